//! What keys do.

use super::app::{App, Question};
use ratatui::crossterm::event::{KeyCode, KeyEvent, KeyModifiers};
use tip_sim::debug::Move;

/// Lines of a page.
const PAGE: i64 = 15;

/// A key is pressed.
pub(crate) fn press(app: &mut App, key: KeyEvent) {
    if key.modifiers.contains(KeyModifiers::CONTROL) {
        if key.code == KeyCode::Char('c') {
            app.quit();
        }
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

/// Types an answer.
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

/// A letter; a capital one goes back, or asks for more.
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
        ('.', _) => app.cursor = app.debugger.line(),
        ('k', false) => app.move_cursor(-1),
        ('j', false) => app.move_cursor(1),
        _ => {}
    }
}
