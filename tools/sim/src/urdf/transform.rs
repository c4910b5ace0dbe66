//! Transformations between frames, and their angles in URDF.

/// The pose of a frame in its parent's.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Origin {
    /// Position, m.
    pub(super) xyz: [f64; 3],
    /// Turns about the fixed axes x, y and z, in this order, rad.
    pub(super) rpy: [f64; 3],
}

/// The axis of a file's root link that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// x up, −z forward, y left.
    X,
    /// y up, x forward, z right.
    Y,
    /// z up, x forward, y left, as in REP 103.
    #[default]
    Z,
}

/// A rigid transformation: a rotation, and the position of the origin, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform {
    rotation: [[f64; 3]; 3],
    at: [f64; 3],
}

impl Transform {
    /// Returns the root link of a URDF file in a robot frame with x to the right and y forward.
    pub(super) fn of_root(up: Up) -> Transform {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let back = |axis: [f64; 3]| axis.map(|part| -part);
        Transform {
            rotation: match up {
                Up::X => [back(y), back(z), x],
                Up::Y => [z, x, y],
                Up::Z => [back(y), x, z],
            },
            at: [0.0; 3],
        }
    }

    /// Returns the transformation of a frame at `origin` in this one.
    pub(super) fn then(&self, origin: &Origin) -> Transform {
        let inner = rotation(origin.rpy);
        let column = |j: usize| inner.map(|row| row[j]);
        let columns = [0, 1, 2].map(|j| self.direction(column(j)));
        let shift = self.direction(origin.xyz);
        Transform {
            rotation: [0, 1, 2].map(|i| columns.map(|column| column[i])),
            at: [0, 1, 2].map(|i| self.at[i] + shift[i]),
        }
    }

    /// Transforms a direction into the outer frame.
    pub(super) fn direction(&self, inner: [f64; 3]) -> [f64; 3] {
        self.rotation
            .map(|[a, b, c]| a * inner[0] + b * inner[1] + c * inner[2])
    }

    /// Transforms a tensor (xx, yy, zz, xy, xz, yz) into the outer frame.
    pub(super) fn tensor(&self, [xx, yy, zz, xy, xz, yz]: [f64; 6]) -> [f64; 6] {
        // Rows are turned, and then, since the tensor is symmetric, columns.
        let rows = [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]].map(|row| self.direction(row));
        let column = |axis: usize| self.direction(rows.map(|row| row[axis]));
        let [x, y, z] = [column(0), column(1), column(2)];
        [x[0], y[1], z[2], x[1], x[2], y[2]]
    }

    /// Returns the position of the origin, mm.
    pub(super) fn origin(&self) -> [f64; 3] {
        self.at.map(|metres| metres * 1000.0)
    }
}

/// Returns roll, pitch and yaw (rad) of the axes x, y and z.
pub(super) fn rpy_of_axes([x, y, z]: [[f64; 3]; 3]) -> [f64; 3] {
    /// Least horizontal length of an x axis that is not upright: for an upright one roll and yaw
    /// are about the same axis.
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

/// Returns the rotation of URDF's roll, pitch and yaw (rad): turns about the fixed axes x, y and z,
/// in this order.
fn rotation([roll, pitch, yaw]: [f64; 3]) -> [[f64; 3]; 3] {
    let [(sr, cr), (sp, cp), (sy, cy)] = [roll, pitch, yaw].map(libm::sincos);
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}

/// Returns roll, pitch and yaw (rad) of a quaternion (x, y, z, w) of any length, by the rules of
/// urdfdom.
pub(super) fn rpy_of_quaternion(quaternion: [f64; 4]) -> [f64; 3] {
    /// The sine of a pitch that leaves roll and yaw about the same axis.
    const UPRIGHT: f64 = 0.99999;
    let length = quaternion
        .iter()
        .map(|part| part * part)
        .sum::<f64>()
        .sqrt();
    let [x, y, z, w] = match length > 0.0 {
        true => quaternion.map(|part| part / length),
        false => [0.0, 0.0, 0.0, 1.0],
    };
    let sin_pitch = -2.0 * (x * z - w * y);
    if sin_pitch <= -UPRIGHT {
        [0.0, -std::f64::consts::FRAC_PI_2, 2.0 * libm::atan2(x, -y)]
    } else if sin_pitch >= UPRIGHT {
        [0.0, std::f64::consts::FRAC_PI_2, 2.0 * libm::atan2(-x, y)]
    } else {
        let [xx, yy, zz, ww] = [x, y, z, w].map(|part| part * part);
        [
            libm::atan2(2.0 * (y * z + w * x), ww - xx - yy + zz),
            libm::asin(sin_pitch),
            libm::atan2(2.0 * (x * y + w * z), ww + xx - yy - zz),
        ]
    }
}
