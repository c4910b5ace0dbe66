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

pub use format::FormattedNumber;
#[doc(hidden)]
pub use format::{Message, Part};

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

pub(crate) const RADIANS_PER_DEGREE: f64 = core::f64::consts::PI / 180.0;
pub(crate) const DEGREES_PER_RADIAN: f64 = 180.0 / core::f64::consts::PI;

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

/// A VAR, or a member of a struct: a number that may be unassigned.
///
/// Every value of the language is finite, so a NaN marks a scalar that was never assigned: a scalar
/// is as large as its number, and assigning one is a single store.
#[derive(Clone, Copy, Debug)]
pub struct Scalar(f64);

impl Scalar {
    /// The initial value of every scalar: a quiet NaN that no calculation makes.
    pub const UNASSIGNED: Self = Scalar(f64::from_bits(0x7ff8_0000_0054_4950));

    /// Returns a scalar with a value.
    #[inline]
    pub const fn of(value: f64) -> Self {
        Scalar(value)
    }

    /// Assigns a value.
    #[inline]
    pub const fn set(&mut self, value: f64) {
        self.0 = value;
    }

    /// Assigns the result of a calculation.
    ///
    /// # Errors
    /// The fault of the calculation; the scalar stays unchanged.
    #[inline]
    pub fn assign(&mut self, value: Result<f64, Domain>) -> Result<(), Domain> {
        self.set(value?);
        Ok(())
    }

    /// `FOR`: assigns the first value; returns true if the loop is entered.
    ///
    /// # Errors
    /// As [`for_test`]; the scalar stays unchanged.
    #[inline]
    pub fn begin(&mut self, from: f64, to: f64, by: f64) -> Result<bool, Domain> {
        let enters = for_test(from, to, by)?;
        self.set(from);
        Ok(enters)
    }

    /// `NEXT`: assigns the value that follows `value`; returns true if the loop continues.
    ///
    /// # Errors
    /// As [`add`] and [`for_test`]; the scalar stays unchanged.
    #[inline]
    pub fn advance(&mut self, value: f64, by: f64, to: f64) -> Result<bool, Domain> {
        let value = add(value, by)?;
        let repeats = for_test(value, to, by)?;
        self.set(value);
        Ok(repeats)
    }

    /// Returns the value where the compiler has proved an assignment: nothing is tested. Before the
    /// first assignment the result is NaN.
    #[inline]
    pub const fn value(self) -> f64 {
        self.0
    }

    /// Returns the value where nothing is proved; `index` is the scalar's place in
    /// [`Program::scalar`](crate::program::Program::scalar).
    ///
    /// # Errors
    /// `Unassigned` before the first assignment.
    #[inline]
    pub const fn get(self, index: u32) -> Result<f64, Fault> {
        match self.assigned() {
            Some(value) => Ok(value),
            None => Err(Fault::Unassigned(index)),
        }
    }

    /// Returns the value, if one was assigned.
    #[inline]
    pub const fn assigned(self) -> Option<f64> {
        if self.0.to_bits() == Self::UNASSIGNED.0.to_bits() {
            None
        } else {
            Some(self.0)
        }
    }
}

/// Returns every member of a struct where nothing is proved, the first at `index`.
///
/// # Errors
/// `Unassigned` for the first member without a value.
#[inline]
pub fn get_each<const N: usize>(members: &[Scalar; N], index: u32) -> Result<[f64; N], Fault> {
    let mut values = [0.0; N];
    for ((value, member), index) in values.iter_mut().zip(members).zip(index..) {
        *value = member.get(index)?;
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

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

    #[test]
    fn only_what_was_assigned_has_a_value() {
        let mut scalar = Scalar::UNASSIGNED;
        assert_eq!(scalar.assigned(), None);
        assert_eq!(scalar.get(7), Err(Fault::Unassigned(7)));
        for value in [0.0, -0.0, f64::MAX, f64::MIN_POSITIVE, -1.5] {
            scalar.set(value);
            assert_eq!(scalar.get(7).map(f64::to_bits), Ok(value.to_bits()));
            assert_eq!(Scalar::of(value).value().to_bits(), value.to_bits());
        }
    }

    /// T.I.P. 3.1 §7-6-4: the loop test of FOR and NEXT uses the assigned value.
    #[test]
    fn a_loop_assigns_what_it_tests() {
        let mut scalar = Scalar::UNASSIGNED;
        assert_eq!(scalar.begin(3.0, 2.0, 1.0), Ok(false));
        assert_eq!(scalar.value(), 3.0);
        assert_eq!(scalar.begin(1.0, 2.0, 1.0), Ok(true));
        assert_eq!(scalar.advance(1.0, 1.0, 2.0), Ok(true));
        assert_eq!(scalar.value(), 2.0);
        assert_eq!(scalar.advance(2.0, 1.0, 2.0), Ok(false));
        assert_eq!(scalar.value(), 3.0);
    }

    #[test]
    fn a_fault_leaves_the_value_as_it_was() {
        let mut scalar = Scalar::of(5.0);
        assert_eq!(scalar.assign(Err(Domain)), Err(Domain));
        assert_eq!(scalar.begin(1.0, 2.0, 0.0), Err(Domain));
        assert_eq!(scalar.advance(1.0, 0.0, 2.0), Err(Domain));
        assert_eq!(scalar.advance(f64::MAX, f64::MAX, 2.0), Err(Domain));
        assert_eq!(scalar.value(), 5.0);
        assert_eq!(scalar.assign(add(5.0, 1.0)), Ok(()));
        assert_eq!(scalar.value(), 6.0);
    }

    /// A custom robot may measure any NaN by mistake; it counts as a value.
    #[test]
    fn no_other_nan_counts_as_unassigned() {
        assert!(Scalar::of(f64::NAN).assigned().is_some());
        assert!(Scalar::of(-f64::NAN).assigned().is_some());
    }
}
