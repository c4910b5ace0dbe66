//! Assignment judged against every run there is, and against gaps reasoned by hand.

use super::{Assigned, Assignment, Gap, Paths, Read, gaps};
use crate::analysis::access;
use crate::program::{Action, Program};
use crate::{Options, load};
use std::collections::{BTreeMap, HashSet};
use std::fmt::Write as _;
use tip_runtime::random::Random;

fn program(text: &str) -> Program {
    let loaded = load("test.prg", text.as_bytes(), &Options::default());
    let reported = loaded.diagnostics;
    loaded
        .program
        .unwrap_or_else(|| panic!("{reported:#?}\n{text}"))
}

/// Returns the gaps of statements: line 3 is the first.
fn gaps_of(statements: &str) -> Vec<Gap> {
    let program = program(&format!("3.1\ntest\n{statements}\n"));
    gaps(&program, &Assignment::of(&program))
}

/// Returns step, kind and path of the only gap.
fn only_gap(statements: &str) -> (u32, Assigned, Vec<u32>) {
    match gaps_of(statements).as_slice() {
        [gap] => (gap.step, gap.assigned, gap.path.clone()),
        others => panic!("{others:#?}"),
    }
}

// clauses: 3.4
#[test]
fn straight_lines_have_gaps_before_the_assignment() {
    assert_eq!(gaps_of("DEF_VAR A B\nA = 1\nB = A\nA = B\nEND"), []);
    let never = only_gap("DEF_VAR A B\nB = A\nA = B\nEND");
    assert_eq!(never, (0, Assigned::Never, vec![0]));
    // What was read has a value after the read: one cause, one gap.
    let never = only_gap("DEF_VAR A B\nB = A\nB = A\nA = B\nB = A\nEND");
    assert_eq!(never, (0, Assigned::Never, vec![0]));
    // The first turn never gets past the read.
    let never = only_gap("DEF_VAR A B\nLOOP:\nB = A\nA = B\nGOTO\nEND");
    assert_eq!(never, (1, Assigned::Never, vec![0, 1]));
}

// clauses: 2.6 2.7 2.8 2.9 2.20 3.4
#[test]
fn branches_count_as_they_are_reached() {
    let all = "DEF_VAR A\nIF KB_HIT THEN\nA = 1\nELSEIF HALT_REQUEST THEN\nA = 2\nELSE\nA = 3\nENDIF\nMESSAGE %A%\nEND";
    assert_eq!(gaps_of(all), []);
    let no_else = "DEF_VAR A\nIF KB_HIT THEN\nA = 1\nELSEIF HALT_REQUEST THEN\nA = 2\nENDIF\nMESSAGE %A%\nEND";
    assert_eq!(
        only_gap(no_else),
        (5, Assigned::Sometimes, vec![0, 2, 4, 5])
    );
    // An ELSEIF that is passed does not read its condition.
    let passed = "DEF_VAR A\nA = 1\nIF A > 2 THEN\nREM\nELSEIF A > 1 THEN\nREM\nENDIF\nEND";
    assert_eq!(gaps_of(passed), []);
}

// clauses: 2.10 2.11 2.12 2.13 3.4
#[test]
fn loops_run_as_often_as_is_known() {
    assert_eq!(
        gaps_of("DEF_VAR A I\nFOR I = 1 TO 2\nA = I\nNEXT\nMESSAGE %A%\nEND"),
        []
    );
    assert_eq!(
        gaps_of("DEF_VAR A\nREPEAT\nA = 1\nUNTIL KB_HIT\nMESSAGE %A%\nEND"),
        []
    );
    let open = "DEF_VAR A I N\nN = 2\nFOR I = 1 TO N\nA = I\nNEXT\nMESSAGE %A%\nEND";
    assert_eq!(only_gap(open), (4, Assigned::Sometimes, vec![0, 1, 4]));
    let open = "DEF_VAR A\nWHILE KB_HIT\nA = 1\nWEND\nMESSAGE %A%\nEND";
    assert_eq!(only_gap(open), (3, Assigned::Sometimes, vec![0, 3]));
    let entered = "DEF_VAR I\nGOTO L1:\nFOR I = 1 TO 2\nL1: NEXT\nEND";
    assert_eq!(only_gap(entered), (3, Assigned::Never, vec![0, 2, 3]));
}

