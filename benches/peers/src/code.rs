//! Commands and targets as numbers, for peers that know no enums of ours.

use tipc::program::{Op, Target};

/// The number of a command.
///
/// # Panics
/// Never: the table has every command.
pub fn of_op(op: Op) -> usize {
    let is_it = |other: &Op| *other == op;
    Op::ALL.iter().position(is_it).expect("every command")
}

/// The command of a number.
pub fn op(code: usize) -> Option<Op> {
    Op::ALL.get(code).copied()
}

/// The number of a target: 0 for none, that of a foot, 10 for `ALL`.
///
/// # Panics
/// For the targets that the peers do not have.
pub fn of_target(target: Target) -> u8 {
    match target {
        Target::None => 0,
        Target::Foot(leg) => leg,
        Target::All => ALL,
        Target::Floor | Target::Joint(..) => panic!("beyond the peers"),
    }
}

/// The target of a number.
pub fn target(code: u8) -> Target {
    match code {
        0 => Target::None,
        ALL => Target::All,
        leg => Target::Foot(leg),
    }
}

const ALL: u8 = 10;
