//! The client: its capabilities and settings, and positions in the encoding of columns that was agreed with it.

use crate::Edit;
use gen_lsp_types::{Position, Range, TextEdit};
use serde_json::Value;
use tipc::message::Lang;
use tipc::source::{self, Source, Span, Unit};

/// The capabilities and settings of a client.
#[derive(Clone, Debug)]
pub(crate) struct Client {
    /// The unit of columns.
    pub(crate) unit: Unit,
    pub(crate) lang: Lang,
    /// It accepts snippets in completions.
    pub(crate) has_snippets: bool,
    /// It shows related information with diagnostics.
    pub(crate) has_related: bool,
    /// It links the codes of diagnostics to pages.
    pub(crate) has_pages: bool,
    /// It can be asked to watch files.
    pub(crate) can_watch: bool,
    /// The robot of its settings.
    pub(crate) robot: Option<String>,
    /// The process that it is, or that started the server for it.
    pub(crate) process: Option<u32>,
}

/// The supported encodings of positions.
const ENCODINGS: [(&str, Unit); 3] = [
    ("utf-8", Unit::Utf8),
    ("utf-32", Unit::Character),
    ("utf-16", Unit::Utf16),
];

impl Client {
    /// Reads the parameters of `initialize`. Missing and malformed capabilities count as absent.
    pub(crate) fn new(params: &Value) -> Self {
        let can = |path: &str| {
            let found = params.pointer(&format!("/capabilities/{path}"));
            found.and_then(Value::as_bool).unwrap_or_default()
        };
        let encodings = params.pointer("/capabilities/general/positionEncodings");
        let encodings: Vec<&str> = encodings
            .and_then(Value::as_array)
            .map(|all| all.iter().filter_map(Value::as_str).collect())
            .unwrap_or_default();
        // The client lists them in its order of preference.
        let unit = encodings.iter().find_map(|name| unit(name));
        let locale = params.get("locale").and_then(Value::as_str);
        let publish = "textDocument/publishDiagnostics";
        Client {
            unit: unit.unwrap_or(Unit::Utf16),
            lang: locale.map_or(Lang::English, Lang::of),
            has_snippets: can("textDocument/completion/completionItem/snippetSupport"),
            has_related: can(&format!("{publish}/relatedInformation")),
            has_pages: can(&format!("{publish}/codeDescriptionSupport")),
            can_watch: can("workspace/didChangeWatchedFiles/dynamicRegistration"),
            robot: params
                .get("initializationOptions")
                .and_then(configured_robot),
            process: params
                .get("processId")
                .and_then(Value::as_u64)
                .and_then(|process| process.try_into().ok()),
        }
    }

    /// Returns the name of the agreed encoding of positions.
    pub(crate) fn encoding(&self) -> &'static str {
        let mut encodings = ENCODINGS.iter();
        let found = encodings.find(|(_, unit)| *unit == self.unit);
        found.map_or("utf-16", |(name, _)| name)
    }
}

fn unit(name: &str) -> Option<Unit> {
    let mut encodings = ENCODINGS.iter();
    encodings
        .find(|(known, _)| *known == name)
        .map(|(_, unit)| *unit)
}

/// Returns the robot of settings: `robot`, at the top or in a section `tip`.
pub(crate) fn configured_robot(settings: &Value) -> Option<String> {
    let mut found = ["/robot", "/tip/robot"]
        .iter()
        .filter_map(|path| settings.pointer(path)?.as_str());
    found
        .next()
        .filter(|name| !name.is_empty())
        .map(str::to_owned)
}

/// Conversions between byte offsets of a text and positions of the protocol.
#[derive(Clone, Copy)]
pub(crate) struct Positions<'a> {
    pub(crate) source: &'a Source,
    pub(crate) unit: Unit,
}

impl Positions<'_> {
    pub(crate) fn position(self, offset: usize) -> Position {
        let position = self.source.position(offset, self.unit);
        let line = position.line - 1;
        Position {
            line,
            character: position.column - 1 + self.mark(line),
        }
    }

    pub(crate) fn range(self, span: Span) -> Range {
        Range {
            start: self.position(span.start),
            end: self.position(span.end),
        }
    }

    /// Returns the offset of a position; a column after the end of its line counts as that end.
    pub(crate) fn offset(self, position: Position) -> usize {
        let column = position.character.saturating_sub(self.mark(position.line));
        let position = source::Position {
            line: position.line.saturating_add(1),
            column: column.saturating_add(1),
        };
        self.source.offset(position, self.unit)
    }

    /// Returns the span of a range; a range that ends before it begins is empty.
    pub(crate) fn span(self, range: Range) -> Span {
        let start = self.offset(range.start);
        Span::new(start, self.offset(range.end).max(start))
    }

    /// Returns the number of columns of a line before its text: most editors do not show a byte order mark of UTF-8.
    fn mark(self, line: u32) -> u32 {
        match (line, self.source.mark().len(), self.unit) {
            (1.., ..) | (_, 0, _) => 0,
            (_, bytes, Unit::Byte | Unit::Utf8) => bytes as u32,
            (_, _, Unit::Utf16 | Unit::Character) => 1,
        }
    }

    pub(crate) fn edits(self, edits: &[Edit]) -> Vec<TextEdit> {
        let edits = edits.iter().map(|edit| TextEdit {
            range: self.range(edit.span),
            new_text: edit.text.clone(),
        });
        edits.collect()
    }
}
