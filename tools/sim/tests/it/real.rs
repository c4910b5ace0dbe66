//! Programs on a real robot, whose servos measure joints and nothing else.

use std::error::Error;
use tip_runtime::command::Port;
use tip_runtime::fault::{Fault, HardwareFault};
use tip_runtime::hardware::JointCommand;
use tip_sim::{Events, Joints, Limit, Robot, Run, load};
use tipc::code::Code;
use tipc::message::Lang;

type Outcome = Result<(), Box<dyn Error>>;

/// Joints that are where they were commanded to be.
struct Servos(Vec<f64>);

impl Joints for Servos {
    fn read(&mut self, angles: &mut [f64], _: &mut [u32]) -> Result<(), HardwareFault> {
        angles.copy_from_slice(&self.0);
        Ok(())
    }

    fn write(&mut self, commands: &[JointCommand], _: f64) -> Result<(), HardwareFault> {
        self.0 = commands.iter().map(|command| command.value()).collect();
        Ok(())
    }

    fn stop(&mut self, _: &Fault) -> Result<(), HardwareFault> {
        Ok(())
    }
}

fn run(edition: &str, statements: &str, events: &str) -> Result<Run, Box<dyn Error>> {
    let robot = Robot::named("titan8")?;
    let program = load("p.prg", &format!("{edition}\nt\n{statements}\n"), &robot)?;
    let legs = robot.description().legs;
    let initial = legs.iter().flat_map(|leg| leg.initial.clone()).collect();
    let run = Run::real(program, &robot, Servos(initial))?;
    Ok(run.events(events)?)
}

// clauses: 7.32
#[test]
fn an_absent_input_is_no_number_on_a_real_robot() -> Outcome {
    let absent = |port| Some(Fault::Sensor(port));
    for (statements, events, expected) in [
        ("DEF_VAR V\nAD_IN VR1 V\nEND", "", absent(Port::Knob(1))),
        (
            "DEF_VAR V\nAD_IN 0 14 V\nEND",
            "",
            absent(Port::Channel(14)),
        ),
        ("DEF_VAR V\nAD_IN PAW2 V\nEND", "", absent(Port::Paw(2))),
        ("DEF_VAR V\nAD_IN ANTENNA V\nEND", "", absent(Port::Antenna)),
        ("DETECT_FLOOR F3 2\nEND", "", absent(Port::Paw(3))),
        // Joints are measured.
        ("DEF_VAR V\nAD_IN J11 V\nAD_IN 0 0 V\nEND", "", None),
        // An input that an event provides exists from then on, and no other one.
        ("DEF_VAR V\nAD_IN VR1 V\nEND", "0:VR1=5", None),
        ("DEF_VAR V\nAD_IN 0 13 V\nEND", "0:VR1=5", None),
        (
            "DEF_VAR V\nAD_IN VR1 V\nEND",
            "1:VR1=5",
            absent(Port::Knob(1)),
        ),
        (
            "DEF_VAR V\nAD_IN VR2 V\nEND",
            "0:VR1=5",
            absent(Port::Knob(2)),
        ),
    ] {
        for edition in ["3.1", "3.2"] {
            let mut run = run(edition, statements, events)?;
            run.to_end(Limit::cycles(100));
            let fault = run.emergency().map(|emergency| emergency.fault);
            assert_eq!(fault, expected, "{edition} {statements} {events}");
        }
    }
    let mut run = run("3.1", "DEF_VAR V\nAD_IN VR1 V\nEND", "0:VR1=5")?;
    run.to_end(Limit::NONE);
    assert_eq!(run.program().get("V"), Ok(Some(5.0)));
    Ok(())
}

#[test]
fn a_program_that_reads_an_absent_input_is_refused_before_the_robot_moves() -> Outcome {
    let titan8 = Robot::named("titan8")?;
    let hand = Robot::named("hand")?;
    for (robot, statements, events, lines) in [
        (
            &titan8,
            "DEF_VAR V\nAD_IN VR1 V\nAD_IN VR2 V\nEND",
            "",
            &[4, 5][..],
        ),
        (
            &titan8,
            "DEF_VAR V\nAD_IN VR1 V\nAD_IN VR2 V\nEND",
            "9:VR2=1",
            &[4],
        ),
        (
            &titan8,
            "DEF_VAR V\nAD_IN 0 13 V\nAD_IN 0 15 V\nEND",
            "0:VR3=1",
            &[4],
        ),
        // Channels 0 to 11 are joints; nothing is connected to 12.
        (
            &titan8,
            "DEF_VAR V\nAD_IN 0 11 V\nAD_IN 0 12 V\nEND",
            "",
            &[5],
        ),
        (
            &titan8,
            "DEF_VAR V\nAD_IN J43 V\nPTP_ANGLE J11 5\nEND",
            "",
            &[],
        ),
        (
            &titan8,
            "DETECT_FLOOR F2 2\nDETECT_FLOOR ALL 2\nEND",
            "0:PAW2=0",
            &[4],
        ),
        (&titan8, "IF KB_HIT GOTO L:\nL:\nEND", "", &[]),
        // The fingers of a hand feel by torque.
        (&hand, "DETECT_FLOOR F2 2\nEND", "", &[]),
        (&hand, "IF ANTENNA_ON GOTO L:\nL:\nEND", "", &[3]),
        (&hand, "WHILE ANTENNA_ON\nWEND\nEND", "0:ANTENNA=0", &[]),
    ] {
        let text = format!("3.1\nt\n{statements}\n");
        let loaded = tip_lint::load("p.prg", text.as_bytes(), &robot.options());
        assert!(loaded.program.is_some(), "{statements}");
        let events: Events = events.parse()?;
        let found = robot.unconnected(&loaded, &events);
        let at = found.iter().map(|one| {
            assert_eq!(one.code, Code::Argument);
            text[..one.span.start].lines().count().max(1)
                + usize::from(text[..one.span.start].ends_with('\n'))
        });
        assert_eq!(at.collect::<Vec<_>>(), lines, "{statements}");
        if let Some(first) = found.first().filter(|_| statements.contains("AD_IN VR1")) {
            let help = first
                .help
                .as_ref()
                .map(|help| help.in_lang(Lang::English).to_string());
            assert_eq!(
                help.as_deref(),
                Some("give it a value in V: `--sensor VR1=5@0`")
            );
        }
    }
    Ok(())
}
