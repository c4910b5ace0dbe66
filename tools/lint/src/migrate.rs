//! Programs of older versions of the language to version 3.1 (T.I.P. 3.1 §1-1), and on to edition 3.2.
//!
//! The original bytes are kept and only spliced: comments, layout, encoding and the order of the steps stay as they
//! are. Every change is noted with its line. What cannot be decided from the text is a question, and then there is
//! no result.

mod commands;
mod declarations;
mod edits;
mod header;
mod labels;
mod lines;
mod message;
mod near;
mod next;
mod placeholders;
mod report;
mod variables;
mod verify;

pub use report::{render_human, render_json, render_short};

use crate::message::Migrating;
use crate::{Loaded, Options, load};
use edits::Edits;
use header::Header;
use lines::{Piece, Statement};
use near::Moves;
use tipc::Robot;
use tipc::language::Edition;
use tipc::parse::header::{version_number, version_word};
use tipc::source::{Encoding, Source, Span};

/// Kind of a note: a change or a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NoteKind {
    /// A change that was made.
    Change,
    /// Something that the text does not decide.
    Question,
}

impl NoteKind {
    /// Returns its name in reports.
    pub const fn name(self) -> &'static str {
        match self {
            NoteKind::Change => "change",
            NoteKind::Question => "question",
        }
    }
}

/// One line of the report.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// A change or a question.
    pub kind: NoteKind,
    /// The line of the old program, from 1.
    pub line: u32,
    /// The column on that line in characters, from 1.
    pub column: u32,
    /// The change and its reason, or the question.
    pub text: Migrating,
}

/// The result for an older program.
#[derive(Clone, Debug)]
pub struct Migration {
    source: Source,
    encoding: Encoding,
    notes: Vec<Note>,
    bytes: Option<Vec<u8>>,
}

impl Migration {
    /// Returns the old program's text.
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// Returns the new program in the encoding of the old one; `None` if a question is open.
    pub fn bytes(&self) -> Option<&[u8]> {
        self.bytes.as_deref()
    }

    /// Returns the report, in order of lines.
    pub fn notes(&self) -> &[Note] {
        &self.notes
    }

    /// Returns the changes.
    pub fn changes(&self) -> impl Iterator<Item = &Note> {
        self.of_kind(NoteKind::Change)
    }

    /// Returns the questions to decide first.
    pub fn questions(&self) -> impl Iterator<Item = &Note> {
        self.of_kind(NoteKind::Question)
    }

    fn of_kind(&self, kind: NoteKind) -> impl Iterator<Item = &Note> {
        self.notes.iter().filter(move |note| note.kind == kind)
    }

    /// Returns the robots that the new program loads for.
    pub fn robots(&self) -> Vec<Robot> {
        let Some(bytes) = &self.bytes else {
            return Vec::new();
        };
        let loads = |robot: &Robot| {
            let options = Options {
                robot: *robot,
                encoding: self.encoding,
                ..Options::default()
            };
            load(self.source.name(), bytes, &options).program.is_some()
        };
        Robot::ALL.iter().copied().filter(loads).collect()
    }
}

/// Turns a program of an older version into one of version 3.1. `name` is how the report calls the file.
///
/// # Errors
///
/// The diagnostics about bytes that are not text, as [`load`] reports them.
pub fn migrate(name: &str, bytes: &[u8], encoding: Encoding) -> Result<Migration, Box<Loaded>> {
    let (source, undecodable) = Source::decode(name, bytes, encoding);
    if let Some(fault) = undecodable {
        return Err(Box::new(Loaded::refused(source, vec![fault.into()])));
    }
    let mut migrator = Migrator {
        source: &source,
        edits: Edits::default(),
        notes: Vec::new(),
    };
    let older = migrator.program();
    let Migrator {
        edits, mut notes, ..
    } = migrator;
    let result = edits.apply(&source);
    if older {
        notes.extend(verify::questions(&source, &result, encoding, &notes));
    }
    notes.sort_by_key(|note| (note.line, note.column));
    let open = notes.iter().any(|note| note.kind == NoteKind::Question);
    Ok(Migration {
        source,
        encoding,
        notes,
        bytes: (!open).then_some(result),
    })
}

