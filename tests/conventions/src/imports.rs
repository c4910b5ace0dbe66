//! Imports of a module from other modules of its crate.

use crate::modules::Module;
use proc_macro2::{Delimiter, TokenStream, TokenTree};
use std::collections::{BTreeMap, BTreeSet};

/// Something of another module that a module names by a path.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Import {
    /// The other module.
    pub module: Vec<String>,
    /// The first name after the module's path; `self` for the module itself.
    pub name: String,
}

/// Returns the modules of the crate that `module` imports, without its own parents: a parent holds what its children share.
pub fn imports(module: &Module, all: &BTreeMap<Vec<String>, Module>) -> BTreeSet<Import> {
    let mut paths = Vec::new();
    collect(module.tokens.clone(), &mut paths);
    let resolve = |path: &Vec<String>| import(&module.path, path, all);
    paths.iter().filter_map(resolve).collect()
}

/// Which module a path leads to, seen from `from`.
fn import(from: &[String], path: &[String], all: &BTreeMap<Vec<String>, Module>) -> Option<Import> {
    let mut names = path.iter().peekable();
    let mut here = from.to_vec();
    match names.peek()?.as_str() {
        "crate" => {
            here.clear();
            names.next();
        }
        "self" => {
            names.next();
        }
        "super" => {
            while names.next_if(|name| *name == "super").is_some() {
                here.pop();
            }
        }
        first => {
            here.push(first.to_owned());
            if !all.contains_key(&here) {
                return None;
            }
            here.pop();
        }
    }
    let mut name = "self";
    for next in names {
        here.push(next.clone());
        if !all.contains_key(&here) {
            here.pop();
            name = next;
            break;
        }
    }
    let name = name.to_owned();
    let is_other = all.contains_key(&here) && !from.starts_with(&here);
    is_other.then_some(Import { module: here, name })
}

/// Every path in the code, whole.
fn collect(stream: TokenStream, paths: &mut Vec<Vec<String>>) {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let mut at = 0;
    while at < tokens.len() {
        match &tokens[at] {
            TokenTree::Ident(word) if !follows_a_path(&tokens[..at]) => {
                let is_use = *word == "use";
                at += usize::from(is_use);
                at += tree(&tokens[at..], &[], paths).max(usize::from(!is_use));
            }
            TokenTree::Group(group) => {
                collect(group.stream(), paths);
                at += 1;
            }
            _ => at += 1,
        }
    }
}

/// Returns true if what comes before makes the next word a field, a method, or a part of a foreign path.
fn follows_a_path(before: &[TokenTree]) -> bool {
    matches!(before.last(), Some(TokenTree::Punct(sign)) if sign.as_char() == '.')
        || (before.len() >= 2 && before[before.len() - 2..].iter().all(is_colon))
}

fn is_colon(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Punct(sign) if sign.as_char() == ':')
}

/// Reads `a::b::{c, d::e}` and adds each of its paths after `head`; returns how many tokens it took.
fn tree(tokens: &[TokenTree], head: &[String], paths: &mut Vec<Vec<String>>) -> usize {
    let mut path = head.to_vec();
    let mut at = 0;
    loop {
        match tokens.get(at) {
            Some(TokenTree::Ident(name)) => path.push(name.to_string()),
            Some(TokenTree::Punct(sign)) if sign.as_char() == '*' && at > 0 => {
                path.push("*".to_owned());
            }
            Some(TokenTree::Group(group)) if at > 0 && group.delimiter() == Delimiter::Brace => {
                for branch in branches(group.stream()) {
                    tree(&branch, &path, paths);
                }
                return at + 1;
            }
            _ => break,
        }
        at += 1;
        match tokens.get(at..at + 2) {
            Some(colons) if colons.iter().all(is_colon) => at += 2,
            _ => break,
        }
    }
    if path.len() > 1 {
        paths.push(path);
    }
    at
}

/// The parts of a group between its commas.
fn branches(stream: TokenStream) -> Vec<Vec<TokenTree>> {
    let tokens: Vec<TokenTree> = stream.into_iter().collect();
    let is_comma =
        |token: &TokenTree| matches!(token, TokenTree::Punct(sign) if sign.as_char() == ',');
    tokens.split(is_comma).map(<[TokenTree]>::to_vec).collect()
}
