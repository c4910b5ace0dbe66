//! The state of the debugger: the program, questions and their answers, and the commands of keys.

use crate::message::DebugText;
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use std::collections::BTreeMap;
use tip_runtime::plant::Scene;
use tip_sim::debug::{DebugError, Debugger, Discard, Move, Progress, Value, Variable, When, Work};
use tip_sim::message::Debugging;
use tip_sim::{Event, Robot};
use tip_view::Skeleton;
use tipc::message::{Lang, Message, Text};
use tipc::source::Source;

/// The state of the screen.
pub(crate) struct App {
    pub(crate) debugger: Debugger,
    pub(crate) source: Source,
    pub(crate) skeleton: Skeleton,
    /// The scene of the robot.
    pub(crate) scene: Scene,
    pub(crate) lang: Lang,
    /// The line of the cursor, from 1.
    pub(crate) cursor: u32,
    /// Ids of breakpoints by line.
    pub(crate) breakpoints: BTreeMap<u32, u32>,
    /// Ids of breakpoints by command, label or routine.
    pub(crate) named: BTreeMap<String, u32>,
    /// The watched variable.
    pub(crate) watched: Option<String>,
    /// The variables before the last movement.
    pub(crate) before: Vec<Variable>,
    /// The page of the list of variables.
    pub(crate) page: usize,
    /// The open question, and the text typed so far.
    pub(crate) question: Option<(Question, String)>,
    /// The last answer.
    pub(crate) answer: Option<String>,
    /// True while all keys are explained.
    pub(crate) explains: bool,
    /// The progress of a backward search.
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
            explains: false,
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

    pub(crate) fn say(&self, message: impl Into<Message>) -> String {
        message.into().in_lang(self.lang).to_string()
    }

    /// Starts a movement.
    pub(crate) fn go(&mut self, movement: Move) {
        self.answer = None;
        self.progress = None;
        self.before = self.debugger.variables();
        self.debugger.start(movement);
        if !self.is_going() {
            self.cursor = self.debugger.line();
        }
    }

    /// Runs the program for some cycles.
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

    /// Looks at the next thread that runs.
    pub(crate) fn next_thread(&mut self) {
        let threads = self.debugger.threads();
        let here = self.debugger.thread();
        let later = threads.iter().find(|thread| **thread > here);
        self.debugger.select(later.copied().unwrap_or(0));
        self.cursor = self.debugger.line();
    }

    pub(crate) fn move_cursor(&mut self, by: i64) {
        let last = i64::from(self.source.line_count().max(1));
        let line = (i64::from(self.cursor) + by).clamp(1, last);
        self.cursor = u32::try_from(line).unwrap_or(1);
    }

    /// Places a breakpoint on the line of the cursor, or removes the one there.
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

    /// Applies an event, after a question if that would discard cycles.
    pub(crate) fn change(&mut self, event: Event, discard: Discard) {
        match self.debugger.happens(event.clone(), discard) {
            Ok(()) => self.answer = None,
            Err(DebugError::WouldDiscard(cycles)) => {
                self.question = Some((Question::Discard(event, cycles), String::new()));
            }
            Err(refused) => self.refuse(&refused),
        }
    }

    pub(crate) fn refuse(&mut self, refused: &DebugError) {
        self.answer = Some(refused.text(self.lang));
    }
}

/// A question in the last line of the screen.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Question {
    Event,
    Expression,
    Watch,
    /// The variable whose last assignment to go back to.
    Who,
    Cycle,
    Condition,
    /// The passes that stop, of a breakpoint with this condition.
    Passes(String),
    /// The command, label or routine to stop before.
    Name,
    /// Consent to discard some cycles for an event.
    Discard(Event, u64),
}

