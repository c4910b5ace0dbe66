//! The summary of a table, gathered row by row.

use crate::choices::quoted;
use crate::message::{Figure, Sweeping};
use crate::run::line;
use std::time::Duration;
use tip_sweep::{Outcome, Row};
use tipc::message::Lang;

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
    best: Option<Row>,
    worst: Option<Row>,
}

impl Summary {
    /// Adds a row.
    pub(super) fn add(&mut self, row: &Row) {
        self.runs += 1;
        if row.counts_falls() {
            *self.falls.get_or_insert(0) += u64::from(row.has_fallen());
        }
        self.collided += u64::from(row.has_collided());
        self.stopped += u64::from(row.is_stopped());
        self.cut_off += u64::from(row.is_cut_off());
        let outcome = row.outcome();
        if outcome == Outcome::Ended {
            return;
        }
        let compared =
            |other: &Option<Row>| other.as_ref().map(|other| outcome.order(&other.outcome()));
        if compared(&self.worst).is_none_or(|order| order.is_lt()) {
            self.worst = Some(row.clone());
        }
        if compared(&self.best).is_none_or(|order| order.is_gt()) {
            self.best = Some(row.clone());
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
        let has_worked = |row: &&Row| !row.has_fallen() && !row.is_stopped();
        let best = self.best.iter().filter(has_worked);
        let best = best.map(|row| (Figure::Best, row));
        for (figure, row) in best.chain(self.worst.iter().map(|row| (Figure::Worst, row))) {
            let case = row.case().to_string();
            let values = row
                .values()
                .map(|(name, value)| format!(", {name}={value}"));
            let outstanding = Sweeping::Outstanding {
                result: result(row.outcome()).in_lang(lang).to_string().into(),
                case: case.clone(),
                values: values.collect::<String>().into(),
            };
            text += &line(figure, outstanding.in_lang(lang), lang);
            if !is_stream {
                text += &format!("          tip view {} --case {case}\n", quoted(name));
            }
        }
        text
    }
}

fn result(outcome: Outcome) -> Sweeping {
    let time = |seconds: f64| format!("{seconds:.3}");
    let length = |millimetres: f64| format!("{millimetres:.1}");
    match outcome {
        Outcome::Fell(after) => Sweeping::FellAfter { time: time(after) },
        Outcome::Stopped(after) => Sweeping::StoppedAfter { time: time(after) },
        Outcome::Lifted(by) => Sweeping::Lifted { length: length(by) },
        Outcome::Walked(by) => Sweeping::Walked { length: length(by) },
        Outcome::Ended => Sweeping::Walked {
            length: length(0.0),
        },
    }
}
