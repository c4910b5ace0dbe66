//! A table of the file, read key by key: every value that cannot be used is reported at its location.

use super::keys::Part;
use crate::diagnostic::Diagnostic;
use crate::language::Bilingual;
use crate::message::list::List;
use crate::message::phrase::Kind;
use crate::message::{Describing, Message, Suggestion};
use crate::source::Span;
use crate::suggest::nearest;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// Maximum of any measure, in mm, deg or another unit: it keeps arithmetic far from infinity.
const LARGEST: f64 = 1e6;
/// Maximum of any count.
const MAX_COUNT: f64 = 1e9;
/// Minimum of any size: programs that read exported robots treat smaller ones as zero.
pub(super) const SMALLEST: f64 = 1e-6;

/// Range that a number must lie in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sign {
    Any,
    NotNegative,
    Positive,
    /// A length, in mm.
    Size,
    /// A number of something, which is no measure.
    Count,
}

/// A table with its location.
#[derive(Clone, Copy, Debug)]
pub(super) struct Section<'a> {
    pub(super) part: Part,
    pub(super) location: Span,
    table: &'a DeTable<'a>,
}

/// Faults found so far.
pub(super) type Found = Vec<Diagnostic>;

/// Creates a diagnostic about the file that a table is of.
pub(super) fn fault(
    part: Part,
    location: Span,
    reason: impl Into<Message>,
    help: impl Into<Message>,
) -> Diagnostic {
    Diagnostic::new(part.code(), location, reason).help(help)
}

impl<'a> Section<'a> {
    /// Wraps a table; reports the keys that it cannot have and those that it lacks.
    pub(super) fn new(
        part: Part,
        location: Span,
        table: &'a DeTable<'a>,
        found: &mut Found,
    ) -> Self {
        let section = Section {
            part,
            location,
            table,
        };
        for key in table.keys() {
            let name: &str = key.get_ref();
            if part.key(name).is_none() {
                found.push(section.unknown(name, span(key)));
            }
        }
        for key in part.keys().filter(|key| key.default.is_none()) {
            if !table.contains_key(key.name) {
                let reason = Describing::Lacks {
                    table: part.table(),
                    key: key.name,
                };
                let help = Describing::KeyMeans {
                    key: key.name,
                    form: key.form,
                    meaning: key.meaning,
                };
                found.push(fault(part, location, reason, help));
            }
        }
        section
    }

    fn unknown(self, name: &str, location: Span) -> Diagnostic {
        let (table, key) = (self.part.table(), name.to_owned());
        let names = || self.part.keys().map(|key| key.name);
        let mut same_file = self.part.same_file().iter();
        let elsewhere = same_file.find(|part| part.key(name).is_some());
        let help: Message = match (nearest(name, names()), elsewhere) {
            (Some(near), _) => Suggestion::DidYouMean { near: near.into() }.into(),
            (None, Some(part)) => Describing::BelongsTo {
                key: key.clone(),
                table: part.table(),
            }
            .into(),
            (None, None) => Describing::KeysOf {
                table: table.clone(),
                keys: List(names().map(str::to_owned).collect()),
            }
            .into(),
        };
        let reason = Describing::NoKey { table, key };
        fault(self.part, location, reason, help)
    }

    fn value(self, key: &str) -> Option<(Span, &'a DeValue<'a>)> {
        let value = self.table.get(key)?;
        Some((span(value), value.get_ref()))
    }

    /// Returns the location of a key's value, else of the table.
    pub(super) fn location_of(self, key: &str) -> Span {
        self.value(key)
            .map_or(self.location, |(location, _)| location)
    }

    /// Refuses the value of `key`, with its form as the help.
    pub(super) fn refuse<T>(
        self,
        key: &str,
        location: Span,
        reason: impl Into<Message>,
        found: &mut Found,
    ) -> Option<T> {
        let form = self.part.key(key).map_or(Bilingual::EMPTY, |key| key.form);
        let key = key.to_owned();
        found.push(fault(
            self.part,
            location,
            reason,
            Describing::KeyIs { key, form },
        ));
        None
    }

    /// Refuses the value of `key`, which has the right form but does not fit another value, and says what to do.
    pub(super) fn refuse_beside(
        self,
        key: &str,
        reason: impl Into<Message>,
        help: impl Into<Message>,
        found: &mut Found,
    ) {
        let location = self.location_of(key);
        found.push(fault(self.part, location, reason, help));
    }