impl Question {
    /// Returns the text of the question for a line of the cursor.
    pub(crate) fn message(&self, line: u32) -> DebugText {
        match self {
            Question::Event => DebugText::AskEvent,
            Question::Expression => DebugText::AskExpression,
            Question::Watch => DebugText::AskWatch,
            Question::Who => DebugText::AskWho,
            Question::Cycle => DebugText::AskCycle,
            Question::Condition => DebugText::AskCondition { line },
            Question::Passes(_) => DebugText::AskPasses,
            Question::Name => DebugText::AskName,
            Question::Discard(_, cycles) => DebugText::AskDiscard {
                count: usize::try_from(*cycles).unwrap_or(usize::MAX),
            },
        }
    }
}

impl App {
    pub(crate) fn ask(&mut self, question: Question) {
        self.answer = None;
        self.question = Some((question, String::new()));
    }

    /// Handles a complete answer.
    pub(crate) fn answered(&mut self) {
        let Some((question, text)) = self.question.take() else {
            return;
        };
        let text = text.trim();
        match question {
            Question::Event => self.make_happen(text),
            Question::Expression => self.show_value(text),
            Question::Watch => {
                self.watch(text);
            }
            Question::Who => {
                if let Some(watch) = self.watch(text) {
                    self.go(Move::SetBack(watch));
                }
            }
            Question::Cycle => match text.parse() {
                Ok(cycle) => self.go(Move::To(cycle)),
                Err(_) => self.answer = Some(self.say(DebugText::NotANumber { text: owned(text) })),
            },
            Question::Condition => self.ask(Question::Passes(text.to_owned())),
            Question::Passes(condition) => self.place(&When {
                condition: non_empty(&condition),
                hits: non_empty(text),
            }),
            Question::Name => self.stop_before(text),
            Question::Discard(..) => {}
        }
    }

    /// Handles the answer to a question about discarded cycles.
    pub(crate) fn confirmed(&mut self, yes: bool) {
        if let Some((Question::Discard(event, _), _)) = self.question.take()
            && yes
        {
            self.change(event, Discard::Later);
        }
    }

    fn make_happen(&mut self, text: &str) {
        match text.parse().ok().or_else(|| self.debugger.assignment(text)) {
            Some(event) => self.change(event, Discard::Nothing),
            None => {
                let text = owned(text);
                self.answer = Some(self.say(DebugText::NeitherEventNorAssignment { text }));
            }
        }
    }

    fn show_value(&mut self, text: &str) {
        let unassigned = || self.say(Debugging::Unassigned);
        let value = match (self.debugger.value(text), self.debugger.evaluate(text)) {
            (Ok(value), _) => value.map_or_else(unassigned, |value| value.to_string()),
            (_, Ok(Value::Number(value))) => value.to_string(),
            (_, Ok(Value::Truth(truth))) => truth.to_string(),
            (_, Err(refused)) => return self.refuse(&refused),
        };
        let (text, value) = (owned(text), owned(&value));
        self.answer = Some(self.say(DebugText::Comes { text, value }));
    }

    /// Stops before every step of a name, or no longer.
    fn stop_before(&mut self, name: &str) {
        let upper = name.trim_end_matches(':').to_ascii_uppercase();
        let name = owned(&upper);
        if let Some(id) = self.named.remove(&upper) {
            self.debugger.remove_breakpoint(id);
            self.answer = Some(self.say(DebugText::StopsNoMore { name }));
            return;
        }
        match self.debugger.break_at_name(&upper, &When::default()) {
            Ok(placed) => {
                self.named.insert(upper, placed.id);
                self.answer = Some(self.say(DebugText::StopsBefore { name }));
            }
            Err(refused) => self.refuse(&refused),
        }
    }

    /// Watches a variable instead of the former one; an empty name ends that.
    fn watch(&mut self, name: &str) -> Option<u32> {
        self.debugger.unwatch_all();
        self.watched = None;
        if name.is_empty() {
            return None;
        }
        match self.debugger.watch(name) {
            Ok(id) => {
                let upper = name.to_ascii_uppercase();
                let name = owned(&upper);
                self.watched = Some(upper);
                self.answer = Some(self.say(DebugText::Watches { name }));
                Some(id)
            }
            Err(refused) => {
                self.refuse(&refused);
                None
            }
        }
    }
}

