//! One run into which a fault breaks.

use crate::defect::Defect;
use crate::faulty::{Desk, Faulty};
use tip_runtime::fault::Fault;
use tip_runtime::hardware::{Hardware, Outputs};
use tip_runtime::machine::{Machine, Status};
use tip_runtime::program::Program;
use tip_runtime::record::TitanLog;
use tip_runtime::special::Special;

pub(crate) type Bench<P, H, S, const L: usize, const J: usize> =
    Machine<P, Faulty<H, L, J>, L, J, Desk, S>;

/// Cycles after which a program that still runs waits for what never comes, and in which a robot whose
/// program is over comes to rest.
pub(crate) const PATIENCE: usize = 150;

/// Outcome of a run. Cycles count from that in which the fault occurred.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// Emergency stop.
    Stops { after: usize, fault: Fault },
    /// END, with the same commands to the last bit as without the fault, or with others.
    Ends { after: usize, same: bool },
    /// The program waits until it is stopped.
    Waits,
}

/// Lets `defect` break into a run whose commands would have been `healthy` from here on.
pub(crate) fn trial<P, H, S, const L: usize, const J: usize>(
    mut machine: Bench<P, H, S, L, J>,
    defect: Defect,
    healthy: &[Outputs<L, J>],
) -> Outcome
where
    P: Program,
    H: Hardware<L, J>,
    S: Special,
{
    break_in(&mut machine, defect);
    let mut same = true;
    for after in 0..healthy.len() + PATIENCE {
        if defect == Defect::KeyFlood {
            machine.console_mut().keys.extend([b'y'; 1000]);
        }
        let status = machine.cycle();
        if status == Status::Emergency {
            return stopped(machine, after);
        }
        same &= healthy.get(after) == Some(machine.outputs());
        if !status.is_running() {
            require_rest(machine, defect);
            return Outcome::Ends { after, same };
        }
    }
    machine.emergency_stop();
    assert_eq!(machine.cycle(), Status::Emergency, "{defect:?}");
    stopped(machine, 0);
    Outcome::Waits
}

fn break_in<P, H, S, const L: usize, const J: usize>(
    machine: &mut Bench<P, H, S, L, J>,
    defect: Defect,
) where
    P: Program,
    H: Hardware<L, J>,
    S: Special,
{
    machine.hardware_mut().defect = Some(defect);
    let keys = &mut machine.console_mut().keys;
    match defect {
        Defect::ReturnKey => keys.push_back(b'\r'),
        Defect::ReturnAfterKeys => {
            keys.extend([b'y'; 1000]);
            keys.push_back(b'\r');
        }
        Defect::Halt => keys.push_back(0x1B),
        Defect::LogFull => machine.console_mut().log = TitanLog::with_capacity(0),
        Defect::HostStop => machine.emergency_stop(),
        _ => {}
    }
}

/// Checks of every emergency stop: the robot is stopped in each cycle and receives no other command; it is
/// reported once; joints stay where they can.
fn stopped<P, H, S, const L: usize, const J: usize>(
    mut machine: Bench<P, H, S, L, J>,
    after: usize,
) -> Outcome
where
    P: Program,
    H: Hardware<L, J>,
    S: Special,
{
    let writes = machine.hardware().writes;
    for stops in 1..5 {
        assert_eq!(machine.hardware().stops, stops);
        assert_eq!(machine.cycle(), Status::Emergency);
    }
    assert_eq!(machine.hardware().writes, writes);
    let desk = machine.console();
    assert_eq!((desk.emergencies, desk.endings), (1, 1));
    let joints = machine
        .hardware()
        .model
        .legs
        .iter()
        .flat_map(|leg| &leg.joints);
    for (joint, told) in joints.zip(machine.controller().outputs().iter().flatten()) {
        assert!(joint.outer.contains(told.value()), "{told:?}");
    }
    let travel = machine.hardware().model.slider.map(|slider| slider.travel);
    let slider = machine.controller().slider();
    for (at, travel) in slider.iter().zip(travel.iter().flatten()) {
        assert!(travel.contains(*at), "the slider at {at}");
    }
    let fault = machine.emergency().expect("it was one").fault;
    Outcome::Stops { after, fault }
}

/// After the end of its program a robot comes to rest, and is stopped if something fails then.
fn require_rest<P, H, S, const L: usize, const J: usize>(
    mut machine: Bench<P, H, S, L, J>,
    defect: Defect,
) where
    P: Program,
    H: Hardware<L, J>,
    S: Special,
{
    let mut told = *machine.outputs();
    for _ in 0..PATIENCE {
        if machine.cycle() == Status::Emergency {
            stopped(machine, 0);
            return;
        }
        assert_ne!(defect, Defect::WriteError, "it fails after END too");
        if told == *machine.outputs() {
            return;
        }
        told = *machine.outputs();
    }
    panic!("{defect:?}: still in motion");
}
