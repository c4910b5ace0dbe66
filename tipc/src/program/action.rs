//! Actions of steps.

use super::{
    Arithmetic, Condition, End, Op, Operand, Port, Scalar, ScalarExpression, StepId,
    StructExpression, Target, Teach, VariableId,
};

/// Action of a step. Next steps are resolved; where none is named it is the following one.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Nothing: a label, REM, ENDIF, REPEAT, SUBROUTINE or THREAD.
    Nothing,
    /// An equation whose left side is a scalar.
    SetScalar {
        /// The left side.
        target: Scalar,
        /// `x op= rhs`: how the right side meets the old value.
        update: Option<Arithmetic>,
        /// The right side.
        value: ScalarExpression,
    },
    /// An equation whose left side is a POS or JOINT.
    SetStruct {
        /// The left side.
        target: VariableId,
        /// `x op= rhs`: how the right side meets the old value, member by member.
        update: Option<Arithmetic>,
        /// The right side.
        value: StructExpression,
    },
    /// IF … THEN: false leads to `otherwise`, "not taken".
    If {
        /// The condition.
        condition: Condition,
        /// The matching ELSEIF, ELSE or ENDIF.
        otherwise: StepId,
    },
    /// ELSEIF: as IF when reached "not taken", else on to `otherwise`, "taken".
    ElseIf {
        /// The condition.
        condition: Condition,
        /// The next ELSEIF, ELSE or ENDIF.
        otherwise: StepId,
    },
    /// ELSE: "not taken" falls through, "taken" leads to `end`.
    Else {
        /// The ENDIF.
        end: StepId,
    },
    /// WHILE: false leads to `exit`.
    While {
        /// The condition.
        condition: Condition,
        /// The step after WEND.
        exit: StepId,
    },
    /// WEND and GOTO: on to `to`.
    Goto {
        /// The step to run next.
        to: StepId,
    },
    /// UNTIL: false leads back.
    Until {
        /// The condition.
        condition: Condition,
        /// The REPEAT.
        back: StepId,
    },
    /// FOR.
    For {
        /// The loop variable.
        variable: Scalar,
        /// Its initial value.
        from: Operand,
        /// Its last value.
        to: Operand,
        /// The increment; 1 if omitted.
        step: Operand,
        /// The step after NEXT.
        exit: StepId,
    },
    /// NEXT; limit and increment are FOR's, read again.
    Next {
        /// The loop variable.
        variable: Scalar,
        /// Its last value.
        to: Operand,
        /// The increment.
        step: Operand,
        /// The step after FOR.
        body: StepId,
    },
    /// IF … GOTO.
    IfGoto {
        /// The condition.
        condition: Condition,
        /// Next step if true.
        to: StepId,
    },
    /// GOSUB and CALL.
    Gosub {
        /// The label or SUBROUTINE.
        to: StepId,
    },
    /// IF … GOSUB.
    IfGosub {
        /// The condition.
        condition: Condition,
        /// Next step if true.
        to: StepId,
    },
    /// RETURN and SUBEND.
    Return,
    /// END and EXIT.
    Finish(End),
    /// A command of the robot.
    Command {
        /// Which one.
        op: Op,
        /// `HS` follows its name.
        hs: bool,
        /// Its target.
        target: Target,
        /// Its operands; a struct is given as its members.
        arguments: Vec<Argument>,
    },
    /// A TEACH_ command that fills a struct.
    TeachStruct {
        /// Measured quantity.
        what: Teach,
        /// Measured part of the robot.
        target: Target,
        /// The POS or JOINT that receives it.
        into: VariableId,
    },
    /// A TEACH_ command that fills a scalar.
    TeachScalar {
        /// Measured quantity.
        what: Teach,
        /// Joint number.
        target: Target,
        /// The scalar that receives it.
        into: Scalar,
    },
    /// AD_IN.
    AdIn {
        /// The input.
        port: Port,
        /// The scalar that receives its volts.
        into: Scalar,
    },
    /// KEY_IN: waits for a key.
    KeyIn {
        /// The scalar that receives its code.
        into: Scalar,
    },
    /// START_THREAD.
    StartThread {
        /// The index among [`Program::threads`](super::Program::threads).
        thread: usize,
    },
    /// STOP_THREAD.
    StopThread {
        /// The index of the thread.
        thread: usize,
    },
    /// WAIT_THREAD.
    WaitThread {
        /// The index of the thread.
        thread: usize,
    },
    /// THREADEND: ends the thread that comes to it.
    ThreadEnd,
    /// F_MESSAGE; an empty text has no parts.
    FileMessage {
        /// Parts to write, in order.
        parts: Vec<MessagePart>,
    },
    /// MESSAGE; MESSAGE_CLEAR and an empty text have no parts.
    Message {
        /// Parts to show, in order.
        parts: Vec<MessagePart>,
    },
}

impl Action {
    /// Returns the condition that decides the next step.
    pub fn condition(&self) -> Option<&Condition> {
        match self {
            Action::If { condition, .. }
            | Action::ElseIf { condition, .. }
            | Action::While { condition, .. }
            | Action::Until { condition, .. }
            | Action::IfGoto { condition, .. }
            | Action::IfGosub { condition, .. } => Some(condition),
            _ => None,
        }
    }

    /// Returns true if it does more than decide what runs next.
    pub fn acts(&self) -> bool {
        match self {
            Action::SetScalar { .. }
            | Action::SetStruct { .. }
            | Action::Command { .. }
            | Action::TeachStruct { .. }
            | Action::TeachScalar { .. }
            | Action::AdIn { .. }
            | Action::KeyIn { .. }
            | Action::StartThread { .. }
            | Action::StopThread { .. }
            | Action::WaitThread { .. }
            | Action::FileMessage { .. }
            | Action::Message { .. } => true,
            Action::Nothing
            | Action::If { .. }
            | Action::ElseIf { .. }
            | Action::Else { .. }
            | Action::While { .. }
            | Action::Goto { .. }
            | Action::Until { .. }
            | Action::For { .. }
            | Action::Next { .. }
            | Action::IfGoto { .. }
            | Action::Gosub { .. }
            | Action::IfGosub { .. }
            | Action::Return
            | Action::ThreadEnd
            | Action::Finish(_) => false,
        }
    }

    /// Returns the step after an ELSEIF or ELSE that is reached "taken"; `None` for other steps, for which it makes no
    /// difference.
    pub fn passed_to(&self) -> Option<StepId> {
        match self {
            Action::ElseIf { otherwise: to, .. } | Action::Else { end: to } => Some(*to),
            _ => None,
        }
    }
}

/// An operand of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Argument {
    /// The number.
    pub operand: Operand,
    /// Flag before it.
    pub mark: Mark,
}

/// Flag before an operand of a motion, where it matters.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Nothing; or `A` where a number without a mark is absolute.
    None,
    /// `R`
    Relative,
    /// `A` where a number without a mark counts from the target.
    Absolute,
}

/// A piece of a MESSAGE or F_MESSAGE.
#[derive(Clone, Debug, PartialEq)]
pub enum MessagePart {
    /// Text, with `\a` and `\t` already characters.
    Text(String),
    /// A value.
    Value {
        /// Which one; without sign.
        operand: Operand,
        /// Digits after the point, 0…7; 0 truncates.
        decimals: u8,
    },
}
