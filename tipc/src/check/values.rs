//! The values of commands: numbers with their flags, or a struct in their place; and constants that a command or an
//! equation refuses at runtime.

use super::equations::type_of;
use super::names::kind_of;
use super::resolve::{Refused, Resolver};
use super::targets::word;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::{self, Arguments, Form, Limit, Targets, Values};
use crate::language::functions::{self, Operation};
use crate::language::{Edition, reserved};
use crate::message::phrase::{Bounds, Numbers};
use crate::message::{Calculating, Commanding, Suggestion};
use crate::parse::is_unit;
use crate::program::{self, Argument, Arithmetic, Function, Mark, StructOperand, VariableId};
use crate::robot::Robot;
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::{Equation, Expression, Operand, OperandKind, VariableKind, Word};
use tip_runtime::command::{ABSOLUTE, FAST, Op, RELATIVE, TIMERS, Target};
use tip_runtime::model::Range;

impl Resolver<'_> {
    pub(super) fn values(
        &mut self,
        name: &Word,
        form: Arguments,
        target: Target,
        operands: &[Operand],
    ) -> Option<Vec<Argument>> {
        let joints = usize::from(self.robot.signature().joints);
        let single = matches!(target, Target::Joint(..));
        let one_for_all = target == Target::All
            && operands.len() < joints
            && !self.is_of(operands, VariableKind::Joint);
        match form.values {
            Values::None => {
                self.no_more(name, operands)?;
                Some(Vec::new())
            }
            Values::One => self.plain_values(name, operands, 1),
            Values::ThreeOrPos if self.is_of(operands, VariableKind::Pos) => {
                self.vector(name, form, operands, VariableKind::Pos, 3)
            }
            Values::Three | Values::ThreeOrPos => self.plain_values(name, operands, 3),
            Values::Limits if single => self.scalars(name, form, operands, 2),
            Values::Limits => self.two_joints(name, operands),
            Values::Angles if single => self.scalars(name, form, operands, 1),
            Values::PerLeg if target == Target::All => self.plain_values(name, operands, 1),
            Values::PerJoint | Values::PerLeg if single || one_for_all => {
                self.plain_values(name, operands, 1)
            }
            Values::Position => self.vector(name, form, operands, VariableKind::Pos, 3),
            Values::Angles | Values::PerJoint | Values::PerLeg => {
                self.vector(name, form, operands, VariableKind::Joint, joints)
            }
        }
    }

    /// Returns true if the first operand is a whole struct of a type.
    fn is_of(&self, operands: &[Operand], kind: VariableKind) -> bool {
        let named = operands
            .first()
            .and_then(|operand| self.struct_named(operand));
        named.is_some_and(|(_, of)| of == kind)
    }

    /// Returns the whole variable that an operand without sign names, and its type.
    fn struct_named(&self, operand: &Operand) -> Option<(StructOperand, VariableKind)> {
        let name = word(operand)?;
        if let Some(id) = self.names.find(name) {
            let kind = self.names.variables[id].kind;
            return Some((StructOperand::Variable(id), kind));
        }
        let reading = reserved::reading(name, self.names.edition)?;
        Some((StructOperand::Reading(reading), kind_of(reading)))
    }

    /// Reads two JOINTs: the lower and the upper limits of a leg.
    fn two_joints(&mut self, name: &Word, operands: &[Operand]) -> Option<Vec<Argument>> {
        let mut read = Vec::new();
        for operand in operands.iter().take(2) {
            read.push(self.joint(name, operand)?);
        }
        let [low, high] = read[..] else {
            let reason = Commanding::WantsTwoJoints {
                command: name.node.clone(),
            };
            return self.refuse(Code::Argument, name.span, reason);
        };
        self.no_more(name, &operands[2..])?;
        let both = [low, high].into_iter();
        Some(
            both.flat_map(|whole| self.members(whole, Mark::None))
                .collect(),
        )
    }

    fn joint(&mut self, name: &Word, operand: &Operand) -> Option<StructOperand> {
        let kind = Some(VariableKind::Joint);
        let meant = self
            .resolve_operand_as(operand, Code::Argument, kind)
            .ok()?;
        self.uses.operand(operand, meant, Access::Read);
        match meant.structure() {
            Some((whole, VariableKind::Joint, false)) => Some(whole),
            _ => {
                let reason = Commanding::WantsTwoJoints {
                    command: name.node.clone(),
                };
                self.refuse(Code::Argument, operand.span, reason)
            }
        }
    }

    /// Reads three or n scalars, or one struct in their place.
    fn vector(
        &mut self,
        name: &Word,
        form: Arguments,
        operands: &[Operand],
        kind: VariableKind,
        count: usize,
    ) -> Option<Vec<Argument>> {
        let flagged = usize::from(self.flag_of(form, operands).is_some());
        let whole = operands
            .get(flagged)
            .and_then(word)
            .filter(|name| !is_flag(form, name));
        if whole.is_some_and(|name| self.names.is_refused(name)) {
            return None;
        }
        let named = whole.and_then(|_| self.struct_named(&operands[flagged]));
        if let (None, Some(_), [operand]) = (named, whole, &operands[flagged..]) {
            // The only operand can only be meant as a struct.
            self.resolve_operand_as(operand, Code::Argument, Some(kind))
                .ok()?;
        }
        let operand = match named {
            None | Some((_, VariableKind::Var)) => {
                return self.scalars(name, form, operands, count);
            }
            Some((whole, of)) if of == kind => whole,
            Some((_, of)) => {
                let reason = Commanding::OtherType {
                    command: name.node.clone(),
                    wanted: Numbers::new(count, Some(type_of(Some(kind)))),
                    found: type_of(Some(of)),
                };
                return self.refuse(Code::Argument, operands[flagged].span, reason);
            }
        };
        self.no_more(name, &operands[flagged + 1..])?;
        let mark = self.mark(form, operands)?;
        let meant = self
            .resolve_operand_as(&operands[flagged], Code::Argument, Some(kind))
            .ok()?;
        self.uses.operand(&operands[flagged], meant, Access::Read);
        Some(self.members(operand, mark).collect())
    }

    /// Returns the members of a struct as arguments.
    fn members(&self, whole: StructOperand, mark: Mark) -> impl Iterator<Item = Argument> + use<> {
        (0..self.names.size_of(whole)).map(move |member| Argument {
            operand: whole.member(member),
            mark,
        })
    }

    /// Reads `count` scalars, each with its flag.
    fn scalars(
        &mut self,
        name: &Word,
        form: Arguments,
        operands: &[Operand],
        count: usize,
    ) -> Option<Vec<Argument>> {
        let mut rest = operands;
        let mut values = Vec::with_capacity(count);
        for _ in 0..count {
            let mark = self.mark(form, rest)?;
            let flag = rest.first().filter(|_| self.flag_of(form, rest).is_some());
            rest = &rest[usize::from(flag.is_some())..];
            let Some((operand, behind)) = rest.split_first() else {
                if values.contains(&None) {
                    // An unknown name may be meant as a struct.
                    return None;
                }
                let location = flag.map_or(name.span, |flag| flag.span);
                let used = self.used_as_flag(form, operands);
                let used = used.filter(|(used, _)| *used != location);
                return self.too_few(name, form, location, [count, values.len()], used);
            };
            if let Some(flag) = flag_name(form, operand) {
                let reason = Commanding::FlagBeforeNumber { flag: flag.into() };
                return self.refuse(Code::Argument, operand.span, reason);
            }
            let number = self.number(operand, Code::Argument);
            if let Err(fault) = number
                && self.explain_word(name, form, operand, fault)
            {
                return None;
            }
            values.push(number.ok().map(|operand| Argument { operand, mark }));
            rest = behind;
        }
        // How many there are does not count where one of them is wrong.
        let values: Vec<Argument> = values.into_iter().collect::<Option<_>>()?;
        self.no_more(name, rest)?;
        Some(values)
    }

    /// Helps with a word that is reported where a number belongs, if what follows it would be reported for the same
    /// reason: a second target, or a flag without a blank, as `R50`.
    fn explain_word(
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

    /// Reads `count` constants or VARs.
    fn plain_values(
        &mut self,
        name: &Word,
        operands: &[Operand],
        count: usize,
    ) -> Option<Vec<Argument>> {
        let judged = &operands[..count.min(operands.len())];
        let values: Vec<Result<Argument, Refused>> = judged
            .iter()
            .map(|operand| {
                let operand = self.variable_or_constant(operand, Code::Argument)?;
                Ok(Argument {
                    operand,
                    mark: Mark::None,
                })
            })
            .collect();
        let is_target =
            |operand: &Operand| word(operand).is_some_and(|it| it.parse::<Target>().is_ok());
        let first = values.iter().find_map(|value| value.err().flatten());
        if let Some(fault) = first.and_then(|first| self.found.get_mut(first))
            && judged.iter().any(is_target)
        {
            let command = name.node.clone();
            let help = match takes_target(&command) {
                true => Suggestion::OneTarget { command },
                false => Suggestion::NoTarget { command },
            };
            fault.help = Some(help.into());
        }
        let values: Vec<Argument> = values.into_iter().collect::<Result<_, _>>().ok()?;
        if values.len() < count {
            let numbers = [count, values.len()];
            return self.too_few(name, Arguments::BARE, name.span, numbers, None);
        }
        self.no_more(name, &operands[count..])?;
        Some(values)
    }

    /// `PTP F1 R 0 0` with a variable R: where it stands, and the variable.
    fn used_as_flag(&self, form: Arguments, operands: &[Operand]) -> Option<(Span, VariableId)> {
        let used = operands
            .iter()
            .filter(|operand| flag_name(form, operand).is_some());
        let mut used = used.filter_map(|it| Some((it.span, self.names.find(word(it)?)?)));
        used.next()
    }

    fn too_few<T>(
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
            // That the word is a flag there explains the missing number.
            self.flags.insert(variable, used);
            let name = self.names.variables[variable].name.as_str().into();
            fault = fault.label(used, Suggestion::FlagHere);
            fault = fault.help(Suggestion::OtherName { name });
        }
        self.report(fault);
        None
    }

    /// Resolves a constant or VAR; a member is neither.
    pub(super) fn variable_or_constant(
        &mut self,
        operand: &Operand,
        shape: Code,
    ) -> Result<program::Operand, Refused> {
        let meant = self.resolve_operand_as(operand, shape, Some(VariableKind::Var))?;
        self.uses.operand(operand, meant, Access::Read);
        match meant.number().filter(|_| !meant.is_member()) {
            Some(number) => Ok(number),
            None => {
                let fault = Diagnostic::new(shape, operand.span, Commanding::ConstantOrVar);
                Err(self.report(fault.help(Commanding::CopyIntoVar)))
            }
        }
    }

    /// Refuses anything after the last argument.
    pub(super) fn no_more(&mut self, name: &Word, extra: &[Operand]) -> Option<()> {
        match extra.first() {
            None => Some(()),
            Some(operand) => {
                let extra = self.extra_word(name, operand);
                let advice = extra.map(|advice| (operand.span, advice));
                if let Some((location, advice)) = advice.or_else(|| self.decimal_comma(name)) {
                    let reason = Commanding::TooMany {
                        command: name.node.clone(),
                    };
                    return self.refuse_with(Code::Argument, location, reason, advice);
                }
                let reason = match name.node.as_str() {
                    // Version 2 had one.
                    name if name == Op::WaitNear.name() => Commanding::ToleranceElsewhere,
                    _ => Commanding::TooMany {
                        command: name.node.clone(),
                    },
                };
                self.refuse(Code::Argument, operand.span, reason)
            }
        }
    }

    /// Returns the foreign spelling that an argument too many is, if it is one.
    fn extra_word(&self, name: &Word, operand: &Operand) -> Option<Suggestion> {
        match word(operand) {
            Some(FAST) => Some(Suggestion::FastFirst {
                command: name.node.clone(),
            }),
            Some(word) if word.parse::<Target>().is_ok() => {
                let command = name.node.clone();
                Some(match takes_target(&command) {
                    true => Suggestion::OneTarget { command },
                    false => Suggestion::NoTarget { command },
                })
            }
            Some(word) if commands::find_in(word, self.names.edition).is_some() => {
                Some(Suggestion::NextStatement)
            }
            Some(unit) if is_unit(unit) && self.names.find(unit).is_none() => {
                Some(Suggestion::NoUnit)
            }
            _ => self.comma_in_number(operand.span),
        }
    }

    /// `PTP F1 100,5 200 300`: the digits after the only comma, if blanks separate the other arguments.
    fn decimal_comma(&self, name: &Word) -> Option<(Span, Suggestion)> {
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

    /// `1,000` or `4,5`: digits right after a comma that digits precede.
    fn comma_in_number(&self, location: Span) -> Option<Suggestion> {
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

    /// `R` or `A` as the first of these operands.
    fn flag_of<'a>(&self, form: Arguments, operands: &'a [Operand]) -> Option<&'a str> {
        let name = operands.first().and_then(word)?;
        (form.motion && (name == RELATIVE || name == ABSOLUTE)).then_some(name)
    }

    /// Reads the flag before the next operand; refuses flags where the command takes none.
    fn mark(&mut self, form: Arguments, operands: &[Operand]) -> Option<Mark> {
        match self.flag_of(form, operands) {
            None => Some(Mark::None),
            Some(RELATIVE) if form.relative => Some(Mark::Relative),
            Some(_) if form.from_target => Some(Mark::Absolute),
            Some(_) if form.relative => Some(Mark::None),
            Some(flag) => {
                let reason = Commanding::NoFlag { flag: flag.into() };
                self.refuse(Code::Argument, operands[0].span, reason)
            }
        }
    }
}

