//! Breakpoints with their conditions and counts of passes, log points, which print a text instead of stopping a run,
//! and watches.

use super::expressions::{BreakCondition, LogText, Now};
use super::stop::{By, Hits, Reason};
use super::{DebugError, Debugger, History, MESSAGES};
use crate::event::{Event, Events};
use std::ops::Range;
use tip_runtime::program::VariableError;
use tipc::analysis::assigns;
use tipc::program::{Action, Program, Variable};

/// The circumstances under which a breakpoint stops a run.
#[derive(Clone, Copy, Debug, Default)]
pub struct When<'a> {
    /// A condition of the language, which may also name `CYCLE` and `TIME` (ms).
    pub condition: Option<&'a str>,
    /// The passes that count, among those where the condition holds; the text of [`Hits`].
    pub hits: Option<&'a str>,
}

/// A breakpoint that was placed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Placed {
    /// Its number, which no other breakpoint or watch has.
    pub id: u32,
    /// The line of its first step.
    pub line: u32,
    /// The column of its first step, in characters, from 1.
    pub column: u32,
}

#[derive(Debug)]
struct Breakpoint {
    id: u32,
    steps: Vec<u32>,
    asked: Option<BreakCondition>,
    hits: Option<Hits>,
    /// Text to print instead of stopping the run.
    log_text: Option<LogText>,
    /// Positions before `known` at which it was passed, in order. Only breakpoints with `hits` need them.
    passes: Vec<u64>,
    known: u64,
}

impl Breakpoint {
    /// Returns true if a pass at a position is one of those that count.
    fn counts(&self, hits: Hits, at: u64) -> bool {
        let place = self.passes.binary_search(&at);
        place.is_ok_and(|place| hits.has(place as u64 + 1))
    }

    fn holds(&self, now: &Now<'_>) -> bool {
        self.asked.as_ref().is_none_or(|asked| asked.holds(now))
    }

    /// Returns true if the run stops at the pass that has just been counted.
    fn is_due(&self, now: &Now<'_>) -> bool {
        match self.hits {
            Some(hits) => self.counts(hits, now.at),
            None => self.holds(now),
        }
    }

    fn passed(&mut self, at: u64, is_pass: bool) {
        if is_pass {
            self.passes.push(at);
        }
        self.known = at + 1;
    }
}

/// Prediction for a position, without a replay of the run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum HitPrediction {
    /// Nothing stops there.
    No,
    /// The breakpoint of this number stops the run.
    Stops(u32),
    /// A condition decides, for which the run has to be replayed.
    Asks,
}

/// All breakpoints.
#[derive(Debug)]
pub(super) struct Breakpoints {
    all: Vec<Breakpoint>,
    /// The number of breakpoints at each step.
    steps: Vec<u32>,
}

impl Breakpoints {
    pub(super) fn new(steps: usize) -> Self {
        Breakpoints {
            all: Vec::new(),
            steps: vec![0; steps],
        }
    }

    fn are_at(&self, step: u32) -> bool {
        self.steps
            .get(step as usize)
            .is_some_and(|count| *count > 0)
    }

    fn at(&self, step: u32) -> impl Iterator<Item = &Breakpoint> {
        let all: &[Breakpoint] = if self.are_at(step) { &self.all } else { &[] };
        all.iter().filter(move |one| one.steps.contains(&step))
    }

    fn add(&mut self, one: Breakpoint) {
        for step in &one.steps {
            if let Some(count) = self.steps.get_mut(*step as usize) {
                *count += 1;
            }
        }
        self.all.push(one);
    }

    fn remove(&mut self, id: u32) -> bool {
        // The ids are in ascending order.
        let Ok(place) = self.all.binary_search_by_key(&id, |one| one.id) else {
            return false;
        };
        for step in self.all.remove(place).steps {
            if let Some(count) = self.steps.get_mut(step as usize) {
                *count -= 1;
            }
        }
        true
    }

