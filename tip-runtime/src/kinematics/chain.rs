//! Forward kinematics: positions, axes and frames of a leg's joints, and the Jacobians of its points; forces at a point
//! and the joint torques that balance them (Craig, *Introduction to Robotics*, ch. 5.9: `τ = Jᵀ F`). Forces are in N,
//! torques in N·m.

use super::LegPoint;
use crate::model::{Axes, Joint, Leg, Point};
use crate::ops::RADIANS_PER_DEGREE;
use nalgebra::{Matrix2, Matrix3, Rotation3, SMatrix, SVector, Unit, Vector2, Vector3};

/// The minimum damping, as a share of the trace of `J Jᵀ`.
const LEAST_DAMPING: f64 = 1e-12;

/// The share of a velocity that may be missed for numerical reasons.
const MISSED: f64 = 1e-6;

/// A leg in one posture: the position and axis of each joint, and the foot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Chain<const J: usize> {
    places: [Vector3<f64>; J],
    axes: [Vector3<f64>; J],
    foot: Vector3<f64>,
}

/// A chain under construction, joint by joint: the position of its end and the rotation of its last
/// link.
pub(super) struct ChainBuilder {
    end: Vector3<f64>,
    turned: Rotation3<f64>,
}

impl ChainBuilder {
    /// Returns a chain without joints at `base` (mm).
    pub(super) fn at(base: Point) -> Self {
        ChainBuilder {
            end: Vector3::from(base),
            turned: Rotation3::identity(),
        }
    }

    /// Appends a joint at `angle` (deg) and its link; returns the position (mm) and axis of the
    /// joint.
    pub(super) fn append(&mut self, joint: &Joint, angle: f64) -> (Vector3<f64>, Vector3<f64>) {
        let local = Unit::new_unchecked(Vector3::from(joint.axis));
        let at = (self.end, self.turned * local.into_inner());
        self.turned *= Rotation3::from_axis_angle(&local, angle * RADIANS_PER_DEGREE);
        self.end += self.turned * Vector3::from(joint.link);
        at
    }

    /// Returns the position of the end, mm.
    pub(super) fn end(&self) -> Vector3<f64> {
        self.end
    }

    /// Returns the x, y and z axes of the last link.
    pub(super) fn axes(&self) -> [[f64; 3]; 3] {
        (*self.turned.matrix()).into()
    }
}

impl<const J: usize> Chain<J> {
    /// Calculates the forward kinematics of `leg` at `angles` (deg).
    #[must_use]
    #[inline]
    pub fn new(leg: &Leg<J>, angles: &[f64; J]) -> Self {
        let mut chain = Chain {
            places: [Vector3::zeros(); J],
            axes: [Vector3::zeros(); J],
            foot: Vector3::from(leg.base),
        };
        let mut builder = ChainBuilder::at(leg.base);
        let slots = chain.places.iter_mut().zip(chain.axes.iter_mut());
        for ((place, axis), (joint, angle)) in slots.zip(leg.joints.iter().zip(angles)) {
            (*place, *axis) = builder.append(joint, *angle);
        }
        chain.foot = builder.end;
        chain
    }

    /// Returns the position of the foot, mm.
    #[must_use]
    pub fn foot(&self) -> Point {
        self.foot.into()
    }

    /// Returns the position of joint `m`, counted from 0, mm.
    #[must_use]
    pub fn joint(&self, m: usize) -> Option<Point> {
        self.places.get(m).map(|place| (*place).into())
    }

