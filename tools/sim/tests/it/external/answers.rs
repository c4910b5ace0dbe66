//! Answers that are accepted, and those that are not.

use super::peer::{
    ANGLES, ECHO, NOD, Outcome, PATIENCE, in_cycle_3, peer, ready, run, run_on, stopped,
};
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::external::{Head, PlantError};
use tip_sim::{ExternalPlant, Limit, Plant, Refused, Robot, Run, load};

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
    let other = in_cycle_3("echo \"state n=$n angles=0.125,${targets#*,}\"");
    assert_ne!(trace(run(NOD, &other)?)?, inside);
    Ok(())
}

#[test]
fn the_example_of_the_guide_simulates() -> Outcome {
    let guide = include_str!("../../../../../docs/external-plant.md");
    let (_, script) = guide.split_once("```sh\nwhile").ok_or("no script")?;
    let (script, _) = script.split_once("```\n").ok_or("no end")?;
    let script = format!("while{script}");
    let plant = ExternalPlant::new("sh", ["-c", script.as_str()]).with_time_limits(PATIENCE);
    let as_ever = trace(run(NOD, &peer(&ready(), ECHO))?)?;
    assert_eq!(trace(run(NOD, &plant)?)?, as_ever);
    Ok(())
}

#[test]
fn blanks_and_the_order_of_keys_do_not_matter() -> Outcome {
    let as_ever = trace(run(NOD, &peer(&ready(), ECHO))?)?;
    let other = in_cycle_3("printf '  state\\tangles=%s   n=%s  \\r\\n' \"$targets\" \"$n\"");
    assert_eq!(trace(run(NOD, &other)?)?, as_ever);
    Ok(())
}

#[test]
fn numbers_may_be_written_as_usual() -> Outcome {
    let ready = "echo \"ready version=1 angles=0,-0,+9.0e1,0,0,90.,.0,0,90,0,0,90\"";
    trace(run(NOD, &peer(ready, ECHO))?)?;
    Ok(())
}

#[test]
fn a_line_that_is_no_answer() -> Outcome {
    let (word, cycle, trouble) = stopped(&in_cycle_3("echo \"step 3 done\""))?;
    assert_eq!((word, cycle), ("plant: wrong answer", 4));
    let line = "step 3 done".to_owned();
    assert_eq!(
        trouble,
        PlantError::Garbage {
            to: TO,
            line,
            begins: "state"
        }
    );
    assert_eq!(
        trouble.to_string(),
        "the external plant's answer to 'cycle n=3' is 'step 3 done'; it has to begin with 'state'"
    );
    // What a library says at its start.
    let loud = peer(&format!("echo Welcome; {}", ready()), ECHO);
    let (word, cycle, trouble) = stopped(&loud)?;
    assert_eq!((word, cycle), ("plant: wrong answer", 0));
    let line = "Welcome".to_owned();
    assert_eq!(
        trouble,
        PlantError::Garbage {
            to: Head::Hello,
            line,
            begins: "ready"
        }
    );
    Ok(())
}

#[test]
fn what_it_says_is_shown_printable_and_in_part() -> Outcome {
    let (_, _, trouble) = stopped(&in_cycle_3("printf '\\033[2J%0100d\\n' 7"))?;
    let text = trouble.to_string();
    assert!(
        !text.contains('\u{1b}') && text.contains('…') && text.len() < 200,
        "{text}"
    );
    Ok(())
}

#[test]
fn bytes_that_are_no_text() -> Outcome {
    let (word, _, trouble) = stopped(&in_cycle_3("printf 'state n=3 \\377\\n'"))?;
    assert_eq!(
        (word, trouble),
        ("plant: wrong answer", PlantError::NotText { to: TO })
    );
    Ok(())
}

#[test]
fn too_few_numbers_and_too_many() -> Outcome {
    for (found, numbers) in [(11, "${targets#*,}"), (13, "0,$targets"), (0, "")] {
        let (word, _, trouble) =
            stopped(&in_cycle_3(&format!("echo \"state n=3 angles={numbers}\"")))?;
        let count = PlantError::Count {
            to: TO,
            key: "angles",
            wanted: 12,
            found,
        };
        assert_eq!((word, trouble), ("plant: wrong answer", count));
    }
    Ok(())
}

#[test]
fn what_is_not_a_number_has_its_place() -> Outcome {
    let does = "echo \"state n=3 angles=0,0,90,0,fast,90,0,0,90,0,0,90\"";
    let (word, _, trouble) = stopped(&in_cycle_3(does))?;
    assert_eq!(word, "plant: wrong answer");
    assert_eq!(
        trouble.to_string(),
        "the external plant's answer to 'cycle n=3': 'fast' is not a number ('angles' of J22)"
    );
    Ok(())
}

