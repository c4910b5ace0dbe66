//! How far a foot is beside the path that its joints were commanded.

use super::Vector;
use super::links::LegLinks;
use crate::hardware::JointCommand;
use crate::model::Leg;

/// Places that differ by less are the same, and lead nowhere: mm.
const SAME: f64 = 1e-6;

/// Where commands lead a foot.
#[derive(Clone, Copy, Debug)]
pub(super) struct Path<const J: usize> {
    /// The angles commanded last (deg), and where they put the foot (mm).
    last: Option<([f64; J], Vector)>,
    /// In which direction the foot was led there.
    along: Option<Vector>,
}

impl<const J: usize> Path<J> {
    /// Nothing was commanded yet.
    pub(super) const NONE: Self = Path {
        last: None,
        along: None,
    };

    /// How far `foot` (mm) is beside the line along which it was led last: mm. A foot that only follows late is on it.
    /// Torques lead along no path.
    pub(super) fn stray(
        &mut self,
        leg: &Leg<J>,
        commands: &[JointCommand; J],
        foot: Vector,
    ) -> f64 {
        let Some(angles) = angles(commands) else {
            *self = Path::NONE;
            return 0.0;
        };
        let place = self.lead(leg, angles);
        let off = foot - place;
        self.along
            .map_or(0.0, |along| (off - along * along.dot(&off)).norm())
    }

    /// Where these angles put the foot.
    fn lead(&mut self, leg: &Leg<J>, angles: [f64; J]) -> Vector {
        let last = self.last;
        if let Some((before, place)) = last
            && before == angles
        {
            return place;
        }
        let mut links = LegLinks::NOWHERE;
        links.place(leg, angles);
        self.last = Some((angles, links.foot));
        if let Some((_, before)) = last {
            let step = links.foot - before;
            if step.norm() > SAME {
                self.along = Some(step / step.norm());
            }
        }
        links.foot
    }
}

/// The angles of commands that are all angles.
fn angles<const J: usize>(commands: &[JointCommand; J]) -> Option<[f64; J]> {
    let mut angles = [0.0; J];
    for (angle, command) in angles.iter_mut().zip(commands) {
        let JointCommand::Angle { angle: to, .. } = command else {
            return None;
        };
        *angle = *to;
    }
    Some(angles)
}