// clauses: 2.15 2.16 3.4
#[test]
fn calls_come_back_where_they_were_made() {
    let assigns = "DEF_VAR A\nGOSUB L1:\nMESSAGE %A%\nEXIT\nL1: A = 1\nRETURN\nEND";
    assert_eq!(gaps_of(assigns), []);
    // The second call may rely on the first; the subroutine itself may not.
    let reads = "DEF_VAR A\nGOSUB L1:\nA = 1\nGOSUB L1:\nEXIT\nL1: MESSAGE %A%\nRETURN\nEND";
    assert_eq!(only_gap(reads), (5, Assigned::Never, vec![0, 4, 5]));
    // A call that assigns nothing is passed as one step.
    let passes = "DEF_VAR A\nGOSUB L1:\nMESSAGE %A%\nA = 1\nEXIT\nL1: REM\nRETURN\nEND";
    assert_eq!(only_gap(passes), (1, Assigned::Never, vec![0, 1]));
    let sometimes =
        "DEF_VAR A\nGOSUB L1:\nMESSAGE %A%\nEXIT\nL1: IF KB_HIT GOTO L2:\nA = 1\nL2: RETURN\nEND";
    assert_eq!(only_gap(sometimes), (1, Assigned::Sometimes, vec![0, 1]));
    // One call assigns, the other does not: the returns must not be mixed up.
    let matched = "DEF_VAR A B\nGOSUB L1:\nA = 1\nGOSUB L1:\nB = A\nEXIT\nL1: B = 2\nRETURN\nEND";
    assert_eq!(gaps_of(matched), []);
}

// clauses: 2.15 3.4
#[test]
fn recursion_ends_where_some_path_returns() {
    let endless = "DEF_VAR A\nGOSUB L1:\nMESSAGE %A%\nA = 1\nEXIT\nL1: GOSUB L1:\nRETURN\nEND";
    assert_eq!(gaps_of(endless), [], "the call never comes back");
    let bounded =
        "DEF_VAR A\nGOSUB L1:\nMESSAGE %A%\nEXIT\nL1: IF KB_HIT GOSUB L1:\nA = 1\nRETURN\nEND";
    assert_eq!(gaps_of(bounded), []);
}

// clauses: 3.4 7.17 7.32 7.33
#[test]
fn members_count_one_by_one() {
    let partly = "DEF_POS P\nP.X = 1\nP.Z = 2\nPTP F1 P\nEND";
    let found = gaps_of(partly);
    let [gap] = found.as_slice() else {
        panic!("{found:#?}")
    };
    // VAR_KEY is scalar 0, P.X is 1.
    assert_eq!(
        (&gap.scalars[..], gap.assigned),
        (&[2][..], Assigned::Never)
    );
    let measured = "DEF_POS P\nDEF_JOINT Q\nDEF_VAR A\nTEACH_POSITION F1 P\nTEACH_ANGLE F1 Q\nAD_IN VR1 A\nKEY_IN\n\
        PTP F1 P\nPTP_ANGLE F1 Q\nMESSAGE %A% %VAR_KEY%\nEND";
    assert_eq!(gaps_of(measured), []);
}

#[test]
fn what_no_run_reaches_is_no_gap() {
    assert_eq!(gaps_of("END"), []);
    assert_eq!(gaps_of("DEF_VAR A B\nEXIT\nB = A\nA = B\nEND"), []);
    assert_eq!(
        gaps_of("DEF_VAR A B\nIF 1 > 2 THEN\nB = A\nENDIF\nA = 1\nB = A\nEND"),
        []
    );
}

// clauses: 2.7 2.8 2.9 2.15 2.16 2.20 3.4
#[test]
fn judgement_is_what_every_run_finds() {
    let mut compared = 0;
    let mut kinds = [0; 3];
    for seed in 0..300 {
        let text = random_program(seed);
        let program = program(&text);
        let judged = Assignment::of(&program);
        for scalar in 0..program.scalar_count() {
            let Some(found) = explored(&program, scalar) else {
                continue;
            };
            let expected: Vec<Read> = found
                .into_iter()
                .map(|(step, (with, without))| Read {
                    step,
                    scalar,
                    assigned: match (with, without) {
                        (true, false) => Assigned::Always,
                        (true, true) => Assigned::Sometimes,
                        _ => Assigned::Never,
                    },
                })
                .collect();
            let reads = judged.reads().iter().copied();
            let reads: Vec<Read> = reads.filter(|read| read.scalar == scalar).collect();
            assert_eq!(reads, expected, "scalar {scalar} of\n{text}");
            compared += 1;
            for read in reads {
                kinds[read.assigned as usize] += 1;
            }
        }
    }
    assert!(compared > 1_000, "{compared} scalars");
    assert!(kinds.iter().all(|count| *count > 100), "{kinds:?}");
}

// clauses: 3.4
#[test]
fn each_path_is_a_run_without_the_value() {
    let mut walked = 0;
    for seed in 0..300 {
        let text = random_program(seed);
        let program = program(&text);
        for gap in gaps(&program, &Assignment::of(&program)) {
            let (last, before) = gap.path.split_last().expect("a path");
            assert_eq!((gap.path[0], *last), (0, gap.step), "{text}");
            for step in before {
                let action = &program.steps()[*step as usize].action;
                let assigned = access::assigns(&program, action);
                assert!(!assigned.contains(&gap.scalars[0]), "{gap:?} of\n{text}");
            }
            walked += 1;
        }
    }
    assert!(walked > 300, "{walked} paths");
}

