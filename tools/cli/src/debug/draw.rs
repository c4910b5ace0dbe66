//! The screen.

use super::app::App;
use super::{figure, panes, variables, words};
use ratatui::Frame;
use ratatui::layout::{Constraint, Layout, Rect};
use ratatui::style::{Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;
use tip_runtime::printable::Printable;
use tip_sim::message::Debugging;

/// Below this width the help takes two lines.
const WIDE: u16 = 160;

/// Draws everything.
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
    title(app, frame, top);
    let said = if body.height > 30 { 8 } else { 4 };
    let [source, messages] =
        Layout::vertical([Constraint::Min(0), Constraint::Length(said)]).areas(left);
    panes::source(app, frame, source);
    panes::messages(app, frame, messages);
    side(app, frame, right);
    last_line(app, frame, answer);
    helps(app, frame, help);
}

/// Variables, calls, legs and the robot.
fn side(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let calls = u16::try_from(app.debugger.frames().len()).unwrap_or(u16::MAX);
    let legs = panes::legs(app);
    let height = u16::try_from(legs.len()).unwrap_or(u16::MAX);
    let [variables, calls, aims, robot] = Layout::vertical([
        Constraint::Fill(3),
        Constraint::Length(calls.min(area.height / 5) + 1),
        Constraint::Length(height.min(area.height / 4) + 1),
        Constraint::Length(area.height * 2 / 5),
    ])
    .areas(area);
    variables::variables(app, frame, variables);
    panes::calls(app, frame, calls);
    let block = panes::block(app.say(Debugging::Legs));
    frame.render_widget(Paragraph::new(legs).block(block), aims);
    figure::robot(app, frame, robot);
}

/// The program, the time, and why it stands.
fn title(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let debugger = &app.debugger;
    let (now, known) = (debugger.now(), debugger.known());
    let name = Printable::line(app.source.name());
    let text = format!(
        " {name}  {now}/{known}  {:.0} ms  {}",
        debugger.run().time(),
        Printable::line(words::state(app))
    );
    let style = Style::new().add_modifier(Modifier::REVERSED);
    frame.render_widget(Paragraph::new(text).style(style), area);
}

/// What is asked, or what was answered.
fn last_line(app: &App, frame: &mut Frame<'_>, area: Rect) {
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

fn helps(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let [moves, others] = [Debugging::HelpMoves, Debugging::HelpOthers].map(|help| app.say(help));
    let text = match area.height {
        1 => format!("{moves}  {others}"),
        _ => format!("{moves}\n{others}"),
    };
    let style = Style::new().add_modifier(Modifier::DIM);
    frame.render_widget(Paragraph::new(text).style(style), area);
}