    /// Iterates over the positions of the joints from base to foot, mm.
    pub fn joints(&self) -> impl Iterator<Item = Point> + '_ {
        self.places.iter().map(|place| (*place).into())
    }

    /// Returns the velocity of the foot for each joint's angular velocity, joint by joint, mm/rad.
    #[must_use]
    pub fn foot_jacobian(&self) -> [[f64; 3]; J] {
        self.jacobian(self.foot, J).into()
    }

    /// Returns the position of a point, mm.
    #[must_use]
    pub fn point(&self, point: LegPoint) -> Option<Point> {
        match point {
            LegPoint::Tip => Some(self.foot()),
            LegPoint::Joint(m) => self.joint(m),
        }
    }

    /// Returns the velocity of a point for each joint's angular velocity, joint by joint, mm/rad.
    /// Only the joints before it move the place of a joint; the entries of the others are zero.
    #[must_use]
    pub fn point_jacobian(&self, point: LegPoint) -> Option<[[f64; 3]; J]> {
        Some(self.jacobian_of(point)?.into())
    }

    /// Returns the Jacobian of a point as a matrix, mm/rad.
    pub(super) fn jacobian_of(&self, point: LegPoint) -> Option<SMatrix<f64, 3, J>> {
        match point {
            LegPoint::Tip => Some(self.jacobian(self.foot, J)),
            LegPoint::Joint(m) => self.places.get(m).map(|place| self.jacobian(*place, m)),
        }
    }

    fn jacobian(&self, point: Vector3<f64>, moved_by: usize) -> SMatrix<f64, 3, J> {
        let mut jacobian = SMatrix::<f64, 3, J>::zeros();
        let joints = self.axes.iter().zip(&self.places).take(moved_by);
        for (mut column, (axis, place)) in jacobian.column_iter_mut().zip(joints) {
            // Member by member: `copy_from` carries a check of shapes that could panic.
            let moved = axis.cross(&(point - place));
            for (entry, moved) in column.iter_mut().zip(&moved) {
                *entry = *moved;
            }
        }
        jacobian
    }

    /// Returns a point's velocity (mm/s) at joint rates (deg/s).
    #[must_use]
    pub fn point_velocity(&self, point: LegPoint, rates: &[f64; J]) -> Option<[f64; 3]> {
        let rates = SVector::<f64, J>::from(*rates) * RADIANS_PER_DEGREE;
        Some((self.jacobian_of(point)? * rates).into())
    }

    /// Returns the least joint rates (deg/s) that give a point a velocity (mm/s) along the axes
    /// that count; `None` where it cannot move that way.
    #[must_use]
    pub fn point_rates(&self, point: LegPoint, velocity: [f64; 3], axes: Axes) -> Option<[f64; J]> {
        let jacobian = rows_that_count(self.jacobian_of(point)?, axes);
        let velocity =
            Vector3::from(velocity).zip_map(
                &Vector3::from(axes),
                |along, counts| {
                    if counts { along } else { 0.0 }
                },
            );
        let rates = least_norm(&jacobian, &velocity, 0.0)?;
        let missed = (jacobian * rates - velocity).norm();
        let rates: [f64; J] = (rates / RADIANS_PER_DEGREE).into();
        let exact = missed <= MISSED * velocity.norm();
        (exact && rates.iter().all(|rate| rate.is_finite())).then_some(rates)
    }
}

/// Zeroes the rows of a Jacobian for the axes that do not count.
pub(super) fn rows_that_count<const J: usize>(
    mut jacobian: SMatrix<f64, 3, J>,
    axes: Axes,
) -> SMatrix<f64, 3, J> {
    for mut column in jacobian.column_iter_mut() {
        for (entry, counts) in column.iter_mut().zip(axes) {
            if !counts {
                *entry = 0.0;
            }
        }
    }
    jacobian
}

/// Returns `Jᵀ (J Jᵀ + λ)⁻¹ v`: the least joint motion that gives the motion `v`, or comes near it
/// where the joints cannot. λ is `damping` (mm²) plus a term that keeps the matrix regular where a
/// chain has too few joints or has lost a direction.
pub(super) fn least_norm<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    motion: &Vector3<f64>,
    damping: f64,
) -> Option<SVector<f64, J>> {
    let gram: Matrix3<f64> = jacobian * jacobian.transpose();
    let regular = damping + LEAST_DAMPING * gram.trace();
    let gram = gram + Matrix3::identity() * regular;
    Some(jacobian.transpose() * gram.cholesky()?.solve(motion))
}

/// The frame of a link: its origin is the joint that carries the link, and it turns with that
/// joint. While all joints are at 0 it is parallel to the robot frame.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Origin in the robot frame, mm.
    pub at: Point,
    /// The x, y and z axes in the robot frame, unit vectors.
    pub axes: [[f64; 3]; 3],
}

impl Frame {
    /// Transforms a point of this frame (mm) into the robot frame, mm.
    #[must_use]
    pub fn point(&self, inner: Point) -> Point {
        let [x, y, z] = self.at;
        let [along_x, along_y, along_z] = self.direction(inner);
        [x + along_x, y + along_y, z + along_z]
    }

    /// Transforms a direction of this frame into the robot frame.
    #[must_use]
    pub fn direction(&self, [a, b, c]: [f64; 3]) -> [f64; 3] {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = self.axes;
        [
            xx * a + yx * b + zx * c,
            xy * a + yy * b + zy * c,
            xz * a + yz * b + zz * c,
        ]
    }
}

