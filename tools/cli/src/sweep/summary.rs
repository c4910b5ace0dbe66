//! The summary of a table, gathered row by row.

use crate::choices::quoted;
use crate::message::{Figure, Sweeping};
use crate::report::fixed;
use crate::run::line;
use std::time::Duration;
use tip_sweep::{Column, Front, Goal, Outcome, Ranking, Row};
use tipc::message::{Lang, Text};

/// Number of runs of a Pareto front that are listed.
const LISTED: usize = 10;

/// The figures of a table.
#[derive(Debug, Default)]
pub(super) struct Summary {
    /// Number of rows.
    pub(super) runs: u64,
    /// Number of runs in which the robot fell; `None` if falls are not counted.
    falls: Option<u64>,
    /// Number of runs in which two parts of the robot overlapped.
    collided: u64,
    /// Number of emergency stops.
    stopped: u64,
    /// Number of runs that were cut off.
    cut_off: u64,
    front: Front,
    worst: Option<Row>,
}

impl Summary {
    /// Returns the summary of a table without rows, whose runs are ranked so.
    pub(super) fn new(ranking: Ranking) -> Self {
        Summary {
            front: Front::new(ranking),
            ..Summary::default()
        }
    }

    /// Returns the goals and the conditions.
    pub(super) fn ranking(&self) -> &Ranking {
        self.front.ranking()
    }

    /// Adds a row.
    pub(super) fn add(&mut self, row: &Row) {
        self.runs += 1;
        if row.counts_falls() {
            *self.falls.get_or_insert(0) += u64::from(row.has_fallen());
        }
        self.collided += u64::from(row.has_collided());
        self.stopped += u64::from(row.is_stopped());
        self.cut_off += u64::from(row.is_cut_off());
        self.front.add(row);
        let outcome = row.outcome();
        if outcome == Outcome::Ended {
            return;
        }
        let worst = self.worst.as_ref();
        if worst.is_none_or(|worst| outcome.order(&worst.outcome()).is_lt()) {
            self.worst = Some(row.clone());
        }
    }

    /// Returns the number of runs in which the robot fell.
    pub(super) fn fell(&self) -> u64 {
        self.falls.unwrap_or(0)
    }

    /// Returns the number of runs in which two parts of the robot overlapped.
    pub(super) fn collided(&self) -> u64 {
        self.collided
    }

    /// Returns the summary of the table `name`; `made` is the number of runs that were made now, and their time.
    pub(super) fn text(
        &self,
        name: &str,
        is_stream: bool,
        until: f64,
        (made, elapsed): (u64, Duration),
        lang: Lang,
    ) -> String {
        let all = || self.runs.to_string();
        let share = |count: u64| Sweeping::Share {
            count: count.to_string(),
            all: all(),
            share: format!("{:.1}", 100.0 * count as f64 / self.runs.max(1) as f64),
        };
        let seconds = elapsed.as_secs_f64();
        let rate = made as f64 / seconds.max(1e-9);
        let digits = usize::from(rate < 10.0);
        let made = Sweeping::Made {
            file: name.to_owned().into(),
            runs: all(),
            made: made.to_string(),
            time: format!("{seconds:.1}"),
            rate: format!("{rate:.digits$}"),
        };
        let mut text = format!("{}\n", made.in_lang(lang));
        let mut add = |figure, value: Sweeping| text += &line(figure, value.in_lang(lang), lang);
        if let Some(falls) = self.falls {
            add(Figure::Falls, share(falls));
        }
        if self.stopped > 0 {
            add(Figure::Stops, share(self.stopped));
        }
        if self.cut_off > 0 {
            let (count, time) = (self.cut_off.to_string(), until.to_string());
            let all = all();
            add(Figure::CutOff, Sweeping::CutOff { count, all, time });
        }
        let goals = &self.ranking().goals;
        let best = self.front.rows();
        match (&*best, goals.len()) {
            (_, 0) => {}
            ([], _) => add(Figure::Best, Sweeping::NoneRanked),
            ([best], _) => {
                let result = goals_of(best, goals).into();
                text += &outstanding(Figure::Best, best, result, name, is_stream, lang);
            }
            (best, _) => {
                let (count, all) = (best.len().to_string(), all());
                add(Figure::Best, Sweeping::OnFront { count, all });
                for row in best.iter().take(LISTED) {
                    let one = case_of(row, goals_of(row, goals).into());
                    text += &format!("          {}\n", one.in_lang(lang));
                }
            }
        }
        if let Some(worst) = &self.worst {
            let result = result(worst.outcome()).in_lang(lang).to_string();
            text += &outstanding(Figure::Worst, worst, result.into(), name, is_stream, lang);
        }
        text
    }
}

/// Returns a run with its number and its values.
fn case_of(row: &Row, result: Text) -> Sweeping {
    let values = row
        .values()
        .map(|(name, value)| format!(", {name}={value}"));
    Sweeping::Outstanding {
        result,
        case: row.case().to_string(),
        values: values.collect::<String>().into(),
    }
}

/// Returns the line of a run, and the command that replays it.
fn outstanding(
    figure: Figure,
    row: &Row,
    result: Text,
    name: &str,
    is_stream: bool,
    lang: Lang,
) -> String {
    let mut text = line(figure, case_of(row, result).in_lang(lang), lang);
    if !is_stream {
        text += &format!(
            "          tip view {} --case {}\n",
            quoted(name),
            row.case()
        );
    }
    text
}

/// Returns the numbers of a run in the columns of the goals.
fn goals_of(row: &Row, goals: &[Goal]) -> String {
    let figures = goals.iter().map(|goal| {
        let mut columns = row.columns().iter();
        let unit = columns.find(|column| column.name == goal.name());
        let unit = unit.map_or("", |column: &Column| column.unit);
        let value = row.named(goal.name()).unwrap_or(f64::NAN);
        let digits = match unit {
            _ if value.fract() == 0.0 => 0,
            "mm" | "mm/s" | "deg" | "deg/s" => 1,
            _ => 3,
        };
        let figure = format!("{} {} {unit}", goal.name(), fixed(value, digits));
        figure.trim_end().to_owned()
    });
    figures.collect::<Vec<_>>().join(", ")
}

fn result(outcome: Outcome) -> Sweeping {
    let time = |seconds: f64| format!("{seconds:.3}");
    let length = |number: f64| fixed(number, 1);
    match outcome {
        Outcome::Fell(after) => Sweeping::FellAfter { time: time(after) },
        Outcome::Stopped(after) => Sweeping::StoppedAfter { time: time(after) },
        Outcome::Lifted(by) => Sweeping::Lifted { length: length(by) },
        Outcome::Walked(by) => Sweeping::Walked { speed: length(by) },
        // It is never the worst run.
        Outcome::Ended => Sweeping::Walked { speed: length(0.0) },
    }
}
