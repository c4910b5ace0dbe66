//! Targets and event flags, as far as the robot has them, and conditions (T.I.P. 3.1 §6, §10-3-5).

use super::names::inventory;
use super::resolve::{Refused, Resolver};
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::Targets;
use crate::language::reserved::JOINT;
use crate::language::{commands, flags};
use crate::message::list::{Alternatives, List};
use crate::message::{Commanding, Message, Suggestion};
use crate::program::Condition;
use crate::robot::Robot;
use crate::source::Span;
use crate::suggest::{digit_like, nearest};
use crate::syntax::{self, Operand, OperandKind, Word, upper_case};
use tip_runtime::command::{CONSTANT, Flag, Target};

/// Returns the word that an operand is, if it is one without sign and member.
pub(super) fn word(operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name(name) if !operand.negative => Some(name),
        _ => None,
    }
}

impl Resolver<'_> {
    /// Suggests a replacement for a command for feet: the statement if it has one number, else the forms of the other
    /// command.
    fn for_joint(&self, command: &Word, other: &'static str, arguments: &[Operand]) -> Message {
        if let [_, _] = arguments {
            let rest = self.rest_of_statement(command.span).trim_end();
            let text = upper_case(&format!("{other}{rest}"));
            return Suggestion::Write { text }.into();
        }
        let usage = commands::find(other).map(|row| row.usage(self.robot, self.names.edition));
        let forms = Alternatives(usage.unwrap_or_default());
        Commanding::Write { forms }.into()
    }

    /// Resolves the target, which is the first of a command's arguments.
    pub(super) fn target(
        &mut self,
        command: &Word,
        targets: Targets,
        arguments: &[Operand],
    ) -> Option<Target> {
        let Some(first) = arguments.first() else {
            let reason = Commanding::WantsTarget {
                command: command.node.clone(),
                targets: self.wanted(targets),
            };
            return self.refuse_target(command.span, reason);
        };
        let Some(target) = word(first).and_then(|word| word.parse().ok()) else {
            let help = self.suggest_target(command, targets, arguments);
            let targets = self.wanted(targets);
            let reason = Commanding::TargetBelongsHere { targets };
            return match (help, word(first)) {
                (Some(help), _) => self.refuse_with(Code::Argument, first.span, reason, help),
                (None, Some(word)) if self.names.find(word).is_none() => {
                    self.refuse_target(first.span, reason)
                }
                // The usage of the command is added as the help.
                (None, _) => self.refuse(Code::Argument, first.span, reason),
            };
        };
        if !self.robot.has(target) {
            let robot = self.robot.name();
            let reason = Commanding::RobotHasNo { robot, target };
            return self.refuse_target(first.span, reason);
        }
        if targets.accept(target, self.robot) {
            return Some(target);
        }
        if let (Target::Joint(..), Some(other)) = (target, commands::of_joints(&command.node)) {
            let help = self.for_joint(command, other, arguments);
            let reason = Commanding::MovesFeet {
                command: command.node.clone(),
                other,
            };
            return self.refuse_with(Code::Argument, first.span, reason, help);
        }
        let reason = Commanding::OtherTargets {
            command: command.node.clone(),
            target,
            targets: self.wanted(targets),
        };
        if target == Target::All {
            let help = Suggestion::OneTarget {
                command: command.node.clone(),
            };
            return self.refuse_with(Code::Argument, first.span, reason, help);
        }
        self.refuse_target(first.span, reason)
    }

    /// Returns what was meant by a first argument that is no target.
    fn suggest_target(
        &self,
        command: &Word,
        targets: Targets,
        arguments: &[Operand],
    ) -> Option<Message> {
        let elsewhere = self.target_elsewhere(command, targets, arguments);
        elsewhere.or_else(|| {
            let word = word(arguments.first()?)?;
            if self.names.find(word).is_some() {
                return None;
            }
            if is_joint_of_no_leg(word) {
                return Some(Suggestion::JointName.into());
            }
            if let Some(command) = self.in_one_word(command) {
                let word = command.into();
                return Some(Suggestion::InOneWord { word }.into());
            }
            let near = self.looks_like_target(word)?.into();
            Some(Suggestion::DidYouMean { near }.into())
        })
    }

    /// Returns the help for a target without its letter, or after another argument: `PTP_ANGLE 11 30`, `TEACH_POSITION
    /// P F1`.
    fn target_elsewhere(
        &self,
        command: &Word,
        targets: Targets,
        arguments: &[Operand],
    ) -> Option<Message> {
        let [first, rest @ ..] = arguments else {
            return None;
        };
        let is_target =
            |target: &Target| self.robot.has(*target) && targets.accept(*target, self.robot);
        let number = self.slice(first.span);
        let by_number = || {
            let digits: Vec<u8> = number.bytes().map(|it| it.wrapping_sub(b'0')).collect();
            match digits.as_slice() {
                [leg @ 0..=9] => Some(Target::Foot(*leg)),
                [leg @ 0..=9, joint @ 0..=9] => Some(Target::Joint(*leg, *joint)),
                _ => None,
            }
        };
        if let Some(target) = by_number().filter(is_target).filter(|_| !rest.is_empty()) {
            let near = target.to_string().into();
            return Some(Suggestion::DidYouMean { near }.into());
        }
        let second = word(rest.first()?)?
            .parse::<Target>()
            .ok()
            .filter(is_target)?;
        let written = format!("{} {second} {}", command.node, upper_case(number)).into();
        (rest.len() == 1).then(|| Suggestion::TargetBefore { written }.into())
    }

    /// Returns the target that a word such as `Fl` or `J1l` was meant to be, if its letters look like digits.
    fn looks_like_target(&self, word: &str) -> Option<String> {
        let digits: String = word.chars().skip(1).map(digit_like).collect();
        let target: Target = format!("{}{digits}", word.get(..1)?).parse().ok()?;
        self.robot.has(target).then(|| target.to_string())
    }

    fn wanted(&self, targets: Targets) -> List {
        let examples = targets.examples(self.robot);
        List(examples.split('|').map(str::to_owned).collect())
    }

    fn refuse_target<T>(&mut self, location: Span, reason: Commanding) -> Option<T> {
        let fault = Diagnostic::new(Code::Argument, location, reason);
        let inventory = inventory(self.robot);
        self.report(fault.help(Commanding::RobotHas { inventory }));
        None
    }

    /// Resolves the event flag of a condition.
    pub(super) fn flag(&mut self, name: &Word) -> Option<Flag> {
        let named = flags::find(&name.node, self.names.edition);
        let found = named.filter(|(flag, row)| {
            let target = flag.target();
            row.robots.contains(self.robot) && target.is_none_or(|target| self.robot.has(target))
        });
        let found = found.map(|(flag, _)| flag);
        if found.is_none() {
            self.refuse_flag(name);
        }
        found
    }

    fn refuse_flag(&mut self, name: &Word) {
        let word = name.node.as_str();
        let robot = self.robot.name();
        let (reason, help) = match self.names.find(word) {
            Some(_) => {
                let name = &name.node;
                let help = Commanding::Compare { name: name.clone() };
                let reason = Commanding::VariableNoCondition { name: name.clone() };
                (reason, help)
            }
            None => {
                let location = name.span;
                let name = name.node.clone();
                let reason = Commanding::NoEventFlag { robot, name };
                let fault = Diagnostic::new(Code::Argument, location, reason);
                self.report(fault.guess(self.flag_help(word)));
                return;
            }
        };
        self.report(Diagnostic::new(Code::Argument, name.span, reason).help(help));
    }

    fn flag_help(&self, word: &str) -> Message {
        if word.starts_with(CONSTANT) {
            return Suggestion::KeyFirst { key: word.into() }.into();
        }
        match nearest(word, flags::words()).filter(|near| *near != word) {
            Some(near) => Suggestion::DidYouMean { near: near.into() }.into(),
            None => flags_of(self.robot).into(),
        }
    }
}

