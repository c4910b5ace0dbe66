//! The servo loop outlives the program, and a program can be started again.

use crate::list::List;
use tip_runtime::command::{Op, Port, Target};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, HardwareFault, JointCommand, Outputs, Sensors};
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::{hand, titan8};
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::realtime::run_realtime;

type Bench<H> = Machine<List<Vec<f64>>, H, (), (), 4, 3>;

fn bench<H: Hardware<4, 3>>(steps: &[(Op, Target, &[f64])], hardware: H) -> Bench<H> {
    let steps = steps
        .iter()
        .map(|(op, target, values)| (*op, *target, values.to_vec()));
    let program = List::new(steps.collect(), titan8::MODEL.signature());
    Machine::new(program, &titan8::MODEL, hardware, (), ()).expect("the same robot")
}

/// A robot that counts its calls; its sensors break in the fourth cycle if `breaks` is set.
struct Counter {
    breaks: bool,
    reads: u32,
    writes: u32,
    stops: u32,
}

impl Counter {
    const fn new(breaks: bool) -> Self {
        Counter {
            breaks,
            reads: 0,
            writes: 0,
            stops: 0,
        }
    }
}

impl Hardware<4, 3> for Counter {
    fn read(&mut self, into: &mut Sensors<4, 3>) -> Result<(), HardwareFault> {
        self.reads += 1;
        into.angles = titan8::MODEL.legs.map(|leg| leg.initial);
        if self.breaks && self.reads > 3 {
            return Err(HardwareFault::new("bus"));
        }
        Ok(())
    }

    fn write(&mut self, _: &Outputs<4, 3>) -> Result<(), HardwareFault> {
        self.writes += 1;
        Ok(())
    }

    fn stop(&mut self, _: &Fault) -> Result<(), HardwareFault> {
        self.stops += 1;
        Ok(())
    }
}

#[test]
fn readings_that_the_hardware_does_not_give_are_absent() {
    // It gives no soles.
    let search: (Op, Target, &[f64]) = (Op::DetectFloor, Target::All, &[2.0]);
    let mut machine = bench(&[search], Counter::new(false));
    while machine.cycle().is_running() {}
    let fault = machine.emergency().map(|emergency| emergency.fault);
    assert_eq!(fault, Some(Fault::Sensor(Port::Paw(1))));

    /// Fingers that give angles, and torques if `feels` is set.
    struct Fingers {
        feels: bool,
    }
    impl Hardware<3, 3> for Fingers {
        fn read(&mut self, into: &mut Sensors<3, 3>) -> Result<(), HardwareFault> {
            into.angles = hand::MODEL.legs.map(|leg| leg.initial);
            if self.feels {
                into.torques = [[0.0; 3]; 3];
            }
            Ok(())
        }
        fn write(&mut self, _: &Outputs<3, 3>) -> Result<(), HardwareFault> {
            Ok(())
        }
        fn stop(&mut self, _: &Fault) -> Result<(), HardwareFault> {
            Ok(())
        }
    }
    for (feels, expected) in [
        (false, Fault::JointSensor(1, 1)),
        (true, Fault::SliderSensor),
    ] {
        let program = List::new(
            Vec::<(Op, Target, Vec<f64>)>::new(),
            hand::MODEL.signature(),
        );
        let fingers = Fingers { feels };
        let machine = Machine::new(program, &hand::MODEL, fingers, (), ());
        let mut machine = machine.expect("the same robot");
        assert_eq!(machine.cycle(), Status::Emergency);
        assert_eq!(machine.emergency().map(|it| it.fault), Some(expected));
    }
}

const QUICK: (Op, Target, &[f64]) = (Op::SetSamplingTime, Target::None, &[1.0]);

/// Runs in real time until the program has been over for `cycles`.
fn run_on(machine: &mut Bench<Counter>, cycles: u32) -> Status {
    let mut left = cycles;
    let (status, pace) = run_realtime(machine, |status| {
        left -= u32::from(!status.is_running());
        left == 0
    });
    assert_eq!(
        pace.cycles(),
        u64::from(machine.hardware().writes + machine.hardware().stops)
    );
    status
}

#[test]
fn the_robot_is_held_after_the_end_until_the_loop_is_stopped() {
    let mut machine = bench(&[QUICK], Counter::new(false));
    assert!(matches!(run_on(&mut machine, 7), Status::Finished(_)));
    // One cycle of the command, then those that the program is over.
    let Counter { writes, stops, .. } = *machine.hardware();
    assert_eq!((writes, stops), (8, 0));
}

#[test]
fn the_robot_is_stopped_again_and_again_in_an_emergency() {
    let mut machine = bench(
        &[QUICK, (Op::Sleep, Target::None, &[1e6])],
        Counter::new(true),
    );
    assert_eq!(run_on(&mut machine, 5), Status::Emergency);
    let Counter { writes, stops, .. } = *machine.hardware();
    assert_eq!((writes, stops), (3, 5));
}

#[test]
fn a_restart_leaves_the_robot_where_it_is_and_forgets_what_steps_have_set() {
    let steps: [(Op, Target, &[f64]); 4] = [
        (Op::Sleep, Target::None, &[20.0]),
        (Op::SetSamplingTime, Target::None, &[10.0]),
        (Op::PtpAngle, Target::Joint(1, 1), &[20.0]),
        (Op::Sleep, Target::None, &[1e6]),
    ];
    let mut machine = bench(&steps, SimulatedPlant::new(&titan8::MODEL));
    for _ in 0..20 {
        assert!(machine.cycle().is_running());
    }
    let moved = machine.sensors().angles[0][0];
    assert!(moved > 1.0, "{moved}");
    assert_eq!(machine.period(), 10.0);
    machine.restart();
    assert_eq!(machine.period(), 20.0);
    assert!(machine.cycle().is_running());
    assert_eq!(machine.outputs().joints[0][0], JointCommand::at(moved));
    assert_eq!(machine.cycles(), 1);
}
