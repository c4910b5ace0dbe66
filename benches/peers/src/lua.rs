//! A Lua coroutine: a script as one writes it in Lua, that yields once in each cycle, with the command
//! if there is one. The same text serves Lua 5.4 and LuaJIT.

use crate::code;
use crate::infix::Infix;
use crate::structure::{Node, blocks};
use std::fmt::Write;
use tipc::program::{Action, Program, Scalar};

/// A chunk that returns the coroutine's function.
pub fn spell(program: &Program) -> String {
    let infix = Infix::of_script(program, "~=");
    let blocks = blocks(program);
    let mut text = String::from("local yield = coroutine.yield\nlocal call = {}\n");
    let places = infix.places().join(", ");
    writeln!(text, "local {places}").expect("a string");
    for (first, nodes) in &blocks.subroutines {
        writeln!(text, "call[{first}] = function()").expect("a string");
        write_nodes(&mut text, &infix, nodes);
        text.push_str("end\n");
    }
    text.push_str("return function()\n");
    write_nodes(&mut text, &infix, &blocks.main);
    text.push_str("end\n");
    text
}

fn write_nodes(text: &mut String, infix: &Infix<'_>, nodes: &[Node<'_>]) {
    for node in nodes {
        match node {
            Node::Step(action) => text.push_str(&step(infix, action)),
            Node::Endless(inner) => {
                text.push_str("while true do\nyield()\n");
                write_nodes(text, infix, inner);
                text.push_str("yield()\nend\n");
            }
            Node::If(condition, inner) => {
                writeln!(text, "if {} then\nyield()", infix.condition(*condition))
                    .expect("a string");
                write_nodes(text, infix, inner);
                text.push_str("else\nyield()\nend\nyield()\n");
            }
            Node::For(variable, from, to, inner) => {
                let (from, to) = (infix.operand(*from), infix.operand(*to));
                let name = loop_variable(infix, *variable);
                writeln!(text, "yield()\nfor {name} = {from}, {to} do").expect("a string");
                write_nodes(text, infix, inner);
                text.push_str("yield()\nend\n");
            }
            Node::Call(to) => writeln!(text, "yield()\ncall[{to}]()").expect("a string"),
        }
    }
}

/// Lua's own loops have variables of their own; no program here reads one outside of its loop.
fn loop_variable(infix: &Infix<'_>, variable: Scalar) -> String {
    infix.place(variable)
}

fn step(infix: &Infix<'_>, action: &Action) -> String {
    if let Some(sets) = infix.sets(action) {
        let places: Vec<_> = sets.iter().map(|set| set.place.clone()).collect();
        let values: Vec<_> = sets.iter().map(|set| set.value.clone()).collect();
        return format!("{} = {}\nyield()\n", places.join(", "), values.join(", "));
    }
    match action {
        Action::Nothing | Action::Return => "yield()\n".to_owned(),
        Action::Command {
            op,
            target,
            arguments,
            ..
        } => {
            let mut values = vec![
                code::of_op(*op).to_string(),
                code::of_target(*target).to_string(),
            ];
            values.extend(infix.arguments(arguments));
            format!("yield({})\n", values.join(", "))
        }
        other => panic!("beyond the peers: {other:?}"),
    }
}
