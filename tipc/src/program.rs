//! A fully resolved program, the input of every back end. Only `load` makes one.

pub use crate::language::functions::Axis;
pub use crate::syntax::{Arithmetic, LabelKind, Relation, StepId, VariableKind};
pub use tip_runtime::command::{Flag, Op, Port, Reading, Target, Teach};
pub use tip_runtime::function::Function;
pub use tip_runtime::program::{End, Signature};

use crate::language::Edition;
use crate::language::reserved::{JOINT, POSITION};
use smol_str::SmolStr;

/// A motion program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    pub(crate) source_name: String,
    pub(crate) source_hash: u64,
    pub(crate) edition: Edition,
    pub(crate) title: String,
    pub(crate) signature: Signature,
    pub(crate) variables: Vec<Variable>,
    pub(crate) constants: Vec<(SmolStr, f64)>,
    pub(crate) labels: Vec<Label>,
    pub(crate) threads: Vec<Thread>,
    pub(crate) steps: Vec<Step>,
}

impl Program {
    /// Returns the source's name as the user gave it, without folders.
    pub fn source_name(&self) -> &str {
        &self.source_name
    }

    /// Returns FNV-1a 64 of the source's bytes.
    pub fn source_hash(&self) -> u64 {
        self.source_hash
    }

    /// Returns the edition of the language, which line 1 chose.
    pub fn edition(&self) -> Edition {
        self.edition
    }

    /// Returns line 2 of the source.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Returns the robot it was checked for.
    pub fn signature(&self) -> Signature {
        self.signature
    }

    /// Returns the variables: `VAR_KEY`, those of the variables shared with native code that the program names, and the
    /// others in order of declaration.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// Returns the constants that DEFINE names, with their values, in order of definition.
    pub fn constants(&self) -> &[(SmolStr, f64)] {
        &self.constants
    }

    /// Returns the labels in order of their steps.
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    /// Returns the threads in the order of the text.
    pub fn threads(&self) -> &[Thread] {
        &self.threads
    }

    /// Returns the steps. The last one is the END that closes the source.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// Returns the number of scalars that the variables hold.
    pub fn scalar_count(&self) -> usize {
        self.variables.iter().map(Variable::size).sum()
    }

    /// Returns the name of every scalar (`A`, `P.X`, `Q.J2`) in declaration order.
    pub fn scalar_names(&self) -> impl Iterator<Item = String> {
        self.variables.iter().flat_map(Variable::scalar_names)
    }

    /// Returns the index of a scalar among all scalars.
    pub fn scalar_index(&self, scalar: Scalar) -> usize {
        self.variables[scalar.variable].first + scalar.member
    }

    /// Returns the variable that holds the scalar at an index among all scalars.
    pub fn variable_of(&self, scalar: usize) -> VariableId {
        let holds_it_or_earlier = |variable: &Variable| variable.first <= scalar;
        self.variables.partition_point(holds_it_or_earlier) - 1
    }
}

/// A variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Its name, upper case.
    pub name: String,
    /// Its type.
    pub kind: VariableKind,
    /// The index of its first scalar among all scalars.
    pub first: usize,
    /// Number of members of a JOINT on this robot.
    pub joints: usize,
    /// Number of a variable shared with native code (`VAR_SPECIAL_n`): it is 0 at the start, and never unassigned.
    pub special: Option<u8>,
}

impl Variable {
    /// Returns the number of scalars it holds.
    pub fn size(&self) -> usize {
        match self.kind {
            VariableKind::Var => 1,
            VariableKind::Pos => 3,
            VariableKind::Joint => self.joints,
        }
    }

    /// Returns the names of its scalars.
    pub fn scalar_names(&self) -> impl Iterator<Item = String> {
        (0..self.size()).map(|member| match self.kind {
            VariableKind::Var => self.name.clone(),
            VariableKind::Pos => format!("{}.{}", self.name, POSITION[member]),
            VariableKind::Joint => format!("{}.{JOINT}{}", self.name, member + 1),
        })
    }
}

/// A label, SUBROUTINE or THREAD.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Its name without colon.
    pub name: String,
    /// The step it stands for.
    pub step: StepId,
    /// Kind of its declaration.
    pub kind: LabelKind,
}

/// A thread: the steps from THREAD to THREADEND.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Thread {
    /// Its name without colon.
    pub name: String,
    /// The step of THREAD.
    pub first: StepId,
    /// The step of THREADEND.
    pub last: StepId,
}

/// One step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// Action of the step.
    pub action: Action,
    /// Its source line, from 1.
    pub line: u32,
    /// Its column on that line in characters, from 1.
    pub column: u32,
    /// The statement as written, blanks trimmed.
    pub text: SmolStr,
}

/// A variable, by its index in [`Program::variables`](Program::variables).
pub type VariableId = usize;

/// One scalar: a VAR, or a member of a struct.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Scalar {
    /// The variable.
    pub variable: VariableId,
    /// The member, from 0; 0 for a VAR.
    pub member: usize,
}

