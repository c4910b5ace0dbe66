//! Descriptions of messages: what a reader of the file needs to decode them.

use super::wire::Message;

/// A file of messages, as `protoc` would describe it.
pub(super) struct File {
    pub(super) name: &'static str,
    pub(super) package: &'static str,
    /// Whether fields that are left out are known to be so.
    pub(super) has_presence: bool,
    pub(super) needs: &'static [&'static str],
    pub(super) types: Vec<Type>,
}

/// A message; its fields are numbered from 1.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Type {
    pub(super) name: String,
    /// Name and type of each: `double`, `repeated Color`, `.google.protobuf.Timestamp`, `/Inner` for a message inside, `enum Level`
    /// for the enumeration of this message.
    pub(super) fields: Vec<(String, String)>,
    /// The values of its enumeration, from 0, with blanks between.
    pub(super) values: &'static str,
    pub(super) inner: Vec<Type>,
}

impl Type {
    /// From a row of a table.
    pub(super) fn row(name: &str, fields: &[(&str, &str)], values: &'static str) -> Self {
        let owned = |(name, kind): &(&str, &str)| ((*name).to_owned(), (*kind).to_owned());
        Type {
            name: name.to_owned(),
            fields: fields.iter().map(owned).collect(),
            values,
            inner: Vec::new(),
        }
    }

    fn descriptor(&self, scope: &str) -> Message {
        let scope = format!("{scope}.{}", self.name);
        let fields = (1..).zip(&self.fields);
        let fields = fields.map(|(number, (name, kind))| field(number, name, kind, &scope));
        let inner = self.inner.iter().map(|inner| inner.descriptor(&scope));
        let message = Message::new()
            .text(1, &self.name)
            .messages(2, fields)
            .messages(3, inner);
        let mut names = self
            .fields
            .iter()
            .filter_map(|(_, kind)| enumeration_of(kind));
        match names.next() {
            None => message,
            Some(name) => message.message(4, &enumeration(name, self.values)),
        }
    }
}

impl File {
    fn descriptor(&self) -> Message {
        let mut message = Message::new().text(1, self.name).text(2, self.package);
        for needed in self.needs {
            message = message.text(3, needed);
        }
        let scope = format!(".{}", self.package);
        let types = self.types.iter().map(|one| one.descriptor(&scope));
        let message = message.messages(4, types);
        let syntax = if self.has_presence {
            "proto2"
        } else {
            "proto3"
        };
        message.text(12, syntax)
    }
}

/// A `FileDescriptorSet`: each file after those that it needs.
pub(super) fn descriptors(files: &[&File]) -> Vec<u8> {
    let files = files.iter().map(|file| file.descriptor());
    Message::new().messages(1, files).into_bytes()
}

const SCALARS: [(&str, u32); 7] = [
    ("double", 1),
    ("int64", 3),
    ("int32", 5),
    ("fixed32", 7),
    ("bool", 8),
    ("string", 9),
    ("bytes", 12),
];
const MESSAGE: u32 = 11;
const ENUM: u32 = 14;
const OPTIONAL: u32 = 1;
const REPEATED: u32 = 3;

/// The name of the enumeration that a field is of, if it is of one.
fn enumeration_of(kind: &str) -> Option<&str> {
    kind.strip_prefix("enum ")
}

fn field(number: u32, name: &str, kind: &str, scope: &str) -> Message {
    let (label, kind) = match kind.strip_prefix("repeated ") {
        Some(kind) => (REPEATED, kind),
        None => (OPTIONAL, kind),
    };
    let field = Message::new()
        .text(1, name)
        .number(3, number)
        .number(4, label);
    if let Some((_, scalar)) = SCALARS.iter().find(|(scalar, _)| *scalar == kind) {
        return field.number(5, *scalar);
    }
    if let Some(name) = enumeration_of(kind) {
        return field.number(5, ENUM).text(6, &format!("{scope}.{name}"));
    }
    let package = scope.rsplit_once('.').map_or("", |(package, _)| package);
    let name = match (kind.strip_prefix('/'), kind.starts_with('.')) {
        (Some(inner), _) => format!("{scope}.{inner}"),
        (None, true) => kind.to_owned(),
        (None, false) => format!("{package}.{kind}"),
    };
    field.number(5, MESSAGE).text(6, &name)
}

fn enumeration(name: &str, values: &str) -> Message {
    let values = (0u32..).zip(values.split_whitespace());
    let values = values.map(|(number, name)| Message::new().text(1, name).number(2, number));
    Message::new().text(1, name).messages(2, values)
}
