//! Programs of older versions of the language to version 3.1 (T.I.P. 3.1 §1-1), and on to edition 3.2.
//!
//! Only changed words are replaced: comments, layout, encoding and the order of the steps stay. Every change is
//! reported with its line. If the text does not decide a change, the report has a question, and there is no result.

mod lines;
mod next;
mod statements;
mod variables;

use crate::message::{Loads, Migrating};
use crate::{Loaded, Options};
use lines::Piece;
use statements::Moves;
use std::collections::HashSet;
use std::fmt::Write;
use tip_runtime::printable::Printable;
use tipc::Robot;
use tipc::code::{Code, Level};
use tipc::diagnostic::{Diagnostic, Edit};
use tipc::language::Edition;
use tipc::language::commands::find;
use tipc::language::names::LIMIT;
use tipc::load::check_module;
use tipc::message::Lang;
use tipc::message::list::List;
use tipc::parse::header::{version_number, version_word};
use tipc::parse::parse;
use tipc::render::{push_member, push_number, push_string};
use tipc::source::{Encoding, Source, Span};
use tipc::syntax::{Module, Statement, StatementKind};
use variables::Variables;

/// The version that a migration leads to.
const CURRENT: f64 = 3.1;
/// The first version with declared variables, and with several statements on a line.
const DECLARED: f64 = 3.0;
/// The first version with a title in line 2.
const TITLED: f64 = 1.1;
/// A version that some older programs name, although the language never had it.
const ODD: f64 = 4.0;

/// Kind of a note: a change or a question.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NoteKind {
    /// A change that was made.
    Change,
    /// A decision that the text does not contain.
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

impl Note {
    fn new(kind: NoteKind, source: &Source, span: Span, text: Migrating) -> Self {
        let (line, column) = source.line_column(span.start);
        Note {
            kind,
            line,
            column,
            text,
        }
    }
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
        let bytes = self.bytes.as_deref().unwrap_or_default();
        robots(self.source.name(), bytes, self.encoding)
    }
}

