//! A recorder that is taken back, and one that forgets.

use super::{Recorder, SlipDetector, Tasks};
use crate::recording::{At, Recording, Tick};
use std::collections::HashSet;
use std::hash::Hash;

/// State of a recorder besides its recording.
#[derive(Clone, Debug)]
pub(crate) struct Checkpoint {
    cycle: u64,
    slips: SlipDetector,
    falls: u32,
    tasks: Tasks,
}

impl Recorder {
    /// Marks where it is.
    pub(crate) fn checkpoint(&self) -> Checkpoint {
        Checkpoint {
            cycle: self.recording.cycles,
            slips: self.slips.clone(),
            falls: self.falls,
            tasks: self.tasks,
        }
    }

    /// Returns to a checkpoint.
    pub(crate) fn take_back(&mut self, checkpoint: &Checkpoint) {
        self.slips = checkpoint.slips.clone();
        self.falls = checkpoint.falls;
        self.tasks = checkpoint.tasks;
        self.pending = None;
        self.recording.cut(checkpoint.cycle);
    }
}

impl Recording {
    /// Takes away what happened from a cycle on; events stay, since they are going to happen again.
    fn cut(&mut self, from: u64) {
        let count = self.frames.partition_point(|frame| frame.cycle < from);
        self.frames.truncate(count);
        let ticks = self.clock.partition_point(|tick| tick.cycle < from);
        self.clock.truncate(ticks);
        cut(&mut self.steps, from);
        cut(&mut self.threads, from);
        cut(&mut self.timers, from);
        cut(&mut self.locks, from);
        cut(&mut self.messages, from);
        cut(&mut self.sets, from);
        cut(&mut self.lamps, from);
        cut(&mut self.commands, from);
        cut(&mut self.contacts, from);
        cut(&mut self.flags, from);
        cut(&mut self.modes, from);
        cut(&mut self.falls, from);
        cut(&mut self.slips, from);
        self.cycles = from;
    }

    /// Forgets what happened before a cycle, but for what still holds in it.
    pub(crate) fn forget(&mut self, before: u64) {
        self.frames.retain(|frame| frame.cycle >= before);
        let later = self.clock.partition_point(|tick| tick.cycle <= before);
        if let Some(Tick {
            cycle,
            time,
            period,
        }) = self.clock.get(later.wrapping_sub(1)).copied()
        {
            let passed = before.saturating_sub(cycle) as f64 * period;
            self.clock.drain(..later - 1);
            self.clock[0] = Tick {
                cycle: before,
                time: time + passed,
                period,
            };
        }
        keep_last(&mut self.steps, before, |_| ());
        keep_last(&mut self.threads, before, |thread| thread.0);
        keep_last(&mut self.timers, before, |timer| timer.number);
        keep_last(&mut self.locks, before, |_| ());
        keep_last(&mut self.contacts, before, |_| ());
        keep_last(&mut self.flags, before, |_| ());
        keep_last(&mut self.modes, before, |_| ());
        keep_last(&mut self.messages, before, |_| ());
        keep_last(&mut self.sets, before, |set| set.scalar);
        keep_last(&mut self.lamps, before, |lamp| lamp.0);
        keep_last(&mut self.commands, before, |asked| asked.target.to_string());
        self.falls.retain(|fall| fall.cycle >= before);
        self.slips.retain(|slip| slip.cycle >= before);
        self.events.retain(|event| event.cycle >= before);
    }
}

fn cut<T>(list: &mut Vec<At<T>>, from: u64) {
    list.truncate(list.partition_point(|at| at.cycle < from));
}

/// Keeps the last value of each key of everything that happened before a cycle.
fn keep_last<T, K: Eq + Hash>(list: &mut Vec<At<T>>, before: u64, key: impl Fn(&T) -> K) {
    let mut seen = HashSet::new();
    let later = list.partition_point(|at| at.cycle < before);
    let mut kept: Vec<bool> = list[..later]
        .iter()
        .rev()
        .map(|at| seen.insert(key(&at.what)))
        .collect();
    // Those that are left are asked for from the front on.
    list.retain(|_| kept.pop().unwrap_or(true));
}
