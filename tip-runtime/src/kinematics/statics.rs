//! Forces at a point of a leg and the joint torques that balance them (Craig, *Introduction to
//! Robotics*, ch. 5.9: `τ = Jᵀ F`). Forces are in N, torques in N·m, Jacobians in mm/rad.

use super::chain::rows_that_count;
use super::{Chain, LegPoint};
use crate::model::Axes;
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

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
