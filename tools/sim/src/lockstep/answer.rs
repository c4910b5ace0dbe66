//! Runs on request: each input line describes a run, and is answered by a line.

use super::{Compared, Divergence, Lockstep, LockstepObserver};
use crate::event::Inputs;
use crate::program_runner::StepTaken;
use serde::{Deserialize, Serialize};
use std::io::{self, BufRead, Write};
use tip_lint::coverage_points::{CoveragePoints, ProgramPoint};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tipc::program::Program;

/// The result for a requested run.
#[derive(Clone, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub enum Answer {
    /// Both engines did the same.
    Agreed {
        /// Number of cycles that were compared.
        cycles: u64,
        /// End of the run.
        end: RunEnd,
        /// The coverage points that no run before reached, by their indices in [`CoveragePoints::all`](tip_lint::coverage_points::CoveragePoints::all).
        new: Vec<usize>,
        /// Some cycles in which a step had an edge that no run has taken: another input may change the path there.
        chances: Vec<u64>,
    },
    /// The engines differ.
    Diverged(Divergence),
    /// The robot lacks a requested input.
    Refused(String),
}

/// The end of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
pub enum RunEnd {
    /// END or EXIT.
    Finished,
    /// The limit of cycles was reached.
    Limit,
    /// Emergency stop.
    Emergency,
}

/// A program in both forms, and the coverage points that its runs have reached.
#[derive(Clone, Debug)]
pub struct Session {
    lockstep: Lockstep,
    reach: ReachedPoints,
}

impl Session {
    /// Creates a session without runs.
    pub fn new(lockstep: Lockstep) -> Self {
        let reach = ReachedPoints::new(lockstep.program());
        Session { lockstep, reach }
    }

    /// Runs once.
    pub fn answer(&mut self, inputs: &Inputs) -> Answer {
        let compared = self.lockstep.run(inputs, &mut self.reach);
        let (new, chances) = self.reach.take_news();
        match compared {
            Err(refused) => Answer::Refused(refused.to_string()),
            Ok(Compared {
                divergence: Some(divergence),
                ..
            }) => Answer::Diverged(divergence),
            Ok(Compared { cycles, ending, .. }) => Answer::Agreed {
                cycles,
                end: match ending {
                    Some(Ending::Program(End::End | End::Exit)) => RunEnd::Finished,
                    Some(Ending::Emergency(_)) => RunEnd::Emergency,
                    Some(Ending::Limit | Ending::Interrupted) | None => RunEnd::Limit,
                },
                new,
                chances,
            },
        }
    }
}

/// Answers each line of `requests`, which is the text of [`Inputs`], by an [`Answer`] in a line of JSON.
///
/// # Errors
/// Requests cannot be read, or answers not be written.
pub fn serve(
    lockstep: Lockstep,
    requests: impl BufRead,
    mut answers: impl Write,
) -> io::Result<()> {
    let mut session = Session::new(lockstep);
    for request in requests.lines() {
        let answer = match request?.parse() {
            Ok(inputs) => session.answer(&inputs),
            Err(error) => Answer::Refused(error.to_string()),
        };
        serde_json::to_writer(&mut answers, &answer)?;
        writeln!(answers)?;
        answers.flush()?;
    }
    Ok(())
}

/// Maximum number of chances that are reported for a run.
const CHANCES: usize = 64;

/// The coverage points of a program that some run reached.
#[derive(Clone, Debug)]
pub struct ReachedPoints {
    points: CoveragePoints,
    seen: Vec<bool>,
    /// The points that the present run reached first.
    new: Vec<usize>,
    chances: Vec<u64>,
}

impl ReachedPoints {
    /// Creates an empty set.
    pub fn new(program: &Program) -> Self {
        let points = CoveragePoints::of(program);
        let seen = vec![false; points.all().len()];
        ReachedPoints {
            points,
            seen,
            new: Vec::new(),
            chances: Vec::new(),
        }
    }

    /// Returns the coverage points of the program.
    pub fn points(&self) -> &CoveragePoints {
        &self.points
    }

    /// Returns true if some run reached the point at this place among all.
    pub fn has(&self, point: usize) -> bool {
        self.seen.get(point).copied().unwrap_or_default()
    }

    /// Adds a point; returns true if no run reached it before.
    pub fn add(&mut self, point: usize) -> bool {
        let seen = self.seen.get_mut(point);
        seen.is_some_and(|seen| !std::mem::replace(seen, true))
    }

    /// Takes the points that the runs since the last call reached first, by places in
    /// [`CoveragePoints::all`]; and some cycles in which a step had an edge that no run went along yet, where
    /// another input may change the path.
    pub fn take_news(&mut self) -> (Vec<usize>, Vec<u64>) {
        (
            std::mem::take(&mut self.new),
            std::mem::take(&mut self.chances),
        )
    }

    /// Keeps a cycle if its step has an edge that no run has taken. If there are too many, every other one is dropped.
    fn chance(&mut self, cycle: u64, at: ProgramPoint) {
        if self.chances.last() == Some(&cycle) || self.points.edges(at).all(|edge| self.has(edge)) {
            return;
        }
        if self.chances.len() == CHANCES {
            let mut keep = false;
            self.chances.retain(|_| {
                keep = !keep;
                keep
            });
        }
        self.chances.push(cycle);
    }
}

impl LockstepObserver for ReachedPoints {
    fn went(&mut self, cycle: u64, StepTaken { from, to }: StepTaken) {
        let edge = to
            .filter(|to| *to != from)
            .and_then(|to| self.points.edge(from, to));
        for point in [self.points.step(from.step), edge].into_iter().flatten() {
            if self.add(point) {
                self.new.push(point);
            }
        }
        self.chance(cycle, from);
    }
}