/// Turns a program of an older version into one of version 3.1. `name` is how the report calls the file.
///
/// # Errors
///
/// The diagnostics about bytes that are not text, as [`load`](crate::load) reports them.
pub fn migrate(name: &str, bytes: &[u8], encoding: Encoding) -> Result<Migration, Box<Loaded>> {
    let (source, undecodable) = Source::decode(name, bytes, encoding);
    if let Some(fault) = undecodable {
        return Err(Box::new(Loaded::refused(source, vec![fault.into()])));
    }
    let mut migrator = Migrator {
        source: &source,
        edits: Vec::new(),
        notes: Vec::new(),
    };
    let older = migrator.program();
    let Migrator {
        edits, mut notes, ..
    } = migrator;
    let result = changed(&source, edits);
    if older {
        notes.extend(questions(&source, &result, encoding, &notes));
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
/// The diagnostics about bytes that are not text, as [`load`](crate::load) reports them.
pub fn migrate_to(
    edition: Edition,
    name: &str,
    bytes: &[u8],
    encoding: Encoding,
) -> Result<Migration, Box<Loaded>> {
    let (source, _) = Source::decode(name, bytes, encoding);
    let version = version_number(source.slice(version_word(&source)));
    if version == Some(Edition::V3_2.number()) {
        return Ok(Migration {
            source,
            encoding,
            notes: Vec::new(),
            bytes: Some(bytes.to_vec()),
        });
    }
    let mut migration = migrate(name, bytes, encoding)?;
    if edition < Edition::V3_2 {
        return Ok(migration);
    }
    let Some(older) = migration.bytes.take() else {
        return Ok(migration);
    };
    let (result, mut notes) = next::to_3_2(name, &older, encoding);
    // Lines are inserted after the title.
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

/// Loads a program for a robot, without lints.
fn load(name: &str, bytes: &[u8], encoding: Encoding, robot: Robot) -> Loaded {
    let options = Options {
        robot,
        encoding,
        ..Options::default()
    };
    tipc::load(name, bytes, &options)
}

fn robots(name: &str, bytes: &[u8], encoding: Encoding) -> Vec<Robot> {
    let loads = |robot: &Robot| load(name, bytes, encoding, *robot).program.is_some();
    Robot::ALL.iter().copied().filter(loads).collect()
}

/// Returns the bytes of the file with edits that do not overlap. Inserted text is ASCII, which is the same in both
/// encodings.
fn changed(source: &Source, mut edits: Vec<Edit>) -> Vec<u8> {
    edits.sort_by_key(|edit| edit.span);
    source.changed(edits.iter().map(|edit| (edit.span, edit.text.as_str())))
}

/// Returns a word in small letters if the old one is written so.
fn like(old: &str, new: &str) -> String {
    match old.contains(|c: char| c.is_ascii_uppercase()) {
        true => new.to_owned(),
        false => new.to_ascii_lowercase(),
    }
}

fn free_name(name: &str, taken: &HashSet<String>) -> String {
    let candidates = (1..).map(|number| {
        let ending = format!("_{number}");
        format!("{}{ending}", &name[..name.len().min(LIMIT - ending.len())])
    });
    let mut free = candidates.filter(|candidate| !taken.contains(candidate));
    free.next().unwrap_or_default()
}

/// Contents of line 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Header {
    /// Variables are typed by their names, as `VAR01`, and a line is one statement: before 3.0. `;` is an ordinary
    /// character of texts then.
    is_typed: bool,
    /// The first line that holds statements: 3, or 2 if there is no title.
    first_line: u32,
}

/// Collects edits and notes.
struct Migrator<'a> {
    source: &'a Source,
    edits: Vec<Edit>,
    notes: Vec<Note>,
}

impl Migrator<'_> {
    /// Applies every rule, in order; returns true if the program is of a known older version.
    fn program(&mut self) -> bool {
        let Some(header) = self.header() else {
            return false;
        };
        let is_typed = header.is_typed;
        let pieces = lines::read(self.source, header.first_line, is_typed);
        let variables = Variables::collect(self.source, &pieces, is_typed);
        self.labels(&pieces);
        let moves = Moves::of(self.source, &pieces);
        for statement in pieces.iter().filter_map(Piece::statement) {
            self.statement(statement, is_typed, &variables, &moves);
        }
        self.variables(&variables);
        self.declare(&variables, header.first_line);
        true
    }

    /// Changes line 1 to version 3.1. Returns `None` if nothing else is to be migrated.
    fn header(&mut self) -> Option<Header> {
        let location = version_word(self.source);
        let word = self.slice(location).to_owned();
        let Some(version) = version_number(&word) else {
            self.question(location, Migrating::WhichVersion);
            return None;
        };
        if version == CURRENT {
            return None;
        }
        let known = (1.0..CURRENT).contains(&version) || version == ODD;
        if !known {
            self.question(location, Migrating::UnknownVersion { version: word });
            return None;
        }
        self.edits.push(Edit::replace(location, "3.1"));
        self.change(location, Migrating::Version { version: word });
        let is_declared = match version == ODD {
            // The declarations of a program with version 4.0 show its real version.
            true => self.declares(),
            false => version >= DECLARED,
        };
        Some(Header {
            is_typed: !is_declared,
            first_line: if self.has_title(version) { 3 } else { 2 },
        })
    }

    fn declares(&self) -> bool {
        let pieces = lines::read(self.source, 3, false);
        let mut statements = pieces.iter().filter_map(Piece::statement);
        statements.any(|statement| statement.keyword.starts_with("DEF_"))
    }

    /// Returns true if line 2 is a title. Version 1.0 had no titles: a line 2 that looks like a statement is one there.
    fn has_title(&self, version: f64) -> bool {
        let pieces = lines::read(self.source, 2, true);
        let first = pieces.first().filter(|piece| piece.line() == 2);
        let is_statement = first.is_some_and(|piece| match piece {
            Piece::Label { .. } => true,
            Piece::Statement(statement) => {
                statement.is_equation() || statements::is_statement_word(&statement.keyword)
            }
        });
        version >= TITLED || !is_statement
    }

    fn slice(&self, span: Span) -> &str {
        self.source.slice(span)
    }

    fn change(&mut self, span: Span, text: Migrating) {
        let note = Note::new(NoteKind::Change, self.source, span, text);
        self.notes.push(note);
    }

    fn question(&mut self, span: Span, text: Migrating) {
        let note = Note::new(NoteKind::Question, self.source, span, text);
        self.notes.push(note);
    }

    /// Replaces a command word, in small letters if the program writes it so.
    fn rename(&mut self, keyword: Span, name: &str) {
        let name = like(self.slice(keyword), name);
        self.edits.push(Edit::replace(keyword, name));
    }
}

/// Asks about texts that are still not statements of version 3.1, on lines without a question.
fn questions(old: &Source, result: &[u8], encoding: Encoding, notes: &[Note]) -> Vec<Note> {
    let asked = notes.iter().filter(|note| note.kind == NoteKind::Question);
    let asked: HashSet<u32> = asked.map(|note| note.line).collect();
    let (source, _) = Source::decode(old.name(), result, encoding);
    // Lines are inserted only after the title, and they are right: only valid names are declared.
    let added = source.line_count() - old.line_count();
    let (module, found) = parse(&source, Some(3.1));
    let broken = found
        .iter()
        .filter(|diagnostic| diagnostic.level() == Level::Error)
        .map(|diagnostic| (diagnostic.span.start, explained(diagnostic)));
    let refused = refused_by_all(&source, &module);
    let unknown = module.statements.iter().zip(&refused);
    let unknown = unknown.filter_map(|(statement, refused)| {
        let StatementKind::Command {
            name, malformed, ..
        } = &statement.kind
        else {
            return None;
        };
        let text = match malformed {
            _ if find(&name.node).is_none() => Migrating::NoCommand {
                word: name.node.to_string(),
            },
            Some(fault) => explained(fault),
            None => explained(refused.as_ref()?),
        };
        Some((name.span.start, text))
    });
    let questions = broken.chain(unknown).map(|(start, text)| {
        let (line, column) = source.line_column(start);
        Note {
            kind: NoteKind::Question,
            line: if line > 2 { line - added } else { line },
            column,
            text,
        }
    });
    questions
        .filter(|note| !asked.contains(&note.line))
        .collect()
}

