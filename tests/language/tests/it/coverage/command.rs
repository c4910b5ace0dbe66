//! Which forms of a command a statement shows, and what happened.

use super::form::Form;
use super::outcome::Outcome;
use super::rule::is_optional;
use super::written::{Names, Written};
use tipc::Robot;
use tipc::code::Code;
use tipc::syntax::Operand;

/// A command in a program for a robot.
#[derive(Clone, Copy, Debug)]
pub struct Statement<'a> {
    /// The robot.
    pub robot: Robot,
    /// Declarations of the program.
    pub names: &'a Names,
    /// The arguments up to the first malformed one.
    pub arguments: &'a [Operand],
    /// True if there is a malformed one.
    pub malformed: bool,
}

impl Statement<'_> {
    /// Returns true if the statement is written in this form.
    pub fn shows(&self, form: &Form) -> bool {
        let written = self.written(form);
        written.is_flagged_as(form)
            && written.pieces.len() == form.length()
            && written.misfits(form, self.robot).is_empty()
    }

    /// Returns the meaning of a diagnostic for this form, if the statement is the form except for one mistake.
    pub fn refusal(&self, form: &Form, code: Code) -> Option<Outcome> {
        match code {
            Code::Argument => self.mistake(form),
            Code::UnknownCommand => Some(Outcome::UnknownCommand),
            _ => Outcome::of_code(code).filter(|_| self.shows(form)),
        }
    }

    fn written(&self, form: &Form) -> Written {
        Written::new(self.arguments, self.malformed, self.names, form)
    }

    /// Which mistake a `Wrong argument` is about.
    fn mistake(&self, form: &Form) -> Option<Outcome> {
        let mistake = self.mistake_anywhere(form);
        let has_head = form.head.is_none_or(|head| head.is_on(self.robot));
        mistake.filter(|mistake| has_head || *mistake == Outcome::Lacking)
    }

    fn mistake_anywhere(&self, form: &Form) -> Option<Outcome> {
        let mut written = self.written(form);
        let misfits = written.misfits(form, self.robot);
        let (found, wanted) = (written.pieces.len(), form.length());
        if written.malformed {
            let begins = misfits.is_empty() && found <= wanted && wanted > 0;
            let prefix = begins && written.is_flagged_as(form);
            return prefix.then_some(Outcome::Malformed);
        }
        let head = usize::from(form.head.is_some());
        if let [at] = misfits[..]
            && written.pieces[at].is_flag()
            && form.is_motion()
        {
            let replaced = at >= head && found == wanted;
            written.pieces.remove(at);
            let inserted =
                written.pieces.len() == wanted && written.misfits(form, self.robot).is_empty();
            let flag = (replaced || inserted) && written.is_flagged_as(form);
            return flag.then_some(Outcome::WrongFlag);
        }
        if !written.is_flagged_as(form) {
            return None;
        }
        match misfits[..] {
            // What stands there is another form of the command, and the mistake one in that.
            [] if found < wanted && is_optional(form, wanted) => None,
            [] if found > wanted && is_optional(form, wanted + 1) => None,
            [] if found < wanted => Some(Outcome::Missing),
            [] if found > wanted => Some(Outcome::Surplus),
            [] if written.flags.is_empty() => Some(Outcome::WrongType),
            [] => Some(Outcome::WrongFlag),
            [0] if head == 1 && found == wanted => {
                let word = written.pieces[0].word.as_deref().unwrap_or_default();
                let lacking = form.head.is_some_and(|head| head.names(word));
                Some(if lacking {
                    Outcome::Lacking
                } else {
                    Outcome::WrongTarget
                })
            }
            [_] if found == wanted => Some(Outcome::WrongType),
            _ => None,
        }
    }
}