    /// Reads a number; `None` if there is none or it was refused.
    pub(super) fn number(self, key: &str, sign: Sign, found: &mut Found) -> Option<f64> {
        let (location, value) = self.value(key)?;
        self.sound(key, location, value, sign, found)
    }

    /// Reads an array of `N` numbers.
    pub(super) fn numbers<const N: usize>(
        self,
        key: &str,
        sign: Sign,
        found: &mut Found,
    ) -> Option<[f64; N]> {
        let (location, numbers) = self.list(key, sign, found)?;
        let count = numbers.len();
        match numbers.try_into() {
            Ok(numbers) => Some(numbers),
            Err(_) => {
                let reason = Describing::NumbersBelongHere {
                    wanted: N,
                    found: count,
                };
                self.refuse(key, location, reason, found)
            }
        }
    }

    /// Reads a list of numbers, with its location.
    pub(super) fn list(self, key: &str, sign: Sign, found: &mut Found) -> Option<(Span, Vec<f64>)> {
        let (location, value) = self.value(key)?;
        let DeValue::Array(items) = value else {
            return self.wrong_type(key, location, value, found);
        };
        let reported = found.len();
        let numbers: Vec<f64> = items
            .iter()
            .filter_map(|item| self.sound(key, span(item), item.get_ref(), sign, found))
            .collect();
        (found.len() == reported).then_some((location, numbers))
    }

    /// Reads `[min, max]`, in this order.
    pub(super) fn range(
        self,
        key: &str,
        sign: Sign,
        found: &mut Found,
    ) -> Option<tip_runtime::model::Range> {
        let [min, max] = self.numbers(key, sign, found)?;
        if min <= max {
            return Some(tip_runtime::model::Range::new(min, max));
        }
        let reason = Describing::Above { min, max };
        self.refuse(key, self.location_of(key), reason, found)
    }

    /// Reads `[min, max]` of sizes.
    pub(super) fn extent(self, key: &str, found: &mut Found) -> Option<tip_runtime::model::Range> {
        let range = self.range(key, Sign::Any, found)?;
        if range.max - range.min >= SMALLEST {
            return Some(range);
        }
        let reason = Describing::Flat { least: SMALLEST };
        self.refuse(key, self.location_of(key), reason, found)
    }

    /// Reads a text, with its location.
    pub(super) fn text(self, key: &str, found: &mut Found) -> Option<(Span, &'a str)> {
        let (location, value) = self.value(key)?;
        match value {
            DeValue::String(text) => Some((location, text)),
            _ => self.wrong_type(key, location, value, found),
        }
    }

    /// Reads true or false.
    pub(super) fn boolean(self, key: &str, found: &mut Found) -> Option<bool> {
        let (location, value) = self.value(key)?;
        match value {
            DeValue::Boolean(is_on) => Some(*is_on),
            _ => self.wrong_type(key, location, value, found),
        }
    }

    /// Reads one of some words.
    pub(super) fn choice<T: Copy>(
        self,
        key: &str,
        words: &[(&str, T)],
        found: &mut Found,
    ) -> Option<T> {
        let (location, text) = self.text(key, found)?;
        match words.iter().find(|(word, _)| *word == text) {
            Some((_, meant)) => Some(*meant),
            None => {
                let known = words.iter().map(|(word, _)| *word);
                self.refuse_word(key, (location, text), known, found)
            }
        }
    }

