//! The variables that a program and native code of SPECIAL share.

use crate::command::MAX;
use crate::fault::Fault;
use crate::program::{Program, SpecialVariable};

/// Number of variables of each type.
const COUNT: usize = 10;
/// Number of members of a POS.
const AXES: usize = 3;
/// The first scalar of POS variables.
const POSITIONS: usize = COUNT;
/// The first scalar of JOINT variables.
const JOINTS: usize = POSITIONS + COUNT * AXES;
/// Number of all scalars.
const SCALARS: usize = JOINTS + COUNT * MAX;

/// The values of all special variables. Those that the program names are copied from it before native code may read
/// them, and back after native code has written one.
#[derive(Clone, Copy, Debug)]
pub(super) struct SpecialVariables {
    values: [f64; SCALARS],
    /// True if the program has run a SPECIAL.
    are_shared: bool,
    /// True if native code has written one since the last copy.
    are_new: bool,
}

impl SpecialVariables {
    pub(super) const ZERO: Self = SpecialVariables {
        values: [0.0; SCALARS],
        are_shared: false,
        are_new: false,
    };

    /// Allows native code to write them from now on.
    pub(super) fn share(&mut self) {
        self.are_shared = true;
    }

    /// Returns the value of a variable of a robot with `joints` joints on a leg; 0 for none.
    pub(super) fn get(&self, variable: SpecialVariable, joints: usize) -> f64 {
        let index = index(variable, joints);
        index
            .and_then(|index| self.values.get(index))
            .copied()
            .unwrap_or(0.0)
    }

    /// Assigns a variable.
    ///
    /// # Errors
    /// `Domain` for a value that is not finite or no variable, `InvalidMode` before the first SPECIAL.
    pub(super) fn set(
        &mut self,
        variable: SpecialVariable,
        joints: usize,
        value: f64,
    ) -> Result<(), Fault> {
        if !self.are_shared {
            return Err(Fault::InvalidMode);
        }
        let value = crate::ops::finite(value)?;
        let index = index(variable, joints);
        let place = index.and_then(|index| self.values.get_mut(index));
        *place.ok_or(Fault::Domain)? = value;
        self.are_new = true;
        Ok(())
    }

    /// Copies the values of the program.
    pub(super) fn read(&mut self, program: &dyn Program, count: usize) {
        for scalar in 1..=count {
            if let Some((name, Some(value))) = program.scalar(scalar)
                && let Some(place) = index_of(name).and_then(|index| self.values.get_mut(index))
            {
                *place = value;
            }
        }
    }

    /// Copies the values that native code wrote to the program.
    pub(super) fn write(&mut self, program: &mut dyn Program, count: usize) {
        if !core::mem::take(&mut self.are_new) {
            return;
        }
        for scalar in 1..=count {
            let index = program.scalar(scalar).and_then(|(name, _)| index_of(name));
            if let Some(value) = index.and_then(|index| self.values.get(index)) {
                program.set_scalar(scalar, *value);
            }
        }
    }
}

/// Returns the index of the scalar of a variable or of a member.
fn index(variable: SpecialVariable, joints: usize) -> Option<usize> {
    let (first, size, members, n, member) = match variable {
        SpecialVariable::Var(n) => (0, 1, 1, n, 0),
        SpecialVariable::Position(n, member) => (POSITIONS, AXES, AXES, n, member),
        SpecialVariable::Joint(n, member) => (JOINTS, MAX, joints, n, member),
    };
    let (n, member) = (usize::from(n), usize::from(member));
    (n < COUNT && member < members).then_some(first + size * n + member)
}

/// Returns the index of the scalar of this name.
fn index_of(name: &str) -> Option<usize> {
    // The byte slice is split, since the compiler keeps a panic path in searches of strings.
    let (kind, rest) = name.as_bytes().split_at_checked(3)?;
    let rest = rest.strip_prefix(b"_SPECIAL_")?;
    let digit = |byte: &u8| byte.is_ascii_digit().then(|| byte.wrapping_sub(b'0'));
    let (n, member) = match rest {
        [n] => (digit(n)?, None),
        [n, b'.', member @ ..] => (digit(n)?, Some(member)),
        _ => return None,
    };
    let variable = match (kind, member) {
        (b"VAR", None) => SpecialVariable::Var(n),
        (b"POS", Some([axis @ b'X'..=b'Z'])) => SpecialVariable::Position(n, axis - b'X'),
        (b"JNT", Some([b'J', member])) => SpecialVariable::Joint(n, digit(member)?.checked_sub(1)?),
        _ => return None,
    };
    index(variable, MAX)
}

#[cfg(test)]
mod tests {
    use super::*;

    // clauses: 13.3
    #[test]
    fn each_name_has_a_place_of_its_own() {
        assert_eq!(index_of("VAR_SPECIAL_9"), Some(9));
        assert_eq!(index_of("POS_SPECIAL_0.X"), Some(10));
        assert_eq!(index_of("POS_SPECIAL_9.Z"), Some(39));
        assert_eq!(index_of("JNT_SPECIAL_0.J1"), Some(40));
        assert_eq!(index_of("JNT_SPECIAL_9.J9"), Some(129));
        for name in [
            "A",
            "VAR_SPECIAL_",
            "VAR_SPECIAL_10",
            "POS_SPECIAL_1",
            "JNT_SPECIAL_1.J0",
        ] {
            assert_eq!(index_of(name), None, "{name}");
        }
    }

    // clauses: 13.3
    #[test]
    fn native_code_writes_finite_numbers_from_the_first_special_on() {
        let mut variables = SpecialVariables::ZERO;
        let place = SpecialVariable::Joint(1, 2);
        assert_eq!(variables.set(place, 3, 1.0), Err(Fault::InvalidMode));
        variables.share();
        assert_eq!(variables.set(place, 3, 1.0), Ok(()));
        assert_eq!(variables.set(place, 3, f64::NAN), Err(Fault::Domain));
        assert_eq!(variables.set(place, 2, 5.0), Err(Fault::Domain));
        assert_eq!(
            variables.set(SpecialVariable::Var(10), 3, 5.0),
            Err(Fault::Domain)
        );
        assert_eq!(variables.get(place, 3), 1.0);
        assert_eq!(variables.get(SpecialVariable::Joint(1, 3), 3), 0.0);
    }
}
