//! DETECT_FLOOR and DETECT_OBJECT (T.I.P. 3.1 §7-11-3, §7-11-4).
//!
//! Feet of TITAN VIII move until their soles touch the floor, or leave it. Fingers of a hand close with a gentle torque
//! or force until something stops them.
//!
//! A finger has found something when a joint that closes senses at least the contact torque while no
//! joint has turned for [`STILL_CYCLES`]. It goes on pressing until every finger that searches has
//! found something; then all of them hold the angles that are measured.
//!
//! Two joints that close by torque push a fingertip in a direction of their own: `τ = Jᵀ F`. Where that
//! is flatter than the floor's friction allows, it slides to the limits of the joints. DETECT_FLOOR 2
//! therefore pushes straight down.

use super::drive::{Drive, THIRD};
use super::leg::LegState;
use super::targets::unlocked;
use super::task::{FloorSearch, Task};
use super::trajectory::{Goal, SetPoint};
use super::{ControllerView, targets};
use crate::command::{Command, Op, Poll, Port, Target};
use crate::fault::Fault;
use crate::kinematics::LegPoint;
use crate::model::Forces;

/// The speed of a searching foot, as a share of the standard V_MAX (SLOW).
const SLOW: f64 = 0.5;

impl FloorSearch {
    fn new(operand: f64) -> Result<Self, Fault> {
        match libm::trunc(operand) {
            1.0 => Ok(FloorSearch::DownInTurn),
            2.0 => Ok(FloorSearch::DownTogether),
            3.0 => Ok(FloorSearch::Up),
            _ => Err(Fault::Domain),
        }
    }
}

impl<const J: usize> ControllerView<J> {
    pub(super) fn detect_floor_by_soles(&mut self, command: &Command<'_>) -> Result<Poll, Fault> {
        let search = match self.tasks.current() {
            Task::DetectFloor(search) => search,
            _ => self.new_search(command)?,
        };
        for n in 1..=self.count() {
            if self.leg(n)?.search.is_none() {
                continue;
            }
            unlocked(self.leg(n)?.switches.has_locked())?;
            if self.touches(n)? != (search == FloorSearch::Up) {
                // The floor has stopped the foot already: its set point follows immediately.
                self.send_foot(n, self.measured_point(n, LegPoint::Tip)?, true)?;
                targets::leg_mut(&mut self.legs, n)?.search = None;
            } else {
                self.set_off(n, search)?;
                if search == FloorSearch::DownInTurn {
                    break;
                }
            }
        }
        if self.legs.iter().any(|leg| leg.search.is_some()) {
            self.tasks.set(Task::DetectFloor(search));
            Ok(Poll::Pending)
        } else {
            self.tasks.set(Task::Idle);
            Ok(Poll::Done)
        }
    }

    fn new_search(&mut self, command: &Command<'_>) -> Result<FloorSearch, Fault> {
        let [operand] = command.values else {
            return Err(Fault::Domain);
        };
        let search = FloorSearch::new(operand.number())?;
        self.begin_search(command.target)?;
        Ok(search)
    }

    /// Begins the search of the legs that a target names, and of no others.
    ///
    /// # Errors
    /// `InvalidMode` for a leg with a locked joint, or while another thread runs a command of
    /// this kind; `Domain` for a target that is no leg.
    fn begin_search(&mut self, target: Target) -> Result<(), Fault> {
        let legs = targets::feet(&mut self.legs, target)?;
        unlocked(legs.iter().any(|leg| leg.switches.has_locked()))?;
        self.tasks.begin()?;
        for leg in &mut self.legs {
            leg.search = None;
        }
        for leg in targets::feet(&mut self.legs, target)? {
            leg.search = Some(0);
        }
        Ok(())
    }

    /// Returns true if the sole of leg `n` senses the floor.
    fn touches(&self, n: u8) -> Result<bool, Fault> {
        let volts = self.leg(n)?.paw;
        if volts.is_finite() {
            Ok(volts >= self.robot.contact)
        } else {
            Err(Fault::Sensor(Port::Paw(n)))
        }
    }

