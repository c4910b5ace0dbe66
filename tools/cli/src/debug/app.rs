//! What is on the screen, and what changes it.

use super::question::Question;
use std::collections::BTreeMap;
use tip_runtime::plant::Scene;
use tip_sim::debug::{Debugger, Discard, Move, Progress, Refused, Variable, When, Work};
use tip_sim::message::Debugging;
use tip_sim::{Event, Robot};
use tip_view::Skeleton;
use tipc::message::Lang;
use tipc::source::Source;

/// A debugger with its face.
pub(crate) struct App {
    pub(crate) debugger: Debugger,
    pub(crate) source: Source,
    pub(crate) skeleton: Skeleton,
    /// What surrounds the robot.
    pub(crate) scene: Scene,
    pub(crate) lang: Lang,
    /// The line that keys are for, from 1.
    pub(crate) cursor: u32,
    /// Breakpoints by their lines.
    pub(crate) breakpoints: BTreeMap<u32, u32>,
    /// Breakpoints by the names that they are for.
    pub(crate) named: BTreeMap<String, u32>,
    /// The name that is watched.
    pub(crate) watched: Option<String>,
    /// The variables before the last movement.
    pub(crate) before: Vec<Variable>,
    /// Which part of the variables is shown, where all of them are too many.
    pub(crate) page: usize,
    /// What is asked, and what has been typed.
    pub(crate) question: Option<(Question, String)>,
    /// What was answered last.
    pub(crate) answer: Option<String>,
    /// How far a search is.
    pub(crate) progress: Option<Progress>,
    is_over: bool,
}

impl App {
    pub(crate) fn new(debugger: Debugger, source: Source, robot: &Robot, lang: Lang) -> Self {
        App {
            cursor: debugger.line(),
            debugger,
            source,
            skeleton: Skeleton::of(robot),
            scene: *robot.scene(),
            lang,
            breakpoints: BTreeMap::new(),
            named: BTreeMap::new(),
            watched: None,
            before: Vec::new(),
            page: 0,
            question: None,
            answer: None,
            progress: None,
            is_over: false,
        }
    }

    pub(crate) fn is_over(&self) -> bool {
        self.is_over
    }

    pub(crate) fn quit(&mut self) {
        self.is_over = true;
    }

    pub(crate) fn is_going(&self) -> bool {
        self.debugger.is_going()
    }

    pub(crate) fn say(&self, message: Debugging) -> String {
        message.in_lang(self.lang).to_string()
    }

    /// Begins a movement.
    pub(crate) fn go(&mut self, movement: Move) {
        self.answer = None;
        self.progress = None;
        self.before = self.debugger.variables();
        self.debugger.start(movement);
        if !self.is_going() {
            self.cursor = self.debugger.line();
        }
    }

    /// Does a portion of what is under way.
    pub(crate) fn work(&mut self, cycles: u64) {
        if !self.is_going() {
            return;
        }
        match self.debugger.work(cycles) {
            Work::Going(progress) => self.progress = progress.of.is_some().then_some(progress),
            Work::Stopped(_) => self.progress = None,
        }
        self.cursor = self.debugger.line();
    }

    pub(crate) fn interrupt(&mut self) {
        self.debugger.cancel();
        self.progress = None;
        self.cursor = self.debugger.line();
    }

    pub(crate) fn move_cursor(&mut self, by: i64) {
        let last = i64::from(self.source.line_count().max(1));
        let line = (i64::from(self.cursor) + by).clamp(1, last);
        self.cursor = u32::try_from(line).unwrap_or(1);
    }

    /// Places a breakpoint on the line of the cursor, or takes the one there away.
    pub(crate) fn toggle(&mut self) {
        match self.breakpoints.remove(&self.cursor) {
            Some(id) => {
                self.debugger.remove_breakpoint(id);
            }
            None => self.place(&When::default()),
        }
    }

    /// Places a breakpoint on the line of the cursor or the next one that has a step.
    pub(crate) fn place(&mut self, when: &When<'_>) {
        match self.debugger.break_at_line(self.cursor, when) {
            Ok(placed) => {
                self.cursor = placed.line;
                if let Some(old) = self.breakpoints.insert(placed.line, placed.id) {
                    self.debugger.remove_breakpoint(old);
                }
            }
            Err(refused) => self.refuse(&refused),
        }
    }

    /// Makes something happen, or asks first if that would discard anything.
    pub(crate) fn change(&mut self, event: Event, discard: Discard) {
        match self.debugger.happens(event.clone(), discard) {
            Ok(()) => self.answer = None,
            Err(Refused::WouldDiscard(cycles)) => {
                self.question = Some((Question::Discard(event, cycles), String::new()));
            }
            Err(refused) => self.refuse(&refused),
        }
    }

    pub(crate) fn refuse(&mut self, refused: &Refused) {
        self.answer = Some(refused.text(self.lang));
    }
}
