//! The example of docs/robots.md, and programs that are checked for it.

use tip_runtime::model::{Inverse, Model};
use tipc::description::parse;
use tipc::{Options, load};

const HEXAPOD: &str = include_str!("../robots/hexapod.toml");

#[test]
fn the_example_is_a_hexapod() {
    let description = parse("hexapod.toml", HEXAPOD.as_bytes()).expect("it is sound");
    let model: Model<6, 3> = description.model().expect("six legs of three joints");
    assert_eq!(model.check(), Ok(()));
    assert_eq!(model.inverse, Inverse::YawPitchPitch);
    // F1 is the mirror image of F2: at the same angles its foot has the other x.
    let [left, right] = [0, 1].map(|leg| model.legs[leg].joints.map(|joint| joint.link));
    assert_eq!(left, right.map(|[x, y, z]| [-x, y, z]));
}

/// Returns each diagnostic about a program for the hexapod: `LINE: reason (help)`.
fn check(statements: &str) -> Vec<String> {
    check_for(HEXAPOD, statements)
}

fn check_for(description: &str, statements: &str) -> Vec<String> {
    let robot = parse("hexapod.toml", description.as_bytes())
        .expect("it is sound")
        .robot();
    let options = Options {
        robot,
        ..Options::default()
    };
    let program = format!("3.1\ntest\n{statements}\nEND\n");
    let loaded = load("test.prg", program.as_bytes(), &options);
    let reported = loaded.diagnostics.iter().map(|diagnostic| {
        let (line, _) = loaded.source.line_column(diagnostic.span.start);
        let help = diagnostic
            .help
            .as_ref()
            .map(ToString::to_string)
            .unwrap_or_default();
        format!("{line}: {} ({help})", diagnostic.reason)
    });
    reported.collect()
}

// clauses: 7.1
#[test]
fn a_program_has_the_legs_and_joints_of_the_description() {
    assert_eq!(check("PTP F6 100 -200 -80\nREL_PTP_ANGLE J63 5"), [""; 0]);
    assert_eq!(
        check("PTP F7 0 0 0"),
        ["3: hexapod has no F7 (hexapod has F1…F6, J11…J63)"]
    );
    assert_eq!(
        check("OMEGA_CONTROL J64 1"),
        ["3: hexapod has no J64 (hexapod has F1…F6, J11…J63)"]
    );
}

// clauses: 7.9 7.37
#[test]
fn a_robot_without_forces_has_no_commands_of_them() {
    assert_eq!(
        check("TORQUE J11 1"),
        [
            "3: hexapod has no TORQUE (TORQUE needs a robot that senses and gives torque: its description has no `[forces]`)"
        ]
    );
    assert_eq!(check("SILENT_ON"), [""; 0]);
    assert_eq!(
        check("STAND_UP 10"),
        [
            "3: hexapod has no STAND_UP (STAND_UP is a command of titan8, which `--robot` or tip.toml chooses)"
        ]
    );
}

// clauses: 7.36
#[test]
fn constants_are_judged_by_the_description() {
    assert_eq!(
        check("LAMP_ON 16"),
        ["3: out of range (LAMP_ON takes 0 to 15 on hexapod)"]
    );
}

// clauses: 7.31
#[test]
fn sampling_times_and_frequencies_are_those_of_the_description() {
    let description = format!("periods = [4, 40]\n{HEXAPOD}");
    let sound =
        "SET_SAMPLING_TIME 4\nSET_SAMPLING_TIME 40\nSET_SAMPLING_FREQ 25\nSET_SAMPLING_FREQ 250";
    assert_eq!(check_for(&description, sound), [""; 0]);
    let beyond =
        "SET_SAMPLING_TIME 3\nSET_SAMPLING_TIME 41\nSET_SAMPLING_FREQ 24\nSET_SAMPLING_FREQ 251";
    assert_eq!(
        check_for(&description, beyond),
        [
            "3: out of range (SET_SAMPLING_TIME takes 4 to 40 on hexapod)",
            "4: out of range (SET_SAMPLING_TIME takes 4 to 40 on hexapod)",
            "5: out of range (SET_SAMPLING_FREQ takes 25 to 250 on hexapod)",
            "6: out of range (SET_SAMPLING_FREQ takes 25 to 250 on hexapod)",
        ]
    );
}