/// Returns for each statement why no robot takes its arguments, if none does.
fn refused_by_all(source: &Source, module: &Module) -> Vec<Option<Diagnostic>> {
    let mut refused: Vec<Option<Diagnostic>> = vec![None; module.statements.len()];
    let mut robots = vec![0; module.statements.len()];
    for robot in Robot::ALL {
        let mut found = check_module(source, module, *robot);
        found.retain(|one| matches!(one.code, Code::Argument | Code::UnknownCommand));
        let mut seen = vec![false; module.statements.len()];
        for fault in found {
            let location = fault.span.start;
            let before = |statement: &Statement| statement.span.start <= location;
            let behind = module.statements.partition_point(before);
            let Some(at) = behind.checked_sub(1) else {
                continue;
            };
            robots[at] += usize::from(!seen[at]);
            seen[at] = true;
            // An error of an argument on one robot tells more than that another robot lacks the command.
            if refused[at].is_none() || fault.code == Code::Argument {
                refused[at] = Some(fault);
            }
        }
    }
    for (refused, robots) in refused.iter_mut().zip(robots) {
        *refused = refused.take().filter(|_| robots == Robot::ALL.len());
    }
    refused
}

fn explained(diagnostic: &Diagnostic) -> Migrating {
    if diagnostic.code == Code::NoEnd {
        return Migrating::NoEnd;
    }
    Migrating::NoStatement {
        title: diagnostic.message().into(),
        reason: Box::new(diagnostic.reason.clone()),
    }
}

/// Returns every question with its line, or every change; one sentence at the end.
pub fn render_human(migration: &Migration, lang: Lang) -> String {
    let mut out = String::new();
    for note in &migration.notes {
        let source = &migration.source;
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{}", line(migration, note, lang));
        if note.kind == NoteKind::Question {
            let text = source.line_text(note.line).trim();
            let _ = writeln!(out, "    {}", Printable::line(text));
        }
    }
    let _ = writeln!(out, "{}", Printable::line(summary(migration).in_lang(lang)));
    out
}

fn summary(migration: &Migration) -> Migrating {
    let file = migration.source.name().to_owned().into();
    let (changes, questions) = (migration.changes().count(), migration.questions().count());
    match (changes, questions) {
        (0, 0) => {
            let source = &migration.source;
            let version = version_number(source.slice(version_word(source)));
            let version = Edition::of(version.unwrap_or_default());
            Migrating::AlreadyCurrent { file, version }
        }
        (_, 0) => Migrating::Migrated {
            file,
            changes: changes.into(),
            loads: loads(migration),
        },
        _ => Migrating::ToAnswer {
            file,
            questions: questions.into(),
        },
    }
}

fn loads(migration: &Migration) -> Loads {
    let robots = migration.robots();
    let robots: Vec<String> = robots.iter().map(|robot| robot.name().to_owned()).collect();
    match robots.is_empty() {
        true => Loads::ForNone,
        false => Loads::For {
            robots: List(robots),
        },
    }
}

/// Returns a line for each change, `FILE:LINE:COLUMN: change: <text>`, and each question, `…: question: <text>`.
pub fn render_short(migration: &Migration, lang: Lang) -> String {
    let notes = migration.notes.iter();
    notes
        .map(|note| line(migration, note, lang) + "\n")
        .collect()
}

fn line(migration: &Migration, note: &Note, lang: Lang) -> String {
    let name = migration.source.name();
    let (line, column, kind) = (note.line, note.column, note.kind.name());
    let text = note.text.in_lang(lang);
    Printable::line(format_args!("{name}:{line}:{column}: {kind}: {text}")).to_string()
}

/// Returns one object a line: `level` (`change` or `question`), `message`, `file`, `line`, `column`.
pub fn render_json(migration: &Migration, lang: Lang) -> String {
    let notes = migration.notes.iter();
    notes
        .map(|note| object(migration, note, lang) + "\n")
        .collect()
}

fn object(migration: &Migration, note: &Note, lang: Lang) -> String {
    let mut out = String::from("{\"level\":");
    push_string(&mut out, note.kind.name());
    push_member(&mut out, "message", &note.text.in_lang(lang).to_string());
    push_member(&mut out, "file", migration.source.name());
    push_number(&mut out, "line", note.line);
    push_number(&mut out, "column", note.column);
    out.push('}');
    out
}
