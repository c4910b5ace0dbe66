//! Diagnostics as one document of SARIF 2.1.0, the exchange format of static analysis
//! (<https://docs.oasis-open.org/sarif/sarif/v2.1.0/sarif-v2.1.0.html>).

use super::explain::page;
use super::output;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::Path;
use tip_lint::message::More;
use tipc::Loaded;
use tipc::code::{Code, Level};
use tipc::diagnostic::{Diagnostic, Fix};
use tipc::message::Lang;
use tipc::source::{Source, Span, Unit};

/// The address of the schema.
const SCHEMA: &str =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";

/// A document that collects the diagnostics of all files.
#[derive(Debug, Default)]
pub(super) struct Document {
    lang: Lang,
    artifacts: Vec<Value>,
    results: Vec<Value>,
    /// Notes about omitted diagnostics.
    notes: Vec<Value>,
    /// The first diagnostic of each code.
    rules: BTreeMap<&'static str, Diagnostic>,
}

impl Document {
    /// Returns an empty document with texts in a language.
    pub(super) fn new(lang: Lang) -> Self {
        Document {
            lang,
            ..Document::default()
        }
    }

    /// Adds a file and its diagnostics.
    pub(super) fn add(&mut self, loaded: &Loaded) {
        let file = File {
            source: &loaded.source,
            index: self.artifacts.len(),
            lang: self.lang,
        };
        self.artifacts.push(file.artifact());
        for diagnostic in &loaded.diagnostics {
            self.results.push(file.result(diagnostic));
            let rule = self.rules.entry(diagnostic.id());
            rule.or_insert_with(|| diagnostic.clone());
        }
        self.notes.extend(file.note(loaded.omitted.count()));
    }

    /// Returns the text of the document, with a line end.
    pub(super) fn text(mut self) -> String {
        let rules = self.rules.values().map(|one| rule(one, self.lang));
        let rules: Vec<Value> = rules.collect();
        let ids: Vec<&str> = self.rules.keys().copied().collect();
        for result in &mut self.results {
            let index = ids.iter().position(|id| result["ruleId"] == **id);
            result["ruleIndex"] = json!(index);
        }
        let mut document = json!({
            "$schema": SCHEMA,
            "version": "2.1.0",
            "runs": [{
                "tool": { "driver": {
                    "name": "tip",
                    "fullName": "tip, checker of T.I.P. robot programs",
                    "semanticVersion": env!("CARGO_PKG_VERSION"),
                    "rules": rules,
                } },
                "language": self.lang.pick("en", "ja"),
                "columnKind": "unicodeCodePoints",
                "artifacts": self.artifacts,
                "results": self.results,
            }],
        });
        if !self.notes.is_empty() {
            document["runs"][0]["invocations"] = json!([{
                "executionSuccessful": true,
                "toolExecutionNotifications": self.notes,
            }]);
        }
        output::escaped(&format!("{document:#}\n"))
    }
}

/// A file as the standard describes it.
struct File<'a> {
    source: &'a Source,
    /// Its index among the artifacts.
    index: usize,
    lang: Lang,
}

