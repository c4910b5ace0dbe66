//! Classes of words, for editors that colour them.

use crate::Document;
use crate::word::{What, Word};
use tipc::source::{Line, Span};
use tipc::symbols::{Access, DefinitionKind, Use};

/// The class of a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Paint {
    /// A word that the parser reads itself.
    Keyword,
    /// A command.
    Command,
    /// A function of equations.
    Function,
    /// A flag of conditions.
    Flag,
    /// A target, an input or a constant.
    Constant,
    /// `HS`, `R` or `A`.
    Modifier,
    /// A variable.
    Variable,
    /// A member of a variable.
    Member,
    /// A label or subroutine.
    Label,
    /// A number.
    Number,
    /// A text that is shown.
    Text,
    /// A comment.
    Comment,
    /// An operator.
    Operator,
}

/// A word with its class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Painted {
    /// The word, which never goes on to another line.
    pub span: Span,
    /// Its class.
    pub paint: Paint,
    /// It is declared here.
    pub declares: bool,
    /// It is given a value here.
    pub assigns: bool,
}

impl Paint {
    /// Every class.
    pub const ALL: [Paint; 13] = [
        Paint::Keyword,
        Paint::Command,
        Paint::Function,
        Paint::Flag,
        Paint::Constant,
        Paint::Modifier,
        Paint::Variable,
        Paint::Member,
        Paint::Label,
        Paint::Number,
        Paint::Text,
        Paint::Comment,
        Paint::Operator,
    ];
}

impl Document {
    /// The classes of the words in a stretch of the text, line by line and from left to right.
    pub fn paint(&self, span: Span) -> Vec<Painted> {
        let source = &self.loaded.source;
        let first = source.line_column(span.start).0;
        let mut found = Vec::new();
        let mut line: Line = source.line(first);
        while line.span.start <= span.end && line.number <= source.line_count() {
            found.extend(
                self.words(line)
                    .iter()
                    .filter_map(|word| self.painted(word)),
            );
            line = source.line(line.number + 1);
        }
        found
    }

    fn painted(&self, word: &Word) -> Option<Painted> {
        let plain = |paint: Paint| Painted {
            span: word.span,
            paint,
            declares: false,
            assigns: false,
        };
        Some(match word.what {
            What::Keyword(_) => plain(Paint::Keyword),
            What::Command(_) => plain(Paint::Command),
            What::Function(_) => plain(Paint::Function),
            What::Flag(_) => plain(Paint::Flag),
            What::Input(_) | What::Target(_) | What::Constant(..) => plain(Paint::Constant),
            What::MotionFlag(_) => plain(Paint::Modifier),
            What::Member(_) => plain(Paint::Member),
            What::Number | What::Version => plain(Paint::Number),
            What::Text => plain(Paint::Text),
            What::Comment => plain(Paint::Comment),
            What::Operator => plain(Paint::Operator),
            What::Name(named) => self.painted_name(&named, plain(Paint::Variable)),
            What::Unknown => return None,
        })
    }

    fn painted_name(&self, named: &Use, plain: Painted) -> Painted {
        let definition = self.definition_of(named);
        let paint = match definition.kind {
            DefinitionKind::Variable(_) => Paint::Variable,
            DefinitionKind::Label | DefinitionKind::Subroutine => Paint::Label,
        };
        let assigns = matches!(
            named.access,
            Access::Assign | Access::Update | Access::Count
        );
        Painted {
            paint,
            declares: named.access == Access::Define || definition.place == Some(named.place),
            assigns,
            ..plain
        }
    }
}
