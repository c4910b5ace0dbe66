//! Arguments of commands against their forms in the command table.

use super::resolve::Resolver;
use super::resolved;
use super::resolved::Resolved;
use super::targets::word;
use crate::code::{Code, Level};
use crate::diagnostic::Diagnostic;
use crate::language::commands::{Arguments, Command, Form, Meaning};
use crate::language::{Keyword, commands};
use crate::message::list::{Alternatives, Both};
use crate::message::phrase::Lacking;
use crate::message::{Commanding, ForeignWord, Message, Parsing};
use crate::parse::label_of;
use crate::program::{MessagePart, Scalar};
use crate::robot::Robot;
use crate::source::Span;
use crate::symbols::Access;
use crate::syntax::{Operand, VariableKind, Word};
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
            let forms = Alternatives(command.usage(self.robot));
            fault.help = Some(Commanding::Write { forms }.into());
        }
    }

    fn action(
        &mut self,
        command: &Command,
        name: &Word,
        arguments: &[Operand],
    ) -> Option<Resolved> {
        match (command.form, command.meaning) {
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
        let command = commands::find(&name.node).filter(|command| {
            command.since <= self.names.edition && !matches!(command.meaning, Meaning::Keyword(_))
        });
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
        [Keyword::Message, Keyword::Rem]
            .iter()
            .any(|text| first.eq_ignore_ascii_case(text.word()))
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

impl Resolver<'_> {
    /// Splits a text of the source at `location` into what is shown as it is and the values between.
    pub(super) fn message(&mut self, text: &str, location: Span) -> Vec<MessagePart> {
        let mut parts = Vec::new();
        let mut plain = String::new();
        let mut rest = text;
        while let Some(first) = rest.chars().next() {
            if let Some((variable, decimals, length)) = self.placeholder(rest) {
                let start = location.end - rest.len() + 1;
                let name = Span::new(start, start + self.names.variables[variable].name.len());
                self.uses.variable(name, variable, Access::Read);
                if !plain.is_empty() {
                    parts.push(MessagePart::Text(std::mem::take(&mut plain)));
                }
                parts.push(MessagePart::Value {
                    scalar: Scalar {
                        variable,
                        member: 0,
                    },
                    decimals,
                });
                rest = &rest[length..];
            } else {
                if let Some(variable) = self.value_of_others(rest) {
                    self.uses.was_to_be_shown(variable);
                }
                let length = shown(rest, first, &mut plain);
                rest = &rest[length..];
            }
        }
        if !plain.is_empty() {
            parts.push(MessagePart::Text(plain));
        }
        parts
    }

    /// `%N`, `$N`, `{N}`, `％N％` at the start: the variable that is not shown, although it was meant to be.
    fn value_of_others(&self, text: &str) -> Option<usize> {
        let name = text.strip_prefix(['%', '$', '{', '％'])?;
        let is_name = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let name = &name[..name.len() - name.trim_start_matches(is_name).len()];
        self.names.find(&name.to_ascii_uppercase())
    }

    /// `%NAME%` or `%NAME.n%` at the start: the VAR, its decimals, the placeholder's length.
    fn placeholder(&self, text: &str) -> Option<(usize, u8, usize)> {
        let inner = text.strip_prefix('%')?;
        let inner = &inner[..inner.find('%')?];
        let (name, decimals) = match inner.split_once('.') {
            Some((name, digits)) => match digits.as_bytes() {
                [digit @ b'0'..=b'7'] => (name, digit - b'0'),
                _ => return None,
            },
            None => (inner, 0),
        };
        let variable = self.names.find(&name.to_ascii_uppercase())?;
        let is_var = self.names.variables[variable].kind == VariableKind::Var;
        is_var.then_some((variable, decimals, inner.len() + 2))
    }
}

/// Adds what the start of a text, whose first character is `first`, shows; returns its length in the source.
///
/// A doubled backslash stays as it is, so that the second one escapes nothing.
fn shown(text: &str, first: char, plain: &mut String) -> usize {
    let length = first.len_utf8();
    match (first, text[length..].chars().next()) {
        ('\\' | '\u{A5}', Some('a')) => plain.push('\u{7}'),
        ('\\' | '\u{A5}', Some('t')) => plain.push('\t'),
        ('\\' | '\u{A5}', Some(second @ ('\\' | '\u{A5}'))) => {
            plain.extend([first, second]);
            return length + second.len_utf8();
        }
        ('\u{3000}', _) => {
            plain.push_str("  ");
            return length;
        }
        _ => {
            plain.push(first);
            return length;
        }
    }
    length + 1
}
