//! `tip debug`: a debugger on the terminal.

mod screen;

#[cfg(test)]
mod tests;

use super::arguments::RunArguments;
use super::error::Error;
use super::{Status, interrupt, loader, sticks};
use crate::Action;
use crate::message::{DebugText, Using};
use clap::Args;
use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use std::collections::BTreeMap;
use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};
use tip_runtime::plant::Scene;
use tip_sim::debug::{DebugError, Debugger, Discard, Move, Progress, Value, Variable, When, Work};
use tip_sim::message::Debugging;
use tip_sim::{Event, Robot};
use tip_view::Skeleton;
use tipc::message::{Lang, Message, Text};
use tipc::source::Source;

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip debug walk.prg                            stops before the first step
  tip debug walk.prg --events '120:key F'       a key is pressed before cycle 120
  tip debug --robot hand grasp.prg --scene scene.toml

Keys: r runs, n goes over the next step, s into routines, o out of one, c one control cycle,
l to the line of the cursor, g to a cycle; the same in capitals goes back. t looks at the next thread. b places and removes a
breakpoint, B one with a condition and a count of passes, f stops before each command, label or
routine of a name. w watches a variable, W goes back to the last assignment of one. i applies an event,
such as 'key F', 'VR1=8' or 'N = 5'; e shows the value of an expression. Esc interrupts, ? explains, q ends.")]
pub(super) struct Debug {
    #[command(flatten)]
    pub(super) run: RunArguments,
}

/// Time to wait for a key before checking for signals.
const PATIENCE: Duration = Duration::from_millis(200);

/// Time between two drawings of the screen while the program runs.
const FRAME: Duration = Duration::from_millis(40);

/// Number of control cycles between two looks at the keyboard.
const PORTION: u64 = 200;

impl Action for Debug {
    fn complete(&mut self) -> Result<(), Error> {
        self.run.complete(&self.run.file.clone()).map(drop)
    }

    fn execute(&self) -> Result<Status, Error> {
        debug(self)
    }
}

/// Debugs a program until the user quits.
fn debug(arguments: &Debug) -> Result<Status, Error> {
    let app = load(&arguments.run)?;
    if !io::stdin().is_terminal() || !io::stdout().is_terminal() {
        let reason = "tip debug needs a terminal; editors start tip dap";
        return Err(Error::Usage(reason.to_owned()));
    }
    interrupt::catch();
    // From here on a panic gives the terminal back, too.
    let terminal = ratatui::try_init();
    let done = terminal.and_then(|mut terminal| show(app, &mut terminal));
    ratatui::restore();
    interrupt::hold();
    match done {
        Ok(()) if interrupt::is_requested() => Ok(Status::Interrupted),
        Ok(()) => Ok(Status::Success),
        Err(error) => Err(Error::Failed(format!(
            "the terminal cannot be used: {error}"
        ))),
    }
}

fn load(run: &RunArguments) -> Result<App, Error> {
    let output_options = run.source.output_options;
    let refusal = Using::ProcessRunsOnce { command: "debug" };
    let subject = loader::load(&run.file, run, Some(refusal))?;
    let (subject, program) = loader::sound(subject, output_options, false)?;
    let usage = |refused: &dyn std::fmt::Display| Error::Usage(refused.to_string());
    let events = run.inputs.inputs(&subject.robot).events;
    let events = sticks::let_rest(&program, events);
    let mut debugger = Debugger::new(program, &subject.robot)
        .map_err(|mismatch| usage(&mismatch))?
        .with_events(&events)
        .map_err(|refused| usage(&refused))?;
    debugger.stop_at_fall(true);
    let lang = output_options.lang();
    let source = subject.loaded.source;
    Ok(App::new(debugger, source, &subject.robot, lang))
}

/// Draws the screen and handles keys until the user quits.
fn show(mut app: App, terminal: &mut DefaultTerminal) -> io::Result<()> {
    let mut drawn = None;
    while !app.is_over && !interrupt::is_requested() {
        let is_due = drawn.is_none_or(|at: Instant| at.elapsed() >= FRAME);
        if is_due || !app.is_going() {
            terminal.draw(|frame| screen::draw(&app, frame))?;
            drawn = Some(Instant::now());
        }
        let patience = match app.is_going() {
            true => Duration::ZERO,
            false => PATIENCE,
        };
        if event::poll(patience)? {
            if let event::Event::Key(key) = event::read()?
                && key.kind != KeyEventKind::Release
            {
                press(&mut app, key);
            }
        } else {
            app.work(PORTION);
        }
    }
    Ok(())
}

