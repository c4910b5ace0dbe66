//! The program, and what it does, as text.

use super::app::App;
use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Borders, Paragraph};
use std::collections::BTreeSet;
use tip_runtime::command::Target;
use tip_runtime::controller::Aim;
use tip_runtime::printable::Printable;
use tip_sim::debug::control;
use tip_sim::message::Debugging;

/// A list with a title; of lines that do not fit, the first ones are shown.
pub(super) fn block(title: String) -> Block<'static> {
    Block::new().borders(Borders::TOP).title(title)
}

/// The program around the line of the cursor.
pub(super) fn source(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let height = u32::from(area.height);
    let last = app.source.line_count();
    let first = app
        .cursor
        .saturating_sub(height / 2)
        .min((last + 1).saturating_sub(height))
        .max(1);
    let here = app.debugger.line();
    let marked: BTreeSet<u32> = app
        .debugger
        .breakpoint_lines()
        .map(|(line, _)| line)
        .collect();
    let lines = (first..=last).take(area.height.into()).map(|number| {
        let text = Printable::line(app.source.line_text(number)).to_string();
        let is_here = number == here;
        let mark = if marked.contains(&number) { "●" } else { " " };
        let arrow = if is_here { "▶" } else { " " };
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

/// What the program said last.
pub(super) fn messages(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let room = usize::from(area.height.saturating_sub(1));
    let all = app.debugger.messages();
    let last = all
        .get(all.len().saturating_sub(room)..)
        .unwrap_or_default();
    let lines = last
        .iter()
        .map(|(at, text)| Line::from(format!("{at:>6} {}", Printable::line(text))));
    let block = block(app.say(Debugging::Said));
    frame.render_widget(Paragraph::new(lines.collect::<Vec<_>>()).block(block), area);
}

pub(super) fn calls(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let lines = app.debugger.frames().into_iter().map(|call| {
        let name = call.name.unwrap_or_else(|| app.say(Debugging::MainProgram));
        Line::from(format!("{:>4} {name}", call.line))
    });
    let block = block(app.say(Debugging::Calls));
    frame.render_widget(Paragraph::new(lines.collect::<Vec<_>>()).block(block), area);
}

/// What each foot or joint is to do, a line for each leg.
pub(super) fn legs(app: &App) -> Vec<Line<'static>> {
    let aims = app.debugger.run().aims();
    let legs = (1..=app.skeleton.legs.len()).map(|leg| {
        let is_own = |aim: &&Aim| leg_of(aim.of).is_some_and(|of| usize::from(of) == leg);
        let own: Vec<&Aim> = aims.iter().filter(is_own).collect();
        Line::from(format!("{leg}: {}", aims_text(app, &own)))
    });
    let others: Vec<&Aim> = aims.iter().filter(|aim| leg_of(aim.of).is_none()).collect();
    let others = (!others.is_empty()).then(|| Line::from(aims_text(app, &others)));
    legs.chain(others).collect()
}

/// The joints of a leg that are all controlled in one way share its name.
fn aims_text(app: &App, aims: &[&Aim]) -> String {
    let goal = |aim: &Aim| {
        let numbers = aim.goal().iter().map(|value| format!("{value:.0}"));
        numbers.collect::<Vec<_>>().join(" ")
    };
    let mode = |aim: &Aim| app.say(control(aim.mode));
    match aims {
        [] => String::new(),
        [first, .., last] if aims.iter().all(|aim| aim.mode == first.mode) => {
            let goals: Vec<String> = aims.iter().map(|aim| goal(aim)).collect();
            let goals = goals.join(" ");
            format!("{}-{} {} {goals}", first.of, last.of, mode(first))
        }
        _ => {
            let parts = aims
                .iter()
                .map(|aim| format!("{} {} {}", aim.of, mode(aim), goal(aim)));
            parts.collect::<Vec<_>>().join(", ")
        }
    }
}

/// The leg of a foot or joint.
fn leg_of(target: Target) -> Option<u8> {
    match target {
        Target::Foot(leg) | Target::Joint(leg, _) => Some(leg),
        Target::None | Target::All | Target::Floor => None,
    }
}