/// Returns true for a joint without its leg: `J1`, `J2`.
fn is_joint_of_no_leg(word: &str) -> bool {
    let number = word.strip_prefix(JOINT).unwrap_or_default();
    number.len() == 1 && number.starts_with(|c: char| c.is_ascii_digit())
}

/// Returns the event flags of a robot.
fn flags_of(robot: Robot) -> Commanding {
    let inventory = inventory(robot);
    match robot.is_hand() {
        true => Commanding::FlagsWith {
            others: List(vec![Flag::Antenna.to_string()]),
            inventory,
        },
        false => Commanding::Flags { inventory },
    }
}

impl Resolver<'_> {
    pub(super) fn condition(&mut self, condition: &syntax::Condition) -> Option<Condition> {
        match condition {
            syntax::Condition::Compare {
                left,
                relation,
                right,
            } => {
                let is_flag = word(left).is_some_and(|name| self.is_flag(name));
                let left = self.number(left, Code::Argument);
                if let Err(fault) = left
                    && is_flag
                {
                    // The right side is not a second mistake.
                    self.suggest_reading(right, fault);
                    return None;
                }
                let right = self.number(right, Code::Argument);
                if let Err(fault) = right {
                    self.suggest_key(fault);
                }
                Some(Condition::Compare {
                    left: left.ok()?,
                    relation: *relation,
                    right: right.ok()?,
                })
            }
            syntax::Condition::Flag { name, negated } => Some(Condition::Flag {
                flag: self.flag(name)?,
                negated: *negated,
            }),
        }
    }

    fn is_flag(&self, name: &str) -> bool {
        !self.names.has(name) && flags::find(name, self.names.edition).is_some()
    }

    /// Suggests reading the key for a flag that is compared with one.
    fn suggest_reading(&mut self, right: &syntax::Operand, fault: Refused) {
        let key = word(right).filter(|word| word.starts_with(CONSTANT));
        let fault = fault.and_then(|fault| self.found.get_mut(fault));
        if let (Some(fault), Some(key)) = (fault, key) {
            fault.help = Some(Suggestion::KeyFirst { key: key.into() }.into());
        }
    }

    /// Suggests a key's constant for a letter that is compared with and not declared.
    fn suggest_key(&mut self, fault: Refused) {
        if let Some(fault) = fault.and_then(|fault| self.found.get_mut(fault)) {
            let name = fault.subject.as_deref().unwrap_or_default();
            let is_key = name.len() == 1 && name.starts_with(|c: char| c.is_ascii_uppercase());
            if fault.code == Code::UnknownVariable && is_key {
                let character = name.into();
                fault.help = Some(Suggestion::CharacterOrVariable { character }.into());
            }
        }
    }
}
