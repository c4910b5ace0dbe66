//! Forward kinematics of URDF by homogeneous transforms, independent of the code under test.

use crate::urdf::robots::Joint;

type Matrix = [[f64; 4]; 4];

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// A turn by `angle` (rad) about a unit axis (Rodrigues), then a shift.
fn transform(axis: [f64; 3], angle: f64, shift: [f64; 3]) -> Matrix {
    let [x, y, z] = axis;
    let (sin, cos) = (sine(angle), sine(angle + std::f64::consts::FRAC_PI_2));
    let v = 1.0 - cos;
    [
        [
            cos + x * x * v,
            x * y * v - z * sin,
            x * z * v + y * sin,
            shift[0],
        ],
        [
            y * x * v + z * sin,
            cos + y * y * v,
            y * z * v - x * sin,
            shift[1],
        ],
        [
            z * x * v - y * sin,
            z * y * v + x * sin,
            cos + z * z * v,
            shift[2],
        ],
        [0.0, 0.0, 0.0, 1.0],
    ]
}

/// Returns the sine by its series, so that not even that is shared with the code under test.
fn sine(angle: f64) -> f64 {
    let mut term = angle;
    let mut sum = angle;
    for n in 1..40 {
        let n = f64::from(n);
        term *= -angle * angle / ((2.0 * n) * (2.0 * n + 1.0));
        sum += term;
    }
    sum
}

/// Returns the origin of a joint's child link by URDF's own frames, in mm with x to the right and y forward.
pub(crate) fn place(joints: &[Joint], child: &str, angles: &[(&str, f64)]) -> [f64; 3] {
    const X: [f64; 3] = [1.0, 0.0, 0.0];
    const Y: [f64; 3] = [0.0, 1.0, 0.0];
    const Z: [f64; 3] = [0.0, 0.0, 1.0];
    const NOWHERE: [f64; 3] = [0.0; 3];
    let mut frame = transform(Z, 0.0, NOWHERE);
    let mut link = child;
    while let Some(joint) = joints.iter().find(|joint| joint.child == link) {
        let [roll, pitch, yaw] = joint.rpy;
        let length = joint
            .axis
            .iter()
            .map(|part| part * part)
            .sum::<f64>()
            .sqrt();
        let axis = joint.axis.map(|part| part / length);
        let angle = angles.iter().find(|(name, _)| *name == joint.name);
        let steps = [
            transform(Z, 0.0, joint.xyz),
            transform(Z, yaw, NOWHERE),
            transform(Y, pitch, NOWHERE),
            transform(X, roll, NOWHERE),
            transform(axis, angle.map_or(0.0, |(_, angle)| *angle), NOWHERE),
        ];
        let own = steps
            .iter()
            .skip(1)
            .fold(steps[0], |all, step| product(&all, step));
        frame = product(&own, &frame);
        link = joint.parent;
    }
    let [forward, left, up] = [0, 1, 2].map(|i| 1000.0 * frame[i][3]);
    [-left, forward, up]
}
