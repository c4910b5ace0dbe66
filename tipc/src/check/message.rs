//! Placeholders and escapes of MESSAGE (T.I.P. 3.1 §7-9-4).

use super::resolve::Resolver;
use crate::program::{MessagePart, Scalar};
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::VariableKind;

impl Resolver<'_> {
    /// Splits a text of the source at `place` into what is shown as it is and the values between.
    pub(super) fn message(&mut self, text: &str, place: Span) -> Vec<MessagePart> {
        let mut parts = Vec::new();
        let mut plain = String::new();
        let mut rest = text;
        while let Some(first) = rest.chars().next() {
            if let Some((variable, decimals, length)) = self.placeholder(rest) {
                let start = place.end - rest.len() + 1;
                let name = Span::new(start, start + self.names.variables[variable].name.len());
                self.uses.variable(name, variable, Access::Read);
                if !plain.is_empty() {
                    parts.push(MessagePart::Text(std::mem::take(&mut plain)));
                }
                parts.push(MessagePart::Value {
                    scalar: Scalar {
                        variable,
                        member: 0,
                    },
                    decimals,
                });
                rest = &rest[length..];
            } else {
                if let Some(variable) = self.value_of_others(rest) {
                    self.uses.was_to_be_shown(variable);
                }
                let length = shown(rest, first, &mut plain);
                rest = &rest[length..];
            }
        }
        if !plain.is_empty() {
            parts.push(MessagePart::Text(plain));
        }
        parts
    }

    /// `%N`, `$N`, `{N}`, `％N％` at the start: the variable that is not shown, although it was meant to be.
    fn value_of_others(&self, text: &str) -> Option<usize> {
        let name = text.strip_prefix(['%', '$', '{', '％'])?;
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let name = &name[..name.len() - name.trim_start_matches(is_name).len()];
        self.names.find(&name.to_ascii_uppercase())
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

/// Adds what the start of a text, whose first character is `first`, shows; returns its length in the source.
///
/// A doubled backslash stays as it is, so that the second one escapes nothing.
fn shown(text: &str, first: char, plain: &mut String) -> usize {
    let length = first.len_utf8();
    match (first, text[length..].chars().next()) {
        ('\\' | '\u{A5}', Some('a')) => plain.push('\u{7}'),
        ('\\' | '\u{A5}', Some('t')) => plain.push('\t'),
        ('\\' | '\u{A5}', Some(second @ ('\\' | '\u{A5}'))) => {
            plain.extend([first, second]);
            return length + second.len_utf8();
        }
        ('\u{3000}', _) => {
            plain.push_str("  ");
            return length;
        }
        _ => {
            plain.push(first);
            return length;
        }
    }
    length + 1
}
