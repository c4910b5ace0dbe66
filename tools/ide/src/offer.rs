//! What completion offers.

use tipc::language::Bilingual;
use tipc::source::Span;

/// Something that can be written at a place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Offer {
    /// The word.
    pub label: String,
    /// What it is.
    pub kind: OfferKind,
    /// How it is used, in a few words.
    pub detail: String,
    /// One line that says what it is.
    pub description: Bilingual,
    /// What goes: the word that is begun.
    pub span: Span,
    /// What comes instead.
    pub text: String,
    /// The same with places to fill, where there are any, as a snippet of the Language Server Protocol.
    pub template: Option<String>,
}

/// What is offered.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum OfferKind {
    /// A word that the parser reads itself.
    Keyword,
    /// A command of the robot.
    Command,
    /// A function.
    Function,
    /// A flag of conditions.
    Flag,
    /// A target or an input.
    Target,
    /// `HS`, `R` or `A`.
    MotionFlag,
    /// A constant.
    Constant,
    /// A variable.
    Variable,
    /// A member of a POS or JOINT.
    Member,
    /// A label or SUBROUTINE.
    Label,
}

impl Offer {
    pub(crate) fn new(label: impl Into<String>, kind: OfferKind, description: Bilingual) -> Self {
        let label = label.into();
        Offer {
            text: label.clone(),
            label,
            kind,
            detail: String::new(),
            description,
            span: Span::default(),
            template: None,
        }
    }

    pub(crate) fn detail(self, detail: impl Into<String>) -> Self {
        Offer {
            detail: detail.into(),
            ..self
        }
    }

    pub(crate) fn template(self, template: String) -> Self {
        let template = Some(template).filter(|template| *template != self.text);
        Offer { template, ..self }
    }
}
