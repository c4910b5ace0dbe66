//! Cycle counts as a table for people, and as lines for tools.

use super::{Part, Parts, Sampling, Span, Stop, line_with, sampling_set};
use std::fmt::Write;
use tip_runtime::printable::Printable;
use tipc::language::Keyword;
use tipc::program::{Op, Program, StepId};
use tipc::render::{push_member, push_number, push_string};

/// Note that counting ended early.
const MORE: &str = "further parts are not counted: their paths cross too often";

/// Returns a table: part, lines, cycles, ms at the robot's standard sampling time.
pub fn human(program: &Program, parts: &Parts, sampling: Sampling) -> String {
    let name = Printable::line(program.source_name());
    let robot = program.signature().robot;
    let mut out = format!("{name} for {robot}, {} ms a cycle\n", sampling.standard);
    if let Some(line) = sampling_set(program) {
        let note =
            format!("line {line} sets a sampling time: other times hold while it is in force\n");
        out += &note;
    }
    if let Some(note) = speed_up(program) {
        out = out + &note + "\n";
    }
    let mut rows = vec![["part", "lines", "cycles", "ms", ""].map(str::to_owned)];
    rows.extend(
        parts
            .counted
            .iter()
            .map(|part| row(program, part, sampling)),
    );
    let width = |column: usize| {
        let widths = rows.iter().map(|row| row[column].chars().count());
        widths.max().unwrap_or_default()
    };
    let widths: Vec<usize> = (0..5).map(width).collect();
    for row in &rows {
        let mut line = String::new();
        for (cell, width) in row.iter().zip(&widths) {
            line += cell;
            line += &" ".repeat(width - cell.chars().count() + 2);
        }
        out += line.trim_end();
        out.push('\n');
    }
    if parts.has_more {
        out = out + MORE + "\n";
    }
    out
}

/// Returns one line a part: `FILE:LINE: part: cycles`; a last one without a line of the file if there are more.
pub fn short(program: &Program, parts: &Parts, sampling: Sampling) -> String {
    let lines = parts.counted.iter().map(|part| {
        let [what, _, cycles, ms, waits] = row(program, part, sampling);
        let line = line_of(program, part.first_step(program));
        let waits = if waits.is_empty() { "" } else { ", waits" };
        let name = Printable::line(program.source_name());
        let plural = if cycles == "1" { "" } else { "s" };
        format!("{name}:{line}: {what}: {cycles} cycle{plural}, {ms} ms{waits}\n")
    });
    let more = parts.has_more.then(|| MORE.to_owned());
    let notes = speed_up(program).into_iter().chain(more).map(|note| {
        let name = Printable::line(program.source_name());
        format!("{name}: {note}\n")
    });
    lines.chain(notes).collect()
}

/// Returns one object a line: `part` (`subroutine`, `turn`, `stretch`), `name`, `file`, `line`, of a stretch `to`, of
/// a FOR over constants `turns`, then `min`, `max` (absent without bound), `min_ms`, `max_ms` and `waits`. A last
/// object without `part`, with `file` and `note`, if there are more, and one if the program sets the steps of a cycle.
pub fn json(program: &Program, parts: &Parts, sampling: Sampling) -> String {
    let objects = parts.counted.iter();
    let objects = objects.map(|part| object(program, part, sampling) + "\n");
    let more = parts.has_more.then(|| MORE.to_owned());
    let notes = speed_up(program).into_iter().chain(more).map(|note| {
        let mut out = String::from("{\"file\":");
        push_string(&mut out, program.source_name());
        push_member(&mut out, "note", &note);
        out + "}\n"
    });
    objects.chain(notes).collect()
}

