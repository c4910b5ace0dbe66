//! Values in MESSAGE: a VAR by its number before 3.0, by its name since.

use super::Migrator;
use super::lines::Statement;
use super::placeholders::old_placeholders;
use super::variables::Variables;
use crate::message::Migrating;
use tipc::source::Span;

/// Number of decimals of `%fnn%`: as C's `%f`, whose letter it is.
const DECIMALS: u8 = 6;

impl Migrator<'_> {
    /// Placeholders of today, and what would be read otherwise today.
    pub(super) fn message(&mut self, statement: &Statement, variables: &Variables) {
        let text = self.slice(statement.text).to_owned();
        let location =
            |start, end| Span::new(statement.text.start + start, statement.text.start + end);
        if let Some(at) = text.find(';') {
            self.question(location(at, at + 1), Migrating::Semicolon);
        }
        let old = old_placeholders(&text);
        let behind = old
            .iter()
            .map(|placeholder| placeholder.start)
            .chain([text.len()]);
        let before = [0]
            .into_iter()
            .chain(old.iter().map(|placeholder| placeholder.end));
        for (start, end) in before.zip(behind) {
            if let Some(name) = names_a_variable(&text[start..end], variables) {
                self.question(location(start, end), Migrating::PlainText { name });
            }
        }
        for placeholder in &old {
            let span = location(placeholder.start, placeholder.end);
            let name = variables.var(&placeholder.digits).unwrap_or_default();
            let new = if placeholder.real {
                format!("%{name}.{DECIMALS}%")
            } else {
                format!("%{name}%")
            };
            self.edits.replace(span, new.as_str());
            let old = text[placeholder.start..placeholder.end].to_owned();
            self.change(span, Migrating::Placeholder { old, new });
        }
    }
}

/// Returns a variable that plain text would show today.
fn names_a_variable(text: &str, variables: &Variables) -> Option<String> {
    let words = text.split('%').skip(1);
    let closed = text.matches('%').count().saturating_sub(1);
    words
        .take(closed)
        .map(|word| {
            word.split('.')
                .next()
                .unwrap_or_default()
                .to_ascii_uppercase()
        })
        .find(|name| variables.is_var(name))
}
