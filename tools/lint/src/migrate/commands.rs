//! Commands that got another name or another form.

use super::Migrator;
use super::lines::Statement;
use crate::message::Migrating;
use tipc::language::commands::{COMMANDS, find};
use tipc::lex::Kind;
use tipc::source::Span;
use tipc::syntax::Arithmetic;

/// Suffixes after the name of a parameter.
const SUFFIXES: &[&str] = &["_RATE", "_SLOW", "_FAST", "_NORMAL", "_FIRMLY", "_SOFT"];

/// The parameters, as old programs call them and as they are called now.
const PARAMETERS: &[(&str, &str)] = &[
    ("A_MAX", "A_MAX"),
    ("V_MAX", "V_MAX"),
    ("OMEGA_MAX", "OMEGA_MAX"),
    ("OMEGA_DOT_MAX", "OMEGA_DOT_MAX"),
    ("TORQUE_MAX", "TORQUE_MAX"),
    ("T_MAX", "TORQUE_MAX"),
];

/// Returns the name of today of a parameter command, if it has another one (§1-1, 2.0).
fn parameter_command(keyword: &str) -> Option<String> {
    let bare = keyword.strip_prefix("SET_").unwrap_or(keyword);
    let suffix = SUFFIXES.iter().find(|suffix| bare.ends_with(**suffix));
    let suffix = suffix.copied().unwrap_or_default();
    let base = &bare[..bare.len() - suffix.len()];
    let (_, now) = PARAMETERS.iter().find(|(old, _)| *old == base)?;
    let name = format!("SET_{now}{suffix}");
    (name != keyword && find(&name).is_some()).then_some(name)
}

/// Returns true if an old statement may start with this word.
pub(super) fn is_statement_word(keyword: &str) -> bool {
    let renamed = ["COMPLIANCE", "SET_INPOS", "SET_NEAR"];
    COMMANDS
        .iter()
        .any(|command| command.name == keyword || command.alias == Some(keyword))
        || renamed.contains(&keyword)
        || parameter_command(keyword).is_some()
}

impl Migrator<'_> {
    /// Migrates a command that is neither of the special ones nor an equation.
    pub(super) fn command(&mut self, statement: &Statement) {
        match statement.keyword.as_str() {
            "SET_INPOS" => self.tolerance(statement, "SET_JUST_POSITION"),
            "SET_NEAR" => self.tolerance(statement, "SET_NEAR_POSITION"),
            "COMPLIANCE" => self.compliance(statement),
            keyword => {
                if let Some(name) = parameter_command(keyword) {
                    self.rename(statement.word, &name);
                    let old = keyword.to_owned();
                    self.change(statement.word, Migrating::IsSince2_0 { old, new: name });
                }
            }
        }
    }

    fn tolerance(&mut self, statement: &Statement, name: &str) {
        let target = statement.words().nth(1).unwrap_or(statement.word);
        let target_name = self.slice(target).to_ascii_uppercase();
        let keyword = &statement.keyword;
        if target_name.starts_with('J') {
            let text = Migrating::TwoSuccessors {
                old: keyword.clone(),
                target: target_name,
                feet: name.to_owned(),
                joints: name.replace("POSITION", "ANGLE"),
            };
            return self.question(target, text);
        }
        self.rename(statement.word, name);
        let (old, new) = (keyword.clone(), name.to_owned());
        self.change(statement.word, Migrating::IsSince3_1 { old, new });
    }

    fn compliance(&mut self, statement: &Statement) {
        let words = statement.words().skip(1);
        let words: Vec<String> = words
            .map(|word| self.slice(word).to_ascii_uppercase())
            .collect();
        let values = words
            .iter()
            .skip(1)
            .filter(|word| !["R", "A", "HS"].contains(&word.as_str()));
        let fits = match (words.first(), values.count()) {
            (Some(target), 1) => target.starts_with(['F', 'J', 'A']),
            (Some(target), 3) => target.starts_with(['F', 'A']),
            _ => false,
        };
        if !fits {
            return self.question(statement.word, Migrating::NotTheAngles);
        }
        self.rename(statement.word, "COMPLIANCE_ANGLE");
        self.change(statement.word, Migrating::Compliance);
    }

    /// `FOR A B TO C` → `FOR A = B TO C`
    pub(super) fn for_statement(&mut self, statement: &Statement) {
        let [_, variable, from, _, ..] = statement.tokens.as_slice() else {
            return;
        };
        let has_sign = matches!(from.kind, Kind::Assign(_));
        let is_operand = matches!(
            from.kind,
            Kind::Word | Kind::Arithmetic(Arithmetic::Sub | Arithmetic::Add)
        );
        if variable.kind != Kind::Word || has_sign || !is_operand {
            return;
        }
        if self.slice(from.span).eq_ignore_ascii_case("TO") {
            return;
        }
        self.edits.insert(from.span.start, "= ");
        let variable = self.slice(variable.span).to_ascii_uppercase();
        self.change(from.span, Migrating::AssignmentBehindFor { variable });
    }

    /// `A = - B` → `A = -B`
    pub(super) fn sign(&mut self, statement: &Statement) {
        let [_, _, sign, operand, ..] = statement.tokens.as_slice() else {
            return;
        };
        let is_split = sign.kind == Kind::Arithmetic(Arithmetic::Sub)
            && operand.kind == Kind::Word
            && operand.spaced;
        if is_split {
            let blanks = Span::new(sign.span.end, operand.span.start);
            self.edits.replace(blanks, "");
            let operand = self.slice(operand.span).to_ascii_uppercase();
            self.change(sign.span, Migrating::Sign { operand });
        }
    }

    /// Migrates REM to a comment: it was no step before 3.0; a comment is none now.
    pub(super) fn remark(&mut self, statement: &Statement) {
        self.edits.replace(statement.word, "//");
        self.change(statement.word, Migrating::Remark);
    }
}
