//! How a finding can be put right, as changes of the text.

use crate::message::Message;
use crate::source::Span;

/// How sure it is that a fix is what was meant.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Applicability {
    /// Every reader would mean exactly this.
    Certain,
    /// Most readers would mean this; someone has to look.
    Likely,
}

impl Applicability {
    /// Its name for tools.
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
    /// What goes; empty where something is only put in.
    pub span: Span,
    /// What comes in its place: ASCII, which every encoding spells alike.
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

    /// Nothing in the place of `span`.
    pub fn remove(span: Span) -> Self {
        Edit::replace(span, "")
    }
}

/// A way to put a finding right.
#[derive(Clone, Debug, PartialEq)]
pub struct Fix {
    /// What it does.
    pub title: Message,
    /// How sure it is.
    pub applicability: Applicability,
    /// The changes, which belong together and do not overlap.
    pub edits: Vec<Edit>,
}

impl Fix {
    /// What every reader would mean.
    pub fn certain(title: impl Into<Message>, edits: impl Into<Vec<Edit>>) -> Self {
        Fix {
            title: title.into(),
            applicability: Applicability::Certain,
            edits: edits.into(),
        }
    }

    /// What most readers would mean.
    pub fn likely(title: impl Into<Message>, edits: impl Into<Vec<Edit>>) -> Self {
        Fix {
            applicability: Applicability::Likely,
            ..Fix::certain(title, edits)
        }
    }
}