#[test]
fn what_is_not_finite_has_its_place() -> Outcome {
    for number in ["nan", "NaN", "inf", "-inf", "1e999"] {
        let does = format!("echo \"state n=3 angles=0,0,90,0,0,90,{number},0,90,0,0,90\"");
        let (word, _, trouble) = stopped(&in_cycle_3(&does))?;
        assert_eq!(word, "plant: answer is not finite", "{number}");
        let place = "J31".to_owned();
        assert_eq!(
            trouble,
            PlantError::NotFinite {
                to: TO,
                key: "angles",
                place
            }
        );
    }
    Ok(())
}

#[test]
fn the_answer_to_another_cycle() -> Outcome {
    for found in ["2", "4", "3.0", "x"] {
        let does = format!("echo \"state n={found} angles=$targets\"");
        let (word, _, trouble) = stopped(&in_cycle_3(&does))?;
        assert_eq!(word, "plant: answer to another cycle");
        assert_eq!(
            trouble,
            PlantError::Cycle {
                to: TO,
                found: found.to_owned()
            }
        );
    }
    // Two answers to one line.
    let (word, cycle, _) = stopped(&in_cycle_3(&format!("{ECHO}; {ECHO}")))?;
    assert_eq!((word, cycle), ("plant: answer to another cycle", 5));
    Ok(())
}

#[test]
fn words_that_an_answer_has_not() -> Outcome {
    for word in ["angels=0", "version=1", "angles", "=1"] {
        let (_, _, trouble) = stopped(&in_cycle_3(&format!("{ECHO}\" {word}\"")))?;
        assert_eq!(
            trouble,
            PlantError::Word {
                to: TO,
                word: word.to_owned()
            }
        );
    }
    let (_, _, trouble) = stopped(&in_cycle_3(&format!("{ECHO}\" angles=1\"")))?;
    assert_eq!(
        trouble,
        PlantError::Twice {
            to: TO,
            key: "angles"
        }
    );
    let (_, _, trouble) = stopped(&in_cycle_3("echo state n=3"))?;
    assert_eq!(
        trouble,
        PlantError::Missing {
            to: TO,
            key: "angles"
        }
    );
    Ok(())
}

#[test]
fn another_version() -> Outcome {
    let (word, cycle, trouble) = stopped(&peer(&format!("echo ready version=2 {ANGLES}"), ECHO))?;
    assert_eq!((word, cycle), ("plant: other version", 0));
    assert_eq!(
        trouble,
        PlantError::Version {
            found: "2".to_owned()
        }
    );
    let (_, _, trouble) = stopped(&peer(&format!("echo ready {ANGLES}"), ECHO))?;
    assert_eq!(
        trouble,
        PlantError::Missing {
            to: Head::Hello,
            key: "version"
        }
    );
    Ok(())
}

#[test]
fn lines_may_be_long_but_not_endless() -> Outcome {
    let of = |bytes: usize| format!("printf '%-{bytes}s\\n' \"state n=3 angles=$targets\"");
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
    let ready = format!("{}' loads=50,40,30,20'", ready());
    let (_, _, trouble) = stopped(&peer(&ready, ECHO))?;
    assert_eq!(
        trouble,
        PlantError::Missing {
            to: Head::Cycle(0),
            key: "loads"
        }
    );
    Ok(())
}

#[test]
fn loads_are_what_soles_read_and_events_take_their_place() -> Outcome {
    // 200 N are 5 V.
    let with_loads = |line: &str| format!("{line}' loads=50,40,30,20'");
    let plant = peer(&with_loads(&ready()), &with_loads(ECHO));
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
    let each = format!("{pose}; {ECHO}\" pose=3,$((m * 10)),250,0,0,$a\"");
    let ready = format!("{}' pose=1,0,240,0,0,0'", ready());
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
    let angles = format!("angles={}", joints("20"));
    let needed = format!("{angles} torques={} slider=0,0,-60", joints("0.25"));
    let plant = |answer: &str| {
        peer(
            &format!("echo ready version=1 {answer}"),
            &format!("echo state n=$n {answer}"),
        )
    };
    let missing = |answer: &str| {
        let mut run = run_on("hand", "END", &plant(answer))?;
        run.to_end(Limit::NONE);
        let trouble = run.plant_error().cloned();
        trouble.ok_or_else(|| Box::<dyn std::error::Error>::from("no trouble"))
    };
    let of = |key| PlantError::Missing {
        to: Head::Hello,
        key,
    };
    assert_eq!(missing(&angles)?, of("slider"));
    assert_eq!(missing(&format!("{angles} slider=0,0,-60"))?, of("torques"));
    let mut run = run_on("hand", "MESSAGE held\nEND", &plant(&needed))?;
    assert_eq!(run.to_end(Limit::NONE), Ending::Program(End::End));
    // It has no soles that could carry something.
    let (_, loads) = (of("loads"), format!("{needed} loads=1,2,3"));
    let count = PlantError::Count {
        to: Head::Hello,
        key: "loads",
        wanted: 0,
        found: 3,
    };
    assert_eq!(missing(&loads)?, count);
    Ok(())
}