/// Returns a text unless it is empty.
fn non_empty(text: &str) -> Option<&str> {
    (!text.is_empty()).then_some(text)
}

fn owned(text: &str) -> Text {
    Text::from(text.to_owned())
}

/// Number of lines of a page.
const PAGE: i64 = 15;

/// Handles a key.
pub(crate) fn press(app: &mut App, key: KeyEvent) {
    if key.modifiers.contains(KeyModifiers::CONTROL) {
        if key.code == KeyCode::Char('c') {
            app.quit();
        }
        return;
    }
    if std::mem::take(&mut app.explains) {
        return;
    }
    match &app.question {
        Some((Question::Discard(..), _)) => {
            let yes = matches!(key.code, KeyCode::Char(char) if char.eq_ignore_ascii_case(&'y'));
            app.confirmed(yes);
        }
        Some(_) => edit(app, key.code),
        None if app.is_going() => {
            if matches!(key.code, KeyCode::Esc | KeyCode::Char(' ')) {
                app.interrupt();
            } else if key.code == KeyCode::Char('q') {
                app.quit();
            }
        }
        None => command(app, key.code),
    }
}

/// Edits the answer to a question.
fn edit(app: &mut App, code: KeyCode) {
    match code {
        KeyCode::Enter => return app.answered(),
        KeyCode::Esc => app.question = None,
        _ => {}
    }
    if let Some((_, text)) = &mut app.question {
        match code {
            KeyCode::Char(char) => text.push(char),
            KeyCode::Backspace => {
                text.pop();
            }
            _ => {}
        }
    }
}

fn command(app: &mut App, code: KeyCode) {
    match code {
        KeyCode::Char(char) => letter(app, char.to_ascii_lowercase(), char.is_ascii_uppercase()),
        KeyCode::Up => app.move_cursor(-1),
        KeyCode::Down => app.move_cursor(1),
        KeyCode::Tab => app.page = app.page.wrapping_add(1),
        KeyCode::PageUp => app.move_cursor(-PAGE),
        KeyCode::PageDown => app.move_cursor(PAGE),
        _ => {}
    }
}

/// Runs the command of a letter; capitals go back, or ask for more.
fn letter(app: &mut App, letter: char, is_capital: bool) {
    let line = app.cursor;
    match (letter, is_capital) {
        ('q', false) => app.quit(),
        ('r', false) => app.go(Move::Continue),
        ('r', true) => app.go(Move::ReverseContinue),
        ('n', false) => app.go(Move::Over),
        ('n', true) => app.go(Move::OverBack),
        ('s', false) => app.go(Move::Step),
        ('s', true) => app.go(Move::StepBack),
        ('o', false) => app.go(Move::Out),
        ('o', true) => app.go(Move::OutBack),
        ('c', false) => app.go(Move::Cycle),
        ('c', true) => app.go(Move::CycleBack),
        ('l', false) => app.go(Move::Line(line)),
        ('l', true) => app.go(Move::LineBack(line)),
        ('b', false) => app.toggle(),
        ('b', true) => app.ask(Question::Condition),
        ('f', false) => app.ask(Question::Name),
        ('w', false) => app.ask(Question::Watch),
        ('w', true) => app.ask(Question::Who),
        ('i', false) => app.ask(Question::Event),
        ('e', false) => app.ask(Question::Expression),
        ('g', false) => app.ask(Question::Cycle),
        ('?', _) => app.explains = true,
        ('t', false) => app.next_thread(),
        ('.', _) => app.cursor = app.debugger.line(),
        ('k', false) => app.move_cursor(-1),
        ('j', false) => app.move_cursor(1),
        _ => {}
    }
}
