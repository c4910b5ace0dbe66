//! Names of the generated code.

use crate::program::{Flag, Label, Op, Port, Reading, StepId, Target, Teach, Variable};
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;
use std::collections::BTreeMap;
use std::fmt::{Debug, Write};

/// Returns the type that a source file's program gets: its name without folders and extension, in
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

/// Returns a word in UpperCamelCase: `walk` → `Walk`, `WALK` → `Walk`, `fastWalk` → `FastWalk`.
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

/// Returns the field that holds a variable. The prefix keeps it clear of keywords and of the other fields.
pub(super) fn field(variable: &Variable) -> Ident {
    identifier(&format!("v_{}", variable.name.to_ascii_lowercase()))
}

/// Returns the function of a step.
pub(super) fn state(step: StepId) -> Ident {
    identifier(&format!("step_{step}"))
}

/// Returns step and constant of each label whose name stands for one step only; LOOP may stand for many.
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

/// Returns the text with an escape in the place of each character that a comment may not hold; a tab stays.
pub(crate) fn in_comment(text: &str) -> String {
    let mut shown = String::with_capacity(text.len());
    for char in text.chars() {
        match breaks_comments(char) {
            // Writing to a string cannot fail.
            true => _ = write!(shown, "{}", char.escape_unicode()),
            false => shown.push(char),
        }
    }
    shown
}

/// Returns true for control characters, line separators, and characters that set the direction of text.
fn breaks_comments(char: char) -> bool {
    let sets_direction = matches!(
        char,
        '\u{61C}' | '\u{200E}' | '\u{200F}' | '\u{202A}'..='\u{202E}' | '\u{2066}'..='\u{2069}'
    );
    let parts_lines = matches!(char, '\u{2028}' | '\u{2029}');
    sets_direction || parts_lines || (char.is_control() && char != '\t')
}

/// Returns a number that reads back to the same bits.
pub(crate) fn number(value: f64) -> TokenStream {
    let magnitude = Literal::f64_unsuffixed(value.abs());
    if value.is_sign_negative() {
        quote!(-#magnitude)
    } else {
        quote!(#magnitude)
    }
}

/// Returns a variant of the vocabulary: its `Debug` form after the name of its type.
fn variant(of: &str, variant: impl Debug) -> TokenStream {
    let path = format!("{of}::{variant:?}");
    path.parse().unwrap_or_default()
}

pub(super) fn op(op: Op) -> TokenStream {
    variant("Op", op)
}

pub(super) fn target(target: Target) -> TokenStream {
    variant("Target", target)
}

pub(super) fn teach(what: Teach) -> TokenStream {
    variant("Teach", what)
}

pub(super) fn reading(reading: Reading) -> TokenStream {
    match reading {
        Reading::Timer(n) => {
            let n = small(n);
            quote!(Reading::Timer(#n))
        }
        Reading::Measured(what, part) => {
            let (what, part) = (teach(what), target(part));
            quote!(Reading::Measured(#what, #part))
        }
    }
}

pub(super) fn port(port: Port) -> TokenStream {
    variant("Port", port)
}

pub(super) fn flag(flag: Flag) -> TokenStream {
    let Some(of) = flag.target() else {
        return variant("Flag", flag);
    };
    let variant = format!("{flag:?}");
    let name = identifier(variant.split('(').next().unwrap_or_default());
    let of = target(of);
    quote!(Flag::#name(#of))
}

/// Returns the number of a thread from 1, by its index.
pub(super) fn thread(index: usize) -> Literal {
    Literal::usize_unsuffixed(index + 1)
}

pub(super) fn small(n: u8) -> Literal {
    Literal::u8_unsuffixed(n)
}

#[cfg(test)]
mod tests {
    use super::in_comment;

    #[test]
    fn what_ends_a_line_or_turns_text_is_an_escape() {
        assert_eq!(in_comment("a\nb\r\u{202E}c"), "a\\u{a}b\\u{d}\\u{202e}c");
        assert_eq!(in_comment("\u{1b}\u{85}\u{7f}"), "\\u{1b}\\u{85}\\u{7f}");
        assert_eq!(in_comment("\u{2028}\u{2066}"), "\\u{2028}\\u{2066}");
        assert_eq!(in_comment("歩く\t\\n → ok"), "歩く\t\\n → ok");
    }
}
