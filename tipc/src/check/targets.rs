//! Targets and event flags of the robot at hand (T.I.P. 3.1 §6-2, §10-3-5).

use super::resolve::Resolver;
use super::suggest::nearest;
use crate::code::Code;
use crate::diagnostic::Diagnostic;
use crate::language::commands::{Joints, Targets};
use crate::language::flags;
use crate::robot::Robot;
use crate::source::Span;
use crate::syntax::{Operand, OperandKind, Word};
use tip_runtime::command::{Flag, Target};

/// The word that an operand is, if it is one without sign and member.
pub(super) fn word(operand: &Operand) -> Option<&str> {
    match &operand.kind {
        OperandKind::Name(name) if !operand.negative => Some(name),
        _ => None,
    }
}

impl Resolver<'_> {
    /// The target that stands first among a command's arguments.
    pub(super) fn target(
        &mut self,
        command: &Word,
        targets: Targets,
        arguments: &[Operand],
    ) -> Option<Target> {
        let Some(first) = arguments.first() else {
            let reason = format!(
                "{} wants a target, as {}",
                command.node,
                self.wanted(targets)
            );
            return self.refuse_target(command.span, reason);
        };
        let Some(target) = word(first).and_then(|word| word.parse().ok()) else {
            let reason = format!("a target belongs here, as {}", self.wanted(targets));
            return self.refuse_target(first.span, reason);
        };
        if !self.robot.has(target) {
            let reason = format!("{} has no {target}", self.robot.name());
            return self.refuse_target(first.span, reason);
        }
        if !takes(targets, target, self.robot) {
            let reason = format!(
                "{} takes no {target}; its targets are such as {}",
                command.node,
                self.wanted(targets)
            );
            return self.refuse_target(first.span, reason);
        }
        Some(target)
    }

    fn wanted(&self, targets: Targets) -> String {
        targets.examples(self.robot).replace('|', ", ")
    }

    fn refuse_target<T>(&mut self, place: Span, reason: String) -> Option<T> {
        let fault = Diagnostic::new(Code::Argument, place, reason);
        self.report(fault.help(self.robot.inventory()));
        None
    }

    /// The event flag of a condition.
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
            Some(_) => (
                format!("`{word}` is a variable; alone it is no condition"),
                format!("compare it with something: `{word} <> 0`"),
            ),
            None => (
                format!("{robot} has no event flag of this name"),
                self.flag_help(word),
            ),
        };
        self.report(Diagnostic::new(Code::Argument, name.span, reason).help(help));
    }

    fn flag_help(&self, word: &str) -> String {
        match nearest(word, flags::words()).filter(|near| *near != word) {
            Some(near) => format!("did you mean `{near}`?"),
            None => {
                let palm = if self.robot.is_hand() {
                    ", ANTENNA_ON"
                } else {
                    ""
                };
                format!(
                    "flags are HALT_REQUEST, KB_HIT, INPOS_F1 and NEAR_F1 (or another target), SPECIAL_FLAG0…9{palm}; {}",
                    self.robot.inventory()
                )
            }
        }
    }
}

fn takes(targets: Targets, target: Target, robot: Robot) -> bool {
    match target {
        Target::None => false,
        Target::All => targets.all,
        Target::Floor => targets.floor,
        Target::Foot(_) => targets.foot,
        Target::Joint(_, joint) => match targets.joints {
            Joints::None => false,
            Joints::Every => true,
            Joints::Second => joint == 2,
            Joints::Third => joint == 3,
            Joints::ThirdOfHand => joint == 3 && robot.is_hand(),
        },
    }
}
