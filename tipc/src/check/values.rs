//! The values of commands: numbers with their flags, or a struct in their place.
//!
//! ```text
//! values = {["R" | "A"] number} | ["R" | "A"] POS or JOINT
//! ```

mod recover;

use super::equations::type_of;
use super::resolve::{Refused, Resolver};
use super::targets::word;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::{Arguments, Values};
use crate::language::reserved;
use crate::message::Commanding;
use crate::message::phrase::Numbers;
use crate::program::{self, Argument, Mark, StructOperand};
use crate::symbols::Access;
use crate::syntax::{Operand, OperandKind, VariableKind, Word};
use tip_runtime::command::{ABSOLUTE, FAST, RELATIVE, Target};

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
        Some((
            StructOperand::Reading(reading),
            VariableKind::of_reading(reading),
        ))
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
            // A single operand can only be a struct.
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
        // The number of values is checked only if all of them are right.
        let values: Vec<Argument> = values.into_iter().collect::<Option<_>>()?;
        self.no_more(name, rest)?;
        Some(values)
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
        let first = values.iter().find_map(|value| value.err().flatten());
        self.explain_target(name, judged, first);
        let values: Vec<Argument> = values.into_iter().collect::<Result<_, _>>().ok()?;
        if values.len() < count {
            let numbers = [count, values.len()];
            return self.too_few(name, Arguments::BARE, name.span, numbers, None);
        }
        self.no_more(name, &operands[count..])?;
        Some(values)
    }

    /// Resolves a constant or VAR; a member is neither.
    pub(super) fn variable_or_constant(
        &mut self,
        operand: &Operand,
        mistake: Code,
    ) -> Result<program::Operand, Refused> {
        let meant = self.resolve_operand_as(operand, mistake, Some(VariableKind::Var))?;
        self.uses.operand(operand, meant, Access::Read);
        match meant.number().filter(|_| !meant.is_member()) {
            Some(number) => Ok(number),
            None => {
                let fault = Diagnostic::new(mistake, operand.span, Commanding::ConstantOrVar);
                Err(self.report(fault.help(Commanding::CopyIntoVar)))
            }
        }
    }

    /// Refuses anything after the last argument.
    pub(super) fn no_more(&mut self, name: &Word, extra: &[Operand]) -> Option<()> {
        match extra.first() {
            None => Some(()),
            Some(operand) => self.too_many(name, operand),
        }
    }

    /// Returns the first of these operands if it is the flag `R` or `A`.
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

/// Returns the flag in the place of a number, even after a sign.
fn flag_name(form: Arguments, operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name(name) if is_flag(form, name) => Some(name),
        _ => None,
    }
}
