//! A program on a simulated robot, whatever the robot's size.

use crate::desk::Desk;
use crate::echo::Echo;
use crate::engine::Engine;
use crate::motion::{Grasp, Limbs};
use crate::native::Native;
use crate::rig::{Failures, Rig};
use std::any::Any;
use std::time::Duration;
use tip_runtime::command::{Flag, MAX, Port};
use tip_runtime::controller::Aim;
use tip_runtime::hardware::JointCommand;
use tip_runtime::machine::{Emergency, Machine, Status};
use tip_runtime::plant::{self, Motion, Noise, Plant as _, Pose, Travel};
use tip_runtime::record::Sink;

/// What a sole's sensor reads on the ground: V.
const PRESSED: f64 = 2.0;

/// The machine of a robot of some size. Each size has its own; logic is outside.
pub(crate) trait Shell {
    fn boxed(&self) -> Box<dyn Shell>;
    fn cycle(&mut self, sink: Option<&mut dyn Sink>) -> Status;
    fn seen(&self) -> Seen<'_>;
    fn engine_mut(&mut self) -> &mut Engine;
    fn desk_mut(&mut self) -> &mut Desk;
    fn failures_mut(&mut self) -> &mut Failures;
    fn touched(&mut self) -> Option<&mut Echo>;
    fn is_ready(&mut self, longest: Duration) -> bool;
    fn motion(&self) -> Option<Motion>;
    fn pose(&self) -> Option<Pose>;
    fn travel(&self) -> Option<Travel>;
    fn first_fall(&self) -> Option<plant::Fall>;
    fn limbs(&self) -> Option<Limbs>;
    fn aims(&self) -> Vec<Aim>;
    fn grasp(&self) -> Option<Grasp>;
    fn has_input(&self, port: Port) -> bool;
    fn can_be_pushed(&self) -> bool;
    fn can_have_noise(&self) -> bool;
    fn set_sensor(&mut self, port: Port, volts: f64) -> bool;
    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool;
    fn set_noise(&mut self, noise: Noise) -> bool;
    fn pause(&mut self, on: bool);
    fn flag(&self, flag: Flag) -> bool;
}

/// What a run shows of itself.
pub(crate) struct Seen<'a> {
    pub(crate) cycles: u64,
    /// ms.
    pub(crate) time: f64,
    /// ms.
    pub(crate) period: f64,
    pub(crate) emergency: Option<&'a Emergency>,
    pub(crate) engine: &'a Engine,
    pub(crate) desk: &'a Desk,
    pub(crate) plant: &'a dyn Any,
    /// What each joint was sent, leg by leg.
    pub(crate) commands: &'a [JointCommand],
    /// What each joint was measured at, leg by leg: deg.
    pub(crate) angles: &'a [f64],
    pub(crate) lamps: &'a [u32; 8],
}

impl dyn Shell {
    /// Every foot or finger begins to feel something, or ceases to. Simulated joints feel what is there; only the
    /// readings of soles can be set.
    pub(crate) fn touch(&mut self, on: bool) {
        let volts = if on { PRESSED } else { 0.0 };
        for leg in (1..).take(MAX) {
            self.set_sensor(Port::Paw(leg), volts);
        }
        if let Some(echo) = self.touched() {
            echo.touch(on);
        }
    }
}

pub(crate) type Sized<const L: usize, const J: usize> =
    Machine<'static, Engine, Rig<L, J>, Desk, Native, L, J>;

impl<const L: usize, const J: usize> Shell for Sized<L, J> {
    fn boxed(&self) -> Box<dyn Shell> {
        Box::new(self.clone())
    }

    fn cycle(&mut self, sink: Option<&mut dyn Sink>) -> Status {
        match sink {
            Some(sink) => self.cycle_traced(sink),
            None => Machine::cycle(self),
        }
    }

    fn seen(&self) -> Seen<'_> {
        Seen {
            cycles: self.cycles(),
            time: self.time(),
            period: self.period(),
            emergency: self.emergency(),
            engine: self.program(),
            desk: self.console(),
            plant: self.hardware().plant(),
            commands: self.outputs().joints.as_flattened(),
            angles: self.sensors().angles.as_flattened(),
            lamps: &self.outputs().lamps,
        }
    }

    fn engine_mut(&mut self) -> &mut Engine {
        self.program_mut()
    }

    fn desk_mut(&mut self) -> &mut Desk {
        self.console_mut()
    }

    fn failures_mut(&mut self) -> &mut Failures {
        &mut self.hardware_mut().failures
    }

    fn touched(&mut self) -> Option<&mut Echo> {
        self.hardware_mut().touched()
    }

    fn is_ready(&mut self, longest: Duration) -> bool {
        self.hardware_mut().is_ready(longest)
    }

    fn motion(&self) -> Option<Motion> {
        self.hardware().motion()
    }

    fn pose(&self) -> Option<Pose> {
        self.hardware().pose()
    }

    fn travel(&self) -> Option<Travel> {
        self.hardware().travel()
    }

    fn first_fall(&self) -> Option<plant::Fall> {
        self.hardware().first_fall()
    }

    fn limbs(&self) -> Option<Limbs> {
        match self.hardware().elsewhere() {
            Some(outside) => outside.limbs(),
            None => self.hardware().limbs().map(Limbs::from),
        }
    }

    fn aims(&self) -> Vec<Aim> {
        self.controller().aims().collect()
    }

    fn grasp(&self) -> Option<Grasp> {
        self.hardware().grasp().map(Grasp::from)
    }

    fn has_input(&self, port: Port) -> bool {
        self.hardware().has_input(port)
    }

    fn can_be_pushed(&self) -> bool {
        self.hardware().can_be_pushed()
    }

    fn can_have_noise(&self) -> bool {
        self.hardware().can_have_noise()
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.hardware_mut().set_sensor(port, volts)
    }

    fn push(&mut self, force: [f64; 3], cycles: u32) -> bool {
        self.hardware_mut().push(force, cycles)
    }

    fn set_noise(&mut self, noise: Noise) -> bool {
        self.hardware_mut().set_noise(noise)
    }

    fn flag(&self, flag: Flag) -> bool {
        Machine::flag(self, flag)
    }

    fn pause(&mut self, on: bool) {
        match on {
            true => Machine::pause(self),
            false => self.resume(),
        }
    }
}
