//! Names of the generated code.

use crate::program::{Label, StepId, Variable};
use proc_macro2::{Ident, Span};
use std::collections::BTreeMap;

/// The type that a source file's program gets: its name without folders and extension, in
/// UpperCamelCase (`walk_fast.prg` is `WalkFast`). Characters other than ASCII letters and digits
/// separate words; where no word is left the name is `Program`.
pub fn type_name(source_name: &str) -> String {
    let file = source_name
        .rsplit(['/', '\\'])
        .next()
        .unwrap_or(source_name);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let name: String = stem
        .split(|c: char| !c.is_ascii_alphanumeric())
        .map(capitalised)
        .collect();
    match name.as_bytes().first() {
        None => "Program".to_owned(),
        Some(first) if first.is_ascii_digit() => format!("Program{name}"),
        Some(_) if name == "Self" => "SelfProgram".to_owned(),
        Some(_) => name,
    }
}

/// `walk` → `Walk`, `WALK` → `Walk`, `fastWalk` → `FastWalk`.
fn capitalised(word: &str) -> String {
    let mut letters = word.chars();
    let Some(first) = letters.next() else {
        return String::new();
    };
    let shouted = !word.contains(|c: char| c.is_ascii_lowercase());
    let rest = if shouted {
        letters.as_str().to_ascii_lowercase()
    } else {
        letters.as_str().to_owned()
    };
    format!("{}{rest}", first.to_ascii_uppercase())
}

/// The field that holds a variable. The prefix keeps it clear of keywords and of the other fields.
pub(super) fn field(variable: &Variable) -> Ident {
    identifier(&format!("v_{}", variable.name.to_ascii_lowercase()))
}

/// The function of a step.
pub(super) fn state(step: StepId) -> Ident {
    identifier(&format!("step_{step}"))
}

/// Step and constant of each label whose name stands for one step only; LOOP may stand for many.
pub(super) fn label_constants(labels: &[Label]) -> Vec<(u32, Ident)> {
    let mut declared = BTreeMap::<&str, usize>::new();
    for label in labels {
        *declared.entry(&label.name).or_default() += 1;
    }
    labels
        .iter()
        .filter(|label| declared.get(label.name.as_str()) == Some(&1))
        .map(|label| (label.step, identifier(&format!("L_{}", label.name))))
        .collect()
}

pub(super) fn identifier(name: &str) -> Ident {
    Ident::new(name, Span::call_site())
}
