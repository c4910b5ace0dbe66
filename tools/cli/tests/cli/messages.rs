//! `tip run`: what it says on standard error while it runs and at its end.

use crate::support::{Folder, Outcome};

/// Stands, then lifts two feet, and lies down without them.
const TOPPLES: &str = "STAND_UP 60
WAIT_INPOS ALL
REL_PTP F1 0 0 60
REL_PTP F2 0 0 60
WAIT_INPOS ALL
MESSAGE still here";

/// The number in a line of the summary before some words.
#[track_caller]
fn number(text: &str, line: &str, before: &str) -> f64 {
    let line = text.lines().find_map(|own| own.trim().strip_prefix(line));
    let line = line.unwrap_or_else(|| panic!("no such line in {text}"));
    let (number, _) = line.split_once(before).expect(before);
    let word = number.split_whitespace().last().expect("a number");
    word.parse().expect("a number")
}

#[test]
fn a_run_says_how_and_where_it_ended() {
    let folder = Folder::new("speaks-endings")
        .program("end.prg", "REM\nEND")
        .program("exit.prg", "EXIT\nEND")
        .program("loop.prg", "L1:\nGOTO L1:\nEND")
        .program("bad.prg", "DEF_VAR A\nA = 0\nA = 1 / A\nEND");
    for (program, more, status, expected) in [
        (
            "end.prg",
            &[][..],
            0,
            "END at line 4 after 2 cycles, 0.040 s",
        ),
        ("exit.prg", &[], 0, "EXIT at line 3 after 1 cycle, 0.020 s"),
        (
            "loop.prg",
            &["--cycles", "5"],
            0,
            "--cycles used up at line 4 after 5 cycles, 0.100 s",
        ),
        (
            "bad.prg",
            &[],
            3,
            "emergency stop at line 5 after 1 cycle, 0.020 s",
        ),
    ] {
        let outcome = folder
            .tip(&[&["run", program], more].concat())
            .expect(status);
        let expected = format!("{program}: {expected} of robot time\n");
        assert!(outcome.err.contains(&expected), "{outcome:#?}");
    }
}

#[test]
fn a_run_that_is_cut_off_names_the_statement_that_is_next() {
    let folder = Folder::new("speaks-next")
        .program("loop.prg", "L1:\n  goto l1:  // again\nEND")
        .program("wait.prg", "PTP F1 -391 281 -160\nWAIT_INPOS F1\nEND")
        .program("key.prg", "SLEEP 100\nKEY_IN\nEND");
    for (program, cycles, expected) in [
        ("loop.prg", "5", "line 4: goto l1:"),
        (
            "wait.prg",
            "3",
            "line 4: WAIT_INPOS F1, which waits until F1 is within the JUST tolerance",
        ),
        (
            "key.prg",
            "2",
            "line 3: SLEEP 100, which waits until the time is over",
        ),
        (
            "key.prg",
            "9",
            "line 4: KEY_IN, which waits until a key is pressed",
        ),
    ] {
        let outcome = folder.tip(&["run", program, "--cycles", cycles]).expect(0);
        let line = format!("  next    {expected}");
        assert_eq!(
            outcome.err.lines().nth(1),
            Some(line.as_str()),
            "{outcome:#?}"
        );
    }
    let done = folder.tip(&["run", "key.prg", "--keys", "9:a"]).expect(0);
    assert!(!done.err.contains("next"), "{done:#?}");
}

#[test]
fn the_summary_speaks_japanese() {
    let folder = Folder::new("speaks-japanese").program("p.prg", "WAIT_INPOS ALL\nKEY_IN\nEND");
    let outcome = folder
        .tip(&["run", "p.prg", "--cycles", "3", "--lang", "ja"])
        .expect(0);
    let lines: Vec<&str> = outcome.err.lines().collect();
    let [margin, torque] = [lines[7], lines[8]];
    assert_eq!(
        lines[..7],
        [
            "p.prg: 4行目で--cyclesの周期数に到達(3周期、ロボットの時間で0.060 s)",
            "  次      4行目: KEY_IN (キーが押されるまで待ちます)",
            "  待機    4行目がキー入力を待っています(0.0 sから0.0 s間)",
            "  移動    胴体が前へ0.0 mm、右へ0.0 mm、上へ0.0 mm",
            "  旋回    左へ0.0度",
            "  転倒    なし",
            "  滑り    最大0.0 mm",
        ]
    );
    assert!(margin.starts_with("  余裕    最小"), "{margin}");
    assert!(torque.starts_with("  トルク  最大"), "{torque}");
    let checked = folder
        .tip(&["check", "p.prg", "p.prg", "--lang", "ja"])
        .expect(0);
    let lines: Vec<&str> = checked.err.lines().collect();
    let one = "p.prg: titan8用、3ステップ、警告0件";
    assert_eq!(lines, [one, one, "2ファイルの合計: エラー0件、警告0件"]);
}

