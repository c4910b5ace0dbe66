//! The kinds of statements, and what each of them is to the passes: an opener, a jump, a label.

use super::{Condition, Counting, Equation, Expression, Operand, Spanned, VariableKind, Word};
use crate::diagnostic::Diagnostic;
use crate::language::Keyword;
use crate::source::Span;

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
        /// The name.
        name: Word,
    },
    /// `SUBEND`
    SubEnd,
    /// `THREAD NAME:`; the name without its colon.
    Thread {
        /// The command word.
        keyword: Span,
        /// The name.
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

/// Role of a statement among the blocks; of a broken one, the intended role, so that one mistake does not unbalance
/// the blocks around it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shape {
    /// Neither opens nor closes anything.
    Plain,
    /// `IF … THEN`
    If,
    /// `IF … THEN` with a statement after it: a mistake that may or may not have its ENDIF.
    OneLineIf,
    /// `ELSEIF`
    ElseIf,
    /// `ELSE`
    Else,
    /// `ENDIF`
    EndIf,
    /// `WHILE`
    While,
    /// `WEND`
    Wend,
    /// `REPEAT`
    Repeat,
    /// `UNTIL`
    Until,
    /// `FOR`
    For,
    /// `NEXT`
    Next,
    /// `}` of another language: a mistake that closes whatever is open.
    Close,
    /// `SUBROUTINE`
    Subroutine,
    /// `SUBEND`
    SubEnd,
    /// `THREAD`
    Thread,
    /// `THREADEND`
    ThreadEnd,
}

impl Shape {
    /// Returns the word of such a statement; `None` for one that neither opens nor closes a block, or should not be.
    pub const fn keyword(self) -> Option<Keyword> {
        Some(match self {
            Shape::If => Keyword::If,
            Shape::ElseIf => Keyword::ElseIf,
            Shape::Else => Keyword::Else,
            Shape::EndIf => Keyword::EndIf,
            Shape::While => Keyword::While,
            Shape::Wend => Keyword::Wend,
            Shape::Repeat => Keyword::Repeat,
            Shape::Until => Keyword::Until,
            Shape::For => Keyword::For,
            Shape::Next => Keyword::Next,
            Shape::Subroutine => Keyword::Subroutine,
            Shape::SubEnd => Keyword::SubEnd,
            Shape::Thread => Keyword::Thread,
            Shape::ThreadEnd => Keyword::ThreadEnd,
            Shape::Plain | Shape::OneLineIf | Shape::Close => return None,
        })
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
