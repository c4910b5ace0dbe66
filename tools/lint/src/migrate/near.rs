//! `WAIT_NEAR target tolerance`: since 3.1 the tolerance is set beforehand (§1-1, §7-4-3).

use super::Migrator;
use super::lines::{Piece, Statement};
use super::variables::Variables;
use crate::message::Migrating;
use std::collections::BTreeSet;
use tipc::lex::{Kind, Token};
use tipc::source::{Source, Span};

/// Commands that put their target under position control.
const POSITIONS: &[&str] = &[
    "PTP",
    "REL_PTP",
    "COMPLIANCE_POSITION",
    "REL_COMPLIANCE_POSITION",
];
/// Commands that put every foot there.
const WHOLE_BODY: &[&str] = &["INITIAL_POSTURE", "STAND_UP", "SIT_DOWN"];
/// Commands that put it under angle control.
const ANGLES: &[&str] = &[
    "PTP_ANGLE",
    "REL_PTP_ANGLE",
    "COMPLIANCE",
    "COMPLIANCE_ANGLE",
    "REL_COMPLIANCE_ANGLE",
];

/// Unit of a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Measure {
    /// mm
    Position,
    /// deg
    Angle,
    /// The program moves the target in both ways.
    Both,
}

impl Migrator<'_> {
    /// Sets the tolerance in a step of its own, on the same line.
    pub(super) fn wait_near(
        &mut self,
        statement: &Statement,
        variables: &Variables,
        moves: &Moves,
    ) {
        let [word, target, values @ ..] = statement.tokens.as_slice() else {
            return;
        };
        let [
            value @ Token {
                kind: Kind::Word, ..
            },
        ] = values
        else {
            if !values.is_empty() {
                let location = values[0].span;
                self.question(location, Migrating::OneTolerance);
            }
            return;
        };
        let name = self.slice(target.span).to_ascii_uppercase();
        let is_plain = self.slice(value.span).is_ascii();
        if target.kind != Kind::Word || !is_target(&name) || !is_plain {
            return;
        }
        let measure = moves.measure(&name);
        if measure == Measure::Both {
            return self.ask_measure(value.span, &name);
        }
        if measure == Measure::Position
            && let Some(leg) = leg_of_joint(&name)
        {
            let text = Migrating::WholeLeg {
                leg: leg.to_owned(),
                target: name,
            };
            return self.question(value.span, text);
        }
        let setting = match measure {
            Measure::Angle => "SET_NEAR_ANGLE",
            Measure::Position | Measure::Both => "SET_NEAR_POSITION",
        };
        let mut behind = String::new();
        if measure == Measure::Angle && name.starts_with('F') {
            // A leg takes a tolerance for each of its three joints.
            let spelt = variables.spelt(self.slice(value.span));
            behind = format!(" {spelt} {spelt}");
        }
        let waiting = format!("{} {}", self.slice(word.span), self.slice(target.span));
        self.edits
            .insert(statement.end(), format!("{behind} ; {waiting}"));
        self.rename(word.span, setting);
        self.change(word.span, Migrating::TwoSteps { setting });
    }

    fn ask_measure(&mut self, location: Span, target: &str) {
        let target = target.to_owned();
        self.question(location, Migrating::WhichMeasure { target });
    }
}

/// Targets that the commands of a program move, and how.
#[derive(Debug, Default)]
pub(super) struct Moves {
    /// The words behind commands of [`POSITIONS`].
    positions: BTreeSet<String>,
    /// The words behind those of [`ANGLES`].
    angles: BTreeSet<String>,
    /// There is one of [`WHOLE_BODY`].
    whole_body: bool,
}

impl Moves {
    /// Collects the moves of a program.
    pub(super) fn of(source: &Source, pieces: &[Piece]) -> Self {
        let mut moves = Moves::default();
        for statement in pieces.iter().filter_map(Piece::statement) {
            let words = statement.words().skip(1);
            let words = words.map(|word| source.slice(word).to_ascii_uppercase());
            match statement.keyword.as_str() {
                keyword if POSITIONS.contains(&keyword) => moves.positions.extend(words),
                keyword if ANGLES.contains(&keyword) => moves.angles.extend(words),
                keyword => moves.whole_body |= WHOLE_BODY.contains(&keyword),
            }
        }
        moves
    }

    /// Returns how the program moves what WAIT_NEAR waits for; where it does not, the kind of the target decides.
    fn measure(&self, target: &str) -> Measure {
        let is_joint = target.starts_with('J');
        let moves = |words: &BTreeSet<String>| match target {
            "ALL" => !words.is_empty(),
            _ => words.contains(target),
        };
        let positions = moves(&self.positions) || (!is_joint && self.whole_body);
        match (positions, moves(&self.angles)) {
            (true, true) => Measure::Both,
            (true, false) => Measure::Position,
            (false, true) => Measure::Angle,
            (false, false) if is_joint => Measure::Angle,
            (false, false) => {
                let joints = target.replacen('F', "J", 1);
                let mut of_leg = self.angles.range(joints.clone()..);
                match of_leg.next().is_some_and(|word| word.starts_with(&joints)) {
                    true => Measure::Angle,
                    false => Measure::Position,
                }
            }
        }
    }
}

/// Returns the leg of a joint's name.
fn leg_of_joint(target: &str) -> Option<&str> {
    target.strip_prefix('J')?.get(..1)
}

/// Returns true if WAIT_NEAR can wait for this.
fn is_target(name: &str) -> bool {
    let is_number = |digits: &str| digits.bytes().all(|byte| matches!(byte, b'1'..=b'9'));
    match (name.strip_prefix('F'), name.strip_prefix('J')) {
        (Some(leg), _) => leg.len() == 1 && is_number(leg),
        (_, Some(joint)) => joint.len() == 2 && is_number(joint),
        (None, None) => name == "ALL",
    }
}