/// Turns a program of version 3.1 or an older one into one of an edition. `name` is how the report calls the file.
///
/// # Errors
///
/// The diagnostics about bytes that are not text, as [`load`] reports them.
pub fn migrate_to(
    edition: Edition,
    name: &str,
    bytes: &[u8],
    encoding: Encoding,
) -> Result<Migration, Box<Loaded>> {
    let says_next = || {
        let (source, _) = Source::decode(name, bytes, encoding);
        let version = version_number(source.slice(version_word(&source)));
        version == Some(Edition::V3_2.number())
    };
    let mut migration = match says_next() {
        true => unchanged(name, bytes, encoding),
        false => migrate(name, bytes, encoding)?,
    };
    if edition < Edition::V3_2 {
        return Ok(migration);
    }
    let Some(older) = migration.bytes.take() else {
        return Ok(migration);
    };
    let (result, mut notes) = next::to_3_2(name, &older, encoding);
    // Lines are put in behind the title.
    let (source, _) = Source::decode(name, &older, encoding);
    let added = source.line_count() - migration.source.line_count();
    for note in &mut notes {
        note.line -= if note.line > 2 { added } else { 0 };
    }
    migration.notes.extend(notes);
    migration.notes.sort_by_key(|note| (note.line, note.column));
    let is_open = migration.questions().next().is_some();
    migration.bytes = (!is_open).then_some(result);
    Ok(migration)
}

/// Returns the result for a program that is to stay as it is.
fn unchanged(name: &str, bytes: &[u8], encoding: Encoding) -> Migration {
    Migration {
        source: Source::decode(name, bytes, encoding).0,
        encoding,
        notes: Vec::new(),
        bytes: Some(bytes.to_vec()),
    }
}

/// Collects edits and notes.
struct Migrator<'a> {
    source: &'a Source,
    edits: Edits,
    notes: Vec<Note>,
}

impl Migrator<'_> {
    /// Applies every rule, in order; returns true if the program is of a known older version.
    fn program(&mut self) -> bool {
        let Some(Header { style, title }) = self.header() else {
            return false;
        };
        let pieces = lines::read(self.source, title.first_line(), style.single());
        let spelling = variables::Variables::collect(self.source, &pieces, style);
        self.labels(&pieces);
        let moves = Moves::of(self.source, &pieces);
        for statement in pieces.iter().filter_map(Piece::statement) {
            self.statement(statement, style, &spelling, &moves);
        }
        self.variables(&spelling);
        self.declare(&spelling, title);
        true
    }

    fn statement(
        &mut self,
        statement: &Statement,
        style: header::Style,
        variables: &variables::Variables,
        moves: &Moves,
    ) {
        match statement.keyword.as_str() {
            "MESSAGE" if style.typed() => self.message(statement, variables),
            "MESSAGE" => {}
            "REM" if style.typed() => self.remark(statement),
            "REM" => {}
            "DEF_VAR" | "DEF_POS" | "DEF_JOINT" => self.clashes(statement),
            "FOR" => self.for_statement(statement),
            "WAIT_NEAR" => self.wait_near(statement, variables, moves),
            _ if statement.is_equation() => self.sign(statement),
            _ => self.command(statement),
        }
    }

    /// Returns the text at `span`.
    fn slice(&self, span: Span) -> &str {
        self.source.slice(span)
    }

    /// Notes a change at `span`.
    fn change(&mut self, span: Span, text: Migrating) {
        self.note(NoteKind::Change, span, text);
    }

    /// Asks about `span`.
    fn question(&mut self, span: Span, text: Migrating) {
        self.note(NoteKind::Question, span, text);
    }

    fn note(&mut self, kind: NoteKind, span: Span, text: Migrating) {
        let (line, column) = self.source.line_column(span.start);
        self.notes.push(Note {
            kind,
            line,
            column,
            text,
        });
    }

    /// Puts another word in the place of a command word, in small letters if the program writes it so.
    fn rename(&mut self, keyword: Span, name: &str) {
        let small = !self
            .slice(keyword)
            .contains(|c: char| c.is_ascii_uppercase());
        let name = if small {
            name.to_ascii_lowercase()
        } else {
            name.to_owned()
        };
        self.edits.replace(keyword, name);
    }
}
