//! The screen of the debugger: source, messages, variables, calls and targets as text.

use crate::debug::app::App;
use crate::debug::figure::{block, draw_robot};
use crate::message::DebugText;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;
use std::collections::BTreeSet;
use tip_runtime::command::{TIMERS, Target};
use tip_runtime::controller::Setpoint;
use tip_runtime::printable::Printable;
use tip_sim::debug::{By, Reason, Variable, control};
use tip_sim::message::Debugging;
use tipc::message::Message;
use tipc::program::VariableKind;

/// Minimum width for help in one line.
const WIDE: u16 = 160;

/// Draws the screen.
pub(crate) fn draw(app: &App, frame: &mut Frame<'_>) {
    let [top, body, answer, help] = Layout::vertical([
        Constraint::Length(1),
        Constraint::Min(0),
        Constraint::Length(1),
        Constraint::Length(if frame.area().width < WIDE { 2 } else { 1 }),
    ])
    .areas(frame.area());
    let [left, right] =
        Layout::horizontal([Constraint::Percentage(54), Constraint::Percentage(46)])
            .spacing(1)
            .areas(body);
    draw_title(app, frame, top);
    if app.explains {
        draw_keys(app, frame, body);
        return;
    }
    let said = if body.height > 30 { 8 } else { 4 };
    let [source, messages] =
        Layout::vertical([Constraint::Min(0), Constraint::Length(said)]).areas(left);
    draw_source(app, frame, source);
    draw_messages(app, frame, messages);
    draw_side(app, frame, right);
    draw_last_line(app, frame, answer);
    draw_help(app, frame, help);
}

/// Draws variables, calls, targets and the robot.
fn draw_side(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let calls = calls(app);
    let count = u16::try_from(calls.len()).unwrap_or(u16::MAX);
    let legs = legs(app);
    let height = u16::try_from(legs.len()).unwrap_or(u16::MAX);
    let [variables, called, setpoints, robot] = Layout::vertical([
        Constraint::Fill(3),
        Constraint::Length(count.min(area.height / 5) + 1),
        Constraint::Length(height.min(area.height / 4) + 1),
        Constraint::Length(area.height * 2 / 5),
    ])
    .areas(area);
    draw_variables(app, frame, variables);
    let block = self::block(app.say(DebugText::Calls));
    frame.render_widget(Paragraph::new(calls).block(block), called);
    let block = self::block(app.say(Debugging::Legs));
    frame.render_widget(Paragraph::new(legs).block(block), setpoints);
    draw_robot(app, frame, robot);
}

/// Draws the title: program, time, and state.
fn draw_title(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let debugger = &app.debugger;
    let (now, known) = (debugger.now(), debugger.known());
    let name = Printable::line(app.source.name());
    let text = format!(
        " {name}  {now}/{known}  {:.0} ms  {}",
        debugger.run().time(),
        Printable::line(state(app))
    );
    let style = Style::new().add_modifier(Modifier::REVERSED);
    frame.render_widget(Paragraph::new(text).style(style), area);
}

/// Draws the open question, or the last answer.
fn draw_last_line(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let line = match (&app.question, &app.answer) {
        (Some((question, text)), _) => {
            let asked = app.say(question.message(app.cursor));
            let cursor = Span::styled(" ", Style::new().add_modifier(Modifier::REVERSED));
            Line::from(vec![format!("{asked}: {text}").into(), cursor])
        }
        (None, Some(answer)) => Line::from(Printable::line(answer).to_string()),
        (None, None) => Line::default(),
    };
    frame.render_widget(Paragraph::new(line), area);
}

/// Explains all keys.
fn draw_keys(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let lines = [
        DebugText::KeysForward,
        DebugText::KeysOver,
        DebugText::KeysInto,
        DebugText::KeysOut,
        DebugText::KeysCycle,
        DebugText::KeysThread,
        DebugText::KeysLine,
        DebugText::KeysGo,
        DebugText::KeysBreak,
        DebugText::KeysName,
        DebugText::KeysWatch,
        DebugText::KeysLastSet,
        DebugText::KeysChange,
        DebugText::KeysValue,
        DebugText::KeysCursor,
    ];
    let lines = lines.map(|line| Line::from(app.say(line)));
    let block = block(app.say(DebugText::Keys));
    frame.render_widget(Paragraph::new(lines.to_vec()).block(block), area);
}

fn draw_help(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let [moves, others] = [DebugText::HelpMoves, DebugText::HelpOthers].map(|help| app.say(help));
    let text = match area.height {
        1 => format!("{moves}  {others}"),
        _ => format!("{moves}\n{others}"),
    };
    let style = Style::new().add_modifier(Modifier::DIM);
    frame.render_widget(Paragraph::new(text).style(style), area);
}

