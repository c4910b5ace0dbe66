//! One diagnostic, as every pass makes it.

use crate::code::{Code, Level};
use crate::language::Edition;
use crate::message::{Cut, Lang, Message, Naming, Reading, Structuring};
use crate::source::{Span, Undecodable};
pub use collection::{Diagnostics, MAX_DIAGNOSTICS, Omitted};
pub(crate) use collection::{Handle, by_location};
pub(crate) use mistake::MistakeId;

mod collection;
mod mistake;

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
    /// Returns true if the label marks another occurrence of the same mistake, such as another use of an undeclared
    /// name.
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
    /// The name or file that replaces the message's `{}`.
    pub subject: Option<String>,
    /// Location in the source.
    pub span: Span,
    /// The reason. It is the headline of an error, and the text at the location of a warning.
    pub reason: Message,
    /// Other locations that matter.
    pub labels: Vec<Label>,
    /// The help: what to do about it.
    pub help: Option<Message>,
    /// True if the help is a guess at the meaning of an unknown word. A crate that knows the word may replace the help.
    pub is_guess: bool,
    /// Ways to put it right, the best first.
    pub fixes: Vec<Fix>,
    /// The edition of the program, which decides the severity.
    pub edition: Edition,
    /// The code of its kind of mistake, see [`Diagnostic::id`].
    id: &'static str,
    /// The identity of a mistake that is reported once: later diagnostics of it become labels of the first one.
    pub(crate) once: Option<MistakeId>,
    /// The text of those labels; `None` for the usual text.
    again: Option<Message>,
}

impl Diagnostic {
    /// Creates a diagnostic of class `code` at `span`.
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

    /// Sets the subject, which replaces the message's `{}`.
    #[must_use]
    pub fn about(mut self, subject: impl Into<String>) -> Self {
        self.subject = Some(subject.into());
        self
    }

    /// Names the mistake, which is reported once.
    #[must_use]
    pub(crate) fn once(mut self, mistake: MistakeId) -> Self {
        self.once = Some(mistake);
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

    /// Adds a help that only guesses the meaning of an unknown word.
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

    /// Fills the subject into a template. A path is kept whole; a long name is cut.
    fn filled(&self, template: &str) -> String {
        let subject = self.subject.as_deref().unwrap_or_default();
        match self.code {
            Code::CannotWrite | Code::FileNotFound => template.replace("{}", subject),
            _ => template.replace("{}", &Cut::word(subject).to_string()),
        }
    }

    /// Returns the line that people read first: the reason of an error, the message of a warning.
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
    /// Creates an edit that replaces the text at `span`.
    pub fn replace(span: Span, text: impl Into<String>) -> Self {
        let text = text.into();
        Edit { span, text }
    }

    /// Creates an edit that inserts a text before the byte at `at`.
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
