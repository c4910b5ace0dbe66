//! The texts of MESSAGE and F_MESSAGE: their placeholders and escapes (T.I.P. 3.1 §7-9-4).

use super::names::Names;
use super::resolve::Resolver;
use crate::language::{Edition, Keyword, reserved};
use crate::program::{MessagePart, Operand, StructOperand, VariableId};
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::VariableKind;
use tip_runtime::command::{READING, Reading};

/// The value that a placeholder shows.
#[derive(Clone, Copy)]
enum PlaceholderValue {
    Variable(VariableId),
    Constant(usize),
    Reading(Reading),
}

/// A placeholder.
struct Placeholder {
    named: PlaceholderValue,
    /// The member, of a struct; `None` for the whole.
    member: Option<usize>,
    decimals: u8,
    /// Number of bytes of its name.
    name: usize,
    /// Number of bytes, the percent signs among them.
    length: usize,
}

impl Names {
    /// Passes on each variable that a text shows.
    pub(super) fn each_shown(&self, text: &str, found: &mut dyn FnMut(VariableId)) {
        let mut rest = text;
        while let Some(start) = rest.find('%') {
            rest = &rest[start..];
            let length = match self.placeholder(rest) {
                Some(placeholder) => {
                    if let PlaceholderValue::Variable(variable) = placeholder.named {
                        found(variable);
                    }
                    placeholder.length
                }
                None => 1,
            };
            rest = &rest[length..];
        }
    }

    /// Reads `%NAME%` or `%NAME.n%` at the start of a text.
    fn placeholder(&self, text: &str) -> Option<Placeholder> {
        let inner = text.strip_prefix('%')?;
        let inner = &inner[..inner.find('%')?];
        let mut parts = inner.split('.');
        let name = parts.next()?;
        let upper = name.to_ascii_uppercase();
        let (named, kind) = self.shown(&upper)?;
        let (mut member, mut decimals) = (None, 0);
        let mut next = parts.next();
        if let Some(word) =
            next.filter(|word| word.starts_with(|it: char| it.is_ascii_alphabetic()))
        {
            let is_later = self.edition >= Edition::V3_2;
            let index = self.member_of(kind, &word.to_ascii_uppercase());
            member = Some(index.filter(|_| is_later)?);
            next = parts.next();
        }
        if let Some(digits) = next {
            decimals = match digits.as_bytes() {
                [digit @ b'0'..=b'7'] => digit - b'0',
                _ => return None,
            };
        }
        parts.next().is_none().then_some(Placeholder {
            named,
            member,
            decimals,
            name: name.len(),
            length: inner.len() + 2,
        })
    }

    /// Returns value and type of a name, in capital letters, in a placeholder.
    fn shown(&self, name: &str) -> Option<(PlaceholderValue, VariableKind)> {
        if name.starts_with(READING) {
            let reading = reserved::reading(name, self.edition)?;
            return Some((
                PlaceholderValue::Reading(reading),
                VariableKind::of_reading(reading),
            ));
        }
        if let Some(constant) = self.find_constant(name) {
            return Some((PlaceholderValue::Constant(constant), VariableKind::Var));
        }
        let variable = self.find(name)?;
        let kind = self.variables[variable].kind;
        let is_shown = kind == VariableKind::Var || self.edition >= Edition::V3_2;
        is_shown.then_some((PlaceholderValue::Variable(variable), kind))
    }
}

impl Resolver<'_> {
    /// Splits the text at `location` into texts and values to show.
    pub(super) fn message(&mut self, of: Keyword, location: Span) -> Option<Vec<MessagePart>> {
        let mut parts = Vec::new();
        let mut plain = String::new();
        let mut rest = self.slice(location);
        let mut is_sound = true;
        while let Some(first) = rest.chars().next() {
            if let Some(placeholder) = self.names.placeholder(rest) {
                let start = location.end - rest.len() + 1;
                let name = Span::new(start, start + placeholder.name);
                is_sound &= self.show(&placeholder, name, &mut plain, &mut parts);
                rest = &rest[placeholder.length..];
            } else {
                if let Some(variable) = self.value_of_others(rest) {
                    self.uses.was_to_be_shown(variable);
                }
                let length = shown(of, rest, first, &mut plain);
                rest = &rest[length..];
            }
        }
        if !plain.is_empty() {
            parts.push(MessagePart::Text(plain));
        }
        is_sound.then_some(parts)
    }

    /// Adds the value of a placeholder whose name is at `location`; a struct is its members, a blank between two.
    /// Returns false if the robot has no such value, which is reported.
    fn show(
        &mut self,
        placeholder: &Placeholder,
        location: Span,
        plain: &mut String,
        parts: &mut Vec<MessagePart>,
    ) -> bool {
        let whole = match placeholder.named {
            PlaceholderValue::Constant(constant) => {
                self.uses.constant(location, constant);
                let Some(value) = self.names.constants[constant].value else {
                    return false;
                };
                self.put(Operand::Constant(value), placeholder.decimals, plain, parts);
                return true;
            }
            PlaceholderValue::Variable(variable) => {
                self.uses
                    .member(location, variable, placeholder.member, Access::Read);
                StructOperand::Variable(variable)
            }
            PlaceholderValue::Reading(reading) => {
                if let Some(fault) = self.names.not_sensed(reading, location) {
                    self.report(*fault);
                    return false;
                }
                StructOperand::Reading(reading)
            }
        };
        let size = self.names.size_of(whole);
        let members = match placeholder.member {
            Some(member) => member..member + 1,
            None => 0..size,
        };
        let first = members.start;
        for member in members {
            if member > first {
                plain.push(' ');
            }
            self.put(whole.member(member), placeholder.decimals, plain, parts);
        }
        true
    }

    /// Adds a value behind the text so far.
    fn put(
        &self,
        operand: Operand,
        decimals: u8,
        plain: &mut String,
        parts: &mut Vec<MessagePart>,
    ) {
        if !plain.is_empty() {
            parts.push(MessagePart::Text(std::mem::take(plain)));
        }
        parts.push(MessagePart::Value { operand, decimals });
    }

    /// Returns the variable that a text was meant to show at its start in the form of another language: `%N`, `$N`,
    /// `{N}`, `％N％`.
    fn value_of_others(&self, text: &str) -> Option<usize> {
        let name = text.strip_prefix(['%', '$', '{', '％'])?;
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let name = &name[..name.len() - name.trim_start_matches(is_name).len()];
        self.names.find(&name.to_ascii_uppercase())
    }
}

/// Adds what the start of a text, whose first character is `first`, shows; returns its length in the source.
///
/// In a MESSAGE a doubled backslash is kept, so that the second one escapes nothing.
fn shown(of: Keyword, text: &str, first: char, plain: &mut String) -> usize {
    let length = first.len_utf8();
    match (first, text[length..].chars().next()) {
        ('\\' | '\u{A5}', Some('a')) if of == Keyword::Message => plain.push('\u{7}'),
        ('\\' | '\u{A5}', Some('n')) if of == Keyword::FileMessage => plain.push('\n'),
        ('\\' | '\u{A5}', Some('t')) => plain.push('\t'),
        ('\\' | '\u{A5}', Some(second @ ('\\' | '\u{A5}'))) => {
            match of {
                Keyword::Message => plain.extend([first, second]),
                _ => plain.push(second),
            }
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
