//! Simulated hardware: a hand of planar fingers, a floor on a slider, and objects to grasp.
//!
//! Fingers are chains of rigid links with motors, objects are rigid bodies in the x–y plane, y being
//! the height. Where things overlap they push each other apart with springs, dampers and Coulomb
//! friction. Motion advances in even steps of at most 0.1 ms, velocities first (semi-implicit Euler,
//! Hairer, Lubich and Wanner, *Geometric Numerical Integration*, 2006, ch. I.1).
//!
//! This is code of ours and not a physics engine on purpose. An engine such as rapier resolves
//! contacts as constraints, whose forces depend on its solver's iterations; here what a torque sensor
//! reads follows from stiffnesses that are written down. It needs `alloc`, half a minute and fifty
//! crates to build; this runs without any of them, and gives the same bits on every machine.
//!
//! Links are lines and fingertips points, so that forces act exactly where kinematics has the
//! fingertip. Fingers have no weight, since they are counterbalanced, and do not touch each other:
//! those of one side are beside each other.

mod body;
mod contact;
mod finger;
mod motor;
mod overlap;
mod slider;
mod thing;

use super::Plant;
use super::override_sensors::Overrides;
use super::scene::{OBJECTS, Scene};
use crate::command::Port;
use crate::fault::Fault;
use crate::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use crate::model::Model;
use contact::{Bristle, Push};
use finger::Finger;
use overlap::Surface;
use slider::SliderServo;
use thing::{Palm, Thing};

/// The longest step: ms.
const STEP: f64 = 0.1;

/// A cycle that is longer is cut short: ms.
const LONGEST: f64 = 1000.0;

/// In SI units.
type Vector = nalgebra::Vector2<f64>;

/// The end of a finger.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fingertip {
    /// Where it is: mm.
    pub position: [f64; 3],
    /// With what force the last link pushes the floor: N.
    pub on_floor: [f64; 3],
    /// With what force the last link pushes objects: N.
    pub on_objects: [f64; 3],
}

/// An object of the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectState {
    /// Its centre: mm.
    pub position: [f64; 2],
    /// deg.
    pub angle: f64,
    /// Of its centre: mm/s.
    pub velocity: [f64; 2],
    /// deg/s.
    pub spin: f64,
    /// How far its lowest point is above the floor: mm.
    pub clearance: f64,
    /// Whether it touches the floor.
    pub on_floor: bool,
    /// Whether it touches the palm.
    pub at_palm: bool,
}

/// A hand of `L` fingers with `J` joints over a floor. All joints turn about z.
///
/// The slider follows its command exactly, as fast as it can (1 m/s). See the [module](self) for
/// what is simulated.
#[derive(Clone, Debug)]
pub struct SimulatedHand<const L: usize, const J: usize> {
    model: Model<L, J>,
    scene: Scene,
    fingers: [Finger<J>; L],
    slider: SliderServo,
    /// `None` of a hand without fingers.
    palm: Option<Palm>,
    /// Friction of each finger's joints and tip on the floor.
    treads: [[Bristle; J]; L],
    things: [Option<Thing<L, J>>; OBJECTS],
    /// What pulls each fingertip from outside: N.
    pulls: [Vector; L],
    /// What the floor, and what the objects do to each last link: N.
    on_last: [[Vector; 2]; L],
    overrides: Overrides<L, J>,
    lamps: [u32; 8],
    /// Of the last cycle: ms.
    period: f64,
    stopped: bool,
}

impl<const L: usize, const J: usize> SimulatedHand<L, J> {
    /// The hand in its initial posture over a level floor with nothing on it.
    pub fn new(model: &Model<L, J>) -> Self {
        SimulatedHand {
            model: *model,
            scene: Scene::EMPTY,
            fingers: model.legs.each_ref().map(Finger::new),
            slider: SliderServo::new(model),
            palm: Palm::between(model.legs.iter().map(|leg| leg.base)),
            treads: [[Bristle::default(); J]; L],
            things: [None; OBJECTS],
            pulls: [Vector::zeros(); L],
            on_last: [[Vector::zeros(); 2]; L],
            overrides: Overrides::new(),
            lamps: [0; 8],
            period: model.standards.period,
            stopped: false,
        }
    }

    /// Puts a floor and objects under the hand.
    #[must_use]
    pub fn with_scene(mut self, scene: &Scene) -> Self {
        self.scene = *scene;
        let floor = self.floor();
        let objects = scene.objects.each_ref();
        self.things = objects.map(|object| Some(Thing::new(object.as_ref()?, &floor)));
        self
    }

    /// Pulls finger `n`, counted from 1, at its tip with a force along x and y (N) from now on, as a
    /// weight would that hangs on it.
    pub fn pull(&mut self, n: u8, [x, y]: [f64; 2]) {
        let pull = self.pulls.get_mut(usize::from(n).wrapping_sub(1));
        if let Some(pull) = pull.filter(|_| x.is_finite() && y.is_finite()) {
            *pull = Vector::new(x, y);
        }
    }

    /// The fingertips.
    pub fn fingertips(&self) -> [Fingertip; L] {
        let mut tips = [Fingertip {
            position: [0.0; 3],
            on_floor: [0.0; 3],
            on_objects: [0.0; 3],
        }; L];
        let fingers = self.fingers.iter().zip(&self.on_last);
        for (tip, ((finger, [floor, objects]), leg)) in
            tips.iter_mut().zip(fingers.zip(&self.model.legs))
        {
            let at = finger.tip() * 1000.0;
            tip.position = [at.x, at.y, leg.base[2]];
            tip.on_floor = [-floor.x, -floor.y, 0.0];
            tip.on_objects = [-objects.x, -objects.y, 0.0];
        }
        tips
    }

