//! Placeholders and escapes of MESSAGE (T.I.P. 3.1 §7-9-4).

use super::resolve::Resolver;
use crate::program::{Action, MessagePart, Scalar};
use crate::syntax::{Span, VariableKind};

impl Resolver<'_> {
    /// Splits a text into what stands as it is and the values between.
    pub(super) fn message(&mut self, text: &str, place: Span) -> Action {
        let mut parts = Vec::new();
        let mut plain = String::new();
        let mut rest = text;
        while let Some(first) = rest.chars().next() {
            if let Some((variable, decimals, length)) = self.placeholder(rest) {
                if !plain.is_empty() {
                    parts.push(MessagePart::Text(std::mem::take(&mut plain)));
                }
                self.usage.read(variable, place);
                parts.push(MessagePart::Value {
                    scalar: Scalar {
                        variable,
                        member: 0,
                    },
                    decimals,
                });
                rest = &rest[length..];
            } else if let Some((escaped, length)) = escape(rest) {
                plain.push(escaped);
                rest = &rest[length..];
            } else {
                plain.push(first);
                rest = &rest[first.len_utf8()..];
            }
        }
        if !plain.is_empty() {
            parts.push(MessagePart::Text(plain));
        }
        Action::Message { parts }
    }

    /// `%NAME%` or `%NAME.n%` at the start: the VAR, its decimals, the placeholder's length.
    fn placeholder(&self, text: &str) -> Option<(usize, u8, usize)> {
        let inner = text.strip_prefix('%')?;
        let inner = &inner[..inner.find('%')?];
        let (name, decimals) = match inner.split_once('.') {
            Some((name, digits)) => match digits.as_bytes() {
                [digit @ b'0'..=b'7'] => (name, digit - b'0'),
                _ => return None,
            },
            None => (inner, 0),
        };
        let variable = self.names.find(&name.to_ascii_uppercase())?;
        let is_var = self.names.variables[variable].kind == VariableKind::Var;
        is_var.then_some((variable, decimals, inner.len() + 2))
    }
}

/// `\a` or `\t` at the start, the backslash perhaps a yen sign: the character and the escape's length.
fn escape(text: &str) -> Option<(char, usize)> {
    let mut chars = text.chars();
    let sign = chars
        .next()
        .filter(|sign| matches!(sign, '\\' | '\u{A5}'))?;
    let escaped = match chars.next()? {
        'a' => '\u{7}',
        't' => '\t',
        _ => return None,
    };
    Some((escaped, sign.len_utf8() + 1))
}