    /// Returns the first breakpoint that stops a run at a position where a step begins.
    pub(super) fn stops(&self, step: u32, now: &Now<'_>) -> Option<u32> {
        let mut here = self.at(step).filter(|one| one.log_text.is_none());
        here.find(|one| one.is_due(now)).map(|one| one.id)
    }

    /// Returns the texts of the log points there.
    pub(super) fn log_texts(&self, step: u32, now: &Now<'_>) -> Vec<String> {
        let here = self.at(step).filter(|one| one.is_due(now));
        let words = here.filter_map(|one| one.log_text.as_ref());
        words.map(|words| words.at(now)).collect()
    }

    /// Returns true if there is a log point.
    fn have_log_text(&self) -> bool {
        self.all.iter().any(|one| one.log_text.is_some())
    }

    /// Makes a breakpoint a log point.
    pub(super) fn set_log_text(&mut self, id: u32, words: LogText) {
        if let Some(one) = self.all.iter_mut().find(|one| one.id == id) {
            one.log_text = Some(words);
        }
    }

    /// Predicts the result of [`stops`](Self::stops) without the run.
    pub(super) fn predict(&self, step: u32, at: u64) -> HitPrediction {
        let mut known = HitPrediction::No;
        for one in self.at(step).filter(|one| one.log_text.is_none()) {
            match (one.hits, &one.asked) {
                (Some(hits), _) if one.counts(hits, at) => return HitPrediction::Stops(one.id),
                (None, None) => return HitPrediction::Stops(one.id),
                (None, Some(_)) => known = HitPrediction::Asks,
                (Some(_), _) => {}
            }
        }
        known
    }

    /// Counts the passes of a position that has not been counted.
    pub(super) fn count(&mut self, history: &History, now: &Now<'_>) {
        for one in &mut self.all {
            if one.hits.is_some() && one.known == now.at {
                let is_there = history
                    .begins(now.at)
                    .any(|it| one.steps.contains(&it.step));
                let is_pass = is_there && one.holds(now);
                one.passed(now.at, is_pass);
            }
        }
    }

    /// Counts passes up to a position, as far as that needs no replay. Returns the first position that needs one, if
    /// any.
    pub(super) fn count_known(&mut self, history: &History, until: u64) -> Option<u64> {
        for one in &mut self.all {
            if one.hits.is_some() && one.asked.is_none() {
                for at in one.known..until {
                    let is_pass = history.begins(at).any(|it| one.steps.contains(&it.step));
                    one.passed(at, is_pass);
                }
            }
        }
        let counting = self.all.iter().filter(|one| one.hits.is_some());
        let known = counting.map(|one| one.known).min()?;
        (known < until).then_some(known)
    }

    /// Removes the counts from a position on.
    pub(super) fn truncate(&mut self, at: u64) {
        for one in &mut self.all {
            one.passes.retain(|pass| *pass < at);
            one.known = one.known.min(at);
        }
    }
}

impl Debugger {
    /// Places a breakpoint before the first step of a line, or of the next line that has one.
    ///
    /// # Errors
    /// There is no such line, or its condition or its hits are wrong.
    pub fn break_at_line(&mut self, line: u32, when: &When<'_>) -> Result<Placed, DebugError> {
        self.break_at(line, 1, when)
    }

    /// Sets a breakpoint from a column (in characters, from 1) on, where a line has several steps.
    ///
    /// # Errors
    /// The errors of [`break_at_line`](Self::break_at_line).
    pub fn break_at(
        &mut self,
        line: u32,
        column: u32,
        when: &When<'_>,
    ) -> Result<Placed, DebugError> {
        let step = first_from(&self.program, line, column);
        self.place(vec![step.ok_or(DebugError::NoStep(line))?], when)
    }

