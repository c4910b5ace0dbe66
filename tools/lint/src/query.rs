//! Conditions and equations that someone asks of a program while it runs, in the program's own language.
//!
//! A question is read and checked as a line of a program that has the same variables and constants, so that whoever knows
//! the language knows how to ask.

use crate::Options;
use std::fmt::Write;
use tipc::code::{Code, Level};
use tipc::diagnostic::Diagnostic;
use tipc::language::Keyword;
use tipc::language::commands::{COMMANDS, Meaning};
use tipc::load::lowered;
use tipc::message::Parsing;
use tipc::program::{Action, Condition, Program, ScalarExpression, Variable, VariableKind};
use tipc::source::Span;

/// A program's variables, and more that only a query may name.
#[derive(Clone, Debug)]
pub struct QueryContext {
    options: Options,
    /// Lines 1 and 2, a declaration of each variable, and a step for each scalar that assigns it: what is never assigned may
    /// not be read.
    head: String,
    /// The variable that an equation assigns, after all others.
    answer: String,
    /// The variables from here on are none of the program's.
    own: usize,
    more: Vec<String>,
    head_steps: usize,
}

impl QueryContext {
    /// Creates a context from a program that was loaded with these options. Each name of `more` that the program does
    /// not declare or define is a VAR as well; its number is that of the program's variables, and so on.
    pub fn new(program: &Program, options: Options, more: &[&str]) -> Self {
        let (variables, constants) = (program.variables(), program.constants());
        let is_free = |name: &str| {
            variables.iter().all(|variable| variable.name != name)
                && constants.iter().all(|(constant, _)| constant != name)
        };
        let more = more.iter().filter(|name| is_free(name));
        let more: Vec<String> = more.map(|name| (*name).to_owned()).collect();
        let mut answer = "ANSWER".to_owned();
        while !is_free(&answer) {
            answer.push('_');
        }
        let mut head = format!("{}\n\n", program.edition());
        // VAR_KEY is always there, and a variable shared with native code wherever it is named.
        let declared = variables.iter().skip(1);
        for Variable { name, kind, .. } in declared.filter(|it| it.special.is_none()) {
            declare(&mut head, *kind, name);
        }
        for (name, value) in constants {
            let _ = writeln!(head, "{} {name} {value:?}", Keyword::Define.word());
        }
        for name in more.iter().chain([&answer]) {
            declare(&mut head, VariableKind::Var, name);
        }
        // What KEY_IN assigns without being asked to.
        let key_in = COMMANDS
            .iter()
            .find(|row| matches!(row.meaning, Meaning::KeyIn));
        let _ = writeln!(head, "{}", key_in.map_or("", |row| row.name));
        for scalar in program.scalar_names().skip(1).chain(more.iter().cloned()) {
            let _ = writeln!(head, "{scalar} = 0");
        }
        QueryContext {
            options,
            head,
            answer,
            own: variables.len(),
            head_steps: program.scalar_count() + more.len(),
            more,
        }
    }

    /// Returns the number of the program's variables; those from there on belong to the query.
    pub fn own(&self) -> usize {
        self.own
    }

    /// Returns the names that are not the program's, in the order of their numbers.
    pub fn more(&self) -> &[String] {
        &self.more
    }

