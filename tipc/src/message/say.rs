//! Messages in words, in one language or another.

use super::Message;
use crate::language::{Bilingual, Edition, Keyword};
use std::fmt::{self, Debug, Display, Formatter};
use tip_runtime::command::Target;
use tip_runtime::model::Part;

/// A language that messages are written in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Lang {
    /// English.
    #[default]
    English,
    /// Japanese.
    Japanese,
}

impl Lang {
    /// Every language.
    pub const ALL: &'static [Lang] = &[Lang::English, Lang::Japanese];

    /// Returns the language of a locale or of its language alone, as POSIX names them: `ja`, `ja_JP.UTF-8`; English
    /// for others.
    pub fn of(locale: &str) -> Self {
        match locale.starts_with("ja") {
            true => Lang::Japanese,
            false => Lang::English,
        }
    }

    /// Returns the text in this language.
    pub const fn pick<'a>(self, english: &'a str, japanese: &'a str) -> &'a str {
        match self {
            Lang::English => english,
            Lang::Japanese => japanese,
        }
    }
}

/// Part of a message that has a text: each table of messages, and each argument.
pub trait Say {
    /// Writes it in a language.
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result;
}

/// A value with the language of its text.
pub struct Said<'a, T: ?Sized>(pub &'a T, pub Lang);

impl<T: Say + ?Sized> Display for Said<'_, T> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.say(self.1, f)
    }
}

/// Arguments that every language writes alike.
macro_rules! alike {
    ($( $type:ty ),*) => {
        $( impl Say for $type {
            fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
                Display::fmt(self, f)
            }
        } )*
    };
}

alike!(
    char,
    u32,
    usize,
    &'static str,
    Edition,
    Keyword,
    Part,
    Target
);

impl Say for f64 {
    /// A zero has no sign.
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        Display::fmt(&(self + 0.0), f)
    }
}

impl Bilingual {
    /// Returns the text in a language.
    pub const fn in_lang(self, lang: Lang) -> &'static str {
        lang.pick(self.english, self.japanese)
    }
}

impl Say for Bilingual {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(self.in_lang(lang))
    }
}

impl Say for Box<Message> {
    fn say(&self, lang: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        (**self).say(lang, f)
    }
}

/// A number with its decimal point, as a version is written: `3.0`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decimal(pub f64);

impl Say for Decimal {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        Debug::fmt(&self.0, f)
    }
}

/// A character in quotes, an escape if it has no face of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Letter(pub char);

impl Say for Letter {
    fn say(&self, _: Lang, f: &mut Formatter<'_>) -> fmt::Result {
        Debug::fmt(&self.0, f)
    }
}

/// Writes a text, with the argument that a hole names in place of each hole.
pub fn fill(
    f: &mut Formatter<'_>,
    lang: Lang,
    text: &str,
    arguments: &[(&str, &dyn Say)],
) -> fmt::Result {
    let mut rest = text;
    while let Some((before, after)) = rest.split_once('{') {
        f.write_str(before)?;
        let (hole, after) = after.split_once('}').unwrap_or((after, ""));
        if let Some((_, argument)) = arguments.iter().find(|(name, _)| *name == hole) {
            // With a formatter of its own: what the whole is padded to is not its arguments' business.
            write!(f, "{}", Said(*argument, lang))?;
        }
        rest = after;
    }
    f.write_str(rest)
}

/// Returns true if every hole of a text names an argument, and every argument has a hole.
pub const fn fits(text: &str, arguments: &[&str]) -> bool {
    let mut used = 0;
    let mut at = 0;
    let text = text.as_bytes();
    while at < text.len() {
        match text[at] {
            b'{' => {
                let start = at + 1;
                while at < text.len() && text[at] != b'}' {
                    at += 1;
                }
                if at == text.len() {
                    return false;
                }
                match position(text, start, at, arguments) {
                    Some(argument) => used |= 1 << argument,
                    None => return false,
                }
            }
            b'}' => return false,
            _ => {}
        }
        at += 1;
    }
    used == (1u32 << arguments.len()) - 1
}

/// Returns the index of the argument whose name is at `start..end` of a text.
const fn position(text: &[u8], start: usize, end: usize, arguments: &[&str]) -> Option<usize> {
    let mut argument = 0;
    while argument < arguments.len() {
        let name = arguments[argument].as_bytes();
        let mut same = 0;
        while same < name.len() && start + same < end && name[same] == text[start + same] {
            same += 1;
        }
        if same == name.len() && start + same == end {
            return Some(argument);
        }
        argument += 1;
    }
    None
}

#[cfg(test)]
mod tests {
    use super::fits;

    #[test]
    fn every_hole_has_its_argument_and_every_argument_its_hole() {
        for text in ["{a} {bc}", "{bc}{a}", "{a} and {a}, {bc}"] {
            assert!(fits(text, &["a", "bc"]), "{text}");
        }
        for text in [
            "",
            "{a}",
            "{a} {b}",
            "{a} {bc} {c}",
            "{a} {bc",
            "{a} bc}",
            "{a} {bcd}",
        ] {
            assert!(!fits(text, &["a", "bc"]), "{text}");
        }
        assert!(fits("no hole", &[]));
        assert!(!fits("{a}", &[]));
    }
}
