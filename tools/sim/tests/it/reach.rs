//! Which constant targets are reported as out of reach, against the robots' geometry.

use tip_runtime::command::Target;
use tip_runtime::fault::Fault;
use tip_runtime::random::Random;
use tip_runtime::record::Ending;
use tip_sim::{Interpreter, Limit, Robot, Run};
use tipc::message::Message;

/// Returns code, reason and help of the first diagnostic of some statements.
fn said(robot: &str, statements: &str) -> Vec<String> {
    let robot = Robot::named(robot).expect("a robot");
    let text = format!("3.1\nreach\n{statements}\nEND\n");
    let mut loaded = tipc::load("reach.prg", text.as_bytes(), &robot.options());
    robot.warn(&mut loaded);
    let findings = loaded.diagnostics.iter();
    let one = |finding: &tipc::diagnostic::Diagnostic| {
        let help = finding.help.as_ref().map(Message::to_string);
        let place = loaded.source.slice(finding.span);
        let (code, reason) = (finding.code.id(), &finding.reason);
        format!("{code} {place}: {reason}; {}", help.unwrap_or_default())
    };
    findings.map(one).collect()
}

#[track_caller]
fn check(robot: &str, statements: &str, expected: &[&str]) {
    assert_eq!(said(robot, statements), expected, "{statements}");
}

// The hip of F1 is at (-101, 201, 0), its links are 50, 240 and 200 mm long: a foot comes 490 mm outwards.
// clauses: 2.22 7.2
#[test]
fn a_foot_that_links_do_not_reach() {
    check("titan8", "PTP F1 -391 201 -200", &[]);
    let said = said("titan8", "PTP F1 -2000 201 0");
    let [one] = said.as_slice() else {
        panic!("{said:?}")
    };
    let start = "W122 -2000 201 0: F1 ends about ";
    assert!(one.starts_with(start), "{one}");
    let by = one[start.len()..].split(' ').next().expect("a number");
    let by: f64 = by.parse().expect("mm");
    // From 101 + 490 to 2000 at least: limits may keep the leg from stretching out.
    assert!((1409.0..1500.0).contains(&by), "{one}");
}

#[test]
fn an_angle_beyond_a_limit() {
    let model = tip_runtime::model::titan8::MODEL;
    let limits = model.legs[0].joints[1].limits;
    let far = limits.max + 12.5;
    let finding = format!(
        "W122 {far}: J12 would turn 12.5 deg beyond its limit of {max} deg; J12 turns from {min} to {max} deg",
        min = limits.min,
        max = limits.max
    );
    check("titan8", &format!("PTP_ANGLE J12 {far}"), &[&finding]);
    check("titan8", &format!("PTP_ANGLE F1 0 {far} 90"), &[&finding]);
    check("titan8", &format!("PTP_ANGLE J12 {}", limits.max), &[]);
}

#[test]
fn what_may_be_in_reach_is_left_alone() {
    for statements in [
        // Relative, in part or whole; a variable; a joint that stops at its limit.
        "PTP F1 R -2000 R 0 R 0",
        "PTP F1 A -2000 R 0 R 0",
        "IF KB_HIT THEN\nSLEEP 1\nENDIF\nREL_PTP F1 -2000 0 0",
        "DEF_VAR X\nX = -2000\nPTP F1 X 201 0",
        "EMG_OFF\nPTP F1 -2000 201 0",
        "PTP F1 -2000 201 0 // tip: allow(W122)",
    ] {
        check("titan8", statements, &[]);
    }
    // It is not said to silence nothing, since loading alone does not know.
    check("titan8", "PTP F1 -391 201 -200 // tip: allow(W122)", &[]);
}

