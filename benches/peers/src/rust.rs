//! The Rust that one would write by hand for a long motion: a struct of numbers, the state as a number,
//! one arm for each, and a helper that asks for a command.

use crate::flat::{self, Ask, Then};
use crate::infix::{Infix, Set, variables};
use std::fmt::Write;
use tipc::program::{Program, VariableKind};

/// The items of a type `ByHand`.
pub fn spell(program: &Program) -> String {
    let infix = Infix::of_rust(program);
    let mut arms = String::new();
    for (at, step) in flat::steps(&infix).iter().enumerate() {
        let mut lines = sets(&step.sets);
        if let Some(command) = &step.ask {
            let ask = ask(command);
            write!(
                lines,
                "if {ask}? == Poll::Pending {{ return Ok(Flow::Wait); }}"
            )
            .expect("a string");
        }
        let then = match &step.then {
            Then::To(to) => format!("self.at = {to};"),
            Then::If(condition, yes, no) => {
                format!("self.at = if {condition} {{ {yes} }} else {{ {no} }};")
            }
            Then::Call { to, back } => format!("self.back = {back}; self.at = {to};"),
            Then::Return => "self.at = self.back;".to_owned(),
            Then::Finish => "return Ok(Flow::Finished(End::End));".to_owned(),
        };
        writeln!(arms, "{at} => {{ {lines} {then} }}").expect("a string");
    }
    let fields = fields(program);
    format!(
        "#[derive(Default)]
pub(crate) struct ByHand {{ at: u32, back: u32, {fields} }}
impl ByHand {{
    #[inline]
    pub(crate) fn step(&mut self, cx: &mut dyn Context) -> Result<Flow, Fault> {{
        match self.at {{
            {arms}
            _ => return Err(Fault::WrongStep),
        }}
        Ok(Flow::Next)
    }}
}}
"
    )
}

/// The numbers of a struct.
pub(crate) fn fields(program: &Program) -> String {
    variables(program)
        .map(|variable| {
            let kind = match variable.kind {
                VariableKind::Var => "f64",
                VariableKind::Pos | VariableKind::Joint => "[f64; 3]",
            };
            format!("{}: {kind}, ", variable.name.to_lowercase())
        })
        .collect()
}

/// A command, asked for by the helper `ask` that every file of these has.
pub(crate) fn ask(ask: &Ask) -> String {
    let (op, target) = (ask.op, ask.target);
    let values = ask.values.join(", ");
    format!("ask(cx, Op::{op:?}, Target::{target:?}, [{values}])")
}

/// Assignments. Nothing is assigned before everything is known to be finite.
pub(crate) fn sets(sets: &[Set]) -> String {
    let value = |set: &Set| match set.is_calculated {
        true => format!("finite({})?", set.value),
        false => set.value.clone(),
    };
    match sets {
        [] => String::new(),
        [set] => format!("{} = {};", set.place, value(set)),
        sets => {
            let values: Vec<_> = sets.iter().map(value).collect();
            let places: Vec<_> = sets.iter().map(|set| set.place.clone()).collect();
            format!("[{}] = [{}];", places.join(", "), values.join(", "))
        }
    }
}
