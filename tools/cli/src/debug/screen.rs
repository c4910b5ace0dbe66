//! The screen of the debugger: source, messages, variables, calls and targets as text, and drawings of the robot from above and
//! from the side.

use crate::debug::App;
use crate::message::DebugText;
use crate::report::fixed;
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Color, Modifier, Style};
use ratatui::symbols::Marker;
use ratatui::text::{Line, Span};
use ratatui::widgets::canvas::{self, Canvas, Circle};
use ratatui::widgets::{Block, Borders, Paragraph};
use std::collections::BTreeSet;
use tip_runtime::command::{TIMERS, Target};
use tip_runtime::controller::Setpoint;
use tip_runtime::model::Point;
use tip_runtime::plant::{ObjectState, Shape};
use tip_runtime::printable::Printable;
use tip_sim::debug::{By, Reason, Variable, control};
use tip_sim::message::Debugging;
use tip_view::robot_frame;
use tipc::message::Message;
use tipc::program::VariableKind;

/// Minimum width for help in one line.
const WIDE: u16 = 160;

pub(super) fn draw(app: &App, frame: &mut Frame<'_>) {
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
    let pane = block(app.say(DebugText::Calls));
    frame.render_widget(Paragraph::new(calls).block(pane), called);
    let pane = block(app.say(Debugging::Legs));
    frame.render_widget(Paragraph::new(legs).block(pane), setpoints);
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
    let pane = block(app.say(DebugText::Keys));
    frame.render_widget(Paragraph::new(lines.to_vec()).block(pane), area);
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
fn state(app: &App) -> String {
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
fn draw_source(app: &App, frame: &mut Frame<'_>, area: Rect) {
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
fn draw_messages(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let room = usize::from(area.height.saturating_sub(1));
    let all = app.debugger.messages();
    let last = all
        .get(all.len().saturating_sub(room)..)
        .unwrap_or_default();
    let lines = last
        .iter()
        .map(|(at, text)| Line::from(format!("{at:>6} {}", Printable::line(text))));
    let pane = block(app.say(DebugText::Said));
    frame.render_widget(Paragraph::new(lines.collect::<Vec<_>>()).block(pane), area);
}

/// Returns the open calls of the main program and of each thread that runs; where there are several, the one that is
/// looked at first.
fn calls(app: &App) -> Vec<Line<'static>> {
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
fn legs(app: &App) -> Vec<Line<'static>> {
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
        let numbers = aim.goal().iter().map(|value| fixed(*value, 0));
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
fn draw_variables(app: &App, frame: &mut Frame<'_>, area: Rect) {
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
        (Some(value), VariableKind::Pos | VariableKind::Joint) => fixed(value, 2),
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
        false => fixed(value, 3),
    }
}

/// Names of the axes.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Margin around a walking robot, mm.
const MARGIN: f64 = 80.0;

/// Margin around a hand, mm.
const HAND_MARGIN: f64 = 30.0;

/// Step in which views of hands move and all views grow, mm.
const STEP: f64 = 50.0;

/// Radius of a foot, mm.
const DOT: f64 = 14.0;

/// Number of corners of a disc.
const CORNERS: u16 = 24;

/// The axes of a view: to the right, and up.
type Axes = [usize; 2];

/// The drawn points in the world frame, mm.
struct Figure {
    legs: Vec<Vec<Point>>,
    /// The corners of each object.
    objects: Vec<Vec<Point>>,
    /// Height of the floor under the middle; the floor under a hand moves.
    floor: Option<f64>,
    is_planar: bool,
    /// Centre of the view.
    centre: Point,
}

/// Returns a pane with a title and a rule above it.
fn block(title: String) -> Block<'static> {
    Block::new().borders(Borders::TOP).title(title)
}

/// Draws both views.
fn draw_robot(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let [above, side] =
        Layout::horizontal([Constraint::Percentage(50), Constraint::Percentage(50)])
            .spacing(1)
            .areas(area);
    let figure = Figure::of(app);
    let (from_above, from_side) = match app.skeleton.is_planar {
        // A hand's fingers move in a plane whose height is y.
        true => ([0, 2], [0, 1]),
        false => ([0, 1], [1, 2]),
    };
    let title = |name: String, axes: Axes| {
        let [right, up] = axes.map(|axis| AXES[axis]);
        format!("{name} {right}→ {up}↑")
    };
    let name = title(app.say(Debugging::Above), from_above);
    figure.draw(frame, above, from_above, None, name);
    let name = title(app.say(DebugText::Side), from_side);
    figure.draw(frame, side, from_side, figure.floor, name);
}

impl Figure {
    fn of(app: &App) -> Self {
        let run = app.debugger.run();
        let place = run.motion().map(|motion| robot_frame(&motion.pose));
        let in_world = |point: Point| place.as_ref().map_or(point, |frame| frame.point(point));
        let joints = app
            .skeleton
            .legs
            .first()
            .map_or(1, |leg| leg.joints.len().max(1));
        let legs = run
            .angles()
            .chunks(joints)
            .enumerate()
            .map(|(leg, angles)| {
                let points = app.skeleton.points(leg, angles);
                points.into_iter().map(in_world).collect()
            });
        let legs: Vec<Vec<Point>> = legs.collect();
        let is_planar = app.skeleton.is_planar;
        let grasp = run.grasp();
        let floor = match (is_planar, &grasp) {
            (true, None) => None,
            (true, Some(grasp)) => Some(grasp.slider[1] + app.scene.floor.height),
            (false, _) => Some(app.scene.floor.height),
        };
        let states = grasp.map_or(Vec::new(), |grasp| grasp.objects);
        let objects = app.scene.objects.iter().flatten().zip(&states);
        Figure {
            objects: objects
                .map(|(object, state)| outline(&object.shape, state))
                .collect(),
            centre: match is_planar {
                true => middle(&legs),
                false => in_world([0.0; 3]),
            },
            legs,
            floor,
            is_planar,
        }
    }

    /// Returns the position of a point on the way around the body, from 0 to 4.
    fn around(&self, point: &Point) -> f64 {
        let (x, y) = (point[0] - self.centre[0], point[1] - self.centre[1]);
        let right = x / (x.abs() + y.abs()).max(f64::MIN_POSITIVE);
        if y < 0.0 { 3.0 + right } else { 1.0 - right }
    }

    /// Returns half of the visible width, mm; it grows in steps, so that the view does not jitter.
    fn reach(&self, axes: Axes) -> f64 {
        let far = |point: &Point| {
            let away = |axis: usize| (point[axis] - self.centre[axis]).abs();
            away(axes[0]).max(away(axes[1]))
        };
        let points = self.legs.iter().chain(&self.objects).flatten();
        let margin = if self.is_planar { HAND_MARGIN } else { MARGIN };
        let most = points.map(far).fold(100.0, f64::max) + margin;
        (most / STEP).ceil() * STEP
    }

    fn draw(
        &self,
        frame: &mut Frame<'_>,
        area: Rect,
        axes: Axes,
        floor: Option<f64>,
        title: String,
    ) {
        let (reach, [right, up]) = (self.reach(axes), axes);
        // Each cell has two columns and four rows of dots, all at the same distance.
        let inner = area.height.saturating_sub(1).max(1);
        let (across, high) = (2.0 * f64::from(area.width.max(1)), 4.0 * f64::from(inner));
        let (half_x, half_y) = match across > high {
            true => (reach * across / high, reach),
            false => (reach, reach * high / across),
        };
        let (x, y) = (self.centre[right], self.centre[up]);
        let canvas = Canvas::default()
            .block(block(title))
            .marker(Marker::Braille)
            .x_bounds([x - half_x, x + half_x])
            .y_bounds([y - half_y, y + half_y])
            .paint(|context| {
                let line = |from: &Point, to: &Point, color| canvas::Line {
                    x1: from[right],
                    y1: from[up],
                    x2: to[right],
                    y2: to[up],
                    color,
                };
                if let Some(floor) = floor {
                    context.draw(&canvas::Line {
                        x1: x - half_x,
                        y1: floor,
                        x2: x + half_x,
                        y2: floor,
                        color: Color::DarkGray,
                    });
                }
                let mut bases: Vec<&Point> =
                    self.legs.iter().filter_map(|leg| leg.first()).collect();
                bases.sort_by(|one, other| self.around(one).total_cmp(&self.around(other)));
                for (base, next) in bases.iter().zip(bases.iter().cycle().skip(1)) {
                    context.draw(&line(base, next, Color::Gray));
                }
                for leg in &self.legs {
                    for (from, to) in leg.iter().zip(leg.iter().skip(1)) {
                        context.draw(&line(from, to, Color::Cyan));
                    }
                    if let Some(foot) = leg.last() {
                        context.draw(&Circle {
                            x: foot[right],
                            y: foot[up],
                            radius: DOT,
                            color: Color::Yellow,
                        });
                    }
                }
                for object in &self.objects {
                    for (from, to) in object.iter().zip(object.iter().cycle().skip(1)) {
                        context.draw(&line(from, to, Color::Green));
                    }
                }
            });
        frame.render_widget(canvas, area);
    }
}

/// Returns the middle of the fingers, mm; it moves in steps, so that the view is steady.
fn middle(legs: &[Vec<Point>]) -> Point {
    std::array::from_fn(|axis| {
        let along = || legs.iter().flatten().map(|point| point[axis]);
        let (low, high) = (
            along().fold(f64::MAX, f64::min),
            along().fold(f64::MIN, f64::max),
        );
        ((low + high) / 2.0 / STEP).round() * STEP
    })
}

/// Returns the corners of an object in its plane, mm.
fn outline(shape: &Shape, state: &ObjectState) -> Vec<Point> {
    let corners: Vec<[f64; 2]> = match *shape {
        Shape::Disc { radius } => (0..CORNERS)
            .map(|corner| {
                let turn = 360.0 * f64::from(corner) / f64::from(CORNERS);
                let (sin, cos) = turn.to_radians().sin_cos();
                [radius * cos, radius * sin]
            })
            .collect(),
        Shape::Box { width, height } => {
            let (x, y) = (width / 2.0, height / 2.0);
            vec![[-x, -y], [x, -y], [x, y], [-x, y]]
        }
    };
    let (sin, cos) = state.angle.to_radians().sin_cos();
    let [x, y, z] = state.position;
    let placed =
        |[along, up]: [f64; 2]| [x + along * cos - up * sin, y + along * sin + up * cos, z];
    corners.into_iter().map(placed).collect()
}
