//! One diagnostic, as every pass makes it.

use crate::code::{Code, Level};
use crate::language::Edition;
use crate::message::{Cut, Lang, Message, Naming, Reading, Structuring};
use crate::source::{Span, Undecodable};
use smol_str::SmolStr;
use std::collections::{BTreeMap, HashMap};
use std::ops::{Deref, DerefMut};

/// A second location that a diagnostic points at.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Label {
    /// Location of the label.
    pub span: Span,
    /// Text of the label.
    pub text: Message,
}

impl Label {
    /// Returns true if the same mistake shows again here, as at each other use of a name that is not declared.
    pub const fn is_again(&self) -> bool {
        matches!(
            self.text,
            Message::Naming(Naming::AlsoHere) | Message::Structuring(Structuring::JumpsHere)
        )
    }
}

/// One diagnostic about a source file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Diagnostic {
    /// The class of what it is about.
    pub code: Code,
    /// The name or file that the message's `{}` stands for.
    pub subject: Option<String>,
    /// Location in the source.
    pub span: Span,
    /// The reason: of an error, its headline; of a warning, what is said at the location.
    pub reason: Message,
    /// Other locations that matter.
    pub labels: Vec<Label>,
    /// The help: what to do about it.
    pub help: Option<Message>,
    /// True if a word is unknown, and the help is no more than a guess. Who knows the word may replace the help.
    pub is_guess: bool,
    /// Ways to put it right, the best first.
    pub fixes: Vec<Fix>,
    /// Whose rules it is judged by.
    pub edition: Edition,
    /// Its finest code.
    id: &'static str,
    /// The mistake, if it is one mistake wherever it shows: the first diagnostic of it is reported, the others are its labels.
    pub(crate) once: Option<SmolStr>,
    /// The text of those labels, if it is not the usual one.
    again: Option<Message>,
}

impl Diagnostic {
    /// Creates a diagnostic of `code` at `span`, with the reason in this case.
    pub fn new(code: Code, span: Span, reason: impl Into<Message>) -> Self {
        let reason = reason.into();
        let mut finer = reason.codes().iter().copied();
        let id = finer.find(|finer| finer.starts_with(code.id()));
        Diagnostic {
            code,
            id: id.unwrap_or(code.id()),
            subject: None,
            span,
            reason,
            labels: Vec::new(),
            help: None,
            is_guess: false,
            fixes: Vec::new(),
            edition: Edition::default(),
            once: None,
            again: None,
        }
    }

    /// Names what the message's `{}` stands for.
    #[must_use]
    pub fn about(mut self, subject: impl Into<String>) -> Self {
        self.subject = Some(subject.into());
        self
    }

    /// Names the mistake, which is reported once.
    #[must_use]
    pub(crate) fn once(mut self, mistake: impl Into<SmolStr>) -> Self {
        self.once = Some(mistake.into());
        self
    }

    /// Names the text of the labels of a mistake that is reported once.
    #[must_use]
    pub(crate) fn again(mut self, text: impl Into<Message>) -> Self {
        self.again = Some(text.into());
        self
    }

    /// Points at a second location.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<Message>) -> Self {
        self.point(span, text);
        self
    }

    /// Points at one more location.
    pub fn point(&mut self, span: Span, text: impl Into<Message>) {
        let text = text.into();
        self.labels.push(Label { span, text });
    }

    /// Adds the help: what to do about it.
    #[must_use]
    pub fn help(mut self, help: impl Into<Message>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Adds a help that is a guess, since a word is unknown.
    #[must_use]
    pub(crate) fn guess(mut self, help: impl Into<Message>) -> Self {
        self.is_guess = true;
        self.help(help)
    }

    /// Returns its finest code: that of its kind of mistake, as `E205-03`, or that of its class if this covers one
    /// kind only.
    pub fn id(&self) -> &'static str {
        self.id
    }

    /// Returns its severity.
    pub fn level(&self) -> Level {
        self.code.level(self.edition)
    }

    /// Returns the classical message, its subject filled in.
    pub fn message(&self) -> String {
        self.filled(self.code.template())
    }

    /// Fills the subject into a template: a path whole, of a name as much as is shown.
    fn filled(&self, template: &str) -> String {
        let subject = self.subject.as_deref().unwrap_or_default();
        match self.code {
            Code::CannotWrite | Code::FileNotFound => template.replace("{}", subject),
            _ => template.replace("{}", &Cut::word(subject).to_string()),
        }
    }

    /// Returns what people read first: of an error its reason, of a warning its message.
    pub fn headline(&self, lang: Lang) -> String {
        match self.level() {
            Level::Error => self.reason.in_lang(lang).to_string(),
            Level::Warning => self.filled(self.code.template_in(lang)),
        }
    }

    /// Returns the title line (T.I.P. 3.1 §9): `TIP_ERR:<message> (<kind>)`; of a warning, its message.
    pub fn title(&self) -> String {
        match self.code.kind() {
            Some(kind) => format!("TIP_ERR:{} ({kind})", self.message()),
            None => self.message(),
        }
    }
}

/// Certainty that a fix is what was meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Applicability {
    /// Every reader would mean exactly this.
    Certain,
    /// Most readers would mean this; someone has to look.
    Likely,
}

impl Applicability {
    /// Returns its name for tools.
    pub const fn name(self) -> &'static str {
        match self {
            Applicability::Certain => "certain",
            Applicability::Likely => "likely",
        }
    }
}

/// One change of the text.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edit {
    /// Replaced text; empty where something is only put in.
    pub span: Span,
    /// Replacement: ASCII, which has the same bytes in every encoding.
    pub text: String,
}

impl Edit {
    /// `text` in the place of `span`.
    pub fn replace(span: Span, text: impl Into<String>) -> Self {
        let text = text.into();
        Edit { span, text }
    }

    /// `text` before the byte at `at`.
    pub fn insert(at: usize, text: impl Into<String>) -> Self {
        Edit::replace(Span::new(at, at), text)
    }

    /// Creates an edit that removes the text at `span`.
    pub fn remove(span: Span) -> Self {
        Edit::replace(span, "")
    }
}

/// A way to put a diagnostic right.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// Description of the change.
    pub title: Message,
    /// Certainty of the fix.
    pub applicability: Applicability,
    /// The changes, which belong together and do not overlap.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// Creates a fix that every reader would mean.
    pub fn certain(title: impl Into<Message>, edits: impl Into<Vec<Edit>>) -> Self {
        Fix {
            title: title.into(),
            applicability: Applicability::Certain,
            edits: edits.into(),
        }
    }

    /// Creates a fix that most readers would mean.
    pub fn likely(title: impl Into<Message>, edits: impl Into<Vec<Edit>>) -> Self {
        Fix {
            applicability: Applicability::Likely,
            ..Fix::certain(title, edits)
        }
    }
}

impl From<Undecodable> for Diagnostic {
    fn from(bad: Undecodable) -> Diagnostic {
        let reason = Reading::NotValid {
            byte: bad.byte,
            encoding: bad.charset.name(),
        };
        let help = match bad.other {
            Some((charset, byte)) => Reading::NotTheOtherEither {
                encoding: charset.name(),
                byte,
            },
            None => Reading::SaveInThatEncoding,
        };
        Diagnostic::new(Code::Format, bad.span, reason).help(help)
    }
}

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
        match self.kept.len() >= KEPT {
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