#[test]
fn the_hand_has_no_z_but_a_slider() {
    let slider = tip_runtime::model::hand::MODEL.slider.expect("a slider");
    let at = |x: f64| format!("PTP FLOOR {x} {} {}", slider.initial[1], slider.initial[2]);
    check("hand", &at(slider.travel[0].max), &[]);
    let said = said("hand", &at(slider.travel[0].max + 1.0));
    assert!(
        said.len() == 1 && said[0].contains("along x it goes from"),
        "{said:?}"
    );
    let feet = Robot::named("hand").expect("a robot").description().feet;
    let [x, y, _] = feet[0];
    check("hand", &format!("PTP F1 {x} {y} 5000"), &[]);
    let far = said_far();
    assert!(
        far.len() == 1 && far[0].contains("F1 ends about"),
        "{far:?}"
    );
}

fn said_far() -> Vec<String> {
    said("hand", "PTP F1 5000 0 0")
}

/// A position as a program writes it.
fn written([x, y, z]: [f64; 3]) -> String {
    format!("{x:.1} {y:.1} {z:.1}")
}

/// Pairs of places that a foot of TITAN VIII reaches, on both sides of its hip.
fn pairs() -> impl Iterator<Item = (String, String)> {
    let robot = Robot::named("titan8").expect("a robot");
    let leg = robot.description().legs.remove(0);
    let ranges: Vec<_> = leg.joints.iter().map(|joint| joint.limits).collect();
    let mut random = Random::new(1);
    let mut place = move || {
        let angles = ranges
            .iter()
            .map(|it| it.min + (it.max - it.min) * random.within(0.02, 0.98));
        written(leg.foot(&angles.collect::<Vec<f64>>()))
    };
    std::iter::repeat_with(move || (place(), place())).take(150)
}

// clauses: 2.22
#[test]
fn a_path_that_is_said_to_leave_the_reach_stops_the_program() {
    let mut warned = 0;
    for (first, second) in pairs() {
        let text = format!("PTP F1 {first}\nWAIT_INPOS F1\nPTP F1 {second}\nWAIT_INPOS F1");
        // Some targets are within the body.
        let is_path = |said: &String| !said.starts_with("W138");
        if !said("titan8", &text).iter().any(is_path) {
            continue;
        }
        warned += 1;
        let robot = Robot::named("titan8").expect("a robot");
        let text = format!("3.1\npath\n{text}\nEND\n");
        let loaded = tipc::load("path.prg", text.as_bytes(), &robot.options());
        let program = loaded.program.expect("it loads");
        let mut run = Run::new(Interpreter::new(program), robot).expect("it fits");
        run.to_end(Limit::cycles(5000));
        let stopped = run.ending();
        let is_so = |it: &Ending| matches!(it, Ending::Emergency(it) if it.fault == Fault::OutOfReach(Target::Foot(1)));
        assert!(
            stopped.as_ref().is_some_and(is_so),
            "{first} to {second}: {stopped:?}"
        );
    }
    assert!(warned >= 10, "{warned}");
}

// From above the hip to below it the knee would have to fold beyond its limit.
// clauses: 2.22
#[test]
fn a_path_is_looked_at_where_its_start_is_known() {
    let path = "PTP F1 -408 93 235\nWAIT_INPOS F1\nPTP F1 -199 183 -137";
    let [one] = &said("titan8", path)[..] else {
        panic!("{path}")
    };
    let begins = "W127 -199 183 -137: the straight path of F1 leaves its reach near ";
    assert!(one.starts_with(begins), "{one}");
    for unknown in [
        // Under way, after a question, after another motion, or as far as a joint goes.
        "PTP F1 -408 93 235\nPTP F1 -199 183 -137",
        "PTP F1 -408 93 235\nWAIT_INPOS F1\nIF KB_HIT THEN\nPTP F1 -300 250 -200\nWAIT_INPOS F1\nENDIF\nPTP F1 -199 183 -137",
        "PTP F1 -408 93 235\nWAIT_INPOS F1\nREL_PTP F1 0 0 -10\nWAIT_INPOS F1\nPTP F1 -199 183 -137",
        "EMG_OFF\nPTP F1 -408 93 235\nWAIT_INPOS F1\nPTP F1 -199 183 -137",
    ] {
        check("titan8", unknown, &[]);
    }
    // Waiting for all, and what moves nothing.
    let same =
        "PTP F1 -408 93 235\nLAMP_ON 1\nWAIT_INPOS ALL\nSLEEP 100\nL1:\nPTP F1 -199 183 -137";
    assert_eq!(said("titan8", same).len(), 1);
}

