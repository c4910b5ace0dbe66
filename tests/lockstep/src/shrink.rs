//! The shortest script by which two engines still differ.

use crate::Subject;
use crate::duel::{Difference, Verdict};
use crate::figures::Figures;
use crate::script::Script;

/// Leaves out what the difference does not need: the cycles behind it, then events, many at a time and in the end one by one.
pub fn shrink(subject: &Subject, script: &Script, difference: Difference) -> (Script, Difference) {
    let mut best = (script.clone(), difference);
    let shorter = Script {
        limit: best.1.cycle + 1,
        ..script.clone()
    };
    keep_if_different(subject, &mut best, shorter);
    let mut size = best.0.events.len();
    while size > 0 {
        let mut from = 0;
        while from < best.0.events.len() {
            let mut fewer = best.0.clone();
            let to = fewer.events.len().min(from + size);
            fewer.events.drain(from..to);
            if !keep_if_different(subject, &mut best, fewer) {
                from += size;
            }
        }
        size /= 2;
    }
    best
}

fn keep_if_different(subject: &Subject, best: &mut (Script, Difference), script: Script) -> bool {
    match crate::compare(subject, &script, &mut Figures::default()) {
        Verdict::Different(difference) => {
            *best = (script, difference);
            true
        }
        Verdict::Same(_) => false,
    }
}
