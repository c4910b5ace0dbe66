//! Keys of a terminal as sticks: arrows and W A S D Q E move the inputs VR1 to VR3, which spring back.

use std::collections::VecDeque;
use std::time::{Duration, Instant};
use tip_runtime::command::Port;
use tip_runtime::console::Key;
use tip_sim::event::{Event, Events, STICK_AT_REST, Timed};
use tipc::program::{Action, Program};

/// Number of sticks.
const STICKS: usize = 3;
/// Ends of a stick's range, V.
const LOW: f64 = 0.0;
const HIGH: f64 = 10.0;
/// Time after which a stick springs back. A terminal says when a key repeats, and not when it is released; it waits up to this long
/// before the first repetition.
const SPRING: Duration = Duration::from_millis(600);

/// Returns true if a program reads all sticks; one that reads fewer has knobs, which stay where they are put.
pub(super) fn are_read(program: &Program) -> bool {
    let reads = |number: u8| {
        let port = Port::Knob(number);
        let mut steps = program.steps().iter();
        steps.any(|step| matches!(&step.action, Action::AdIn { port: read, .. } if *read == port))
    };
    (1..).take(STICKS).all(reads)
}

/// Returns the events that let all sticks rest from the start.
pub(super) fn at_rest() -> Vec<Timed> {
    let sticks = (1..).take(STICKS);
    sticks
        .map(|n| Event::Sensor(Port::Knob(n), STICK_AT_REST).at(0))
        .collect()
}

/// Lets the sticks of a program that reads all of them rest from the start, unless its user has set one.
pub(super) fn let_rest(program: &Program, events: Events) -> Events {
    let is_set = events.ports().any(|port| matches!(port, Port::Knob(_)));
    match are_read(program) && !is_set {
        true => at_rest().into_iter().chain(events).collect(),
        false => events,
    }
}

/// The sticks that keys move.
#[derive(Debug)]
pub(super) struct Sticks {
    /// The end of its range where a stick is held, and until when.
    held: [Option<(f64, Instant)>; STICKS],
    /// The readings that the robot has, V.
    shown: [f64; STICKS],
    /// Keys that are not of a stick.
    keys: VecDeque<u8>,
}

impl Sticks {
    pub(super) fn new() -> Self {
        Sticks {
            held: [None; STICKS],
            shown: [STICK_AT_REST; STICKS],
            keys: VecDeque::new(),
        }
    }

    /// Takes all keys that were pressed; those that move no stick wait for [`key`](Self::key).
    pub(super) fn press(&mut self, now: Instant, mut next: impl FnMut() -> Option<Key>) {
        while let Some(key) = next() {
            let (stick, volts) = match key {
                Key::Up | Key::Byte(b'W' | b'w') => (0, HIGH),
                Key::Down | Key::Byte(b'S' | b's') => (0, LOW),
                Key::Left | Key::Byte(b'A' | b'a') => (1, HIGH),
                Key::Right | Key::Byte(b'D' | b'd') => (1, LOW),
                Key::Byte(b'E' | b'e') => (2, HIGH),
                Key::Byte(b'Q' | b'q') => (2, LOW),
                Key::Byte(byte) => {
                    self.keys.push_back(byte);
                    continue;
                }
            };
            self.held[stick] = Some((volts, now + SPRING));
        }
    }

    /// Returns the next key that moves no stick.
    pub(super) fn key(&mut self) -> Option<u8> {
        self.keys.pop_front()
    }

    /// Returns the sticks that have moved, with their readings, V.
    pub(super) fn moved(&mut self, now: Instant) -> Vec<Event> {
        let mut moved = Vec::new();
        for ((n, held), shown) in (1..).zip(&mut self.held).zip(&mut self.shown) {
            if held.is_some_and(|(_, until)| now >= until) {
                *held = None;
            }
            let volts = held.map_or(STICK_AT_REST, |(volts, _)| volts);
            if volts != *shown {
                *shown = volts;
                moved.push(Event::Sensor(Port::Knob(n), volts));
            }
        }
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn press(sticks: &mut Sticks, now: Instant, keys: &[Key]) {
        let mut keys = keys.iter().copied();
        sticks.press(now, || keys.next());
    }

    #[test]
    fn keys_move_sticks_that_spring_back() {
        let (mut sticks, now) = (Sticks::new(), Instant::now());
        press(&mut sticks, now, &[Key::Byte(b'w'), Key::Right]);
        let moved = sticks.moved(now);
        let knob = |n, volts| Event::Sensor(Port::Knob(n), volts);
        assert_eq!(moved, [knob(1, 10.0), knob(2, 0.0)]);
        assert_eq!(sticks.moved(now), []);
        // A key that repeats holds its stick; the other one is back.
        press(&mut sticks, now + SPRING / 2, &[Key::Byte(b'W')]);
        assert_eq!(sticks.moved(now + SPRING), [knob(2, 5.0)]);
        assert_eq!(sticks.moved(now + 2 * SPRING), [knob(1, 5.0)]);
        assert_eq!(sticks.key(), None);
    }

    #[test]
    fn other_keys_reach_the_program() {
        let (mut sticks, now) = (Sticks::new(), Instant::now());
        press(&mut sticks, now, &[b'x', 0x1B].map(Key::Byte));
        assert_eq!(sticks.key(), Some(b'x'));
        assert_eq!(sticks.key(), Some(0x1B));
        assert_eq!(sticks.key(), None);
        assert_eq!(sticks.moved(now), []);
    }
}
