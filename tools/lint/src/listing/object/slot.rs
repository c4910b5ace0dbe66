//! One argument of a step, and the names of TIP.OBJ.

use std::borrow::Cow;
use tip_runtime::command::{Port, Target};
use tipc::language::reserved::POSITION;
use tipc::program::{Argument, Mark, Operand, Program, Scalar, VariableId, VariableKind};

/// The type and the value of an argument.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Slot {
    pub(super) kind: Cow<'static, str>,
    pub(super) value: f64,
}

impl Slot {
    /// No argument.
    pub(super) const NONE: Slot = Slot {
        kind: Cow::Borrowed("ARG_NONE"),
        value: 0.0,
    };

    pub(super) fn new(kind: impl Into<Cow<'static, str>>, value: f64) -> Self {
        Slot {
            kind: kind.into(),
            value,
        }
    }

    pub(super) fn constant(value: f64) -> Self {
        Slot::new("CONSTANT", value)
    }

    /// The same after a mark, of which `R` alone shows.
    pub(super) fn marked(self, mark: Mark) -> Self {
        match mark {
            Mark::None | Mark::Absolute => self,
            Mark::Relative => Slot::new(format!("REL_{}", self.kind), self.value),
        }
    }
}

/// The place of each variable among those of its type.
pub(super) struct Variables<'a> {
    program: &'a Program,
    places: Vec<u32>,
}

impl<'a> Variables<'a> {
    pub(super) fn new(program: &'a Program) -> Self {
        let mut counts = [0; 3];
        let places = program.variables().iter().map(|variable| {
            let count = &mut counts[variable.kind as usize];
            let place = *count;
            *count += 1;
            place
        });
        Variables {
            places: places.collect(),
            program,
        }
    }

    /// A struct as a whole; of a VAR, the VAR.
    pub(super) fn whole(&self, variable: VariableId) -> Slot {
        let kind = match self.program.variables()[variable].kind {
            VariableKind::Var => "VAR",
            VariableKind::Pos => "POS",
            VariableKind::Joint => "JNT",
        };
        Slot::new(kind, f64::from(self.places[variable]))
    }

    /// A VAR or member, perhaps with a minus before it.
    pub(super) fn scalar(&self, scalar: Scalar, negative: bool) -> Slot {
        let Slot { kind, value } = self.whole(scalar.variable);
        let sign = if negative { "MINUS_" } else { "" };
        let member = match self.program.variables()[scalar.variable].kind {
            VariableKind::Var => String::new(),
            VariableKind::Pos => format!("_{}", POSITION[scalar.member]),
            VariableKind::Joint => format!("_{}", scalar.member + 1),
        };
        Slot::new(format!("{sign}{kind}{member}"), value)
    }

    pub(super) fn operand(&self, operand: Operand) -> Slot {
        match operand {
            Operand::Constant(value) => Slot::constant(value),
            Operand::Scalar { scalar, negative } => self.scalar(scalar, negative),
        }
    }

    /// The struct that was written as `word` in the place of these arguments.
    pub(super) fn written_whole(&self, arguments: &[Argument], word: &str) -> Option<Slot> {
        let first = arguments.first()?;
        let Operand::Scalar { scalar, .. } = first.operand else {
            return None;
        };
        let variable = &self.program.variables()[scalar.variable];
        let is_struct = variable.kind != VariableKind::Var && variable.name == word;
        is_struct.then(|| self.whole(scalar.variable).marked(first.mark))
    }
}

/// A target's name; `NO_TARGET` for none.
pub(super) fn target_name(target: Target) -> String {
    match target {
        Target::None => "NO_TARGET".to_owned(),
        target => format!("TARGET_{target}"),
    }
}

/// An input's name.
pub(super) fn port_name(port: Port) -> String {
    match port {
        Port::Channel(_) => target_name(Target::None),
        port => format!("TARGET_{port}"),
    }
}
