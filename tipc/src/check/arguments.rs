//! Arguments of commands against their forms in the command table.

use super::resolve::Resolver;
use super::resolved;
use super::resolved::Resolved;
use super::targets::word;
use crate::code::{Code, Level};
use crate::diagnostic::Diagnostic;
use crate::language::commands::{Arguments, Command, Form, Limit, Meaning};
use crate::language::{Keyword, commands, keywords};
use crate::message::list::{Alternatives, Both};
use crate::message::phrase::Lacking;
use crate::message::{Commanding, ForeignWord, Message, Parsing};
use crate::parse::label_of;
use crate::robot::Robot;
use crate::source::Span;
use crate::syntax::{Operand, Word};
use tip_runtime::command::{FAST, Op, Target};

impl Resolver<'_> {
    pub(super) fn command(
        &mut self,
        name: &Word,
        arguments: &[Operand],
        malformed: Option<&Diagnostic>,
    ) -> Option<Resolved> {
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

    /// Adds the usage of a command to its faults that have no help.
    fn say_usage(&mut self, told: usize, command: &Command) {
        let edition = self.names.edition;
        let silent = |fault: &&mut Diagnostic| {
            fault.help.is_none() && fault.code.level(edition) == Level::Error
        };
        for fault in self.found[told..].iter_mut().filter(silent) {
            let forms = Alternatives(command.usage(self.robot, edition));
            fault.help = Some(Commanding::Write { forms }.into());
        }
    }

    fn action(
        &mut self,
        command: &Command,
        name: &Word,
        arguments: &[Operand],
    ) -> Option<Resolved> {
        match (command.form_in(self.names.edition), command.meaning) {
            (Form::Robot(form), Meaning::Robot(op)) => self.robot(name, op, form, arguments),
            (Form::Robot(_), _) => {
                self.no_more(name, arguments)?;
                Some(Resolved::MessageClear)
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
        let command = commands::find_in(&name.node, self.names.edition);
        let command = command.filter(|command| !matches!(command.meaning, Meaning::Keyword(_)));
        let Some(command) = command else {
            return self.unknown_command(name);
        };
        if !command.robots.contains(self.robot) {
            let robot = self.robot.name();
            let reason = Commanding::RobotLacks {
                robot,
                command: command.name,
            };
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

    /// Returns a replacement for a command that the robot lacks.
    fn who_has(&self, command: &Command) -> Commanding {
        let name = command.name;
        match self.robot {
            Robot::Described(_) if command.robots.misses_forces(self.robot) => {
                Commanding::NeedsForces { command: name }
            }
            _ => Commanding::CommandOf {
                command: name,
                robots: Both(command.robots.names()),
            },
        }
    }

    fn unknown_command<T>(&mut self, name: &Word) -> Option<T> {
        let word = name.node.as_str();
        let (reason, help) = match self.names.find(word) {
            Some(_) => {
                let name = name.node.clone();
                let help = Commanding::OperatorBehindVariable { name: name.clone() };
                (Commanding::VariableNotCommand { name }, help.into())
            }
            None => {
                let command = name.node.clone();
                let help = match self.is_after_text(name.span) {
                    true => ForeignWord::SemicolonEndsText.into(),
                    false => self.suggest_for(name),
                };
                (Commanding::NoCommand { word: command }, help)
            }
        };
        let mut fault = Diagnostic::new(Code::UnknownCommand, name.span, reason);
        match &help {
            Message::ForeignWord(ForeignWord::NoParameters { name }) => {
                fault = fault.once(name.clone())
            }
            Message::Parsing(Parsing::WriteLabel { name }) => fault = fault.once(label_of(name)),
            _ => {}
        }
        self.report(fault.about(word).help(help));
        None
    }

    /// Returns true if a `;` ended a text of MESSAGE or REM right before this location.
    fn is_after_text(&self, location: Span) -> bool {
        let before = self.source_before(location).map(str::trim_end);
        let Some(before) = before.and_then(|before| before.strip_suffix(';')) else {
            return false;
        };
        let last = before.rsplit(';').next().unwrap_or_default();
        let first = last.split_whitespace().next().unwrap_or_default();
        keywords::find(first, self.names.edition).is_some_and(Keyword::takes_text)
    }

    fn robot(
        &mut self,
        name: &Word,
        op: Op,
        form: Arguments,
        arguments: &[Operand],
    ) -> Option<Resolved> {
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
        let arguments = self.values(name, form, target, operands)?;
        if let resolved::Arguments::Each(values) = &arguments {
            self.warn_of_range(name, form, operands, values);
            if form.limit == Limit::Angles {
                self.warn_of_limits(name, target, operands, values);
            }
        }
        Some(Resolved::Command {
            op,
            hs,
            target,
            arguments,
        })
    }

    pub(super) fn missing<T>(&mut self, location: Span, what: Lacking) -> Option<T> {
        self.refuse(Code::Argument, location, Commanding::Missing { what })
    }
}
