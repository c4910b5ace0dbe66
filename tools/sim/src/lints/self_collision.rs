//! The lint of constant targets at which two parts of the robot overlap (W138).
//!
//! A posture is judged where it is certain. From the start of the program to its first condition or jump the targets of all joints
//! are known: they are judged when the program waits for the last joint that moves. Anywhere else a PTP_ANGLE of a whole leg is
//! judged, with the links of that leg and the body alone.

use super::{constants, keeps_targets, place, stops_at_limits, tenths};
use crate::Robot;
use crate::message::Linting;
use crate::model::Miss;
use std::collections::{BTreeMap, BTreeSet};
use tip_runtime::command::{Op, Target};
use tip_runtime::model::Part;
use tip_runtime::plant::{Distances, Gap};
use tipc::Loaded;
use tipc::code::Code;
use tipc::diagnostic::Diagnostic;
use tipc::program::{Action, Step};
use tipc::source::Span;

/// Adds a warning for each constant target at which the robot hits itself.
pub(super) fn warn(loaded: &mut Loaded, robot: &Robot) {
    let certain = |program: &&_| stops_at_limits(program);
    let Some(program) = loaded.program.as_ref().filter(certain) else {
        return;
    };
    let mut postures = Postures::of(robot);
    let mut found = Vec::new();
    for (statement, step) in loaded.module.steps().zip(program.steps()) {
        let span = || place(statement, Miss::Ends { by: 0.0 });
        let hit = postures
            .after(step, span)
            .or_else(|| postures.of_leg(step, span));
        found.extend(hit.map(|(span, gap)| overlap(span, gap)));
    }
    tip_lint::add(loaded, found);
}

fn overlap(span: Span, gap: Gap) -> Diagnostic {
    let [one, other] = gap.parts;
    let by = tenths(-gap.distance).max(0.1);
    let finding = Diagnostic::new(Code::HitsItself, span, Linting::Overlaps { one, other, by });
    finding.help(Linting::ChooseApart)
}

/// Returns the leg of a part, from 1; none of the body.
fn leg_of(part: Part) -> Option<u8> {
    match part {
        Part::Body => None,
        Part::Link(leg, _) => Some(leg),
    }
}

/// The postures that are known from the text of a program.
struct Postures<'a> {
    robot: &'a Robot,
    distances: Distances,
    /// The initial posture, leg by leg.
    initial: Vec<f64>,
    /// Number of joints of a leg.
    of_leg: usize,
    /// The targets of all joints; `None` after the first condition or jump, and after a command that may move anything.
    targets: Option<Vec<f64>>,
    /// The legs that move.
    moving: BTreeSet<u8>,
    /// The last command to each leg since the last judgement.
    commanded: BTreeMap<u8, Span>,
}

impl<'a> Postures<'a> {
    fn of(robot: &'a Robot) -> Self {
        let description = robot.description();
        let initial: Vec<f64> = description
            .legs
            .iter()
            .flat_map(|leg| leg.initial.clone())
            .collect();
        Postures {
            robot,
            distances: robot.distances(),
            of_leg: description.joints,
            targets: Some(initial.clone()),
            initial,
            moving: BTreeSet::new(),
            commanded: BTreeMap::new(),
        }
    }

    /// Applies the effect of a step, and returns the parts that overlap once the joints that it waits for have arrived, with
    /// the command that brings one of them there.
    fn after(&mut self, step: &Step, span: impl Fn() -> Span) -> Option<(Span, Gap)> {
        let targets = self.targets.as_mut()?;
        let goes_on = match &step.action {
            Action::Command {
                op: op @ (Op::Ptp | Op::PtpAngle),
                target: target @ (Target::Foot(leg) | Target::Joint(leg, _)),
                arguments,
                ..
            } => {
                let values = constants(arguments);
                let turns = values.map(|values| self.robot.turns(*op, *target, &values, targets));
                let turns = turns.unwrap_or_default();
                for (joint, angle) in &turns {
                    targets[*joint] = *angle;
                }
                self.moving.insert(*leg);
                self.commanded.insert(*leg, span());
                !turns.is_empty()
            }
            Action::Command {
                op: Op::WaitInpos,
                target,
                ..
            } => {
                match target {
                    Target::All => self.moving.clear(),
                    Target::Foot(leg) => self.moving.retain(|moving| moving != leg),
                    _ => {}
                }
                if self.moving.is_empty() {
                    return self.judge();
                }
                true
            }
            action => keeps_targets(action),
        };
        self.targets = self.targets.take().filter(|_| goes_on);
        None
    }

    /// Judges the posture of joints that have all arrived. A posture counts at the commands that lead there.
    fn judge(&mut self) -> Option<(Span, Gap)> {
        let commanded = std::mem::take(&mut self.commanded);
        let gap = self.distances.overlap(self.targets.as_ref()?)?;
        let legs = gap.parts.into_iter().filter_map(leg_of);
        let commands = legs.filter_map(|leg| commanded.get(&leg).copied());
        let last = commands.max_by_key(|span| span.start)?;
        Some((last, gap))
    }

    /// Returns the parts of one leg, or a link and the body, that overlap at the end of a command to the whole leg.
    fn of_leg(&self, step: &Step, span: impl Fn() -> Span) -> Option<(Span, Gap)> {
        let Action::Command {
            op: op @ Op::PtpAngle,
            target: target @ Target::Foot(leg),
            arguments,
            ..
        } = &step.action
        else {
            return None;
        };
        if self.targets.is_some() {
            return None;
        }
        let mut angles = self.initial.clone();
        let turns = self
            .robot
            .turns(*op, *target, &constants(arguments)?, &angles);
        for (joint, angle) in turns.iter().filter(|_| turns.len() == self.of_leg) {
            angles[*joint] = *angle;
        }
        let gap = self.distances.overlap(&angles)?;
        let is_own = gap
            .parts
            .into_iter()
            .all(|part| leg_of(part).is_none_or(|of| of == *leg));
        is_own.then(|| (span(), gap))
    }
}
