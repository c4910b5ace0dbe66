//! Leaf arithmetic with its faults (T.I.P. 3.1 §5). Transcendentals come from `libm` on every
//! target, so results are bit-identical everywhere.
//!
//! ```
//! use tip_runtime::ops::{Domain, div, int, norm, sin};
//!
//! assert_eq!(div(1.0, 0.0), Err(Domain));
//! assert_eq!(int(-2.5), Ok(-3.0));
//! assert_eq!(norm([2.0, 3.0, 6.0]), Ok(7.0));
//! assert!((sin(30.0)? - 0.5).abs() < 1e-15, "degrees");
//! # Ok::<(), tip_runtime::fault::Fault>(())
//! ```

mod format;
mod scalar;

pub use format::FormattedNumber;
#[doc(hidden)]
pub use format::{Message, Part};
#[doc(hidden)]
pub use scalar::{Scalar, get_each};

use crate::fault::Fault;

/// The only fault of arithmetic: an operand outside the domain of its operation, or a result that
/// is not finite. The type is zero-sized, so that a compiled step returns and tests one bit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Domain;

impl From<Domain> for Fault {
    #[inline]
    fn from(Domain: Domain) -> Self {
        Fault::Domain
    }
}

/// Returns a finite value unchanged.
///
/// # Errors
/// `Domain` for NaN and infinities.
#[inline]
pub const fn finite(value: f64) -> Result<f64, Domain> {
    if value.is_finite() {
        Ok(value)
    } else {
        Err(Domain)
    }
}

