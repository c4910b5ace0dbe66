//! Arguments of commands against their forms in the command table.

use super::names::Meant;
use super::resolve::Resolver;
use super::suggest::nearest;
use super::targets::word;
use crate::codes::Code;
use crate::commands::{self, Arguments, COMMANDS, Command, Form, Meaning, Values};
use crate::diagnostic::Diagnostic;
use crate::program::{self, Action, Argument, Scalar};
use crate::syntax::{Operand, Span, VariableKind, Word};
use tip_runtime::command::{Op, Target};

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
        let command = commands::find(&name.node).filter(|command| command.meaning != Meaning::Word);
        let Some(command) = command else {
            return self.unknown_command(name);
        };
        if !command.robots.contains(self.robot) {
            let reason = format!("{} lacks this command", self.robot.name());
            let help = format!(
                "`{}` is for robots {} (T: titan8, H: hand, G: generic)",
                command.name,
                command.robots.letters()
            );
            self.report(
                Diagnostic::new(Code::UnknownCommand, name.span, reason)
                    .about(&name.node)
                    .help(help),
            );
            return None;
        }
        Some(command)
    }

    fn unknown_command<T>(&mut self, name: &Word) -> Option<T> {
        let fault = Diagnostic::new(Code::UnknownCommand, name.span, "this is no command");
        let names = COMMANDS.iter().map(|command| command.name);
        let help = match nearest(&name.node, names) {
            Some(near) => format!("did you mean `{near}`?"),
            None => "a label ends with a colon, an equation has `=` behind its variable".to_owned(),
        };
        self.report(fault.about(&name.node).help(help));
        None
    }

    fn robot(
        &mut self,
        name: &Word,
        op: Op,
        form: Arguments,
        arguments: &[Operand],
    ) -> Option<Action> {
        let hs = form.hs && arguments.first().and_then(word) == Some("HS");
        let arguments = &arguments[usize::from(hs)..];
        if op == Op::OutputVariables {
            self.usage.dump();
        }
        let has_target = form.targets != commands::Targets::NONE;
        let target = match has_target {
            true => self.target(name, form.targets, arguments)?,
            false => Target::None,
        };
        let operands = &arguments[usize::from(has_target)..];
        let values = self.values(name, form, target, operands)?;
        self.warn_of_range(name, form.limit, operands, &values);
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
        let all = target == Target::All;
        match form.values {
            Values::None => self.no_more(name, operands).map(|()| Vec::new()),
            Values::One => self.plain_values(name, operands, 1),
            Values::Three => self.plain_values(name, operands, 3),
            Values::Position => self.vector(name, form, operands, VariableKind::Pos, 3),
            Values::Angles if single => self.scalars(name, form, operands, 1),
            Values::Angles => self.vector(name, form, operands, VariableKind::Joint, joints),
            Values::Tolerances | Values::TorqueLimits if single => {
                self.plain_values(name, operands, 1)
            }
            Values::Tolerances if all && !self.is_joint(operands) => {
                self.plain_values(name, operands, 1)
            }
            Values::TorqueLimits if all => self.plain_values(name, operands, 1),
            Values::Tolerances if all => {
                self.vector(name, form, operands, VariableKind::Joint, joints)
            }
            Values::Tolerances | Values::TorqueLimits => {
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
        let Some(id) = id.filter(|id| self.names.variables[*id].kind == kind) else {
            return self.scalars(name, form, operands, count);
        };
        self.no_more(name, &operands[flagged + 1..])?;
        let relative = self.relative(form, operands)?;
        self.usage.read(id, operands[flagged].span);
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
                let reason = format!(
                    "{} wants {count} value(s) here, not {}",
                    name.node,
                    values.len()
                );
                return self.refuse(
                    Code::Argument,
                    flag.map_or(name.span, |flag| flag.span),
                    reason,
                );
            };
            if let Some(flag) = word(operand).filter(|name| is_flag(form, name)) {
                let reason = format!("{flag} stands before a number, and once");
                return self.refuse(Code::Argument, operand.span, reason);
            }
            let operand = self.number(operand, Code::Argument)?;
            values.push(Argument { operand, relative });
            rest = behind;
        }
        self.no_more(name, rest)?;
        Some(values)
    }

    /// So many constants or VARs.
    fn plain_values(
        &mut self,
        name: &Word,
        operands: &[Operand],
        count: usize,
    ) -> Option<Vec<Argument>> {
        if operands.len() < count {
            let reason = format!(
                "{} wants {count} value(s) here, not {}",
                name.node,
                operands.len()
            );
            return self.refuse(Code::Argument, name.span, reason);
        }
        let (values, extra) = operands.split_at(count);
        self.no_more(name, extra)?;
        values
            .iter()
            .map(|operand| {
                let operand = self.variable_or_constant(operand, Code::Argument)?;
                Some(Argument {
                    operand,
                    relative: false,
                })
            })
            .collect()
    }

    /// A constant or VAR; a member is neither.
    pub(super) fn variable_or_constant(
        &mut self,
        operand: &Operand,
        shape: Code,
    ) -> Option<program::Operand> {
        let meant = self.meant(operand, shape)?;
        self.read(meant, operand.span);
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
                let form = commands::find(&name.node).map(|command| command.form.syntax());
                let help = match form.filter(|form| !form.is_empty()) {
                    Some(form) => format!("write `{} {form}`", name.node),
                    None => format!("{} takes no arguments", name.node),
                };
                let reason = "this argument is one too many";
                self.report(Diagnostic::new(Code::Argument, operand.span, reason).help(help));
                None
            }
        }
    }

    /// `R` or `A` as the first of these operands.
    fn flag_of<'a>(&self, form: Arguments, operands: &'a [Operand]) -> Option<&'a str> {
        let name = operands.first().and_then(word)?;
        (form.motion && matches!(name, "R" | "A")).then_some(name)
    }

    /// Whether the next operand is relative; refuses flags where the command takes none.
    fn relative(&mut self, form: Arguments, operands: &[Operand]) -> Option<bool> {
        match self.flag_of(form, operands) {
            None => Some(false),
            Some(flag) if form.relative => Some(flag == "R"),
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
    form.motion && commands::MOTION_FLAGS.contains(&word)
}
