//! Judgement of a case.
#![expect(clippy::disallowed_methods, reason = "tests read their cases")]

use crate::clauses;
use crate::compare::matches;
use crate::run::{both, run};
use crate::stops::{self, Stop};
use case_files::{Settings, root};
use std::fs;
use tip_sim::{Interpreter, ProgramRunner};
use tipc::code::Level;
use tipc::diagnostic::Diagnostic;
use tipc::message::{Message, Naming};
use tipc::render;

/// The generated code of a program by [`Settings::key`]; `None` if it does not load.
pub type Compiled = fn(&str) -> Option<ProgramRunner>;

/// Runs a case on the interpreter, and on the generated code if there is some: each gives the expected trace, and both
/// give the same one.
///
/// # Panics
/// They do not, or the case is not what a case has to be.
pub fn traced(case: &str, compiled: Option<Compiled>) {
    let expectation = Expectation::read(case, "trace");
    for settings in &expectation.settings {
        let program = expectation.program(case, settings);
        let compiled = compiled.map(|compiled| engine(compiled, case, settings));
        let trace = trace(program, compiled, settings);
        let records: Vec<String> = trace.lines().map(without_state).collect();
        let records: Vec<&str> = records.iter().map(String::as_str).collect();
        if let Err(difference) = matches(&expectation.body(), &records) {
            let robot = settings.load.robot.name();
            let records = records.join("\n");
            panic!("{robot}: {difference}\n\nthe whole trace:\n{records}");
        }
    }
}

/// Runs a case, on both engines if there is generated code, once for each line that is expected to stop it: there it
/// stops, with that error. If no line is wanted it comes to its END.
///
/// # Panics
/// It does not, or the case is not what a case has to be.
pub fn stopped(case: &str, compiled: Option<Compiled>) {
    let expectation = Expectation::read(case, "stops");
    for settings in &expectation.settings {
        let robot = settings.load.robot.name();
        let program = expectation.program(case, settings);
        let line = |step: u32| program.steps().get(step as usize).map(|step| step.line);
        let run = |settings: &Settings| {
            let compiled = compiled.map(|compiled| engine(compiled, case, settings));
            trace(program.clone(), compiled, settings)
        };
        for text in expectation.body() {
            let stop = Stop::parse(text).unwrap_or_else(|| panic!("no line and error: {text}"));
            let trace = run(&stop.settings(settings));
            let found = stops::emergency(&trace).map(|(step, error)| (line(step), error));
            let expected = Some((Some(stop.line), stop.error.to_owned()));
            let wanted = stop.line;
            assert_eq!(found, expected, "{robot}, line {wanted} wanted:\n{trace}");
        }
        let trace = run(&stops::wanting(0, settings));
        let ends = trace
            .lines()
            .last()
            .is_some_and(|end| end.contains("\"END\""));
        assert!(ends, "{robot}, no line wanted:\n{trace}");
    }
}

/// Compiles a case: it gives the expected diagnostics and no others.
///
/// # Panics
/// It does not, or the case is not what a case has to be.
pub fn checked(case: &str) {
    let expectation = Expectation::read(case, "check");
    for settings in &expectation.settings {
        let loaded = expectation.load(case, settings);
        let prefix = format!("{}:", loaded.source.name());
        let mut places: Vec<Diagnostic> = loaded.diagnostics.iter().flat_map(each_use).collect();
        places.sort_by_key(|place| (place.span, place.code));
        let told: Vec<String> = places
            .iter()
            .map(|diagnostic| render::classical(&loaded.source, diagnostic))
            .map(|line| line.strip_prefix(&prefix).unwrap_or(&line).to_owned())
            .collect();
        let expected = match expectation.body().as_slice() {
            ["ok"] => Vec::new(),
            lines => lines.to_vec(),
        };
        assert_eq!(told, expected, "{}", settings.load.robot.name());
    }
}

/// A finding; of a name that is not declared, one at each place that uses it.
pub fn each_use(finding: &Diagnostic) -> Vec<Diagnostic> {
    let also = Message::from(Naming::AlsoHere);
    let uses = finding.labels.iter().filter(|label| label.text == also);
    let mut places = vec![finding.clone()];
    places.extend(uses.map(|label| {
        let mut place = finding.clone();
        place.span = label.span;
        place
    }));
    places
}

fn engine(compiled: Compiled, case: &str, settings: &Settings) -> ProgramRunner {
    compiled(&settings.key(case)).expect("a case that loads was compiled")
}

/// The trace of a program, states included; that of its generated code, if there is some, is the same.
fn trace(
    program: tipc::program::Program,
    compiled: Option<ProgramRunner>,
    settings: &Settings,
) -> String {
    let trace = match compiled {
        Some(compiled) => both(program, compiled, settings),
        None => run(Interpreter::new(program), settings),
    };
    trace.unwrap_or_else(|error| panic!("{error}"))
}

/// A record without the hash of commands and measurements.
fn without_state(record: &str) -> String {
    match record.split_once(",\"state\":") {
        Some((before, _)) => format!("{before}}}"),
        None => record.to_owned(),
    }
}

/// Expected result of a case.
struct Expectation {
    text: String,
    /// One for each robot.
    settings: Vec<Settings>,
}

impl Expectation {
    /// Reads the file beside a case and insists on what makes it one: it is the only one, it names
    /// clauses that exist, and it says something.
    fn read(case: &str, extension: &str) -> Self {
        let path = |extension: &str| root().join("cases").join(format!("{case}.{extension}"));
        let text = fs::read_to_string(path(extension)).unwrap_or_else(|error| {
            panic!("neither .trace nor .stops nor .check is beside the program: {error}")
        });
        let kinds = ["trace", "stops", "check"].map(|kind| path(kind).exists());
        let kinds = kinds.into_iter().filter(|exists| *exists).count();
        assert_eq!(kinds, 1, "a case expects one thing");
        let named = clauses::of_header(&text);
        assert!(!named.is_empty(), "the header names no clause");
        let known = clauses::of_reference();
        for clause in &named {
            assert!(
                known.contains(clause),
                "the reference has no clause {clause}"
            );
        }
        let beside = path(extension);
        let beside = beside.parent().expect("a case stands in a folder");
        let settings = Settings::of_header(&text, beside).unwrap_or_else(|error| panic!("{error}"));
        let expectation = Expectation { text, settings };
        let says = expectation.body().iter().any(|line| *line != "...");
        assert!(says, "the case expects nothing");
        expectation
    }

    fn body(&self) -> Vec<&str> {
        let lines = self.text.lines().skip_while(|line| line.starts_with('#'));
        lines.filter(|line| !line.is_empty()).collect()
    }

    fn load(&self, case: &str, settings: &Settings) -> tipc::Loaded {
        let path = root().join("cases").join(format!("{case}.prg"));
        let bytes = fs::read(path).unwrap_or_else(|error| panic!("{error}"));
        tip_lint::load_all_errors(&format!("{case}.prg"), &bytes, &settings.load)
    }

    fn program(&self, case: &str, settings: &Settings) -> tipc::program::Program {
        let loaded = self.load(case, settings);
        let told: Vec<String> = loaded
            .diagnostics
            .iter()
            .filter(|diagnostic| diagnostic.level() == Level::Error)
            .map(|diagnostic| render::classical(&loaded.source, diagnostic))
            .collect();
        let told = told.join("\n");
        loaded
            .program
            .unwrap_or_else(|| panic!("it does not load:\n{told}"))
    }
}
