//! The modules of a crate that are files, without tests.

use crate::tree::rust_files;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;

/// A module by its path from the crate's root, and its code without tests and comments.
#[derive(Clone, Debug)]
pub struct Module {
    /// The path; empty for the root.
    pub path: Vec<String>,
    /// The code.
    pub tokens: TokenStream,
}

/// The modules under a `src` folder. A library's binary is left out.
///
/// # Panics
/// A file is not Rust, or cannot be read.
pub fn modules(src: &Path) -> BTreeMap<Vec<String>, Module> {
    let mut tests = BTreeSet::new();
    let mut all = BTreeMap::new();
    let mut files = rust_files(src);
    if files.contains(&src.join("lib.rs")) {
        files.retain(|file| *file != src.join("main.rs"));
    }
    for file in files {
        let path = module_path(src, &file);
        let text = fs::read_to_string(&file).expect("sources are UTF-8");
        let stream: TokenStream = text.parse().expect("sources are Rust");
        let (tokens, test_modules) = without_tests(stream);
        tests.extend(test_modules.into_iter().map(|name| child(&path, name)));
        all.insert(path.clone(), Module { path, tokens });
    }
    let is_test = |path: &[String]| (1..=path.len()).any(|end| tests.contains(&path[..end]));
    all.retain(|path, _| !is_test(path));
    all
}

fn child(path: &[String], name: String) -> Vec<String> {
    let mut path = path.to_vec();
    path.push(name);
    path
}

/// Returns the module path of a file.
fn module_path(src: &Path, file: &Path) -> Vec<String> {
    let inside = file
        .strip_prefix(src)
        .expect("a file of src")
        .with_extension("");
    let mut path: Vec<String> = inside
        .iter()
        .map(|part| part.to_string_lossy().into_owned())
        .collect();
    path.pop_if(|name| matches!(name.as_str(), "lib" | "main" | "mod"));
    path
}

/// The code without items under `#[cfg(test)]`, and the names of the modules among these.
fn without_tests(stream: TokenStream) -> (TokenStream, Vec<String>) {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let (mut kept, mut modules) = (Vec::new(), Vec::new());
    let mut at = 0;
    while at < tokens.len() {
        if !is_test_attribute(&tokens[at..]) {
            kept.push(tokens[at].clone());
            at += 1;
            continue;
        }
        let item = &tokens[at..];
        let length = item
            .iter()
            .position(ends_item)
            .map_or(item.len(), |end| end + 1);
        modules.extend(module_name(&item[..length]));
        at += length;
    }
    (kept.into_iter().collect(), modules)
}

fn is_test_attribute(tokens: &[TokenTree]) -> bool {
    let [TokenTree::Punct(sign), TokenTree::Group(group), ..] = tokens else {
        return false;
    };
    let text = group.stream().to_string().replace(' ', "");
    sign.as_char() == '#'
        && text.starts_with("cfg(")
        && text.contains("test")
        && !text.contains("not(test")
}

fn ends_item(token: &TokenTree) -> bool {
    match token {
        TokenTree::Punct(sign) => sign.as_char() == ';',
        TokenTree::Group(group) => group.delimiter() == Delimiter::Brace,
        _ => false,
    }
}

fn module_name(item: &[TokenTree]) -> Option<String> {
    item.windows(2).find_map(|pair| match pair {
        [TokenTree::Ident(word), TokenTree::Ident(name)] if *word == "mod" => {
            Some(name.to_string())
        }
        _ => None,
    })
}
