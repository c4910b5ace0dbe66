//! The C that one would write by hand: a struct of numbers, the state as a number, a `switch`, and a
//! robot that is asked through a function pointer. `motion.h` beside it has the robot's side.

use crate::code;
use crate::flat::{self, Then};
use crate::infix::{Infix, variables};
use std::fmt::Write;
use tipc::program::{Program, VariableKind};

/// A file that defines `step_NAME` and `size_of_NAME`.
pub fn spell(program: &Program, name: &str) -> String {
    let infix = Infix {
        program,
        scalar: |name| format!("m->{name}"),
        member: |name, member| format!("m->{name}[{member}]"),
        not_equal: "!=",
    };
    let mut cases = String::new();
    for (at, step) in flat::steps(&infix).iter().enumerate() {
        let mut lines = String::new();
        for (n, set) in step.sets.iter().enumerate() {
            write!(lines, "double v{n} = {}; ", set.value).expect("a string");
            if set.is_calculated {
                write!(lines, "if (!isfinite(v{n})) return FAULT; ").expect("a string");
            }
        }
        for (n, set) in step.sets.iter().enumerate() {
            write!(lines, "{} = v{n}; ", set.place).expect("a string");
        }
        if let Some(ask) = &step.ask {
            let (op, target) = (code::of_op(ask.op), code::of_target(ask.target));
            let count = ask.values.len();
            let values: String = ask
                .values
                .iter()
                .map(|value| format!("{{{value}, false}}, "))
                .collect();
            let values = match count {
                0 => "NULL".to_owned(),
                _ => format!("(const struct value[]){{ {values}}}"),
            };
            write!(
                lines,
                "int flow = ask(r, {op}, {target}, {values}, {count}); if (flow != NEXT) return flow; "
            )
            .expect("a string");
        }
        let then = match &step.then {
            Then::To(to) => format!("m->at = {to}; return NEXT;"),
            Then::If(condition, yes, no) => {
                format!("m->at = {condition} ? {yes} : {no}; return NEXT;")
            }
            Then::Call { to, back } => format!("m->back = {back}; m->at = {to}; return NEXT;"),
            Then::Return => "m->at = m->back; return NEXT;".to_owned(),
            Then::Finish => "return FINISHED;".to_owned(),
        };
        writeln!(cases, "case {at}: {{ {lines}{then} }}").expect("a string");
    }
    let fields: String = variables(program)
        .map(|variable| {
            let name = variable.name.to_lowercase();
            match variable.kind {
                VariableKind::Var => format!("double {name}; "),
                VariableKind::Pos | VariableKind::Joint => format!("double {name}[3]; "),
            }
        })
        .collect();
    format!(
        "#include \"motion.h\"
struct motion {{ uint32_t at; uint32_t back; {fields}}};
const size_t size_of_{name} = sizeof(struct motion);
int step_{name}(struct motion *m, struct robot *r) {{
  switch (m->at) {{
{cases}  default: return FAULT;
  }}
}}
"
    )
}