// The links of 50, 240 and 200 mm do not lift a foot by 400 mm from the initial posture.
// clauses: 2.22
#[test]
fn a_relative_target_is_checked_where_its_start_is_known() {
    for known in [
        "REL_PTP F1 0 0 400",
        "REL_PTP F2 0 0 10\nREL_PTP F1 0 0 400",
        "PTP F1 -391 201 -200\nWAIT_INPOS F1\nREL_PTP F1 0 0 1000",
    ] {
        let said = said("titan8", known);
        let [one] = said.as_slice() else {
            panic!("{known}: {said:?}")
        };
        assert!(one.starts_with("W122 0 0 "), "{known}: {one}");
    }
    for unknown in [
        // Within reach, under way, after a motion whose end is not followed, or after a question.
        "REL_PTP F1 0 0 40",
        "PTP F1 -391 201 -200\nREL_PTP F1 0 0 400",
        "REL_PTP F1 0 0 10\nREL_PTP F1 0 0 400",
        "IF KB_HIT THEN\nSLEEP 1\nENDIF\nREL_PTP F1 0 0 400",
        "EMG_OFF\nREL_PTP F1 0 0 400",
    ] {
        check("titan8", unknown, &[]);
    }
    // The warning tells the truth: the run stops at this command.
    let robot = Robot::named("titan8").expect("a robot");
    let text = b"3.1\nreach\nREL_PTP F1 0 0 400\nWAIT_INPOS ALL\nEND\n";
    let loaded = tipc::load("reach.prg", text, &robot.options());
    let program = loaded.program.expect("it loads");
    let mut run = Run::new(Interpreter::new(program), robot).expect("it fits");
    run.to_end(Limit::cycles(5000));
    let stopped = run.ending();
    let is_so = |it: &Ending| matches!(it, Ending::Emergency(it) if it.fault == Fault::OutOfReach(Target::Foot(1)));
    assert!(stopped.as_ref().is_some_and(is_so), "{stopped:?}");
}

/// The thighs of F1 and F3, 240 mm long with bases 402 mm apart, turn towards each other by 60 degrees and cross; by 30 degrees
/// they stay apart.
#[test]
fn targets_at_which_legs_cross() {
    let cross = "PTP_ANGLE J11 -60\nPTP_ANGLE J31 60\n";
    let found = |statements: &str| -> Vec<String> {
        let said = said("titan8", statements);
        let ours = said.into_iter().filter(|said| said.starts_with("W138"));
        ours.collect()
    };
    let said = found(&format!("{cross}WAIT_INPOS ALL"));
    let [one] = said.as_slice() else {
        panic!("{said:?}")
    };
    assert!(one.starts_with("W138 PTP_ANGLE J31 60: link3"), "{one}");
    assert!(
        one.contains(" overlap by ") && one.contains("may_touch"),
        "{one}"
    );
    let apart = "PTP_ANGLE J11 -30\nPTP_ANGLE J31 30\nWAIT_INPOS ALL";
    for good in [
        apart,
        // One leg alone crosses nothing.
        "PTP_ANGLE J11 -60\nWAIT_INPOS ALL",
        // The other leg is not there any more when this one arrives.
        "PTP_ANGLE J31 60\nWAIT_INPOS ALL\nPTP_ANGLE J11 -60\nPTP_ANGLE J31 0\nWAIT_INPOS ALL",
        // Nobody waits for them.
        cross,
        // A program may stop before it.
        &format!("IF KB_HIT THEN\nEXIT\nENDIF\n{cross}WAIT_INPOS ALL"),
        &format!("DEF_VAR A\nA = 1\nPTP_ANGLE J21 A\n{cross}WAIT_INPOS ALL"),
    ] {
        assert_eq!(found(good), [""; 0], "{good}");
    }
    // Straight on, the same posture is said once, and again when a leg is sent there again.
    let twice = format!("{cross}WAIT_INPOS ALL\nWAIT_INPOS ALL\nPTP_ANGLE J31 60\nWAIT_INPOS ALL");
    assert_eq!(found(&twice).len(), 2);
}

