//! `WAIT_NEAR target tolerance`: since 3.1 the tolerance is set beforehand (§1-1, §7-4-3).

use super::Migrator;
use super::lines::{Piece, Statement};
use super::variables::Variables;
use crate::lex::{Kind, Token};
use crate::message::Migrating;
use crate::source::Span;

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

/// What a tolerance is measured in.
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
        pieces: &[Piece],
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
                let place = values[0].span;
                self.question(place, Migrating::OneTolerance);
            }
            return;
        };
        let name = self.slice(target.span).to_ascii_uppercase();
        let is_plain = self.slice(value.span).is_ascii();
        if target.kind != Kind::Word || !is_target(&name) || !is_plain {
            return;
        }
        let measure = self.measure(&name, pieces);
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

    fn ask_measure(&mut self, place: Span, target: &str) {
        let target = target.to_owned();
        self.question(place, Migrating::WhichMeasure { target });
    }

    /// How the program moves what WAIT_NEAR waits for; where it does not, by the kind of the target.
    fn measure(&self, target: &str, pieces: &[Piece]) -> Measure {
        let is_joint = target.starts_with('J');
        let itself = |word: &str| target == "ALL" || word == target;
        let positions =
            self.moved(POSITIONS, pieces, itself) || (!is_joint && self.runs(WHOLE_BODY, pieces));
        match (positions, self.moved(ANGLES, pieces, itself)) {
            (true, true) => Measure::Both,
            (true, false) => Measure::Position,
            (false, true) => Measure::Angle,
            (false, false) if is_joint => Measure::Angle,
            (false, false) => {
                let joints = target.replacen('F', "J", 1);
                let of_leg = |word: &str| word.starts_with(&joints);
                match self.moved(ANGLES, pieces, of_leg) {
                    true => Measure::Angle,
                    false => Measure::Position,
                }
            }
        }
    }

    /// Whether the program has one of these commands followed by such a word.
    fn moved(&self, commands: &[&str], pieces: &[Piece], word: impl Fn(&str) -> bool) -> bool {
        let mut statements = pieces.iter().filter_map(Piece::statement);
        statements.any(|statement| {
            let mut words = statement.words().skip(1);
            commands.contains(&statement.keyword.as_str())
                && words.any(|span| word(&self.slice(span).to_ascii_uppercase()))
        })
    }

    /// Whether the program has one of these commands.
    fn runs(&self, commands: &[&str], pieces: &[Piece]) -> bool {
        let mut statements = pieces.iter().filter_map(Piece::statement);
        statements.any(|statement| commands.contains(&statement.keyword.as_str()))
    }
}

/// The leg of a joint's name.
fn leg_of_joint(target: &str) -> Option<&str> {
    target.strip_prefix('J')?.get(..1)
}

/// Whether WAIT_NEAR can wait for this.
fn is_target(name: &str) -> bool {
    let is_number = |digits: &str| digits.bytes().all(|byte| matches!(byte, b'1'..=b'9'));
    match (name.strip_prefix('F'), name.strip_prefix('J')) {
        (Some(leg), _) => leg.len() == 1 && is_number(leg),
        (_, Some(joint)) => joint.len() == 2 && is_number(joint),
        (None, None) => name == "ALL",
    }
}
