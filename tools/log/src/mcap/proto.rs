//! Messages of Protocol Buffers, and the descriptions that readers of a file need to decode them.

use prost_types::field_descriptor_proto::{Label, Type};
use prost_types::{DescriptorProto, FieldDescriptorProto, FileDescriptorProto};

/// Declares messages, and a function that returns their descriptors. Each field has its label, its type in Protocol Buffers and
/// in Rust, and its number. What is `required` is written even if it is 0: readers need not know the default.
macro_rules! protobuf {
    ($all:ident: $($name:ident {
        $($field:ident: $label:ident $kind:ident $([$($option:tt)*])? $type:ident = $tag:literal,)*
    })*) => {
        $(
            #[derive(Clone, PartialEq, prost::Message)]
            pub(super) struct $name {
                $(
                    #[prost($kind, $label, $($($option)*,)? tag = $tag)]
                    pub(super) $field: $crate::mcap::proto::labelled!($label $type),
                )*
            }
        )*

        pub(super) fn $all() -> Vec<prost_types::DescriptorProto> {
            use $crate::mcap::proto::{field, message};
            vec![$(message(stringify!($name), vec![$(
                field(stringify!($field), $tag, stringify!($label), stringify!($kind), stringify!($type)),
            )*]),)*]
        }
    };
}

/// The type of a field in Rust.
macro_rules! labelled {
    (required $type:ty) => { $type };
    (optional $type:ty) => { Option<$type> };
    (repeated $type:ty) => { Vec<$type> };
}

pub(super) use {labelled, protobuf};

/// Returns a file of messages, as `protoc` would describe it.
pub(super) fn file(
    name: &str,
    package: &str,
    syntax: &str,
    needs: &[&str],
    mut messages: Vec<DescriptorProto>,
) -> FileDescriptorProto {
    for message in &mut messages {
        let inner = message.name().to_owned();
        for field in &mut message.field {
            // A message of the same package, or one that is declared inside of this one.
            if let Some(of) = &mut field.type_name {
                *of = match of.strip_prefix('/') {
                    Some(nested) => format!(".{package}.{inner}.{nested}"),
                    None if matches!(of.as_str(), "Timestamp" | "Duration") => {
                        format!(".google.protobuf.{of}")
                    }
                    None => format!(".{package}.{of}"),
                };
            }
        }
    }
    FileDescriptorProto {
        name: Some(name.to_owned()),
        package: Some(package.to_owned()),
        dependency: needs.iter().map(|&name| name.to_owned()).collect(),
        message_type: messages,
        syntax: Some(syntax.to_owned()),
        ..FileDescriptorProto::default()
    }
}

pub(super) fn message(name: &str, field: Vec<FieldDescriptorProto>) -> DescriptorProto {
    DescriptorProto {
        name: Some(name.to_owned()),
        field,
        ..DescriptorProto::default()
    }
}

/// Returns a field; `of` names the message that it is, and begins with `/` for one that is declared
/// inside.
pub(super) fn field(
    name: &str,
    number: i32,
    label: &str,
    kind: &str,
    of: &str,
) -> FieldDescriptorProto {
    let label = match label {
        "repeated" => Label::Repeated,
        _ => Label::Optional,
    };
    let kind = Type::from_str_name(&format!("TYPE_{}", kind.to_uppercase()));
    FieldDescriptorProto {
        name: Some(name.trim_start_matches("r#").to_owned()),
        number: Some(number),
        label: Some(label.into()),
        r#type: kind.map(i32::from),
        type_name: (kind == Some(Type::Message)).then(|| of.to_owned()),
        ..FieldDescriptorProto::default()
    }
}
