//! Watches: who assigns a variable.

use super::history::History;
use super::stop::{By, Reason};
use super::{Debugger, Refused};
use crate::event::{Event, Events};
use std::ops::Range;
use tip_runtime::program::VariableError;
use tipc::analysis::assigns;
use tipc::program::{Action, Program, Variable};

#[derive(Debug)]
struct Watch {
    id: u32,
    /// Upper case.
    names: Vec<String>,
    /// Whether a step assigns any of them.
    steps: Vec<bool>,
}

/// All watches.
#[derive(Debug, Default)]
pub(super) struct Watches(Vec<Watch>);

impl Watches {
    /// What the step of a cycle assigns, if the watch `only`, or any, is on it. Only KEY_IN may assign nothing: it waits.
    pub(super) fn assigned(
        &self,
        at: u64,
        only: Option<u32>,
        history: &History,
        program: &Program,
    ) -> Option<Reason> {
        let step = history.step(at);
        let assigns = |watch: &&Watch| watch.steps.get(step as usize).copied().unwrap_or(false);
        let watch = self.those(only).find(assigns)?;
        let action = program.steps().get(step as usize).map(|step| &step.action);
        let waits = matches!(action, Some(Action::KeyIn { .. })) && history.step(at + 1) == step;
        let assigns = !waits && !history.fails(at);
        assigns.then_some(Reason::Watch {
            id: watch.id,
            by: By::Step(step),
        })
    }

    /// What events assign before the step of a cycle, if the watch `only`, or any, is on it.
    pub(super) fn set(&self, at: u64, only: Option<u32>, events: &Events) -> Option<Reason> {
        if self.0.is_empty() {
            return None;
        }
        let all = events.all();
        let first = all.partition_point(|event| event.cycle < at);
        let here = all.iter().skip(first).take_while(|event| event.cycle == at);
        let watch = here.into_iter().find_map(|timed| match &timed.event {
            Event::Set(name, _) => (self.those(only)).find(|watch| watch.names.contains(name)),
            _ => None,
        })?;
        Some(Reason::Watch {
            id: watch.id,
            by: By::Event,
        })
    }

    /// One watch, or all.
    fn those(&self, only: Option<u32>) -> impl Iterator<Item = &Watch> {
        let is_meant = move |watch: &&Watch| only.is_none_or(|id| watch.id == id);
        self.0.iter().filter(is_meant)
    }
}

impl Debugger {
    /// Stops where a variable, or a member such as `P.X`, is assigned; gives the number of the watch.
    ///
    /// # Errors
    /// The program has no such variable.
    pub fn watch(&mut self, name: &str) -> Result<u32, Refused> {
        let name = name.trim().to_ascii_uppercase();
        let scalars = scalars(&self.program, &name)
            .ok_or(Refused::NoVariable(name, VariableError::Unknown))?;
        let names = self.program.scalar_names().skip(scalars.start);
        let names = names.take(scalars.len()).collect();
        let assigns = |action| {
            let assigned = assigns(&self.program, action);
            assigned.start < scalars.end && scalars.start < assigned.end
        };
        let steps = self.program.steps().iter();
        let steps = steps.map(|step| assigns(&step.action)).collect();
        let id = self.new_id();
        self.watches.0.push(Watch { id, names, steps });
        Ok(id)
    }

    /// Takes a watch away; says whether there was one.
    pub fn unwatch(&mut self, id: u32) -> bool {
        let before = self.watches.0.len();
        self.watches.0.retain(|watch| watch.id != id);
        self.watches.0.len() < before
    }

    /// Takes all watches away.
    pub fn unwatch_all(&mut self) {
        self.watches.0.clear();
    }
}

/// The places of a variable, or of a member, among all scalars.
fn scalars(program: &Program, name: &str) -> Option<Range<usize>> {
    let mut variables = program.variables().iter();
    let whole = |variable: &Variable| variable.first..variable.first + variable.size();
    let variable = variables.find(|variable| variable.name == name).map(whole);
    variable.or_else(|| {
        let member = program.scalar_names().position(|other| other == name)?;
        Some(member..member + 1)
    })
}
