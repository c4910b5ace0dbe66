//! Programs on the interpreter: whatever they do, every command is a number within the robot's limits, and so is what
//! the joints of a robot with mass do.

use tip_runtime::command::Port;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use tip_runtime::model::{generic, hand, titan8};
use tip_runtime::plant::{DynamicPlant, Plant, SimulatedHand, SimulatedPlant};
use tip_runtime::special::hand::HandSpecials;
use tip_sim::{Interpreter, Limit, Robot, Run};
use tipc::load;

/// Number of cycles of a program, and its events.
const LIMIT: Limit = Limit::cycles(200);
const EVENTS: &str = "3:key A, 10:key 1, 40:key 0x20, 90:key 0x0D, 150:halt";
/// The same for robots with mass, which take a hundred times as long.
const HEAVY_LIMIT: Limit = Limit::cycles(40);

/// Runs the bytes on TITAN VIII and on the hand; with mass on TITAN VIII and on the generic robot, which takes torques.
///
/// # Panics
/// A command, or what is measured, is not a number.
pub fn examine(bytes: &[u8]) {
    let walker = Guarded(SimulatedPlant::new(&titan8::MODEL));
    run(bytes, Robot::on(&titan8::MODEL, walker), LIMIT);
    let hand = Robot::on(&hand::MODEL, Guarded(SimulatedHand::new(&hand::MODEL)));
    run(bytes, hand.with_special(HandSpecials::new()), LIMIT);
    for model in [&titan8::MODEL, &generic::MODEL] {
        let heavy = Guarded(DynamicPlant::new(model));
        run(bytes, Robot::on(model, heavy), HEAVY_LIMIT);
    }
}

fn run(bytes: &[u8], robot: Robot, limit: Limit) {
    let Some(program) = load("random.prg", bytes, &robot.options()).program else {
        return;
    };
    let run = Run::new(Interpreter::new(program), robot).expect("it was loaded for this robot");
    let mut run = run.events(EVENTS).expect("every robot has a keyboard");
    run.to_end(limit);
}

/// A robot that takes numbers only.
#[derive(Clone)]
struct Guarded<H>(H);

impl<H: Hardware<L, J>, const L: usize, const J: usize> Hardware<L, J> for Guarded<H> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        self.0.read(into)?;
        let mut numbers = into.angles.iter().chain(&into.torques).flatten();
        assert!(numbers.all(|number| number.is_finite()), "{into:?}");
        Ok(())
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        let joints = outputs.joints.iter().flatten().map(|joint| joint.value());
        let mut numbers = joints.chain(outputs.slider);
        assert!(numbers.all(f64::is_finite), "{outputs:?}");
        self.0.write(outputs)
    }

    fn stop(&mut self, why: &Fault) -> Result<(), HardwareFault> {
        self.0.stop(why)
    }
}

impl<H: Plant<L, J>, const L: usize, const J: usize> Plant<L, J> for Guarded<H> {
    fn has_input(&self, port: Port) -> bool {
        self.0.has_input(port)
    }

    fn set_sensor(&mut self, port: Port, volts: f64) -> bool {
        self.0.set_sensor(port, volts)
    }
}
