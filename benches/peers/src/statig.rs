//! A machine of the crate `statig`, spelt without its macros: an enum of states, a handler for each, and
//! the event of a control cycle.

use crate::flat::{self, Then};
use crate::infix::Infix;
use crate::rust::{ask, fields, sets};
use std::fmt::Write;
use tipc::program::Program;

/// The items of a type `Machine` and of its states.
pub fn spell(program: &Program) -> String {
    let infix = Infix::of_rust(program);
    let mut states = String::new();
    let mut calls = String::new();
    let mut handlers = String::new();
    for (at, step) in flat::steps(&infix).iter().enumerate() {
        let to = |step: &u32| format!("Transition(State::S{step})");
        let mut lines = sets(&step.sets);
        if let Some(command) = &step.ask {
            let ask = ask(command).replace("ask(cx", "ask(context.robot");
            write!(
                lines,
                "if {ask}? == Poll::Pending {{ return Ok(Handled); }}"
            )
            .expect("a string");
        }
        let then = match &step.then {
            Then::To(step) => to(step),
            Then::If(condition, yes, no) => {
                format!("if {condition} {{ {} }} else {{ {} }}", to(yes), to(no))
            }
            Then::Call { to: step, back } => {
                write!(lines, "self.back = State::S{back};").expect("a string");
                to(step)
            }
            Then::Return => "Transition(self.back)".to_owned(),
            Then::Finish => "Handled".to_owned(),
        };
        write!(states, "S{at}, ").expect("a string");
        writeln!(calls, "State::S{at} => machine.s{at}(context),").expect("a string");
        writeln!(
            handlers,
            "fn s{at}(&mut self, context: &mut Cycle<'_>) -> Result<Outcome<State>, Fault> {{ {lines} Ok({then}) }}"
        )
        .expect("a string");
    }
    let fields = fields(program);
    format!(
        "#[derive(Clone, Copy, Default)]
pub(crate) enum State {{ #[default] {states} }}
#[derive(Default)]
pub(crate) struct Machine {{ back: State, {fields} }}
impl blocking::IntoStateMachine for Machine {{
    type Event<'event> = ();
    type Context<'context> = Cycle<'context>;
    type State = State;
    type Superstate<'sub> = ();
    fn initial() -> State {{ State::S0 }}
}}
impl blocking::State<Machine> for State {{
    fn call_handler(&mut self, machine: &mut Machine, _: &(), context: &mut Cycle<'_>) -> Outcome<State> {{
        let outcome = match self {{
            {calls}
        }};
        outcome.unwrap_or_else(|fault| {{
            context.fault = Some(fault);
            Handled
        }})
    }}
}}
impl Machine {{
{handlers}
}}
"
    )
}