macro_rules! operator {
    ($(#[$doc:meta])* $name:ident $op:tt) => {
        $(#[$doc])*
        ///
        /// # Errors
        /// `Domain` if the result is not finite.
        #[inline]
        pub const fn $name(a: f64, b: f64) -> Result<f64, Domain> {
            finite(a $op b)
        }
    };
}

operator!(/** `a + b` */ add +);
operator!(/** `a - b` */ sub -);
operator!(/** `a * b` */ mul *);
operator!(/** `a / b`; division by zero is not finite */ div /);

macro_rules! member_by_member {
    ($(#[$doc:meta])* $name:ident $scalar:ident) => {
        $(#[$doc])*
        ///
        /// # Errors
        /// `Domain` if a member's result is not finite.
        #[inline]
        pub fn $name<const N: usize>(mut a: [f64; N], b: [f64; N]) -> Result<[f64; N], Domain> {
            for (a, b) in a.iter_mut().zip(b) {
                *a = $scalar(*a, b)?;
            }
            Ok(a)
        }
    };
}

member_by_member!(/** `a + b`, member by member */ add_each add);
member_by_member!(/** `a - b`, member by member */ sub_each sub);
member_by_member!(/** `a * b`, member by member */ mul_each mul);
member_by_member!(/** `a / b`, member by member */ div_each div);

/// `INT`: returns the largest whole number not above `a`.
///
/// # Errors
/// None; the shape is that of every function.
#[inline]
pub fn int(a: f64) -> Result<f64, Domain> {
    finite(libm::floor(a))
}

/// `ABS`: returns the absolute value.
///
/// # Errors
/// None; the shape is that of every function.
#[inline]
pub fn abs(a: f64) -> Result<f64, Domain> {
    finite(libm::fabs(a))
}

/// `SQRT`: returns the square root.
///
/// # Errors
/// `Domain` below zero.
#[inline]
pub fn sqrt(a: f64) -> Result<f64, Domain> {
    finite(libm::sqrt(a))
}

const RADIANS_PER_DEGREE: f64 = core::f64::consts::PI / 180.0;
const DEGREES_PER_RADIAN: f64 = 180.0 / core::f64::consts::PI;

/// `DEG2RAD`: converts degrees to radians.
///
/// # Errors
/// None; the shape is that of every function.
#[inline]
pub fn deg2rad(a: f64) -> Result<f64, Domain> {
    finite(a * RADIANS_PER_DEGREE)
}

/// `RAD2DEG`: converts radians to degrees.
///
/// # Errors
/// `Domain` if the result is not finite.
#[inline]
pub fn rad2deg(a: f64) -> Result<f64, Domain> {
    finite(a * DEGREES_PER_RADIAN)
}

/// `SIN`: returns the sine of an angle in degrees.
///
/// # Errors
/// None; the shape is that of every function.
#[inline]
pub fn sin(a: f64) -> Result<f64, Domain> {
    finite(libm::sin(a * RADIANS_PER_DEGREE))
}

/// `COS`: returns the cosine of an angle in degrees.
///
/// # Errors
/// None; the shape is that of every function.
#[inline]
pub fn cos(a: f64) -> Result<f64, Domain> {
    finite(libm::cos(a * RADIANS_PER_DEGREE))
}

/// `TAN`: returns the tangent of an angle in degrees.
///
/// # Errors
/// `Domain` if the result is not finite.
#[inline]
pub fn tan(a: f64) -> Result<f64, Domain> {
    finite(libm::tan(a * RADIANS_PER_DEGREE))
}

/// `ASIN`: returns the arc sine in degrees.
///
/// # Errors
/// `Domain` outside −1…1.
#[inline]
pub fn asin(a: f64) -> Result<f64, Domain> {
    finite(libm::asin(a) * DEGREES_PER_RADIAN)
}

/// `ACOS`: returns the arc cosine in degrees.
///
/// # Errors
/// `Domain` outside −1…1.
#[inline]
pub fn acos(a: f64) -> Result<f64, Domain> {
    finite(libm::acos(a) * DEGREES_PER_RADIAN)
}

/// `ATAN`: returns the arc tangent in degrees; the language gives it the domain of `ASIN` (T.I.P.
/// 3.1 §5-2-2).
///
/// # Errors
/// `Domain` outside −1…1.
#[inline]
pub fn atan(a: f64) -> Result<f64, Domain> {
    if libm::fabs(a) <= 1.0 {
        finite(libm::atan(a) * DEGREES_PER_RADIAN)
    } else {
        Err(Domain)
    }
}

/// `ATAN2 a b`: returns the angle in degrees, −180…180.
///
/// # Errors
/// `Domain` if both are zero.
#[inline]
pub fn atan2(a: f64, b: f64) -> Result<f64, Domain> {
    if a == 0.0 && b == 0.0 {
        return Err(Domain);
    }
    finite(libm::atan2(a, b) * DEGREES_PER_RADIAN)
}

/// `NORM`: returns the root of the sum of squares, also where the squares alone exceed the largest
/// number.
///
/// # Errors
/// `Domain` if the result is not finite.
#[inline]
pub fn norm<const N: usize>(a: [f64; N]) -> Result<f64, Domain> {
    let root = root_of_squares(a);
    if root.is_finite() {
        return Ok(root);
    }
    // Powers of two round nothing.
    finite(root_of_squares(a.map(|a| a * SMALLER)) / SMALLER)
}

/// 2^−600, a scale at which the square of the largest number is finite.
const SMALLER: f64 = f64::from_bits((1023 - 600) << 52);

fn root_of_squares<const N: usize>(a: [f64; N]) -> f64 {
    let mut sum = 0.0;
    for a in a {
        sum += a * a;
    }
    libm::sqrt(sum)
}

/// `UNIT_VECT`: returns the unit vector.
///
/// # Errors
/// `Domain` for a vector without length.
#[inline]
pub fn unit_vect(a: [f64; 3]) -> Result<[f64; 3], Domain> {
    let length = norm(a)?;
    div_each(a, [length; 3])
}

/// `ROT_X`: rotates `p` about the robot's x axis by an angle in degrees, right-handed.
///
/// # Errors
/// `Domain` if the result is not finite.
#[inline]
pub fn rot_x([x, y, z]: [f64; 3], angle: f64) -> Result<[f64; 3], Domain> {
    let (y, z) = turn(y, z, angle)?;
    Ok([x, y, z])
}

/// `ROT_Y`: rotates `p` about the robot's y axis by an angle in degrees, right-handed.
///
/// # Errors
/// `Domain` if the result is not finite.
#[inline]
pub fn rot_y([x, y, z]: [f64; 3], angle: f64) -> Result<[f64; 3], Domain> {
    let (z, x) = turn(z, x, angle)?;
    Ok([x, y, z])
}

/// `ROT_Z`: rotates `p` about the robot's z axis by an angle in degrees, right-handed.
///
/// # Errors
/// `Domain` if the result is not finite.
#[inline]
pub fn rot_z([x, y, z]: [f64; 3], angle: f64) -> Result<[f64; 3], Domain> {
    let (x, y) = turn(x, y, angle)?;
    Ok([x, y, z])
}

fn turn(a: f64, b: f64, angle: f64) -> Result<(f64, f64), Domain> {
    let (sin, cos) = (sin(angle)?, cos(angle)?);
    Ok((finite(a * cos - b * sin)?, finite(a * sin + b * cos)?))
}

/// Returns true if a FOR or NEXT loop continues (T.I.P. 3.1 §7-6-4).
///
/// # Errors
/// `Domain` for a step of zero.
#[inline]
pub fn for_test(value: f64, end: f64, step: f64) -> Result<bool, Domain> {
    if step > 0.0 {
        Ok(value <= end)
    } else if step < 0.0 {
        Ok(value >= end)
    } else {
        Err(Domain)
    }
}

#[cfg(test)]
mod tests {
    use super::{Domain, norm};

    // clauses: 4.6
    #[test]
    fn a_norm_is_finite_where_its_root_is() {
        let far = 2.0_f64.powi(600);
        assert_eq!(norm([3.0 * far, -4.0 * far, 0.0]), Ok(5.0 * far));
        assert_eq!(norm([2.0 * far, -3.0 * far, 6.0 * far]), Ok(7.0 * far));
        assert_eq!(norm([f64::MAX, 1.0, 0.0]), Ok(f64::MAX));
        assert_eq!(norm([f64::MAX, f64::MAX, 0.0]), Err(Domain));
        assert_eq!(norm([f64::NAN, 1.0]), Err(Domain));
        assert_eq!(
            norm([1e150, 1e150]),
            Ok(libm::sqrt(1e150 * 1e150 + 1e150 * 1e150))
        );
    }
}
