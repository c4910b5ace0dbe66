//! The contact model of the hand: fingers, the floor on its slider, the palm and the objects
//! between them.

use super::contact::{Bristle, Push};
use super::finger::Finger;
use super::grasped_object::{GraspedObject, LinkContact, Palm, Surface};
use super::{Fingertip, ObjectState, Vector};
use crate::command::Port;
use crate::hardware::{JointCommand, SensorsMut};
use crate::model::{Leg, Model, ModelFacts, Point, Range, Slider};
use crate::plant::{ContactLaw, Floor, are_sane};
use crate::scene::{OBJECTS, Scene};

/// The longest step: s.
const STEP: f64 = 0.0005;

/// Greatest oscillation of a body on one contact in a step, rad. All of its contacts together swing
/// it up to four times as fast, and their dampers must not reverse its motion within a step.
const SWING: f64 = 0.12;

/// The longest cycle, ms; longer ones are cut short.
const MAX_CYCLE: f64 = 1000.0;

/// One finger and its contacts.
#[derive(Clone, Debug)]
pub(super) struct FingerContacts<const J: usize> {
    finger: Finger<J>,
    /// Position along z, mm.
    z: f64,
    /// Friction of joints and tip on the floor.
    floor_bristles: [Bristle; J],
    /// Contacts of the links with each object.
    link_contacts: [[LinkContact; J]; OBJECTS],
    /// External force on the fingertip, N.
    pub(super) pull: Vector,
    /// Forces of the floor, and of the objects, on the last link, N.
    on_last: [Vector; 2],
    /// The greatest sum of both at the end of a cycle, N.
    greatest: f64,
}

/// A hand and its surroundings: with an array of fingers, or a slice, which holds all logic.
#[derive(Clone, Debug)]
pub(super) struct ContactModel<S: ?Sized> {
    scene: Scene,
    /// Number of the robot's torque units in one N·m.
    pub(super) torque_unit: f64,
    slider: SliderServo,
    /// The palm; `None` for a hand without fingers.
    palm: Option<Palm>,
    objects: [Option<GraspedObject>; OBJECTS],
    /// The longest step that the fingers and objects allow, s.
    step: f64,
    /// Period of the last cycle, ms.
    period: f64,
    stopped: bool,
    pub(super) fingers: S,
}

impl<const J: usize> FingerContacts<J> {
    fn new(leg: &Leg<J>) -> Self {
        FingerContacts {
            finger: Finger::new(leg),
            z: leg.base[2],
            floor_bristles: [Bristle::default(); J],
            link_contacts: [[LinkContact::NONE; J]; OBJECTS],
            pull: Vector::zeros(),
            on_last: [Vector::zeros(); 2],
            greatest: 0.0,
        }
    }

    pub(super) fn tip(&self) -> Fingertip {
        let at = self.finger.tip() * 1000.0;
        let [floor, objects] = self.on_last;
        Fingertip {
            position: [at.x, at.y, self.z],
            on_floor: [-floor.x, -floor.y, 0.0],
            on_objects: [-objects.x, -objects.y, 0.0],
            greatest: self.greatest,
        }
    }

    /// Returns the joint angles, deg.
    pub(super) const fn angles(&self) -> [f64; J] {
        self.finger.angles
    }

    /// Returns the motor torques, in a unit of which one N·m is `unit`.
    pub(super) fn torques(&self, unit: f64) -> [f64; J] {
        self.finger.motors.map(|motor| motor.torque * unit)
    }

    /// Applies the contacts of joints and tip with the floor.
    fn press_floor(&mut self, floor: &Surface, dt: f64) {
        for (m, bristle) in self.floor_bristles.iter_mut().enumerate() {
            let Some(&link) = self.finger.links().get(m) else {
                continue;
            };
            let velocity = |at| link.velocity_at(at) - floor.velocity;
            let place = floor.overlap(link.end);
            let push = bristle.press(place, velocity, ContactLaw::FINGER, floor.friction, dt);
            if let Some(Push { at, force }) = push {
                self.finger.push(m, at, force);
                if m + 1 == J {
                    let [on_last, _] = &mut self.on_last;
                    *on_last += force;
                }
            }
        }
    }

    /// Applies the contacts with the object at a place in the scene.
    fn press_object(&mut self, place: usize, object: &mut GraspedObject, dt: f64) {
        if let Some(contacts) = self.link_contacts.get_mut(place) {
            let [_, on_last] = &mut self.on_last;
            *on_last += object.press_finger(contacts, &mut self.finger, dt);
        }
    }
}

impl<const L: usize, const J: usize> ContactModel<[FingerContacts<J>; L]> {
    /// Returns the hand in its initial posture over an empty, level floor.
    pub(super) fn new(model: &Model<L, J>) -> Self {
        let mut contacts = ContactModel {
            scene: Scene::EMPTY,
            torque_unit: ModelFacts::of(model).torque_unit(),
            slider: SliderServo::new(model.slider.as_ref()),
            palm: Palm::between(model.legs.iter().map(|leg| leg.base)),
            objects: [None; OBJECTS],
            step: STEP,
            period: model.standards.period,
            stopped: false,
            fingers: model.legs.each_ref().map(FingerContacts::new),
        };
        let slice: &mut ContactModel<[FingerContacts<J>]> = &mut contacts;
        slice.step = slice.longest_step();
        contacts
    }
}

