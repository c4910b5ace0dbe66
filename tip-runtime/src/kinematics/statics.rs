//! Forces at a point of a leg and the joint torques that balance them (Craig, *Introduction to
//! Robotics*, ch. 5.9: `τ = Jᵀ F`). Forces are in N, torques in N·m, Jacobians in mm/rad.

use super::{Chain, Point};
use nalgebra::{Matrix2, Matrix3, SMatrix, SVector, Vector2, Vector3};

const MILLIMETRES_PER_METRE: f64 = 1000.0;

/// A Jacobian whose Gram determinant is smaller than this, against that of a sphere of the same
/// trace, has lost a direction.
const SINGULAR: f64 = 1e-8;

impl<const J: usize> Chain<J> {
    /// The joint torques with which `point` pushes by `force`: `Jᵀ F`. `None` if there is no such
    /// point.
    #[must_use]
    pub fn torques_of_force(&self, point: Point, force: [f64; 3]) -> Option<[f64; J]> {
        let torques = self.point_jacobian(point)?.transpose() * Vector3::from(force);
        Some((torques / MILLIMETRES_PER_METRE).into())
    }

    /// The force with which `point` pushes at these joint torques: `(Jᵀ)# τ`. In the `plane` of x
    /// and y z is 0. `None` where the posture is singular.
    #[must_use]
    pub fn force_of_torques(
        &self,
        point: Point,
        torques: &[f64; J],
        plane: bool,
    ) -> Option<[f64; 3]> {
        let jacobian = self.point_jacobian(point)?;
        let torques = SVector::<f64, J>::from(*torques) * MILLIMETRES_PER_METRE;
        let moved_by = match point {
            Point::Tip => J,
            Point::Joint(m) => m,
        };
        if plane {
            in_plane(&jacobian, &torques)
        } else if moved_by == 2 {
            of_two_joints(&jacobian, &torques)
        } else {
            in_space(&jacobian, &torques)
        }
    }
}

/// `(J Jᵀ)⁻¹ J τ` of the rows x and y.
fn in_plane<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    torques: &SVector<f64, J>,
) -> Option<[f64; 3]> {
    let gram: Matrix3<f64> = jacobian * jacobian.transpose();
    let gram = Matrix2::new(gram.m11, gram.m12, gram.m21, gram.m22);
    let right = (jacobian * torques).xy();
    let force = invert_2(&gram)? * right;
    Some([force.x, force.y, 0.0])
}

/// `(J Jᵀ)⁻¹ J τ`.
fn in_space<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    torques: &SVector<f64, J>,
) -> Option<[f64; 3]> {
    let gram: Matrix3<f64> = jacobian * jacobian.transpose();
    let size = gram.trace() / 3.0;
    if gram.determinant() <= SINGULAR * size * size * size {
        return None;
    }
    Some((gram.try_inverse()? * (jacobian * torques)).into())
}

/// `J (Jᵀ J)⁻¹ τ` of the first two columns: the least force that two joints in space feel so.
fn of_two_joints<const J: usize>(
    jacobian: &SMatrix<f64, 3, J>,
    torques: &SVector<f64, J>,
) -> Option<[f64; 3]> {
    let mut columns = jacobian.column_iter();
    let (first, second) = (columns.next()?, columns.next()?);
    let mut torques = torques.iter();
    let right = Vector2::new(*torques.next()?, *torques.next()?);
    let across = first.dot(&second);
    let gram = Matrix2::new(first.norm_squared(), across, across, second.norm_squared());
    let shares = invert_2(&gram)? * right;
    Some((first * shares.x + second * shares.y).into())
}

fn invert_2(gram: &Matrix2<f64>) -> Option<Matrix2<f64>> {
    let size = gram.trace() / 2.0;
    if gram.determinant() <= SINGULAR * size * size {
        return None;
    }
    gram.try_inverse()
}
