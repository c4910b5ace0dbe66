//! Observations of the cases: each is loaded, those that run are run, and each statement is found in the table.

use super::command::Statement;
use super::outcome::Outcome;
use super::row::Row;
use super::sentence;
use super::written::{Names, names};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use tip_sim::Interpreter;
use tip_tests::stops::{Stop, wanting};
use tip_tests::{Settings, each_use, root, run};
use tipc::diagnostic::Diagnostic;
use tipc::parse::parse;
use tipc::syntax::{self, Module, Operand, StatementKind};
use tipc::{Loaded, Robot};

/// The cases that show an outcome, by row, robot and outcome.
#[derive(Debug, Default)]
pub struct Seen(BTreeMap<(usize, &'static str, Outcome), BTreeSet<String>>);

impl Seen {
    /// The cases of a cell.
    pub fn cases(&self, row: usize, robot: Robot, outcome: Outcome) -> Option<&BTreeSet<String>> {
        self.0.get(&(row, robot.name(), outcome))
    }

    /// All cells that cases show, with their cases.
    pub fn all(&self) -> impl Iterator<Item = ((usize, &'static str, Outcome), &BTreeSet<String>)> {
        self.0.iter().map(|(cell, cases)| (*cell, cases))
    }

    /// Looks at every case.
    ///
    /// # Panics
    /// A case cannot be read or run.
    pub fn in_cases(rows: &[Row]) -> Self {
        let mut seen = Seen::default();
        for case in tip_tests::cases(&root().join("cases")) {
            for case in Case::read(&case) {
                case.watch(rows, &mut seen);
            }
        }
        seen
    }
}

struct Case {
    name: String,
    runs: Vec<Settings>,
    loaded: Loaded,
    module: Module,
    names: Names,
    robot: Robot,
}

impl Case {
    /// The case on each of its robots.
    fn read(name: &str) -> Vec<Self> {
        let path = |kind: &str| root().join("cases").join(format!("{name}.{kind}"));
        let read = |kind: &str| Some((kind.to_owned(), fs::read_to_string(path(kind)).ok()?));
        let found = ["trace", "stops", "check"].into_iter().find_map(read);
        let (kind, text) = found.unwrap_or_else(|| panic!("{name} expects nothing"));
        let program = path("prg");
        let beside = program.parent().expect("a case stands in a folder");
        let settings = Settings::of_header(&text, beside);
        let settings = settings.unwrap_or_else(|error| panic!("{name}: {error}"));
        let bytes = fs::read(&program).unwrap_or_else(|error| panic!("{name}: {error}"));
        let on = |settings: &Settings| {
            let loaded = tip_lint::load_all_errors(&format!("{name}.prg"), &bytes, &settings.load);
            let (module, _) = parse(&loaded.source, settings.load.tip_version);
            Case {
                names: names(&module),
                robot: settings.load.robot,
                runs: runs(&kind, &text, settings),
                name: name.to_owned(),
                loaded,
                module,
            }
        };
        settings.iter().map(on).collect()
    }

    fn watch(&self, rows: &[Row], seen: &mut Seen) {
        let mut note = |row: usize, outcome: Outcome| {
            // What an edition lacks is another statement in it.
            if rows[row].since() > self.module.edition {
                return;
            }
            let another = outcome.is_anywhere() || rows[row].is_part();
            if another && rows[row].possible(self.robot, outcome).is_err() {
                return;
            }
            let cell = seen.0.entry((row, self.robot.name(), outcome)).or_default();
            cell.insert(self.name.clone());
        };
        for diagnostic in self.loaded.diagnostics.iter().flat_map(each_use) {
            for (row, outcome) in self.refused(rows, &diagnostic) {
                note(row, outcome);
            }
        }
        for settings in &self.runs {
            for (row, outcome) in self.ran(rows, settings) {
                note(row, outcome);
            }
        }
    }

    /// Returns the subject of a diagnostic.
    fn refused(&self, rows: &[Row], diagnostic: &Diagnostic) -> Vec<(usize, Outcome)> {
        let code = diagnostic.code;
        let general = Outcome::of_code(code).or(match code {
            tipc::code::Code::Argument => Some(Outcome::Argument),
            _ => None,
        });
        let Some(general) = general else {
            return Vec::new();
        };
        // A special variable that the robot lacks is wrong in itself, whatever the form.
        let word = self.loaded.source.slice(diagnostic.span);
        if general == Outcome::Argument && word.contains('@') {
            return Vec::new();
        }
        if general == Outcome::NoEnd {
            return self
                .rows_of(rows, &[sentence::end()])
                .map(|row| (row, general))
                .collect();
        }
        let Some(statement) = self.statement_at(diagnostic) else {
            return Vec::new();
        };
        if let Some((name, arguments, malformed)) = as_command(statement) {
            let statement = self.command(arguments, malformed);
            return rows
                .iter()
                .enumerate()
                .filter_map(|(at, row)| match row {
                    Row::Command(form) if form.name == name => {
                        Some((at, statement.refusal(form, code)?))
                    }
                    _ => None,
                })
                .collect();
        }
        let forms = match &statement.kind {
            // Its first word is none of any form.
            StatementKind::Broken(_) if code == tipc::code::Code::UnknownCommand => Vec::new(),
            StatementKind::Broken(_) => {
                let text = self.loaded.source.slice(statement.span);
                sentence::meant(text, &self.names)
            }
            kind => {
                let mut forms = sentence::shown(kind, &self.names);
                if !sentence::condition_holds(kind, diagnostic.span.start) {
                    forms.retain(|form| form.name != sentence::CONDITION);
                }
                forms
            }
        };
        self.rows_of(rows, &forms)
            .map(|row| (row, general))
            .collect()
    }

    fn statement_at(&self, diagnostic: &Diagnostic) -> Option<&syntax::Statement> {
        let at = diagnostic.span.start;
        let holds =
            |statement: &&syntax::Statement| statement.span.start <= at && at <= statement.span.end;
        self.module.statements.iter().rev().find(holds)
    }

    /// Outcomes of the steps of a run.
    fn ran(&self, rows: &[Row], settings: &Settings) -> Vec<(usize, Outcome)> {
        let Some(program) = self.loaded.program.clone() else {
            return Vec::new();
        };
        let Ok(trace) = run(Interpreter::new(program), settings) else {
            return Vec::new();
        };
        let is_step = |statement: &&syntax::Statement| {
            !matches!(
                statement.kind,
                StatementKind::Define { .. } | StatementKind::Constant { .. }
            )
        };
        let (steps, declarations): (Vec<_>, Vec<_>) =
            self.module.statements.iter().partition(is_step);
        let mut ran = BTreeSet::new();
        let mut came = Vec::new();
        let mut motions: BTreeMap<char, &syntax::Statement> = BTreeMap::new();
        for record in trace.lines() {
            let step = number(record, "step").and_then(|step| steps.get(step));
            let error = text(record, "error");
            let outcome = match error {
                Some(error) => Outcome::of_emergency(error),
                None if number(record, "step") == number(record, "next") => None,
                None => Some(Outcome::Valid),
            };
            let (Some(step), Some(outcome)) = (step, outcome) else {
                continue;
            };
            // What happens to a moving leg belongs to its last motion command.
            let leg = error.and_then(leg_of);
            let motion = leg.and_then(|leg| motions.get(&leg)).copied();
            for statement in [Some(*step), motion].into_iter().flatten() {
                if ran.insert((statement.span, outcome)) {
                    came.extend(self.shown(rows, statement).map(|row| (row, outcome)));
                }
            }
            if let Some(leg) = leg_commanded(record) {
                motions.insert(leg, step);
            }
        }
        let declared = declarations
            .into_iter()
            .flat_map(|one| self.shown(rows, one));
        came.extend(
            declared
                .map(|row| (row, Outcome::Valid))
                .collect::<Vec<_>>(),
        );
        came
    }

    /// The rows whose form a statement has.
    fn shown<'a>(
        &'a self,
        rows: &'a [Row],
        statement: &'a syntax::Statement,
    ) -> Box<dyn Iterator<Item = usize> + 'a> {
        if let Some((name, arguments, malformed)) = as_command(statement) {
            let statement = self.command(arguments, malformed);
            let native = sentence::native_shown(arguments).filter(|_| name == "SPECIAL");
            let shows = move |row: &Row| match row {
                Row::Command(form) => form.name == name && statement.shows(form),
                Row::Sentence(form) => native.as_ref() == Some(form),
            };
            return Box::new((0..rows.len()).filter(move |at| shows(&rows[*at])));
        }
        let forms = sentence::shown(&statement.kind, &self.names);
        self.rows_of(rows, &forms)
    }

    fn rows_of<'a>(
        &self,
        rows: &'a [Row],
        forms: &[sentence::Sentence],
    ) -> Box<dyn Iterator<Item = usize> + 'a> {
        let forms = forms.to_vec();
        let is_one = move |row: &Row| match row {
            Row::Sentence(form) => forms.contains(form),
            Row::Command(_) => false,
        };
        Box::new((0..rows.len()).filter(move |at| is_one(&rows[*at])))
    }

    fn command<'a>(&'a self, arguments: &'a [Operand], malformed: bool) -> Statement<'a> {
        Statement {
            robot: self.robot,
            names: &self.names,
            arguments,
            malformed,
        }
    }
}