/// Returns the reason of the stop, or that the program runs.
pub(crate) fn state(app: &App) -> String {
    if let Some(progress) = app.progress.filter(|_| app.is_going()) {
        let percent = progress.done.saturating_mul(100) / progress.of.unwrap_or(1).max(1);
        let percent = u32::try_from(percent.min(100)).unwrap_or(100);
        return app.say(DebugText::Searching { percent });
    }
    if app.is_going() {
        return app.say(DebugText::Running);
    }
    let message: Message = match &app.debugger.stop().reason {
        Reason::Start => Debugging::Start.into(),
        Reason::Step => DebugText::Stepped.into(),
        Reason::There => DebugText::There.into(),
        Reason::Breakpoint(_) => DebugText::AtBreakpoint.into(),
        Reason::Watch {
            by: By::Step(step), ..
        } => DebugText::Assigned {
            line: app.debugger.run().program().line(*step),
        }
        .into(),
        Reason::Watch { by: By::Event, .. } => DebugText::AssignedByEvent.into(),
        Reason::Fall(_) => DebugText::Fell.into(),
        Reason::Fault(emergency) => return emergency.to_string(),
        Reason::Ended(_) => Debugging::Ended.into(),
        Reason::Change => DebugText::Changed.into(),
        _ => DebugText::Interrupted.into(),
    };
    app.say(message)
}

/// Draws the program around the line of the cursor.
pub(super) fn draw_source(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let height = u32::from(area.height);
    let last = app.source.line_count();
    let first = app
        .cursor
        .saturating_sub(height / 2)
        .min((last + 1).saturating_sub(height))
        .max(1);
    let here = app.debugger.line();
    let others = lines_of_others(app);
    let marked: BTreeSet<u32> = app
        .debugger
        .breakpoint_lines()
        .map(|(line, _)| line)
        .collect();
    let lines = (first..=last).take(area.height.into()).map(|number| {
        let text = Printable::line(app.source.line_text(number)).to_string();
        let is_here = number == here;
        let mark = if marked.contains(&number) { "●" } else { " " };
        let arrow = match is_here {
            true => "▶",
            false if others.contains(&number) => "▷",
            false => " ",
        };
        let mut style = Style::new();
        if is_here {
            style = style.fg(Color::Yellow).add_modifier(Modifier::BOLD);
        }
        if number == app.cursor {
            style = style.add_modifier(Modifier::UNDERLINED);
        }
        Line::from(vec![
            Span::styled(mark, Style::new().fg(Color::Red)),
            Span::styled(
                format!("{arrow}{number:>4} "),
                style.remove_modifier(Modifier::UNDERLINED),
            ),
            Span::styled(text, style),
        ])
    });
    frame.render_widget(Paragraph::new(lines.collect::<Vec<_>>()), area);
}

/// Draws the last messages of the program.
pub(super) fn draw_messages(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let room = usize::from(area.height.saturating_sub(1));
    let all = app.debugger.messages();
    let last = all
        .get(all.len().saturating_sub(room)..)
        .unwrap_or_default();
    let lines = last
        .iter()
        .map(|(at, text)| Line::from(format!("{at:>6} {}", Printable::line(text))));
    let block = block(app.say(DebugText::Said));
    frame.render_widget(Paragraph::new(lines.collect::<Vec<_>>()).block(block), area);
}

/// Returns the open calls of the main program and of each thread that runs; where there are several, the one that is
/// looked at first.
pub(super) fn calls(app: &App) -> Vec<Line<'static>> {
    let mut threads = app.debugger.threads();
    threads.sort_by_key(|thread| *thread != app.debugger.thread());
    let calls = threads.into_iter().flat_map(|thread| {
        let outermost = match app.debugger.thread_name(thread) {
            Some(name) => name.to_owned(),
            None => app.say(DebugText::MainProgram),
        };
        let frames = app.debugger.frames(thread).into_iter();
        frames.map(move |call| {
            let name = call.name.unwrap_or_else(|| outermost.clone());
            Line::from(format!("{:>4} {name}", call.line))
        })
    });
    calls.collect()
}

/// Returns the lines that threads other than the one that is looked at run next.
fn lines_of_others(app: &App) -> BTreeSet<u32> {
    let (debugger, run) = (&app.debugger, app.debugger.run());
    let others = debugger.threads().into_iter();
    let others = others.filter(|thread| *thread != debugger.thread());
    others
        .map(|thread| run.program().line(run.step_of(thread)))
        .collect()
}

/// Returns the mode and target of each foot or joint, a line for each leg.
pub(super) fn legs(app: &App) -> Vec<Line<'static>> {
    let setpoints = app.debugger.run().setpoints();
    let legs = (1..=app.skeleton.legs.len()).map(|leg| {
        let is_own = |aim: &&Setpoint| leg_of(aim.of).is_some_and(|of| usize::from(of) == leg);
        let own: Vec<&Setpoint> = setpoints.iter().filter(is_own).collect();
        Line::from(format!("{leg}: {}", aims_text(app, &own)))
    });
    let others: Vec<&Setpoint> = setpoints
        .iter()
        .filter(|aim| leg_of(aim.of).is_none())
        .collect();
    let others = (!others.is_empty()).then(|| Line::from(aims_text(app, &others)));
    legs.chain(others).chain(switches(app)).collect()
}

