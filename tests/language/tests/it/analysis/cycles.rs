//! Cycle counts against traces: every stretch, turn and subroutine that a run passes takes as many
//! cycles as the compiler says, where it waits at least so many.

use crate::analysis::programs::{RUNS, Runnable};
use std::collections::{BTreeMap, BTreeSet};
use tip_lint::cycles::{Part, Parts, Sampling, Span, Stop, parts};
use tipc::language::commands;
use tipc::program::{Action, Program, StepId};

/// A cycle of a trace: its number, the step that ran, and the next one.
type Cycle = (u64, StepId, Option<StepId>);

fn cycles(trace: &str) -> Vec<Cycle> {
    let number = |record: &str, key: &str| -> Option<u64> {
        let (_, rest) = record.split_once(&format!("\"{key}\":"))?;
        let end = rest.find(|char: char| !char.is_ascii_digit())?;
        rest[..end].parse().ok()
    };
    let cycle = |record: &str| -> Option<Cycle> {
        let record = record.strip_prefix("{\"cycle\"").map(|_| record)?;
        let step = number(record, "step")? as StepId;
        let next = number(record, "next").map(|next| next as StepId);
        Some((number(record, "cycle")?, step, next))
    };
    trace.lines().filter_map(cycle).collect()
}

/// A subroutine in progress, or the program itself.
#[derive(Default)]
struct Frame {
    /// The step that it was called at, and the cycle of that.
    entry: (StepId, u64),
    /// The last label, and the cycle that reached it.
    label: Option<(StepId, u64)>,
    /// The heads of loops that are turning, and the cycles that reached them.
    turning: BTreeMap<StepId, u64>,
    /// The step before, if it waits: its next visit is none.
    waits_at: Option<StepId>,
}

/// Durations of the runs of one program.
struct Measured<'a> {
    program: &'a Program,
    name: &'a str,
    parts: &'a [Part],
    labels: BTreeSet<StepId>,
    /// For each part, the least and the most that was measured.
    found: BTreeMap<usize, (u64, u64)>,
}

impl Measured<'_> {
    fn follow(&mut self, cycles: &[Cycle]) {
        let mut frames = vec![Frame::default()];
        for (cycle, step, next) in cycles.iter().copied() {
            let Some(mut frame) = frames.pop() else {
                return;
            };
            if frame.waits_at != Some(step) {
                self.visit(&mut frame, cycle, step);
            }
            let action = &self.program.steps()[step as usize].action;
            frame.waits_at = (next == Some(step) && waits(action)).then_some(step);
            match action {
                Action::Return => {
                    let (entry, since) = frame.entry;
                    let is = |span: &Span| *span == Span::Subroutine { entry };
                    self.found(is, cycle + 1 - since);
                    self.stretch(&frame, Stop::Return, cycle + 1);
                    continue;
                }
                Action::Finish(_) => self.stretch(&frame, Stop::End, cycle + 1),
                _ => {}
            }
            frames.push(frame);
            match action {
                Action::Gosub { to } | Action::IfGosub { to, .. } if next == Some(*to) => {
                    frames.push(Frame {
                        entry: (*to, cycle + 1),
                        ..Frame::default()
                    });
                }
                _ => {}
            }
        }
    }

    fn visit(&mut self, frame: &mut Frame, cycle: u64, step: StepId) {
        if self.labels.contains(&step) || cycle == 0 {
            self.stretch(frame, Stop::Label(step), cycle);
            frame.label = Some((step, cycle));
        }
        let parts = self.parts;
        for (index, part) in parts.iter().enumerate() {
            let Span::Turn { head, steps, .. } = &part.span else {
                continue;
            };
            if *head == step {
                if let Some(since) = frame.turning.insert(step, cycle) {
                    self.note(index, cycle - since);
                }
            } else if !steps.contains(&step) {
                frame.turning.remove(head);
            }
        }
    }

    fn stretch(&mut self, frame: &Frame, stop: Stop, cycle: u64) {
        if let Some((label, since)) = frame.label {
            let is = |span: &Span| {
                *span
                    == Span::Stretch {
                        from: label,
                        to: stop,
                    }
            };
            self.found(is, cycle - since);
        }
    }

    fn found(&mut self, is: impl Fn(&Span) -> bool, cycles: u64) {
        let index = self.parts.iter().position(|part| is(&part.span));
        let index = index.unwrap_or_else(|| panic!("{}: a way that is unknown", self.name));
        self.note(index, cycles);
    }

    fn note(&mut self, index: usize, cycles: u64) {
        let part = &self.parts[index];
        let too_many = |max| cycles > max && !part.cycles.waits;
        let fits = cycles >= part.cycles.min && !part.cycles.max.is_some_and(too_many);
        assert!(fits, "{}: {cycles} cycles of {part:?}", self.name);
        let (least, most) = self.found.entry(index).or_insert((cycles, cycles));
        *least = cycles.min(*least);
        *most = cycles.max(*most);
    }
}

fn waits(action: &Action) -> bool {
    match action {
        Action::KeyIn { .. } => true,
        Action::Command { op, .. } => commands::waits(*op),
        _ => false,
    }
}

/// An IF … GOSUB to the step after it cannot be followed in a trace.
fn is_plain(program: &Program) -> bool {
    (1..)
        .zip(program.steps())
        .all(|(next, step)| match step.action {
            Action::IfGosub { to, .. } => to != next,
            _ => true,
        })
}

/// The least and the most cycles of each part that a run passed.
fn measure(one: &Runnable, trace: &str) -> Vec<(Part, (u64, u64))> {
    let program = &one.program;
    let Parts { counted, has_more } = parts(program, Sampling::of(one.settings.load.robot));
    assert!(!has_more, "{}", one.name);
    let parts = counted;
    let mut measured = Measured {
        program,
        name: &one.name,
        parts: &parts,
        labels: program.labels().iter().map(|label| label.step).collect(),
        found: BTreeMap::new(),
    };
    measured.follow(&cycles(trace));
    let found = measured.found.into_iter();
    found
        .map(|(index, both)| (parts[index].clone(), both))
        .collect()
}

// clauses: 2.1 2.3
#[test]
fn no_trace_contradicts_a_count() {
    let (mut exact, mut between, mut tight, mut waiting) = (0, 0, 0, 0);
    // A cycle of several steps says nothing about the cycles that each would take.
    let plain = RUNS
        .traces
        .iter()
        .filter(|(one, trace)| is_plain(&one.program) && !trace.contains("\"sub\":"));
    for (one, trace) in plain {
        for (part, found) in measure(one, trace) {
            match part.cycles.max {
                _ if part.cycles.waits => waiting += 1,
                Some(max) if max == part.cycles.min => exact += 1,
                max => {
                    between += 1;
                    tight += u64::from(Some(found.1) == max && found.0 == part.cycles.min);
                }
            }
        }
    }
    println!(
        "{exact} parts take what is said, {between} more or less, {tight} of them both bounds, {waiting} wait"
    );
    assert!(exact > 500, "{exact}");
    assert!(between > 200, "{between}");
    assert!(tight > 5, "{tight}");
}
