//! Messages as Protocol Buffers have them on the wire.

/// A message that grows field by field. Numbers that are 0 are written too: readers need not know the default.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Message(Vec<u8>);

/// How a field is encoded.
enum Wire {
    Varint = 0,
    Fixed64 = 1,
    Length = 2,
    Fixed32 = 5,
}

impl Message {
    pub(super) fn new() -> Self {
        Message::default()
    }

    /// `double`
    pub(super) fn double(mut self, field: u32, value: f64) -> Self {
        self.tag(field, Wire::Fixed64);
        self.0.extend(value.to_le_bytes());
        self
    }

    /// `bool`, an enumeration, or a number that is not negative.
    pub(super) fn number(mut self, field: u32, value: impl Into<u64>) -> Self {
        self.tag(field, Wire::Varint);
        self.varint(value.into());
        self
    }

    /// `fixed32`
    pub(super) fn fixed(mut self, field: u32, value: u32) -> Self {
        self.tag(field, Wire::Fixed32);
        self.0.extend(value.to_le_bytes());
        self
    }

    /// `string`
    pub(super) fn text(self, field: u32, value: &str) -> Self {
        self.bytes(field, value.as_bytes())
    }

    /// Another message.
    pub(super) fn message(self, field: u32, value: &Message) -> Self {
        self.bytes(field, &value.0)
    }

    /// One message after the other in a repeated field.
    pub(super) fn messages(self, field: u32, values: impl IntoIterator<Item = Message>) -> Self {
        let all = values.into_iter();
        all.fold(self, |message, value| message.message(field, &value))
    }

    /// What is written.
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.0
    }

    fn bytes(mut self, field: u32, value: &[u8]) -> Self {
        self.tag(field, Wire::Length);
        self.varint(value.len() as u64);
        self.0.extend(value);
        self
    }

    fn tag(&mut self, field: u32, wire: Wire) {
        self.varint(u64::from(field) << 3 | wire as u64);
    }

    /// Seven bits a byte, the low ones first.
    fn varint(&mut self, mut value: u64) {
        while value >= 0x80 {
            self.0.push(value as u8 | 0x80);
            value >>= 7;
        }
        self.0.push(value as u8);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The examples of the description of the encoding: 150 in field 1, "testing" in field 2, both in a message in field 3.
    #[test]
    fn fields_are_encoded_as_described() {
        let number = Message::new().number(1, 150u32);
        assert_eq!(number.clone().into_bytes(), [0x08, 0x96, 0x01]);
        let text = Message::new().text(2, "testing").into_bytes();
        assert_eq!(text, b"\x12\x07testing");
        let nested = Message::new().message(3, &number).into_bytes();
        assert_eq!(nested, [0x1a, 0x03, 0x08, 0x96, 0x01]);
        let fixed = Message::new().fixed(1, 1).double(2, 1.0).into_bytes();
        assert_eq!(
            fixed,
            [0x0d, 1, 0, 0, 0, 0x11, 0, 0, 0, 0, 0, 0, 0xf0, 0x3f]
        );
    }
}
