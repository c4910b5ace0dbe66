//! `tip run --trace-motion`: what the simulated robot did, cycle by cycle.

use crate::support::Folder;
use serde_json::Value;

const TOPPLES: &str = "STAND_UP 60
WAIT_INPOS ALL
SLEEP 500
REL_PTP F1 0 0 60
REL_PTP F2 0 0 60
WAIT_INPOS ALL
RETURN
END";

fn list(value: &Value) -> Vec<f64> {
    let values = value.as_array().expect("an array").iter();
    values
        .map(|value| value.as_f64().expect("a number"))
        .collect()
}

/// Keys in the order in which they are written.
fn keys(line: &str) -> Vec<&str> {
    ["state", "pose", "angles", "loads", "margin", "falls"]
        .into_iter()
        .filter(|key| line.contains(&format!("\"{key}\":")))
        .collect()
}

#[test]
fn motion_ends_each_record_and_changes_nothing_before_it() {
    let folder = Folder::new("motion-keys").program("p.prg", TOPPLES);
    let run = ["run", "p.prg", "--trace", "-", "--trace-state"];
    let without = folder.tip(&run).expect(3);
    let with = folder
        .tip(&[&run[..], &["--trace-motion"]].concat())
        .expect(3);
    assert_eq!(with.lines().len(), without.lines().len());
    let (ends, records) = (without.lines().len() - 1, without.lines());
    for (with, without) in with.lines().iter().zip(&records[..ends]) {
        let open = without.strip_suffix('}').expect("an object");
        let rest = with.strip_prefix(open).expect("the same record");
        let places = ["pose", "angles", "loads", "margin", "falls"]
            .map(|key| rest.find(&format!(",\"{key}\":")).expect(key));
        assert!(places[0] == 0 && places.is_sorted(), "{rest}");
    }
    assert_eq!(with.lines()[ends], records[ends]);
}

#[test]
fn the_figures_are_those_of_the_robot() {
    let folder = Folder::new("motion-figures").program("p.prg", TOPPLES);
    let run = ["run", "p.prg", "--trace", "-", "--trace-motion"];
    let outcome = folder.tip(&run).expect(3);
    let lines = outcome.lines();
    let records: Vec<Value> = (lines[..lines.len() - 1].iter())
        .map(|line| serde_json::from_str(line).expect("JSON"))
        .collect();
    // It stands on four feet when the first one is lifted.
    let standing = records.iter().rposition(|record| record["step"] == 2);
    let standing = &records[standing.expect("it sleeps")];
    let pose = list(&standing["pose"]);
    assert_eq!(pose.len(), 6);
    assert!(
        pose[0].abs() < 1.0
            && pose[1].abs() < 1.0
            && pose[3..].iter().all(|angle| angle.abs() < 0.5)
    );
    let weight: f64 = list(&standing["loads"]).iter().sum();
    assert!((weight - 20.0 * 9.80665).abs() < 0.1, "{weight}");
    assert!((standing["margin"].as_f64().expect("mm") - 201.0).abs() < 1.0);
    let legs = standing["angles"].as_array().expect("legs");
    assert!(legs.len() == 4 && legs.iter().all(|leg| list(leg).len() == 3));
    // Falls are counted, and the cycle of the first is that of the warning.
    let first = records.iter().position(|record| record["falls"] == 1);
    let first = first.expect("it falls");
    assert!(records[..first].iter().all(|record| record["falls"] == 0));
    assert!(records[first]["margin"].as_f64().expect("mm") < 0.0);
    let warning = format!("s, in cycle {first}: ");
    assert!(outcome.err.contains(&warning), "{outcome:#?}");
}

#[test]
fn a_robot_without_a_body_has_no_pose() {
    let bolted = "name = \"bolted\"\njoint = [{ axis = \"y\", link = [0, 0, -100], limits = [-90, 90] }]\nleg = [{ base = [0, 0, 0] }]\n";
    let folder = Folder::new("motion-bolted")
        .program("p.prg", "SLEEP 100\nEND")
        .file("bolted.toml", bolted);
    for (robot, angles, known) in [
        ("hand", 3, &["angles", "loads"][..]),
        ("bolted.toml", 1, &["angles"]),
    ] {
        let run = [
            "run",
            "p.prg",
            "--robot",
            robot,
            "--trace",
            "-",
            "--trace-motion",
        ];
        let outcome = folder.tip(&run).expect(0);
        assert_eq!(keys(outcome.lines()[0]), known, "{robot}");
        let record: Value = serde_json::from_str(outcome.lines()[0]).expect("JSON");
        assert_eq!(record["angles"].as_array().map(Vec::len), Some(angles));
        let loads = record.get("loads").map(list);
        assert_eq!(loads, (robot == "hand").then(|| vec![0.0; angles]));
    }
}
