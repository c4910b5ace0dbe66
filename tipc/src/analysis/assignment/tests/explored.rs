//! Every run of a small program, for any answers of the robot.

use crate::analysis::access;
use crate::program::{Action, Program};
use std::collections::{BTreeMap, HashSet};

/// Step number, "not taken", open calls, and whether the scalar has a value.
type Place = (u32, bool, Vec<u32>, bool);

/// Explores what every run, for any answers of the robot, finds at the reads of one scalar: with a value,
/// without one. `None` if there are too many runs.
pub(super) fn explored(program: &Program, scalar: usize) -> Option<BTreeMap<u32, (bool, bool)>> {
    let mut found: BTreeMap<u32, (bool, bool)> = BTreeMap::new();
    let mut seen = HashSet::new();
    let mut open: Vec<Place> = vec![(0, false, Vec::new(), false)];
    while let Some(place) = open.pop() {
        if !seen.insert(place.clone()) {
            continue;
        }
        if seen.len() > 3_000 {
            return None;
        }
        let (at, not_taken, calls, mut assigned) = place;
        let action = &program.steps()[at as usize].action;
        let is_passed = matches!(action, Action::ElseIf { .. }) && !not_taken;
        let mut reads = false;
        access::reads(program, action, |read| reads |= read == scalar);
        if !is_passed && reads {
            let read = found.entry(at).or_default();
            read.0 |= assigned;
            read.1 |= !assigned;
            if !assigned {
                continue;
            }
        }
        assigned |= access::assigns(program, action).contains(&scalar);
        let mut go = |to: u32, not_taken: bool, calls: Vec<u32>| {
            open.push((to, not_taken, calls, assigned));
        };
        let next = at + 1;
        match action {
            Action::If { otherwise, .. } => {
                go(*otherwise, true, calls.clone());
                go(next, false, calls);
            }
            Action::ElseIf { otherwise, .. } if not_taken => {
                go(*otherwise, true, calls.clone());
                go(next, false, calls);
            }
            Action::ElseIf { otherwise: to, .. } | Action::Goto { to } => go(*to, false, calls),
            Action::Else { end } => go(if not_taken { next } else { *end }, false, calls),
            Action::While { exit: to, .. }
            | Action::Until { back: to, .. }
            | Action::For { exit: to, .. }
            | Action::Next { body: to, .. }
            | Action::IfGoto { to, .. } => {
                go(*to, false, calls.clone());
                go(next, false, calls);
            }
            Action::Gosub { to } | Action::IfGosub { to, .. } => {
                if matches!(action, Action::IfGosub { .. }) {
                    go(next, false, calls.clone());
                }
                if calls.len() < 10 {
                    go(*to, false, [&calls[..], &[next]].concat());
                }
            }
            Action::Return => {
                if let Some((back, calls)) = calls.split_last() {
                    go(*back, false, calls.to_vec());
                }
            }
            Action::Finish(_) => {}
            _ => go(next, false, calls),
        }
    }
    Some(found)
}