/// The runs of a case: one of a trace, one for each line that stops it, and none of what the compiler says.
fn runs(kind: &str, text: &str, settings: &Settings) -> Vec<Settings> {
    match kind {
        "trace" => vec![settings.clone()],
        "stops" => {
            let stops = text.lines().filter_map(Stop::parse);
            let wanted = stops.map(|stop| stop.settings(settings));
            std::iter::once(wanting(0, settings))
                .chain(wanted)
                .collect()
        }
        _ => Vec::new(),
    }
}

/// Name, arguments, and whether more that is malformed follows them.
fn as_command(statement: &syntax::Statement) -> Option<(&str, &[Operand], bool)> {
    match &statement.kind {
        StatementKind::Command {
            name,
            arguments,
            malformed,
        } => Some((&name.node, arguments, malformed.is_some())),
        _ => None,
    }
}

/// The leg that the command of a record acts on.
fn leg_commanded(record: &str) -> Option<char> {
    let command = record.split_once("\"cmd\":[")?.1;
    let words = command.split(&[',', ']']).take(3);
    words.map(|word| word.trim_matches('"')).find_map(leg_of)
}

/// The leg of a target, which may be the last word of a message.
fn leg_of(text: &str) -> Option<char> {
    let target = text.rsplit(' ').next()?;
    let digits = target.strip_prefix(['F', 'J'])?;
    digits.chars().next().filter(char::is_ascii_digit)
}

/// A whole number of a record.
fn number(record: &str, key: &str) -> Option<usize> {
    let rest = record.split_once(&format!("\"{key}\":"))?.1;
    let end = rest.find(|char: char| !char.is_ascii_digit())?;
    rest[..end].parse().ok()
}

/// A text of a record.
fn text<'a>(record: &'a str, key: &str) -> Option<&'a str> {
    let rest = record.split_once(&format!("\"{key}\":\""))?.1;
    rest.split_once('"').map(|(text, _)| text)
}
