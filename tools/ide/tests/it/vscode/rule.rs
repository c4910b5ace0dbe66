//! TextMate grammars as data.

use serde::Serialize;
use std::collections::BTreeMap;

/// A rule of a grammar: what is found, and what it is called.
#[derive(Clone, Default, Serialize)]
#[serde(rename_all = "camelCase")]
pub(crate) struct Rule {
    #[serde(skip_serializing_if = "String::is_empty")]
    include: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    name: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    content_name: String,
    #[serde(skip_serializing_if = "String::is_empty")]
    r#match: String,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    captures: BTreeMap<u8, Capture>,
    #[serde(skip_serializing_if = "String::is_empty")]
    begin: String,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    begin_captures: BTreeMap<u8, Capture>,
    #[serde(skip_serializing_if = "String::is_empty")]
    end: String,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    end_captures: BTreeMap<u8, Capture>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    patterns: Vec<Rule>,
}

#[derive(Clone, Serialize)]
struct Capture {
    name: String,
}

/// Each name ends with that of the language.
fn named(scope: &str) -> String {
    format!("{scope}.tip")
}

fn capture(scope: &str) -> Capture {
    Capture { name: named(scope) }
}

impl Rule {
    /// Returns a rule whose whole match has a name.
    pub(crate) fn named(scope: &str, pattern: impl Into<String>) -> Self {
        Rule {
            name: named(scope),
            r#match: pattern.into(),
            ..Rule::default()
        }
    }

    /// Returns a rule whose groups have names.
    pub(crate) fn parts(pattern: impl Into<String>, scopes: &[(u8, &str)]) -> Self {
        let captures = scopes.iter().map(|(group, scope)| (*group, capture(scope)));
        Rule {
            r#match: pattern.into(),
            captures: captures.collect(),
            ..Rule::default()
        }
    }

    /// Returns a rule from a beginning to an end, with rules inside.
    pub(crate) fn stretch(
        begin: impl Into<String>,
        end: impl Into<String>,
        patterns: Vec<Rule>,
    ) -> Self {
        Rule {
            begin: begin.into(),
            end: end.into(),
            patterns,
            ..Rule::default()
        }
    }

    /// The rules of the grammar under a name.
    pub(crate) fn include(name: &str) -> Self {
        Rule {
            include: format!("#{name}"),
            ..Rule::default()
        }
    }

    /// Only a list of rules.
    pub(crate) fn list(patterns: Vec<Rule>) -> Self {
        Rule {
            patterns,
            ..Rule::default()
        }
    }

    pub(crate) fn begins_with(mut self, group: u8, scope: &str) -> Self {
        self.begin_captures.insert(group, capture(scope));
        self
    }

    pub(crate) fn ends_with(mut self, group: u8, scope: &str) -> Self {
        self.end_captures.insert(group, capture(scope));
        self
    }

    pub(crate) fn holds(mut self, scope: &str) -> Self {
        self.content_name = named(scope);
        self
    }
}
