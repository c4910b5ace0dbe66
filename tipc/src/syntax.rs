//! Statements as data: what the parser reads, before anything is looked up or judged.
//!
//! Words are upper-cased. Every piece keeps its span.

mod statement;

pub use statement::{Jump, JumpKind, LabelKind, Shape, StatementKind, Then};

use crate::language::Edition;
use crate::source::Span;
use smol_str::{SmolStr, StrExt};

/// A node of the syntax with its location.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spanned<T> {
    /// The thing.
    pub node: T,
    /// Location in the source.
    pub span: Span,
}

/// The number of a step, from 0.
pub type StepId = u32;

/// A word, upper-cased.
pub type Word = Spanned<SmolStr>;

/// Returns a piece of the source in capital letters, as it is usually written.
pub fn upper_case(text: &str) -> SmolStr {
    match text.bytes().any(|byte| byte.is_ascii_lowercase()) {
        true => text.to_ascii_uppercase_smolstr(),
        false => text.into(),
    }
}

/// The types of variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum VariableKind {
    /// A scalar.
    Var,
    /// X, Y, Z in mm.
    Pos,
    /// J1…Jn.
    Joint,
}

/// An operand or argument as written: `-12.5`, `A`, `-P.X`, `F1`, `ALL`, `HS`, `J11`.
#[derive(Clone, Debug, PartialEq)]
pub struct Operand {
    /// Kind of the operand.
    pub kind: OperandKind,
    /// A minus precedes a name (a constant holds its own sign).
    pub negative: bool,
    /// The operand with its sign.
    pub span: Span,
}

/// Kind of an operand.
#[derive(Clone, Debug, PartialEq)]
pub enum OperandKind {
    /// A constant with its sign.
    Number(f64),
    /// A word.
    Name(SmolStr),
    /// The words before and after a point; boxed, since few operands are members.
    Member(Box<(SmolStr, SmolStr)>),
}

/// `a REL b`, or an event flag.
#[derive(Clone, Debug, PartialEq)]
pub enum Condition {
    /// Two scalars compared.
    Compare {
        /// The left operand.
        left: Operand,
        /// The relation.
        relation: Relation,
        /// The right operand.
        right: Operand,
    },
    /// `FLAG` or `!FLAG`.
    Flag {
        /// The flag's name without `!`.
        name: Word,
        /// `!` precedes it.
        negated: bool,
    },
}

/// A relational operator.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Relation {
    /// `==`
    Eq,
    /// `<>`
    Ne,
    /// `<`
    Lt,
    /// `>`
    Gt,
    /// `<=`
    Le,
    /// `>=`
    Ge,
}

/// The four operations.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arithmetic {
    /// `+`
    Add,
    /// `-`
    Sub,
    /// `*`
    Mul,
    /// `/`
    Div,
}

/// The operands of FOR.
#[derive(Clone, Debug, PartialEq)]
pub struct Counting {
    /// The loop variable.
    pub variable: Operand,
    /// The initial value.
    pub from: Operand,
    /// The last value.
    pub to: Operand,
    /// The increment, 1 if omitted.
    pub step: Option<Operand>,
}

/// An equation as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Equation {
    /// The left side.
    pub target: Operand,
    /// `None` for `=`, else the operation of `+= -= *= /=`.
    pub update: Option<Arithmetic>,
    /// The operator's location.
    pub operator: Span,
    /// The right side.
    pub value: Expression,
}

/// The right side of an equation as written; types are for the checker.
#[derive(Clone, Debug, PartialEq)]
pub enum Expression {
    /// `a`
    Operand(Operand),
    /// `a + b` and its like.
    Binary {
        /// The left operand.
        left: Operand,
        /// The operation.
        operation: Arithmetic,
        /// The right operand.
        right: Operand,
    },
    /// A function word and its operands, however many there are.
    Function {
        /// The function's name.
        name: Word,
        /// Its operands.
        operands: Vec<Operand>,
    },
}

/// A whole source file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Module {
    /// The edition of the language, which line 1 chooses.
    pub edition: Edition,
    /// Line 2.
    pub title: String,
    /// The statements up to and including the first END.
    pub statements: Vec<Statement>,
    /// Text after END on its line, which is not part of the program.
    pub after_end: Option<Word>,
}

