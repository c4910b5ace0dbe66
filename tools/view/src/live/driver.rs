//! The page that drives a robot: which one it is, and what becomes of the robot when that page falls silent.
//!
//! A [`Driver`] has no clock. Its owner says what time it is with each call, as a duration since any moment. One viewer at a time
//! holds the robot. While its operator holds the button and the page is visible, it sends a [`Sign`] of life every
//! [`SIGN`]. Without signs the [`Stage`] rises: the robot pauses, then its program is asked to halt, then it is stopped as in an
//! emergency. A pause ends with a new press of the button alone: a page that comes back does not move the robot.
//!
//! ```
//! use std::time::Duration;
//! use tip_view::live::{Driver, Rules, Sign, Stage};
//!
//! let at = Duration::from_millis;
//! let mut driver = Driver::new(Rules::default());
//! driver.take(7, at(0));
//! driver.begin(at(0));
//! let sign = |press| Sign { press, sticks: [10.0, 5.0, 5.0] };
//! assert!(driver.sign(7, sign(1), at(100)));
//! assert_eq!(driver.stage(at(200)), Stage::Driven);
//! assert_eq!(driver.stage(at(400)), Stage::Paused);
//! driver.sign(7, sign(1), at(500));
//! assert_eq!(driver.stage(at(500)), Stage::Paused);
//! driver.sign(7, sign(2), at(600));
//! assert_eq!(driver.stage(at(600)), Stage::Driven);
//! ```

use serde::{Deserialize, Serialize};
use std::time::Duration;
use tip_sim::event::STICK_AT_REST;
use tipc::description::Bus;

/// Time between two signs of life.
pub const SIGN: Duration = Duration::from_millis(100);
/// Time for which the button is held before the torque is switched on.
pub const ARMING: Duration = Duration::from_secs(1);
/// Longest time between two signs of a press that switches the torque on.
const ARMING_GAP: Duration = Duration::from_millis(300);
/// Number of sticks.
pub const STICKS: usize = 3;
/// Readings of sticks at rest, V.
const AT_REST: [f64; STICKS] = [STICK_AT_REST; STICKS];
/// Range of a stick's reading, V.
const READINGS: std::ops::RangeInclusive<f64> = 0.0..=10.0;

/// Rules of driving: the button, and the answers to silence of the driving page.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rules {
    /// True if the robot moves only while the button is held.
    pub hold_to_drive: bool,
    /// Silence after which the robot pauses with its sticks at rest.
    pub pause: Duration,
    /// Silence after which the program is asked to halt.
    pub halt: Duration,
    /// Silence after which the robot is stopped as in an emergency.
    pub emergency: Duration,
}

impl Rules {
    /// Returns the rules of a described robot.
    pub fn of(bus: &Bus) -> Self {
        let [pause, halt, emergency] = bus
            .driver_silence
            .map(|time| Duration::try_from_secs_f64(time).unwrap_or(Duration::ZERO));
        Rules {
            hold_to_drive: bus.hold_to_drive,
            pause,
            halt,
            emergency,
        }
    }
}

impl Default for Rules {
    /// Returns the rules of a description that states none.
    fn default() -> Self {
        Rules {
            hold_to_drive: true,
            pause: Duration::from_millis(300),
            halt: Duration::from_secs(3),
            emergency: Duration::from_secs(10),
        }
    }
}

/// The freedom that is left to the robot.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Stage {
    /// Its program runs, with the sticks of the page.
    Driven,
    /// It holds where it is.
    Paused,
    /// Its program runs with sticks at rest, and was asked to halt.
    Halt,
    /// It is stopped as in an emergency.
    Emergency,
}

/// A sign of life of the page that drives.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sign {
    /// The number of the press of the button, another one for each press; 0 while nobody presses it.
    pub press: u32,
    /// Readings of the sticks VR1 to VR3, V.
    pub sticks: [f64; STICKS],
}

/// The page that drives a robot.
#[derive(Clone, Debug)]
pub struct Driver {
    rules: Rules,
    /// The viewer that holds the robot.
    holder: Option<u64>,
    /// The viewer that asked for it last.
    asker: Option<u64>,
    /// The last time at which anything came from the holder.
    contact: Duration,
    /// The last sign of life.
    alive: Duration,
    press: u32,
    /// The beginning of a press that may switch the torque on.
    pressed: Option<Duration>,
    is_driven: bool,
    sticks: [f64; STICKS],
    /// The stage that was reached and is not left any more; `None` while the torque is off.
    reached: Option<Stage>,
}