/// A number that a step reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Operand {
    /// A constant.
    Constant(f64),
    /// A scalar, its sign changed if `negative`.
    Scalar {
        /// The scalar.
        scalar: Scalar,
        /// `-` precedes it.
        negative: bool,
    },
    /// A special variable, or a member of one, its sign changed if `negative`.
    Reading {
        /// The special variable.
        reading: Reading,
        /// The member, from 0; 0 for a number.
        member: usize,
        /// `-` precedes it.
        negative: bool,
    },
}

/// A whole POS or JOINT that a step reads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StructOperand {
    /// A variable.
    Variable(VariableId),
    /// A special variable.
    Reading(Reading),
}

impl StructOperand {
    /// Returns one of its members as an operand.
    pub const fn member(self, member: usize) -> Operand {
        match self {
            StructOperand::Variable(variable) => Operand::Scalar {
                scalar: Scalar { variable, member },
                negative: false,
            },
            StructOperand::Reading(reading) => Operand::Reading {
                reading,
                member,
                negative: false,
            },
        }
    }
}

/// A condition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Two numbers compared.
    Compare {
        /// The left one.
        left: Operand,
        /// Relation between the sides.
        relation: Relation,
        /// The right one.
        right: Operand,
    },
    /// An event flag.
    Flag {
        /// The flag that is read.
        flag: Flag,
        /// `!` precedes it.
        negated: bool,
    },
}

/// The right side of a scalar equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScalarExpression {
    /// `a`
    Operand(Operand),
    /// An operator and two scalars: `a + b`.
    Binary {
        /// The left operand.
        left: Operand,
        /// The operation.
        operation: Arithmetic,
        /// The right operand.
        right: Operand,
    },
    /// A function of one scalar.
    Function {
        /// The function that is evaluated.
        function: Function,
        /// Its operand.
        operand: Operand,
    },
    /// `ATAN2 a b`
    Atan2 {
        /// The first operand.
        y: Operand,
        /// The second one.
        x: Operand,
    },
    /// `NORM s`
    Norm(StructOperand),
}

/// The right side of a struct equation; all structs in it are of one type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StructExpression {
    /// `a`
    Copy(StructOperand),
    /// An operator and two structures, member by member: `a + b`.
    Binary {
        /// The left operand.
        left: StructOperand,
        /// The operation.
        operation: Arithmetic,
        /// The right operand.
        right: StructOperand,
    },
    /// `UNIT_VECT p`
    UnitVect(StructOperand),
    /// A rotation about an axis: `ROT_X p angle`.
    Rotate {
        /// The axis.
        axis: Axis,
        /// The POS that is rotated.
        operand: StructOperand,
        /// The angle, deg.
        angle: Operand,
    },
}

/// Action of a step. Jumps hold their target step; other actions go on with the following step.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Nothing: a label, REM, ENDIF, REPEAT, SUBROUTINE or THREAD.
    Nothing,
    /// An equation whose left side is a scalar.
    SetScalar {
        /// The left side.
        target: Scalar,
        /// The operation `op` of `x op= rhs`; `None` for `=`.
        update: Option<Arithmetic>,
        /// The right side.
        value: ScalarExpression,
    },
    /// An equation whose left side is a POS or JOINT.
    SetStruct {
        /// The left side.
        target: VariableId,
        /// The operation `op` of `x op= rhs`, member by member; `None` for `=`.
        update: Option<Arithmetic>,
        /// The right side.
        value: StructExpression,
    },
    /// IF … THEN: if false, the next step is `otherwise`, reached "not taken".
    If {
        /// The condition.
        condition: Condition,
        /// The matching ELSEIF, ELSE or ENDIF.
        otherwise: StepId,
    },
    /// ELSEIF: acts as IF when reached "not taken"; else the next step is `otherwise`, reached "taken".
    ElseIf {
        /// The condition.
        condition: Condition,
        /// The next ELSEIF, ELSE or ENDIF.
        otherwise: StepId,
    },
    /// ELSE: goes on with the following step when reached "not taken", else with `end`.
    Else {
        /// The ENDIF.
        end: StepId,
    },
    /// WHILE: if false, the next step is `exit`.
    While {
        /// The condition.
        condition: Condition,
        /// The step after WEND.
        exit: StepId,
    },
    /// WEND and GOTO.
    Goto {
        /// The step to run next.
        to: StepId,
    },
    /// UNTIL: if false, the next step is `back`.
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
    /// NEXT: reads limit and increment of its FOR again.
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
        /// The command that the controller carries out.
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
        /// The index among [`Program::threads`](Program::threads).
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

    /// Returns true if it has an effect besides the choice of the next step.
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
        /// The scalar that is printed, without sign.
        operand: Operand,
        /// Digits after the point, 0…7; 0 truncates.
        decimals: u8,
    },
}
