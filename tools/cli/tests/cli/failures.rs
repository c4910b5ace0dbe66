//! Faults that stop a robot on servos, beside its operator and its program. Each fault is injected here, and the table of
//! docs/drives.md shows the message of the command.

use crate::drives::{crate_for, crate_on};
use crate::endings::{page, replace_part};
use crate::servo_bus::ServoBus;
use crate::support::{Folder, Outcome};
use crate::torque::{Session, WAITS, await_go, leg, signal};
use rustix::process::Signal;
use std::fmt::Write;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread::{scope, sleep};
use std::time::Duration;
use tip_drives::simulated::Servo;

/// A fault, and the words of docs/drives.md about it.
struct Fault {
    name: &'static str,
    outcome: &'static str,
    examples: &'static [Example],
}

/// A run with a fault.
struct Example {
    run: fn() -> Outcome,
    /// Exit status.
    status: i32,
    /// Begin and end of what is seen.
    seen: (&'static str, &'static str),
}

/// A run whose servos do what they are to do.
const GOES_ON: i32 = 0;
/// A run that does not start.
const NO_START: i32 = 1;
/// The emergency stop.
const STOPS: i32 = 3;

const FAULTS: &[Fault] = &[
    Fault {
        name: "damaged, lost, doubled, cut or late answers",
        outcome: "the last angle stands for the missing one; nothing stops",
        examples: &[Example {
            run: || walks("phantomx", "AX-12", "", "faults=0.01"),
            status: GOES_ON,
            seen: ("answers ", " missing"),
        }],
    },
    Fault {
        name: "a servo that is silent for more than `silence` cycles",
        outcome: "emergency stop; at the start, the run does not start",
        examples: &[
            Example {
                run: || walks("phantomx", "AX-12", "", "unplug=7@3"),
                status: STOPS,
                seen: ("J31 (servo 7) has", "cycles"),
            },
            Example {
                run: || walks("phantomx", "AX-12", "", "unplug=7@0"),
                status: NO_START,
                seen: ("J31 (servo 7) has", "cycles"),
            },
        ],
    },
    Fault {
        name: "a machine that is suspended, or too busy to read the servos, for three times `silence` cycles",
        outcome: "emergency stop",
        examples: &[Example {
            run: || suspended("", ("= 200", "= 60"), Duration::from_secs(5)),
            status: STOPS,
            seen: ("J11 (servo 1) was not asked for ", "cycles"),
        }],
    },
    Fault {
        name: "a host or a line to a servo (X, moteus) that is away for longer than the servo's watchdog waits",
        outcome: "emergency stop",
        examples: &[Example {
            run: || {
                // A busy machine must not be away for as long.
                let slow = "[standards]\nperiod = 80";
                suspended(slow, ("STS3215", "XL430-W250"), Duration::from_secs(2))
            },
            status: STOPS,
            seen: ("J11 (servo 1) was stopped by its watchdog", "ms"),
        }],
    },
    Fault {
        name: "a servo that was reset (AX, MX, STS)",
        outcome: "emergency stop",
        examples: &[
            Example {
                run: || walks("phantomx", "AX-12", "", "reset=7@3"),
                status: STOPS,
                seen: ("J31 (servo 7) has lost its torque", ""),
            },
            Example {
                run: || walks("spotmicro", "STS3215", "", "reset=7@3"),
                status: STOPS,
                seen: ("J31 (servo 7) has lost its torque", ""),
            },
        ],
    },
    Fault {
        name: "a joint that is farther than `lag` from its command (a reset X servo, an obstacle of an LX)",
        outcome: "emergency stop",
        examples: &[
            Example {
                run: || walks("spotmicro", "XL430-W250", "lag = [5, 0.5]", "reset=8@3"),
                status: STOPS,
                seen: ("J32 (servo 8) is ", " from its command"),
            },
            Example {
                run: || walks("phantomx", "LX-16A", "lag = [5, 0.5]", "block=7@3"),
                status: STOPS,
                seen: ("J31 (servo 7) is ", " from its command"),
            },
        ],
    },
    Fault {
        name: "more than `overload` of the stall torque for too long",
        outcome: "emergency stop",
        examples: &[Example {
            run: || walks("phantomx", "AX-12", "", "block=7@3"),
            status: STOPS,
            seen: ("J31 (servo 7) needs", " for too long"),
        }],
    },
    Fault {
        name: "more than `temperature`, or a supply outside of `voltage`",
        outcome: "emergency stop",
        examples: &[
            Example {
                run: || walks("phantomx", "AX-12", "", "overheat=7@3"),
                status: STOPS,
                seen: ("J31 (servo 7) has", " is allowed"),
            },
            Example {
                run: || walks("spotmicro", "STS3215", "", "sag=7@3"),
                status: STOPS,
                seen: ("J31 (servo 7) measures", " are allowed"),
            },
        ],
    },
    Fault {
        name: "an alarm of the servo itself",
        outcome: "emergency stop; the servo has switched itself off",
        examples: &[Example {
            run: || walks("phantomx", "AX-12", "temperature = 95", "overheat=7@3"),
            status: STOPS,
            seen: ("J31 (servo 7) has the alarm", ")"),
        }],
    },
    Fault {
        name: "a servo with a setting that gives goals another meaning (wheel, reverse, limits of its own), or of another model",
        outcome: "the run does not start",
        examples: &[
            Example {
                // Velocity control is 1.
                run: || starts(|id| Servo::of("XL430-W250", id, 2048.0).with(11, 1)),
                status: NO_START,
                seen: ("J11 (servo 1) would not go where it is sent", " to it"),
            },
            Example {
                run: || starts(|id| Servo::of("XL330-M288", id, 2048.0)),
                status: NO_START,
                seen: ("J11 (servo 1) reports", "XL430-W250"),
            },
        ],
    },
    Fault {
        name: "a joint that is outside of its limits at the start",
        outcome: "the run does not start",
        examples: &[Example {
            // 3500 - 2048 counts are 127.6 deg.
            run: || starts(|id| Servo::of("XL430-W250", id, 3500.0)),
            status: NO_START,
            seen: ("J11 (servo 1) is at", " deg"),
        }],
    },
    Fault {
        name: "a bus that cannot carry a cycle; a sampling time that is too long for the watchdogs",
        outcome: "the run does not start; emergency stop if a program sets it",
        examples: &[
            Example {
                run: || sets("STS3215", "[standards]\nperiod = 1", "END"),
                status: NO_START,
                seen: ("the bus cannot carry a cycle of ", " ms"),
            },
            Example {
                run: || sets("STS3215", "", "SET_SAMPLING_TIME 1\nSLEEP 100\nEND"),
                status: STOPS,
                seen: ("the bus cannot carry a cycle of ", " ms"),
            },
            Example {
                run: || sets("XL430-W250", "", "SET_SAMPLING_TIME 900\nSLEEP 9000\nEND"),
                status: STOPS,
                seen: ("the sampling time is", " at most"),
            },
        ],
    },
    Fault {
        name: "a command to a posture in which two parts of the robot overlap",
        outcome: "emergency stop before the command is sent; with `collisions = \"warn\"` a warning, and nothing stops",
        examples: &[
            Example {
                run: || crosses("stop"),
                status: STOPS,
                seen: ("link33 and link13 would overlap", ""),
            },
            Example {
                run: || crosses("warn"),
                status: GOES_ON,
                seen: ("warning: link33 and link13 overlap by ", " mm"),
            },
        ],
    },
    Fault {
        name: "the port is gone",
        outcome: "emergency stop; no command reaches the servos",
        examples: &[Example {
            run: || {
                let robot = leg("relax", "relax", "");
                let mut session = Session::new("failures-usb", &robot, 0.5, WAITS);
                let mut child = session.run();
                await_go(&mut child);
                session.bus.hang_up();
                session.ended(child)
            },
            status: STOPS,
            seen: ("the port is gone", ""),
        }],
    },
];