impl Driver {
    /// Creates a robot without torque that nobody holds.
    pub const fn new(rules: Rules) -> Self {
        Driver {
            rules,
            holder: None,
            asker: None,
            contact: Duration::ZERO,
            alive: Duration::ZERO,
            press: 0,
            pressed: None,
            is_driven: false,
            sticks: AT_REST,
            reached: None,
        }
    }

    /// Returns the rules.
    pub const fn rules(&self) -> &Rules {
        &self.rules
    }

    /// Returns the viewer that holds the robot.
    pub const fn holder(&self) -> Option<u64> {
        self.holder
    }

    /// Returns the viewer that asks the holder for the robot.
    pub const fn asker(&self) -> Option<u64> {
        self.asker
    }

    /// Gives the robot to a viewer if nobody holds it or the holder is gone, and otherwise asks the holder for it. Returns true if
    /// the viewer holds the robot.
    pub fn take(&mut self, viewer: u64, now: Duration) -> bool {
        let is_gone = now.saturating_sub(self.contact) >= self.rules.halt;
        if self.holder == Some(viewer) {
            return true;
        }
        if self.holder.is_some() && !is_gone {
            self.asker = Some(viewer);
            return false;
        }
        self.hand_to(Some(viewer), now);
        true
    }

    /// Hands the robot to the viewer that asks for it, or to nobody; returns false if the viewer does not hold it.
    pub fn give(&mut self, viewer: u64, now: Duration) -> bool {
        let is_own = self.holder == Some(viewer);
        if is_own {
            self.hand_to(self.asker, now);
        }
        is_own
    }

    /// Forgets a viewer that has left.
    pub fn leave(&mut self, viewer: u64, now: Duration) {
        self.asker.take_if(|asker| *asker == viewer);
        if self.holder == Some(viewer) {
            self.hand_to(None, now);
        }
    }

    fn hand_to(&mut self, viewer: Option<u64>, now: Duration) {
        self.holder = viewer;
        self.asker = None;
        self.contact = now;
        self.rest();
    }

    /// Lets the robot move again after a new press alone.
    fn rest(&mut self) {
        self.press = 0;
        self.pressed = None;
        self.is_driven = false;
        self.sticks = AT_REST;
    }

    /// Takes a sign of a viewer; returns false if it does not hold the robot.
    pub fn sign(&mut self, viewer: u64, sign: Sign, now: Duration) -> bool {
        if self.holder != Some(viewer) {
            return false;
        }
        self.pass(now);
        self.contact = now;
        let is_pressed = sign.press != 0;
        if is_pressed && sign.press != self.press {
            self.pressed = Some(now);
            self.is_driven = true;
        } else if !is_pressed {
            self.pressed = None;
            self.is_driven &= !self.rules.hold_to_drive;
        }
        self.press = sign.press;
        if is_pressed || !self.rules.hold_to_drive {
            self.alive = now;
        }
        if self.is_driven && sign.sticks.iter().all(|volts| READINGS.contains(volts)) {
            self.sticks = sign.sticks;
        } else {
            self.sticks = AT_REST;
        }
        true
    }

    /// Pauses the robot until the next press, or until [`resume`](Self::resume); returns false if the viewer does not hold it.
    pub fn pause(&mut self, viewer: u64) -> bool {
        let is_own = self.holder == Some(viewer);
        if is_own {
            self.pressed = None;
            self.is_driven = false;
            self.sticks = AT_REST;
        }
        is_own
    }

    /// Ends a pause of a robot that moves without the button; returns false if the viewer does not hold it, or the button is needed.
    pub fn resume(&mut self, viewer: u64) -> bool {
        let may = self.holder == Some(viewer) && !self.rules.hold_to_drive;
        self.is_driven |= may;
        may
    }

    /// Returns true if the button was held long enough to switch the torque on, without a gap.
    pub fn is_armed(&mut self, now: Duration) -> bool {
        self.pass(now);
        self.pressed
            .is_some_and(|since| now.saturating_sub(since) >= ARMING)
    }

    /// Requires a new press before the torque is switched on.
    pub const fn disarm(&mut self) {
        self.pressed = None;
    }

    /// Watches for silence from now on: the torque is on.
    pub const fn begin(&mut self, now: Duration) {
        self.alive = now;
        self.reached = Some(Stage::Driven);
        self.is_driven |= !self.rules.hold_to_drive;
    }

    /// Watches no longer: the robot was left.
    pub fn end(&mut self) {
        self.reached = None;
        self.rest();
    }