/// Returns a program of that many steps: nested blocks, calls, a hundred variables assigned at the end only.
fn long(steps: usize) -> String {
    let mut text = "3.1\nlong\n".to_owned();
    for name in 0..100 {
        writeln!(text, "DEF_VAR V{name}").expect("writing to a string");
    }
    for n in 0..steps / 10 {
        let name = n % 100;
        write!(
            text,
            "LOOP:\nIF KB_HIT THEN\nIF HALT_REQUEST GOSUB R:\nELSEIF KB_HIT THEN\nMESSAGE %V{name}%\nELSE\nREM\nENDIF\n\
             IF KB_HIT GOTO\nV{name} = 1\n"
        )
        .expect("writing to a string");
    }
    text += "EXIT\nR: RETURN\nEND\n";
    text
}

/// Nested blocks, calls and many variables: all of it is judged.
#[test]
fn a_long_program_is_judged() {
    let program = program(&long(10_000));
    let assignment = Assignment::of(&program);
    assert!(assignment.is_complete());
    let read: usize = assignment.reads().len();
    // One MESSAGE in each of the thousand turns.
    assert_eq!(read, 1_000);
}

/// Returns the reads of a program of 3.2, as they are proved and as paths find them.
fn threads_of(statements: &str) -> (Assignment, Assignment) {
    let program = program(&format!("3.2\ntest\n{statements}\n"));
    (Assignment::of(&program), Paths::of(&program).assignment)
}

fn assigned(reads: &Assignment, step: u32) -> Vec<Assigned> {
    let here = reads.reads().iter().filter(|read| read.step == step);
    here.map(|read| read.assigned).collect()
}

// clauses: 12.4
#[test]
fn what_another_thread_assigns_counts_and_proves_nothing() {
    let text = "DEF_VAR A B\nSTART_THREAD T:\nSLEEP A\nB = 1\nEXIT\nTHREAD T:\nA = 1\nSLEEP B\nSLEEP A\nTHREADEND\nEND";
    let (proved, on_paths) = threads_of(text);
    // The main program may read A before the thread has assigned it.
    assert_eq!(assigned(&proved, 1), [Assigned::Never]);
    assert_eq!(assigned(&on_paths, 1), [Assigned::Always]);
    assert_eq!(assigned(&proved, 6), [Assigned::Never]);
    assert_eq!(assigned(&on_paths, 6), [Assigned::Always]);
    // A thread's own assignments are a proof.
    assert_eq!(assigned(&proved, 7), [Assigned::Always]);
}

// clauses: 12.4
#[test]
fn a_part_that_threads_share_has_a_value_only_if_each_brings_it() {
    let text = "DEF_VAR A\nSTART_THREAD T:\nA = 1\nGOSUB SHOW:\nEXIT\nSHOW:\nSLEEP A\nRETURN\nEXIT\nTHREAD T:\nGOSUB SHOW:\nTHREADEND\nEND";
    let (proved, on_paths) = threads_of(text);
    assert_eq!(assigned(&proved, 5), [Assigned::Sometimes]);
    assert_eq!(assigned(&on_paths, 5), [Assigned::Always]);
}

// clauses: 13.3
#[test]
fn what_native_code_shares_has_a_value_from_the_start() {
    let text = "SLEEP VAR_SPECIAL_1\nPTP F1 POS_SPECIAL_2\nEND";
    let (proved, _) = threads_of(text);
    assert_eq!(assigned(&proved, 0), [Assigned::Always]);
    assert_eq!(assigned(&proved, 1), [Assigned::Always; 3]);
}

/// Step number, "not taken", open calls, and whether the scalar has a value.
type Place = (u32, bool, Vec<u32>, bool);

