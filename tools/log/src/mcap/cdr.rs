//! Messages of ROS 2: their definitions, and CDR, as they are encoded.

/// `std_msgs/msg/String`
pub(super) const STRING: &str = "string data\n";

/// `sensor_msgs/msg/JointState`, with what it needs.
pub(super) const JOINT_STATE: &str = "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n\
================================================================================\nMSG: std_msgs/Header\n\
builtin_interfaces/Time stamp\nstring frame_id\n\
================================================================================\nMSG: builtin_interfaces/Time\n\
int32 sec\nuint32 nanosec\n";

/// Little endian, each number at a multiple of its size.
pub(super) struct Cdr(Vec<u8>);

/// Header before the body, which does not count for the multiples.
const HEADER: [u8; 4] = [0, 1, 0, 0];

impl Cdr {
    pub(super) fn new() -> Self {
        Cdr(HEADER.to_vec())
    }

    fn align(&mut self, size: usize) {
        let length = self.0.len() - HEADER.len();
        self.0
            .resize(HEADER.len() + length.next_multiple_of(size), 0);
    }

    /// Appends a `uint32`, or an `int32` that is not negative.
    pub(super) fn number(mut self, value: u32) -> Self {
        self.align(4);
        self.0.extend(value.to_le_bytes());
        self
    }

    /// Appends a `string`; its length counts the zero at the end.
    pub(super) fn text(mut self, text: &str) -> Self {
        self = self.number(text.len() as u32 + 1);
        self.0.extend(text.as_bytes());
        self.0.push(0);
        self
    }

    /// Appends a `string[]`.
    pub(super) fn texts(self, texts: &[String]) -> Self {
        let all = self.number(texts.len() as u32);
        texts.iter().fold(all, |cdr, text| cdr.text(text))
    }

    /// Appends a `float64[]`.
    pub(super) fn doubles(mut self, values: &[f64]) -> Self {
        self = self.number(values.len() as u32);
        for value in values {
            self.align(8);
            self.0.extend(value.to_le_bytes());
        }
        self
    }

    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_at_multiples_of_their_size() {
        let cdr = Cdr::new().text("ab").doubles(&[1.0]).number(7);
        let expected: [&[u8]; 5] = [
            &[0, 1, 0, 0],
            // Three bytes with the zero; one is left out.
            &[3, 0, 0, 0, b'a', b'b', 0, 0],
            // How many; the double begins at 16 of the body.
            &[1, 0, 0, 0, 0, 0, 0, 0],
            &1.0f64.to_le_bytes(),
            &[7, 0, 0, 0],
        ];
        assert_eq!(cdr.into_bytes(), expected.concat());
    }
}
