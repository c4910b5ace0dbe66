//! Conditions and expressions that a user evaluates while a program runs, in the language of the program.
//!
//! A query is read and checked as a line of a small program that has the declarations of its names. Other declarations
//! are left out, so that the time depends on the query alone.

use crate::Options;
use std::collections::{BTreeMap, HashMap};
use std::fmt::Write;
use tipc::code::{Code, Level};
use tipc::diagnostic::Diagnostic;
use tipc::language::commands::{COMMANDS, Meaning};
use tipc::language::{Edition, Keyword};
use tipc::load::lowered;
use tipc::message::Parsing;
use tipc::program::{
    Action, Condition, Operand, Program, Scalar, ScalarExpression, StructOperand, VariableId,
    VariableKind,
};
use tipc::source::Span;
use tipc::syntax::upper_case;

/// The variables of a program, and further names that only a query may use.
#[derive(Clone, Debug)]
pub struct QueryContext {
    options: Options,
    edition: Edition,
    names: HashMap<String, Meant>,
    /// The variable that an equation assigns, after all others.
    answer: String,
    /// The number of the first variable that is not the program's.
    own: usize,
    more: Vec<String>,
}

/// The meaning of a name in questions.
#[derive(Clone, Debug)]
enum Meant {
    /// A variable, with the names of its scalars.
    Variable {
        id: VariableId,
        kind: VariableKind,
        scalars: Vec<String>,
        /// False if the language or native code provides it.
        is_declared: bool,
    },
    Constant(f64),
}

impl QueryContext {
    /// Creates a context from a program that was loaded with these options. Each name of `more` that the program does
    /// not declare or define is a VAR as well; its number is that of the program's variables, and so on.
    pub fn new(program: &Program, options: Options, more: &[&str]) -> Self {
        let variables = program.variables();
        let constants = program.constants().iter();
        let constants = constants.map(|(name, value)| (name.to_string(), Meant::Constant(*value)));
        let mut names: HashMap<String, Meant> = constants.collect();
        for (id, variable) in variables.iter().enumerate() {
            let meant = Meant::Variable {
                id,
                kind: variable.kind,
                scalars: variable.scalar_names().collect(),
                // VAR_KEY is always there, and a variable shared with native code wherever it is named.
                is_declared: id > 0 && variable.special.is_none(),
            };
            names.insert(variable.name.clone(), meant);
        }
        let more = more.iter().filter(|name| !names.contains_key(**name));
        let more: Vec<String> = more.map(|name| (*name).to_owned()).collect();
        let mut answer = "ANSWER".to_owned();
        let own = variables.len();
        for (id, name) in (own..).zip(&more) {
            let meant = Meant::Variable {
                id,
                kind: VariableKind::Var,
                scalars: vec![name.clone()],
                is_declared: true,
            };
            names.insert(name.clone(), meant);
        }
        while names.contains_key(&answer) {
            answer.push('_');
        }
        QueryContext {
            options,
            edition: program.edition(),
            names,
            answer,
            own,
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
        let before = format!("{if} ");
        let after = format!(" {then}\n{end_if}\n{end}\n");
        let asked = self.asked(text, &before, &after)?;
        match asked.actions()[..] {
            [
                Action::If { condition, .. },
                Action::Nothing,
                Action::Finish(_),
            ] => asked.condition(*condition),
            _ => None,
        }
        .ok_or_else(|| refused(text))
    }

    /// Parses a text as a number, as it follows `=`.
    ///
    /// # Errors
    /// Returns what is wrong with it, located in the text.
    pub fn number(&self, text: &str) -> Result<ScalarExpression, Box<Diagnostic>> {
        let before = format!("{} = ", self.answer);
        let after = format!("\n{}\n", Keyword::End.word());
        let asked = self.asked(text, &before, &after)?;
        match asked.actions()[..] {
            [
                Action::SetScalar {
                    target,
                    update: None,
                    value,
                },
                Action::Finish(_),
            ] if asked.name(target.variable) == self.answer => asked.expression(*value),
            _ => None,
        }
        .ok_or_else(|| refused(text))
    }

    /// Loads a program that declares the names of a text, with the text between two others behind it.
    fn asked(&self, text: &str, before: &str, after: &str) -> Result<Asked<'_>, Box<Diagnostic>> {
        if text.contains(char::is_control) {
            return Err(refused(text));
        }
        let (mut whole, head_steps) = self.head(text);
        whole.push_str(before);
        let start = whole.len();
        whole.push_str(text);
        whole.push_str(after);
        let (loaded, found) = lowered("", whole.as_bytes(), &self.options);
        match loaded.program {
            Some(program) => Ok(Asked {
                names: &self.names,
                program,
                head_steps,
            }),
            None => {
                let errors = found.into_iter();
                let error = errors.min_by_key(|one| (one.level() != Level::Error, one.span));
                Err(error.map_or_else(|| refused(text), |error| placed(error, start, text)))
            }
        }
    }