/// Explores what every run, for any answers of the robot, finds at the reads of one scalar: with a value,
/// without one. `None` if there are too many runs.
fn explored(program: &Program, scalar: usize) -> Option<BTreeMap<u32, (bool, bool)>> {
    let mut found: BTreeMap<u32, (bool, bool)> = BTreeMap::new();
    let mut seen = HashSet::new();
    let mut open: Vec<Place> = vec![(0, false, Vec::new(), false)];
    while let Some(place) = open.pop() {
        if !seen.insert(place.clone()) {
            continue;
        }
        if seen.len() > 3_000 {
            return None;
        }
        let (at, not_taken, calls, mut assigned) = place;
        let action = &program.steps()[at as usize].action;
        let is_passed = matches!(action, Action::ElseIf { .. }) && !not_taken;
        let mut reads = false;
        access::reads(program, action, |read| reads |= read == scalar);
        if !is_passed && reads {
            let read = found.entry(at).or_default();
            read.0 |= assigned;
            read.1 |= !assigned;
            if !assigned {
                continue;
            }
        }
        assigned |= access::assigns(program, action).contains(&scalar);
        let mut go = |to: u32, not_taken: bool, calls: Vec<u32>| {
            open.push((to, not_taken, calls, assigned));
        };
        let next = at + 1;
        match action {
            Action::If { otherwise, .. } => {
                go(*otherwise, true, calls.clone());
                go(next, false, calls);
            }
            Action::ElseIf { otherwise, .. } if not_taken => {
                go(*otherwise, true, calls.clone());
                go(next, false, calls);
            }
            Action::ElseIf { otherwise: to, .. } | Action::Goto { to } => go(*to, false, calls),
            Action::Else { end } => go(if not_taken { next } else { *end }, false, calls),
            Action::While { exit: to, .. }
            | Action::Until { back: to, .. }
            | Action::For { exit: to, .. }
            | Action::Next { body: to, .. }
            | Action::IfGoto { to, .. } => {
                go(*to, false, calls.clone());
                go(next, false, calls);
            }
            Action::Gosub { to } | Action::IfGosub { to, .. } => {
                if matches!(action, Action::IfGosub { .. }) {
                    go(next, false, calls.clone());
                }
                if calls.len() < 10 {
                    go(*to, false, [&calls[..], &[next]].concat());
                }
            }
            Action::Return => {
                if let Some((back, calls)) = calls.split_last() {
                    go(*back, false, calls.to_vec());
                }
            }
            Action::Finish(_) => {}
            _ => go(next, false, calls),
        }
    }
    Some(found)
}

/// Returns a program whose every branch is open.
fn random_program(seed: u64) -> String {
    let mut writer = Writer {
        random: Random::new(seed),
        text: "3.1\nrandom\nDEF_VAR A B I N\nDEF_POS P\n".to_owned(),
        labels: 0,
        depth: 0,
    };
    writer.block();
    writer.block();
    writer.line("LAST: EXIT");
    for routine in ["R1:", "R2:"] {
        writer.line(routine);
        writer.block();
        writer.line("RETURN");
    }
    // No run comes here; it makes the program load.
    writer.line("A = 1; B = 2; I = 3; N = 4; P.X = 5; KEY_IN");
    writer.line("END");
    writer.text
}

struct Writer {
    random: Random,
    text: String,
    labels: u32,
    depth: u32,
}

impl Writer {
    fn below(&mut self, bound: u64) -> u64 {
        self.random.below(bound)
    }

    fn line(&mut self, line: &str) {
        writeln!(self.text, "{line}").expect("writing to a string");
    }

    fn block(&mut self) {
        for _ in 0..1 + self.below(3) {
            self.statement();
        }
    }

    fn nested(&mut self) {
        self.depth += 1;
        self.block();
        self.depth -= 1;
    }

    fn statement(&mut self) {
        let kinds = if self.depth < 3 { 22 } else { 14 };
        match self.below(kinds) {
            0 => self.line("A = B"),
            1 => self.line("B = 1"),
            2 => self.line("A += 1"),
            3 => self.line("A = N"),
            4 => self.line("N = 2"),
            5 => self.line("P.Y = P.X"),
            6 => self.line("TEACH_POSITION F1 P"),
            7 => self.line("P = P + P"),
            8 => self.line("KEY_IN"),
            9 => self.line("MESSAGE %VAR_KEY%"),
            10 => self.line("IF KB_HIT GOSUB R1:"),
            11 => self.line("GOSUB R2:"),
            12 => self.line("IF A > 1 GOSUB R2:"),
            13 => {
                self.labels += 1;
                let label = self.labels;
                self.line(&format!("IF KB_HIT GOTO L{label}:"));
                self.line("P.X = 2");
                self.line(&format!("L{label}:"));
            }
            14..=16 => {
                self.line("IF KB_HIT THEN");
                self.nested();
                if self.below(2) == 0 {
                    self.line("ELSEIF B > 1 THEN");
                    self.nested();
                }
                if self.below(2) == 0 {
                    self.line("ELSE");
                    self.nested();
                }
                self.line("ENDIF");
            }
            17 => {
                self.line("WHILE N > 3");
                self.nested();
                self.line("WEND");
            }
            18 => {
                self.line("REPEAT");
                self.nested();
                self.line("UNTIL KB_HIT");
            }
            19 => {
                self.line("FOR I = A TO N");
                self.nested();
                self.line("NEXT");
            }
            20 => {
                self.labels += 1;
                let label = self.labels;
                self.line(&format!("L{label}:"));
                self.nested();
                self.line(&format!("IF HALT_REQUEST GOTO L{label}:"));
            }
            _ => self.line("IF KB_HIT GOTO LAST:"),
        }
    }
}
