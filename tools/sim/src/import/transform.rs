//! Rigid transformations between frames, and the forms in which files state rotations.

use super::ImportError;
use crate::message::Importing;

/// The axis of a file's root link that points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Up {
    /// x up.
    X,
    /// y up.
    Y,
    /// z up, as in REP 103.
    #[default]
    Z,
}

/// The axis of a file's root link that points forward.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Forward {
    /// x forward, as in REP 103.
    X,
    /// y forward.
    Y,
    /// z forward.
    Z,
    /// −x forward.
    MinusX,
    /// −y forward.
    MinusY,
    /// −z forward.
    MinusZ,
}

impl Up {
    /// Returns the default direction of forward: x, or −z where x points up.
    fn forward(self) -> Forward {
        match self {
            Up::X => Forward::MinusZ,
            Up::Y | Up::Z => Forward::X,
        }
    }

    fn axis(self) -> [f64; 3] {
        match self {
            Up::X => [1.0, 0.0, 0.0],
            Up::Y => [0.0, 1.0, 0.0],
            Up::Z => [0.0, 0.0, 1.0],
        }
    }
}

impl Forward {
    /// All directions with their names in options.
    pub const ALL: [(&'static str, Forward); 6] = [
        ("x", Forward::X),
        ("y", Forward::Y),
        ("z", Forward::Z),
        ("-x", Forward::MinusX),
        ("-y", Forward::MinusY),
        ("-z", Forward::MinusZ),
    ];

    fn axis(self) -> [f64; 3] {
        match self {
            Forward::X => [1.0, 0.0, 0.0],
            Forward::Y => [0.0, 1.0, 0.0],
            Forward::Z => [0.0, 0.0, 1.0],
            Forward::MinusX => [-1.0, 0.0, 0.0],
            Forward::MinusY => [0.0, -1.0, 0.0],
            Forward::MinusZ => [0.0, 0.0, -1.0],
        }
    }

    /// Returns the name of the direction in options.
    pub fn name(self) -> &'static str {
        let row = Forward::ALL.iter().find(|(_, forward)| *forward == self);
        row.map_or("x", |(name, _)| name)
    }

    /// Returns the direction that is nearest to one of the file's root link.
    pub(super) fn nearest(direction: [f64; 3]) -> Forward {
        let along = |forward: Forward| dot(forward.axis(), direction);
        let mut best = Forward::X;
        for (_, forward) in Forward::ALL {
            if along(forward) > along(best) {
                best = forward;
            }
        }
        best
    }
}

/// A rigid transformation: the pose of a frame in an outer one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Transform {
    /// Rows of the rotation matrix.
    pub(super) rotation: [[f64; 3]; 3],
    /// Position, m.
    pub(super) at: [f64; 3],
}

impl Default for Transform {
    fn default() -> Self {
        Transform {
            rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            at: [0.0; 3],
        }
    }
}

impl Transform {
    /// Returns the root link of a file in a robot frame with x to the right and y forward.
    pub(super) fn of_root(up: Up, forward: Option<Forward>) -> Result<Transform, ImportError> {
        let forward = forward.unwrap_or_else(|| up.forward());
        let (ahead, above) = (forward.axis(), up.axis());
        if dot(ahead, above) != 0.0 {
            return Err(ImportError::new(Importing::ForwardIsUp {
                forward: forward.name(),
            }));
        }
        Ok(Transform {
            // Adding 0 makes of −0 a plain 0.
            rotation: [cross(ahead, above), ahead, above].map(|row| row.map(|part| part + 0.0)),
            at: [0.0; 3],
        })
    }

    /// Returns a shifted frame with parallel axes, m.
    pub(super) fn shifted(at: [f64; 3]) -> Transform {
        Transform {
            at,
            ..Transform::default()
        }
    }

    /// Returns a frame with these axes, of length 1.
    pub(super) fn of_axes([x, y, z]: [[f64; 3]; 3]) -> Transform {
        Transform {
            rotation: [0, 1, 2].map(|i| [x[i], y[i], z[i]]),
            at: [0.0; 3],
        }
    }

    /// Returns the frame of URDF's roll, pitch and yaw (rad): turns about the fixed axes x, y and z, in
    /// this order.
    pub(super) fn of_rpy([roll, pitch, yaw]: [f64; 3]) -> Transform {
        let [(sr, cr), (sp, cp), (sy, cy)] = [roll, pitch, yaw].map(libm::sincos);
        Transform {
            rotation: [
                [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                [-sp, cp * sr, cp * cr],
            ],
            at: [0.0; 3],
        }
    }

    /// Returns the frame of a quaternion (w, x, y, z) of any length; one of length 0 does not turn.
    pub(super) fn of_quaternion(quaternion: [f64; 4]) -> Transform {
        let length = quaternion.iter().map(|part| part * part).sum::<f64>();
        let length = length.sqrt();
        if length <= 0.0 {
            return Transform::default();
        }
        let [w, x, y, z] = quaternion.map(|part| part / length);
        Transform {
            rotation: [
                [
                    w * w + x * x - y * y - z * z,
                    2.0 * (x * y - w * z),
                    2.0 * (x * z + w * y),
                ],
                [
                    2.0 * (x * y + w * z),
                    w * w - x * x + y * y - z * z,
                    2.0 * (y * z - w * x),
                ],
                [
                    2.0 * (x * z - w * y),
                    2.0 * (y * z + w * x),
                    w * w - x * x - y * y + z * z,
                ],
            ],
            at: [0.0; 3],
        }
    }

    /// Returns the frame that is turned about an axis of any length by an angle, rad.
    pub(super) fn turned(axis: [f64; 3], angle: f64) -> Transform {
        let length = dot(axis, axis).sqrt();
        if length <= 0.0 {
            return Transform::default();
        }
        let (sin, cos) = libm::sincos(angle / 2.0);
        let [x, y, z] = axis.map(|part| part / length * sin);
        Transform::of_quaternion([cos, x, y, z])
    }

    /// Returns this frame with its origin moved, m.
    pub(super) fn moved(self, at: [f64; 3]) -> Transform {
        Transform { at, ..self }
    }

    /// Returns the transformation of a frame at `inner` in this one.
    pub(super) fn then(&self, inner: &Transform) -> Transform {
        let column = |j: usize| inner.rotation.map(|row| row[j]);
        let columns = [0, 1, 2].map(|j| self.direction(column(j)));
        let shift = self.direction(inner.at);
        Transform {
            rotation: [0, 1, 2].map(|i| columns.map(|column| column[i])),
            at: [0, 1, 2].map(|i| self.at[i] + shift[i]),
        }
    }

    /// Transforms a direction into the outer frame.
    pub(super) fn direction(&self, inner: [f64; 3]) -> [f64; 3] {
        self.rotation.map(|row| dot(row, inner))
    }

    /// Transforms a direction of the outer frame into this one.
    pub(super) fn inward(&self, outer: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|j| dot(self.rotation.map(|row| row[j]), outer))
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

/// Returns the tensor (xx, yy, zz, xy, xz, yz) of a point mass at a place (m) about the origin.
pub(super) fn point_tensor(mass: f64, [x, y, z]: [f64; 3]) -> [f64; 6] {
    [
        y * y + z * z,
        x * x + z * z,
        x * x + y * y,
        -x * y,
        -x * z,
        -y * z,
    ]
    .map(|element| mass * element)
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}
