//! `--realtime`: each cycle takes as long as on the robot, and a line says how the robot is.

use super::super::interrupt;
use super::super::report;
use super::screen::Screen;
use super::summary::{line, status, tenths};
use crate::message::Running;
use crate::message::running::Figure;
use std::io::{self, IsTerminal};
use std::thread::sleep;
use std::time::{Duration, Instant};
use tip_runtime::realtime::Pacer;
use tip_sim::{Run, Waits};
use tipc::message::Lang;
use tipc::source::Source;

/// How often the line is written anew on a terminal, and elsewhere.
const ON_TERMINAL: Duration = Duration::from_millis(100);
const ELSEWHERE: Duration = Duration::from_secs(1);
/// A long cycle is interrupted so soon.
const NAP: Duration = Duration::from_millis(50);

/// Paces a run.
#[derive(Debug)]
pub(super) struct Live {
    pacer: Pacer,
    /// When the line is due; none if nothing is to be said.
    due: Option<Instant>,
    every: Duration,
    lang: Lang,
}

impl Live {
    /// From now on, with a legend of keys unless it is `quiet`.
    pub(super) fn begin(quiet: bool, lang: Lang) -> Self {
        if !quiet {
            let keys = match io::stdin().is_terminal() {
                true => Running::Keys,
                false => Running::NoKeys,
            };
            report::complain(&format!("{}\n", keys.in_lang(lang)));
        }
        let every = if io::stderr().is_terminal() {
            ON_TERMINAL
        } else {
            ELSEWHERE
        };
        Live {
            pacer: Pacer::start(),
            due: (!quiet).then(|| Instant::now() + every),
            every,
            lang,
        }
    }

    /// A cycle was simulated: says how the robot is, and waits until the cycle is over.
    pub(super) fn after(&mut self, run: &mut Run, waits: &Waits, source: &Source) {
        if self.due.is_some_and(|due| Instant::now() >= due) {
            self.due = Some(Instant::now() + self.every);
            let text = status(run, waits.now(run).as_ref(), source, self.lang);
            if let Some(screen) = run.console_mut::<Screen>() {
                screen.status(text);
            }
        }
        let over = self.pacer.due(run.period());
        loop {
            let left = over.saturating_duration_since(Instant::now());
            if left.is_zero() || interrupt::is_requested() {
                break;
            }
            sleep(left.min(NAP));
        }
    }

    /// A line for the summary.
    pub(super) fn pace(&self, lang: Lang) -> String {
        let pace = match self.pacer.overruns() {
            0 => Running::InTime,
            late => Running::Late {
                late: late.to_string(),
                all: self.pacer.cycles().to_string(),
                worst: tenths(self.pacer.worst().as_secs_f64() * 1000.0),
            },
        };
        line(Figure::Pace, &pace, lang)
    }
}
