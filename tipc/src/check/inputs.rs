//! Commands that fill variables, and SPECIAL (T.I.P. 3.1 §7-5, §7-9-1, §7-9-2, §7-10-11).

use super::names::{ResolvedOperand, VAR_KEY_ID, inventory};
use super::resolve::Resolver;
use super::targets::word;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::Targets;
use crate::language::inputs;
use crate::message::Commanding;
use crate::message::list::List;
use crate::message::phrase::Lacking;
use crate::program::{Action, Argument, Mark, Operand as Number, Scalar};
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::{Operand, VariableKind, Word};
use tip_runtime::command::{Op, Port, READING, Target, Teach};

impl Resolver<'_> {
    pub(super) fn teach(
        &mut self,
        name: &Word,
        what: Teach,
        targets: Targets,
        arguments: &[Operand],
    ) -> Option<Action> {
        let target = self.target(name, targets, arguments)?;
        let Some(into) = arguments.get(1) else {
            return self.missing(name.span, Lacking::Measured);
        };
        self.no_more(name, &arguments[2..])?;
        let kind = match (what, target) {
            (Teach::Position | Teach::Force, _) => VariableKind::Pos,
            (Teach::Angle | Teach::Torque, Target::Joint(..)) => VariableKind::Var,
            (Teach::Angle | Teach::Torque, _) => VariableKind::Joint,
        };
        let wanted = match kind {
            VariableKind::Pos => Commanding::PosVariable,
            VariableKind::Joint => Commanding::JointVariable,
            VariableKind::Var => Commanding::VarOrJointMember,
        };
        let meant = self
            .resolve_operand_as(into, Code::Argument, Some(kind))
            .ok()?;
        match meant {
            ResolvedOperand::Struct {
                variable,
                kind: of,
                negative: false,
            } if kind == of => {
                self.uses.variable(into.span, variable, Access::Assign);
                let into = variable;
                Some(Action::TeachStruct { what, target, into })
            }
            ResolvedOperand::Scalar {
                scalar,
                negative: false,
                ..
            } if kind == VariableKind::Var
                && self.names.variables[scalar.variable].kind != VariableKind::Pos =>
            {
                self.uses.operand(into, meant, Access::Assign);
                let into = scalar;
                Some(Action::TeachScalar { what, target, into })
            }
            _ => self.refuse(Code::Argument, into.span, wanted),
        }
    }

    pub(super) fn key_in(&mut self, name: &Word, arguments: &[Operand]) -> Option<Action> {
        self.no_more(name, arguments.get(1..).unwrap_or_default())?;
        let into = match arguments.first() {
            Some(operand) => self.receiver(operand)?,
            None => {
                let left_out = Span::new(name.span.end, name.span.end);
                self.uses.variable(left_out, VAR_KEY_ID, Access::Assign);
                Scalar {
                    variable: VAR_KEY_ID,
                    member: 0,
                }
            }
        };
        Some(Action::KeyIn { into })
    }

    pub(super) fn ad_in(&mut self, name: &Word, arguments: &[Operand]) -> Option<Action> {
        let Some(first) = arguments.first() else {
            return self.missing(name.span, Lacking::Input);
        };
        let (port, used) = match word(first) {
            Some(id) if !self.names.has(id) && !id.starts_with(READING) => {
                (self.port(first, id)?, 1)
            }
            _ => (self.channel(name, arguments)?, 2),
        };
        let Some(into) = arguments.get(used) else {
            return self.missing(name.span, Lacking::Volts);
        };
        self.no_more(name, &arguments[used + 1..])?;
        let into = self.receiver(into)?;
        Some(Action::AdIn { port, into })
    }

    fn channel(&mut self, name: &Word, arguments: &[Operand]) -> Option<Port> {
        let board = self.constant(&arguments[0])?;
        if board.trunc() != 0.0 {
            let reason = Commanding::OneBoard;
            return self.refuse(Code::Argument, arguments[0].span, reason);
        }
        let Some(channel) = arguments.get(1) else {
            return self.missing(name.span, Lacking::Channel);
        };
        let number = self.constant(channel)?.trunc();
        if !(0.0..=15.0).contains(&number) {
            let reason = Commanding::Channels;
            return self.refuse(Code::Argument, channel.span, reason);
        }
        Some(Port::Channel(number as u8))
    }

    fn port(&mut self, operand: &Operand, id: &str) -> Option<Port> {
        let named = inputs::find(id, self.names.edition);
        let found = named.filter(|(port, row)| {
            let joint = port.joint();
            row.robots.contains(self.robot) && joint.is_none_or(|joint| self.robot.has(joint))
        });
        let port = found.map(|(port, _)| port);
        if port.is_none() {
            let robot = self.robot.name();
            let reason = Commanding::NoInput {
                robot,
                name: id.into(),
            };
            let inventory = inventory(self.robot);
            let others: Vec<String> = inputs::others(self.robot).collect();
            let help = match others.is_empty() {
                true => Commanding::Inputs { inventory },
                false => Commanding::InputsWith {
                    others: List(others),
                    inventory,
                },
            };
            self.report(Diagnostic::new(Code::Argument, operand.span, reason).help(help));
        }
        port
    }

    pub(super) fn special(&mut self, name: &Word, arguments: &[Operand]) -> Option<Action> {
        let Some((number, values)) = arguments.split_first() else {
            return self.missing(name.span, Lacking::NativeCommand);
        };
        let code = self.constant(number)?.trunc();
        if !(0.0..=255.0).contains(&code) {
            let reason = Commanding::NativeCommands;
            return self.refuse(Code::Argument, number.span, reason);
        }
        self.no_more(name, values.get(2..).unwrap_or_default())?;
        let values: Vec<Option<Number>> = values
            .iter()
            .map(|value| self.variable_or_constant(value, Code::Argument).ok())
            .collect();
        let values = values.into_iter().collect::<Option<Vec<_>>>()?;
        // The number of the native command comes before its values; it is not -0.
        let operands = [Number::Constant(code + 0.0)].into_iter().chain(values);
        let argument = |operand| Argument {
            operand,
            mark: Mark::None,
        };
        Some(Action::Command {
            op: Op::Special,
            hs: false,
            target: Target::None,
            arguments: operands.map(argument).collect(),
        })
    }

    /// Resolves a VAR without sign, which a command fills.
    fn receiver(&mut self, operand: &Operand) -> Option<Scalar> {
        let meant = self
            .resolve_operand_as(operand, Code::Argument, Some(VariableKind::Var))
            .ok()?;
        match meant {
            ResolvedOperand::Scalar {
                scalar,
                negative: false,
                member: false,
            } => {
                self.uses.operand(operand, meant, Access::Assign);
                Some(scalar)
            }
            _ => self.refuse(Code::Argument, operand.span, Commanding::VarBelongsHere),
        }
    }

    fn constant(&mut self, operand: &Operand) -> Option<f64> {
        let meant = self
            .resolve_operand_as(operand, Code::Argument, None)
            .ok()?;
        match meant {
            ResolvedOperand::Constant(value) => {
                self.uses.operand(operand, meant, Access::Read);
                Some(value)
            }
            _ => self.refuse(
                Code::Argument,
                operand.span,
                Commanding::ConstantBelongsHere,
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::program::{Action, Scalar};
    use tip_runtime::command::Port;

    // clauses: 7.32
    #[test]
    fn inputs_have_the_numbers_of_their_names() {
        let into = Scalar {
            variable: 0,
            member: 0,
        };
        for (input, port) in [
            ("VR1", Port::Knob(1)),
            ("VR3", Port::Knob(3)),
            ("PAW1", Port::Paw(1)),
            ("PAW4", Port::Paw(4)),
            ("J43", Port::Joint(4, 3)),
            ("0 13", Port::Channel(13)),
        ] {
            let text = format!("3.1\ninputs\nAD_IN {input} VAR_KEY\nSLEEP VAR_KEY\nEND\n");
            let loaded = crate::load("inputs.prg", text.as_bytes(), &crate::Options::default());
            let program = loaded.program.expect("a sound program");
            assert_eq!(program.steps()[0].action, Action::AdIn { port, into });
        }
    }
}