impl<S: ?Sized> ContactModel<S> {
    fn floor(&self) -> Surface {
        self.slider.floor(&self.scene.floor, self.scene.friction)
    }

    /// Returns the position of the slider, mm.
    pub(super) const fn slider(&self) -> Point {
        self.slider.position
    }

    /// Returns the objects, in the order of the scene.
    pub(super) fn objects(&self) -> [Option<ObjectState>; OBJECTS] {
        let floor = self.floor();
        self.objects.map(|object| {
            let object = object?;
            let body = &object.body;
            Some(ObjectState {
                position: in_space(body.centre * 1000.0),
                angle: body.angle.to_degrees(),
                velocity: in_space(body.velocity * 1000.0),
                spin: body.spin.to_degrees(),
                clearance: object.clearance(&floor) * 1000.0,
                highest: object.highest * 1000.0,
                on_floor: object.on_floor,
                at_palm: object.at_palm,
            })
        })
    }
}

impl<const J: usize> ContactModel<[FingerContacts<J>]> {
    /// Replaces floor and objects and clears the contacts.
    pub(super) fn replace(&mut self, scene: &Scene) {
        self.scene = *scene;
        let floor = self.floor();
        let objects = scene.objects.each_ref();
        self.objects = objects.map(|object| Some(GraspedObject::new(object.as_ref()?, &floor)));
        for finger in &mut self.fingers {
            finger.link_contacts = [[LinkContact::NONE; J]; OBJECTS];
        }
        self.step = self.longest_step();
    }

    /// Returns a step in which no contact swings too far, s.
    fn longest_step(&self) -> f64 {
        let of_fingers = self.fingers.iter().map(|FingerContacts { finger, .. }| {
            ContactLaw::FINGER.frequency(finger.lightest()) / 3.0
        });
        let objects = self.objects.iter().flatten();
        let frequencies = of_fingers.chain(objects.map(|object| object.body.frequency()));
        frequencies.fold(STEP, |step, frequency| step.min(SWING / frequency))
    }

    /// Measures joints, palm and slider.
    pub(super) fn measure(&self, sensors: &mut SensorsMut<'_, J>) {
        let joints = sensors.angles.iter_mut().zip(sensors.torques.iter_mut());
        for ((angles, torques), finger) in joints.zip(&self.fingers) {
            *angles = finger.angles();
            *torques = finger.torques(self.torque_unit);
        }
        let touched = self.objects.iter().flatten().any(|object| object.at_palm);
        let volts = f64::from(u8::from(touched));
        sensors.inputs.set(Port::Antenna, volts);
        *sensors.slider = self.slider.position;
    }

    /// Simulates a control cycle of `period` ms with commands. Without a period nothing moves.
    pub(super) fn simulate(&mut self, commands: &[[JointCommand; J]], slider: Point, period: f64) {
        self.stopped = false;
        if !(period > 0.0 && period.is_finite()) {
            return;
        }
        self.period = period;
        let seconds = period / 1000.0;
        for (FingerContacts { finger, .. }, commands) in self.fingers.iter_mut().zip(commands) {
            let joints = finger.motors.iter_mut().zip(finger.angles);
            for ((motor, angle), command) in joints.zip(commands) {
                motor.command(*command, self.torque_unit, angle, seconds);
            }
        }
        self.slider.send(slider, seconds);
        self.advance();
    }

    /// Returns true if all positions and speeds are valid.
    pub(super) fn is_sane(&self) -> bool {
        let objects = self.objects.iter().flatten().map(|object| &object.body);
        let objects = objects.flat_map(|body| {
            let ([x, y], [u, v]) = (body.centre.into(), body.velocity.into());
            [x, y, u, v, body.angle, body.spin]
        });
        let fingers = self.fingers.iter().map(|finger| &finger.finger);
        let fingers = fingers.flat_map(|finger| {
            let torques = finger.motors.iter().map(|motor| motor.torque);
            finger.angles.iter().copied().chain(torques)
        });
        are_sane(objects.chain(fingers))
    }

    /// Simulates a control cycle of an emergency.
    pub(super) fn stop(&mut self) {
        if !self.stopped {
            self.stopped = true;
            for FingerContacts { finger, .. } in &mut self.fingers {
                for (motor, angle) in finger.motors.iter_mut().zip(finger.angles) {
                    motor.hold(angle);
                }
            }
            self.slider.halt();
        }
        self.advance();
    }

    /// Simulates a control cycle: positions at the middles of steps, velocities at their ends.
    /// Contact forces in a middle depend on velocities, too, which are extrapolated from the step
    /// before.
    fn advance(&mut self) {
        let time = self.period.min(MAX_CYCLE) / 1000.0;
        // The subtrahend keeps a rounding error from adding a step to a whole multiple of the longest one.
        let steps = libm::ceil(time / self.step - 1e-9);
        let dt = time / steps;
        self.drift(dt / 2.0, dt);
        for _ in 1..steps as u32 {
            self.kick(dt);
            self.drift(dt, dt);
        }
        self.kick(dt);
        self.arrive(dt / 2.0);
        self.update_extremes();
    }

