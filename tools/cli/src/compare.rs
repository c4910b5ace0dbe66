//! `tip compare`: the figures of two runs, with their differences and which is better.

use crate::arguments::RunArguments;
use crate::choices::Format;
use crate::error::Error;
use crate::message::{Comparing, Using};
use crate::record::{Reading, tell_apart};
use crate::report::fixed;
use crate::run::SummaryFormat;
use crate::{Action, Status, output, report};
use clap::Args;
use serde::Serialize;
use std::path::PathBuf;
use tip_runtime::printable::Printable;
use tip_sim::Summary;
use tip_sweep::Condition;
use tip_view::{Outcome, Recording};
use tipc::message::Lang;

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip compare walk.prg faster.prg              runs both
  tip run walk.prg --trace walk.jsonl --trace-motion
  tip compare walk.jsonl walk.prg              the trace of an earlier run, or of a real robot
  tip compare walk.prg faster.prg --fail-if 'speed<10' --fail-if 'falls>0'
  tip compare walk.prg faster.prg --format json

The figures are those of 'tip run'; docs/files.md lists their names and units. --fail-if is about OTHER.

Exit status: 0 done, 1 a program does not load or a file cannot be read, 2 wrong usage, 4 a condition of
--fail-if holds, 130 interrupted.")]
pub(super) struct Compare {
    #[command(flatten)]
    pub(super) run: RunArguments,

    /// The second program or trace
    #[arg(value_name = "OTHER")]
    other: PathBuf,

    /// The program of traces
    ///
    /// By default FILE.prg next to FILE.jsonl
    #[arg(long, value_name = "FILE.prg")]
    program: Option<PathBuf>,

    /// Exit with status 4 if a figure of OTHER is so
    ///
    /// A name, one of < <= > >= =, and a number
    #[arg(long, value_name = "CONDITION", value_parser = condition)]
    fail_if: Vec<Condition>,

    /// The table: text or json
    #[arg(long, value_name = "FORMAT", value_enum, default_value = "text")]
    format: SummaryFormat,
}

impl Action for Compare {
    fn complete(&mut self) -> Result<(), Error> {
        let program = self.reading().program(&self.run.file);
        self.run.complete(&program).map(drop)
    }

    fn format(&self) -> Option<Format> {
        Some(self.run.source.output_options.message_format)
    }

    fn execute(&self) -> Result<Status, Error> {
        compare(self)
    }
}

impl Compare {
    fn reading(&self) -> Reading<'_> {
        Reading {
            run: &self.run,
            program: self.program.as_deref(),
            is_alone: false,
            quiet: false,
            command: "compare",
        }
    }
}

/// Records both runs, and prints the table.
fn compare(arguments: &Compare) -> Result<Status, Error> {
    let lang = arguments.run.source.output_options.lang();
    let reading = arguments.reading();
    let files = [&*arguments.run.file, &*arguments.other];
    let mut runs = [reading.recording(files[0])?, reading.recording(files[1])?];
    let [one, other] = &mut runs;
    tell_apart([(one, files[0]), (other, files[1])]);
    if runs.iter().any(|run| run.outcome == Outcome::Interrupted)
        && crate::interrupt::is_requested()
    {
        return Ok(Status::Interrupted);
    }
    // The figures of a part of a run say nothing about the run.
    if let Some(cut) = runs.iter().find(|run| run.outcome == Outcome::Unknown) {
        let (file, cycle) = (cut.script.name.clone(), cut.cycles.to_string());
        return Err(Error::failed(Using::CutTrace { file, cycle }, lang));
    }
    let rows = rows(&runs[0].summary, &runs[1].summary);
    // A condition on a figure that the robot lacks is a mistake, not a success.
    for condition in &arguments.fail_if {
        if !rows
            .iter()
            .any(|row| row.name == condition.name && row.other.is_some())
        {
            let name = condition.name.clone();
            return Err(Error::usage(Using::NoFigure { name }, lang));
        }
    }
    output::print(match arguments.format {
        SummaryFormat::Text => {
            let diff = runs[0].program_diff(&runs[1]);
            let gap = if diff.is_empty() { "" } else { "\n" };
            table(&runs, &rows, lang) + gap + &Printable::lines(diff).to_string()
        }
        SummaryFormat::Json => json(&runs, &rows),
    })?;
    let held = (arguments.fail_if.iter()).filter(|condition| holds(condition, &rows));
    let mut status = Status::Success;
    for condition in held {
        report::say(
            Comparing::Fails {
                condition: condition.to_string(),
            },
            lang,
        );
        status = Status::Fell;
    }
    Ok(status)
}

/// The direction in which a figure is better.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
enum Better {
    More,
    Less,
}

/// The figures that can be compared: names and directions.
const FIGURES: [(&str, Better); 10] = [
    ("forward", Better::More),
    ("speed", Better::More),
    ("falls", Better::Less),
    ("margin", Better::More),
    ("slip", Better::Less),
    ("rate", Better::Less),
    ("torque", Better::Less),
    ("energy", Better::Less),
    ("cost", Better::Less),
    ("lift", Better::More),
];