    /// Returns lines 1 and 2, the declarations of what a text names, and a step for each of their scalars that assigns it:
    /// what is never assigned may not be read. Returns the number of these steps, too.
    fn head(&self, text: &str) -> (String, usize) {
        let upper = upper_case(text);
        let words = upper.split(|char: char| !(char.is_ascii_alphanumeric() || char == '_'));
        let named: BTreeMap<&str, &Meant> = words
            .filter_map(|word| Some((word, self.names.get(word)?)))
            .collect();
        // KEY_IN assigns VAR_KEY, which needs no declaration.
        let key_in = COMMANDS
            .iter()
            .find(|row| matches!(row.meaning, Meaning::KeyIn));
        let key_in = key_in.map_or("", |row| row.name);
        let mut head = format!("{}\n\n{key_in}\n", self.edition);
        declare(&mut head, VariableKind::Var, &self.answer);
        let mut steps = 1;
        for (name, meant) in named {
            match meant {
                Meant::Constant(value) => {
                    // A String takes all that is written.
                    let _ = writeln!(head, "{} {name} {value:?}", Keyword::Define.word());
                }
                Meant::Variable {
                    id,
                    kind,
                    scalars,
                    is_declared,
                } => {
                    if *is_declared {
                        declare(&mut head, *kind, name);
                    }
                    // KEY_IN assigns VAR_KEY.
                    for scalar in scalars.iter().filter(|_| *id > 0) {
                        let _ = writeln!(head, "{scalar} = 0");
                        steps += 1;
                    }
                }
            }
        }
        (head, steps)
    }
}

/// A query as a program of its own, whose variables have other numbers.
struct Asked<'a> {
    names: &'a HashMap<String, Meant>,
    program: Program,
    head_steps: usize,
}

impl Asked<'_> {
    /// Returns the actions of the question's steps.
    fn actions(&self) -> Vec<&Action> {
        let steps = self.program.steps().iter().skip(self.head_steps);
        steps.map(|step| &step.action).collect()
    }

    fn name(&self, variable: VariableId) -> &str {
        &self.program.variables()[variable].name
    }

    /// Returns the number of a variable in the program that the question is about. A shared variable that it does not name has
    /// no value in it.
    fn id(&self, variable: VariableId) -> Option<VariableId> {
        match self.names.get(self.name(variable))? {
            Meant::Variable { id, .. } => Some(*id),
            Meant::Constant(_) => None,
        }
    }

    fn operand(&self, operand: Operand) -> Option<Operand> {
        Some(match operand {
            Operand::Scalar { scalar, negative } => Operand::Scalar {
                scalar: Scalar {
                    variable: self.id(scalar.variable)?,
                    ..scalar
                },
                negative,
            },
            other => other,
        })
    }

    fn condition(&self, condition: Condition) -> Option<Condition> {
        Some(match condition {
            Condition::Compare {
                left,
                relation,
                right,
            } => Condition::Compare {
                left: self.operand(left)?,
                relation,
                right: self.operand(right)?,
            },
            flag @ Condition::Flag { .. } => flag,
        })
    }

    fn expression(&self, value: ScalarExpression) -> Option<ScalarExpression> {
        use ScalarExpression as E;
        Some(match value {
            E::Operand(operand) => E::Operand(self.operand(operand)?),
            E::Binary {
                left,
                operation,
                right,
            } => E::Binary {
                left: self.operand(left)?,
                operation,
                right: self.operand(right)?,
            },
            E::Function { function, operand } => E::Function {
                function,
                operand: self.operand(operand)?,
            },
            E::Atan2 { y, x } => E::Atan2 {
                y: self.operand(y)?,
                x: self.operand(x)?,
            },
            E::Norm(StructOperand::Variable(variable)) => {
                E::Norm(StructOperand::Variable(self.id(variable)?))
            }
            E::Norm(reading) => E::Norm(reading),
        })
    }
}

fn declare(head: &mut String, kind: VariableKind, name: &str) {
    // A String takes all that is written.
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