/// Returns true if a motion command reads this word as its flag.
fn is_flag(form: Arguments, word: &str) -> bool {
    form.motion && [RELATIVE, ABSOLUTE, FAST].contains(&word)
}

fn takes_target(command: &str) -> bool {
    let form = commands::find_in(command, Edition::V3_2).map(|command| command.form);
    matches!(form, Some(Form::Robot(form)) if form.targets != Targets::NONE)
}

/// `R50`, where `R 50` was meant.
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

/// Returns the flag in the place of a number, even after a sign.
fn flag_name(form: Arguments, operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name(name) if is_flag(form, name) => Some(name),
        _ => None,
    }
}

impl Resolver<'_> {
    /// Warns of each constant out of the command's range.
    pub(super) fn warn_of_range(
        &mut self,
        name: &Word,
        form: Arguments,
        operands: &[Operand],
        values: &[Argument],
    ) {
        let judged = match form.values {
            // The z of a finger is ignored.
            Values::Three | Values::ThreeOrPos | Values::Position if self.robot.is_hand() => 2,
            _ => values.len(),
        };
        for (operand, value) in operands.iter().zip(values).take(judged) {
            if let program::Operand::Constant(value) = value.operand
                && let Some(bounds) = broken(form.limit, value, self.robot)
            {
                self.warn_of_bounds(name, operand.span, bounds);
                if self.names.edition.is_strict() {
                    // The step fails at its first one.
                    return;
                }
            }
        }
    }

    /// Warns of a constant limit outside the joint's own ones, or of two that leave no range between them.
    pub(super) fn warn_of_limits(
        &mut self,
        name: &Word,
        target: Target,
        operands: &[Operand],
        values: &[Argument],
    ) {
        let constant = |value: &Argument| match value.operand {
            program::Operand::Constant(value) => Some(value),
            _ => None,
        };
        let own = self.robot.limits(target);
        let mut pairs = operands.iter().zip(values);
        let outside = pairs.find_map(|(operand, value)| {
            let own = own.filter(|own| constant(value).is_some_and(|it| !own.contains(it)))?;
            let Range { min, max } = own;
            Some((operand.span, Bounds::FromTo { min, max }))
        });
        let reversed = || match (values, operands) {
            ([low, high], [_, operand]) if constant(low)? >= constant(high)? => Some((
                operand.span,
                Bounds::Above {
                    low: constant(low)?,
                },
            )),
            _ => None,
        };
        if let Some((location, bounds)) = outside.or_else(reversed) {
            self.warn_of_bounds(name, location, bounds);
        }
    }

    fn warn_of_bounds(&mut self, name: &Word, location: Span, bounds: Bounds) {
        let help = Commanding::Takes {
            command: name.node.clone(),
            bounds,
            robot: self.robot.name(),
        };
        let reason = Commanding::OutOfRange;
        self.report(Diagnostic::new(Code::OutOfRange, location, reason).help(help));
    }

    /// Warns of a constant for which an equation has no result, whatever its variables are.
    pub(super) fn warn_of_domain(&mut self, equation: &Equation) {
        if let Some((location, reason, help)) = self.impossible(equation) {
            self.report(Diagnostic::new(Code::OutOfRange, location, reason).help(help));
        }
    }

    /// Finds such a constant: its location, why it has no result, and what to write instead.
    fn impossible(&self, equation: &Equation) -> Option<(Span, Calculating, Calculating)> {
        let constant = |operand: &Operand| self.names.constant(operand);
        let division = |divisor: &Operand| {
            let (reason, help) = (Calculating::DividedByZero, Calculating::DivideByAnother);
            (constant(divisor)? == 0.0).then_some((divisor.span, reason, help))
        };
        match &equation.value {
            Expression::Operand(divisor) if equation.update == Some(Arithmetic::Div) => {
                division(divisor)
            }
            Expression::Binary {
                operation: Arithmetic::Div,
                right,
                ..
            } => division(right),
            Expression::Function { name, operands } => {
                let operation = functions::find(&name.node, self.names.edition)?;
                outside(operation, operands, constant)
            }
            Expression::Operand(_) | Expression::Binary { .. } => None,
        }
    }
}

