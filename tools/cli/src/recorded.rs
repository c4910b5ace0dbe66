//! A run that is recorded, for what shows it afterwards.

use super::arguments::{InputArguments, SourceArguments};
use super::error::Error;
use super::loader::{self, Subject};
use super::plant::Ours;
use super::run::{LONG_WAIT, said};
use super::{Status, interrupt, report, scene};
use crate::message::Running;
use clap::Args;
use std::path::{Path, PathBuf};
use tip_sim::Robot;
use tip_view::{Extent, Outcome, Pace, Recording};
use tipc::Loaded;

/// How long a run is recorded that nobody ends: minutes of the robot's time.
const MINUTES: f64 = 10.0;

/// What is run, and how.
#[derive(Debug, Args)]
pub(super) struct RecordedArguments {
    /// The program
    pub(super) file: PathBuf,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) inputs: InputArguments,
}

/// A run, and the robot that did it.
pub(super) struct Recorded {
    pub(super) recording: Recording,
    pub(super) robot: Robot,
}

impl Recorded {
    /// The exit status that belongs to the run's ending.
    pub(super) fn status(&self) -> Status {
        match self.recording.outcome {
            Outcome::Interrupted => Status::Interrupted,
            Outcome::Emergency(_) => Status::Emergency,
            Outcome::Program(_) | Outcome::Limit => Status::Success,
        }
    }
}

impl RecordedArguments {
    /// The files that are read.
    pub(super) fn files(&self) -> Vec<&Path> {
        let scene = self.inputs.scene.as_ref();
        let scene = scene.and_then(scene::SceneChoice::file);
        let robot = self.source.robot().file();
        [self.file.as_path()]
            .into_iter()
            .chain(robot)
            .chain(scene)
            .collect()
    }

    /// Runs the program until it ends, the time is over, or someone presses Ctrl-C; none if something was found, and
    /// reported.
    pub(super) fn record(&self, pace: Pace, why: Ours) -> Result<Option<Recorded>, Error> {
        let Some(Subject { loaded, robot, .. }) = self.load(&self.file, false, why)? else {
            return Ok(None);
        };
        let recording = self.run(&loaded, &robot, pace)?;
        interrupt::hold();
        self.say_wait(&recording);
        if let Outcome::Emergency(_) = recording.outcome {
            report::complain(&format!("{}\n", recording.outcome));
        }
        Ok(Some(Recorded { recording, robot }))
    }

    /// The program and the robot in its scene, with inputs that it has; none if something was found, and reported. The
    /// command takes our plants alone, and says why.
    pub(super) fn load(
        &self,
        program: &Path,
        quiet: bool,
        why: Ours,
    ) -> Result<Option<Subject>, Error> {
        interrupt::catch();
        let subject = loader::load(program, &self.source, &self.inputs, Some(why));
        let subject = loader::reported(subject, &self.source, quiet)?;
        Ok(subject.filter(|subject| subject.loaded.program.is_some()))
    }

    /// Runs a program that loads.
    pub(super) fn run(
        &self,
        loaded: &Loaded,
        robot: &Robot,
        pace: Pace,
    ) -> Result<Recording, Error> {
        let inputs = self.inputs.inputs();
        let extent = inputs
            .cycles
            .map_or(Extent::minutes(MINUTES), Extent::cycles);
        let goes_on = || !interrupt::is_requested();
        let recording = Recording::paced(loaded, robot, &inputs.events, extent, pace, goes_on);
        recording.map_err(|reason| Error::Usage(reason.to_string()))
    }

    /// Says what the program waited for at the end of a run, and why it ended if nobody asked for that.
    pub(super) fn say_wait(&self, recording: &Recording) {
        let lang = self.source.shown.lang();
        let wait = recording.wait.as_ref().map(said);
        let lasted = recording.time(recording.cycles);
        let is_cut_off =
            self.inputs.inputs().cycles.is_none() && recording.outcome == Outcome::Limit;
        let text = match wait {
            Some(wait) if is_cut_off && lasted < MINUTES * 60_000.0 => Running::StopsWaiting {
                wait,
                time: format!("{:.0}", LONG_WAIT / 1000.0),
            },
            Some(wait) if is_cut_off => Running::StopsInTimeWaiting {
                minutes: MINUTES.to_string(),
                wait,
            },
            None if is_cut_off => Running::StopsInTime {
                minutes: MINUTES.to_string(),
            },
            Some(wait) => Running::IsWaiting { wait },
            None => return,
        };
        report::complain(&format!("{}\n", text.in_lang(lang)));
    }
}