impl File<'_> {
    fn artifact(&self) -> Value {
        json!({
            "location": self.location(),
            "encoding": self.source.charset().name(),
        })
    }

    fn location(&self) -> Value {
        json!({ "uri": uri(self.source.name()), "index": self.index })
    }

    /// Returns the note about omitted diagnostics, if there are any.
    fn note(&self, omitted: usize) -> Option<Value> {
        let text = More::from(omitted).in_lang(self.lang).to_string();
        let note = json!({
            "level": "note",
            "message": { "text": text },
            "locations": [{ "physicalLocation": { "artifactLocation": self.location() } }],
        });
        (omitted > 0).then_some(note)
    }

    fn result(&self, diagnostic: &Diagnostic) -> Value {
        let mut result = json!({
            "ruleId": diagnostic.id(),
            "level": diagnostic.level().name(),
            "message": { "text": escaped(&text(diagnostic, self.lang)) },
            "locations": [self.place(diagnostic)],
            "properties": { "class": diagnostic.code.id(), "message": diagnostic.message() },
        });
        if let Some(kind) = diagnostic.code.kind() {
            result["properties"]["kind"] = json!(kind.name());
        }
        if !diagnostic.labels.is_empty() {
            let labels = diagnostic.labels.iter().map(|label| {
                let text = label.text.in_lang(self.lang).to_string();
                json!({
                    "physicalLocation": self.physical(label.span),
                    "message": { "text": escaped(&text) },
                })
            });
            result["relatedLocations"] = labels.collect();
        }
        if !diagnostic.fixes.is_empty() {
            result["fixes"] = diagnostic.fixes.iter().map(|fix| self.fix(fix)).collect();
        }
        result
    }

    fn fix(&self, fix: &Fix) -> Value {
        let replacements = fix.edits.iter().map(|edit| {
            json!({
                "deletedRegion": self.region(edit.span),
                "insertedContent": { "text": edit.text },
            })
        });
        let replacements: Vec<Value> = replacements.collect();
        json!({
            "description": { "text": escaped(&fix.title.in_lang(self.lang).to_string()) },
            "artifactChanges": [{
                "artifactLocation": self.location(),
                "replacements": replacements,
            }],
        })
    }

    /// Returns the location of a diagnostic; for a file that cannot be read, the file.
    fn place(&self, diagnostic: &Diagnostic) -> Value {
        match diagnostic.code {
            Code::FileNotFound => {
                json!({ "physicalLocation": { "artifactLocation": self.location() } })
            }
            _ => json!({ "physicalLocation": self.physical(diagnostic.span) }),
        }
    }

    fn physical(&self, span: Span) -> Value {
        json!({ "artifactLocation": self.location(), "region": self.region(span) })
    }

    /// Returns the region of a span: lines and columns from 1, the end after the last character; bytes of the file from 0.
    fn region(&self, span: Span) -> Value {
        let place = |offset| self.source.position(offset, Unit::Character);
        let (start, end) = (place(span.start), place(span.end));
        let first = self.source.file_offset(span.start);
        json!({
            "startLine": start.line,
            "startColumn": start.column,
            "endLine": end.line,
            "endColumn": end.column,
            "byteOffset": first,
            "byteLength": self.source.file_offset(span.end) - first,
        })
    }
}

/// Returns the message: the reason, and the help on the next line.
fn text(diagnostic: &Diagnostic, lang: Lang) -> String {
    let mut text = diagnostic.headline(lang);
    if diagnostic.level() == Level::Warning {
        text += &format!(": {}", diagnostic.reason.in_lang(lang));
    }
    if let Some(help) = &diagnostic.help {
        text += &format!("\n{}", help.in_lang(lang));
    }
    text
}

/// Returns the rule of a diagnostic.
fn rule(diagnostic: &Diagnostic, lang: Lang) -> Value {
    let id = diagnostic.id();
    let page = page(id, lang).unwrap_or_default();
    let title = page.lines().next().and_then(|line| line.split_once(": "));
    let title = title.map_or(id, |(_, title)| title);
    json!({
        "id": id,
        "shortDescription": { "text": escaped(title) },
        "help": { "text": escaped(page), "markdown": escaped(page) },
        "defaultConfiguration": { "level": diagnostic.level().name() },
    })
}

/// Escapes braces, which begin placeholders.
fn escaped(text: &str) -> String {
    text.replace('{', "{{").replace('}', "}}")
}

/// Returns the reference to a file (RFC 3986): relative if its path is.
pub(super) fn uri(name: &str) -> String {
    let mut uri = match (Path::new(name).is_absolute(), name.starts_with('/')) {
        (true, true) => "file://".to_owned(),
        (true, false) => "file:///".to_owned(),
        (false, _) => String::new(),
    };
    for byte in name.bytes() {
        match byte {
            b'\\' if cfg!(windows) => uri.push('/'),
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                uri.push(char::from(byte));
            }
            // Writing to a String cannot fail.
            _ => drop(write!(uri, "%{byte:02X}")),
        }
    }
    uri
}
