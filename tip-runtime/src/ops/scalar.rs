//! The scalars of a compiled program (T.I.P. 3.1 §5-1).

use super::{Domain, add, for_test};
use crate::fault::Fault;

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
