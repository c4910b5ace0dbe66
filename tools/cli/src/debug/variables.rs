//! The variables: one on each line, or as many as a line takes where there are too many.

use super::app::App;
use super::panes::block;
use ratatui::Frame;
use ratatui::layout::Rect;
use ratatui::style::{Color, Modifier, Style};
use ratatui::text::{Line, Span};
use ratatui::widgets::Paragraph;
use tip_sim::debug::Variable;
use tip_sim::message::Debugging;
use tipc::program::VariableKind;

/// Between two variables of a line.
const GAP: &str = "  ";

/// The variables of this page. What the last movement changed is bold, what is watched has a colour.
pub(super) fn variables(app: &App, frame: &mut Frame<'_>, area: Rect) {
    let variables = app.debugger.variables();
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

/// Lines of this width at most; a variable that is wider has a line for itself.
fn in_lines(app: &App, variables: &[Variable], width: usize) -> Vec<Line<'static>> {
    let mut lines: Vec<Line<'static>> = Vec::new();
    for variable in variables {
        let span = Span::styled(text(variable), style(app, variable));
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

fn style(app: &App, variable: &Variable) -> Style {
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

/// Whether a name is that of a variable, or of a member.
fn is_of(variable: &Variable, name: &str) -> bool {
    let mut scalars = variable.scalars.iter();
    variable.name == name || scalars.any(|(scalar, _)| scalar == name)
}

fn text(variable: &Variable) -> String {
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

/// A number for a narrow list: whole numbers as they are, others to a thousandth.
fn short(value: f64) -> String {
    match value.fract() == 0.0 {
        true => value.to_string(),
        false => format!("{value:.3}"),
    }
}
