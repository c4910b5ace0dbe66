//! Every word of the language is spelled once: in its table, or, if a trace prints it, in the vocabulary of the runtime.

use conventions::{modules, packages};
use proc_macro2::{Delimiter, Literal, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use tipc::language::commands::COMMANDS;
use tipc::language::flags::FLAGS;
use tipc::language::functions::FUNCTIONS;
use tipc::language::inputs::{self, INPUTS};
use tipc::language::keywords::KEYWORDS;
use tipc::language::reserved::RESERVED;

/// Modules that spell words: the tables, the vocabulary, and the words of older editions.
const HOMES: [&str; 3] = [
    "tip-compiler::language",
    "tip-runtime::command",
    "tip-lint::migrate",
];

#[test]
fn no_word_is_spelled_outside_its_table() {
    let words = words();
    let mut found = Vec::new();
    for (module, code) in sources() {
        let mut spelled = spelled(code, &words);
        // The unit joule is no joint.
        let has_units = ["tip-sweep::columns", "tip-cli::compare"].contains(&&*module);
        spelled.retain(|word| !has_units || word != "J");
        found.extend(spelled.iter().map(|word| format!("{module}: {word}")));
    }
    assert!(found.is_empty(), "spelled again:\n{}", found.join("\n"));
}

#[test]
fn the_search_reaches_the_modules_of_all_crates() {
    let sources = sources();
    for module in [
        "tip-runtime::record::json_lines",
        "tip-compiler::check::names",
        "tip-lint::listing::object",
        "tip-macros::arguments",
        "tip-sim::run",
        "tip-cli::run",
    ] {
        assert!(sources.contains_key(module), "{module}");
    }
    let is_home = |module: &String| HOMES.iter().any(|home| module.starts_with(home));
    assert!(!sources.keys().any(is_home));
}

#[test]
fn a_planted_word_is_found_and_prose_is_not() {
    let found = |text: &str| spelled(text.parse().expect("it is Rust"), &words());
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
    ] {
        assert!(found(text).is_empty(), "{text}");
    }
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

/// The code of products and tools that have to look words up, by crate and module; tests left out.
fn sources() -> BTreeMap<String, TokenStream> {
    let crates = packages(&["tip-runtime", "tipc", "tip-macros", "tools"]);
    let all = crates.iter().flat_map(|package| {
        let modules = modules(&package.folder.join("src")).into_values();
        modules.map(|module| {
            let path = [package.name.clone()].into_iter().chain(module.path);
            (path.collect::<Vec<_>>().join("::"), module.tokens)
        })
    });
    let is_home = |module: &String| HOMES.iter().any(|home| module.starts_with(home));
    all.filter(|(module, _)| !is_home(module)).collect()
}

/// The literals of some code that are words, or from which words are made; attributes left out.
fn spelled(code: TokenStream, words: &BTreeSet<String>) -> Vec<String> {
    let mut literals = Vec::new();
    find_literals(code, &mut literals);
    literals.retain(|literal| words.contains(literal) || makes_a_word(literal));
    literals
}

fn find_literals(tokens: TokenStream, found: &mut Vec<String>) {
    let mut tokens = tokens.into_iter().peekable();
    while let Some(token) = tokens.next() {
        match token {
            TokenTree::Punct(sign) if sign.as_char() == '#' => {
                tokens.next_if(|next| {
                    matches!(next, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket)
                });
            }
            TokenTree::Group(group) => find_literals(group.stream(), found),
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

/// Returns true if a format string puts something after what the words of a family begin with, and is not a sentence.
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
