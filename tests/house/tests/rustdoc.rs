//! What the pages of the published crates show.

use house::{packages, root};
use std::fs;
use std::path::{Path, PathBuf};
use syn::{Attribute, Expr, ExprLit, Item, Lit, Meta, Visibility};

/// The libraries; the command has no pages.
const LIBRARIES: [&str; 7] = [
    "tip-runtime",
    "tipc",
    "tip-macros",
    "tools/ide",
    "tools/lint",
    "tools/sim",
    "tools/view",
];

/// Those with an example in every public module.
const TAUGHT: [&str; 2] = ["tip-runtime", "tools/sim"];

/// A public module: its path, its file, and its own documentation.
struct Page {
    name: String,
    docs: String,
}

#[test]
fn every_front_page_and_every_public_module_has_an_example_that_is_compiled() {
    for library in LIBRARIES {
        let mut pages = Vec::new();
        let source = root().join(library).join("src");
        collect(library, &source.join("lib.rs"), &source, &mut pages);
        let is_taught = TAUGHT.contains(&library);
        assert!(
            !is_taught || pages.len() > 4,
            "{library}: modules are found"
        );
        let count = if is_taught { pages.len() } else { 1 };
        for Page { name, docs } in &pages[..count] {
            let kinds = fences(docs);
            let compiled = kinds.iter().filter(|kind| is_compiled(kind)).count();
            assert!(compiled > 0, "{name} has no example: {kinds:?}");
        }
    }
}

#[test]
fn no_example_is_ignored() {
    for library in LIBRARIES {
        let mut texts = vec![read(&root().join(library).join("README.md"))];
        texts.extend(
            house::rust_files(&root().join(library).join("src"))
                .iter()
                .map(|file| read(file)),
        );
        let docs = texts.iter().flat_map(|text| text.lines()).map(|line| {
            let line = line.trim_start();
            line.trim_start_matches("///")
                .trim_start_matches("//!")
                .trim_start()
        });
        let ignored: Vec<&str> = docs
            .filter(|line| line.starts_with("```") && line.contains("ignore"))
            .collect();
        assert!(ignored.is_empty(), "{library}: {ignored:?}");
    }
}

#[test]
fn planted_pages_are_judged() {
    let of = |docs: &str| fences(docs).iter().filter(|kind| is_compiled(kind)).count();
    assert_eq!(
        of("A\n```\nf();\n```\n```rust,no_run\n```\n````should_panic\n```\n````"),
        3
    );
    assert_eq!(
        of("```text\n```\n```ignore\n```\n```sh\n```\n```tip\n```\n```rust,ignore\n```\n"),
        0
    );
}

#[test]
fn docs_rs_shows_everything_and_what_each_item_needs() {
    let published = packages(&["tip-runtime", "tipc", "tip-macros", "tools"]);
    assert_eq!(
        published.len(),
        LIBRARIES.len() + 1,
        "the published crates are found"
    );
    for package in published {
        let manifest: toml::Table = read(&package.folder.join("Cargo.toml"))
            .parse()
            .expect("manifests are TOML");
        let settings = manifest["package"]
            .get("metadata")
            .and_then(|all| all.get("docs")?.get("rs"));
        let all = settings.and_then(|settings| settings.get("all-features")?.as_bool());
        assert_eq!(
            all,
            Some(true),
            "{}: package.metadata.docs.rs",
            package.name
        );
        let library = package.folder.join("src/lib.rs");
        if library.exists() {
            assert!(
                read(&library).contains("#![cfg_attr(docsrs, feature(doc_cfg))]"),
                "{}: nothing says which feature an item needs",
                package.name
            );
        }
    }
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The page of a module, and those of its public modules.
fn collect(name: &str, file: &Path, folder: &Path, pages: &mut Vec<Page>) {
    let parsed = syn::parse_file(&read(file)).expect("sources are Rust");
    let docs = parsed
        .attrs
        .iter()
        .filter_map(|attribute| text(attribute, file));
    pages.push(Page {
        name: name.to_owned(),
        docs: docs.collect::<Vec<_>>().join("\n"),
    });
    for item in parsed.items {
        let Item::Mod(module) = item else { continue };
        if matches!(module.vis, Visibility::Public(_)) && !module.attrs.iter().any(is_hidden) {
            let inner = module.ident.to_string();
            let file: PathBuf = folder.join(format!("{inner}.rs"));
            collect(
                &format!("{name}::{inner}"),
                &file,
                &folder.join(inner),
                pages,
            );
        }
    }
}

/// `#[doc(hidden)]`
fn is_hidden(attribute: &Attribute) -> bool {
    attribute.path().is_ident("doc")
        && matches!(&attribute.meta, Meta::List(list) if list.tokens.to_string() == "hidden")
}

/// The documentation that an attribute holds, or the file that it includes.
fn text(attribute: &Attribute, file: &Path) -> Option<String> {
    match &attribute.meta {
        Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
            Expr::Lit(ExprLit {
                lit: Lit::Str(text),
                ..
            }) => Some(text.value()),
            Expr::Macro(included) => Some(included_text(&included.mac.tokens.to_string(), file)),
            _ => None,
        },
        Meta::List(list) if list.path.is_ident("cfg_attr") => {
            let tokens = list.tokens.to_string();
            let (_, included) = tokens.split_once("include_str")?;
            Some(included_text(included, file))
        }
        _ => None,
    }
}

/// The file that `include_str!` names, between the first two quotes.
fn included_text(tokens: &str, file: &Path) -> String {
    let path = tokens.split('"').nth(1).expect("a path in quotes");
    read(&file.parent().expect("a folder").join(path))
}

/// What stands after the opening fence of each code block.
fn fences(docs: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut open: Option<usize> = None;
    for line in docs.lines().map(str::trim) {
        let ticks = line.len() - line.trim_start_matches('`').len();
        match open {
            None if ticks >= 3 => {
                open = Some(ticks);
                found.push(line[ticks..].trim().to_owned());
            }
            Some(length) if ticks >= length && ticks == line.len() => open = None,
            _ => {}
        }
    }
    found
}

/// Whether rustdoc compiles such a block.
fn is_compiled(kind: &str) -> bool {
    let of_rust = [
        "rust",
        "no_run",
        "should_panic",
        "compile_fail",
        "edition2024",
    ];
    kind.split(',')
        .filter(|word| !word.is_empty())
        .all(|word| of_rust.contains(&word.trim()))
}