/// A robot that has not moved yet: every figure is known.
#[test]
fn the_summary_of_a_robot_that_lies_still_is_this() {
    let folder = Folder::new("speaks-still").program("p.prg", "END");
    let outcome = folder.tip(&["run", "p.prg"]).expect(0);
    let margin = number(&outcome.err, "margin", " mm at least");
    let torque = number(&outcome.err, "torque", " of 40");
    let (summary, moment) = outcome.err.rsplit_once(" N·m at most, ").expect("a torque");
    // The belly carries the robot; the legs hang.
    assert!(
        moment.ends_with(" after 0.000 s (cycle 0, line 3)\n"),
        "{moment}"
    );
    assert_eq!(
        summary,
        format!(
            "p.prg: END at line 3 after 1 cycle, 0.020 s of robot time\n  \
             travel  0.0 mm forward, 0.0 mm to the right, 0.0 mm up\n  \
             turn    0.0 deg to the left\n  \
             falls   none\n  \
             slip    0.0 mm at most\n  \
             margin  {margin:.1} mm at least, after 0.000 s (cycle 0, line 3)\n  \
             torque  {torque:.1} of 40"
        )
    );
    assert!(margin > 0.0);
}

/// On a slope that is steeper than its friction, feet that stay where they are cannot be believed.
#[test]
fn the_summary_says_where_mass_would_have_mattered() {
    let slope = |rise: f64| format!("[floor]\nslope = [0, {rise}]\nfriction = 0.5\n");
    let folder = Folder::new("speaks-slope")
        .program("p.prg", "END")
        .file("steep.toml", slope(0.51))
        .file("gentle.toml", slope(0.49));
    let gentle = folder
        .tip(&["run", "p.prg", "--scene", "gentle.toml"])
        .expect(0);
    assert!(gentle.err.contains("\n  margin  "), "{gentle:#?}");
    assert!(!gentle.err.contains("grip") && !gentle.err.contains("note"));
    let steep = ["run", "p.prg", "--scene", "steep.toml"];
    let ends = [
        (
            "en",
            "  grip    the feet would slip in 1 cycle\n  note    dynamics matter here: --plant dynamic\n",
        ),
        (
            "ja",
            "  摩擦    1周期で足が滑るはず\n  注意    ここでは動力学が効きます: --plant dynamic\n",
        ),
    ];
    for (lang, end) in ends {
        let outcome = folder
            .tip(&[&steep[..], &["--lang", lang]].concat())
            .expect(0);
        assert!(outcome.err.ends_with(end), "{outcome:#?}");
    }
    let traced = folder
        .tip(&[&steep[..], &["--trace", "-", "--trace-motion"]].concat())
        .expect(0);
    let record = traced.lines()[0].to_owned();
    let (_, last) = record
        .split_once(r#","falls":0,"zmp":"#)
        .expect("after all else");
    assert!(last.ends_with(r#","slides":1}"#), "{last}");
}

#[test]
fn the_body_rises_by_as_much_as_the_feet_go_down() {
    let folder =
        Folder::new("speaks-rise").program("p.prg", "STAND_UP 60\nWAIT_INPOS ALL\nSLEEP 500\nEND");
    let outcome = folder.tip(&["run", "p.prg"]).expect(0);
    let up = number(&outcome.err, "travel", " mm up");
    assert!((up - 60.0).abs() < 2.0, "{outcome:#?}");
    // In the middle of feet that are 201 mm before and after it.
    let margin = number(&outcome.err, "margin", " mm at least");
    assert!((margin - 201.0).abs() < 3.0, "{outcome:#?}");
}

#[test]
fn a_fall_is_reported_with_its_time_and_source_line() {
    let folder = Folder::new("speaks-fall").program("p.prg", &format!("{TOPPLES}\nEND"));
    let outcome = folder.tip(&["run", "p.prg"]).expect(0);
    assert_eq!(outcome.out, "still here\n");
    let (warning, rest) = outcome.err.split_once('\n').expect("lines");
    let (before, cycle) = warning
        .split_once(" s, in cycle ")
        .expect("a time and a cycle");
    // Its body is upright then, and comes down to the floor later.
    let cycle = cycle
        .strip_suffix(": its feet do not hold its centre of mass")
        .expect("the reason");
    let time = before
        .strip_prefix("warning: the robot would fall after ")
        .expect("a warning");
    let (time, cycle): (f64, f64) = (time.parse().expect("s"), cycle.parse().expect("a cycle"));
    assert!((time - cycle * 0.02).abs() < 1e-9);
    let place = " --> p.prg:7:1\n  |\n7 | WAIT_INPOS ALL\n  |\np.prg: END at line 9 ";
    assert!(rest.starts_with(place), "{rest}");
    let falls = format!("  falls   1, the first after {time:.3} s at line 7\n");
    assert!(rest.contains(&falls), "{rest}");
    assert!(number(rest, "margin", " mm at least") < 0.0);
}

#[test]
fn a_body_that_stays_upright_would_fall_and_one_that_comes_down_falls() {
    let lifts = |by: u32| {
        format!(
            "STAND_UP 60\nWAIT_INPOS ALL\nREL_PTP F1 0 0 {by}\nREL_PTP F3 0 0 {by}\nSLEEP 3000\nEND"
        )
    };
    let folder = Folder::new("speaks-upright")
        .program("leans.prg", &lifts(80))
        .program("drops.prg", &lifts(120));
    let falls = |program, plant| {
        let all = [
            "run", program, "--plant", plant, "--quiet", "--deny", "falls",
        ];
        let status = folder.tip(&all).status;
        let shown = folder.tip(&all[..4]).expect(0).err;
        let line = shown.lines().find(|line| line.starts_with("  falls "));
        (status, line.expect("a line of falls").to_owned())
    };
    let (status, line) = falls("leans.prg", "quasi-static");
    assert_eq!(status, 4);
    assert!(
        line.starts_with("  falls   would fall: 1, the first after "),
        "{line}"
    );
    assert!(line.ends_with("; the body stays upright"), "{line}");
    // With mass it comes down on the feet that were lifted.
    let (status, line) = falls("leans.prg", "dynamic");
    assert_eq!(status, 4);
    assert!(line.starts_with("  falls   1, the first after "), "{line}");
    assert!(line.ends_with("; the body stays upright in 1"), "{line}");
    for plant in ["quasi-static", "dynamic"] {
        let (status, line) = falls("drops.prg", plant);
        assert_eq!(status, 4, "{plant}");
        assert!(line.starts_with("  falls   1, the first after "), "{line}");
        assert!(line.ends_with(" at line 7"), "{line}");
    }
}

#[test]
fn a_simulation_that_diverges_ends_and_leaves_a_trace_of_json() {
    let folder = Folder::new("speaks-diverges").program("p.prg", "STAND_UP 60\nSLEEP 3000\nEND");
    let outcome = folder
        .tip(&[
            "run",
            "p.prg",
            "--plant",
            "dynamic",
            "--trace",
            "-",
            "--trace-motion",
            "--events",
            "10:push 1e300 0 0 for 5",
        ])
        .expect(3);
    assert!(
        outcome.err.contains("the simulation diverged"),
        "{outcome:#?}"
    );
    let records = outcome
        .out
        .lines()
        .map(serde_json::from_str::<serde_json::Value>);
    let records: Vec<_> = records.map(|record| record.expect("JSON")).collect();
    let [.., last, end] = &records[..] else {
        panic!("{outcome:#?}")
    };
    assert_eq!(
        (&last["cycle"], &end["end"]),
        (&10.into(), &"EMERGENCY".into())
    );
    assert!(last["pose"][0].is_f64(), "{last}");
}

#[test]
fn a_denied_fall_is_status_4_unless_something_worse_happened() {
    let folder = Folder::new("speaks-deny")
        .program("falls.prg", &format!("{TOPPLES}\nEND"))
        .program("emergency.prg", &format!("{TOPPLES}\nRETURN\nEND"))
        .program("stands.prg", "STAND_UP 60\nWAIT_INPOS ALL\nEND");
    let run = |program, more: &[&str]| folder.tip(&[&["run", program], more].concat());
    let deny = ["--deny", "falls"];
    let fell = run("falls.prg", &deny).expect(4);
    // It runs to its end.
    assert_eq!(fell.out, "still here\n");
    assert!(
        fell.err.starts_with("error: the robot would fall after "),
        "{fell:#?}"
    );
    run("falls.prg", &[]).expect(0);
    run("emergency.prg", &deny).expect(3);
    run("stands.prg", &deny).expect(0);
    run("stands.prg", &["--deny", "rain"]).expect(2);
    // Before the fall nothing is denied.
    run("falls.prg", &["--deny", "falls", "--cycles", "3"]).expect(0);
}

#[cfg(unix)]
#[test]
fn an_interrupted_run_is_130_whatever_fell() {
    use std::process::{Command, Stdio};

    let text = format!("{TOPPLES}\nL:\nGOTO L:\nEND");
    let folder = Folder::new("speaks-interrupted").program("p.prg", &text);
    let mut child = folder
        .command(&["run", "p.prg", "--deny", "falls"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("tip starts");
    let mut first = [0; 5];
    let mut out = child.stdout.take().expect("piped");
    std::io::Read::read_exact(&mut out, &mut first).expect("the message");
    let killed = Command::new("kill")
        .args(["-INT", &child.id().to_string()])
        .status();
    assert!(killed.expect("kill starts").success());
    let outcome = Outcome::of(child.wait_with_output().expect("tip ends")).expect(130);
    assert!(
        outcome.err.contains("p.prg: interrupted at line "),
        "{outcome:#?}"
    );
}

#[test]
fn a_quiet_run_says_what_its_program_says() {
    let folder = Folder::new("speaks-quiet")
        .program("p.prg", &format!("DEF_VAR UNUSED\n{TOPPLES}\nEND"))
        .program("bad.prg", "RETURN\nEND")
        .program("worse.prg", "FOO\nEND");
    for quiet in ["--quiet", "-q"] {
        let outcome = folder.tip(&["run", "p.prg", quiet]).expect(0);
        assert_eq!((&*outcome.out, &*outcome.err), ("still here\n", ""));
    }
    let denied = ["run", "p.prg", "--quiet", "--deny", "falls"];
    assert_eq!(folder.tip(&denied).expect(4).err, "");
    // What ends a run has a reason.
    let outcome = folder.tip(&["run", "bad.prg", "--quiet"]).expect(3);
    assert!(
        outcome
            .err
            .starts_with("error[E303]: this returns from a subroutine that was not called\n"),
        "{outcome:#?}"
    );
    assert!(!outcome.err.contains("robot time"), "{outcome:#?}");
    let outcome = folder.tip(&["run", "worse.prg", "--quiet"]).expect(1);
    assert!(outcome.err.contains("FOO"), "{outcome:#?}");
}

#[test]
fn a_hand_says_how_far_it_lifts_and_how_hard_it_pushes() {
    let grasp = include_str!("../../../../examples/grasp/motions/grasp.prg");
    let folder = Folder::new("speaks-hand").file("grasp.prg", grasp).file(
        "scene.toml",
        include_str!("../../../../examples/grasp/scene.toml"),
    );
    let hand = [
        "run",
        "--robot",
        "hand",
        "grasp.prg",
        "--scene",
        "scene.toml",
    ];
    let outcome = folder.tip(&hand).expect(0);
    // It is lifted by about 42 mm, and put back.
    let lifted = number(&outcome.err, "lift", " mm at most");
    assert!(lifted > 25.0 && lifted < 60.0, "{outcome:#?}");
    let now = number(&outcome.err, "lift", " mm, ");
    assert!(now.abs() < 1.0, "{outcome:#?}");
    for finger in ["force   F1:", "force   F2:", "force   F3:"] {
        assert!(
            number(&outcome.err, finger, " N at most") > 0.5,
            "{outcome:#?}"
        );
        assert!(number(&outcome.err, finger, " N, ") < 0.01, "{outcome:#?}");
    }
    for absent in ["travel", "falls", "margin"] {
        assert!(!outcome.err.contains(absent), "{outcome:#?}");
    }
}

#[test]
fn a_robot_that_is_bolted_down_says_how_it_ended_and_how_its_joints_turned() {
    let bolted = "name = \"bolted\"\njoint = [{ axis = \"y\", link = [0, 0, -100], limits = [-90, 90] }]\nleg = [{ base = [0, 0, 0] }]\n";
    let folder = Folder::new("speaks-bolted")
        .program("p.prg", "PTP_ANGLE J11 5\nEND")
        .file("bolted.toml", bolted);
    let outcome = folder
        .tip(&["run", "p.prg", "--robot", "bolted.toml"])
        .expect(0);
    let lines: Vec<&str> = outcome.err.lines().collect();
    assert_eq!(lines.len(), 2, "{outcome:#?}");
    assert!(lines[1].starts_with("  rate "), "{outcome:#?}");
}

/// 1.2 s of the robot, in 60 cycles of SLEEP and one of END.
const NAPS: &str = "SLEEP 1200\nMESSAGE awake\nEND";

#[test]
fn real_time_is_that_of_the_robot_with_a_legend_and_a_status() {
    let folder = Folder::new("speaks-realtime").program("p.prg", NAPS);
    let begin = std::time::Instant::now();
    let outcome = folder.tip(&["run", "p.prg", "--realtime"]).expect(0);
    let elapsed = begin.elapsed().as_secs_f64();
    assert!((1.2..30.0).contains(&elapsed), "{elapsed} s");
    assert_eq!(outcome.out, "awake\n");
    let lines: Vec<_> = outcome.err.lines().collect();
    assert!(lines[0].starts_with("keys: none, "), "{outcome:#?}");
    // One second later, and in plain text.
    let (time, status) = lines[1].split_once(" s | ").expect("a status");
    let time: f64 = time.parse().expect("s");
    assert!(time > 0.5 && time <= 1.2, "{outcome:#?}");
    let expected = "0.0 mm forward, margin ";
    assert!(
        status.starts_with(expected) && status.ends_with("falls 0 | line 3: SLEEP 1200"),
        "{status}"
    );
    let end = |line: &&&str| line.starts_with("p.prg: END at line 5 ");
    assert_eq!(lines.iter().filter(end).count(), 1, "{outcome:#?}");
    assert!(
        lines
            .last()
            .is_some_and(|line| line.starts_with("  pace    ")),
        "{outcome:#?}"
    );
    assert!(!outcome.err.contains(['\r', '\u{1b}']), "{outcome:#?}");
}

#[test]
fn a_quiet_run_in_real_time_is_silent() {
    let folder = Folder::new("speaks-realtime-quiet").program("p.prg", "SLEEP 300\nEND");
    let begin = std::time::Instant::now();
    let outcome = folder
        .tip(&["run", "p.prg", "--realtime", "--quiet"])
        .expect(0);
    assert!(begin.elapsed().as_secs_f64() >= 0.3);
    assert_eq!((&*outcome.out, &*outcome.err), ("", ""));
}

/// The cylinder that comes with the hand is too large for the grasp of the example.
#[test]
fn a_run_that_waits_says_where_for_what_and_how_long() {
    let grasp = include_str!("../../../../examples/grasp/motions/grasp.prg");
    let folder = Folder::new("speaks-waits")
        .file("grasp.prg", grasp)
        .program("key.prg", "SLEEP 1000\nKEY_IN\nEND")
        .program("sleep.prg", "SLEEP 90000\nEND")
        .program(
            "flag.prg",
            "STAND_UP 60\nL1:\nSLEEP 100\nIF !KB_HIT GOTO L1:\nEND",
        )
        .program(
            "knob.prg",
            "DEF_VAR V\nV = 0\nWHILE V < 5\nAD_IN VR1 V\nWEND\nEND",
        )
        .program("ever.prg", "L1:\nGOTO L1:\nEND")
        .program("lamp.prg", "L1:\nLAMP_ON 1\nLAMP_OFF 1\nGOTO L1:\nEND")
        .program(
            "count.prg",
            "DEF_VAR N\nN = 0\nL1:\nN = N + 1\nIF N < 100000 GOTO L1:\nEND",
        );
    let run = |program: &str, more: &[&str]| {
        let run = ["run", program, "--cycles", "4000"];
        folder.tip(&[&run[..], more].concat()).expect(0).err
    };
    let hand = run("grasp.prg", &["--robot", "hand", "--scene", "cylinder"]);
    assert!(
        hand.contains("\n  waits   line 22 has been waiting for INPOS_ALL for "),
        "{hand}"
    );
    for (program, expected) in [
        (
            "key.prg",
            "line 4 has been waiting for a key for 79.0 s, since 1.0 s",
        ),
        (
            "knob.prg",
            "lines 5 to 7 have been waiting for VR1 for 79.9 s, since 0.1 s",
        ),
        (
            "ever.prg",
            "lines 3 to 4 have repeated without a motion for 80.0 s, since 0.0 s",
        ),
    ] {
        let said = run(program, &[]);
        assert!(
            said.contains(&format!("\n  waits   {expected}\n")),
            "{program}: {said}"
        );
        let during = said
            .lines()
            .filter(|line| line.ends_with("Ctrl-C ends the run"));
        assert_eq!(during.count(), 1, "{said}");
    }
    let flag = run("flag.prg", &[]);
    assert!(
        flag.contains("\n  waits   lines 4 to 6 have been waiting for KB_HIT for "),
        "{flag}"
    );
    for program in ["sleep.prg", "lamp.prg", "count.prg"] {
        let said = run(program, &[]);
        assert!(
            !said.contains("wait") || said.contains("which waits until the time"),
            "{said}"
        );
        assert!(!said.contains("  waits  "), "{program}: {said}");
    }
}

#[test]
fn view_and_log_end_after_a_long_wait_and_say_so() {
    let folder = Folder::new("speaks-stopped")
        .program("key.prg", "SLEEP 1000\nKEY_IN\nEND")
        .program("sleep.prg", "SLEEP 90000\nEND");
    let expected = "stopped after 60 s without a motion: line 4 has been waiting for a key for 60.0 s, since 1.0 s; --cycles sets another end";
    for command in [
        ["log", "key.prg", "-o", "key.csv"],
        ["view", "key.prg", "-o", "key.html"],
    ] {
        let outcome = folder.tip(&command).expect(0);
        assert_eq!(
            outcome.err.lines().filter(|line| *line == expected).count(),
            1,
            "{outcome:#?}"
        );
    }
    let rows = folder.read("key.csv").lines().count();
    assert!((3050..3053).contains(&rows), "{rows}");
    // Who asks for an end gets that one, and a program that lets time pass is not waiting.
    let asked = [
        "log", "key.prg", "-o", "key.csv", "--cycles", "5000", "--lang", "ja",
    ];
    let outcome = folder.tip(&asked).expect(0);
    assert!(
        outcome
            .err
            .contains("4行目がキー入力を待っています(1.0 sから99.0 s間)\n"),
        "{outcome:#?}"
    );
    assert_eq!(folder.read("key.csv").lines().count(), 5001);
    let outcome = folder
        .tip(&["log", "sleep.prg", "-o", "sleep.csv"])
        .expect(0);
    assert!(!outcome.err.contains("stopped"), "{outcome:#?}");
}

/// Fingers that press on something tremble for ever.
#[test]
fn a_hand_that_trembles_waits_without_a_motion() {
    let grasp = include_str!("../../../../examples/grasp/motions/grasp.prg");
    let folder = Folder::new("speaks-trembles").file("grasp.prg", grasp);
    let outcome = folder
        .tip(&[
            "log",
            "grasp.prg",
            "--robot",
            "hand",
            "--scene",
            "cylinder",
            "-o",
            "grasp.csv",
            "--every",
            "500",
        ])
        .expect(0);
    let expected = "stopped after 60 s without a motion: line 22 has been waiting for INPOS_ALL for 60.8 s, since 1.2 s;";
    assert!(outcome.err.contains(expected), "{outcome:#?}");
}

#[test]
fn a_recording_that_ends_in_time_says_what_the_program_waits_for() {
    let folder = Folder::new("speaks-in-time").program(
        "keys.prg",
        "DEF_VAR K\nL1:\nKEY_IN K\nMESSAGE %K%\nGOTO L1:\nEND",
    );
    // A key every 50 s, the last one after 550 s.
    let keys: Vec<String> = (1..=11).map(|k| format!("{}:key {k}", 2500 * k)).collect();
    let keys = keys
        .join(", ")
        .replace("key 10", "key A")
        .replace("key 11", "key B");
    let log = [
        "log", "keys.prg", "-o", "keys.csv", "--events", &keys, "--every", "500",
    ];
    let outcome = folder.tip(&log).expect(0);
    let expected = "stopped after 10 minutes of the robot's time: line 5 has been waiting for a key for 49.9 s, since 550.1 s;";
    assert!(outcome.err.contains(expected), "{outcome:#?}");
}