/// Returns a figure with its unit, if the run has it.
fn figure(summary: &Summary, name: &str) -> Option<(f64, &'static str)> {
    let peak = |peak: &Option<tip_sim::Peak>| peak.as_ref().map(|peak| (peak.value, peak.unit));
    match name {
        "forward" => Some((summary.travel?.forward_mm, "mm")),
        "speed" => Some((summary.travel?.speed_mm_s, "mm/s")),
        "falls" => Some((f64::from(summary.falls?.count), "")),
        "margin" => peak(&summary.margin),
        "slip" => peak(&summary.slip),
        "rate" => peak(&summary.rate),
        "torque" => peak(&summary.torque),
        "energy" => Some((summary.energy?.work_j, "J")),
        "cost" => Some((summary.energy?.cost_of_transport?, "")),
        "lift" => summary.lifts.first().map(|lift| (lift.value, lift.unit)),
        _ => None,
    }
}

/// A figure of both runs.
#[derive(Serialize)]
struct Row {
    name: &'static str,
    unit: &'static str,
    one: Option<f64>,
    other: Option<f64>,
    /// The second less the first.
    difference: Option<f64>,
    better: Better,
}

fn rows(one: &Summary, other: &Summary) -> Vec<Row> {
    let rows = FIGURES.into_iter().filter_map(|(name, better)| {
        let [one, other] = [figure(one, name), figure(other, name)];
        let (_, unit) = one.or(other)?;
        let [one, other] = [one, other].map(|figure| figure.map(|(value, _)| value));
        Some(Row {
            name,
            unit,
            one,
            other,
            difference: one.zip(other).map(|(one, other)| other - one),
            better,
        })
    });
    rows.collect()
}

/// Parses a condition on one of the figures.
fn condition(text: &str) -> Result<Condition, Using> {
    let parsed = text.parse::<Condition>().ok();
    let is_known = |condition: &Condition| FIGURES.iter().any(|(name, _)| *name == condition.name);
    parsed.filter(is_known).ok_or_else(|| Using::NotACondition {
        text: text.to_owned(),
    })
}

/// Returns true if the condition holds for the second run.
fn holds(condition: &Condition, rows: &[Row]) -> bool {
    let row = rows.iter().find(|row| row.name == condition.name);
    let value = row.and_then(|row| row.other);
    value.is_some_and(|value| condition.holds(value))
}

fn decimals(name: &str) -> usize {
    match name {
        "falls" => 0,
        "cost" => 2,
        _ => 1,
    }
}

/// Returns the table for people.
fn table(runs: &[Recording; 2], rows: &[Row], lang: Lang) -> String {
    let [one, other] = runs
        .each_ref()
        .map(|run| Printable::line(&run.script.name).to_string());
    let difference = Comparing::Difference.in_lang(lang).to_string();
    let mut lines = vec![[String::new(), one, other, difference, String::new()]];
    for row in rows {
        let decimals = decimals(row.name);
        let shown = |value: Option<f64>| {
            value.map_or("-".to_owned(), |value| {
                format!("{} {}", fixed(value, decimals), row.unit)
                    .trim_end()
                    .to_owned()
            })
        };
        let change = row.difference.map(|change| fixed(change, decimals));
        let is_same = change
            .as_ref()
            .is_none_or(|text| text.trim_matches(['0', '.']).is_empty());
        let signed = change.map(|text| match is_same || text.starts_with('-') {
            true => text,
            false => format!("+{text}"),
        });
        let gains = row
            .difference
            .is_some_and(|change| (change > 0.0) == (row.better == Better::More));
        let verdict = match (is_same, gains, row.better) {
            (true, ..) => String::new(),
            (_, true, Better::More) => Comparing::BetterByMore.in_lang(lang).to_string(),
            (_, true, Better::Less) => Comparing::BetterByLess.in_lang(lang).to_string(),
            (_, false, Better::More) => Comparing::WorseByLess.in_lang(lang).to_string(),
            (_, false, Better::Less) => Comparing::WorseByMore.in_lang(lang).to_string(),
        };
        let difference = signed.unwrap_or_default();
        lines.push([
            row.name.to_owned(),
            shown(row.one),
            shown(row.other),
            difference,
            verdict,
        ]);
    }
    let widths = [0, 1, 2, 3].map(|at| {
        let cells = lines
            .iter()
            .map(|line: &[String; 5]| output::width(&line[at]));
        cells.max().unwrap_or(0)
    });
    let mut text = String::new();
    for line in &lines {
        let pad = |at: usize| " ".repeat(widths[at] - output::width(&line[at]));
        let [name, one, other, change, verdict] = line;
        let row = format!(
            "{name}{}  {}{one}  {}{other}  {}{change}  {verdict}",
            pad(0),
            pad(1),
            pad(2),
            pad(3)
        );
        text += row.trim_end();
        text.push('\n');
    }
    text
}

#[derive(Serialize)]
struct Ended<'a> {
    file: &'a str,
    end: String,
    #[serde(flatten)]
    summary: &'a Summary,
}

#[derive(Serialize)]
struct Report<'a> {
    runs: Vec<Ended<'a>>,
    figures: &'a [Row],
    diff: String,
}

/// Returns the table as a line of JSON.
fn json(runs: &[Recording; 2], rows: &[Row]) -> String {
    let ended = runs.iter().map(|run| Ended {
        file: &run.script.name,
        end: match &run.outcome {
            Outcome::Program(word) => word.clone(),
            Outcome::Interrupted | Outcome::Unknown => "INTERRUPTED".to_owned(),
            Outcome::Limit => "LIMIT".to_owned(),
            Outcome::Emergency(_) => "EMERGENCY".to_owned(),
        },
        summary: &run.summary,
    });
    let report = Report {
        runs: ended.collect(),
        figures: rows,
        diff: runs[0].program_diff(&runs[1]),
    };
    // No value of it can fail to be written.
    serde_json::to_string(&report).unwrap_or_default() + "\n"
}
