//! The summary of a run against an independent computation from its log, and `tip compare`.

use crate::support::Folder;
use serde_json::Value;

const WALK: &str = include_str!("../../../../tests/language/motions/walk.prg");
const GRASP: &str = include_str!("../../../../examples/grasp/motions/grasp.prg");
const SCENE: &str = include_str!("../../../../examples/grasp/scene.toml");

/// Two feet of one side are lifted.
const TOPPLES: &str = "3.1\ntopples\nSTAND_UP 60\nWAIT_INPOS ALL\nREL_PTP F1 0 0 60\nREL_PTP F2 0 0 60\nWAIT_INPOS ALL\nEND\n";
/// A standing foot is commanded to another place.
const SLIDES: &str = "3.1\nslides\nSTAND_UP 100\nWAIT_INPOS ALL\nREL_PTP F2 40 0 0\nWAIT_INPOS ALL\nSLEEP 200\nEND\n";

/// The log of a run: names of columns, and a row of numbers for each cycle.
struct Log {
    names: Vec<String>,
    rows: Vec<Vec<Option<f64>>>,
}

impl Log {
    fn of(text: &str) -> Self {
        let mut lines = text.lines();
        // The columns of these programs have no commas in them but those of messages, which are quoted.
        let cells = |line: &str| {
            let mut is_quoted = false;
            let split = line.split(move |char| {
                is_quoted ^= char == '"';
                char == ',' && !is_quoted
            });
            split.map(str::to_owned).collect::<Vec<_>>()
        };
        let names = cells(lines.next().expect("a head"));
        let numbers = |line| cells(line).iter().map(|cell| cell.parse().ok()).collect();
        Log {
            names,
            rows: lines.map(numbers).collect(),
        }
    }

    /// The places of the columns that end so.
    fn columns(&self, begins: &str, ends: &str) -> Vec<usize> {
        let names = self.names.iter().enumerate();
        let of = names.filter(|(_, name)| name.starts_with(begins) && name.ends_with(ends));
        of.map(|(at, _)| at).collect()
    }

    fn column(&self, name: &str) -> Vec<f64> {
        let at = self.names.iter().position(|other| other == name);
        let at = at.unwrap_or_else(|| panic!("no {name} in {:?}", self.names));
        self.rows
            .iter()
            .map(|row| row[at].expect("a number"))
            .collect()
    }

    /// The largest number of some columns.
    fn largest(&self, columns: &[usize]) -> f64 {
        let cells = self
            .rows
            .iter()
            .flat_map(|row| columns.iter().map(|at| row[*at]));
        cells
            .map(|cell| cell.expect("a number").abs())
            .fold(0.0, f64::max)
    }

    /// Times at the ends of cycles, s, and the differences between them.
    fn seconds(&self) -> Vec<f64> {
        self.column("time_ms")
            .iter()
            .map(|time| time / 1000.0)
            .collect()
    }
}

#[track_caller]
fn is_near(one: f64, other: f64, what: &str) {
    let error = (one - other).abs() / one.abs().max(1.0);
    assert!(error < 1e-6, "{what}: {one} is not {other}");
}

