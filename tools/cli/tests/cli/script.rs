//! `tip run`: keys, halt requests and sensors by the command line.

use crate::support::Folder;

/// The records of a run that begin to show something with these words.
fn records(folder: &Folder, arguments: &[&str], words: &str) -> Vec<String> {
    let all = [&["run", "p.prg", "--trace", "-"], arguments].concat();
    let outcome = folder.tip(&all).expect(0);
    let lines = outcome
        .lines()
        .into_iter()
        .filter(|line| line.contains(words));
    lines.map(str::to_owned).collect()
}

// clauses: 7.33 3.3
#[test]
fn a_key_arrives_before_the_step_of_its_cycle() {
    let folder = Folder::new("keys").program("p.prg", "KEY_IN\nMESSAGE %VAR_KEY%\nEND");
    let set = records(&folder, &["--keys", "3:a"], r#""set""#);
    assert_eq!(
        set,
        [r#"{"cycle":3,"step":0,"next":1,"set":{"VAR_KEY":65.0}}"#]
    );
    let set = records(&folder, &["--keys", "0:0x2C"], r#""set""#);
    assert_eq!(
        set,
        [r#"{"cycle":0,"step":0,"next":1,"set":{"VAR_KEY":44.0}}"#]
    );
}

// clauses: 7.33
#[test]
fn several_keys_of_a_cycle_keep_their_order() {
    let folder =
        Folder::new("keys-order").program("p.prg", "SLEEP 40\nKEY_IN\nMESSAGE %VAR_KEY%\nEND");
    let set = records(&folder, &["--keys", "1:x,0:z,1:y"], r#""set""#);
    assert_eq!(
        set,
        [r#"{"cycle":2,"step":1,"next":2,"set":{"VAR_KEY":90.0}}"#]
    );
}

// clauses: 5.1 2.23
#[test]
fn a_halt_is_requested_from_its_cycle_on() {
    let program = "L1:\nIF HALT_REQUEST GOTO L2:\nGOTO L1:\nL2:\nEND";
    let folder = Folder::new("halt").program("p.prg", program);
    // The condition runs in cycles 1, 4, 7 …: a request in cycle 4 is seen immediately, one in 5 by cycle 7.
    let seen = records(&folder, &["--halt", "4"], r#""next":3"#);
    assert_eq!(seen, [r#"{"cycle":4,"step":1,"next":3}"#]);
    let seen = records(&folder, &["--halt", "5"], r#""next":3"#);
    assert_eq!(seen, [r#"{"cycle":7,"step":1,"next":3}"#]);
    let seen = records(&folder, &["--keys", "5:0x1B"], r#""next":3"#);
    assert_eq!(seen, [r#"{"cycle":7,"step":1,"next":3}"#]);
}

// clauses: 2.23
#[test]
fn return_is_the_emergency_stop() {
    let folder = Folder::new("return").program("p.prg", "L1:\nGOTO L1:\nEND");
    let outcome = folder
        .tip(&["run", "p.prg", "--keys", "2:0x0D", "--trace", "-"])
        .expect(3);
    assert_eq!(
        outcome.lines().last(),
        Some(
            &r#"{"end":"EMERGENCY","error":"Emergency stop key","kind":"RobotError","step":0,"cycles":2}"#
        )
    );
}

// clauses: 7.32
#[test]
fn a_sensor_reads_its_value_from_its_cycle_on() {
    let program = "DEF_VAR A\nAD_IN VR1 A\nAD_IN VR1 A\nAD_IN VR1 A\nMESSAGE %A%\nEND";
    let folder = Folder::new("sensor").program("p.prg", program);
    let set = records(
        &folder,
        &["--sensor", "VR1=8@1", "--sensor", "VR1=2.5@2"],
        r#""set""#,
    );
    assert_eq!(
        set,
        [
            r#"{"cycle":0,"step":0,"next":1,"set":{"A":0.0}}"#,
            r#"{"cycle":1,"step":1,"next":2,"set":{"A":8.0}}"#,
            r#"{"cycle":2,"step":2,"next":3,"set":{"A":2.5}}"#,
        ]
    );
}

#[test]
fn what_makes_no_sense_is_wrong_usage() {
    let folder = Folder::new("script-usage").program("p.prg", "END");
    for wrong in [
        ["--keys", "a"],
        ["--keys", "1:ab"],
        ["--halt", "-1"],
        ["--sensor", "VR9=1@1"],
        ["--sensor", "VR1=1"],
        ["--sensor", "J91=1@1"],
        ["--cycles", "many"],
    ] {
        let outcome = folder.tip(&["run", "p.prg", wrong[0], wrong[1]]).expect(2);
        let value = wrong[1].split('=').next().unwrap_or_default();
        let names_it = outcome.err.contains(value) && !outcome.err.contains("unexpected");
        assert!(names_it, "{}", outcome.err);
    }
}