impl Module {
    /// Returns the statements that are steps, in order: the first is step 0.
    pub fn steps(&self) -> impl Iterator<Item = &Statement> {
        self.statements.iter().filter(|it| it.is_step())
    }

    /// Returns the index of the statement that is a step.
    pub fn statement_of(&self, step: StepId) -> Option<usize> {
        // After declarations comes the statement whose number they share.
        let behind = self.statements.partition_point(|it| it.step <= step);
        let index = behind.checked_sub(1)?;
        let statement = &self.statements[index];
        (statement.is_step() && statement.step == step).then_some(index)
    }

    /// Returns the index of the statement that covers a byte of the text, or ends there.
    pub fn statement_at(&self, offset: usize) -> Option<usize> {
        let behind = self
            .statements
            .partition_point(|it| it.span.start <= offset);
        let index = behind.checked_sub(1)?;
        (offset <= self.statements[index].span.end).then_some(index)
    }
}

/// One statement. Each but a declaration is one step; `L1: CMD` is two statements, `SUBROUTINE NAME:` one.
#[derive(Clone, Debug, PartialEq)]
pub struct Statement {
    /// Kind of the statement.
    pub kind: StatementKind,
    /// The whole statement.
    pub span: Span,
    /// Its source line, from 1.
    pub line: u32,
    /// Its step; of a declaration, which is not one, the step after it.
    pub step: StepId,
}

impl Statement {
    /// Returns true if it is a step: everything but a declaration.
    pub const fn is_step(&self) -> bool {
        !matches!(
            self.kind,
            StatementKind::Define { .. } | StatementKind::Constant { .. }
        )
    }

    /// Returns its first word if it has a location of its own, else the whole statement.
    pub const fn keyword(&self) -> Span {
        match self.kind.keyword() {
            Some(keyword) => keyword,
            None => self.span,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::parse::parse;
    use crate::source::{Encoding, Source};
    use crate::syntax::Module;

    const TEXT: &str =
        "3.1\nsteps\nDEF_VAR A\nDEF_POS P\nL1: A = 1\nDEF_VAR B\nB = A; SLEEP B\nEND\n";

    fn module(text: &str) -> Module {
        let (source, _) = Source::decode("steps.prg", text.as_bytes(), Encoding::Utf8);
        parse(&source, Some(3.1)).0
    }

    // clauses: 2.1
    #[test]
    fn each_statement_but_a_declaration_is_a_step() {
        let module = module(TEXT);
        let steps: Vec<(u32, bool)> = module
            .statements
            .iter()
            .map(|it| (it.step, it.is_step()))
            .collect();
        let declared = |step| (step, false);
        let step = |step| (step, true);
        let expected = [
            declared(0),
            declared(0),
            step(0),
            step(1),
            declared(2),
            step(2),
            step(3),
            step(4),
        ];
        assert_eq!(steps, expected);
        let found: Vec<Option<usize>> = (0..6).map(|step| module.statement_of(step)).collect();
        let statements = [Some(2), Some(3), Some(5), Some(6), Some(7), None];
        assert_eq!(found, statements);
        assert_eq!(module.steps().count(), 5);
    }

    #[test]
    fn a_declaration_behind_the_last_statement_is_no_step() {
        let module = module("3.1\nsteps\nA = 1\nDEF_VAR A\n");
        assert_eq!(module.statement_of(0), Some(0));
        assert_eq!(module.statement_of(1), None);
    }

    #[test]
    fn a_place_leads_to_its_statement() {
        let module = module(TEXT);
        let at = |word: &str, offset: usize| {
            module.statement_at(TEXT.find(word).expect("it stands there") + offset)
        };
        assert_eq!(module.statement_at(0), None);
        assert_eq!(at("DEF_VAR A", 0), Some(0));
        assert_eq!(at("DEF_VAR A", 9), Some(0));
        assert_eq!(at("L1:", 3), Some(2));
        assert_eq!(at("A = 1", 0), Some(3));
        assert_eq!(at("; SLEEP", 0), Some(5));
        assert_eq!(at("; SLEEP", 1), None);
        assert_eq!(at("END", 3), Some(7));
    }
}
