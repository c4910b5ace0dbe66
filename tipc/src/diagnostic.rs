//! One diagnostic, as every pass makes it.

mod findings;
mod fix;
mod undecodable;

pub use findings::{Findings, Omitted};
pub use fix::{Applicability, Edit, Fix};

use crate::code::{Code, Level, Mistake};
use crate::language::Edition;
use crate::message::{Cut, Lang, Message, Naming, Structuring};
use crate::source::Span;

/// A second place that a diagnostic points at.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is there.
    pub text: Message,
}

impl Label {
    /// Whether the same mistake shows again here, as at each other use of a name that is not declared.
    pub const fn is_again(&self) -> bool {
        matches!(
            self.text,
            Message::Naming(Naming::AlsoHere) | Message::Structuring(Structuring::JumpsHere)
        )
    }
}

/// One finding about a source file.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Diagnostic {
    /// The class of what it is about.
    pub code: Code,
    /// The name or file that the message's `{}` stands for.
    pub subject: Option<String>,
    /// Where.
    pub span: Span,
    /// The reason: of an error, its headline; of a warning, what is said at the place.
    pub reason: Message,
    /// Other places that matter.
    pub labels: Vec<Label>,
    /// The help: what to do about it.
    pub help: Option<Message>,
    /// Ways to put it right, the best first.
    pub fixes: Vec<Fix>,
    /// Whose rules it is judged by.
    pub edition: Edition,
}

impl Diagnostic {
    /// A finding of `code` at `span`, with the reason in this case.
    pub fn new(code: Code, span: Span, reason: impl Into<Message>) -> Self {
        Diagnostic {
            code,
            subject: None,
            span,
            reason: reason.into(),
            labels: Vec::new(),
            help: None,
            fixes: Vec::new(),
            edition: Edition::default(),
        }
    }

    /// Names what the message's `{}` stands for.
    #[must_use]
    pub fn about(mut self, subject: impl Into<String>) -> Self {
        self.subject = Some(subject.into());
        self
    }

    /// Points at a second place.
    #[must_use]
    pub fn label(mut self, span: Span, text: impl Into<Message>) -> Self {
        self.labels.push(Label {
            span,
            text: text.into(),
        });
        self
    }

    /// Adds the help: what to do about it.
    #[must_use]
    pub fn help(mut self, help: impl Into<Message>) -> Self {
        self.help = Some(help.into());
        self
    }

    /// Its finest code: that of its kind of mistake, as `E205-03`, or that of its class if this covers one kind only.
    pub fn id(&self) -> &'static str {
        let mistake = Mistake::of(self.code, &self.reason);
        mistake.map_or(self.code.id(), |mistake| mistake.id)
    }

    /// How grave it is.
    pub fn level(&self) -> Level {
        self.code.level(self.edition)
    }

    /// The classical message, its subject filled in.
    pub fn message(&self) -> String {
        self.filled(self.code.template())
    }

    /// A template with the subject in it: a path whole, of a name as much as is shown.
    fn filled(&self, template: &str) -> String {
        let subject = self.subject.as_deref().unwrap_or_default();
        match self.code {
            Code::CannotWrite | Code::FileNotFound => template.replace("{}", subject),
            _ => template.replace("{}", &Cut::word(subject).to_string()),
        }
    }

    /// What people read first: of an error its reason, of a warning its message.
    pub fn headline(&self, lang: Lang) -> String {
        match self.level() {
            Level::Error => self.reason.in_lang(lang).to_string(),
            Level::Warning => self.filled(self.code.template_in(lang)),
        }
    }

    /// What is printed of it in one line (T.I.P. 3.1 §9): `TIP_ERR:<message> (<kind>)`; of a warning, its message.
    pub fn title(&self) -> String {
        match self.code.kind() {
            Some(kind) => format!("TIP_ERR:{} ({kind})", self.message()),
            None => self.message(),
        }
    }
}