/// The state of the screen.
struct App {
    debugger: Debugger,
    source: Source,
    skeleton: Skeleton,
    /// The scene of the robot.
    scene: Scene,
    lang: Lang,
    /// The line of the cursor, from 1.
    cursor: u32,
    /// Ids of breakpoints by line.
    breakpoints: BTreeMap<u32, u32>,
    /// Ids of breakpoints by command, label or routine.
    named: BTreeMap<String, u32>,
    /// The watched variable.
    watched: Option<String>,
    /// The variables before the last movement.
    before: Vec<Variable>,
    /// The page of the list of variables.
    page: usize,
    /// The open question, and the text typed so far.
    question: Option<(Question, String)>,
    /// The last answer.
    answer: Option<String>,
    /// True while all keys are explained.
    explains: bool,
    /// The progress of a backward search.
    progress: Option<Progress>,
    is_over: bool,
}

impl App {
    fn new(debugger: Debugger, source: Source, robot: &Robot, lang: Lang) -> Self {
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

    fn is_going(&self) -> bool {
        self.debugger.is_going()
    }

    fn say(&self, message: impl Into<Message>) -> String {
        message.into().in_lang(self.lang).to_string()
    }

    fn go(&mut self, movement: Move) {
        self.answer = None;
        self.progress = None;
        self.before = self.debugger.variables();
        self.debugger.start(movement);
        if !self.is_going() {
            self.cursor = self.debugger.line();
        }
    }

    /// Runs the program for some cycles.
    fn work(&mut self, cycles: u64) {
        if !self.is_going() {
            return;
        }
        match self.debugger.work(cycles) {
            Work::Going(progress) => self.progress = progress.of.is_some().then_some(progress),
            Work::Stopped(_) => self.progress = None,
        }
        self.cursor = self.debugger.line();
    }

    fn interrupt(&mut self) {
        self.debugger.cancel();
        self.progress = None;
        self.cursor = self.debugger.line();
    }

    /// Looks at the next thread that runs.
    fn next_thread(&mut self) {
        let threads = self.debugger.threads();
        let here = self.debugger.thread();
        let later = threads.iter().find(|thread| **thread > here);
        self.debugger.select(later.copied().unwrap_or(0));
        self.cursor = self.debugger.line();
    }

    fn move_cursor(&mut self, by: i64) {
        let last = i64::from(self.source.line_count().max(1));
        let line = (i64::from(self.cursor) + by).clamp(1, last);
        self.cursor = u32::try_from(line).unwrap_or(1);
    }

    /// Places a breakpoint on the line of the cursor, or removes the one there.
    fn toggle(&mut self) {
        match self.breakpoints.remove(&self.cursor) {
            Some(id) => {
                self.debugger.remove_breakpoint(id);
            }
            None => self.place(&When::default()),
        }
    }

    /// Places a breakpoint on the line of the cursor or the next one that has a step.
    fn place(&mut self, when: &When<'_>) {
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
    fn change(&mut self, event: Event, discard: Discard) {
        match self.debugger.happens(event.clone(), discard) {
            Ok(()) => self.answer = None,
            Err(DebugError::WouldDiscard(cycles)) => {
                self.question = Some((Question::Discard(event, cycles), String::new()));
            }
            Err(refused) => self.refuse(&refused),
        }
    }

    fn refuse(&mut self, refused: &DebugError) {
        self.answer = Some(refused.text(self.lang));
    }
}

/// A question in the last line of the screen.
#[derive(Clone, Debug, PartialEq)]
enum Question {
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
    fn message(&self, line: u32) -> DebugText {
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
    fn ask(&mut self, question: Question) {
        self.answer = None;
        self.question = Some((question, String::new()));
    }

    /// Handles a complete answer.
    fn answered(&mut self) {
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
    fn confirmed(&mut self, yes: bool) {
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

fn press(app: &mut App, key: KeyEvent) {
    if key.modifiers.contains(KeyModifiers::CONTROL) {
        if key.code == KeyCode::Char('c') {
            app.is_over = true;
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
                app.is_over = true;
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
        ('q', false) => app.is_over = true,
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
