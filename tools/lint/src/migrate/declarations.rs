//! The DEF lines that version 3.0 asks for, and names that became words of the language.

use super::Migrator;
use super::header::Title;
use super::lines::Statement;
use super::variables::Variables;
use crate::message::Declared;
use crate::message::Migrating;
use tipc::language::Edition;
use tipc::language::reserved::is_reserved;
use tipc::syntax::VariableKind;

/// Maximum number of names in a declaration line.
const NAMES_PER_LINE: usize = 8;

impl Migrator<'_> {
    /// Declares every variable after the title, which is put in if it is missing.
    pub(super) fn declare(&mut self, variables: &Variables, title: Title) {
        let above = self.source.line(title.first_line() - 1).span;
        let mut lines = Vec::new();
        if title == Title::Missing {
            lines.push(String::new());
            self.change(above, Migrating::EmptyTitle);
        }
        for (kind, keyword) in [
            (VariableKind::Var, "DEF_VAR"),
            (VariableKind::Pos, "DEF_POS"),
            (VariableKind::Joint, "DEF_JOINT"),
        ] {
            let names = variables.to_declare(kind);
            for names in names.chunks(NAMES_PER_LINE) {
                let line = format!("{keyword} {}", names.join(", "));
                lines.push(line.clone());
                let (line, declared) = (line.into(), declared(kind));
                self.change(above, Migrating::Declares { line, declared });
            }
        }
        let end = self.line_end();
        let text: String = lines.iter().map(|line| format!("{end}{line}")).collect();
        if !text.is_empty() {
            self.edits.insert(above.end, text);
        }
    }

    /// Returns the line end of the program.
    fn line_end(&self) -> &'static str {
        match self.slice(self.source.line(1).end) {
            "\r\n" => "\r\n",
            "\r" => "\r",
            _ => "\n",
        }
    }

    /// Asks for another name of a variable whose name is a word of the language now.
    pub(super) fn clashes(&mut self, statement: &Statement) {
        for name in statement.words().skip(1) {
            let word = self.slice(name).to_ascii_uppercase();
            if is_reserved(&word, Edition::V3_1) {
                self.question(name, Migrating::WordOfLanguage { word });
            }
        }
    }
}

fn declared(kind: VariableKind) -> Declared {
    match kind {
        VariableKind::Joint => Declared::OneType,
        _ => Declared::Plainly,
    }
}
