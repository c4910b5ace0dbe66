//! Engines whose runs are counted: for a line of progress, and so that Ctrl-C ends them with a word about how far they came.

use super::super::error::Error;
use super::super::{interrupt, report};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::{self, IsTerminal};
use std::thread::sleep;
use std::time::Duration;
use tip_sim::Inputs;
use tip_sim::lockstep::Answer;
use tip_sim::search::Engines;

/// How often the line is drawn: Hz.
const RATE: u8 = 5;
const COMPARES: &str = "comparing {wide_bar} {pos} of {len} runs, {msg} cycles, {eta} left";
const SHRINKS: &str = "they differ: looking for the shortest inputs, {pos} runs so far";
/// The signal that ended cargo arrives here at about the same time.
const MOMENT: Duration = Duration::from_millis(100);

/// The first stage, on a terminal; cargo shows how far it is itself.
pub(super) fn building() {
    if io::stderr().is_terminal() {
        report::complain("building compiled code and interpreter with cargo (Ctrl-C ends it)\n");
    }
}

/// Ctrl-C was pressed during the first stage.
pub(super) fn interrupted_building(error: Error) -> Error {
    sleep(MOMENT);
    match interrupt::is_requested() {
        true => Error::Interrupted("while cargo built: nothing was compared".to_owned()),
        false => error,
    }
}

/// Engines, and the runs that they have made.
#[derive(Debug)]
pub(super) struct Watched<E> {
    engines: E,
    bar: ProgressBar,
    all: u64,
    runs: u64,
    cycles: u64,
    differ: bool,
}

impl<E> Watched<E> {
    /// For a search of `all` runs.
    pub(super) fn new(engines: E, all: u64) -> Self {
        let target = ProgressDrawTarget::stderr_with_hz(RATE);
        let bar = ProgressBar::with_draw_target(Some(all), target);
        bar.set_style(style(COMPARES));
        bar.set_message("0");
        Watched {
            engines,
            bar,
            all,
            runs: 0,
            cycles: 0,
            differ: false,
        }
    }

    fn count(&mut self, answer: &Answer) {
        self.runs += 1;
        match answer {
            Answer::Agreed { cycles, .. } => self.cycles += cycles,
            Answer::Diverged(_) if !self.differ => {
                self.differ = true;
                self.bar.set_style(style(SHRINKS));
            }
            Answer::Diverged(_) | Answer::Refused(_) => {}
        }
        self.bar.set_message(self.cycles.to_string());
        self.bar.set_position(self.runs);
    }

    fn interrupted(&self) -> Error {
        let (runs, all, cycles) = (self.runs, self.all, self.cycles);
        Error::Interrupted(match self.differ {
            true => "while looking for the shortest inputs: compiled code and interpreter DIFFER"
                .to_owned(),
            false => format!("after {runs} of {all} runs, {cycles} cycles: no difference so far"),
        })
    }
}

impl<E: Engines> Engines for Watched<E>
where
    Error: From<E::Error>,
{
    type Error = Error;

    fn ask(&mut self, inputs: &Inputs) -> Result<Answer, Error> {
        let answer = match interrupt::is_requested() {
            true => Err(self.interrupted()),
            false => self.engines.ask(inputs).map_err(Error::from),
        };
        match answer {
            // They were given up.
            Err(_) if interrupt::is_requested() => Err(self.interrupted()),
            Err(error) => Err(error),
            Ok(answer) => {
                self.count(&answer);
                Ok(answer)
            }
        }
    }
}

impl<E> Drop for Watched<E> {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

fn style(template: &str) -> ProgressStyle {
    let plain = ProgressStyle::default_bar();
    let style = ProgressStyle::with_template(template);
    style.unwrap_or(plain).progress_chars("=> ")
}
