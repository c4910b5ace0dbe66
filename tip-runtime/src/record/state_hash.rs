//! A hash of the robot's commands and measurements.

use crate::hardware::JointCommand;

const OFFSET: u64 = 0xCBF2_9CE4_8422_2325;
const PRIME: u64 = 0x0000_0100_0000_01B3;

/// Returns the 64-bit FNV-1a hash over the bits (little endian) of each joint's command and
/// measured angle, joint by joint (Fowler, Noll and Vo's hash: IETF draft-eastlake-fnv).
pub fn state_hash(commands: &[JointCommand], angles: &[f64]) -> u64 {
    commands
        .iter()
        .zip(angles)
        .flat_map(|(command, angle)| [command.value(), *angle])
        .flat_map(|value| value.to_bits().to_le_bytes())
        .fold(OFFSET, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(PRIME)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_hashes_to_the_offset_basis() {
        assert_eq!(state_hash(&[], &[]), 0xCBF2_9CE4_8422_2325);
    }

    #[test]
    fn zeros_only_multiply() {
        // XOR with a zero byte changes nothing: sixteen multiplications remain.
        let expected = (0..16).fold(OFFSET, |hash, _| hash.wrapping_mul(PRIME));
        assert_eq!(state_hash(&[JointCommand::at(0.0)], &[0.0]), expected);
    }

    #[test]
    fn a_last_bit_a_sign_of_zero_and_the_order_count() {
        let one = [JointCommand::at(1.0)];
        let hash = state_hash(&one, &[2.0]);
        assert_ne!(hash, state_hash(&one, &[2.0_f64.next_up()]));
        assert_ne!(hash, state_hash(&[JointCommand::at(2.0)], &[1.0]));
        assert_ne!(state_hash(&one, &[0.0]), state_hash(&one, &[-0.0]));
    }
}
