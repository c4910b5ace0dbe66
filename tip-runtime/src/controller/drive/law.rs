//! The laws of torque, force and compliance.
//!
//! A joint's spring: `τ = k (θ_d − θ)`. A point's spring: `F = K (x_d − x)`, axis by axis. Either is
//! bounded by the compliance limit, if one is set. A force acts through the joints as `τ = Jᵀ F`, and
//! no joint is commanded more than `TORQUE_MAX`, or than its motor gives. This is stiffness control
//! without an inner force loop (Salisbury, *Active Stiffness Control of a Manipulator in Cartesian
//! Coordinates*, 1980), without damping of its own: that of the joints brings the robot to rest. Units:
//! deg, mm, N, and torques in the robot's torque unit.

/// Returns the pull of a spring, bounded by `limit` where there is one.
pub(super) fn spring<const N: usize>(
    stiffness: [f64; N],
    target: [f64; N],
    at: [f64; N],
    limit: Option<[f64; N]>,
) -> [f64; N] {
    let mut pull = stiffness;
    for (pull, (target, at)) in pull.iter_mut().zip(target.iter().zip(at)) {
        *pull *= target - at;
    }
    for (pull, limit) in pull.iter_mut().zip(limit.into_iter().flatten()) {
        *pull = bounded(*pull, limit);
    }
    pull
}

/// Returns `value` within ±`most`.
pub(in crate::controller) fn bounded(value: f64, most: f64) -> f64 {
    value.min(most).max(-most)
}
