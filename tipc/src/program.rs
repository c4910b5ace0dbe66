//! A program, fully resolved: what every back end starts from. Only `load` makes one.

pub use crate::language::functions::Axis;
pub use crate::syntax::{Arithmetic, LabelKind, Relation, StepId, VariableKind};
pub use tip_runtime::command::{Flag, Op, Port, Reading, Target, Teach};
pub use tip_runtime::function::Function;
pub use tip_runtime::program::{End, Signature};

use crate::language::Edition;
use crate::language::reserved::{JOINT, POSITION};
use smol_str::SmolStr;

mod action;
mod operand;

pub use action::{Action, Argument, Mark, MessagePart};
pub use operand::{
    Condition, Operand, Scalar, ScalarExpression, StructExpression, StructOperand, VariableId,
};

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