    /// Counts the silence until now.
    fn pass(&mut self, now: Duration) {
        let silence = now.saturating_sub(self.alive);
        if silence > ARMING_GAP.min(self.rules.pause) {
            self.pressed = None;
        }
        if silence >= self.rules.pause {
            self.sticks = AT_REST;
            self.is_driven &= !self.rules.hold_to_drive;
        }
        let stage = if silence >= self.rules.emergency {
            Stage::Emergency
        } else if silence >= self.rules.halt {
            Stage::Halt
        } else {
            Stage::Driven
        };
        self.reached = self.reached.map(|reached| reached.max(stage));
    }

    /// Returns what the robot may do now. A request to halt and an emergency stop last until [`end`](Self::end).
    pub fn stage(&mut self, now: Duration) -> Stage {
        self.pass(now);
        match self.reached {
            Some(Stage::Driven) if self.is_driven => Stage::Driven,
            Some(reached) if reached > Stage::Paused => reached,
            _ => Stage::Paused,
        }
    }

    /// Returns the readings of the sticks, V: at rest unless the robot is driven.
    pub fn sticks(&self) -> [f64; STICKS] {
        match self.reached {
            Some(Stage::Driven) => self.sticks,
            _ => AT_REST,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ME: u64 = 1;
    const OTHER: u64 = 2;
    const AHEAD: [f64; STICKS] = [10.0, 5.0, 5.0];

    fn at(ms: u64) -> Duration {
        Duration::from_millis(ms)
    }

    fn sign(press: u32) -> Sign {
        Sign {
            press,
            sticks: AHEAD,
        }
    }

    /// A robot that a page has driven since 0 ms, with its last sign at 1000 ms.
    fn driven(rules: Rules) -> Driver {
        let mut driver = Driver::new(rules);
        assert!(driver.take(ME, at(0)));
        driver.begin(at(0));
        for time in (0..=1000).step_by(100) {
            assert!(driver.sign(ME, sign(1), at(time)));
            assert_eq!(driver.stage(at(time)), Stage::Driven);
        }
        assert_eq!(driver.sticks(), AHEAD);
        driver
    }

    #[test]
    fn each_silence_has_its_stage_whether_time_passes_in_steps_or_at_once() {
        for (silence, expected) in [
            (0, Stage::Driven),
            (299, Stage::Driven),
            (300, Stage::Paused),
            (2999, Stage::Paused),
            (3000, Stage::Halt),
            (9999, Stage::Halt),
            (10_000, Stage::Emergency),
            (100_000, Stage::Emergency),
        ] {
            let mut at_once = driven(Rules::default());
            assert_eq!(at_once.stage(at(1000 + silence)), expected, "{silence} ms");
            let mut in_steps = driven(Rules::default());
            for time in (0..silence).step_by(20) {
                in_steps.stage(at(1000 + time));
            }
            assert_eq!(in_steps.stage(at(1000 + silence)), expected, "{silence} ms");
            let sticks = match expected {
                Stage::Driven => AHEAD,
                _ => AT_REST,
            };
            assert_eq!(at_once.sticks(), sticks, "{silence} ms");
            assert_eq!(in_steps.sticks(), sticks, "{silence} ms");
        }
    }

    /// A sign that comes before anybody has looked at the stage does not hide the silence before it.
    #[test]
    fn coming_back_moves_nothing_and_a_new_press_does() {
        for (silence, back, pressed) in [
            (300, Stage::Paused, Stage::Driven),
            (2999, Stage::Paused, Stage::Driven),
            (3000, Stage::Halt, Stage::Halt),
            (9999, Stage::Halt, Stage::Halt),
            (10_000, Stage::Emergency, Stage::Emergency),
        ] {
            for looks in [true, false] {
                let mut driver = driven(Rules::default());
                let now = at(1000 + silence);
                if looks {
                    driver.stage(now);
                }
                driver.sign(ME, sign(1), now);
                assert_eq!(driver.stage(now), back, "{silence} ms, {looks}");
                assert_eq!(driver.sticks(), AT_REST, "{silence} ms, {looks}");
                driver.sign(ME, sign(2), now);
                assert_eq!(driver.stage(now), pressed, "{silence} ms, {looks}");
            }
        }
    }

    #[test]
    fn a_program_that_was_asked_to_halt_is_stopped_only_if_nobody_is_there() {
        let mut driver = driven(Rules::default());
        assert_eq!(driver.stage(at(4000)), Stage::Halt);
        for time in (4000..20_000).step_by(100) {
            driver.sign(ME, sign(1), at(time));
            assert_eq!(driver.stage(at(time)), Stage::Halt);
        }
        assert_eq!(driver.stage(at(29_900)), Stage::Emergency);
        driver.end();
        assert_eq!(driver.stage(at(29_900)), Stage::Paused);
    }

    #[test]
    fn a_released_button_is_silence() {
        let mut driver = driven(Rules::default());
        for time in (1100..=20_000).step_by(100) {
            driver.sign(ME, sign(0), at(time));
            let expected = match time {
                ..4000 => Stage::Paused,
                4000..11_000 => Stage::Halt,
                _ => Stage::Emergency,
            };
            assert_eq!(driver.stage(at(time)), expected, "{time} ms");
            assert_eq!(driver.sticks(), AT_REST);
        }
    }

    #[test]
    fn a_bench_does_not_pause_and_is_stopped_all_the_same() {
        let rules = Rules {
            hold_to_drive: false,
            ..Rules::default()
        };
        for (silence, expected, sticks) in [
            (200, Stage::Driven, AHEAD),
            (300, Stage::Driven, AT_REST),
            (2999, Stage::Driven, AT_REST),
            (3000, Stage::Halt, AT_REST),
            (10_000, Stage::Emergency, AT_REST),
        ] {
            let mut driver = driven(rules);
            // The page is there, and nobody presses.
            driver.sign(ME, sign(0), at(1100));
            assert_eq!(driver.stage(at(1100 + silence)), expected, "{silence} ms");
            assert_eq!(driver.sticks(), sticks, "{silence} ms");
        }
        let mut driver = driven(rules);
        assert!(driver.pause(ME));
        driver.sign(ME, sign(0), at(1100));
        assert_eq!(driver.stage(at(1100)), Stage::Paused);
        assert!(!driver.resume(OTHER) && driver.resume(ME));
        assert_eq!(driver.stage(at(1100)), Stage::Driven);
    }

    #[test]
    fn a_pause_lasts_until_the_next_press() {
        let mut driver = driven(Rules::default());
        assert!(!driver.pause(OTHER));
        assert_eq!(driver.stage(at(1000)), Stage::Driven);
        assert!(driver.pause(ME));
        driver.sign(ME, sign(1), at(1100));
        assert_eq!(driver.stage(at(1100)), Stage::Paused);
        assert!(!driver.resume(ME), "the button is needed");
        driver.sign(ME, sign(2), at(1200));
        assert_eq!(driver.stage(at(1200)), Stage::Driven);
    }

    #[test]
    fn one_viewer_holds_the_robot_and_hands_it_over_or_is_gone() {
        let mut driver = driven(Rules::default());
        assert!(!driver.sign(OTHER, sign(9), at(1000)), "it watches");
        assert!(!driver.take(OTHER, at(1050)));
        assert_eq!((driver.holder(), driver.asker()), (Some(ME), Some(OTHER)));
        assert!(!driver.give(OTHER, at(1050)), "it is not its own");
        assert!(driver.give(ME, at(1050)));
        assert_eq!((driver.holder(), driver.asker()), (Some(OTHER), None));
        assert_eq!(driver.stage(at(1060)), Stage::Paused, "a press is needed");
        assert!(!driver.sign(ME, sign(3), at(1070)));
        driver.sign(OTHER, sign(1), at(1080));
        assert_eq!(driver.stage(at(1080)), Stage::Driven);
        // Nothing comes from it any more.
        assert!(!driver.take(ME, at(4079)));
        assert!(driver.take(ME, at(4080)));
        driver.leave(ME, at(4090));
        assert_eq!(driver.holder(), None);
        assert_eq!(driver.stage(at(4090)), Stage::Halt, "the silence goes on");
        assert!(driver.take(OTHER, at(4100)));
    }

    #[test]
    fn the_torque_needs_a_press_of_a_second_without_a_gap() {
        let mut driver = Driver::new(Rules::default());
        driver.take(ME, at(0));
        let mut held = |from: u64, until: u64, press, gap: usize| {
            let signs = (from..=until).step_by(gap);
            signs.for_each(|time| assert!(driver.sign(ME, sign(press), at(time))));
            driver.is_armed(at(until))
        };
        assert!(!held(0, 999, 1, 100));
        assert!(!held(1400, 2400, 1, 100), "the same press after a gap");
        assert!(!held(3000, 4200, 2, 301));
        assert!(held(5000, 6000, 3, 300));
        driver.disarm();
        driver.sign(ME, sign(3), at(7000));
        assert!(!driver.is_armed(at(7000)), "a new press is needed");
        driver.sign(ME, sign(4), at(7100));
        assert!(!driver.is_armed(at(8200)), "there were no signs");
    }

    #[test]
    fn sticks_beyond_their_range_rest() {
        let mut driver = driven(Rules::default());
        for volts in [f64::NAN, -0.1, 10.1] {
            let sticks = [5.0, volts, 10.0];
            driver.sign(ME, Sign { press: 1, sticks }, at(1000));
            assert_eq!(driver.sticks(), AT_REST, "{volts}");
        }
    }
}