    /// Updates the extremes at the end of a cycle.
    fn update_extremes(&mut self) {
        for finger in &mut self.fingers {
            let [floor, objects] = finger.on_last;
            finger.greatest = finger.greatest.max((floor + objects).norm());
        }
        let floor = self.floor();
        for object in self.objects.iter_mut().flatten() {
            object.highest = object.highest.max(object.clearance(&floor));
        }
    }

    /// Moves all bodies for `time` s at their velocities, to the middle of a step of `dt` s.
    fn drift(&mut self, time: f64, dt: f64) {
        for FingerContacts { finger, .. } in &mut self.fingers {
            finger.drift(time, dt);
        }
        for object in self.objects.iter_mut().flatten() {
            object.body.drift(time, dt);
        }
        self.slider.advance(time);
    }

    /// Moves all bodies for `time` s at their velocities, to the end of a cycle.
    fn arrive(&mut self, time: f64) {
        for FingerContacts { finger, .. } in &mut self.fingers {
            finger.arrive(time);
        }
        for object in self.objects.iter_mut().flatten() {
            object.body.arrive(time);
        }
        self.slider.advance(time);
    }

    /// Integrates all velocities from the start to the end of a step of `dt` s, with the forces of
    /// its middle.
    fn kick(&mut self, dt: f64) {
        let floor = self.floor();
        for finger in &mut self.fingers {
            finger.on_last = [Vector::zeros(); 2];
            finger.press_floor(&floor, dt);
        }
        self.press_objects(&floor, dt);
        for FingerContacts { finger, pull, .. } in &mut self.fingers {
            finger.push(J.wrapping_sub(1), finger.tip(), *pull);
            finger.kick(dt);
        }
        for object in self.objects.iter_mut().flatten() {
            object.body.kick(dt);
        }
    }

    /// Applies the contacts of objects with the floor, the palm, the fingers and each other.
    fn press_objects(&mut self, floor: &Surface, dt: f64) {
        for (place, object) in self.objects.iter_mut().enumerate() {
            let Some(object) = object else {
                continue;
            };
            object.press_floor(floor, dt);
            if let Some(palm) = &self.palm {
                object.press_palm(palm, dt);
            }
            for finger in &mut self.fingers {
                finger.press_object(place, object, dt);
            }
        }
        let mut rest = self.objects.as_mut_slice();
        while let Some((first, others)) = rest.split_first_mut() {
            for (n, other) in others.iter_mut().enumerate() {
                if let (Some(object), Some(other)) = (first.as_mut(), other) {
                    object.press_object(n, other, dt);
                }
            }
            rest = others;
        }
    }
}

fn in_space(vector: Vector) -> [f64; 3] {
    [vector.x, vector.y, 0.0]
}

/// Greatest speed, mm/s.
const FASTEST: f64 = 1000.0;

/// A slider and the floor on it.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SliderServo {
    travel: [Range; 3],
    /// Position, mm.
    pub(super) position: Point,
    /// Velocity, mm/s.
    velocity: [f64; 3],
}

impl SliderServo {
    /// Returns a slider at rest in the model's initial position.
    pub(super) fn new(slider: Option<&Slider>) -> Self {
        SliderServo {
            travel: slider.map_or([Range::new(0.0, 0.0); 3], |slider| slider.travel),
            position: slider.map_or([0.0; 3], |slider| slider.initial),
            velocity: [0.0; 3],
        }
    }

    /// Starts a motion that arrives in `time` s; a position that is not a number stops the slider.
    fn send(&mut self, target: Point, time: f64) {
        let axes = self.velocity.iter_mut().zip(self.position);
        for ((velocity, at), (target, travel)) in axes.zip(target.iter().zip(self.travel)) {
            let way = travel.nearest(*target) - at;
            *velocity = if target.is_finite() {
                (way / time).clamp(-FASTEST, FASTEST)
            } else {
                0.0
            };
        }
    }

    /// Stops the slider.
    pub(super) const fn halt(&mut self) {
        self.velocity = [0.0; 3];
    }

    /// Moves the slider for `dt` s.
    pub(super) fn advance(&mut self, dt: f64) {
        let axes = self.velocity.iter().zip(self.travel);
        for (at, (velocity, travel)) in self.position.iter_mut().zip(axes) {
            *at = travel.nearest(*at + velocity * dt);
        }
    }

    /// Returns the floor on the slider.
    pub(super) fn floor(&self, floor: &Floor, friction: f64) -> Surface {
        let [x, y, _] = self.position;
        let [vx, vy, _] = self.velocity;
        let [rise, _] = floor.slope;
        Surface {
            point: Vector::new(x, y + floor.height) / 1000.0,
            normal: Vector::new(-rise, 1.0).normalize(),
            velocity: Vector::new(vx, vy) / 1000.0,
            friction,
        }
    }
}
