//! Conditions of other languages, and relations that are written in another way.

use crate::language::{Edition, Keyword, flags, functions, keywords};
use crate::lex::{Kind, Token};
use crate::message::phrase::End;
use crate::message::{Message, Parsing, Suggestion};
use crate::parse::reader::{Broken, Fault, Reader};
use crate::source::Span;
use crate::syntax::{Operand, OperandKind, Relation, upper_case};

impl Reader<'_> {
    pub(in crate::parse) fn missing_condition(&self) -> Fault {
        self.fault_with_help(self.here(), Parsing::ConditionMissing, Parsing::Conditions)
    }

    /// Returns the fault of a `!` that no flag follows directly: `! FLAG`, `!(A == 1)`, `!` alone.
    pub(in crate::parse) fn negates_no_flag(&self, not: Token, next: Option<Token>) -> Fault {
        let reason = Parsing::NotStandsBeforeFlag;
        match next {
            Some(word) if self.slice(word.span).starts_with('(') => {
                self.fault_with_help(not.span, Suggestion::Not, Suggestion::WriteNot)
            }
            Some(word) if word.kind == Kind::Word => {
                let text = format!("!{}", upper_case(self.slice(word.span))).into();
                self.fault_with_help(not.span, reason, Suggestion::Write { text })
            }
            _ => self.fault_with_help(not.span, reason, Parsing::Conditions),
        }
    }

    /// Returns the fault of a relation that another sign follows: `> =`, `== =`, `><`.
    pub(in crate::parse) fn relation_in_pieces(
        &self,
        relation: Relation,
        sign: Span,
    ) -> Option<Fault> {
        if let Some((token, whole)) = self.split_relation(relation) {
            let location = sign.to(token.span);
            let reason = Suggestion::SplitOperator {
                sign: sign_of(whole).into(),
            };
            return Some(self.meant(whole, location, reason));
        }
        let token = self.peek().filter(is_part_of_relation)?;
        let reason = Parsing::NoRelation;
        Some(match (relation, token.kind) {
            (Relation::Gt, Kind::Relation(Relation::Lt)) => {
                self.fault_with_help(token.span, reason, Suggestion::WriteNotEqual)
            }
            (Relation::Eq, Kind::Assign(None)) => self.meant(Relation::Eq, token.span, reason),
            _ => self.fault_with_help(token.span, reason, Parsing::Relations),
        })
    }

    /// Returns the fault of a token after a comparison: `1 < A < 3`, `A == B + 1`.
    pub(in crate::parse) fn behind_comparison(&self, token: Token) -> Fault {
        let reason = Parsing::CannotStandHere {
            text: self.slice(token.span).into(),
        };
        let help: Message = match token.kind {
            Kind::Relation(_) => Suggestion::Nest.into(),
            Kind::Arithmetic(_) => Suggestion::CalculateBefore.into(),
            _ => Parsing::Conditions.into(),
        };
        self.fault_with_help(token.span, reason, help)
    }

    /// Returns the fault of an operand without a relation: `WHILE 1`, `IF -A THEN`.
    pub(in crate::parse) fn compared_with_nothing(&self, operand: &Operand) -> Fault {
        let help: Message = match operand.kind {
            OperandKind::Number(_) => Suggestion::Forever.into(),
            _ => Parsing::Conditions.into(),
        };
        self.fault_with_help(operand.span, Parsing::ComparedWithNothing, help)
    }

    /// Returns true if a condition begins with a call of a function: `ABS A > 3`.
    pub(in crate::parse) fn calls_function(&self, left: &Operand) -> bool {
        let is_function = |word: &str| functions::words().any(|it| it.eq_ignore_ascii_case(word));
        let is_word = self.peek().is_some_and(|next| next.kind == Kind::Word);
        is_word && is_function(self.slice(left.span))
    }

    /// Returns the second sign of a relation in two pieces such as `> =`, and the whole relation.
    pub(in crate::parse) fn split_relation(&self, first: Relation) -> Option<(Token, Relation)> {
        let next = self.peek().filter(|next| next.spaced)?;
        let whole = match (first, next.kind) {
            (Relation::Lt, Kind::Assign(None)) => Relation::Le,
            (Relation::Gt, Kind::Assign(None)) => Relation::Ge,
            (Relation::Lt, Kind::Relation(Relation::Gt)) => Relation::Ne,
            _ => return None,
        };
        Some((next, whole))
    }

    /// Returns the fault of signs that were meant as a relation.
    pub(in crate::parse) fn meant(
        &self,
        relation: Relation,
        location: Span,
        reason: impl Into<Message>,
    ) -> Fault {
        let help = Suggestion::WriteRelation {
            relation: sign_of(relation),
        };
        self.fault_with_help(location, reason, help)
            .of(Broken::Relation(relation))
    }

    /// Returns the fault after a condition that goes on as in another language.
    pub(in crate::parse) fn joined(&self) -> Option<Fault> {
        let next = self.peek()?;
        let before = self.before().filter(|it| negates(self.slice(it.span)));
        if let Some(not) = before {
            return Some(self.fault_with_help(not.span, Suggestion::Not, Suggestion::WriteNot));
        }
        let word = self.slice(next.span);
        joins_conditions(word).then(|| {
            let reason = Suggestion::AndOr { word: word.into() };
            self.fault_with_help(next.span, reason, Suggestion::Nest)
        })
    }

    pub(in crate::parse) fn no_relation(&self, left: &Operand, token: Token) -> Fault {
        if self.calls_function(left) {
            let location = left.span.to(token.span);
            let reason = Parsing::ConditionCannotCalculate;
            return self.fault_with_help(location, reason, Suggestion::CalculateBefore);
        }
        if token.kind == Kind::Not {
            let help = Suggestion::WriteNotEqual;
            return self
                .fault_with_help(token.span, Suggestion::NotEqual, help)
                .of(Broken::Relation(Relation::Ne));
        }
        let turned = match self.peek_second().filter(|next| !next.spaced) {
            Some(Token {
                kind: Kind::Relation(relation @ (Relation::Gt | Relation::Lt)),
                span,
                ..
            }) => Some((relation, token.span.to(span))),
            _ => None,
        };
        match (token.kind, turned) {
            (Kind::Assign(None), Some((relation, location))) => {
                let relation = match relation {
                    Relation::Gt => Relation::Ge,
                    _ => Relation::Le,
                };
                self.meant(relation, location, Parsing::NoRelation)
            }
            (Kind::Assign(None), None) => {
                let reason = Parsing::AssignsComparesNothing;
                let word = upper_case(self.slice(left.span));
                let fault = self.fault(token.span, reason);
                match flags::find(&word, Edition::default()) {
                    Some(_) => fault.help(Suggestion::FlagAlone { flag: word }),
                    None => fault
                        .help(Parsing::Relations)
                        .of(Broken::Relation(Relation::Eq)),
                }
            }
            (Kind::Arithmetic(_), _) => {
                let reason = Parsing::ConditionCannotCalculate;
                self.fault_with_help(token.span, reason, Suggestion::CalculateBefore)
            }
            _ => self.fault_with_help(token.span, Parsing::RelationBelongsHere, Parsing::Relations),
        }
    }

    /// Returns the help for parentheses around the whole condition, as in `IF (A == 1)`.
    pub(in crate::parse) fn condition_in_parentheses(&self) -> Option<Message> {
        let whole = self.slice(self.whole());
        let (keyword, rest) = whole.split_once('(')?;
        let (inside, rest) = rest.rsplit_once(')')?;
        let keyword = keywords::find(keyword.trim(), Edition::default())?;
        let mut words = inside.split_whitespace();
        if words.any(joins_conditions) {
            return Some(Suggestion::NestWithoutParentheses.into());
        }
        let joins = |word: &str| joins_conditions(word) || negates(word);
        let is_constant = ["1", "TRUE"].contains(&&*upper_case(inside.trim()));
        if keyword == Keyword::While && is_constant {
            return Some(Suggestion::Forever.into());
        }
        if inside.contains(['(', ')', '&', '|', '!']) || inside.split(' ').any(joins) {
            return None;
        }
        let condition = inside.trim();
        let rest = rest.trim();
        let word = keyword.word();
        let closer = match keyword {
            Keyword::If if rest.is_empty() => Keyword::EndIf,
            Keyword::While if rest.is_empty() => Keyword::Wend,
            // `IF (A == 1) MESSAGE one`: the statement needs a line of its own.
            Keyword::If if !jumps(rest) => Keyword::EndIf,
            Keyword::If | Keyword::ElseIf | Keyword::While | Keyword::Until => {
                let written = upper_case(format!("{word} {condition} {rest}").trim());
                return Some(Suggestion::WithoutParentheses { written }.into());
            }
            _ => return None,
        };
        let then = if closer == Keyword::EndIf {
            " THEN"
        } else {
            ""
        };
        let written = upper_case(&format!("{word} {condition}{then}"));
        Some(Suggestion::OpenBlock { written, closer }.into())
    }

    /// Returns the fault after a condition that opens a block as in another language: `WHILE A < 3 DO`.
    pub(in crate::parse) fn opened(&self) -> Option<Fault> {
        let word = self.peek().filter(|_| self.left() == 1)?;
        let text = self.slice(word.span);
        let opens = text.eq_ignore_ascii_case("DO") || text == ":" || self.at_word(Keyword::Then);
        opens.then(|| {
            let end = End::Condition;
            let help = Suggestion::BlockBegins;
            self.fault_with_help(word.span, Parsing::NothingBehind { end }, help)
        })
    }
}

