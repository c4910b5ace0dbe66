//! A control cycle of a compiled program takes nothing from the heap, on any robot.

use allocation_counter::measure;
use cycle::runs::{self, Run, finish};
use std::fmt::{Display, Write};
use tip_runtime::console::Console;
use tip_runtime::fault::Fault;
use tip_runtime::machine::{Machine, Report, Status};
use tip_runtime::model::generic;
use tip_runtime::plant::SimulatedPlant;
use tip_runtime::record::{Dump, Sample};

/// Cycles after the end of a program, in which the robot is held or stopped.
const BEYOND: usize = 100;

#[track_caller]
fn assert_no_heap(mut run: impl Run) {
    let heap = measure(|| {
        finish(&mut run);
        for _ in 0..BEYOND {
            run.cycle();
        }
    });
    assert_eq!(heap.count_total, 0);
}

#[test]
fn titan_walks() {
    assert_no_heap(runs::walk());
}

#[test]
fn a_described_robot_walks() {
    assert_no_heap(runs::six_legs());
}

#[test]
fn the_hand_grasps() {
    assert_no_heap(runs::grasp());
}

tip_macros::tip!(
    Busy,
    r#"3.1
Logs, messages, a dump of variables, and a fault
DEF_VAR N, B
LOG_START
N = 3
PTP_ANGLE J11 20
FOR B = 1 TO 20
  MESSAGE %N.3% and %B%
NEXT B
OUTPUT_VARIABLES
LOG_STOP
B = 0
N = N / B
END"#,
    robot = generic
);

/// A console that writes every text into room of its own.
struct Pad {
    line: [u8; 4096],
    length: usize,
    samples: usize,
}

impl Pad {
    fn show(&mut self, text: &dyn Display) {
        self.length = 0;
        write!(self, "{text}").expect("the text fits");
    }

    fn text(&self) -> &str {
        std::str::from_utf8(&self.line[..self.length]).expect("written as text")
    }
}

impl Write for Pad {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        let room = self.line.get_mut(self.length..self.length + text.len());
        room.ok_or(std::fmt::Error)?
            .copy_from_slice(text.as_bytes());
        self.length += text.len();
        Ok(())
    }
}

impl Console for Pad {
    fn message(&mut self, text: &dyn Display) {
        self.show(text);
    }
    fn sample(&mut self, _sample: &Sample<'_>) {
        self.samples += 1;
    }
    fn variables(&mut self, dump: &Dump<'_>) {
        self.show(dump);
    }
    fn emergency(&mut self, report: &Report<'_>) {
        self.show(report);
    }
}

#[test]
fn neither_do_logs_messages_dumps_and_an_emergency() {
    let plant = SimulatedPlant::new(&generic::MODEL);
    let pad = Pad {
        line: [0; 4096],
        length: 0,
        samples: 0,
    };
    let mut machine = Machine::new(Busy::new(), &generic::MODEL, plant)
        .expect("generic")
        .with_console(pad);
    let heap = measure(|| {
        finish(&mut machine);
        for _ in 0..BEYOND {
            machine.cycle();
        }
    });
    assert_eq!(heap.count_total, 0);
    assert_eq!(machine.status(), Status::Emergency);
    let emergency = machine.emergency().expect("in emergency");
    assert_eq!(emergency.fault, Fault::Domain);
    let pad = machine.console();
    assert!(pad.text().starts_with("TIP_ERR:"), "{}", pad.text());
    assert!(pad.samples > 20, "{} samples", pad.samples);
}

#[test]
fn the_counter_counts() {
    let heap = measure(|| drop(std::hint::black_box(vec![1_u8])));
    assert_eq!(heap.count_total, 1);
}