/// Iterates over the frames of a leg's links, from base to foot; the first joint is at `base` (mm),
/// the angles are in deg. In the last frame, the `link` of the last joint leads to the foot.
///
/// ```
/// use tip_runtime::kinematics::frames;
/// use tip_runtime::model::titan8;
///
/// let leg = &titan8::MODEL.legs[1];
/// let [_, _, shank] = &leg.joints;
/// let last = frames(leg.base, &leg.joints, &[0.0, 0.0, 90.0]).last().expect("it has joints");
/// assert!((last.at[0] - 391.0).abs() < 1e-9, "the knee is out on the right");
/// assert!((last.point(shank.link)[2] + 200.0).abs() < 1e-9, "the shank hangs down from it");
/// ```
pub fn frames<'a>(
    base: Point,
    joints: &'a [Joint],
    angles: &'a [f64],
) -> impl Iterator<Item = Frame> + 'a {
    let mut chain = ChainBuilder::at(base);
    joints.iter().zip(angles).map(move |(joint, angle)| {
        let (place, _) = chain.append(joint, *angle);
        Frame {
            at: place.into(),
            axes: chain.axes(),
        }
    })
}

const MILLIMETRES_PER_METRE: f64 = 1000.0;

/// The ratio of Gram determinants, against that of a sphere of the same trace, below which a
/// Jacobian has lost a direction.
const SINGULAR: f64 = 1e-8;

impl<const J: usize> Chain<J> {
    /// Returns the joint torques with which `point` pushes by `force`: `Jᵀ F`. `None` if there is
    /// no such point.
    #[must_use]
    pub fn torques_of_force(&self, point: LegPoint, force: [f64; 3]) -> Option<[f64; J]> {
        let torques = self.jacobian_of(point)?.transpose() * Vector3::from(force);
        Some((torques / MILLIMETRES_PER_METRE).into())
    }

    /// Returns the force with which `point` pushes at these joint torques, along the axes that
    /// count: `(Jᵀ)# τ`. `None` where the posture is singular.
    #[must_use]
    pub fn force_of_torques(
        &self,
        point: LegPoint,
        torques: &[f64; J],
        axes: Axes,
    ) -> Option<[f64; 3]> {
        let jacobian = rows_that_count(self.jacobian_of(point)?, axes);
        let torques = SVector::<f64, J>::from(*torques) * MILLIMETRES_PER_METRE;
        let moved_by = point.moved_by(J);
        if moved_by < axes.iter().filter(|counts| **counts).count() {
            of_few_joints(&jacobian, &torques, moved_by)
        } else {
            of_enough_joints(&jacobian, &torques, axes)
        }
    }
}

/// Returns `(J Jᵀ)⁻¹ J τ` of the axes that count.
fn of_enough_joints<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    torques: &SVector<f64, J>,
    axes: Axes,
) -> Option<[f64; 3]> {
    if is_singular(jacobian, axes, SINGULAR) {
        return None;
    }
    let gram = filled_gram(jacobian, axes).0;
    Some((gram.try_inverse()? * (jacobian * torques)).into())
}

/// Returns true if the Gram determinant of the axes that count is smaller than `share` of that of a
/// sphere of the same trace.
pub(super) fn is_singular<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    axes: Axes,
    share: f64,
) -> bool {
    let (gram, size) = filled_gram(jacobian, axes);
    gram.determinant() <= share * size * size * size
}

/// Returns `J Jᵀ`, with the mean of the axes that count in place of the others, and that mean.
fn filled_gram<const J: usize>(jacobian: &SMatrix<f64, 3, J>, axes: Axes) -> (Matrix3<f64>, f64) {
    let mut gram: Matrix3<f64> = jacobian * jacobian.transpose();
    let counting = axes.iter().filter(|counts| **counts).count();
    let size = gram.trace() / counting as f64;
    for (axis, counts) in axes.iter().enumerate() {
        if let (false, Some(entry)) = (counts, gram.get_mut((axis, axis))) {
            *entry = size;
        }
    }
    (gram, size)
}

/// Returns `J (Jᵀ J)⁻¹ τ` for one or two joints that move the point: the least force that balances
/// them.
fn of_few_joints<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    torques: &SVector<f64, J>,
    moved_by: usize,
) -> Option<[f64; 3]> {
    let mut columns = jacobian.column_iter().zip(torques.iter());
    let (first, of_first) = columns.next()?;
    let Some((second, of_second)) = columns.next().filter(|_| moved_by == 2) else {
        let square = first.norm_squared();
        return (square > 0.0).then(|| (first * (of_first / square)).into());
    };
    let across = first.dot(&second);
    let gram = Matrix2::new(first.norm_squared(), across, across, second.norm_squared());
    let size = gram.trace() / 2.0;
    if gram.determinant() <= SINGULAR * size * size {
        return None;
    }
    let shares = gram.try_inverse()? * Vector2::new(*of_first, *of_second);
    Some((first * shares.x + second * shares.y).into())
}
