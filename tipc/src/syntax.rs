//! Statements as data: what the parser reads, before anything is looked up or judged.
//!
//! Words are upper-cased. Every piece keeps its span.

use crate::diagnostic::Diagnostic;
use crate::language::{Edition, Keyword};
use crate::source::Span;
use smol_str::{SmolStr, StrExt};
use tip_runtime::command::{Reading, Target, Teach};

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

impl VariableKind {
    /// Returns the type of a special variable.
    pub const fn of_reading(reading: Reading) -> Self {
        match reading {
            Reading::Measured(Teach::Position | Teach::Force, _) => VariableKind::Pos,
            Reading::Measured(_, Target::Joint(..)) | Reading::Timer(_) => VariableKind::Var,
            Reading::Measured(Teach::Angle | Teach::Torque, _) => VariableKind::Joint,
        }
    }
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

impl Operand {
    /// Returns its name, without the member; `None` for a constant.
    pub const fn name(&self) -> Option<&SmolStr> {
        match &self.kind {
            OperandKind::Number(_) => None,
            OperandKind::Name(name) => Some(name),
            OperandKind::Member(words) => Some(&words.0),
        }
    }
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
    /// An operator and two operands: `a + b`.
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

/// Kind of a statement. Large parts are boxed: a long program holds many statements.
#[derive(Clone, Debug, PartialEq)]
pub enum StatementKind {
    /// `DEF_VAR`, `DEF_POS`, `DEF_JOINT`: not a step.
    Define {
        /// The type of the names.
        kind: VariableKind,
        /// The command word.
        keyword: Span,
        /// The names as written, well-formed or not.
        names: Vec<Word>,
    },
    /// `DEFINE NAME value`: not a step.
    Constant {
        /// The command word.
        keyword: Span,
        /// The name as written, well-formed or not.
        name: Word,
        /// The value as written, constant or not.
        value: Operand,
    },
    /// `NAME:`; the name without its colon.
    Label(Word),
    /// `LHS op RHS`.
    Equation(Box<Equation>),
    /// `IF condition` and what follows it.
    If {
        /// The command word.
        keyword: Span,
        /// The condition.
        condition: Box<Condition>,
        /// THEN, GOTO or GOSUB.
        then: Then,
    },
    /// `ELSEIF condition THEN`.
    ElseIf {
        /// The command word.
        keyword: Span,
        /// The condition.
        condition: Box<Condition>,
    },
    /// `ELSE`
    Else,
    /// `ENDIF`
    EndIf,
    /// `WHILE condition`
    While {
        /// The command word.
        keyword: Span,
        /// The condition.
        condition: Box<Condition>,
    },
    /// `WEND`
    Wend,
    /// `REPEAT`
    Repeat,
    /// `UNTIL condition`
    Until {
        /// The command word.
        keyword: Span,
        /// The condition.
        condition: Box<Condition>,
    },
    /// `FOR variable = from TO to [STEP step]`
    For {
        /// The command word.
        keyword: Span,
        /// Counter and range.
        counting: Box<Counting>,
    },
    /// `NEXT [variable]`
    Next {
        /// The command word.
        keyword: Span,
        /// The loop variable, if named.
        variable: Option<Operand>,
    },
    /// `SUBROUTINE NAME:`; the name without its colon.
    Subroutine {
        /// The command word.
        keyword: Span,
        /// The declared name, without colon.
        name: Word,
    },
    /// `SUBEND`
    SubEnd,
    /// `THREAD NAME:`; the name without its colon.
    Thread {
        /// The command word.
        keyword: Span,
        /// The declared name, without colon.
        name: Word,
    },
    /// `THREADEND`
    ThreadEnd,
    /// `START_THREAD NAME:`
    StartThread(Jump),
    /// `STOP_THREAD NAME:`
    StopThread(Jump),
    /// `WAIT_THREAD NAME:`
    WaitThread(Jump),
    /// `CALL NAME:`
    Call(Jump),
    /// `GOTO [NAME:]`
    Goto(Jump),
    /// `GOSUB NAME:`
    Gosub(Jump),
    /// `RETURN`
    Return,
    /// `END`
    End,
    /// `EXIT`
    Exit,
    /// `REM text`
    Rem,
    /// `MESSAGE text`; the text trimmed, U+3000 already two spaces, escapes and placeholders as written.
    Message {
        /// The text.
        text: Spanned<String>,
    },
    /// `F_MESSAGE text`; the text as in MESSAGE.
    FileMessage {
        /// The text.
        text: Spanned<String>,
    },
    /// Any other command with its arguments; whether it exists is for the checker to say.
    Command {
        /// The command word.
        name: Word,
        /// Its arguments, up to the first malformed one.
        arguments: Vec<Operand>,
        /// Malformed part after `arguments`, not yet reported: it counts only if the command exists.
        malformed: Option<Box<Diagnostic>>,
    },
    /// A statement that the parser has already reported; it still takes its step.
    Broken(Shape),
}

/// The effect of a statement on the blocks around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edge {
    /// It stands inside a block.
    Inside,
    /// It opens a block.
    Opens,
    /// It closes a branch that one of these opened, and opens the next.
    Parts(&'static [Shape]),
    /// It closes a block that one of these opened; without any, the innermost one.
    Closes(&'static [Shape]),
}

macro_rules! shapes {
    ($( $(#[$doc:meta])* $shape:ident: $keyword:expr, $edge:expr; )*) => {
        /// Role of a statement among the blocks; of a broken one, the intended role, so that one mistake does not
        /// unbalance the blocks around it.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Shape {
            $( $(#[$doc])* $shape, )*
        }

        impl Shape {
            /// Every role.
            pub const ALL: &[Shape] = &[$( Shape::$shape, )*];

            /// Returns the word of such a statement; `None` for one that neither opens nor closes a block, or should
            /// not be.
            pub const fn keyword(self) -> Option<Keyword> {
                match self {
                    $( Shape::$shape => $keyword, )*
                }
            }

            /// Returns its effect on the blocks around it.
            pub const fn edge(self) -> Edge {
                match self {
                    $( Shape::$shape => $edge, )*
                }
            }
        }
    };
}

/// Shapes of the statements that open a branch of an IF.
const BRANCHES: &[Shape] = &[Shape::If, Shape::ElseIf, Shape::Else];

shapes! {
    /// Neither opens nor closes anything.
    Plain: None, Edge::Inside;
    /// `IF … THEN`
    If: Some(Keyword::If), Edge::Opens;
    /// `IF … THEN` with a statement after it: a mistake that may or may not have its ENDIF.
    OneLineIf: None, Edge::Inside;
    /// `ELSEIF`
    ElseIf: Some(Keyword::ElseIf), Edge::Parts(BRANCHES);
    /// `ELSE`
    Else: Some(Keyword::Else), Edge::Parts(BRANCHES);
    /// `ENDIF`
    EndIf: Some(Keyword::EndIf), Edge::Closes(BRANCHES);
    /// `WHILE`
    While: Some(Keyword::While), Edge::Opens;
    /// `WEND`
    Wend: Some(Keyword::Wend), Edge::Closes(&[Shape::While]);
    /// `REPEAT`
    Repeat: Some(Keyword::Repeat), Edge::Opens;
    /// `UNTIL`
    Until: Some(Keyword::Until), Edge::Closes(&[Shape::Repeat]);
    /// `FOR`
    For: Some(Keyword::For), Edge::Opens;
    /// `NEXT`
    Next: Some(Keyword::Next), Edge::Closes(&[Shape::For]);
    /// `}` of another language: a mistake that closes whatever is open.
    Close: None, Edge::Closes(&[]);
    /// `SUBROUTINE`
    Subroutine: Some(Keyword::Subroutine), Edge::Opens;
    /// `SUBEND`
    SubEnd: Some(Keyword::SubEnd), Edge::Closes(&[Shape::Subroutine]);
    /// `THREAD`
    Thread: Some(Keyword::Thread), Edge::Opens;
    /// `THREADEND`
    ThreadEnd: Some(Keyword::ThreadEnd), Edge::Closes(&[Shape::Thread]);
}

impl Shape {
    /// Returns the role of a statement with this word that is written as it should be; `None` if the word is none of
    /// blocks.
    pub fn of(keyword: Keyword) -> Option<Self> {
        let mut all = Shape::ALL.iter().copied();
        all.find(|shape| shape.keyword() == Some(keyword))
    }

    /// Returns the roles that open what it closes.
    pub const fn closes(self) -> &'static [Shape] {
        match self.edge() {
            Edge::Parts(openers) | Edge::Closes(openers) => openers,
            Edge::Inside | Edge::Opens => &[],
        }
    }

    /// Returns true if it opens a block, or another branch of one.
    pub const fn opens(self) -> bool {
        matches!(self.edge(), Edge::Opens | Edge::Parts(_))
    }
}

/// Continuation of an IF.
#[derive(Clone, Debug, PartialEq)]
pub enum Then {
    /// `THEN`: a block follows.
    Block,
    /// `GOTO [NAME:]`
    Goto(Jump),
    /// `GOSUB NAME:`
    Gosub(Jump),
}

/// A jump as written.
#[derive(Clone, Debug, PartialEq)]
pub struct Jump {
    /// The jump's own word.
    pub keyword: Span,
    /// The label without its colon; `None` if omitted.
    pub label: Option<Word>,
    /// True if the jump is wrong in itself, which is reported.
    pub broken: bool,
}

/// Kind of jump to a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum JumpKind {
    /// Goes there.
    Goto,
    /// Goes to a label or SUBROUTINE, and comes back.
    Gosub,
    /// Goes to a SUBROUTINE, and comes back.
    Call,
    /// Names a THREAD to start, stop or wait for, and goes on.
    Thread,
}

/// Kind of a label.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum LabelKind {
    /// A label of its own.
    Plain,
    /// The name of a SUBROUTINE.
    Subroutine,
    /// The name of a THREAD.
    Thread,
}

impl StatementKind {
    /// Returns its role among the blocks.
    pub const fn shape(&self) -> Shape {
        match self {
            StatementKind::If {
                then: Then::Block, ..
            } => Shape::If,
            StatementKind::ElseIf { .. } => Shape::ElseIf,
            StatementKind::Else => Shape::Else,
            StatementKind::EndIf => Shape::EndIf,
            StatementKind::While { .. } => Shape::While,
            StatementKind::Wend => Shape::Wend,
            StatementKind::Repeat => Shape::Repeat,
            StatementKind::Until { .. } => Shape::Until,
            StatementKind::For { .. } => Shape::For,
            StatementKind::Next { .. } => Shape::Next,
            StatementKind::Subroutine { .. } => Shape::Subroutine,
            StatementKind::SubEnd => Shape::SubEnd,
            StatementKind::Thread { .. } => Shape::Thread,
            StatementKind::ThreadEnd => Shape::ThreadEnd,
            StatementKind::Broken(shape) => *shape,
            StatementKind::If {
                then: Then::Goto(_) | Then::Gosub(_),
                ..
            }
            | StatementKind::Define { .. }
            | StatementKind::Constant { .. }
            | StatementKind::Label(_)
            | StatementKind::Equation(_)
            | StatementKind::StartThread(_)
            | StatementKind::StopThread(_)
            | StatementKind::WaitThread(_)
            | StatementKind::FileMessage { .. }
            | StatementKind::Call(_)
            | StatementKind::Goto(_)
            | StatementKind::Gosub(_)
            | StatementKind::Return
            | StatementKind::End
            | StatementKind::Exit
            | StatementKind::Rem
            | StatementKind::Message { .. }
            | StatementKind::Command { .. } => Shape::Plain,
        }
    }

    /// Returns the jump in it, or what names a THREAD.
    pub const fn jump(&self) -> Option<(JumpKind, &Jump)> {
        match self {
            StatementKind::Goto(jump)
            | StatementKind::If {
                then: Then::Goto(jump),
                ..
            } => Some((JumpKind::Goto, jump)),
            StatementKind::Gosub(jump)
            | StatementKind::If {
                then: Then::Gosub(jump),
                ..
            } => Some((JumpKind::Gosub, jump)),
            StatementKind::Call(jump) => Some((JumpKind::Call, jump)),
            StatementKind::StartThread(jump)
            | StatementKind::StopThread(jump)
            | StatementKind::WaitThread(jump) => Some((JumpKind::Thread, jump)),
            _ => None,
        }
    }

    /// Passes on each operand in it, in the order of the text.
    pub fn each_operand(&self, found: &mut dyn FnMut(&Operand)) {
        match self {
            StatementKind::Constant { value, .. } => found(value),
            StatementKind::Equation(equation) => {
                found(&equation.target);
                match &equation.value {
                    Expression::Operand(operand) => found(operand),
                    Expression::Binary { left, right, .. } => {
                        found(left);
                        found(right);
                    }
                    Expression::Function { operands, .. } => operands.iter().for_each(found),
                }
            }
            StatementKind::If { condition, .. }
            | StatementKind::ElseIf { condition, .. }
            | StatementKind::While { condition, .. }
            | StatementKind::Until { condition, .. } => {
                if let Condition::Compare { left, right, .. } = &**condition {
                    found(left);
                    found(right);
                }
            }
            StatementKind::For { counting, .. } => {
                let Counting {
                    variable,
                    from,
                    to,
                    step,
                } = &**counting;
                [variable, from, to].into_iter().chain(step).for_each(found);
            }
            StatementKind::Next { variable, .. } => variable.iter().for_each(found),
            StatementKind::Command { arguments, .. } => arguments.iter().for_each(found),
            StatementKind::Define { .. }
            | StatementKind::Label(_)
            | StatementKind::Else
            | StatementKind::EndIf
            | StatementKind::Wend
            | StatementKind::Repeat
            | StatementKind::Subroutine { .. }
            | StatementKind::SubEnd
            | StatementKind::Thread { .. }
            | StatementKind::ThreadEnd
            | StatementKind::StartThread(_)
            | StatementKind::StopThread(_)
            | StatementKind::WaitThread(_)
            | StatementKind::Call(_)
            | StatementKind::Goto(_)
            | StatementKind::Gosub(_)
            | StatementKind::Return
            | StatementKind::End
            | StatementKind::Exit
            | StatementKind::Rem
            | StatementKind::Message { .. }
            | StatementKind::FileMessage { .. }
            | StatementKind::Broken(_) => {}
        }
    }

    /// Returns the label that it defines, and its kind.
    pub const fn label(&self) -> Option<(&Word, LabelKind)> {
        match self {
            StatementKind::Label(name) => Some((name, LabelKind::Plain)),
            StatementKind::Subroutine { name, .. } => Some((name, LabelKind::Subroutine)),
            StatementKind::Thread { name, .. } => Some((name, LabelKind::Thread)),
            _ => None,
        }
    }

    /// Returns the location of its first word, if it is kept.
    pub const fn keyword(&self) -> Option<Span> {
        match self {
            StatementKind::If { keyword, .. }
            | StatementKind::ElseIf { keyword, .. }
            | StatementKind::While { keyword, .. }
            | StatementKind::Until { keyword, .. }
            | StatementKind::For { keyword, .. }
            | StatementKind::Next { keyword, .. }
            | StatementKind::Subroutine { keyword, .. }
            | StatementKind::Thread { keyword, .. }
            | StatementKind::Constant { keyword, .. }
            | StatementKind::Define { keyword, .. } => Some(*keyword),
            _ => None,
        }
    }

    /// Returns true if the statement after it may run next; false for a broken one, of which this is unknown.
    pub const fn goes_on(&self) -> bool {
        !matches!(
            self,
            StatementKind::Goto(_)
                | StatementKind::SubEnd
                | StatementKind::ThreadEnd
                | StatementKind::Return
                | StatementKind::End
                | StatementKind::Exit
                | StatementKind::Broken(_)
        )
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
