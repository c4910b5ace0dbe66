//! The program on the bus: targets against measurements, and what a broken bus does.

use custom_hardware::Feet;
use custom_hardware::bus::ServoBus;
use custom_hardware::description::{Description, JOINTS, LEGS};
use custom_hardware::link::MemoryLink;
use custom_hardware::record::Recorded;
use custom_hardware::workshop::bench;
use tip_runtime::command::Target;
use tip_runtime::fault::Fault;
use tip_runtime::machine::{Machine, Status};
use tip_runtime::model::Model;
use tip_runtime::program::End;

type Robot<'a> = Recorded<ServoBus<MemoryLink>, &'a mut Vec<u8>>;
type Loop<'a> = Machine<Feet, Robot<'a>, (), (), LEGS, JOINTS>;

fn description() -> Description {
    Description::parse(include_str!("../../robot.toml")).unwrap()
}

fn ready<'a>(
    model: &'a Model<LEGS, JOINTS>,
    description: &Description,
    table: &'a mut Vec<u8>,
) -> Loop<'a> {
    let robot = Recorded::new(bench(description, model), table).unwrap();
    Machine::new(Feet::new(), model, robot, (), ()).unwrap()
}

fn rows(table: &[u8]) -> Vec<Vec<f64>> {
    let text = std::str::from_utf8(table).unwrap();
    let numbers = |line: &str| line.split(',').map(|word| word.parse().unwrap()).collect();
    text.lines().skip(1).map(numbers).collect()
}

#[test]
fn the_table_has_a_row_for_each_cycle_and_a_pair_for_each_joint() {
    let (description, mut table) = (description(), Vec::new());
    let model = description.model();
    let mut machine = ready(&model, &description, &mut table);
    while machine.cycle().is_running() {}
    assert_eq!(machine.status(), Status::Finished(End::End));
    let cycles = machine.cycles() as usize;
    drop(machine);
    let header = std::str::from_utf8(&table).unwrap().lines().next().unwrap();
    assert!(header.starts_with("time_ms,J11_target,J11_measured,J12_target"));
    assert!(header.ends_with(",J43_target,J43_measured"));
    let rows = rows(&table);
    assert_eq!(rows.len(), cycles);
    assert!(rows.iter().all(|row| row.len() == 1 + 2 * LEGS * JOINTS));
    assert_eq!(rows[1][0] - rows[0][0], 20.0);
}

#[test]
fn measurements_follow_targets_and_arrive() {
    let (description, mut table) = (description(), Vec::new());
    let model = description.model();
    let mut machine = ready(&model, &description, &mut table);
    while machine.cycle().is_running() {}
    drop(machine);
    let rows = rows(&table);
    let farthest = |row: &Vec<f64>| {
        row[1..]
            .chunks(2)
            .map(|pair| (pair[0] - pair[1]).abs())
            .fold(0.0, f64::max)
    };
    let lag = rows.iter().map(farthest).fold(0.0, f64::max);
    assert!((0.5..15.0).contains(&lag), "servos lag by {lag} deg");
    // A count of the encoder is 0.09 deg.
    assert!(farthest(rows.last().unwrap()) < 0.5);
    let knee = rows.iter().map(|row| row[5]).fold(0.0, f64::max);
    // A foot 30 mm higher bends the knee from 90 to 96.6 deg.
    assert!((95.0..97.5).contains(&knee), "J13 reached {knee} deg");
}

#[test]
fn signs_and_offsets_do_not_reach_the_program() {
    let mut plain = description();
    for joint in plain.joints.iter_mut().flatten() {
        (joint.sign, joint.offset) = (1, 0.0);
    }
    let run = |description: &Description| {
        let (model, mut table) = (description.model(), Vec::new());
        let mut machine = ready(&model, description, &mut table);
        while machine.cycle().is_running() {}
        drop(machine);
        rows(&table)
    };
    for (ours, theirs) in run(&description()).iter().zip(&run(&plain)) {
        for (a, b) in ours.iter().zip(theirs) {
            // What differs is the rounding to counts, and the cycle in which a wait ends.
            assert!((a - b).abs() < 3.0, "{a} against {b}");
        }
    }
}

#[test]
fn a_servo_that_falls_silent_is_an_emergency_stop() {
    let (description, mut table) = (description(), Vec::new());
    let model = description.model();
    let mut machine = ready(&model, &description, &mut table);
    for _ in 0..10 {
        assert!(machine.cycle().is_running());
    }
    machine.hardware_mut().inner_mut().link_mut().unplug(32);
    assert_eq!(machine.cycle(), Status::Emergency);
    let emergency = machine.emergency().unwrap();
    assert_eq!(emergency.fault, Fault::Hardware("servo bus: no answer"));
    let held: Vec<f64> = machine
        .hardware_mut()
        .inner_mut()
        .link()
        .servos()
        .iter()
        .map(|servo| servo.position())
        .collect();
    for _ in 0..5 {
        machine.cycle();
    }
    let later = machine
        .hardware_mut()
        .inner_mut()
        .link()
        .servos()
        .iter()
        .map(|servo| servo.position());
    assert_eq!(
        held,
        later.collect::<Vec<_>>(),
        "every servo holds where it is"
    );
}

#[test]
fn a_target_beyond_the_limits_of_the_description_is_out_of_reach() {
    let text = include_str!("../../robot.toml").replacen(
        "limits = [5.0, 150.0]",
        "limits = [5.0, 91.0]",
        1,
    );
    let description = Description::parse(&text).unwrap();
    let (model, mut table) = (description.model(), Vec::new());
    let mut machine = ready(&model, &description, &mut table);
    while machine.cycle().is_running() {}
    let fault = machine.emergency().map(|emergency| emergency.fault);
    assert_eq!(fault, Some(Fault::OutOfReach(Target::Foot(1))));
}
