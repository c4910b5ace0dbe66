//! Semantic tokens: words with their classes, for editors that colour them.

use crate::Document;
use crate::word::{Word, WordKind};
use tipc::source::{Line, Span};
use tipc::symbols::{Access, DefinitionKind, Use};

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
        let plain = |class: TokenClass| SemanticToken {
            span: word.span,
            class,
            declares: false,
            assigns: false,
        };
        Some(match word.kind {
            WordKind::Keyword(_) => plain(TokenClass::Keyword),
            WordKind::Command(_) => plain(TokenClass::Command),
            WordKind::Function(_) => plain(TokenClass::Function),
            WordKind::Flag(_) => plain(TokenClass::Flag),
            WordKind::Input(_) | WordKind::Target(_) | WordKind::Constant(..) => {
                plain(TokenClass::Constant)
            }
            WordKind::Reading(_) => plain(TokenClass::Variable),
            WordKind::MotionFlag(_) => plain(TokenClass::Modifier),
            WordKind::Member(_) => plain(TokenClass::Member),
            WordKind::Number | WordKind::Version => plain(TokenClass::Number),
            WordKind::Text => plain(TokenClass::Text),
            WordKind::Comment => plain(TokenClass::Comment),
            WordKind::Operator => plain(TokenClass::Operator),
            WordKind::Name(named) => self.name_token(&named, plain(TokenClass::Variable)),
            WordKind::Unknown => return None,
        })
    }

    fn name_token(&self, named: &Use, plain: SemanticToken) -> SemanticToken {
        let definition = self.definition_of(named);
        let class = match definition.kind {
            DefinitionKind::Variable(_) => TokenClass::Variable,
            DefinitionKind::Label | DefinitionKind::Subroutine | DefinitionKind::Thread => {
                TokenClass::Label
            }
            DefinitionKind::Constant => TokenClass::Constant,
        };
        let assigns = matches!(
            named.access,
            Access::Assign | Access::Update | Access::Count
        );
        SemanticToken {
            class,
            declares: named.access == Access::Define || definition.span == Some(named.span),
            assigns,
            ..plain
        }
    }
}
