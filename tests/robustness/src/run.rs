//! Programs on the interpreter: whatever they do, every command is a number within the robot's limits.

use tip_runtime::console::Scripted;
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, Outputs, Sensors};
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::{Model, hand, titan8};
use tip_runtime::plant::{SimulatedHand, SimulatedPlant};
use tip_runtime::special::Special;
use tip_runtime::special::hand::HandSpecials;
use tip_sim::Interpreter;
use tipc::program::Program;
use tipc::{Options, Robot, load};

/// How many cycles a program gets, the number of the one with a halt request, and what is typed when.
const CYCLES: u64 = 200;
const HALT: u64 = 150;
const KEYS: [(u64, u8); 4] = [(3, b'A'), (10, b'1'), (40, b' '), (90, 0x0D)];

/// Runs the bytes on TITAN VIII and on the hand.
///
/// # Panics
/// A command is no number.
pub fn examine(bytes: &[u8]) {
    if let Some(program) = loaded(bytes, Robot::Titan8) {
        run(
            program,
            &titan8::MODEL,
            SimulatedPlant::new(&titan8::MODEL),
            (),
        );
    }
    if let Some(program) = loaded(bytes, Robot::Hand) {
        let special = HandSpecials::new();
        run(
            program,
            &hand::MODEL,
            SimulatedHand::new(&hand::MODEL),
            special,
        );
    }
}

fn loaded(bytes: &[u8], robot: Robot) -> Option<Program> {
    let options = Options {
        robot,
        ..Options::default()
    };
    load("random.prg", bytes, &options).program
}

fn run<const L: usize, const J: usize>(
    program: Program,
    model: &Model<L, J>,
    plant: impl Hardware<L, J>,
    special: impl Special,
) {
    let console = Scripted::new(KEYS.to_vec()).halt(HALT);
    let plant = Guarded(plant);
    let machine = Machine::new(Interpreter::new(program), model, plant, console, special);
    let mut machine = machine.expect("it was loaded for this robot");
    while machine.cycles() < CYCLES && machine.cycle() == Status::Running {}
}

/// A robot that takes numbers only.
struct Guarded<H>(H);

impl<H: Hardware<L, J>, const L: usize, const J: usize> Hardware<L, J> for Guarded<H> {
    fn read(&mut self, into: &mut Sensors<L, J>) -> Result<(), HardwareFault> {
        self.0.read(into)
    }

    fn write(&mut self, outputs: &Outputs<L, J>) -> Result<(), HardwareFault> {
        let joints = outputs.joints.iter().flatten().map(|joint| joint.value());
        let mut numbers = joints.chain(outputs.slider);
        assert!(numbers.all(f64::is_finite), "{outputs:?}");
        self.0.write(outputs)
    }

    fn stop(&mut self, why: &Fault) {
        self.0.stop(why);
    }
}
