//! The table as Markdown.

use super::observe::Seen;
use super::outcome::Outcome;
use super::row::Row;
use super::why;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use tipc::Robot;

/// How many cells there are of each sort.
#[derive(Clone, Debug, Default)]
pub struct Count {
    /// A case shows them.
    pub covered: usize,
    /// They cannot occur.
    pub impossible: usize,
    /// They can occur, and no case shows them: in words.
    pub empty: Vec<String>,
    /// Cases show what the rules call impossible: in words.
    pub contradictions: Vec<String>,
}

/// One line of a table: a row on a robot.
struct Line<'a> {
    row: &'a Row,
    robot: Robot,
    cells: Vec<(Outcome, Cell<'a>)>,
}

enum Cell<'a> {
    Covered(&'a BTreeSet<String>),
    Empty,
    Impossible(&'static str),
}

/// The document, and what it counts.
pub fn document(rows: &[Row], seen: &Seen) -> (String, Count) {
    let lines = lines(rows, seen);
    let count = count(&lines, rows, seen);
    let mut text = String::from(HEAD);
    for outcome in Outcome::ALL {
        writeln!(text, "| {} | {} |", outcome.heading(), outcome.meaning()).unwrap();
    }
    text.push_str("\n| in a cell | why it cannot occur |\n|---|---|\n");
    for (word, meaning) in why::WORDS {
        writeln!(text, "| *{word}* | {meaning} |").unwrap();
    }
    writeln!(
        text,
        "\n{} cells: {} covered, {} empty; {} more cannot occur.",
        count.covered + count.empty.len(),
        count.covered,
        count.empty.len(),
        count.impossible
    )
    .unwrap();
    let mut rest = &lines[..];
    while let Some(first) = rest.first() {
        let name = first.row.name();
        let here = rest
            .iter()
            .take_while(|line| line.row.name() == name)
            .count();
        let (section, behind) = rest.split_at(here);
        write_section(&mut text, name, section);
        rest = behind;
    }
    (text, count)
}

const HEAD: &str = "# Coverage

Every command in every form on every robot, each with all that can come of it: it runs, it is refused, or it stops the program.
A letter stands for a case in `tests/cases` that shows it, named below the table of its command; a plus says that there are more.
Every case that runs does so in both engines, and both give the same trace. What cannot occur says why, in italics; a column is left
out where it could occur in no form of the command. The test `coverage`
derives rows, columns and exceptions from the compiler's table of commands, finds what each case shows by loading and running
it, and compares this page; `TIP_BLESS=1 cargo test -p tip-tests --test it coverage` rewrites it.

S is a scalar operand, V a constant or VAR, F a foot or finger, J a joint; R and A stand before one value at least.

| column | the outcome of the statement |
|---|---|
";

fn lines<'a>(rows: &'a [Row], seen: &'a Seen) -> Vec<Line<'a>> {
    let mut lines = Vec::new();
    for (at, row) in rows.iter().enumerate() {
        for robot in Robot::ALL {
            let cell = |outcome: &Outcome| {
                let cell = match (
                    row.possible(*robot, *outcome),
                    seen.cases(at, *robot, *outcome),
                ) {
                    (Err(why), _) => Cell::Impossible(why),
                    (Ok(()), Some(cases)) => Cell::Covered(cases),
                    (Ok(()), None) => Cell::Empty,
                };
                (*outcome, cell)
            };
            lines.push(Line {
                row,
                robot: *robot,
                cells: Outcome::ALL.iter().map(cell).collect(),
            });
        }
    }
    lines
}

fn count(lines: &[Line<'_>], rows: &[Row], seen: &Seen) -> Count {
    let mut count = Count::default();
    for line in lines {
        let at = rows
            .iter()
            .position(|row| row == line.row)
            .unwrap_or_default();
        for (outcome, cell) in &line.cells {
            let name = || {
                let (name, text) = (line.row.name(), line.row.text());
                format!(
                    "{}: {name} {text}: {}",
                    line.robot.name(),
                    outcome.heading()
                )
            };
            match cell {
                Cell::Covered(_) => count.covered += 1,
                Cell::Empty => count.empty.push(name()),
                Cell::Impossible(why) => {
                    count.impossible += 1;
                    if let Some(cases) = seen.cases(at, line.robot, *outcome) {
                        count
                            .contradictions
                            .push(format!("{} ({why}) {cases:?}", name()));
                    }
                }
            }
        }
    }
    count
}

fn write_section(text: &mut String, name: &str, lines: &[Line<'_>]) {
    let columns: Vec<Outcome> = Outcome::ALL
        .iter()
        .copied()
        .filter(|outcome| lines.iter().any(|line| line.is_possible(*outcome)))
        .collect();
    let letters = letters(lines);
    let headings: Vec<&str> = columns.iter().map(|outcome| outcome.heading()).collect();
    writeln!(text, "\n## {name}\n").unwrap();
    writeln!(text, "| form | robot | {} |", headings.join(" | ")).unwrap();
    writeln!(text, "|---|---|{}", "---|".repeat(columns.len())).unwrap();
    for line in lines {
        let cells: Vec<String> = line
            .cells
            .iter()
            .filter(|(outcome, _)| columns.contains(outcome))
            .map(|(_, cell)| shown(cell, &letters))
            .collect();
        let form = match line.row.text() {
            form if form.is_empty() => "–".to_owned(),
            form => format!("`{form}`"),
        };
        writeln!(
            text,
            "| {form} | {} | {} |",
            line.robot.name(),
            cells.join(" | ")
        )
        .unwrap();
    }
    let mut cases: Vec<(&str, &String)> = letters
        .iter()
        .map(|(case, letter)| (*case, letter))
        .collect();
    cases.sort_by_key(|(_, letter)| (letter.len(), (*letter).clone()));
    let cases: Vec<String> = cases
        .iter()
        .map(|(case, letter)| format!("{letter} [{case}](../tests/cases/{case}.prg)"))
        .collect();
    if !cases.is_empty() {
        writeln!(text, "\n{}", cases.join(", ")).unwrap();
    }
}

impl Line<'_> {
    fn is_possible(&self, outcome: Outcome) -> bool {
        let mut cells = self.cells.iter();
        cells.any(|(of, cell)| *of == outcome && !matches!(cell, Cell::Impossible(_)))
    }
}

fn shown(cell: &Cell<'_>, letters: &BTreeMap<&str, String>) -> String {
    match cell {
        Cell::Covered(cases) => {
            let first = cases.iter().next().map_or("", String::as_str);
            let more = if cases.len() > 1 { "+" } else { "" };
            let letter = letters.get(first).map_or("", String::as_str);
            format!("{letter}{more}")
        }
        Cell::Empty => "**empty**".to_owned(),
        Cell::Impossible(why) => {
            let explained = why::WORDS.iter().any(|(word, _)| word == why);
            assert!(explained, "the legend lacks: {why}");
            format!("*{why}*")
        }
    }
}

/// A letter for the first case of each cell, in the order of the cells.
fn letters<'a>(lines: &[Line<'a>]) -> BTreeMap<&'a str, String> {
    let mut letters = BTreeMap::new();
    for (_, cell) in lines.iter().flat_map(|line| &line.cells) {
        if let Cell::Covered(cases) = cell
            && let Some(first) = cases.first()
        {
            let next = letter(letters.len());
            letters.entry(first.as_str()).or_insert(next);
        }
    }
    letters
}

/// a, b, … z, aa, ab, …
fn letter(at: usize) -> String {
    let last = char::from(b'a' + (at % 26) as u8);
    match at / 26 {
        0 => last.to_string(),
        more => format!("{}{last}", letter(more - 1)),
    }
}