/// Finds a constant outside the domain of a function.
fn outside(
    operation: Operation,
    operands: &[Operand],
    constant: impl Fn(&Operand) -> Option<f64>,
) -> Option<(Span, Calculating, Calculating)> {
    let first = operands.first()?;
    let value = constant(first)?;
    let name = operation.word();
    match operation {
        Operation::Scalar(Function::Sqrt) if value < 0.0 => {
            let reason = Calculating::NoSquareRoot;
            Some((first.span, reason, Calculating::SqrtTakes))
        }
        Operation::Scalar(function @ (Function::Asin | Function::Acos | Function::Atan))
            if !(-1.0..=1.0).contains(&value) =>
        {
            let reason = Calculating::NoResult { function: name };
            let help = if function == Function::Atan {
                Calculating::TakesToOneOrRatio { function: name }
            } else {
                Calculating::TakesToOne { function: name }
            };
            Some((first.span, reason, help))
        }
        Operation::Atan2 => {
            let second = operands.get(1)?;
            let reason = Calculating::NoDirection;
            let help = Calculating::AnotherThanZero;
            let nowhere = value == 0.0 && constant(second)? == 0.0;
            nowhere.then(|| (first.span.to(second.span), reason, help))
        }
        _ => None,
    }
}

/// Returns the range that a value leaves.
fn broken(limit: Limit, value: f64, robot: Robot) -> Option<Bounds> {
    let outside = |value: f64, min: f64, max: f64| {
        (!Range::new(min, max).contains(value)).then_some(Bounds::FromTo { min, max })
    };
    let whole_outside = |min, max| outside(value.trunc(), min, max);
    let Range { min, max } = robot.facts().periods;
    match limit {
        Limit::Any | Limit::Angles => None,
        Limit::NotNegative => (value < 0.0).then_some(Bounds::NotNegative),
        Limit::Positive => (value <= 0.0).then_some(Bounds::Positive),
        Limit::Percent => (value <= 0.0 || value > 100.0).then_some(Bounds::Percent),
        Limit::Period => outside(value, min, max),
        Limit::Frequency => outside(value, 1000.0 / max, 1000.0 / min),
        Limit::Lamp => match robot.facts().lamps.checked_sub(1) {
            None => Some(Bounds::Nothing),
            Some(last) => whole_outside(0.0, f64::from(last)),
        },
        Limit::FloorType if robot.is_hand() => whole_outside(1.0, 2.0),
        Limit::FloorType | Limit::ObjectType => whole_outside(1.0, 3.0),
        Limit::Timer => whole_outside(0.0, f64::from(TIMERS - 1)),
        Limit::Steps => whole_outside(1.0, 255.0),
    }
}