    fn set_off(&mut self, n: u8, search: FloorSearch) -> Result<(), Fault> {
        let slow = SLOW * self.robot.standards.v_max;
        let velocity = match search {
            FloorSearch::DownInTurn | FloorSearch::DownTogether => [0.0, 0.0, -slow],
            FloorSearch::Up => [0.0, 0.0, slow],
        };
        let foot = self.foot_track(n)?.towards(Goal::Speed(velocity));
        self.take_point(n, LegPoint::Tip, foot)
    }
}

/// Number of cycles that a joint has to stand still before contact counts.
const STILL_CYCLES: u16 = 10;

/// Rate up to which a joint stands still, deg/s.
const STILL: f64 = 2.0;

/// Index of the height in a fingertip's place.
const HEIGHT: usize = 1;

/// Shortest lever that gets all of the search torque, mm: a finger that is nearly straight would
/// push without bound.
const LEAST_LEVER: f64 = 20.0;

/// Number of joints that push a fingertip down.
const PUSHING_JOINTS: usize = 2;

/// Distance that such a joint keeps from its limit, deg.
const LIMIT_MARGIN: f64 = 1.0;

/// Number of cycles before that place at which it is stopped.
const LOOKAHEAD_CYCLES: f64 = 2.0;

impl<const J: usize> ControllerView<J> {
    /// Starts or continues a search.
    pub(super) fn detect_touch(
        &mut self,
        command: &Command<'_>,
        start: fn(&mut Self, &Command<'_>, &Forces) -> Result<(), Fault>,
    ) -> Result<Poll, Fault> {
        let forces = self.robot.forces.ok_or(Fault::Domain)?;
        if self.tasks.current() != Task::DetectTouch {
            start(self, command, &forces)?;
            self.tasks.set(Task::DetectTouch);
            self.press_floor(command, &forces);
            return Ok(Poll::Pending);
        }
        let searching = self.legs.iter().filter(|leg| leg.search.is_some());
        unlocked(searching.into_iter().any(|leg| leg.switches.has_locked()))?;
        self.press_floor(command, &forces);
        let pressing = if is_downward(command) {
            PUSHING_JOINTS
        } else {
            1
        };
        for leg in &mut self.legs {
            let mut torques = leg.torques.iter().take(pressing);
            let presses = torques.any(|torque| libm::fabs(*torque) >= forces.contact_torque);
            let stands = leg.rates.iter().all(|rate| libm::fabs(*rate) <= STILL);
            if let Some(still) = &mut leg.search {
                *still = if presses && stands {
                    still.saturating_add(1)
                } else {
                    0
                };
            }
        }
        let mut searching = self.legs.iter().filter_map(|leg| leg.search);
        if searching.all(|still| still >= STILL_CYCLES) {
            self.tasks.set(Task::Idle);
            self.hold_where_stopped();
            return Ok(Poll::Done);
        }
        Ok(Poll::Pending)
    }

    /// Holds every finger that searched at its measured angles.
    fn hold_where_stopped(&mut self) {
        for leg in &mut self.legs {
            if leg.search.is_some() {
                leg.drive.drive = Drive::Joints(leg.stays().map(held));
            }
        }
    }

    /// Starts DETECT_FLOOR: joint 1 closes by torque (type 1), or joints 1 and 2 press down (type
    /// 2); the others hold their angles.
    pub(super) fn floor_search(
        &mut self,
        command: &Command<'_>,
        forces: &Forces,
    ) -> Result<(), Fault> {
        let closing = match kind(command)? {
            1 => 1,
            2 => 0,
            _ => return Err(Fault::Domain),
        };
        self.begin_search(command.target)?;
        for leg in self.legs.iter_mut().filter(|leg| leg.search.is_some()) {
            let mut tracks = leg.stays().map(held);
            for track in tracks.iter_mut().take(closing) {
                *track = track.towards(Goal::Effort([forces.search_torque]));
            }
            leg.drive.drive = Drive::Joints(tracks);
        }
        Ok(())
    }

    /// Sets the torques of this cycle for DETECT_FLOOR 2.
    fn press_floor(&mut self, command: &Command<'_>, forces: &Forces) {
        if !is_downward(command) {
            return;
        }
        let look = LOOKAHEAD_CYCLES * self.params.period / 1000.0;
        for leg in self.legs.iter_mut().filter(|leg| leg.search.is_some()) {
            leg.press_down(forces, look);
        }
    }

    /// Starts DETECT_OBJECT: fingertips (type 1) or third joints (type 2) close along x by force,
    /// which the fingers of one side share; in type 3 a spring draws the fingertips, and keeps
    /// their height.
    pub(super) fn object_search(
        &mut self,
        command: &Command<'_>,
        forces: &Forces,
    ) -> Result<(), Fault> {
        let kind = kind(command)?;
        let point = match kind {
            1 | 3 => LegPoint::Tip,
            2 => LegPoint::Joint(THIRD),
            _ => return Err(Fault::Domain),
        };
        self.begin_search(Target::All)?;
        for n in 1..=self.count() {
            let base = self.leg(n)?.model.base;
            let sharing = self
                .legs
                .iter()
                .filter(|other| is_left(other.model.base) == is_left(base));
            let sharing = sharing.count();
            let force = libm::copysign(forces.search_force / sharing as f64, -base[0]);
            if kind == 3 {
                self.draw_inward(n)?;
            } else {
                self.push_point(n, point, [force, 0.0, 0.0])?;
            }
        }
        Ok(())
    }

    /// Pulls a fingertip by a spring to the middle of the palm, at its present height.
    fn draw_inward(&mut self, n: u8) -> Result<(), Fault> {
        let from = self.measured_point(n, LegPoint::Tip)?;
        let target = [0.0, from[1], from[2]];
        let spring = Goal::Spring { target, hs: false };
        self.take_point(n, LegPoint::Tip, SetPoint::resting(from).towards(spring))
    }
}

impl<const J: usize> LegState<J> {
    /// Pushes the fingertip straight down by joints 1 and 2. The one with the longer lever has the
    /// search torque. A joint that comes near its limit within `look` seconds stays there while it
    /// is pushed farther.
    fn press_down(&mut self, forces: &Forces, look: f64) {
        let Drive::Joints(mut tracks) = self.drive.drive else {
            return;
        };
        let levers = self.levers();
        let longest = levers
            .iter()
            .take(PUSHING_JOINTS)
            .fold(LEAST_LEVER, |most, lever| most.max(libm::fabs(*lever)));
        let states = levers.iter().zip(self.angles.iter().zip(&self.rates));
        let joints = tracks.iter_mut().zip(&self.model.joints).zip(states);
        for ((track, joint), (lever, (angle, rate))) in joints.take(PUSHING_JOINTS) {
            let torque = -forces.search_torque * lever / longest;
            let ahead = angle + look * rate;
            let near = (torque > 0.0 && angle.max(ahead) > joint.limits.max - LIMIT_MARGIN)
                || (torque < 0.0 && angle.min(ahead) < joint.limits.min + LIMIT_MARGIN);
            *track = match track.goal() {
                _ if !near => track.towards(Goal::Effort([torque])),
                Goal::Effort(_) => held(joint.limits.nearest(*angle)),
                _ => *track,
            };
        }
        self.drive.drive = Drive::Joints(tracks);
    }

    /// Returns the rise of the fingertip for each joint, mm/rad.
    fn levers(&self) -> [f64; J] {
        let columns = self.chain().foot_jacobian();
        columns.map(|column| column.get(HEIGHT).copied().unwrap_or_default())
    }
}

/// Returns true if the command is DETECT_FLOOR 2.
fn is_downward(command: &Command<'_>) -> bool {
    command.op == Op::DetectFloor && kind(command) == Ok(2)
}

fn is_left(base: [f64; 3]) -> bool {
    base[0].is_sign_negative()
}

/// Returns angle control at rest.
fn held(angle: f64) -> SetPoint<1> {
    SetPoint::resting([angle]).towards(Goal::Point {
        target: [angle],
        hs: false,
    })
}

/// Returns the type of a search, truncated; 0, which is no type, for a value below 1 or a NaN.
fn kind(command: &Command<'_>) -> Result<u8, Fault> {
    match command.values {
        [value] => Ok(value.number() as u8),
        _ => Err(Fault::Domain),
    }
}
