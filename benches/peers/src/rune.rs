//! A Rune generator: it yields once in each cycle, with the command if there is one. A generator cannot
//! yield from a function that it calls, so that subroutines stand where they are called.

use crate::code;
use crate::infix::Infix;
use crate::structure::{Blocks, Node, blocks};
use std::fmt::Write;
use tipc::program::{Action, Program};

/// A script whose `main` is the generator.
pub fn spell(program: &Program) -> String {
    let infix = Infix::of_script(program, "!=");
    let blocks = blocks(program);
    let mut text = String::from("pub fn main() {\n");
    for place in infix.places() {
        writeln!(text, "let {place} = 0.0;").expect("a string");
    }
    write_nodes(&mut text, &infix, &blocks, &blocks.main);
    text.push_str("}\n");
    text
}

fn write_nodes(text: &mut String, infix: &Infix<'_>, blocks: &Blocks<'_>, nodes: &[Node<'_>]) {
    for node in nodes {
        match node {
            Node::Step(action) => text.push_str(&step(infix, action)),
            Node::Endless(inner) => {
                text.push_str("loop {\nyield ();\n");
                write_nodes(text, infix, blocks, inner);
                text.push_str("yield ();\n}\n");
            }
            Node::If(condition, inner) => {
                writeln!(text, "if {} {{\nyield ();", infix.condition(*condition))
                    .expect("a string");
                write_nodes(text, infix, blocks, inner);
                text.push_str("} else {\nyield ();\n}\nyield ();\n");
            }
            Node::For(variable, from, to, inner) => {
                let (from, to) = (infix.operand(*from), infix.operand(*to));
                let name = infix.place(*variable);
                writeln!(text, "{name} = {from};\nyield ();\nwhile {name} <= {to} {{")
                    .expect("a string");
                write_nodes(text, infix, blocks, inner);
                writeln!(text, "{name} += 1.0;\nyield ();\n}}").expect("a string");
            }
            Node::Call(to) => {
                text.push_str("yield ();\n");
                write_nodes(text, infix, blocks, &blocks.subroutines[to]);
            }
        }
    }
}

fn step(infix: &Infix<'_>, action: &Action) -> String {
    if let Some(sets) = infix.sets(action) {
        let each = sets
            .iter()
            .map(|set| format!("{} = {};\n", set.place, set.value));
        return each.chain(["yield ();\n".to_owned()]).collect();
    }
    match action {
        Action::Nothing | Action::Return => "yield ();\n".to_owned(),
        Action::Command {
            op,
            target,
            arguments,
            ..
        } => {
            let mut values = infix.arguments(arguments);
            values.resize(3, "0.0".to_owned());
            let (op, target) = (code::of_op(*op), code::of_target(*target));
            let count = arguments.len();
            format!("yield ({op}, {target}, {count}, {});\n", values.join(", "))
        }
        other => panic!("beyond the peers: {other:?}"),
    }
}
