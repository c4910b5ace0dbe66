//! `WAIT_NEAR target tolerance`: since 3.1 the tolerance is set beforehand (§1-1, §7-4-3).

use super::Migrator;
use super::lines::{Piece, Statement};
use super::variables::Variables;
use crate::lex::Kind;
use crate::syntax::Span;

/// Commands that put their target under position control.
const POSITIONS: &[&str] = &[
    "PTP",
    "REL_PTP",
    "COMPLIANCE_POSITION",
    "REL_COMPLIANCE_POSITION",
];
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
        let [value] = values else {
            if !values.is_empty() {
                let place = values[0].span;
                self.question(
                    place,
                    "WAIT_NEAR takes one tolerance, not negative: which one is meant?",
                );
            }
            return;
        };
        let name = self.slice(target.span).to_ascii_uppercase();
        let measure = self.measure(&name, pieces);
        if value.kind != Kind::Word || measure == Measure::Both {
            return self.ask_measure(value.span, &name);
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
        let waiting = self
            .slice(Span::new(word.span.start, target.span.end))
            .to_owned();
        self.edits
            .insert(statement.end(), format!("{behind} ; {waiting}"));
        self.rename(word.span, setting);
        let text = format!(
            "two steps, {setting} and WAIT_NEAR: since 3.1 the tolerance is set beforehand, and stays set"
        );
        self.change(word.span, text);
    }

    fn ask_measure(&mut self, place: Span, target: &str) {
        let text = format!(
            "the program moves {target} to positions and to angles: is this tolerance in mm (SET_NEAR_POSITION) \
             or in deg (SET_NEAR_ANGLE)?"
        );
        self.question(place, text);
    }

    /// How the program moves what WAIT_NEAR waits for; where it does not, by the kind of the target.
    fn measure(&self, target: &str, pieces: &[Piece]) -> Measure {
        let moved = |commands: &[&str]| {
            let mut statements = pieces.iter().filter_map(Piece::statement);
            statements.any(|statement| {
                let mut words = statement.words().skip(1);
                let named = |word: Span| {
                    let word = self.slice(word).to_ascii_uppercase();
                    target == "ALL" || word == target
                };
                commands.contains(&statement.keyword.as_str()) && words.any(named)
            })
        };
        match (moved(POSITIONS), moved(ANGLES)) {
            (true, true) => Measure::Both,
            (true, false) => Measure::Position,
            (false, true) => Measure::Angle,
            (false, false) if target.starts_with('J') => Measure::Angle,
            (false, false) => Measure::Position,
        }
    }
}