    /// Places a breakpoint where a routine or label is, or at every step that begins with this word, such as `PTP`.
    ///
    /// # Errors
    /// Nothing has this name, or the condition or the hits are wrong.
    pub fn break_at_name(&mut self, name: &str, when: &When<'_>) -> Result<Placed, DebugError> {
        let word = name.trim().trim_end_matches(':').trim_end();
        let is_it = |other: &str| other.eq_ignore_ascii_case(word);
        let labels = self.program.labels().iter();
        let label = labels
            .filter(|label| is_it(&label.name))
            .map(|label| label.step);
        let mut steps: Vec<u32> = label.collect();
        if steps.is_empty() {
            let numbered = (0..).zip(self.program.steps());
            let begins = numbered.filter(|(_, step)| {
                let first = step.text.split([' ', '\t', ',', '\u{3000}']).next();
                first.is_some_and(is_it)
            });
            steps.extend(begins.map(|(number, _)| number));
        }
        if steps.is_empty() || word.is_empty() {
            return Err(DebugError::NoName(word.to_owned()));
        }
        self.place(steps, when)
    }

    fn place(&mut self, steps: Vec<u32>, when: &When<'_>) -> Result<Placed, DebugError> {
        let asked = when
            .condition
            .map(|text| BreakCondition::new(text, &self.asker));
        let hits = when.hits.map(str::parse);
        let (asked, hits) = (asked.transpose()?, hits.transpose()?);
        let first = steps
            .first()
            .and_then(|step| self.program.steps().get(*step as usize));
        let (line, column) = first.map_or((0, 0), |step| (step.line, step.column));
        let id = self.new_id();
        self.breakpoints.add(Breakpoint {
            id,
            steps,
            asked,
            hits,
            log_text: None,
            passes: Vec::new(),
            known: 0,
        });
        Ok(Placed { id, line, column })
    }

    /// Removes a breakpoint; returns true if there was one.
    pub fn remove_breakpoint(&mut self, id: u32) -> bool {
        self.breakpoints.remove(id)
    }

    /// Returns the lines of a step where breakpoints are, with their numbers.
    pub fn breakpoint_lines(&self) -> impl Iterator<Item = (u32, u32)> {
        let all = self.breakpoints.all.iter();
        all.flat_map(|one| {
            one.steps
                .iter()
                .map(|step| (self.run().program().line(*step), one.id))
        })
    }
}

/// Returns the first step that does not begin before a place. Steps are in the order of the text.
fn first_from(program: &Program, line: u32, column: u32) -> Option<u32> {
    let steps = program.steps();
    let first = steps.partition_point(|step| (step.line, step.column) < (line, column));
    (first < steps.len()).then_some(first as u32)
}

impl Debugger {
    /// Places a breakpoint that does not stop a run, but prints a text each time the run passes it going forward. In the text,
    /// braces hold an expression or condition of the program, or the name of a POS or JOINT; its value is printed in their place.
    ///
    /// # Errors
    /// The errors of [`break_at`](Self::break_at); or a text in braces is neither.
    pub fn log_at(
        &mut self,
        line: u32,
        column: u32,
        when: &When<'_>,
        text: &str,
    ) -> Result<Placed, DebugError> {
        let words = LogText::new(text, &self.program, &self.asker)?;
        let placed = self.break_at(line, column, when)?;
        self.breakpoints.set_log_text(placed.id, words);
        Ok(placed)
    }

    /// Takes the output of log points since the last call, each text with its position. Only the last texts are kept.
    pub fn logged(&mut self) -> Vec<(u64, String)> {
        std::mem::take(&mut self.logged)
    }

    /// Logs the texts of log points where a step begins.
    pub(super) fn log_here(&mut self) {
        if !self.breakpoints.have_log_text() || self.end_at(self.now()).is_some() {
            return;
        }
        let begin = self.history.begins(self.now());
        let said: Vec<String> = begin
            .flat_map(|it| self.breakpoints.log_texts(it.step, &self.here()))
            .collect();
        if self.logged.len() >= 2 * MESSAGES {
            self.logged.drain(..MESSAGES);
        }
        let at = self.now();
        self.logged.extend(said.into_iter().map(|text| (at, text)));
    }
}

