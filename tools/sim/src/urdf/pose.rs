//! The pose of a frame in another one.

use super::robot::Origin;

/// The axis of a file's root link that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// With −z forward and y left.
    X,
    /// With x forward and z right.
    Y,
    /// With x forward and y left, as REP 103 has it.
    #[default]
    Z,
}

/// A rotation, and the origin in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pose {
    rotation: [[f64; 3]; 3],
    at: [f64; 3],
}

impl Pose {
    /// The root link of a URDF file in a robot frame with x to the right and y forward.
    pub(super) fn of_root(up: Up) -> Pose {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let back = |axis: [f64; 3]| axis.map(|part| -part);
        Pose {
            rotation: match up {
                Up::X => [back(y), back(z), x],
                Up::Y => [z, x, y],
                Up::Z => [back(y), x, z],
            },
            at: [0.0; 3],
        }
    }

    /// A frame at `origin` in this one.
    pub(super) fn then(&self, origin: &Origin) -> Pose {
        let inner = rotation(origin.rpy);
        let column = |j: usize| inner.map(|row| row[j]);
        let columns = [0, 1, 2].map(|j| self.direction(column(j)));
        let shift = self.direction(origin.xyz);
        Pose {
            rotation: [0, 1, 2].map(|i| columns.map(|column| column[i])),
            at: [0, 1, 2].map(|i| self.at[i] + shift[i]),
        }
    }

    /// A direction of this frame, as the outer one sees it.
    pub(super) fn direction(&self, inner: [f64; 3]) -> [f64; 3] {
        self.rotation
            .map(|[a, b, c]| a * inner[0] + b * inner[1] + c * inner[2])
    }

    /// The elements xx, yy, zz, xy, xz and yz of a tensor of this frame, as the outer one sees it.
    pub(super) fn tensor(&self, [xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [f64; 6] {
        // Rows are turned, and then, since the tensor is symmetric, columns.
        let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(|row| self.direction(row));
        let column = |axis: usize| self.direction(rows.map(|row| row[axis]));
        let [x, y, z] = [column(0), column(1), column(2)];
        [x[0], y[1], z[2], x[1], x[2], y[2]]
    }

    /// The origin: mm.
    pub(super) fn origin(&self) -> [f64; 3] {
        self.at.map(|metres| metres * 1000.0)
    }
}

/// The roll, pitch and yaw (rad) of these axes x, y and z.
pub(super) fn roll_pitch_yaw([x, y, z]: [[f64; 3]; 3]) -> [f64; 3] {
    /// Of an x that is upright: there roll and yaw are about the same axis.
    const LEVEL: f64 = 1e-12;
    let level = (x[0] * x[0] + x[1] * x[1]).sqrt();
    let pitch = libm::atan2(-x[2], level);
    if level < LEVEL {
        return [0.0, pitch, libm::atan2(-y[0], y[1])];
    }
    let yaw = libm::atan2(x[1], x[0]);
    // What a yaw near there is off by, the roll makes good.
    let (sin, cos) = libm::sincos(yaw);
    let roll = libm::atan2(sin * z[0] - cos * z[1], cos * y[1] - sin * y[0]);
    [roll, pitch, yaw]
}

/// URDF's roll, pitch and yaw (rad): turns about the fixed axes x, y and z, one after the other.
fn rotation([roll, pitch, yaw]: [f64; 3]) -> [[f64; 3]; 3] {
    let [(sr, cr), (sp, cp), (sy, cy)] = [roll, pitch, yaw].map(libm::sincos);
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}