    /// Refuses a word, with the nearest known one as the help.
    pub(super) fn refuse_word<'w, T>(
        self,
        key: &str,
        (location, word): (Span, &str),
        known: impl IntoIterator<Item = &'w str>,
        found: &mut Found,
    ) -> Option<T> {
        let reason = Describing::CannotBeThis {
            key: key.to_owned(),
        };
        let Some(near) = nearest(&word.to_lowercase(), known) else {
            return self.refuse(key, location, reason, found);
        };
        let help = Suggestion::DidYouMean { near: near.into() };
        found.push(fault(self.part, location, reason, help));
        None
    }

    /// Reads a list of pairs of texts, each with its location.
    pub(super) fn pairs(self, key: &str, found: &mut Found) -> Option<Vec<(Span, [&'a str; 2])>> {
        let (location, value) = self.value(key)?;
        let DeValue::Array(items) = value else {
            return self.wrong_type(key, location, value, found);
        };
        let mut pairs = Vec::new();
        for item in items.iter() {
            let (location, value) = (span(item), item.get_ref());
            let DeValue::Array(texts) = value else {
                return self.wrong_type(key, location, value, found);
            };
            let mut words = Vec::new();
            for text in texts.iter() {
                match text.get_ref() {
                    DeValue::String(word) => words.push(word.as_ref()),
                    other => return self.wrong_type(key, span(text), other, found),
                }
            }
            match words.try_into() {
                Ok(pair) => pairs.push((location, pair)),
                Err(_) => return self.refuse(key, location, Describing::NoPair, found),
            }
        }
        Some(pairs)
    }

    /// Returns true if the key is there at all.
    pub(super) fn has(self, key: &str) -> bool {
        self.table.contains_key(key)
    }

    /// Returns true if the value is text.
    pub(super) fn is_text(self, key: &str) -> bool {
        self.table
            .get(key)
            .is_some_and(|value| value.get_ref().is_str())
    }

    /// Reads a table.
    pub(super) fn table(self, key: &str, part: Part, found: &mut Found) -> Option<Section<'a>> {
        let (location, value) = self.value(key)?;
        match value {
            DeValue::Table(table) => Some(Section::new(part, location, table, found)),
            _ => self.wrong_type(key, location, value, found),
        }
    }

    /// Reads one or several tables; `None` if there are none.
    pub(super) fn tables(
        self,
        key: &str,
        part: Part,
        found: &mut Found,
    ) -> Option<Vec<Section<'a>>> {
        let (location, value) = self.value(key)?;
        let DeValue::Array(items) = value else {
            return self.wrong_type(key, location, value, found);
        };
        let mut sections = Vec::new();
        for item in items.iter() {
            match item.get_ref() {
                DeValue::Table(table) => {
                    sections.push(Section::new(part, span(item), table, found));
                }
                other => return self.wrong_type(key, span(item), other, found),
            }
        }
        Some(sections)
    }

    fn sound(
        self,
        key: &str,
        location: Span,
        value: &DeValue<'_>,
        sign: Sign,
        found: &mut Found,
    ) -> Option<f64> {
        let number = match value {
            DeValue::Integer(digits) => i64::from_str_radix(digits.as_str(), digits.radix())
                .map_or(f64::INFINITY, |number| number as f64),
            DeValue::Float(digits) => digits.as_str().parse().unwrap_or(f64::NAN),
            _ => return self.wrong_type(key, location, value, found),
        };
        // A comparison with NaN is false.
        let most = if sign == Sign::Count {
            MAX_COUNT
        } else {
            LARGEST
        };
        if !(-most..=most).contains(&number) {
            let reason = Describing::OutOfReach { most };
            return self.refuse(key, location, reason, found);
        }
        let wrong = match sign {
            Sign::Any | Sign::Count => None,
            Sign::NotNegative => (number < 0.0).then_some(Describing::NotBelowZero),
            Sign::Positive | Sign::Size if number <= 0.0 => Some(Describing::AboveZero),
            Sign::Size if number < SMALLEST => Some(Describing::TooSmall { least: SMALLEST }),
            Sign::Positive | Sign::Size => None,
        };
        match wrong {
            None => Some(number),
            Some(reason) => self.refuse(key, location, reason, found),
        }
    }

    fn wrong_type<T>(
        self,
        key: &str,
        location: Span,
        value: &DeValue<'_>,
        found: &mut Found,
    ) -> Option<T> {
        let kind = match value {
            DeValue::String(_) => Kind::Text,
            DeValue::Integer(_) | DeValue::Float(_) => Kind::Number,
            DeValue::Boolean(_) => Kind::Truth,
            DeValue::Datetime(_) => Kind::Date,
            DeValue::Array(_) => Kind::List,
            DeValue::Table(_) => Kind::Table,
        };
        self.refuse(key, location, Describing::WrongKind { kind }, found)
    }
}

/// Returns the location of a key or value.
fn span<T>(spanned: &Spanned<T>) -> Span {
    let range = spanned.span();
    Span::new(range.start, range.end)
}