/// Returns the locked joints and the timers that have run, if there are any.
fn switches(app: &App) -> impl Iterator<Item = Line<'static>> {
    let run = app.debugger.run();
    let locked: Vec<String> = run.locked().iter().map(Target::to_string).collect();
    let locked = (!locked.is_empty())
        .then(|| format!("{}: {}", app.say(DebugText::Locked), locked.join(" ")));
    let timers = (0..TIMERS).filter(|n| run.timer(*n) > 0.0);
    let timers: Vec<String> = timers
        .map(|n| format!("{n}: {} ms", run.timer(n)))
        .collect();
    let timers = (!timers.is_empty())
        .then(|| format!("{} {}", app.say(DebugText::Timers), timers.join("  ")));
    locked.into_iter().chain(timers).map(Line::from)
}

/// Returns modes and targets; joints with the same mode share it.
fn aims_text(app: &App, setpoints: &[&Setpoint]) -> String {
    let goal = |aim: &Setpoint| {
        let numbers = aim.goal().iter().map(|value| format!("{value:.0}"));
        numbers.collect::<Vec<_>>().join(" ")
    };
    let mode = |aim: &Setpoint| app.say(control(aim.mode));
    match setpoints {
        [] => String::new(),
        [first, .., last] if setpoints.iter().all(|aim| aim.mode == first.mode) => {
            let goals: Vec<String> = setpoints.iter().map(|aim| goal(aim)).collect();
            let goals = goals.join(" ");
            format!("{}-{} {} {goals}", first.of, last.of, mode(first))
        }
        _ => {
            let parts = setpoints
                .iter()
                .map(|aim| format!("{} {} {}", aim.of, mode(aim), goal(aim)));
            parts.collect::<Vec<_>>().join(", ")
        }
    }
}

/// Returns the leg of a foot or joint.
fn leg_of(target: Target) -> Option<u8> {
    match target {
        Target::Foot(leg) | Target::Joint(leg, _) => Some(leg),
        Target::None | Target::All | Target::Floor => None,
    }
}

/// The gap between two variables of a line.
const GAP: &str = "  ";

/// Draws a page of variables. Those that the last movement changed are bold; the watched one is first and has a colour.
pub(super) fn draw_variables(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let mut variables = app.debugger.variables();
    let is_watched = |variable: &Variable| {
        let watched = app.watched.as_deref();
        watched.is_some_and(|name| is_of(variable, name))
    };
    variables.sort_by_key(|variable| !is_watched(variable));
    let room = usize::from(area.height.saturating_sub(1)).max(1);
    let width = match variables.len() <= room {
        true => 0,
        false => usize::from(area.width),
    };
    let lines = in_lines(app, &variables, width);
    let pages = lines.len().div_ceil(room).max(1);
    let page = app.page % pages;
    let name = app.say(Debugging::Variables);
    let title = match pages {
        1 => name,
        _ => format!("{name} {}/{pages} (Tab)", page + 1),
    };
    let shown: Vec<Line<'_>> = lines.into_iter().skip(page * room).take(room).collect();
    frame.render_widget(Paragraph::new(shown).block(block(title)), area);
}

/// Arranges variables in lines of a width; a wider variable has its own line.
fn in_lines(app: &App, variables: &[Variable], width: usize) -> Vec<Line<'static>> {
    let mut lines: Vec<Line<'static>> = Vec::new();
    for variable in variables {
        let span = Span::styled(variable_text(variable), variable_style(app, variable));
        match lines.last_mut() {
            Some(line) if line.width() + GAP.len() + span.width() <= width => {
                line.push_span(GAP);
                line.push_span(span);
            }
            _ => lines.push(Line::from(span)),
        }
    }
    lines
}

fn variable_style(app: &App, variable: &Variable) -> Style {
    let style = match app.watched.as_deref() {
        Some(name) if is_of(variable, name) => Style::new().fg(Color::Magenta),
        _ => Style::new(),
    };
    let before = app.before.iter().find(|one| one.name == variable.name);
    match before.is_none_or(|before| before.scalars == variable.scalars) {
        true => style,
        false => style.add_modifier(Modifier::BOLD),
    }
}

/// Returns true if a name is that of a variable or of one of its members.
fn is_of(variable: &Variable, name: &str) -> bool {
    let mut scalars = variable.scalars.iter();
    variable.name == name || scalars.any(|(scalar, _)| scalar == name)
}

fn variable_text(variable: &Variable) -> String {
    let shown = |value: Option<f64>| match (value, variable.kind) {
        (None, _) => "–".to_owned(),
        (Some(value), VariableKind::Var) => short(value),
        (Some(value), VariableKind::Pos | VariableKind::Joint) => format!("{value:.2}"),
    };
    let scalars = variable.scalars.iter().map(|(_, value)| shown(*value));
    format!(
        "{} {}",
        variable.name,
        scalars.collect::<Vec<_>>().join(" ")
    )
}

/// Formats a number for a narrow list: whole numbers as they are, others to a thousandth.
fn short(value: f64) -> String {
    match value.fract() == 0.0 {
        true => value.to_string(),
        false => format!("{value:.3}"),
    }
}