#[test]
fn a_robot_that_is_said_to_hit_itself_does_so() {
    let (mut warned, mut silent) = (0, 0);
    for (first, second) in pairs() {
        let text = format!("PTP F1 {first}\nWAIT_INPOS F1\nPTP F1 {second}\nWAIT_INPOS F1");
        let said = said("titan8", &text);
        if said.iter().any(|said| !said.starts_with("W138")) {
            continue;
        }
        let robot = Robot::named("titan8").expect("a robot");
        let text = format!("3.1\nhits\n{text}\nEND\n");
        let loaded = tipc::load("hits.prg", text.as_bytes(), &robot.options());
        let program = loaded.program.expect("it loads");
        let mut run = Run::new(Interpreter::new(program), robot).expect("it fits");
        // In the cycle of the second PTP and in the last one the foot is at its target.
        let mut at_target = Vec::new();
        while run.ending().is_none() && run.cycles() < 5000 {
            let line = run.program().line(run.program().at());
            run.cycle();
            if line == 5 || run.ending().is_some() {
                let clearance = run.clearance().expect("its links are compared");
                at_target.push(clearance.now.distance);
            }
        }
        let deepest = at_target.into_iter().fold(f64::INFINITY, f64::min);
        match said.is_empty() {
            // A foot comes to 2 mm of its target.
            true => assert!(deepest > -5.0, "{first} to {second}: {deepest} mm"),
            false => assert!(deepest < 5.0, "{first} to {second}: {deepest} mm"),
        }
        warned += u32::from(!said.is_empty());
        silent += u32::from(said.is_empty());
    }
    assert!(warned >= 3 && silent >= 10, "{warned} {silent}");
}

/// A shin that is folded back by nearly 180 degrees lies along the thigh, and reaches the link before it.
#[test]
fn a_leg_that_hits_itself_does_so_anywhere() {
    let text = "name = \"folds\"\njoint = [\n\
        { axis = \"z\", link = [100, 0, 0], limits = [-170, 170] },\n\
        { axis = \"z\", link = [200, 0, 0], limits = [-170, 170] },\n\
        { axis = \"z\", link = [250, 0, 0], limits = [-179, 179] },\n]\n\
        leg = [{ base = [0, 0, 0] }]\n";
    let described = tipc::description::parse("folds.toml", text.as_bytes()).expect("a robot");
    let robot = Robot::described(&described);
    let codes = |angle: &str| -> Vec<&str> {
        let text = format!(
            "3.1\nt\nL1:\nIF KB_HIT THEN\nEXIT\nENDIF\nPTP_ANGLE F1 0 0 {angle}\nGOTO L1:\nEND\n"
        );
        let mut loaded = tipc::load("folds.prg", text.as_bytes(), &robot.options());
        assert!(loaded.program.is_some(), "{:?}", loaded.diagnostics);
        robot.warn(&mut loaded);
        loaded
            .diagnostics
            .iter()
            .map(|found| found.code.id())
            .collect()
    };
    // At 179 deg the foot is 50 mm behind the second joint, in the first link; at 90 deg it is beside it.
    assert_eq!((codes("179"), codes("90")), (vec!["W138"], vec![]));
}