#[derive(Debug)]
struct Watch {
    id: u32,
    /// Upper case.
    names: Vec<String>,
    /// True for each step that assigns one of them.
    steps: Vec<bool>,
}

/// All watches.
#[derive(Debug, Default)]
pub(super) struct Watches(Vec<Watch>);

impl Watches {
    /// Returns the variable that a step of a cycle assigns and the thread of the step, if the watch `only`, or any
    /// watch, is on it. A KEY_IN that still waits assigns nothing.
    pub(super) fn assigned(
        &self,
        at: u64,
        only: Option<u32>,
        history: &History,
        program: &Program,
    ) -> Option<(Reason, u8)> {
        if self.0.is_empty() {
            return None;
        }
        let taken = history.cycle(at);
        let count = taken.len() - usize::from(history.fails(at)).min(taken.len());
        taken.iter().take(count).find_map(|it| {
            let assigns = |watch: &&Watch| watch.steps.get(it.step as usize) == Some(&true);
            let watch = self.selected(only).find(assigns)?;
            let action = program.steps().get(it.step as usize);
            let asks_key = matches!(action?.action, Action::KeyIn { .. });
            let goes_on = history.first(at + 1, it.thread).map(|next| next.step);
            let reason = Reason::Watch {
                id: watch.id,
                by: By::Step(it.step),
            };
            let waits = asks_key && goes_on == Some(it.step);
            (!waits).then_some((reason, it.thread))
        })
    }

    /// Returns the variable that events assign before the step of a cycle, if the watch `only`, or any watch, is on it.
    pub(super) fn set(&self, at: u64, only: Option<u32>, events: &Events) -> Option<Reason> {
        if self.0.is_empty() {
            return None;
        }
        let all = events.all();
        let first = all.partition_point(|event| event.cycle < at);
        let here = all.iter().skip(first).take_while(|event| event.cycle == at);
        let watch = here.into_iter().find_map(|timed| match &timed.event {
            Event::Set(name, _) => (self.selected(only)).find(|watch| watch.names.contains(name)),
            _ => None,
        })?;
        Some(Reason::Watch {
            id: watch.id,
            by: By::Event,
        })
    }

    /// Iterates over one watch, or all.
    fn selected(&self, only: Option<u32>) -> impl Iterator<Item = &Watch> {
        let is_meant = move |watch: &&Watch| only.is_none_or(|id| watch.id == id);
        self.0.iter().filter(is_meant)
    }
}

impl Debugger {
    /// Adds a watch that stops where a variable, or a member such as `P.X`, is assigned. Returns its number.
    ///
    /// # Errors
    /// The program has no such variable.
    pub fn watch(&mut self, name: &str) -> Result<u32, DebugError> {
        let name = name.trim().to_ascii_uppercase();
        let scalars = scalars(&self.program, &name)
            .ok_or(DebugError::NoVariable(name, VariableError::Unknown))?;
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

    /// Removes a watch; returns true if there was one.
    pub fn unwatch(&mut self, id: u32) -> bool {
        let before = self.watches.0.len();
        self.watches.0.retain(|watch| watch.id != id);
        self.watches.0.len() < before
    }

    /// Removes all watches.
    pub fn unwatch_all(&mut self) {
        self.watches.0.clear();
    }
}

/// Returns the places of a variable, or of a member, among all scalars.
fn scalars(program: &Program, name: &str) -> Option<Range<usize>> {
    let mut variables = program.variables().iter();
    let whole = |variable: &Variable| variable.first..variable.first + variable.size();
    let variable = variables.find(|variable| variable.name == name).map(whole);
    variable.or_else(|| {
        let member = program.scalar_names().position(|other| other == name)?;
        Some(member..member + 1)
    })
}
