//! Arguments of commands against their forms in the command table.

use super::equations::type_name;
use super::names::Meant;
use super::resolve::Resolver;
use super::suggest::nearest;
use super::targets::word;
use crate::code::{Code, Level};
use crate::diagnostic::Diagnostic;
use crate::language::commands::{self, Arguments, COMMANDS, Command, Form, Meaning, Values};
use crate::program::{self, Action, Argument, Scalar};
use crate::robot::Robot;
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::{Operand, OperandKind, VariableKind, Word};
use tip_runtime::command::{ABSOLUTE, FAST, Op, RELATIVE, Target};

impl Resolver<'_> {
    pub(super) fn command(
        &mut self,
        name: &Word,
        arguments: &[Operand],
        malformed: Option<&Diagnostic>,
    ) -> Option<Action> {
        let command = self.known(name)?;
        if let Some(fault) = malformed {
            self.report(fault.clone());
            return None;
        }
        let told = self.found.len();
        let action = self.action(command, name, arguments);
        self.say_usage(told, command);
        action
    }

    /// Gives the faults of a command that say no way out its usage.
    fn say_usage(&mut self, told: usize, command: &Command) {
        let edition = self.names.edition;
        let silent = |fault: &&mut Diagnostic| {
            fault.help.is_none() && fault.code.level(edition) == Level::Error
        };
        for fault in self.found[told..].iter_mut().filter(silent) {
            let usage = command.usage(self.robot).join("`, or `");
            fault.help = Some(format!("write `{usage}`").into());
        }
    }

    fn action(&mut self, command: &Command, name: &Word, arguments: &[Operand]) -> Option<Action> {
        match (command.form, command.meaning) {
            (Form::Robot(form), Meaning::Robot(op)) => self.robot(name, op, form, arguments),
            (Form::Robot(_), _) => {
                self.no_more(name, arguments)?;
                Some(Action::Message { parts: Vec::new() })
            }
            (Form::Special, _) => self.special(name, arguments),
            (Form::Teach(targets), Meaning::Teach(what)) => {
                self.teach(name, what, targets, arguments)
            }
            (Form::AdIn, _) => self.ad_in(name, arguments),
            (Form::KeyIn, _) => self.key_in(name, arguments),
            (Form::Words(_) | Form::Teach(_), _) => self.unknown_command(name),
        }
    }

    fn known(&mut self, name: &Word) -> Option<&'static Command> {
        let command = commands::find(&name.node).filter(|command| {
            command.since <= self.names.edition && !matches!(command.meaning, Meaning::Keyword(_))
        });
        let Some(command) = command else {
            return self.unknown_command(name);
        };
        if !command.robots.contains(self.robot) {
            let reason = format!("{} lacks this command", self.robot.name());
            let help = self.who_has(command);
            self.report(
                Diagnostic::new(Code::UnknownCommand, name.span, reason)
                    .about(name.node.as_str())
                    .help(help),
            );
            return None;
        }
        Some(command)
    }

    /// The way to a command that the robot lacks.
    fn who_has(&self, command: &Command) -> String {
        let name = command.name;
        match self.robot {
            Robot::Described(_) if command.robots.misses_forces(self.robot) => format!(
                "{name} needs a robot that senses and gives torque: its description has no `[forces]`"
            ),
            _ => format!("{name} is a command of {}", command.robots.names()),
        }
    }

    fn unknown_command<T>(&mut self, name: &Word) -> Option<T> {
        let word = name.node.as_str();
        let (reason, help) = match self.names.find(word) {
            Some(_) => (
                "this is a variable, not a command",
                format!("an equation has an operator behind its variable: `{word} = 0`"),
            ),
            None => ("this is no command", meant_by(word)),
        };
        let fault = Diagnostic::new(Code::UnknownCommand, name.span, reason);
        self.report(fault.about(word).help(help));
        None
    }

    fn robot(
        &mut self,
        name: &Word,
        op: Op,
        form: Arguments,
        arguments: &[Operand],
    ) -> Option<Action> {
        let hs = form.hs && arguments.first().and_then(word) == Some(FAST);
        let arguments = &arguments[usize::from(hs)..];
        if op == Op::OutputVariables {
            self.uses.dump();
        }
        let has_target = form.targets != commands::Targets::NONE;
        let target = match has_target {
            true => self.target(name, form.targets, arguments)?,
            false => Target::None,
        };
        let operands = &arguments[usize::from(has_target)..];
        let values = self.values(name, form, target, operands)?;
        self.warn_of_range(name, form, operands, &values);
        Some(Action::Command {
            op,
            hs,
            target,
            arguments: values,
        })
    }

    fn values(
        &mut self,
        name: &Word,
        form: Arguments,
        target: Target,
        operands: &[Operand],
    ) -> Option<Vec<Argument>> {
        let joints = usize::from(self.robot.signature().joints);
        let single = matches!(target, Target::Joint(..));
        let one_for_all = match (form.values, target) {
            (Values::Tolerances, Target::All) => !self.is_joint(operands),
            (Values::TorqueLimits, Target::All) => true,
            _ => false,
        };
        match form.values {
            Values::None => self.no_more(name, operands).map(|()| Vec::new()),
            Values::One => self.plain_values(name, operands, 1),
            Values::Three => self.plain_values(name, operands, 3),
            Values::Position => self.vector(name, form, operands, VariableKind::Pos, 3),
            Values::Angles if single => self.scalars(name, form, operands, 1),
            Values::Tolerances | Values::TorqueLimits if single || one_for_all => {
                self.plain_values(name, operands, 1)
            }
            Values::Angles | Values::Tolerances | Values::TorqueLimits => {
                self.vector(name, form, operands, VariableKind::Joint, joints)
            }
        }
    }

    fn is_joint(&self, operands: &[Operand]) -> bool {
        let id = operands
            .first()
            .and_then(word)
            .and_then(|name| self.names.find(name));
        id.is_some_and(|id| self.names.variables[id].kind == VariableKind::Joint)
    }

    /// Three or n scalars, or one struct in their place.
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
        let id = whole.and_then(|name| self.names.find(name));
        let id = match id.map(|id| (id, self.names.variables[id].kind)) {
            None | Some((_, VariableKind::Var)) => {
                return self.scalars(name, form, operands, count);
            }
            Some((id, of)) if of == kind => id,
            Some((_, of)) => {
                let reason = format!(
                    "{} wants {} here, not {}",
                    name.node,
                    numbers(count, Some(kind)),
                    type_name(Some(of))
                );
                return self.refuse(Code::Argument, operands[flagged].span, reason);
            }
        };
        self.no_more(name, &operands[flagged + 1..])?;
        let relative = self.relative(form, operands)?;
        self.uses.variable(operands[flagged].span, id, Access::Read);
        let members = 0..self.names.variables[id].size();
        let argument = |member| Argument {
            operand: program::Operand::Scalar {
                scalar: Scalar {
                    variable: id,
                    member,
                },
                negative: false,
            },
            relative,
        };
        Some(members.map(argument).collect())
    }

    /// So many scalars, each with its flag.
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
            let relative = self.relative(form, rest)?;
            let flag = rest.first().filter(|_| self.flag_of(form, rest).is_some());
            rest = &rest[usize::from(flag.is_some())..];
            let Some((operand, behind)) = rest.split_first() else {
                if values.contains(&None) {
                    // An unknown name may stand for a struct.
                    return None;
                }
                let place = flag.map_or(name.span, |flag| flag.span);
                return self.too_few(name, form, place, count, values.len());
            };
            if let Some(flag) = flag_name(form, operand) {
                let reason = format!("{flag} is a flag here: it stands before a number, and once");
                return self.refuse(Code::Argument, operand.span, reason);
            }
            let number = self.number(operand, Code::Argument);
            values.push(number.map(|operand| Argument { operand, relative }));
            rest = behind;
        }
        self.no_more(name, rest)?;
        values.into_iter().collect()
    }

    /// So many constants or VARs.
    fn plain_values(
        &mut self,
        name: &Word,
        operands: &[Operand],
        count: usize,
    ) -> Option<Vec<Argument>> {
        let judged = &operands[..count.min(operands.len())];
        let values: Vec<Option<Argument>> = judged
            .iter()
            .map(|operand| {
                let operand = self.variable_or_constant(operand, Code::Argument)?;
                Some(Argument {
                    operand,
                    relative: false,
                })
            })
            .collect();
        let values: Vec<Argument> = values.into_iter().collect::<Option<_>>()?;
        if values.len() < count {
            return self.too_few(name, Arguments::BARE, name.span, count, values.len());
        }
        self.no_more(name, &operands[count..])?;
        Some(values)
    }

    fn too_few<T>(
        &mut self,
        name: &Word,
        form: Arguments,
        place: Span,
        wanted: usize,
        found: usize,
    ) -> Option<T> {
        let whole = match form.values {
            Values::Position => Some(VariableKind::Pos),
            Values::Angles | Values::Tolerances | Values::TorqueLimits if wanted > 1 => {
                Some(VariableKind::Joint)
            }
            _ => None,
        };
        let stand = match found {
            0 => "none stands".to_owned(),
            1 => "one stands".to_owned(),
            _ => format!("{found} stand"),
        };
        let wanted = numbers(wanted, whole);
        let reason = format!("{} wants {wanted}; {stand} here", name.node);
        self.refuse(Code::Argument, place, reason)
    }

    /// A constant or VAR; a member is neither.
    pub(super) fn variable_or_constant(
        &mut self,
        operand: &Operand,
        shape: Code,
    ) -> Option<program::Operand> {
        let meant = self.meant(operand, shape)?;
        self.uses.operand(operand, meant, Access::Read);
        match meant {
            Meant::Constant(_) | Meant::Scalar { member: false, .. } => meant.number(),
            Meant::Scalar { .. } | Meant::Struct { .. } => {
                let reason = "only a constant or a VAR can stand here";
                let fault = Diagnostic::new(shape, operand.span, reason);
                self.report(fault.help("copy the number into a VAR first"));
                None
            }
        }
    }

    /// Refuses what stands behind the last argument.
    pub(super) fn no_more(&mut self, name: &Word, extra: &[Operand]) -> Option<()> {
        match extra.first() {
            None => Some(()),
            Some(operand) => {
                let reason = match name.node.as_str() {
                    // Version 2 had one.
                    name if name == Op::WaitNear.name() => {
                        "SET_NEAR_POSITION and SET_NEAR_ANGLE set the tolerance".to_owned()
                    }
                    name => format!("one argument too many for {name}"),
                };
                self.refuse(Code::Argument, operand.span, reason)
            }
        }
    }

    /// `R` or `A` as the first of these operands.
    fn flag_of<'a>(&self, form: Arguments, operands: &'a [Operand]) -> Option<&'a str> {
        let name = operands.first().and_then(word)?;
        (form.motion && (name == RELATIVE || name == ABSOLUTE)).then_some(name)
    }

    /// Whether the next operand is relative; refuses flags where the command takes none.
    fn relative(&mut self, form: Arguments, operands: &[Operand]) -> Option<bool> {
        match self.flag_of(form, operands) {
            None => Some(false),
            Some(flag) if form.relative => Some(flag == RELATIVE),
            Some(flag) => {
                let reason = format!("this command takes no {flag}");
                self.refuse(Code::Argument, operands[0].span, reason)
            }
        }
    }

    pub(super) fn missing<T>(&mut self, place: Span, what: &str) -> Option<T> {
        self.refuse(Code::Argument, place, format!("{what} is missing"))
    }
}

/// Whether a motion command reads this word as its flag.
fn is_flag(form: Arguments, word: &str) -> bool {
    form.motion && [RELATIVE, ABSOLUTE, FAST].contains(&word)
}

/// The flag that stands in the place of a number, be it behind a sign.
fn flag_name(form: Arguments, operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name(name) if is_flag(form, name) => Some(name),
        _ => None,
    }
}

/// So many numbers, or a struct in their place, in words.
fn numbers(count: usize, whole: Option<VariableKind>) -> String {
    let numbers = match count {
        1 => "one number".to_owned(),
        _ => format!("{count} numbers"),
    };
    match whole {
        Some(kind) => format!("{numbers} or {}", type_name(Some(kind))),
        None => numbers,
    }
}

/// What an unknown word may have been meant to be.
fn meant_by(word: &str) -> String {
    if let Some(renamed) = commands::renamed(word) {
        return format!("this language calls it `{renamed}`");
    }
    match nearest(word, COMMANDS.iter().map(|command| command.name)) {
        Some(near) => format!("did you mean `{near}`?"),
        None => "a label ends with a colon, an equation has `=` behind its variable".to_owned(),
    }
}
