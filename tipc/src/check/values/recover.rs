//! Helps for values of commands that are missing, too many or no numbers.

use super::flag_name;
use crate::check::equations::type_of;
use crate::check::resolve::{Refused, Resolver};
use crate::check::targets::word;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::Edition;
use crate::language::commands::{self, Arguments, Form, Targets, Values};
use crate::message::phrase::Numbers;
use crate::message::{Commanding, Suggestion};
use crate::parse::is_unit;
use crate::program::VariableId;
use crate::source::Span;
use crate::syntax::{Operand, VariableKind, Word};
use tip_runtime::command::{ABSOLUTE, FAST, Op, RELATIVE, Target};

impl Resolver<'_> {
    /// Adds a help to a word that is reported in place of a number, if the words after it are wrong for the same
    /// reason: a second target, or a flag without a blank, as `R50`.
    pub(super) fn explain_word(
        &mut self,
        name: &Word,
        form: Arguments,
        operand: &Operand,
        fault: Refused,
    ) -> bool {
        let Some(text) = word(operand) else {
            return false;
        };
        let advice = if text.parse::<Target>().is_ok() {
            let command = name.node.clone();
            Some(Suggestion::OneTarget { command })
        } else {
            glued_flag(form, text)
        };
        let fault = fault.and_then(|fault| self.found.get_mut(fault));
        let Some((advice, fault)) = advice.zip(fault) else {
            return false;
        };
        fault.help = Some(advice.into());
        true
    }

    /// Returns location and variable of an operand that is read as a flag, although a variable has that name: `PTP F1 R
    /// 0 0`.
    pub(super) fn used_as_flag(
        &self,
        form: Arguments,
        operands: &[Operand],
    ) -> Option<(Span, VariableId)> {
        let used = operands
            .iter()
            .filter(|operand| flag_name(form, operand).is_some());
        let mut used = used.filter_map(|it| Some((it.span, self.names.find(word(it)?)?)));
        used.next()
    }

    pub(super) fn too_few<T>(
        &mut self,
        name: &Word,
        form: Arguments,
        location: Span,
        [wanted, found]: [usize; 2],
        used_as_flag: Option<(Span, VariableId)>,
    ) -> Option<T> {
        let whole = match form.values {
            Values::Position | Values::ThreeOrPos => Some(VariableKind::Pos),
            Values::Angles | Values::PerJoint | Values::PerLeg if wanted > 1 => {
                Some(VariableKind::Joint)
            }
            _ => None,
        };
        let reason = Commanding::TooFew {
            command: name.node.clone(),
            wanted: Numbers::new(wanted, whole.map(|kind| type_of(Some(kind)))),
            found: found.into(),
        };
        let mut fault = Diagnostic::new(Code::Argument, location, reason);
        if let Some((used, variable)) = used_as_flag {
            // The number is missing because the word is read as a flag.
            self.flags.insert(variable, used);
            let name = self.names.variables[variable].name.as_str().into();
            fault = fault.label(used, Suggestion::FlagHere);
            fault = fault.help(Suggestion::OtherName { name });
        }
        self.report(fault);
        None
    }

    /// Returns the help for an argument too many that another language explains.
    pub(super) fn extra_word(&self, name: &Word, operand: &Operand) -> Option<Suggestion> {
        match word(operand) {
            Some(FAST) => Some(Suggestion::FastFirst {
                command: name.node.clone(),
            }),
            Some(word) if word.parse::<Target>().is_ok() => Some(target_help(name)),
            Some(word) if commands::find_in(word, self.names.edition).is_some() => {
                Some(Suggestion::NextStatement)
            }
            Some(unit) if is_unit(unit) && self.names.find(unit).is_none() => {
                Some(Suggestion::NoUnit)
            }
            _ => self.comma_in_number(operand.span),
        }
    }

    /// Returns the digits after the only comma, if blanks separate the other arguments: `PTP F1 100,5 200 300`.
    pub(super) fn decimal_comma(&self, name: &Word) -> Option<(Span, Suggestion)> {
        let rest = self.rest_of_statement(name.span);
        let (before, after) = rest
            .split_once(',')
            .filter(|(_, after)| !after.contains(','))?;
        let digits = after
            .find(|c: char| !c.is_ascii_digit())
            .unwrap_or(after.len());
        let start = name.span.end + before.len() + 1;
        let location = Span::new(start, start + digits);
        Some((location, self.comma_in_number(location)?))
    }

    /// Returns the help for a comma right between digits, as in `1,000` or `4,5`.
    pub(super) fn comma_in_number(&self, location: Span) -> Option<Suggestion> {
        let text = self.source_before(location)?.strip_suffix(',')?;
        let digits = |c: char| c.is_ascii_digit();
        let before = &text[text.trim_end_matches(digits).len()..];
        let after = self.slice(location);
        let is_number = !before.is_empty() && !after.is_empty() && after.chars().all(digits);
        is_number.then(|| Suggestion::Comma {
            whole: format!("{before}{after}").into(),
            point: format!("{before}.{after}").into(),
        })
    }

    /// Refuses an argument too many.
    pub(super) fn too_many<T>(&mut self, name: &Word, operand: &Operand) -> Option<T> {
        let too_many = || Commanding::TooMany {
            command: name.node.clone(),
        };
        let advice = self.extra_word(name, operand);
        let advice = advice.map(|advice| (operand.span, advice));
        if let Some((location, advice)) = advice.or_else(|| self.decimal_comma(name)) {
            return self.refuse_with(Code::Argument, location, too_many(), advice);
        }
        let reason = match name.node.as_str() {
            // In version 2, WAIT_NEAR had this argument.
            name if name == Op::WaitNear.name() => Commanding::ToleranceElsewhere,
            _ => too_many(),
        };
        self.refuse(Code::Argument, operand.span, reason)
    }

    /// Adds a help to a target that is reported in place of a number: `SPEED F1 100`.
    pub(super) fn explain_target(&mut self, name: &Word, judged: &[Operand], fault: Refused) {
        let is_target =
            |operand: &Operand| word(operand).is_some_and(|it| it.parse::<Target>().is_ok());
        if let Some(fault) = fault.and_then(|fault| self.found.get_mut(fault))
            && judged.iter().any(is_target)
        {
            fault.help = Some(target_help(name).into());
        }
    }
}

fn takes_target(command: &str) -> bool {
    let form = commands::find_in(command, Edition::V3_2).map(|command| command.form);
    matches!(form, Some(Form::Robot(form)) if form.targets != Targets::NONE)
}

/// Returns the help for a flag without the blank after it, such as `R50`.
fn glued_flag(form: Arguments, word: &str) -> Option<Suggestion> {
    let flag = [RELATIVE, ABSOLUTE].into_iter().find(|flag| {
        let number = word.strip_prefix(*flag).unwrap_or_default();
        form.motion && !number.is_empty() && number.chars().all(|c| c.is_ascii_digit())
    })?;
    Some(Suggestion::FlagApart {
        flag,
        number: word[flag.len()..].into(),
    })
}

/// Returns what to write in place of a target among the values of a command.
fn target_help(name: &Word) -> Suggestion {
    let command = name.node.clone();
    match takes_target(&command) {
        true => Suggestion::OneTarget { command },
        false => Suggestion::NoTarget { command },
    }
}