/// Walks on simulated servos, with a line for `[bus]`.
fn walks(robot: &str, servo: &str, line: &str, fault: &str) -> Outcome {
    let folder = match servo {
        "LX-16A" => crate_on(robot, servo),
        _ => crate_for(robot),
    };
    let own = folder.read("it/robot.toml").replace("STS3215", servo);
    let own = own.replace("[bus]\n", &format!("[bus]\n{line}\n"));
    let folder = folder.file("it/robot.toml", own);
    let port = format!("simulated:{fault}");
    let run = [
        "run",
        "it/motions/walk.prg",
        "--hardware",
        "it/robot.toml",
        "--cycles",
        "500",
        "--port",
    ];
    folder.tip(&[&run[..], &[&port]].concat())
}

/// Turns two legs of a walker towards each other, until their links cross.
fn crosses(collisions: &str) -> Outcome {
    let folder = crate_for("phantomx");
    let own = folder.read("it/robot.toml").replace(
        "[bus]\n",
        &format!("[bus]\ncollisions = \"{collisions}\"\n"),
    );
    let program = "PTP_ANGLE F1 -55 0 0\nPTP_ANGLE F3 55 0 0\nSLEEP 3000\nEND";
    let folder = folder
        .file("it/robot.toml", own)
        .program("it/p.prg", program);
    folder.tip(&[
        "run",
        "it/p.prg",
        "--hardware",
        "it/robot.toml",
        "--port",
        "simulated",
    ])
}

