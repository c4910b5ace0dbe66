//! The tables of messages: each crate owns those that it says, no text is written twice, and each is said in both languages.

use conventions::{Module, modules, packages};
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::iter::Peekable;
use std::sync::OnceLock;

/// The macros that define a table.
const MACROS: [&str; 4] = ["messages", "counted", "message_table", "count_table"];

/// A row of a table.
#[derive(Clone, Debug)]
struct Row {
    table: String,
    name: String,
    english: String,
    japanese: String,
    /// The words in the types of its arguments.
    types: BTreeSet<String>,
    is_count: bool,
}

/// The code of a crate, and the rows that it defines.
type Package = (Vec<String>, Vec<Row>);

/// The published crates by name.
fn crates() -> &'static BTreeMap<String, Package> {
    static CRATES: OnceLock<BTreeMap<String, Package>> = OnceLock::new();
    CRATES.get_or_init(read)
}

fn read() -> BTreeMap<String, Package> {
    let packages = packages(&["tip-runtime", "tipc", "tip-macros", "tools"]);
    let of_package = packages.into_iter().map(|package| {
        let modules = modules(&package.folder.join("src"));
        let rows = modules.values().flat_map(rows).collect();
        let code = modules.values().map(|module| module.tokens.to_string());
        (package.name, (code.collect(), rows))
    });
    of_package.collect()
}

/// The rows that a module defines.
fn rows(module: &Module) -> Vec<Row> {
    let mut found = Vec::new();
    let tokens: Vec<TokenTree> = module.tokens.clone().into_iter().collect();
    for three in tokens.windows(3) {
        if let [
            TokenTree::Ident(name),
            TokenTree::Punct(mark),
            TokenTree::Group(body),
        ] = three
            && mark.as_char() == '!'
            && MACROS.iter().any(|one| name == one)
        {
            table(body.stream(), &mut found);
        }
    }
    found
}

/// Adds the rows of a table.
fn table(body: TokenStream, found: &mut Vec<Row>) {
    let mut tokens = body.into_iter().peekable();
    let table = word(&mut tokens);
    let is_count = matches!(tokens.next(), Some(TokenTree::Punct(mark)) if mark.as_char() == ':');
    while tokens.peek().is_some() {
        let name = match is_count {
            true => "from".to_owned(),
            false => word(&mut tokens),
        };
        let mut types = BTreeSet::new();
        let braces = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace);
        if let Some(TokenTree::Group(arguments)) = tokens.next_if(braces) {
            words(arguments.stream(), &mut types);
        }
        // The codes of a reason.
        let codes = |tree: &TokenTree| matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Bracket);
        tokens.next_if(codes);
        let english = text(&mut tokens);
        let japanese = text(&mut tokens);
        found.push(Row {
            table: table.clone(),
            name,
            english,
            japanese,
            types,
            is_count,
        });
    }
}

/// The next word, after attributes.
fn word(tokens: &mut Peekable<impl Iterator<Item = TokenTree>>) -> String {
    loop {
        match tokens.next() {
            Some(TokenTree::Ident(word)) => return word.to_string(),
            Some(_) => {}
            None => panic!("a table has a name, and each row has one"),
        }
    }
}

/// The next text, and the comma or semicolon after it.
fn text(tokens: &mut Peekable<impl Iterator<Item = TokenTree>>) -> String {
    let literal = tokens.next().expect("a row has a text in each language");
    let text = syn::parse2::<syn::LitStr>(literal.into()).expect("a row's texts are literals");
    tokens.next();
    text.value()
}

/// Adds all words of some code.
fn words(code: TokenStream, found: &mut BTreeSet<String>) {
    for tree in code {
        match tree {
            TokenTree::Ident(word) => {
                found.insert(word.to_string());
            }
            TokenTree::Group(group) => words(group.stream(), found),
            _ => {}
        }
    }
}

/// Returns true if some code has a path of words, such as `Parsing :: PutEnd`.
fn has(code: &str, path: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_';
    code.match_indices(path).any(|(at, _)| {
        let next = code[at + path.len()..].chars().next();
        !next.is_some_and(is_part) && !code[..at].ends_with(is_part)
    })
}

#[test]
fn every_row_is_said_somewhere() {
    let crates = crates();
    let count: usize = crates.values().map(|(_, rows)| rows.len()).sum();
    assert!(count > 900, "{count} rows: the tables are found");
    let mut silent = Vec::new();
    let code: Vec<&String> = crates.values().flat_map(|(code, _)| code).collect();
    for row in crates.values().flat_map(|(_, rows)| rows) {
        let path = format!("{} :: {}", row.table, row.name);
        let argument = format!(": {}", row.table);
        if !code
            .iter()
            .any(|code| has(code, &path) || row.is_count && has(code, &argument))
        {
            silent.push(path);
        }
    }
    assert!(silent.is_empty(), "nothing says\n{}", silent.join("\n"));
}

#[test]
fn the_compiler_holds_no_sentence_of_a_tool() {
    let crates = crates();
    let inside = ["tip-compiler", "tip-lint", "tip-macros"];
    for row in &crates["tip-compiler"].1 {
        let path = format!("{} ::", row.table);
        let says = |name: &&str| crates[*name].0.iter().any(|code| code.contains(&path));
        let is_argument = || {
            let mut rows = crates["tip-compiler"].1.iter();
            rows.any(|other| other.types.contains(&row.table))
        };
        assert!(inside.iter().any(says) || is_argument(), "{}", row.table);
    }
}

#[test]
fn no_text_stands_in_two_rows() {
    let crates = crates();
    let rows: Vec<&Row> = crates.values().flat_map(|(_, rows)| rows).collect();
    let types: BTreeSet<&String> = rows.iter().flat_map(|row| &row.types).collect();
    for text in [
        |row: &Row| row.english.clone(),
        |row: &Row| row.japanese.clone(),
    ] {
        let mut seen: BTreeMap<String, String> = BTreeMap::new();
        // A part of a sentence may be like another.
        for row in rows.iter().filter(|row| !types.contains(&row.table)) {
            let is_words = text(row).replace(['{', '}'], "").contains(' ');
            let name = format!("{}::{}", row.table, row.name);
            if let Some(first) = seen.insert(text(row), name.clone()).filter(|_| is_words) {
                panic!("{first} and {name} are both {:?}", text(row));
            }
        }
    }
}

/// Holes alone, names, and what the system says are alike in both languages.
#[test]
fn every_text_is_translated() {
    let is_words = |text: &str| {
        let mut depth = 0;
        text.chars().any(|letter| {
            depth += i32::from(letter == '{') - i32::from(letter == '}');
            depth == 0 && letter.is_ascii_alphabetic()
        })
    };
    let is_japanese = |letter: char| ('\u{3041}'..='\u{9fff}').contains(&letter);
    for row in crates().values().flat_map(|(_, rows)| rows) {
        let translated = row.japanese.contains(is_japanese) || !is_words(&row.english);
        assert!(
            translated,
            "{}::{}: {:?}",
            row.table, row.name, row.japanese
        );
    }
}

#[test]
fn every_text_is_whole() {
    for row in crates().values().flat_map(|(_, rows)| rows) {
        for text in [&row.english, &row.japanese] {
            assert!(!text.trim().is_empty(), "{}::{}", row.table, row.name);
            assert_eq!(text.trim_end(), text, "{}::{}", row.table, row.name);
            assert!(!text.contains("  "), "{}::{}", row.table, row.name);
        }
    }
}
