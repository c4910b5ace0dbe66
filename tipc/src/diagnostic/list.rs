//! The diagnostics of a pass, of which only so many are kept.

use super::{Diagnostic, Label};
use crate::code::{Code, Level};
use crate::language::Edition;
use crate::message::Naming;
use smol_str::SmolStr;
use std::collections::{BTreeMap, HashMap};
use std::ops::{Deref, DerefMut};

/// The most diagnostics of a file that are reported: nobody reads more, and what shows and tries them takes a while for each.
pub const MOST: usize = 1_000;

/// The most diagnostics that the passes keep: of a hostile file there may be one for each byte, and each takes hundreds.
const KEPT: usize = 10_000;

/// Diagnostics; those beyond the most that are kept are counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnostics {
    kept: Vec<Diagnostic>,
    /// The index of the diagnostic of each mistake that is one mistake wherever it shows.
    once: HashMap<SmolStr, usize>,
    omitted: Omitted,
}

impl Diagnostics {
    /// Adds a diagnostic. One of a mistake that is reported already becomes a label of that one.
    pub fn push(&mut self, diagnostic: Diagnostic) {
        if let Some(mistake) = &diagnostic.once {
            let first = self.once.get(mistake).and_then(|at| self.kept.get_mut(*at));
            if let Some(first) = first.filter(|first| first.once == diagnostic.once) {
                return also_here(first, diagnostic);
            }
            self.once.insert(mistake.clone(), self.kept.len());
        }
        match self.is_full() {
            true => self.omitted.add(diagnostic.code),
            false => self.kept.push(diagnostic),
        }
    }

    /// Returns the diagnostic of a mistake that is reported once, if it is.
    pub(crate) fn of_mistake(&mut self, mistake: &str) -> Option<&mut Diagnostic> {
        let at = *self.once.get(mistake)?;
        let first = self.kept.get_mut(at)?;
        (first.once.as_deref() == Some(mistake)).then_some(first)
    }

    /// Returns true if no more are kept.
    fn is_full(&self) -> bool {
        self.kept.len() >= KEPT
    }

    /// Returns true if more diagnostics are kept than are shown. No suggestion is searched for further ones.
    pub(crate) fn are_many(&self) -> bool {
        self.kept.len() >= MOST
    }

    /// Adds those of another pass, the omitted ones among them.
    pub fn append(&mut self, later: Diagnostics) {
        self.omitted.append(later.omitted);
        self.extend(later.kept);
    }

    /// Returns the number of errors by the rules of an edition, kept or not.
    pub(crate) fn errors(&self, edition: Edition) -> usize {
        let kept = self.kept.iter();
        let kept = kept.filter(|it| it.code.level(edition) == Level::Error);
        kept.count() + self.omitted.of_level(Level::Error, edition)
    }

    /// Returns true if there is an error by the rules of an edition, kept or not.
    pub fn have_error(&self, edition: Edition) -> bool {
        let is_error = |code: Code| code.level(edition) == Level::Error;
        self.kept.iter().any(|it| is_error(it.code))
            || self.omitted.codes().any(|(code, _)| is_error(code))
    }

    /// Returns the diagnostics that are kept, and how many others there were.
    pub(crate) fn into_parts(self) -> (Vec<Diagnostic>, Omitted) {
        (self.kept, self.omitted)
    }
}

impl Deref for Diagnostics {
    type Target = Vec<Diagnostic>;

    fn deref(&self) -> &Vec<Diagnostic> {
        &self.kept
    }
}

impl DerefMut for Diagnostics {
    fn deref_mut(&mut self) -> &mut Vec<Diagnostic> {
        &mut self.kept
    }
}

impl Extend<Diagnostic> for Diagnostics {
    fn extend<T: IntoIterator<Item = Diagnostic>>(&mut self, diagnostics: T) {
        diagnostics
            .into_iter()
            .for_each(|diagnostic| self.push(diagnostic));
    }
}

impl From<Vec<Diagnostic>> for Diagnostics {
    fn from(diagnostics: Vec<Diagnostic>) -> Self {
        let mut all = Diagnostics::default();
        all.extend(diagnostics);
        all
    }
}

impl IntoIterator for Diagnostics {
    type Item = Diagnostic;
    type IntoIter = std::vec::IntoIter<Diagnostic>;

    fn into_iter(self) -> Self::IntoIter {
        self.kept.into_iter()
    }
}

/// The diagnostics that are not reported, since there are too many: how many of each code.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Omitted(BTreeMap<Code, usize>);

impl Omitted {
    /// Returns true if there are none, neither kept nor omitted.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the number of diagnostics.
    pub fn count(&self) -> usize {
        self.0.values().sum()
    }

    /// Returns the number of diagnostics of a level, by the rules of an edition.
    pub fn of_level(&self, level: Level, edition: Edition) -> usize {
        let of_level = self.0.iter();
        let of_level = of_level.filter(|(code, _)| code.level(edition) == level);
        of_level.map(|(_, count)| count).sum()
    }

    /// Returns the omitted codes, each with its number.
    pub fn codes(&self) -> impl Iterator<Item = (Code, usize)> {
        self.0.iter().map(|(code, count)| (*code, *count))
    }

    /// Counts one more.
    pub(crate) fn add(&mut self, code: Code) {
        *self.0.entry(code).or_default() += 1;
    }

    /// Counts others as well.
    pub(crate) fn append(&mut self, others: Omitted) {
        for (code, count) in others.0 {
            *self.0.entry(code).or_default() += count;
        }
    }
}

/// Adds the location of a mistake to its diagnostic, which stands at the first one.
fn also_here(first: &mut Diagnostic, mut other: Diagnostic) {
    if other.span < first.span {
        std::mem::swap(first, &mut other);
        first.labels.append(&mut other.labels);
    }
    if first.labels.len() < KEPT && first.span != other.span {
        let text = other.again.unwrap_or(Naming::AlsoHere.into());
        first.labels.push(Label {
            span: other.span,
            text,
        });
    }
}

/// Puts diagnostics in the order of their locations.
pub(crate) fn by_location(found: &mut [Diagnostic]) {
    found.sort_by_key(|one| (one.span, one.code));
}