/// Runs a leg on a bus in real time, and suspends the command for a time.
fn suspended(table: &str, (from, to): (&str, &str), time: Duration) -> Outcome {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let n = COUNT.fetch_add(1, Ordering::Relaxed);
    let robot = leg("relax", "hold", table).replace(from, to);
    let session = Session::new(&format!("failures-away-{n}"), &robot, 0.5, WAITS);
    let mut child = session.run();
    await_go(&mut child);
    signal(&child, Signal::STOP);
    sleep(time);
    signal(&child, Signal::CONT);
    session.ended(child)
}

/// Starts a leg of XL430 on these servos.
fn starts(servo: fn(u8) -> Servo) -> Outcome {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let n = COUNT.fetch_add(1, Ordering::Relaxed);
    let robot = leg("relax", "hold", "").replace("STS3215", "XL430-W250");
    let mut session = Session::new(&format!("failures-start-{n}"), &robot, 0.5, WAITS);
    session.bus = ServoBus::new((1..=3).map(servo).collect(), 1_000_000);
    let child = session.run();
    session.ended(child)
}

/// Runs a program on a simulated leg, with a table more.
fn sets(servo: &str, table: &str, program: &str) -> Outcome {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let n = COUNT.fetch_add(1, Ordering::Relaxed);
    let periods = "name = \"leg\"\nperiods = [1, 5000]";
    let robot = leg("relax", "hold", table).replace("STS3215", servo);
    let folder = Folder::new(&format!("failures-sets-{n}"))
        .file("robot.toml", robot.replace("name = \"leg\"", periods))
        .program("p.prg", program);
    let run = ["run", "p.prg", "--hardware", "robot.toml"];
    folder.tip(&[&run[..], &["--port", "simulated"]].concat())
}

/// Returns what a run has said of its fault, with `N` for a number that is another one each time.
fn seen(example: &Example) -> String {
    let outcome = (example.run)().expect(example.status);
    let (begin, end) = example.seen;
    let place = outcome.err.find(begin);
    let place = place.unwrap_or_else(|| panic!("no `{begin}`: {}", outcome.err));
    let said = &outcome.err[place..];
    let length = said[begin.len()..].find(end);
    let length = length.unwrap_or_else(|| panic!("no `{end}`: {said}"));
    let said = &said[..begin.len() + length + end.len()];
    match said.split_once("was not asked for ") {
        Some((servo, _)) => format!("{servo}was not asked for N {end}"),
        None => said.to_owned(),
    }
}

fn table() -> String {
    let mut table = String::from("| fault | what happens | what you see |\n|---|---|---|\n");
    let rows = scope(|scope| {
        let example = |example| scope.spawn(move || seen(example));
        let row = |fault: &'static Fault| fault.examples.iter().map(example).collect();
        let rows: Vec<Vec<_>> = FAULTS.iter().map(row).collect();
        let join = |row: Vec<std::thread::ScopedJoinHandle<'_, String>>| {
            let seen = row.into_iter().map(|it| it.join().expect("it is seen"));
            seen.collect::<Vec<_>>()
        };
        rows.into_iter().map(join).collect::<Vec<_>>()
    });
    for (Fault { name, outcome, .. }, mut seen) in FAULTS.iter().zip(rows) {
        seen.dedup();
        let seen = seen.join("`; `");
        writeln!(table, "| {name} | {outcome} | `{seen}` |").expect("a string");
    }
    table
}

#[test]
fn the_docs_show_what_stops_a_robot() {
    replace_part(&page("drives.md"), "stops", &table());
}

/// A status stands for the words about it.
#[test]
fn the_outcome_of_each_fault_is_its_status() {
    for Fault {
        name,
        outcome,
        examples,
    } in FAULTS
    {
        for (status, words) in [
            (GOES_ON, "nothing stops"),
            (NO_START, "the run does not start"),
            (STOPS, "emergency stop"),
        ] {
            let has = examples.iter().any(|example| example.status == status);
            assert_eq!(outcome.contains(words), has, "{name}: {words}");
        }
    }
}
