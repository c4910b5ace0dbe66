//! Finding what a target names; legs and joints count from 1 in the language.

use crate::command::Target;
use crate::fault::Fault;

/// Returns the place of leg or joint `n`, counted from 0.
pub(super) fn index(n: u8) -> usize {
    usize::from(n).wrapping_sub(1)
}

/// Returns the entry of leg or joint `n`.
pub(super) fn leg<T>(legs: &[T], n: u8) -> Result<&T, Fault> {
    legs.get(index(n)).ok_or(Fault::Domain)
}

/// Returns the entry of leg or joint `n`.
pub(super) fn leg_mut<T>(legs: &mut [T], n: u8) -> Result<&mut T, Fault> {
    legs.get_mut(index(n)).ok_or(Fault::Domain)
}

/// Returns the entries of the one leg, or of all legs, that a target names.
pub(super) fn feet<T>(legs: &mut [T], target: Target) -> Result<&mut [T], Fault> {
    match target {
        Target::All => Ok(legs),
        Target::Foot(n) => {
            let at = index(n);
            legs.get_mut(at..at.wrapping_add(1)).ok_or(Fault::Domain)
        }
        Target::None | Target::Floor | Target::Joint(..) => Err(Fault::Domain),
    }
}

/// Returns the number, from 1, of the leg or joint at `index`.
pub(super) fn number(index: usize) -> u8 {
    u8::try_from(index).map_or(u8::MAX, |index| index.saturating_add(1))
}

/// Refuses what is locked.
pub(super) fn unlocked(is_locked: bool) -> Result<(), Fault> {
    if is_locked {
        Err(Fault::InvalidMode)
    } else {
        Ok(())
    }
}

/// Returns the joint (from 0) that a target names, if it names one alone.
pub(super) fn joint_of(target: Target) -> Option<usize> {
    match target {
        Target::Joint(_, m) => Some(index(m)),
        Target::None | Target::All | Target::Floor | Target::Foot(_) => None,
    }
}
