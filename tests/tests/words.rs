//! Every word of the language is spelled once: in its table, or, if a trace prints it, in the vocabulary of the runtime.

use proc_macro2::{Delimiter, Literal, TokenStream, TokenTree};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use tipc::language::commands::COMMANDS;
use tipc::language::flags::FLAGS;
use tipc::language::functions::FUNCTIONS;
use tipc::language::inputs::{self, INPUTS};
use tipc::language::keywords::KEYWORDS;
use tipc::language::reserved::RESERVED;

/// Where words are spelled: the tables, the vocabulary, and what knows the words of older editions.
const HOMES: [&str; 3] = [
    "tipc/src/language",
    "tip-runtime/src/command",
    "tipc/src/migrate",
];

#[test]
fn no_word_is_spelled_outside_its_table() {
    let words = words();
    let mut found = Vec::new();
    for path in sources() {
        let text = fs::read_to_string(workspace().join(&path)).expect("a source file");
        let spelled = spelled(&text, &words);
        found.extend(spelled.iter().map(|word| format!("{path}: {word}")));
    }
    assert!(found.is_empty(), "spelled again:\n{}", found.join("\n"));
}

#[test]
fn the_search_reaches_the_rooms_of_all_crates() {
    let sources = sources();
    for file in [
        "tip-runtime/src/record/json_lines.rs",
        "tipc/src/check/names.rs",
        "tipc/src/listing/object.rs",
        "tip-macros/src/arguments.rs",
        "tools/cli/src/run.rs",
    ] {
        assert!(sources.iter().any(|source| source == file), "{file}");
    }
    let is_home = |source: &String| HOMES.iter().any(|home| source.starts_with(home));
    assert!(!sources.iter().any(is_home));
}

#[test]
fn a_planted_word_is_found_and_prose_is_not() {
    let found = |text: &str| spelled(text, &words());
    for (text, word) in [
        (r#"fn f() { g("PTP_ANGLE") }"#, "PTP_ANGLE"),
        (r#"const A: &[&str] = &["no", "THEN"];"#, "THEN"),
        (r#"fn f() { let _ = format!("VR{n}"); }"#, "VR{n}"),
        (r#"fn f() { write!(f, "\tPAW{}", n) }"#, "\tPAW{}"),
        (r#"fn f() { format!("TARGET_VR{n}") }"#, "TARGET_VR{n}"),
        (r#"fn f() { b"ANTENNA" }"#, "ANTENNA"),
        (r##"fn f() { r#"INPOS_"# }"##, "INPOS_"),
        ("fn f() { 'J' }", "J"),
        (
            r#"mod tested { const A: &str = "WAIT_IN_POS"; }"#,
            "WAIT_IN_POS",
        ),
    ] {
        assert_eq!(found(text), [word], "{text}");
    }
    for text in [
        r#"fn f() { "use PTP_ANGLE instead" }"#,
        "/// `PTP`\nfn f() {}",
        "#[doc = \"PTP\"]\nfn f() {}",
        r#"fn f() { "IF_THEN"; "ptp"; "MODELF{n}" }"#,
        r#"fn f() { format!("leg F{n} has no joints") }"#,
        "fn f() { b'A'..=b'Z' }",
        r#"#[cfg(test)] mod tests { const A: &str = "PTP"; }"#,
    ] {
        assert!(found(text).is_empty(), "{text}");
    }
}

fn workspace() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// Every word, and what the words of each family begin with.
fn words() -> BTreeSet<String> {
    let commands = COMMANDS.iter();
    let commands = commands.flat_map(|row| [Some(row.name), row.alias].into_iter().flatten());
    let rest = KEYWORDS.iter().map(|row| row.word);
    let rest = rest.chain(FUNCTIONS.iter().map(|row| row.word));
    let rest = rest.chain(FLAGS.iter().map(|row| row.word()));
    let rest = rest.chain(INPUTS.iter().map(|row| row.port.stem()));
    let rest = rest.chain(RESERVED.iter().map(|row| row.word));
    let inputs = inputs::named().map(|port| port.to_string());
    let words = commands.chain(rest).map(str::to_owned);
    words.chain(inputs).collect()
}

/// The source files of products and tools that have to look words up, by their paths in the workspace.
fn sources() -> Vec<String> {
    let crates = ["tip-runtime", "tipc", "tip-macros"].map(str::to_owned);
    let tools = fs::read_dir(workspace().join("tools")).expect("the tools");
    let tools = tools.map(|tool| format!("tools/{}", name(&tool.expect("a tool"))));
    let mut sources = Vec::new();
    for member in crates.into_iter().chain(tools) {
        collect(&format!("{member}/src"), &mut sources);
    }
    sources.sort();
    sources
}

fn collect(folder: &str, sources: &mut Vec<String>) {
    let Ok(entries) = fs::read_dir(workspace().join(folder)) else {
        return;
    };
    for entry in entries {
        let entry = entry.expect("an entry");
        let path = format!("{folder}/{}", name(&entry));
        let is_home = HOMES.iter().any(|home| path.starts_with(home));
        if is_home || path.ends_with("/tests") || path.ends_with("/tests.rs") {
            continue;
        }
        if entry.path().is_dir() {
            collect(&path, sources);
        } else if path.ends_with(".rs") {
            sources.push(path);
        }
    }
}

fn name(entry: &fs::DirEntry) -> String {
    entry.file_name().to_string_lossy().into_owned()
}

/// The literals of a source that are words, or from which words are made; attributes and tests left out.
fn spelled(text: &str, words: &BTreeSet<String>) -> Vec<String> {
    let tokens: TokenStream = text.parse().expect("a source file");
    let mut literals = Vec::new();
    find_literals(tokens, &mut literals);
    literals.retain(|literal| words.contains(literal) || makes_a_word(literal));
    literals
}

fn find_literals(tokens: TokenStream, found: &mut Vec<String>) {
    let mut tokens = tokens.into_iter().peekable();
    let mut in_test = false;
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(sign) if sign.as_char() == '#' => {
                let attribute = tokens.next_if(|next| {
                    matches!(next, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket)
                });
                in_test |= attribute.is_some_and(|tokens| tokens.to_string() == "[cfg (test)]");
            }
            TokenTree::Punct(sign) if sign.as_char() == ';' => in_test = false,
            TokenTree::Group(group) if in_test && group.delimiter() == Delimiter::Brace => {
                in_test = false;
            }
            TokenTree::Group(group) if !in_test => find_literals(group.stream(), found),
            TokenTree::Literal(literal) => found.extend(text_of(literal)),
            _ => {}
        }
    }
}

/// The text of a string, in bytes or not, or of a character.
fn text_of(literal: Literal) -> Option<String> {
    match syn::Lit::new(literal) {
        syn::Lit::Str(text) => Some(text.value()),
        syn::Lit::ByteStr(bytes) => String::from_utf8(bytes.value()).ok(),
        syn::Lit::Char(char) => Some(char.value().to_string()),
        _ => None,
    }
}

/// Whether a format string puts something behind what the words of a family begin with, and is no sentence.
fn makes_a_word(literal: &str) -> bool {
    let families = [
        "F",
        "J",
        "VR",
        "PAW",
        "INPOS_",
        "NEAR_",
        "SPECIAL_FLAG",
        "CHAR_",
    ];
    families.iter().any(|family| {
        let made = format!("{family}{{");
        let mut places = literal.match_indices(&made).map(|(at, _)| &literal[..at]);
        !literal.contains(' ') && places.any(|before| !before.ends_with(char::is_alphanumeric))
    })
}
