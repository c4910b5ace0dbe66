//! Texts with expressions in braces, which log points say.

use super::Refused;
use super::ask::{Now, Question};
use tip_lint::ask::Asker;
use tip_runtime::fault::Fault;
use tipc::program::Program;

/// A text with expressions in braces: `stride {N} at {P}`.
#[derive(Debug)]
pub(super) struct Words(Vec<Part>);

#[derive(Debug)]
enum Part {
    Text(String),
    One(Question),
    /// The members of a POS or JOINT.
    Members(Vec<Question>),
}

impl Words {
    /// Braces that hold nothing, or are not closed, are text.
    pub(super) fn new(text: &str, program: &Program, asker: &Asker) -> Result<Self, Refused> {
        let mut parts = Vec::new();
        let mut rest = text;
        while let Some((before, after)) = rest.split_once('{') {
            let Some((inside, next)) = after.split_once('}') else {
                break;
            };
            parts.push(Part::Text(before.to_owned()));
            parts.push(match inside.trim() {
                "" => Part::Text(format!("{{{inside}}}")),
                asked => Part::asked(asked, program, asker)?,
            });
            rest = next;
        }
        parts.push(Part::Text(rest.to_owned()));
        Ok(Words(parts))
    }

    /// What it says at a position.
    pub(super) fn at(&self, now: &Now<'_>) -> String {
        self.0.iter().map(|part| part.at(now)).collect()
    }
}

impl Part {
    fn asked(text: &str, program: &Program, asker: &Asker) -> Result<Self, Refused> {
        let is_it = |name: &str| name.eq_ignore_ascii_case(text);
        let mut variables = program.variables().iter();
        let structure = variables.find(|it| is_it(&it.name) && it.size() > 1);
        let Some(structure) = structure else {
            return Question::new(text, asker).map(Part::One);
        };
        let members = structure.scalar_names();
        let members = members.map(|name| Question::new(&name, asker));
        members.collect::<Result<_, _>>().map(Part::Members)
    }

    fn at(&self, now: &Now<'_>) -> String {
        match self {
            Part::Text(text) => text.clone(),
            Part::One(question) => said(*question, now),
            Part::Members(members) => {
                let members = members.iter().map(|question| said(*question, now));
                format!("({})", members.collect::<Vec<_>>().join(", "))
            }
        }
    }
}

fn said(question: Question, now: &Now<'_>) -> String {
    match question.answer(now) {
        Ok(value) => value.to_string(),
        Err(Fault::Unassigned(_)) => "unassigned".to_owned(),
        Err(fault) => fault.to_string(),
    }
}
