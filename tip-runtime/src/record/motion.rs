//! The motion of a simulated robot in a cycle, as the trace shows it.

use crate::plant::{Motion, Pose};
use core::fmt::{self, Write};

/// The motion of a simulated robot in a cycle. Joints come leg by leg.
#[derive(Clone, Copy, Debug)]
pub struct MotionRecord<'a> {
    /// Pose of the body; `None` for a robot that stays where it is.
    pub pose: Option<Pose>,
    /// Motion of the body, if known.
    pub motion: Option<Motion>,
    /// Number of joints of each leg.
    pub joints_per_leg: usize,
    /// True joint angles, deg; empty if unknown.
    pub angles: &'a [f64],
    /// The load of each foot or the contact force of each fingertip, N; empty if unknown.
    pub loads: &'a [f64],
}

impl MotionRecord<'_> {
    /// Writes the keys `pose`, `angles`, `loads`, `margin` and `falls`, each after a comma; then `zmp`, and `tips`,
    /// `slides`, `crossings`, `hurries` and `strays` once they are above 0.
    pub(super) fn write(&self, out: &mut impl Write) -> fmt::Result {
        if let Some(pose) = &self.pose {
            let [x, y, z] = pose.position;
            let pose = [x, y, z, pose.roll, pose.pitch, pose.yaw];
            out.write_str(r#","pose":"#)?;
            numbers(out, &pose)?;
        }
        if !self.angles.is_empty() {
            let mut opening = r#","angles":["#;
            for leg in self.angles.chunks(self.joints_per_leg.max(1)) {
                out.write_str(opening)?;
                numbers(out, leg)?;
                opening = ",";
            }
            out.write_char(']')?;
        }
        if !self.loads.is_empty() {
            out.write_str(r#","loads":"#)?;
            numbers(out, self.loads)?;
        }
        if let Some(Motion { margin, falls, .. }) = &self.motion {
            write!(out, r#","margin":{},"falls":{falls}"#, Number(*margin))?;
        }
        let Some(Motion {
            tracking_errors,
            unmodelled,
            ..
        }) = self.motion
        else {
            return Ok(());
        };
        if let Some(unmodelled) = unmodelled {
            write!(out, r#","zmp":{}"#, Number(unmodelled.zmp_margin))?;
            counts(
                out,
                [
                    ("tips", unmodelled.tips),
                    ("slides", unmodelled.slides),
                    ("crossings", unmodelled.crossings),
                ],
            )?;
        }
        counts(
            out,
            [
                ("hurries", tracking_errors.hurries),
                ("strays", tracking_errors.strays),
            ],
        )
    }
}

/// Writes the counts that are above 0.
fn counts<const N: usize>(out: &mut impl Write, counts: [(&str, u32); N]) -> fmt::Result {
    for (key, count) in counts.into_iter().filter(|(_, count)| *count > 0) {
        write!(out, r#","{key}":{count}"#)?;
    }
    Ok(())
}

/// A JSON number in the shortest form that reads back to the same bits; JSON has no infinity, which
/// becomes `null`.
struct Number(f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.0.is_finite() {
            write!(f, "{:?}", self.0)
        } else {
            f.write_str("null")
        }
    }
}

/// Writes an array.
fn numbers(out: &mut impl Write, values: &[f64]) -> fmt::Result {
    let mut opening = '[';
    for value in values {
        write!(out, "{opening}{}", Number(*value))?;
        opening = ',';
    }
    out.write_char(']')
}

#[cfg(test)]
mod tests {
    extern crate std;

    use super::*;
    use std::string::String;

    #[test]
    fn numbers_that_json_lacks_are_null() {
        let mut out = String::new();
        let all = [1.5, f64::NAN, -0.0, f64::INFINITY, f64::NEG_INFINITY, 1e300];
        assert_eq!(numbers(&mut out, &all), Ok(()));
        assert_eq!(out, "[1.5,null,-0.0,null,null,1e300]");
    }
}
