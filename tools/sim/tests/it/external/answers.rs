//! Answers that are accepted, and those that are not.

use super::peer::{
    ANGLES, ECHO, NOD, Outcome, echo_with, in_cycle_3, peer, ready, ready_with, run, run_on, says,
    stopped,
};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::external::{Head, PlantError};
use tip_sim::{Limit, Plant, Refused, Robot, Run, load};

const TO: Head = Head::Cycle(3);

/// Its trace, if it comes to its end.
fn trace(mut run: Run) -> Result<String, String> {
    match run.to_end(Limit::cycles(1000)) {
        Ending::Program(End::End) => Ok(run.trace()),
        other => Err(format!("{other:?} {:?}", run.plant_error())),
    }
}

#[test]
fn the_same_answers_give_the_same_trace() -> Outcome {
    let robot = Robot::named("titan8")?;
    let program = load("p.prg", &format!("3.1\nt\n{NOD}\n"), &robot)?;
    let echo = Run::new(program, robot.with_plant(Plant::Echo))?.with_trace(true);
    let inside = trace(echo)?;
    assert_eq!(trace(run(NOD, &peer(&ready(), ECHO))?)?, inside);
    // However long they take.
    let slow = in_cycle_3(&format!("sleep 0.3; {ECHO}"));
    assert_eq!(trace(run(NOD, &slow)?)?, inside);
    // An answer that differs in a bit does not.
    let other = in_cycle_3(&says(r#""n":$n,"angles":[0.125,${targets#*,}"#));
    assert_ne!(trace(run(NOD, &other)?)?, inside);
    Ok(())
}

#[test]
fn blanks_and_the_order_of_fields_do_not_matter() -> Outcome {
    let as_ever = trace(run(NOD, &peer(&ready(), ECHO))?)?;
    let other =
        in_cycle_3(r#"printf '  {"angles" :\t%s ,  "n":%s, "pose":null}  \r\n' "$targets" "$n""#);
    assert_eq!(trace(run(NOD, &other)?)?, as_ever);
    Ok(())
}

#[test]
fn numbers_may_be_written_as_usual() -> Outcome {
    let ready = says(r#""version":2,"angles":[0,-0,9.0e1,0,0,90E+0,0.0,0,900e-1,0,0,90]"#);
    trace(run(NOD, &peer(&ready, ECHO))?)?;
    Ok(())
}

/// Returns the error of an answer to cycle 3: its path, its reason, and its message.
fn wrong(answer: &str) -> Result<(String, String, String), Box<dyn std::error::Error>> {
    let (word, cycle, trouble) = stopped(&in_cycle_3(answer))?;
    assert_eq!((word, cycle), ("plant: wrong answer", 4), "{answer}");
    let message = trouble.to_string();
    match trouble {
        PlantError::Wrong {
            to: TO,
            path,
            reason,
            ..
        } => Ok((path, reason, message)),
        other => Err(format!("{answer}: {other:?}").into()),
    }
}

#[test]
fn a_line_that_is_no_answer() -> Outcome {
    let (path, _, message) = wrong("echo step 3 done")?;
    assert_eq!(path, ".");
    let begins = "the external plant's answer to 'cycle 3' is 'step 3 done': ";
    assert!(message.starts_with(begins), "{message}");
    for line in ["", "3", "[3]", "null", "{", r#""n""#] {
        wrong(&format!("echo '{line}'"))?;
    }
    // Two answers on one line.
    let two = format!(
        "echo '{}'",
        r#"{"n":3,"angles":[0,0,90,0,0,90,0,0,90,0,0,90]}{}"#
    );
    assert_eq!(wrong(&two)?.0, ".");
    // What a library says at its start.
    let loud = peer(&format!("echo Welcome; {}", ready()), ECHO);
    let (word, cycle, trouble) = stopped(&loud)?;
    assert_eq!((word, cycle), ("plant: wrong answer", 0));
    let message = trouble.to_string();
    assert!(
        message.starts_with("the external plant's answer to 'hello' is 'Welcome': "),
        "{message}"
    );
    Ok(())
}

#[test]
fn what_it_says_is_shown_printable_and_in_part() -> Outcome {
    let (_, _, message) = wrong("printf '\\033[2J%0100d\\n' 7")?;
    assert!(
        !message.contains('\u{1b}') && message.contains('…') && message.len() < 250,
        "{message}"
    );
    // A key is its word, too.
    let (_, _, message) = wrong(r#"printf '{"\\u001b[2J":%0300d}\n' 7"#)?;
    assert!(
        !message.contains('\u{1b}') && message.len() < 500,
        "{message}"
    );
    Ok(())
}

#[test]
fn bytes_that_are_no_text() -> Outcome {
    let (word, _, trouble) = stopped(&in_cycle_3(r#"printf '{"n":3,"\377\n'"#))?;
    assert_eq!(
        (word, trouble),
        ("plant: wrong answer", PlantError::NotText { to: TO })
    );
    Ok(())
}

#[test]
fn too_few_numbers_and_too_many() -> Outcome {
    for (found, numbers) in [(11, "[${targets#*,}"), (13, "[0,${targets#[}")] {
        let (path, reason, _) = wrong(&says(&format!(r#""n":3,"angles":{numbers}"#)))?;
        let expected = format!("invalid length {found}, expected 12 numbers");
        assert_eq!((path.as_str(), reason), ("angles", expected));
    }
    assert_eq!(
        wrong(&says(r#""n":3,"angles":[]"#))?.1,
        "missing field `angles`"
    );
    for pose in ["[0,0,0,0,0]", "[0,0,0,0,0,0,0]", "[]", "7"] {
        let (path, ..) = wrong(&echo_with(&format!(r#","pose":{pose}"#)))?;
        assert!(path.starts_with("pose"), "{pose}: {path}");
    }
    Ok(())
}

#[test]
fn what_is_not_a_number_has_its_place() -> Outcome {
    for found in [
        r#""fast""#,
        "null",
        "[1]",
        "true",
        "1e999",
        "01",
        "+1",
        ".5",
    ] {
        let angles = format!(r#""n":3,"angles":[0,0,90,0,{found},90,0,0,90,0,0,90]"#);
        let (path, reason, message) = wrong(&says(&angles))?;
        assert_eq!(path, "angles[4]", "{found}");
        let expected =
            format!("the external plant's answer to 'cycle 3' is wrong at 'angles[4]': {reason}");
        assert_eq!(message, expected);
    }
    Ok(())
}

/// JSON has no such numbers, but libraries write these words.
#[test]
fn what_is_not_finite_has_its_place() -> Outcome {
    for number in ["NaN", "Infinity", "-Infinity"] {
        let angles = format!(r#""n":3,"angles":[0,0,90,0,0,90,{number},0,90,0,0,90]"#);
        let (word, _, trouble) = stopped(&in_cycle_3(&says(&angles)))?;
        assert_eq!(word, "plant: answer is not finite", "{number}");
        let path = "angles[6]".to_owned();
        assert_eq!(trouble, PlantError::NotFinite { to: TO, path });
    }
    Ok(())
}

#[test]
fn the_answer_to_another_cycle() -> Outcome {
    for found in [2, 4] {
        let does = says(&format!(r#""n":{found},"angles":$targets"#));
        let (word, _, trouble) = stopped(&in_cycle_3(&does))?;
        assert_eq!(word, "plant: answer to another cycle");
        assert_eq!(trouble, PlantError::Cycle { to: TO, found });
    }
    for found in ["3.0", "-3", r#""3""#] {
        let (path, ..) = wrong(&says(&format!(r#""n":{found},"angles":$targets"#)))?;
        assert_eq!(path, "n", "{found}");
    }
    // Two answers to one line.
    let (word, cycle, _) = stopped(&in_cycle_3(&format!("{ECHO}; {ECHO}")))?;
    assert_eq!((word, cycle), ("plant: answer to another cycle", 5));
    Ok(())
}

#[test]
fn fields_that_an_answer_has_not() -> Outcome {
    for (field, path, reason) in [
        (r#""angels":0"#, "angels", "unknown field `angels`"),
        (r#""version":2"#, "version", "unknown field `version`"),
        (r#""slider":[0,0,0]"#, "slider", "unknown field `slider`"),
        (r#""angles":[1]"#, "angles", "duplicate field `angles`"),
    ] {
        let (found, why, _) = wrong(&echo_with(&format!(",{field}")))?;
        assert!(
            [path, "."].contains(&found.as_str()) && why.starts_with(reason),
            "{field}: {found}: {why}"
        );
    }
    assert_eq!(wrong(&says(r#""n":3"#))?.1, "missing field `angles`");
    assert_eq!(wrong(&says(r#""angles":$targets"#))?.1, "missing field `n`");
    Ok(())
}

#[test]
fn another_version() -> Outcome {
    // Of a version that comes later nothing else can be said.
    let later = says(r#""version":3,"posture":[]"#);
    let (word, cycle, trouble) = stopped(&peer(&later, ECHO))?;
    assert_eq!((word, cycle), ("plant: other version", 0));
    assert_eq!(trouble, PlantError::Version { found: 3 });
    // Version 1 had words.
    let words = "echo ready version=1 angles=0,0,90,0,0,90,0,0,90,0,0,90";
    let (word, cycle, trouble) = stopped(&peer(words, ECHO))?;
    assert_eq!((word, cycle), ("plant: other version", 0));
    assert_eq!(
        trouble.to_string(),
        "the external plant uses version 1 of the protocol, and this is version 2, which has JSON lines: see \
         docs/external-plant.md"
    );
    for (fields, reason) in [
        (format!(r#""angles":{ANGLES}"#), "missing field `version`"),
        (
            format!(r#""version":2,"n":0,"angles":{ANGLES}"#),
            "unknown field `n`",
        ),
    ] {
        let (word, _, trouble) = stopped(&peer(&says(&fields), ECHO))?;
        assert_eq!(word, "plant: wrong answer");
        assert!(trouble.to_string().ends_with(reason), "{trouble}");
    }
    Ok(())
}

#[test]
fn lines_may_be_long_but_not_endless() -> Outcome {
    let of = |bytes: usize| {
        let answer = r#"{\"n\":3,\"angles\":$targets}"#;
        format!(r#"printf '%-{bytes}s\n' "{answer}""#)
    };
    trace(run(NOD, &in_cycle_3(&of(65_536)))?)?;
    let (word, _, trouble) = stopped(&in_cycle_3(&of(65_537)))?;
    assert_eq!(
        (word, trouble),
        ("plant: wrong answer", PlantError::TooLong { to: TO })
    );
    // One without any end.
    let (_, _, trouble) = stopped(&in_cycle_3("exec cat /dev/zero"))?;
    assert_eq!(trouble, PlantError::TooLong { to: TO });
    Ok(())
}

#[test]
fn what_is_measured_first_is_measured_always() -> Outcome {
    for field in [
        r#""loads":[50,40,30,20]"#,
        r#""torques":[0,0,0,0,0,0,0,0,0,0,0,0]"#,
        r#""pose":[0,0,200,0,0,0]"#,
    ] {
        let (_, cycle, trouble) = stopped(&peer(&ready_with(&format!(",{field}")), ECHO))?;
        let (key, _) = field.split_once(':').unwrap_or_default();
        let missing = format!("missing field `{}`", key.trim_matches('"'));
        assert_eq!(cycle, 1);
        assert!(trouble.to_string().ends_with(&missing), "{trouble}");
    }
    Ok(())
}

#[test]
fn loads_are_what_soles_read_and_events_take_their_place() -> Outcome {
    // 200 N are 5 V.
    let loads = r#","loads":[50,40,30,20]"#;
    let plant = peer(&ready_with(loads), &echo_with(loads));
    let statements = "DEF_VAR A, B, C\nAD_IN PAW1 A\nAD_IN PAW2 B\nAD_IN VR1 C\nEND";
    let mut run = run(statements, &plant)?.events("0:PAW2=3.5, 0:VR1=2")?;
    run.to_end(Limit::cycles(10));
    let read = ["A", "B", "C"].map(|name| run.program().get(name));
    assert_eq!(read, [Ok(Some(1.25)), Ok(Some(3.5)), Ok(Some(2.0))]);
    Ok(())
}

#[test]
fn nothing_pushes_what_is_elsewhere() -> Outcome {
    let refused = run(NOD, &peer(&ready(), ECHO))?.events("0:push 80 0 0 for 5");
    assert!(matches!(refused, Err(Refused::Massless(_))), "{refused:?}");
    Ok(())
}

#[test]
fn it_may_say_where_the_body_is() -> Outcome {
    let pose = "m=$((n + 1)); a=$((m * 170 % 360)); if [ $a -gt 180 ]; then a=$((a - 360)); fi";
    let answer = echo_with(r#","pose":[3,$((m * 10)),250,0,0,$a]"#);
    let each = format!("{pose}; {answer}");
    let ready = ready_with(r#","pose":[1,0,240,0,0,0]"#);
    let mut run = run("L:\nGOTO L:\nEND", &peer(&ready, &each))?;
    assert_eq!(run.travel(), None, "before it has answered");
    run.to_end(Limit::cycles(6));
    let travel = run.travel().ok_or("no travel")?;
    // Whole turns count.
    assert_eq!(
        [travel.x, travel.y, travel.z, travel.turn],
        [2.0, 60.0, 10.0, 1020.0]
    );
    let cycle = run.cycle();
    assert_eq!(
        cycle.pose.map(|pose| pose.position),
        Some([3.0, 60.0, 250.0])
    );
    assert_eq!(run.motion(), None, "nobody counts its falls");
    Ok(())
}

#[test]
fn a_hand_has_torques_and_a_slider() -> Outcome {
    let joints = |value: &str| [value; 9].join(",");
    let angles = format!(r#""angles":[{}]"#, joints("20"));
    let slider = r#""slider":[0,0,-60]"#;
    let needed = format!(r#"{angles},"torques":[{}],{slider}"#, joints("0.25"));
    let plant = |answer: &str| {
        peer(
            &says(&format!(r#""version":2,{answer}"#)),
            &says(&format!(r#""n":$n,{answer}"#)),
        )
    };
    let refused = |answer: &str| {
        let mut run = run_on("hand", "END", &plant(answer))?;
        run.to_end(Limit::NONE);
        match run.plant_error() {
            Some(PlantError::Wrong {
                to: Head::Hello,
                reason,
                ..
            }) => Ok(reason.clone()),
            other => Err(Box::<dyn std::error::Error>::from(format!("{other:?}"))),
        }
    };
    assert_eq!(refused(&angles)?, "missing field `torques`");
    assert_eq!(
        refused(&needed.replace(&format!(",{slider}"), ""))?,
        "missing field `slider`"
    );
    let mut run = run_on("hand", "MESSAGE held\nEND", &plant(&needed))?;
    assert_eq!(run.to_end(Limit::NONE), Ending::Program(End::End));
    // It has no soles that could carry something.
    assert_eq!(
        refused(&format!(r#"{needed},"loads":[1,2,3]"#))?,
        "invalid length 3, expected 0 numbers"
    );
    Ok(())
}
