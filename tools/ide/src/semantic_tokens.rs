//! Semantic tokens: words with their classes, for editors that colour them.

use crate::Document;
use crate::word::{Word, WordKind};
use tipc::source::{Line, Span};
use tipc::symbols::{Access, DefinitionKind};

/// The class of a token.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TokenClass {
    /// A keyword.
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
    /// Text of MESSAGE, and text that is not read.
    Text,
    /// A comment.
    Comment,
    /// An operator.
    Operator,
}

/// A token with its class.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SemanticToken {
    /// The token, which is within one line.
    pub span: Span,
    /// Its class.
    pub class: TokenClass,
    /// The name is declared here.
    pub declares: bool,
    /// The variable is assigned here.
    pub assigns: bool,
}

impl TokenClass {
    /// Every class.
    pub const ALL: [TokenClass; 13] = [
        TokenClass::Keyword,
        TokenClass::Command,
        TokenClass::Function,
        TokenClass::Flag,
        TokenClass::Constant,
        TokenClass::Modifier,
        TokenClass::Variable,
        TokenClass::Member,
        TokenClass::Label,
        TokenClass::Number,
        TokenClass::Text,
        TokenClass::Comment,
        TokenClass::Operator,
    ];
}

impl Document {
    /// Returns the tokens of the lines that touch a span, in the order of the text.
    pub fn semantic_tokens(&self, span: Span) -> Vec<SemanticToken> {
        let source = &self.loaded.source;
        let first = source.line_column(span.start).0;
        let mut found = Vec::new();
        let mut line: Line = source.line(first);
        while line.span.start <= span.end && line.number <= source.line_count() {
            found.extend(
                self.words(line)
                    .iter()
                    .filter_map(|word| self.token_of(word)),
            );
            line = source.line(line.number + 1);
        }
        found
    }

    fn token_of(&self, word: &Word) -> Option<SemanticToken> {
        let (mut declares, mut assigns) = (false, false);
        let class = match word.kind {
            WordKind::Keyword(_) => TokenClass::Keyword,
            WordKind::Command(_) => TokenClass::Command,
            WordKind::Function(_) => TokenClass::Function,
            WordKind::Flag(_) => TokenClass::Flag,
            WordKind::Input(_) | WordKind::Target(_) | WordKind::Constant(..) => {
                TokenClass::Constant
            }
            WordKind::Reading(_) => TokenClass::Variable,
            WordKind::MotionFlag(_) => TokenClass::Modifier,
            WordKind::Member(_) => TokenClass::Member,
            WordKind::Number | WordKind::Version => TokenClass::Number,
            WordKind::Text => TokenClass::Text,
            WordKind::Comment => TokenClass::Comment,
            WordKind::Operator => TokenClass::Operator,
            WordKind::Name(named) => {
                let definition = self.definition_of(&named);
                let access = named.access;
                declares = access == Access::Define || definition.span == Some(named.span);
                assigns = matches!(access, Access::Assign | Access::Update | Access::Count);
                match definition.kind {
                    DefinitionKind::Variable(_) => TokenClass::Variable,
                    DefinitionKind::Constant => TokenClass::Constant,
                    DefinitionKind::Label | DefinitionKind::Subroutine | DefinitionKind::Thread => {
                        TokenClass::Label
                    }
                }
            }
            WordKind::Unknown => return None,
        };
        Some(SemanticToken {
            span: word.span,
            class,
            declares,
            assigns,
        })
    }
}