/// Returns true if a word joins two conditions in another language.
fn joins_conditions(word: &str) -> bool {
    ["AND", "OR", "XOR", "&&", "||", "&", "|"]
        .iter()
        .any(|one| one.eq_ignore_ascii_case(word))
}

/// Returns true if a word negates in another language.
fn negates(word: &str) -> bool {
    word.eq_ignore_ascii_case("NOT")
}

/// Returns true if what follows a condition goes on with its IF.
fn jumps(rest: &str) -> bool {
    let first = rest.split([' ', '\t']).next().unwrap_or_default();
    let words = [Keyword::Then, Keyword::Goto, Keyword::Gosub, Keyword::Call];
    words.iter().any(|word| word.is(first))
}

fn is_part_of_relation(token: &Token) -> bool {
    matches!(
        token.kind,
        Kind::Relation(_) | Kind::Assign(None) | Kind::Not
    )
}

/// Returns the tokens of a statement with the relation that was meant, if that is what is wrong with it: `IF A = 1
/// GOTO L1`.
pub(in crate::parse) fn with_intended_relation(
    fault: &Fault,
    tokens: &[Token],
) -> Option<Vec<Token>> {
    let Broken::Relation(relation) = fault.broken else {
        return None;
    };
    let fault = &fault.diagnostic;
    let first = tokens
        .iter()
        .position(|it| it.span.start == fault.span.start)?;
    let is_operand = |at: usize| tokens.get(at).is_some_and(|it| it.kind == Kind::Word);
    let rest = tokens[first..].iter();
    let within = rest.take_while(|it| it.span.end <= fault.span.end).count();
    // `!` and `=`
    let signs = match is_operand(first + within.max(1)) {
        true => within.max(1),
        false => within + 1,
    };
    let end = first + signs;
    if !is_operand(first.checked_sub(1)?) || !is_operand(end) {
        return None;
    }
    let span = Span::new(fault.span.start, tokens[end - 1].span.end);
    let sign = Token {
        kind: Kind::Relation(relation),
        span,
        spaced: tokens[first].spaced,
    };
    let (before, after) = (&tokens[..first], &tokens[end..]);
    Some([before, &[sign], after].concat())
}

/// Returns how a relation is written.
fn sign_of(relation: Relation) -> &'static str {
    match relation {
        Relation::Eq => "==",
        Relation::Ne => "<>",
        Relation::Lt => "<",
        Relation::Gt => ">",
        Relation::Le => "<=",
        Relation::Ge => ">=",
    }
}
