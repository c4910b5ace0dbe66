//! A program, fully resolved: what every back end starts from. Only the lowering makes one.

pub use crate::syntax::{Arithmetic, Relation, VariableKind};
pub use tip_runtime::command::{Flag, Op, Port, Target, Teach};
pub use tip_runtime::program::{End, Signature};

/// The number of a step, from 0.
pub type StepId = u32;

/// A motion program.
#[derive(Clone, Debug, PartialEq)]
pub struct Program {
    pub(crate) source_name: String,
    pub(crate) source_hash: u64,
    pub(crate) title: String,
    pub(crate) signature: Signature,
    pub(crate) variables: Vec<Variable>,
    pub(crate) labels: Vec<Label>,
    pub(crate) steps: Vec<Step>,
}

impl Program {
    /// The source's name as the user gave it, without folders.
    pub fn source_name(&self) -> &str {
        &self.source_name
    }

    /// FNV-1a 64 of the source's bytes.
    pub fn source_hash(&self) -> u64 {
        self.source_hash
    }

    /// Line 2 of the source.
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The robot it was checked for.
    pub fn signature(&self) -> Signature {
        self.signature
    }

    /// The variables, `VAR_KEY` first, then in order of declaration.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The labels in order of their steps.
    pub fn labels(&self) -> &[Label] {
        &self.labels
    }

    /// The steps. The last one is the END that closes the source.
    pub fn steps(&self) -> &[Step] {
        &self.steps
    }

    /// The number of scalars that the variables hold.
    pub fn scalar_count(&self) -> usize {
        self.variables.iter().map(Variable::size).sum()
    }

    /// Name of every scalar (`A`, `P.X`, `Q.J2`) in declaration order.
    pub fn scalar_names(&self) -> impl Iterator<Item = String> {
        self.variables.iter().flat_map(Variable::scalar_names)
    }

    /// The place of a scalar among all scalars.
    pub fn scalar_index(&self, scalar: Scalar) -> usize {
        self.variables[scalar.variable].first + scalar.member
    }
}

/// A variable.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Variable {
    /// Its name, upper case.
    pub name: String,
    /// Its type.
    pub kind: VariableKind,
    /// The place of its first scalar among all scalars.
    pub first: usize,
    /// How many members a JOINT has on this robot.
    pub joints: usize,
}

impl Variable {
    /// How many scalars it holds.
    pub fn size(&self) -> usize {
        match self.kind {
            VariableKind::Var => 1,
            VariableKind::Pos => 3,
            VariableKind::Joint => self.joints,
        }
    }

    /// The names of its scalars.
    pub fn scalar_names(&self) -> impl Iterator<Item = String> {
        (0..self.size()).map(|member| match self.kind {
            VariableKind::Var => self.name.clone(),
            VariableKind::Pos => format!("{}.{}", self.name, ["X", "Y", "Z"][member]),
            VariableKind::Joint => format!("{}.J{}", self.name, member + 1),
        })
    }
}

/// A label or SUBROUTINE.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Label {
    /// Its name without colon.
    pub name: String,
    /// The step it stands for.
    pub step: StepId,
    /// Declared by SUBROUTINE.
    pub subroutine: bool,
}

/// One step.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// What it does.
    pub action: Action,
    /// Its source line, from 1.
    pub line: u32,
    /// Its column on that line in characters, from 1.
    pub column: u32,
    /// The statement as written, blanks trimmed.
    pub text: String,
    /// The statement's line of FORMAL.TMP: fields separated by tabs.
    pub formal: String,
}

/// A variable, by its place in [`Program::variables`].
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
        /// Which scalar.
        scalar: Scalar,
        /// `-` stands before it.
        negative: bool,
    },
}

/// What a step does. Next steps are resolved; where none is named it is the one behind.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// Nothing: a label, REM, ENDIF, REPEAT or SUBROUTINE.
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
        /// The step behind WEND.
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
        /// The step behind NEXT.
        exit: StepId,
    },
    /// NEXT; limit and increment are FOR's, read anew.
    Next {
        /// The loop variable.
        variable: Scalar,
        /// Its last value.
        to: Operand,
        /// The increment.
        step: Operand,
        /// The step behind FOR.
        body: StepId,
    },
    /// IF … GOTO.
    IfGoto {
        /// The condition.
        condition: Condition,
        /// Where true leads.
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
        /// Where true leads.
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
        /// `HS` stands behind its name.
        hs: bool,
        /// Its target.
        target: Target,
        /// Its operands; a struct stands as its members.
        arguments: Vec<Argument>,
    },
    /// A TEACH_ command that fills a struct.
    TeachStruct {
        /// What is measured.
        what: Teach,
        /// Where on the robot.
        target: Target,
        /// The POS or JOINT that receives it.
        into: VariableId,
    },
    /// A TEACH_ command that fills a scalar.
    TeachScalar {
        /// What is measured.
        what: Teach,
        /// Which joint.
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
    /// MESSAGE; MESSAGE_CLEAR and an empty text have no parts.
    Message {
        /// What to show, in order.
        parts: Vec<MessagePart>,
    },
}

/// An operand of a command.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Argument {
    /// The number.
    pub operand: Operand,
    /// `R` stands before it.
    pub relative: bool,
}

/// A condition.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Condition {
    /// Two numbers compared.
    Compare {
        /// The left one.
        left: Operand,
        /// How.
        relation: Relation,
        /// The right one.
        right: Operand,
    },
    /// An event flag.
    Flag {
        /// Which one.
        flag: Flag,
        /// `!` stands before it.
        negated: bool,
    },
}

/// The right side of a scalar equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScalarExpression {
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
    /// A function of one scalar.
    Function {
        /// Which one.
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
    Norm(VariableId),
}

/// A function of one scalar.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Function {
    /// `INT`
    Int,
    /// `ABS`
    Abs,
    /// `SQRT`
    Sqrt,
    /// `SIN`
    Sin,
    /// `COS`
    Cos,
    /// `TAN`
    Tan,
    /// `ASIN`
    Asin,
    /// `ACOS`
    Acos,
    /// `ATAN`
    Atan,
    /// `DEG2RAD`
    Deg2Rad,
    /// `RAD2DEG`
    Rad2Deg,
}

/// The right side of a struct equation; all structs in it are of one type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum StructExpression {
    /// `a`
    Copy(VariableId),
    /// `a + b` and its like, member by member.
    Binary {
        /// The left operand.
        left: VariableId,
        /// The operation.
        operation: Arithmetic,
        /// The right operand.
        right: VariableId,
    },
    /// `UNIT_VECT p`
    UnitVect(VariableId),
    /// `ROT_X p angle` and its like.
    Rotate {
        /// The axis.
        axis: Axis,
        /// What is turned.
        operand: VariableId,
        /// By how many degrees.
        angle: Operand,
    },
}

/// An axis of the robot frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Axis {
    /// To the right.
    X,
    /// Forward.
    Y,
    /// Up.
    Z,
}

/// A piece of a MESSAGE.
#[derive(Clone, Debug, PartialEq)]
pub enum MessagePart {
    /// Text, with `\a` and `\t` already characters.
    Text(String),
    /// The value of a VAR.
    Value {
        /// Which one.
        scalar: Scalar,
        /// Digits behind the point, 0…7; 0 truncates.
        decimals: u8,
    },
}
