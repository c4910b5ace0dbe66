//! TIP.OBJ on robots whose legs have other numbers of joints than three.

use tip_lint::{listing, load};
use tip_runtime::model::{Joint, Leg, Model};
use tipc::{Facts, Options, Robot};

/// Returns a robot of one leg.
fn robot<const J: usize>() -> Robot {
    let joint = Joint::revolute([1.0, 0.0, 0.0], [0.0, 0.0, 10.0]);
    let model = Model::generic("chain", [Leg::at([0.0; 3], [joint; J])]);
    Robot::Described(Facts::copied(&model))
}

/// Returns what follows `=` in the first record that is not an equation.
fn fields(robot: Robot, statement: &str) -> Vec<String> {
    let options = Options {
        robot,
        ..Options::default()
    };
    let text = format!("3.1\ntitle\nDEF_JOINT Q\n{statement}\nQ.J1 = 1\nEND\n");
    let loaded = load("p.prg", text.as_bytes(), &options);
    let program = loaded.program.as_ref();
    let program = program.unwrap_or_else(|| panic!("{:#?}", loaded.diagnostics));
    let text = listing::object(&loaded.source, &loaded.module, program);
    let record = text
        .lines()
        .skip(1)
        .take_while(|line| !line.starts_with('['));
    let value = |line: &str| line.split_once(" = ").expect("a field").1.to_owned();
    record.map(value).collect()
}

/// Returns the types and values of arguments, as many as there are slots.
fn slots(arguments: &[(&str, f64)], count: usize) -> Vec<String> {
    let none = std::iter::repeat(&("ARG_NONE", 0.0));
    let all: Vec<_> = arguments.iter().chain(none).take(count).collect();
    let kinds = all.iter().map(|(kind, _)| (*kind).to_owned());
    let values = all.iter().map(|(_, value)| format!("{value:.6}"));
    kinds.chain(values).collect()
}

// clauses: 9.4
#[test]
fn more_than_five_joints_take_a_slot_each() {
    let record = fields(robot::<9>(), "PTP_ANGLE F1 1 2 3 4 R 5 6 7 8 9");
    let mut arguments = [("CONSTANT", 0.0); 9];
    for (number, argument) in (1..).zip(&mut arguments) {
        argument.1 = f64::from(number);
    }
    arguments[4].0 = "REL_CONSTANT";
    assert_eq!(record[..2], ["PTP_ANGLE", "TARGET_F1"]);
    assert_eq!(record[2..], slots(&arguments, 9));
    let record = fields(robot::<6>(), "OMEGA_CONTROL J16 5");
    assert_eq!(record[..2], ["OMEGA_CONTROL", "TARGET_J16"]);
    assert_eq!(record[2..], slots(&[("CONSTANT", 5.0)], 6));
}

// clauses: 9.4
#[test]
fn a_joint_variable_is_one_argument_whatever_it_has() {
    let record = fields(robot::<9>(), "PTP_ANGLE F1 Q");
    assert_eq!(record[2..], slots(&[("JNT", 0.0)], 9));
    let record = fields(robot::<9>(), "PTP_ANGLE J19 Q.J9");
    assert_eq!(record[2..], slots(&[("JNT_9", 0.0)], 9));
}

// clauses: 9.4
#[test]
fn fewer_joints_leave_five_slots() {
    let record = fields(robot::<1>(), "PTP_ANGLE F1 10");
    assert_eq!(record[2..], slots(&[("CONSTANT", 10.0)], 5));
    let record = fields(robot::<2>(), "PTP_ANGLE F1 10 20");
    assert_eq!(
        record[2..],
        slots(&[("CONSTANT", 10.0), ("CONSTANT", 20.0)], 5)
    );
}
