//! The scalars of a compiled program (T.I.P. 3.1 §5-1).

use crate::fault::Fault;

/// A VAR, or a member of a struct: a number, and whether anything was assigned yet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scalar {
    value: f64,
    is_assigned: bool,
}

impl Scalar {
    /// As every scalar begins.
    pub const UNASSIGNED: Self = Scalar {
        value: 0.0,
        is_assigned: false,
    };

    /// One that has a value.
    #[inline]
    pub const fn of(value: f64) -> Self {
        Scalar {
            value,
            is_assigned: true,
        }
    }

    /// Assigns a value.
    #[inline]
    pub const fn set(&mut self, value: f64) {
        *self = Scalar::of(value);
    }

    /// Reads where the compiler has proved that a value was assigned: nothing is tested. Before the
    /// first assignment it would be 0.
    #[inline]
    pub const fn value(self) -> f64 {
        self.value
    }

    /// Reads where nothing is proved; `index` is the scalar's place in
    /// [`Program::scalar`](crate::program::Program::scalar).
    ///
    /// # Errors
    /// `Unassigned` before the first assignment.
    #[inline]
    pub const fn get(self, index: u32) -> Result<f64, Fault> {
        if self.is_assigned {
            Ok(self.value)
        } else {
            Err(Fault::Unassigned(index))
        }
    }

    /// The value, if there is one.
    #[inline]
    pub const fn assigned(self) -> Option<f64> {
        if self.is_assigned {
            Some(self.value)
        } else {
            None
        }
    }
}

/// Reads every member of a struct where nothing is proved, the first at `index`.
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
