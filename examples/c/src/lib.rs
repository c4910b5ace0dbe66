//! `walk.prg` as a static library: `walk.h` declares it, `main.c` uses it.
//!
//! The caller owns the drives and the clock. It calls [`walk_cycle`] once in each sampling time, from one thread.

use std::sync::{Mutex, PoisonError};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::titan8::MODEL;

tip_macros::include_tip!(pub "../walk/motions/walk.prg");

/// Legs of the robot.
pub const LEGS: usize = 4;
/// Joints of a leg.
pub const JOINTS: usize = 3;

/// `walk_sensors`
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct WalkSensors {
    /// Measured joint angles, deg.
    pub angles: [[f64; JOINTS]; LEGS],
}

/// `walk_outputs`
#[repr(C)]
#[derive(Clone, Copy, Debug, Default)]
pub struct WalkOutputs {
    /// Commanded joint angles, deg.
    pub angles: [[f64; JOINTS]; LEGS],
    /// Rates at which they change, deg/s.
    pub rates: [[f64; JOINTS]; LEGS],
}

/// The caller's structures as hardware.
#[derive(Default)]
struct Wires {
    sensors: WalkSensors,
    outputs: WalkOutputs,
}

impl Hardware<LEGS, JOINTS> for Wires {
    fn read(&mut self, into: &mut Sensors<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        into.angles = self.sensors.angles;
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<LEGS, JOINTS>) -> Result<(), HardwareFault> {
        for leg in 0..LEGS {
            for joint in 0..JOINTS {
                let JointCommand::Angle { angle, rate } = outputs.joints[leg][joint] else {
                    return Err(HardwareFault::new("no torques"));
                };
                self.outputs.angles[leg][joint] = angle;
                self.outputs.rates[leg][joint] = rate;
            }
        }
        Ok(())
    }

    /// Keeps the last commands.
    fn stop(&mut self, _why: &Fault) -> Result<(), HardwareFault> {
        Ok(())
    }
}

type Robot = Machine<Walk, Wires, (), (), LEGS, JOINTS>;

static ROBOT: Mutex<Option<Robot>> = Mutex::new(None);

/// Starts the program anew, and gives the initial posture; returns the sampling time, ms.
#[allow(unsafe_code, reason = "the name is exported")]
#[unsafe(no_mangle)]
pub extern "C" fn walk_start(outputs: &mut WalkOutputs) -> f64 {
    outputs.angles = MODEL.legs.map(|leg| leg.initial);
    outputs.rates = Default::default();
    let robot = Machine::new(Walk::new(), &MODEL, Wires::default(), (), ()).ok();
    let period = robot.as_ref().map_or(0.0, Machine::period);
    *ROBOT.lock().unwrap_or_else(PoisonError::into_inner) = robot;
    period
}

/// Runs one control cycle; returns 0 while the program runs, 1 after its end, 2 in an emergency, 3 if it was not started.
#[allow(unsafe_code, reason = "the name is exported")]
#[unsafe(no_mangle)]
pub extern "C" fn walk_cycle(sensors: &WalkSensors, outputs: &mut WalkOutputs) -> i32 {
    let mut robot = ROBOT.lock().unwrap_or_else(PoisonError::into_inner);
    let Some(robot) = robot.as_mut() else {
        return 3;
    };
    robot.hardware_mut().sensors = *sensors;
    let status = robot.cycle();
    *outputs = robot.hardware().outputs;
    match status {
        Status::Running => 0,
        Status::Finished(_) => 1,
        Status::Emergency => 2,
    }
}
