//! A Rhai script that the host runs in each cycle. Rhai cannot stop inside a script, so that its users
//! keep the state in the scope and `switch` on it; Rhai finds the case by its hash.

use crate::code;
use crate::flat::{self, Then};
use crate::infix::Infix;
use std::fmt::Write;
use tipc::program::Program;

/// The script, and the names of the numbers that the host puts into the scope.
pub fn spell(program: &Program) -> (String, Vec<String>) {
    let infix = Infix::of_script(program, "!=");
    let mut cases = String::new();
    for (at, step) in flat::steps(&infix).iter().enumerate() {
        let mut lines = String::new();
        for set in &step.sets {
            write!(lines, "{} = {}; ", set.place, set.value).expect("a string");
        }
        if let Some(ask) = &step.ask {
            let codes = [
                code::of_op(ask.op).to_string(),
                code::of_target(ask.target).to_string(),
            ];
            let values: Vec<_> = codes.iter().chain(&ask.values).cloned().collect();
            write!(lines, "ask({}); ", values.join(", ")).expect("a string");
        }
        let then = match &step.then {
            Then::To(to) => format!("at = {to};"),
            Then::If(condition, yes, no) => {
                format!("if {condition} {{ at = {yes}; }} else {{ at = {no}; }}")
            }
            Then::Call { to, back } => format!("back = {back}; at = {to};"),
            Then::Return => "at = back;".to_owned(),
            Then::Finish => "throw;".to_owned(),
        };
        writeln!(cases, "{at} => {{ {lines}{then} }},").expect("a string");
    }
    (format!("switch at {{\n{cases}}}\n"), infix.places())
}
