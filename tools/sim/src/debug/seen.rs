//! What a debugger shows where it stands.

use super::Debugger;
use crate::message::Debugging;
use tip_runtime::controller::Mode;
use tipc::program::{Action, VariableKind};

/// A variable with its members.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Its name, upper case.
    pub name: String,
    /// Its type.
    pub kind: VariableKind,
    /// The names of its scalars as the language spells them, such as `P.X`, with their values; none while unassigned.
    pub scalars: Vec<(String, Option<f64>)>,
}

/// A routine that runs, or that waits for one that it called.
#[derive(Clone, Debug, PartialEq)]
pub struct Frame {
    /// The label or SUBROUTINE that was called; none for the program itself.
    pub name: Option<String>,
    /// The step that comes next, or the call that it waits for.
    pub step: u32,
    /// Its line, from 1.
    pub line: u32,
    /// Its column in characters, from 1.
    pub column: u32,
}

/// What a way of controlling a leg or joint is called.
pub fn control(mode: Mode) -> Debugging {
    match mode {
        Mode::Rest => Debugging::AtRest,
        Mode::Position => Debugging::Position,
        Mode::Compliance => Debugging::Compliance,
        Mode::Velocity => Debugging::Velocity,
        Mode::Effort => Debugging::Effort,
    }
}

impl Debugger {
    /// The step that comes next.
    pub fn step(&self) -> u32 {
        self.run.program().at()
    }

    /// Its line, from 1.
    pub fn line(&self) -> u32 {
        self.run.program().line(self.step())
    }

    /// All variables, `VAR_KEY` first.
    pub fn variables(&self) -> Vec<Variable> {
        let engine = self.run.program();
        let scalar = |place| {
            engine
                .scalar(place)
                .map(|(name, value)| (name.to_owned(), value))
        };
        let variables = self.program.variables().iter();
        let shown = variables.map(|variable| Variable {
            name: variable.name.clone(),
            kind: variable.kind,
            scalars: (variable.first..variable.first + variable.size())
                .filter_map(scalar)
                .collect(),
        });
        shown.collect()
    }

    /// The open calls, the innermost first, the program itself last.
    pub fn frames(&self) -> Vec<Frame> {
        let returns = Self::interpreter(&self.run).map_or(&[][..], |engine| engine.calls());
        let calls: Vec<u32> = returns.iter().map(|step| step.saturating_sub(1)).collect();
        let names = std::iter::once(None).chain(calls.iter().map(|call| self.called_by(*call)));
        let steps = calls.iter().copied().chain([self.step()]);
        let mut frames: Vec<Frame> = names
            .zip(steps)
            .map(|(name, step)| self.frame(name, step))
            .collect();
        frames.reverse();
        frames
    }

    fn frame(&self, name: Option<String>, step: u32) -> Frame {
        let place = self.program.steps().get(step as usize);
        let (line, column) = place.map_or((0, 0), |step| (step.line, step.column));
        Frame {
            name,
            step,
            line,
            column,
        }
    }

    /// What a step calls.
    fn called_by(&self, step: u32) -> Option<String> {
        let to = match &self.program.steps().get(step as usize)?.action {
            Action::Gosub { to } | Action::IfGosub { to, .. } => *to,
            _ => return None,
        };
        let label = self.program.labels().iter().find(|label| label.step == to);
        label.map(|label| label.name.clone())
    }

    /// What the program has said up to here: the cycle and the text of each message. Of very many only the last are kept.
    pub fn messages(&self) -> &[(u64, String)] {
        let until = self.said.partition_point(|(at, _)| *at < self.now);
        self.said.get(..until).unwrap_or_default()
    }

    /// The messages that the program said for the first time since this was asked last.
    pub fn news(&mut self) -> Vec<(u64, String)> {
        let news = self.said.get(self.taken..).unwrap_or_default().to_vec();
        self.taken = self.said.len();
        news
    }
}