    /// Joint angles as they are, whatever the sensors say: deg.
    pub fn angles(&self) -> [[f64; J]; L] {
        self.fingers.each_ref().map(|finger| finger.angles)
    }

    /// What the motors give, in the robot's torque unit.
    pub fn torques(&self) -> [[f64; J]; L] {
        let unit = self.torque_unit();
        let torques = |finger: &Finger<J>| finger.motors.map(|motor| motor.torque * unit);
        self.fingers.each_ref().map(torques)
    }

    /// The objects, in the order of the scene.
    pub fn objects(&self) -> [Option<ObjectState>; OBJECTS] {
        let floor = self.floor();
        self.things.map(|thing| {
            let thing = thing?;
            let body = &thing.body;
            Some(ObjectState {
                position: (body.centre * 1000.0).into(),
                angle: body.angle.to_degrees(),
                velocity: (body.velocity * 1000.0).into(),
                spin: body.spin.to_degrees(),
                clearance: thing.clearance(&floor) * 1000.0,
                on_floor: thing.on_floor,
                at_palm: thing.at_palm,
            })
        })
    }

    /// Whether a lamp or relay is on.
    pub fn lamp(&self, device: u8) -> bool {
        let word = self.lamps.get(usize::from(device / 32));
        word.is_some_and(|word| word >> (device % 32) & 1 == 1)
    }

    fn torque_unit(&self) -> f64 {
        let forces = self.model.forces.as_ref();
        forces.map_or(1.0, |forces| forces.unit.per_newton_metre())
    }

    fn floor(&self) -> Surface {
        self.slider.floor(&self.scene.floor, self.scene.friction)
    }

    /// One control cycle.
    fn advance(&mut self) {
        let steps = libm::ceil(self.period.min(LONGEST) / STEP);
        let dt = self.period.min(LONGEST) / steps / 1000.0;
        for _ in 0..steps as u32 {
            self.step(dt);
        }
    }

    /// Moves everything on by `dt` s.
    fn step(&mut self, dt: f64) {
        let floor = self.floor();
        self.on_last = [[Vector::zeros(); 2]; L];
        self.meet_floor(&floor, dt);
        self.meet_objects(&floor, dt);
        for (finger, pull) in self.fingers.iter_mut().zip(self.pulls) {
            finger.push(J.wrapping_sub(1), finger.tip(), pull);
            finger.advance(dt);
        }
        for thing in self.things.iter_mut().flatten() {
            thing.body.advance(dt);
        }
        self.slider.advance(dt);
    }

    /// Fingers press on the floor, each with its joints and its tip.
    fn meet_floor(&mut self, floor: &Surface, dt: f64) {
        let fingers = self.fingers.iter_mut().zip(&mut self.treads);
        for ((finger, treads), [on_last, _]) in fingers.zip(&mut self.on_last) {
            for (m, tread) in treads.iter_mut().enumerate() {
                let Some(&link) = finger.links().get(m) else {
                    continue;
                };
                let velocity = |at| link.velocity_at(at) - floor.velocity;
                let place = floor.overlap(link.end);
                let push = tread.press(place, velocity, floor.friction, dt);
                if let Some(Push { at, force }) = push {
                    finger.push(m, at, force);
                    if m + 1 == J {
                        *on_last += force;
                    }
                }
            }
        }
    }

    /// Objects press on the floor, the palm, the fingers and each other.
    fn meet_objects(&mut self, floor: &Surface, dt: f64) {
        for thing in self.things.iter_mut().flatten() {
            thing.meet_floor(floor, dt);
            if let Some(palm) = &self.palm {
                thing.meet_palm(palm, dt);
            }
            let fingers = self.fingers.iter_mut().zip(&mut self.on_last);
            for (n, (finger, [_, on_last])) in fingers.enumerate() {
                *on_last += thing.meet_finger(n, finger, dt);
            }
        }
        let mut rest = self.things.as_mut_slice();
        while let Some((first, others)) = rest.split_first_mut() {
            for (n, other) in others.iter_mut().enumerate() {
                if let (Some(thing), Some(other)) = (first.as_mut(), other) {
                    thing.meet(n, other, dt);
                }
            }
            rest = others;
        }
    }
}

impl<const L: usize, const J: usize> Plant<L, J> for SimulatedHand<L, J> {
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.overrides.set(&self.model, port, volts)
    }
}

impl<const L: usize, const J: usize> Hardware<L, J> for SimulatedHand<L, J> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        let touched = self.things.iter().flatten().any(|thing| thing.at_palm);
        *into = Sensors {
            angles: self.angles(),
            torques: self.torques(),
            antenna: f64::from(u8::from(touched)),
            slider: self.slider.position,
            ..Sensors::ZERO
        };
        self.overrides.apply(into);
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        self.lamps = outputs.lamps;
        self.stopped = false;
        if !(outputs.period > 0.0 && outputs.period.is_finite()) {
            return Ok(());
        }
        self.period = outputs.period;
        let (unit, seconds) = (self.torque_unit(), outputs.period / 1000.0);
        for (finger, commands) in self.fingers.iter_mut().zip(&outputs.joints) {
            let joints = finger.motors.iter_mut().zip(finger.angles);
            for ((motor, angle), command) in joints.zip(commands) {
                motor.command(*command, unit, angle, seconds);
            }
        }
        self.slider.send(outputs.slider, seconds);
        self.advance();
        Ok(())
    }

    fn stop(&mut self, _why: &Fault) {
        if !self.stopped {
            self.stopped = true;
            for finger in &mut self.fingers {
                for (motor, angle) in finger.motors.iter_mut().zip(finger.angles) {
                    motor.hold(angle);
                }
            }
            self.slider.halt();
        }
        self.advance();
    }
}