fn object(program: &Program, part: &Part, sampling: Sampling) -> String {
    let first = part.first_step(program);
    let mut out = String::from("{\"part\":");
    push_string(&mut out, kind(&part.span));
    push_member(&mut out, "name", &begin(program, part));
    push_member(&mut out, "file", program.source_name());
    push_number(&mut out, "line", line_of(program, first));
    match &part.span {
        Span::Stretch { to, .. } => push_member(&mut out, "to", &end(program, *to)),
        Span::Turn {
            turns: Some(turns), ..
        } => push(&mut out, "turns", turns),
        Span::Turn { .. } | Span::Subroutine { .. } => {}
    }
    push(&mut out, "min", part.cycles.min);
    if let Some(max) = part.cycles.max {
        push(&mut out, "max", max);
    }
    push(&mut out, "min_ms", ms(part.cycles.min, sampling));
    if let Some(max) = part.cycles.max {
        push(&mut out, "max_ms", ms(max, sampling));
    }
    push(&mut out, "waits", part.cycles.waits);
    out.push('}');
    out
}

fn push(out: &mut String, key: &str, value: impl std::fmt::Display) {
    // Writing to a string cannot fail.
    let _ = write!(out, ",\"{key}\":{value}");
}

fn row(program: &Program, part: &Part, sampling: Sampling) -> [String; 5] {
    let first = part.first_step(program);
    let name = begin(program, part);
    let what = match &part.span {
        Span::Subroutine { .. } => format!("subroutine {name}"),
        Span::Turn {
            turns: Some(turns), ..
        } => format!("turn of {name}, {turns} in all"),
        Span::Turn { .. } => format!("turn of {name}"),
        Span::Stretch { to, .. } => format!("{name} to {}", end(program, *to)),
    };
    let first = line_of(program, first);
    let lines = match last_step(&part.span).map(|step| line_of(program, step)) {
        Some(last) if last != first => format!("{first}-{last}"),
        _ => first.to_string(),
    };
    let (min, max) = (part.cycles.min, part.cycles.max);
    let waits = if part.cycles.waits { "and waits" } else { "" };
    [
        what,
        lines,
        interval(min, max),
        interval(ms(min, sampling), max.map(|max| ms(max, sampling))),
        waits.to_owned(),
    ]
}

fn interval<T: PartialEq + std::fmt::Display>(min: T, max: Option<T>) -> String {
    match max {
        Some(max) if max == min => min.to_string(),
        Some(max) => format!("{min} to {max}"),
        None => format!("{min} or more"),
    }
}

fn ms(cycles: u64, sampling: Sampling) -> f64 {
    cycles as f64 * sampling.standard
}

fn kind(span: &Span) -> &'static str {
    match span {
        Span::Subroutine { .. } => "subroutine",
        Span::Turn { .. } => "turn",
        Span::Stretch { .. } => "stretch",
    }
}

fn last_step(span: &Span) -> Option<StepId> {
    match span {
        Span::Turn { steps, .. } => steps.last().copied(),
        Span::Stretch {
            to: Stop::Label(step),
            ..
        } => Some(*step),
        Span::Subroutine { .. } | Span::Stretch { .. } => None,
    }
}

fn line_of(program: &Program, step: StepId) -> u32 {
    program.steps()[step as usize].line
}

/// Returns the name of a part: the label at its first step, else the statement.
fn begin(program: &Program, part: &Part) -> String {
    let step = part.first_step(program);
    match (label(program, step), &part.span) {
        (Some(label), _) => label.to_owned(),
        (None, Span::Stretch { .. }) => "start".to_owned(),
        (None, Span::Subroutine { .. } | Span::Turn { .. }) => {
            program.steps()[step as usize].text.to_string()
        }
    }
}

fn label(program: &Program, step: StepId) -> Option<&str> {
    let labels = program.labels();
    let place = labels
        .binary_search_by_key(&step, |label| label.step)
        .ok()?;
    Some(&labels[place].name)
}

fn end(program: &Program, stop: Stop) -> String {
    match stop {
        Stop::Label(step) => label(program, step).unwrap_or_default().to_owned(),
        Stop::Return => Keyword::Return.to_string(),
        Stop::End => Keyword::End.to_string(),
        Stop::ThreadEnd => Keyword::ThreadEnd.to_string(),
    }
}

/// Returns the note about a program that sets how many steps a cycle runs.
fn speed_up(program: &Program) -> Option<String> {
    let line = line_with(program, |op| op == Op::SpeedUp)?;
    Some(format!(
        "line {line} sets the steps of a cycle: the counts are steps, which are cycles at one step a cycle"
    ))
}
