//! Diagnostics of a file, collected by the passes.

use super::{Diagnostic, Label, MistakeId};
use crate::code::{Code, Level};
use crate::language::Edition;
use crate::message::Naming;
use std::collections::{BTreeMap, HashMap};
use std::ops::Deref;

/// Maximum number of diagnostics of a file that are reported. More are not read, and each takes time to show and to
/// fix.
pub const MAX_DIAGNOSTICS: usize = 1_000;

/// Maximum number of diagnostics that the passes keep: of a hostile file there may be one for each byte, and each takes
/// hundreds of bytes.
const MAX_KEPT: usize = 10_000;

/// The index of a diagnostic that was reported, or of the next one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Handle(usize);

/// The diagnostics of a file. Those beyond a maximum number are only counted.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Diagnostics {
    kept: Vec<Diagnostic>,
    /// The diagnostic of each mistake that is reported once.
    once: HashMap<MistakeId, Handle>,
    omitted: Omitted,
}

impl Diagnostics {
    /// Adds a diagnostic and returns its handle. A diagnostic of a mistake that is reported already becomes a label of
    /// that one. Returns `None` in that case, and if there are too many.
    pub fn push(&mut self, diagnostic: Diagnostic) -> Option<Handle> {
        let handle = Handle(self.kept.len());
        if let Some(mistake) = &diagnostic.once {
            if let Some(first) = self.of_mistake(mistake) {
                also_here(first, diagnostic);
                return None;
            }
            self.once.insert(mistake.clone(), handle);
        }
        if self.kept.len() >= MAX_KEPT {
            self.omitted.add(diagnostic.code);
            return None;
        }
        self.kept.push(diagnostic);
        Some(handle)
    }

    /// Returns the diagnostic of a mistake that is reported once, if it is.
    pub(crate) fn of_mistake(&mut self, mistake: &MistakeId) -> Option<&mut Diagnostic> {
        let first = *self.once.get(mistake)?;
        self.kept.get_mut(first.0)
    }

    /// Returns a diagnostic that was reported.
    pub(crate) fn get_mut(&mut self, handle: Handle) -> Option<&mut Diagnostic> {
        self.kept.get_mut(handle.0)
    }

    /// Returns the diagnostics in the order in which they were reported, to be changed.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, Diagnostic> {
        self.kept.iter_mut()
    }

    /// Returns the place of the next diagnostic.
    pub(crate) fn mark(&self) -> Handle {
        Handle(self.kept.len())
    }

    /// Returns the diagnostics that were reported since a mark.
    pub(crate) fn since(&self, mark: Handle) -> &[Diagnostic] {
        &self.kept[mark.0..]
    }

    /// Returns the diagnostics that were reported since a mark, to be changed.
    pub(crate) fn since_mut(&mut self, mark: Handle) -> &mut [Diagnostic] {
        &mut self.kept[mark.0..]
    }

    /// Takes out the diagnostics that `keeps` returns false for.
    pub fn retain(&mut self, keeps: impl FnMut(&Diagnostic) -> bool) {
        self.kept.retain(keeps);
        // The indices of the others have changed.
        let kept = self.kept.iter().enumerate();
        let of_mistake = kept.filter_map(|(at, it)| Some((it.once.clone()?, Handle(at))));
        self.once = of_mistake.collect();
    }

    /// Returns true if more diagnostics are kept than are shown. Passes then search no suggestions, which take time.
    pub(crate) fn are_many(&self) -> bool {
        self.kept.len() >= MAX_DIAGNOSTICS
    }

    /// Adds the diagnostics of another pass, and its omitted ones.
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
    type Target = [Diagnostic];

    fn deref(&self) -> &[Diagnostic] {
        &self.kept
    }
}

impl Extend<Diagnostic> for Diagnostics {
    fn extend<T: IntoIterator<Item = Diagnostic>>(&mut self, diagnostics: T) {
        diagnostics
            .into_iter()
            .for_each(|diagnostic| _ = self.push(diagnostic));
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

/// The numbers, by code, of the diagnostics that are not reported because there are too many.
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
    if first.labels.len() < MAX_KEPT && first.span != other.span {
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