    /// Parses a text as a condition, as it follows IF.
    ///
    /// # Errors
    /// Returns what is wrong with it, located in the text.
    pub fn condition(&self, text: &str) -> Result<Condition, Box<Diagnostic>> {
        let [r#if, then, end_if, end] =
            [Keyword::If, Keyword::Then, Keyword::EndIf, Keyword::End].map(Keyword::word);
        let rest = format!(" {then}\n{end_if}\n{end}\n");
        let lines = [r#if, " ", text, &rest];
        match &self.steps(text, &lines)?[..] {
            [
                Action::If { condition, .. },
                Action::Nothing,
                Action::Finish(_),
            ] => Ok(*condition),
            _ => Err(refused(text)),
        }
    }

    /// Parses a text as a number, as it follows `=`.
    ///
    /// # Errors
    /// Returns what is wrong with it, located in the text.
    pub fn number(&self, text: &str) -> Result<ScalarExpression, Box<Diagnostic>> {
        let rest = format!("\n{}\n", Keyword::End.word());
        let lines = [&self.answer, " = ", text, &rest];
        match &self.steps(text, &lines)?[..] {
            [
                Action::SetScalar {
                    target,
                    update: None,
                    value,
                },
                Action::Finish(_),
            ] if target.variable == self.own + self.more.len() => Ok(*value),
            _ => Err(refused(text)),
        }
    }

    /// Returns the actions of the steps of a program with these lines.
    fn steps(&self, text: &str, lines: &[&str]) -> Result<Vec<Action>, Box<Diagnostic>> {
        if text.contains(char::is_control) {
            return Err(refused(text));
        }
        let mut whole = self.head.clone();
        let mut start = 0;
        for line in lines {
            if std::ptr::eq(*line, text) {
                start = whole.len();
            }
            whole.push_str(line);
        }
        let (loaded, found) = lowered("", whole.as_bytes(), &self.options);
        match loaded.program {
            // A shared variable that the program itself does not name has no value in it.
            Some(program) if program.variables().len() != self.own + self.more.len() + 1 => {
                Err(refused(text))
            }
            Some(program) => {
                let steps = program.steps().iter().skip(self.head_steps);
                Ok(steps.map(|step| step.action.clone()).collect())
            }
            None => {
                let errors = found.into_iter();
                let error = errors.min_by_key(|one| (one.level() != Level::Error, one.span));
                Err(error.map_or_else(|| refused(text), |error| placed(error, start, text)))
            }
        }
    }
}

fn declare(head: &mut String, kind: VariableKind, name: &str) {
    // A String takes whatever is written.
    let _ = writeln!(head, "{} {name}", keyword(kind).word());
}

const fn keyword(kind: VariableKind) -> Keyword {
    match kind {
        VariableKind::Var => Keyword::DefVar,
        VariableKind::Pos => Keyword::DefPos,
        VariableKind::Joint => Keyword::DefJoint,
    }
}

/// Moves an error in a program to the text that begins at `start`.
fn placed(mut error: Diagnostic, start: usize, text: &str) -> Box<Diagnostic> {
    let at = |offset: usize| offset.saturating_sub(start).min(text.len());
    error.span = Span::new(at(error.span.start), at(error.span.end));
    error.labels.clear();
    error.fixes.clear();
    Box::new(error)
}

/// Refuses a text that is more than one condition or number.
fn refused(text: &str) -> Box<Diagnostic> {
    let span = Span::new(0, text.len());
    Box::new(Diagnostic::new(Code::Argument, span, Parsing::Conditions))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tipc::Robot;
    use tipc::message::Lang;
    use tipc::program::{Operand, Relation, Scalar, StructOperand};

    const TEXT: &str = "3.1\nAsked\nDEF_VAR A, TIME\nDEF_POS P\nDEF_JOINT Q\nA = 1\nEND\n";

    fn queries() -> QueryContext {
        let options = Options {
            robot: Robot::Titan8,
            ..Options::default()
        };
        let program = lowered("asked.prg", TEXT.as_bytes(), &options).0.program;
        QueryContext::new(&program.expect("it is right"), options, &["CYCLE", "TIME"])
    }

    fn scalar(variable: usize, member: usize) -> Operand {
        Operand::Scalar {
            scalar: Scalar { variable, member },
            negative: false,
        }
    }

    #[test]
    fn a_condition_names_the_programs_variables_by_their_numbers() {
        let queries = queries();
        assert_eq!(queries.own(), 5, "VAR_KEY, A, TIME, P and Q");
        let compared = |left, right| Condition::Compare {
            left,
            relation: Relation::Ge,
            right,
        };
        let condition = queries.condition("q.j2 >= p.z");
        assert_eq!(condition, Ok(compared(scalar(4, 1), scalar(3, 2))));
        // TIME is the program's own; CYCLE comes after all of them.
        let condition = queries.condition("TIME >= CYCLE");
        assert_eq!(condition, Ok(compared(scalar(2, 0), scalar(5, 0))));
        assert!(matches!(
            queries.condition("!HALT_REQUEST"),
            Ok(Condition::Flag { negated: true, .. })
        ));
    }

    #[test]
    fn a_number_is_whatever_an_equation_has_on_its_right() {
        let queries = queries();
        let value = queries.number("P.X");
        assert_eq!(value, Ok(ScalarExpression::Operand(scalar(3, 0))));
        assert!(queries.number("A + CYCLE").is_ok());
        assert_eq!(
            queries.number("NORM P"),
            Ok(ScalarExpression::Norm(StructOperand::Variable(3)))
        );
    }

    // clauses: 13.2 13.3
    #[test]
    fn a_program_of_3_2_is_asked_in_its_edition() {
        let text = "3.2\nAsked\nDEF_VAR A\nDEFINE FAR -1E20\nDEFINE TIME FAR\nA = 1\nPOS_SPECIAL_1.X = A\n\
            VAR_SPECIAL_4 = A\nEND\n";
        let options = Options::default();
        let program = lowered("asked.prg", text.as_bytes(), &options).0.program;
        let more = &["CYCLE", "TIME"];
        let queries = QueryContext::new(&program.expect("it is right"), options, more);
        assert_eq!(queries.own(), 4, "VAR_KEY, VAR_SPECIAL_4, POS_SPECIAL_1, A");
        let value = |text| queries.number(text).map_err(|error| error.span.start);
        let variable = |variable, member| Ok(ScalarExpression::Operand(scalar(variable, member)));
        assert_eq!(value("VAR_SPECIAL_4"), variable(1, 0));
        assert_eq!(value("POS_SPECIAL_1.Y"), variable(2, 1));
        assert_eq!(value("A"), variable(3, 0));
        assert_eq!(value("CYCLE"), variable(4, 0));
        assert!(value("@TIMER0").is_ok());
        let constant = |value| Ok(ScalarExpression::Operand(Operand::Constant(value)));
        assert_eq!(value("-far"), constant(1e20));
        assert_eq!(value("TIME"), constant(-1e20), "the program's own");
        // The program has no such variable.
        assert!(value("VAR_SPECIAL_5").is_err());
    }

    #[test]
    fn what_is_wrong_is_placed_in_the_text() {
        let queries = queries();
        for (text, start) in [
            ("HEIGHT > 3", 0),
            ("A > HEIGHT", 4),
            ("A = 3", 2),
            ("", 0),
            // The THEN that follows is one too many.
            ("A > 3 THEN", 10),
            ("A > 3\nA = 2\nIF A > 3", 0),
            ("A > \u{7F}", 0),
        ] {
            let error = queries.condition(text).expect_err(text);
            assert_eq!(error.span.start, start, "{text}");
            assert!(error.span.end <= text.len(), "{text}");
            assert!(!error.headline(Lang::English).is_empty(), "{text}");
        }
        for text in ["P", "1 +", "1 + 2 + 3", "1\nA = 2", "A > 3"] {
            assert!(queries.number(text).is_err(), "{text}");
        }
    }
}
