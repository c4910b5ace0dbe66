//! A module whose statements are all resolved: what their words stand for, and which of them belong together.

use super::labels::DeclaredLabel;
use super::names::NamedConstant;
use crate::program::{
    Argument, Arithmetic, Condition, Mark, MessagePart, Op, Operand, Port, Scalar,
    ScalarExpression, StructExpression, StructOperand, Target, Teach, Variable, VariableId,
};

/// The statements of a module, its variables and labels.
#[derive(Debug)]
pub(crate) struct ResolvedModule<'m> {
    /// The variables, `VAR_KEY` first.
    pub(crate) variables: Vec<Variable>,
    /// The constants that DEFINE names.
    pub(crate) constants: Vec<NamedConstant>,
    /// The labels and SUBROUTINEs.
    pub(crate) labels: Vec<DeclaredLabel<'m>>,
    /// Meaning of each statement of the module.
    pub(crate) statements: Vec<Resolved>,
}

/// A statement of a module, by its index.
pub(crate) type StatementId = usize;

/// Meaning of a statement. The lowering decides what it does.
#[derive(Debug)]
pub(crate) enum Resolved {
    /// DEF_VAR, DEF_POS, DEF_JOINT, DEFINE.
    Define,
    /// A label.
    Label,
    /// An equation.
    Equation(Assignment),
    /// IF … THEN, and its next ELSEIF, ELSE or ENDIF.
    If(Condition, StatementId),
    /// ELSEIF, and the next ELSEIF, ELSE or ENDIF.
    ElseIf(Condition, StatementId),
    /// ELSE, and its ENDIF.
    Else(StatementId),
    /// ENDIF.
    EndIf,
    /// WHILE, and its WEND.
    While(Condition, StatementId),
    /// WEND, and its WHILE.
    Wend(StatementId),
    /// REPEAT.
    Repeat,
    /// UNTIL, and its REPEAT.
    Until(Condition, StatementId),
    /// FOR, and its NEXT.
    For(Counting, StatementId),
    /// NEXT: what its FOR counts, and the FOR.
    Next(Counting, StatementId),
    /// IF … GOTO, and where it leads.
    IfGoto(Condition, StatementId),
    /// IF … GOSUB, and where it leads.
    IfGosub(Condition, StatementId),
    /// SUBROUTINE.
    Subroutine,
    /// SUBEND.
    SubEnd,
    /// THREAD.
    Thread,
    /// THREADEND.
    ThreadEnd,
    /// START_THREAD, and its THREAD.
    StartThread(StatementId),
    /// STOP_THREAD, and its THREAD.
    StopThread(StatementId),
    /// WAIT_THREAD, and its THREAD.
    WaitThread(StatementId),
    /// CALL, and where it leads.
    Call(StatementId),
    /// GOTO, and where it leads.
    Goto(StatementId),
    /// GOSUB, and where it leads.
    Gosub(StatementId),
    /// RETURN.
    Return,
    /// END.
    End,
    /// EXIT.
    Exit,
    /// REM.
    Rem,
    /// MESSAGE.
    Message(Vec<MessagePart>),
    /// F_MESSAGE.
    FileMessage(Vec<MessagePart>),
    /// MESSAGE_CLEAR.
    MessageClear,
    /// A command of the robot.
    Command {
        /// Which one.
        op: Op,
        /// True if `HS` follows its name.
        hs: bool,
        /// Its target.
        target: Target,
        /// Its arguments after the target.
        arguments: Arguments,
    },
    /// SPECIAL: the number of the native command, and its values.
    Special(f64, Vec<Operand>),
    /// A TEACH_ command: what is measured, where, and what receives it.
    Teach(Teach, Target, Receiver),
    /// AD_IN: the input, and what receives its volts.
    AdIn(Port, Scalar),
    /// KEY_IN, and what receives the key.
    KeyIn(Scalar),
}

/// An equation.
#[derive(Debug)]
pub(crate) enum Assignment {
    /// Its left side is a scalar.
    Scalar {
        target: Scalar,
        update: Option<Arithmetic>,
        value: ScalarExpression,
    },
    /// Its left side is a POS or JOINT.
    Struct {
        target: VariableId,
        update: Option<Arithmetic>,
        value: StructExpression,
    },
}

/// Counting of a FOR.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Counting {
    /// The loop variable.
    pub(crate) variable: Scalar,
    /// Its initial value.
    pub(crate) from: Operand,
    /// Its last value.
    pub(crate) to: Operand,
    /// The increment, if it is named.
    pub(crate) step: Option<Operand>,
}

/// The arguments of a command after its target.
#[derive(Debug)]
pub(crate) enum Arguments {
    /// The members of two JOINTs.
    Two([StructOperand; 2]),
    /// One by one.
    Each(Vec<Argument>),
    /// The members of a POS or JOINT.
    Whole {
        /// The variable.
        operand: StructOperand,
        /// Flag before it.
        mark: Mark,
    },
}

/// Destination that a command fills.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Receiver {
    /// A VAR or a member.
    Scalar(Scalar),
    /// A POS or JOINT.
    Struct(VariableId),
}