/// Checks each figure of a run against its log; returns summary and log.
fn judge(name: &str, program: &str, options: &[&str], status: i32) -> (Value, Log) {
    let folder = Folder::new(&format!("figures-{name}"))
        .file("p.prg", program)
        .file("scene.toml", SCENE);
    let arguments = |own: &[&'static str]| {
        let own = own.iter().copied();
        own.chain(options.iter().copied())
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    let tip = |arguments: Vec<String>| {
        let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
        folder.tip(&arguments)
    };
    let outcome = tip(arguments(&["run", "p.prg", "--format", "json"])).expect(status);
    let summary: Value = serde_json::from_str(&outcome.out).expect("one object");
    let log = Log::of(
        &tip(arguments(&["log", "p.prg", "-o", "-"]))
            .expect(status)
            .out,
    );
    let time = log.seconds();
    is_near(
        summary["time_s"].as_f64().expect("s"),
        time[time.len() - 1],
        "time",
    );
    assert_eq!(summary["cycles"], log.rows.len(), "{name}: cycles");
    let lines = log.column("line");
    // Where several moments have the same value but for rounding, the summary names one of them.
    let peak = |key: &str, value: f64, of_cycle: &dyn Fn(usize, &str) -> f64| {
        let peak = &summary[key];
        is_near(peak["value"].as_f64().expect(key), value, key);
        let cycle = peak["cycle"].as_u64().expect("a cycle") as usize;
        let of = peak["of"].as_str().expect("a name");
        is_near(
            of_cycle(cycle, of),
            value,
            &format!("{key} of {of} in cycle {cycle}"),
        );
        assert_eq!(peak["line"].as_f64(), Some(lines[cycle]), "{name}: {key}");
        let began = if cycle == 0 { 0.0 } else { time[cycle - 1] };
        is_near(peak["time_s"].as_f64().expect("s"), began, "time");
        // The terminal says the same.
        let shown = format!("{value:.1}");
        let figure = outcome
            .err
            .lines()
            .find(|line| line.trim_start().starts_with(key));
        let figure = figure.unwrap_or_else(|| panic!("{key} in {}", outcome.err));
        assert!(
            figure.contains(&shown) && (shown == "0.0" || figure.contains(of)),
            "{figure}"
        );
    };
    // Rates are differences of angles.
    let joints = log.columns("J", "_deg");
    let rate = |cycle: usize, joint: usize| {
        let [before, now] = [cycle - 1, cycle].map(|at| log.rows[at][joint].expect("deg"));
        (now - before).abs() / (time[cycle] - time[cycle - 1])
    };
    let mut largest = 0.0_f64;
    let mut work = 0.0;
    let unit = if log.columns("J", "_mNm").is_empty() {
        "_Nm"
    } else {
        "_mNm"
    };
    for cycle in 1..log.rows.len() {
        for joint in &joints {
            let [before, now] = [cycle - 1, cycle].map(|at| log.rows[at][*joint].expect("deg"));
            let turn = (now - before).abs();
            let name = log.names[*joint].replace("_deg", unit);
            let torque = log.names.iter().position(|other| *other == name);
            let torque = log.rows[cycle][torque.expect("a torque")].expect("a number");
            work += torque.abs() * turn.to_radians();
            largest = largest.max(rate(cycle, *joint));
        }
    }
    let place = |name: String| {
        log.names
            .iter()
            .position(|other| *other == name)
            .expect("a column")
    };
    let cell = |cycle: usize, name: String| log.rows[cycle][place(name)].expect("a number").abs();
    peak("rate", largest, &|cycle, of| {
        rate(cycle, place(format!("{of}_deg")))
    });
    let torque = log.largest(&log.columns("J", unit));
    peak("torque", torque, &|cycle, of| {
        cell(cycle, format!("{of}{unit}"))
    });
    if let Some(energy) = summary["energy"]["work_j"].as_f64() {
        let per_joule = if unit == "_mNm" { 1000.0 } else { 1.0 };
        is_near(energy, work / per_joule, "energy");
    }
    if summary["travel"].is_object() {
        let forward = *log.column("y_mm").last().expect("a row");
        let travel = &summary["travel"];
        is_near(
            travel["forward_mm"].as_f64().expect("mm"),
            forward,
            "forward",
        );
        let speed = forward / time[time.len() - 1];
        is_near(travel["speed_mm_s"].as_f64().expect("mm/s"), speed, "speed");
        let slip = log.largest(&log.columns("F", "_slip_mm"));
        if slip > 0.0 {
            peak("slip", slip, &|cycle, of| {
                cell(cycle, format!("{of}_slip_mm"))
            });
        }
        // The posture before the first cycle counts as well: nothing later is less than the least.
        let margins = log.column("margin_mm");
        let least = margins.iter().copied().fold(f64::INFINITY, f64::min);
        let margin = summary["margin"]["value"].as_f64().expect("mm");
        assert!(margin <= least + 1e-9, "{name}: {margin} {least}");
        if summary["margin"]["cycle"] != 0 {
            is_near(margin, least, "margin");
            let cycle = margins.iter().position(|margin| *margin == least);
            assert_eq!(
                summary["margin"]["cycle"].as_u64(),
                cycle.map(|at| at as u64)
            );
        }
        let falls = log.column("falls");
        assert_eq!(summary["falls"]["count"].as_f64(), falls.last().copied());
        let first = falls.iter().position(|falls| *falls > 0.0);
        assert_eq!(
            summary["falls"]["first"]["cycle"].as_u64(),
            first.map(|at| at as u64)
        );
    }
    (summary, log)
}

/// The slip of a foot is its distance from where it touched down, as the places of feet in the log show.
fn measured_slip(log: &Log, foot: usize) -> Vec<f64> {
    let [x, y, load] = ["x_mm", "y_mm", "N"].map(|of| log.column(&format!("F{foot}_{of}")));
    let mut from: Option<(f64, f64)> = None;
    let slips = (0..x.len()).map(|cycle| {
        if load[cycle] <= 0.0 {
            from = None;
            return 0.0;
        }
        let (u, v) = *from.get_or_insert((x[cycle], y[cycle]));
        (x[cycle] - u).hypot(y[cycle] - v)
    });
    slips.collect()
}

#[test]
fn the_figures_of_a_walk_are_those_of_its_log() {
    let (summary, _) = judge("walk", WALK, &["--cycles", "900"], 0);
    assert_eq!(summary["end"], "LIMIT");
    assert_eq!(summary["falls"]["count"], 0);
    // A walk waits for its feet, for no longer than a step takes.
    let waits = summary["waits"].as_array().expect("waits");
    assert!(!waits.is_empty() && waits.len() <= 3);
    assert!(
        waits
            .iter()
            .all(|wait| wait["length_s"].as_f64().is_some_and(|time| time < 10.0))
    );
}

#[test]
fn the_figures_of_a_walk_with_mass_are_those_of_its_log() {
    let (summary, _) = judge("mass", WALK, &["--cycles", "300", "--plant", "dynamic"], 0);
    assert!(
        summary["energy"]["work_j"]
            .as_f64()
            .is_some_and(|work| work > 0.0)
    );
}

#[test]
fn the_figures_of_a_grasp_are_those_of_its_log() {
    let options = ["--robot", "hand", "--scene", "scene.toml"];
    let (summary, log) = judge("grasp", GRASP, &options, 0);
    for (finger, force) in (1..).zip(summary["forces"].as_array().expect("forces")) {
        let forces = log.column(&format!("F{finger}_N"));
        let greatest = forces.iter().copied().fold(0.0, f64::max);
        is_near(force["value"].as_f64().expect("N"), greatest, "force");
        let cycle = forces
            .iter()
            .position(|force| *force == greatest)
            .expect("a cycle");
        assert_eq!(force["cycle"], cycle, "F{finger}");
    }
    assert!(
        summary["lifts"][0]["value"]
            .as_f64()
            .is_some_and(|lift| lift > 25.0)
    );
}

#[test]
fn the_figures_of_a_fall_are_those_of_its_log() {
    let (summary, _) = judge("fall", TOPPLES, &[], 0);
    assert_eq!(summary["falls"]["first_kind"], "would-fall");
    assert_eq!(summary["falls"]["first"]["line"], 7);
    assert!(
        summary["margin"]["value"]
            .as_f64()
            .is_some_and(|margin| margin < 0.0)
    );
}

#[test]
fn the_slip_of_a_foot_is_its_distance_from_its_touchdown() {
    let (summary, log) = judge("slip", SLIDES, &[], 0);
    assert!(
        summary["slip"]["value"]
            .as_f64()
            .is_some_and(|slip| slip > 5.0)
    );
    for foot in 1..=4 {
        let slips = log.column(&format!("F{foot}_slip_mm"));
        for (cycle, (slip, measured)) in slips.iter().zip(measured_slip(&log, foot)).enumerate() {
            // The robot stands before the first cycle of the log.
            assert!(
                (slip - measured).abs() < 1e-3,
                "F{foot} in cycle {cycle}: {slip} {measured}"
            );
        }
    }
    judge("slip-mass", SLIDES, &["--plant", "dynamic"], 0);
}

#[test]
fn messages_are_not_mixed_with_json() {
    let folder = Folder::new("figures-json").program("p.prg", "MESSAGE hello\nEND");
    let outcome = folder
        .tip(&["run", "p.prg", "--format", "json", "-q"])
        .expect(0);
    assert_eq!(outcome.lines().len(), 1);
    assert!(outcome.err.is_empty(), "{}", outcome.err);
    let both = ["run", "p.prg", "--format", "json", "--trace", "-"];
    let outcome = folder.tip(&both).expect(2);
    assert!(
        outcome.err.contains("give the trace a file"),
        "{}",
        outcome.err
    );
    assert!(outcome.out.is_empty());
}

#[test]
fn two_runs_are_compared_figure_by_figure() {
    let folder = Folder::new("figures-compare")
        .file("a.prg", SLIDES.replace("40 0 0", "10 0 0"))
        .file("b.prg", SLIDES);
    let outcome = folder
        .tip(&["compare", "a.prg", "b.prg", "--lang", "en"])
        .expect(0);
    let row = |name: &str| {
        let found = outcome.out.lines().find(|line| line.starts_with(name));
        found
            .unwrap_or_else(|| panic!("{name} in {}", outcome.out))
            .to_owned()
    };
    assert!(
        row("slip").ends_with("worse (less is better)"),
        "{}",
        outcome.out
    );
    assert!(row("falls").ends_with(" 0"), "{}", outcome.out);
    // Its unit is that of `tip run`.
    let mass = ["compare", "a.prg", "b.prg", "--plant", "dynamic"];
    let mass = folder.tip(&mass).expect(0).out;
    let energy = mass.lines().find(|line| line.starts_with("energy"));
    assert!(
        energy.is_some_and(|row| row.matches(" J").count() == 2),
        "{mass}"
    );
    let json = folder
        .tip(&["compare", "a.prg", "b.prg", "--format", "json"])
        .expect(0);
    let report: Value = serde_json::from_str(&json.out).expect("one object");
    let figures = report["figures"].as_array().expect("figures");
    let slip = figures
        .iter()
        .find(|row| row["name"] == "slip")
        .expect("slip");
    let number = |of: &str| slip[of].as_f64().expect("mm");
    is_near(
        number("difference"),
        number("other") - number("one"),
        "difference",
    );
    assert_eq!(slip["better"], "less");
    // The programs differ in one line. The diff has its number.
    let diff = outcome.out.split_once("\n\n").expect("a difference").1;
    let lines: Vec<&str> = diff.lines().collect();
    assert_eq!(lines[..2], ["--- a.prg", "+++ b.prg"], "{diff}");
    let place = SLIDES.lines().position(|line| line.contains("40 0 0"));
    let number = place.expect("the line") + 1;
    assert_eq!(lines[2], format!("@@ -{number} +{number} @@"));
    assert!(
        lines[3].starts_with('-') && lines[3].contains("10 0 0"),
        "{diff}"
    );
    assert!(
        lines[4].starts_with('+') && lines[4].contains("40 0 0"),
        "{diff}"
    );
    assert_eq!(lines.len(), 5, "{diff}");
    assert_eq!(report["diff"], diff);
    let same = folder.tip(&["compare", "a.prg", "a.prg"]).expect(0);
    assert!(!same.out.contains("\n\n"), "{}", same.out);
    // Each run is the one that `tip run` makes.
    for (place, file) in ["a.prg", "b.prg"].into_iter().enumerate() {
        let alone = folder.tip(&["run", file, "--format", "json"]).expect(0);
        let alone: Value = serde_json::from_str(&alone.out).expect("one object");
        for key in [
            "travel", "slip", "margin", "rate", "torque", "falls", "waits",
        ] {
            assert_eq!(report["runs"][place][key], alone[key], "{file}: {key}");
        }
    }
}

#[test]
fn a_condition_on_the_second_run_has_an_exit_status() {
    let folder = Folder::new("figures-fail")
        .file("a.prg", SLIDES)
        .file("b.prg", SLIDES);
    let compare = |condition: &str| {
        folder.tip(&[
            "compare",
            "a.prg",
            "b.prg",
            "--fail-if",
            condition,
            "--lang",
            "en",
        ])
    };
    let outcome = compare("slip>5").expect(4);
    assert_eq!(outcome.err, "the second run has slip>5\n");
    compare("slip<5").expect(0);
    compare("falls>=1").expect(0);
    compare("falls<=0").expect(4);
    compare("falls = 0").expect(4);
    for wrong in ["slip", "sleep<5", "slip<much", "slip<nan", "<5", "slip<>5"] {
        let outcome = compare(wrong).expect(2);
        assert!(
            outcome.err.contains("is not a condition"),
            "{}",
            outcome.err
        );
    }
    // Without mass there is no energy: that is no success.
    let outcome = compare("energy>5").expect(2);
    assert!(
        outcome.err.contains("no figure `energy`"),
        "{}",
        outcome.err
    );
}

#[test]
fn traces_are_compared_too() {
    let folder = Folder::new("figures-traces")
        .file("a.prg", SLIDES)
        .file("b.prg", TOPPLES);
    for file in ["a", "b"] {
        let (program, trace) = (format!("{file}.prg"), format!("{file}.jsonl"));
        folder
            .tip(&["run", &program, "--trace", &trace, "--trace-motion", "-q"])
            .expect(0);
    }
    let report = |files: [&str; 2]| {
        let outcome = folder.tip(&[&["compare"], &files[..], &["--format", "json"]].concat());
        serde_json::from_str::<Value>(&outcome.expect(0).out).expect("one object")
    };
    let (programs, traces) = (report(["a.prg", "b.prg"]), report(["a.jsonl", "b.jsonl"]));
    for place in 0..2 {
        let [run, trace] = [&programs, &traces].map(|report| &report["runs"][place]);
        // A trace has neither torques nor waits, and its travel begins after its first cycle.
        for key in ["slip", "rate"] {
            let number = |of: &Value| of[key]["value"].as_f64().expect("a number");
            // The robot stands before the first cycle of the trace.
            assert!(
                (number(run) - number(trace)).abs() < 1e-3,
                "{key}: {run} {trace}"
            );
            assert_eq!(run[key]["cycle"], trace[key]["cycle"], "{key}");
        }
        assert_eq!(run["falls"]["count"], trace["falls"]["count"]);
        assert_eq!(trace["torque"], Value::Null);
    }
}
