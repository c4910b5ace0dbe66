//! A batch of programs as one table of Rust.

use crate::Specimen;
use proc_macro2::{Delimiter, Group, Ident, Span, TokenStream, TokenTree};
use std::fmt::Write as _;
use tipc::message::Lang;
use tipc::render;
use tipc::{Options, emit};

/// A change of the generated code of a program, by which tests see that a wrong one is found.
pub type Tamper = fn(String) -> String;

/// Modules that hold the compiled programs, and after them `SUBJECTS`: seed, robot, text and a maker of each.
///
/// # Errors
/// The first program that does not load, and why.
pub fn rust(specimens: &[Specimen], tamper: Tamper) -> Result<String, String> {
    let mut modules = String::new();
    let mut rows = String::new();
    for (n, specimen) in specimens.iter().enumerate() {
        let Specimen {
            seed,
            robot,
            source,
        } = specimen;
        let items = tamper(items(specimen)?);
        let robot = robot.name();
        writeln!(modules, "mod p{n} {{ {items} }}").expect("writing to a string");
        writeln!(
            rows,
            "(({seed}, {robot:?}, {source:?}), || ::tip_sim::ProgramRunner::new(p{n}::Compiled::new())),"
        )
        .expect("writing to a string");
    }
    Ok(format!(
        "{modules}
/// Seed, robot, text and compiled form of each program.
#[allow(clippy::type_complexity)]
pub static SUBJECTS: &[((u64, &str, &str), fn() -> ::tip_sim::ProgramRunner)] = &[
{rows}];
"
    ))
}

fn items(specimen: &Specimen) -> Result<String, String> {
    let Specimen {
        seed,
        robot,
        source,
    } = specimen;
    let options = Options {
        robot: *robot,
        ..Options::default()
    };
    let loaded = tipc::load(&format!("{seed}.prg"), source.as_bytes(), &options);
    let Some(program) = &loaded.program else {
        let told = loaded
            .diagnostics
            .iter()
            .map(|one| render::short(&loaded.source, one, Lang::English));
        return Err(format!("{}\n{source}", told.collect::<Vec<_>>().join("\n")));
    };
    let spelling = emit::Options {
        name: Some(Ident::new("Compiled", Span::call_site())),
        visibility: "pub(super)".parse().expect("a visibility"),
        ..emit::Options::default()
    };
    Ok(without_extras(emit::emit(program, &spelling)).to_string())
}

/// Leaves out what no run sees, comments and derived implementations but for `Clone`: a third of the compiler's time.
fn without_extras(tokens: TokenStream) -> TokenStream {
    let mut kept: Vec<TokenTree> = Vec::new();
    for tree in tokens {
        match tree {
            TokenTree::Group(group) if is_attribute(&group, "doc") => {
                // The `#` before it.
                kept.pop();
            }
            TokenTree::Group(group) if is_attribute(&group, "derive") => {
                let clone = "[derive(Clone)]".parse::<TokenStream>().expect("tokens");
                kept.extend(clone);
            }
            TokenTree::Group(group) => {
                let inner = without_extras(group.stream());
                kept.push(Group::new(group.delimiter(), inner).into());
            }
            other => kept.push(other),
        }
    }
    kept.into_iter().collect()
}

/// Returns true if it is an attribute of this name, without its `#`.
fn is_attribute(group: &Group, name: &str) -> bool {
    let first = group.stream().into_iter().next();
    group.delimiter() == Delimiter::Bracket && first.is_some_and(|tree| tree.to_string() == name)
}
