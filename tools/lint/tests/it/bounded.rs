//! Analysis cost grows with a program's length, not with its square. Work is counted in bytes taken from the heap:
//! each search takes what it comes to, and the count is the same on every machine.

use allocation_counter::{AllocationInfo, measure};
use std::fmt::Write;
use tip_lint::cycles::{Sampling, human, json, parts, short};
use tip_lint::load;
use tip_lint::migrate::migrate;
use tip_lint::repair::{confirm, preview};
use tipc::analysis::assignment::{Assigned, Assignment, Read};
use tipc::diagnostic::Applicability;
use tipc::emit::{Options as Spelling, pretty};
use tipc::program::Program;
use tipc::source::Encoding;
use tipc::{MAX_DIAGNOSTICS, Options, Robot};

fn program(statements: &str) -> Program {
    let text = format!("3.1\ntest\n{statements}\nEND\n");
    let loaded = load("test.prg", text.as_bytes(), &Options::default());
    loaded
        .program
        .unwrap_or_else(|| panic!("{:#?}", loaded.diagnostics))
}

/// Four times the length may cost five times as much.
#[track_caller]
fn require_linear(what: &str, cost: impl Fn(usize) -> u64) {
    let (short, long) = (cost(250), cost(1_000));
    assert!(long < 5 * short, "{what}: {short} bytes, then {long}");
}

fn cycles(statements: &str) -> u64 {
    let program = program(statements);
    let sampling = Sampling::of(Robot::Titan8);
    measure(|| assert!(!parts(&program, sampling).counted.is_empty())).bytes_total
}

/// Returns a line for each number.
fn lines(count: usize, line: impl Fn(usize) -> String) -> String {
    (0..count).map(|number| line(number) + "\n").collect()
}

#[test]
fn loops_in_loops_are_counted_within_the_budget() {
    for (open, close) in [
        ("FOR I = 1 TO 3\n", "NEXT\n"),
        ("FOR I = 1 TO N\n", "NEXT\n"),
        ("WHILE KB_HIT\n", "WEND\n"),
        ("REPEAT\n", "UNTIL KB_HIT\n"),
        (
            "WHILE KB_HIT\nIF KB_HIT GOTO OUT:\n",
            "IF HALT_REQUEST THEN\nREM\nENDIF\nWEND\n",
        ),
    ] {
        require_linear(open, |depth| {
            let (open, close) = (open.repeat(depth), close.repeat(depth));
            cycles(&format!("DEF_VAR I N\nN = 3\n{open}{close}OUT: REM"))
        });
    }
    require_linear("counters of their own", |depth| {
        let open = lines(depth, |n| format!("FOR V{n} = 1 TO 3\nGOSUB R:"));
        let names = lines(depth, |n| format!("DEF_VAR V{n}"));
        let close = "NEXT\n".repeat(depth);
        cycles(&format!("{names}{open}{close}EXIT\nR: REM\nRETURN"))
    });
}

#[test]
fn cycles_are_counted_in_proportion_to_labels() {
    require_linear("loops of labels", |depth| {
        let open = lines(depth, |n| format!("L{n}: REM"));
        let close = lines(depth, |n| format!("IF KB_HIT GOTO L{}:", depth - 1 - n));
        cycles(&(open + &close))
    });
    require_linear("labels in a row", |count| {
        cycles(&lines(count, |n| {
            format!("L{n}: REM\nIF KB_HIT GOTO L{n}:")
        }))
    });
    require_linear("calls in calls", |depth| {
        let routine = |n| format!("L{n}: REM\nGOSUB L{}:\nRETURN", n + 1);
        cycles(&format!(
            "GOSUB L0:\nEXIT\n{}L{depth}: RETURN",
            lines(depth, routine)
        ))
    });
    require_linear("calls in a circle", |count| {
        let routine = |n| format!("L{n}: IF KB_HIT GOSUB L{}:\nRETURN", (n + 1) % count);
        cycles(&format!("GOSUB L0:\nEXIT\n{}", lines(count, routine)))
    });
}

/// Jumps across the whole program, forwards and backwards.
fn tangled(count: usize) -> String {
    lines(count, |n| {
        format!("L{n}: REM\nIF KB_HIT GOTO L{}:", n * 7919 % count)
    })
}

#[test]
fn cycles_of_loops_entered_from_aside_are_counted_in_proportion() {
    require_linear("loops in a row", |count| {
        cycles(&lines(count, |n| {
            format!("IF KB_HIT GOTO A{n}:\nL{n}: REM\nA{n}: IF KB_HIT GOTO L{n}:")
        }))
    });
}

#[test]
fn counting_ends_where_paths_cross_too_often() {
    let shared = |count: usize| {
        let calls = lines(count, |n| format!("IF KB_HIT GOSUB L{n}:"));
        let begins = lines(count, |n| format!("L{n}: REM"));
        format!("{calls}EXIT\n{begins}RETURN")
    };
    let fans = |count: usize| {
        let begins = lines(count, |n| format!("L{n}: REM\nELSEIF KB_HIT THEN"));
        let ends = lines(count, |n| format!("IF KB_HIT GOTO M{n}:"));
        let after = lines(count, |n| format!("M{n}: REM"));
        format!("IF KB_HIT THEN\n{begins}ENDIF\n{ends}{after}")
    };
    let entered = |depth: usize| {
        let open = lines(depth, |n| format!("L{n}: REM"));
        let close = lines(depth, |n| format!("IF KB_HIT GOTO L{}:", depth - 1 - n));
        format!("IF KB_HIT GOTO A:\n{open}A: REM\n{close}")
    };
    let left = |depth: usize| {
        let (open, close) = ("WHILE KB_HIT\n".repeat(depth), "WEND\n".repeat(depth));
        let jumps = lines(depth, |n| format!("IF KB_HIT GOTO L{n}:"));
        let labels = lines(depth, |n| format!("L{n}: REM"));
        format!("{open}{jumps}{close}{labels}")
    };
    let kinds: [(&str, &dyn Fn(usize) -> String); 5] = [
        ("jumps over the program", &tangled),
        ("routines that share their ends", &shared),
        ("stretches between all labels", &fans),
        ("nested loops entered from aside", &entered),
        ("nested loops with many ways out", &left),
    ];
    for (kind, text) in kinds {
        let counted = |count: usize| {
            let program = program(&text(count));
            let sampling = Sampling::of(Robot::Titan8);
            let mut has_more = false;
            let run = || has_more = parts(&program, sampling).has_more;
            (measure(run).bytes_total, has_more)
        };
        let ((_, few), (short, many), (long, most)) =
            (counted(100), counted(2_000), counted(8_000));
        assert_eq!([few, many, most], [false, true, true], "{kind}");
        assert!(long < 5 * short, "{kind}: {short} bytes, then {long}");
    }
}

#[test]
fn a_count_that_ends_early_says_so() {
    let program = program(&tangled(2_000));
    let sampling = Sampling::of(Robot::Titan8);
    let found = parts(&program, sampling);
    let note = "further parts are not counted: their paths cross too often";
    let last = |text: String| text.lines().last().map(str::to_owned);
    let table = last(human(&program, &found, sampling));
    assert_eq!(table.as_deref(), Some(note));
    let line = last(short(&program, &found, sampling));
    assert_eq!(line, Some(format!("test.prg: {note}")));
    let object = last(json(&program, &found, sampling));
    let expected = format!(r#"{{"file":"test.prg","note":"{note}"}}"#);
    assert_eq!(object, Some(expected));
}

/// Counts the cost of all diagnostics of a program.
fn check(statements: &str) -> u64 {
    let text = format!("3.1\ntest\n{statements}\nEND\n");
    let options = Options::default();
    measure(|| drop(load("test.prg", text.as_bytes(), &options))).bytes_total
}

#[test]
fn reads_are_judged_up_to_a_bound() {
    let text = |count: usize| {
        let begin = lines(count, |n| format!("DEF_VAR V{n}\nV{n} = 1"));
        let reads = lines(count, |n| format!("IF KB_HIT THEN\nSLEEP V{n}\nENDIF"));
        begin + &reads
    };
    let cost = |count: usize| check(&text(count));
    let (short, long) = (cost(4_000), cost(16_000));
    assert!(long < 5 * short, "{short} bytes, then {long}");
    // What is not judged is neither proved nor doubted.
    let program = program(&text(16_000));
    let assignment = Assignment::of(&program);
    let context = assignment.reads().len();
    assert!((1_000..16_000).contains(&context), "{context}");
    let is_always = |read: &Read| read.assigned == Assigned::Always;
    assert!(!assignment.is_complete());
    assert!(assignment.reads().iter().all(is_always));
}

fn migration(statements: &str) -> u64 {
    let text = format!("2.0\ntest\n{statements}END\n");
    let run = || drop(migrate("test.prg", text.as_bytes(), Encoding::Auto));
    measure(run).bytes_total
}

#[test]
fn a_migration_takes_time_in_proportion() {
    require_linear("tolerances", |count| {
        migration(&"PTP F2 1 2 3\nWAIT_NEAR F1 5\n".repeat(count))
    });
    require_linear("placeholders", |count| {
        migration(&lines(count, |n| {
            format!("VAR{n} = 1\nMESSAGE %VAR{n}X% a")
        }))
    });
    require_linear("renamed labels", |count| {
        let taken = lines(count, |n| format!("SIN_{}:", n + 1));
        migration(&(taken + "SIN:\n" + &"GOTO SIN:\n".repeat(count)))
    });
    require_linear("unknown commands", |count| {
        migration(&lines(count, |n| format!("FOO{n} 1")))
    });
}

/// Returns all kinds of steps.
fn mixed(count: usize) -> Program {
    let mut text = "DEF_VAR V\nDEF_POS P\n".to_owned();
    for n in 0..count / 8 {
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "L{n}: V = {n}\nIF V > 5 THEN\nPTP F1 1 2 V\nELSE\nPTP_ANGLE J11 5\nENDIF\nMESSAGE %V%\n"
        );
    }
    program(&text)
}

#[test]
fn generated_code_takes_memory_in_proportion() {
    let peak = |count: usize| {
        let program = mixed(count);
        let spelling = Spelling::default();
        let AllocationInfo { bytes_max, .. } =
            measure(|| assert!(pretty(&program, &spelling).is_ok()));
        bytes_max
    };
    let a_step = (peak(8_000) - peak(4_000)) / 4_000;
    assert!(a_step < 20_000, "{a_step} bytes a step");
}

#[test]
fn a_check_takes_time_in_proportion() {
    require_linear("values in messages", |count| {
        let names = lines(count, |n| format!("DEF_VAR V{n}"));
        check(&(names + &lines(count, |n| format!("V{n} = 1\nMESSAGE %V{n}% V{n}"))))
    });
    require_linear("labels that are jumped to without their colons", |count| {
        check(&lines(count, |n| format!("L{n}\nGOTO L{n}:")))
    });
    require_linear("declarations on one line", |count| {
        let names: String = (0..count).map(|n| format!(" V{n}")).collect();
        check(&format!("DEF_VAR{names}\n"))
    });
    for (open, close) in [
        ("IF 1 > 2 THEN\n", "ENDIF\n"),
        ("FOR I = 1 TO 3\n", "NEXT\n"),
    ] {
        require_linear(open, |depth| {
            let (open, close) = (open.repeat(depth), close.repeat(depth));
            // One warning more than those that are kept would be another matter.
            check(&format!(
                "DEF_VAR I\nI = 1\nSLEEP I\n{open}SLEEP 20\n{close}"
            ))
        });
    }
    require_linear("comments that allow", |count| {
        check(&"SLEEP 20 // tip: allow(W112)\n".repeat(count))
    });
    require_linear("words of other languages", |count| {
        check(&"ENDWHILE\n".repeat(count))
    });
    require_linear("ends of other blocks", |count| {
        check(&("WHILE KB_HIT\n".repeat(count) + &"NEXT\n".repeat(count)))
    });
    require_linear("branches of no IF", |count| check(&"ELSE\n".repeat(count)));
    require_linear("loops that end crosswise", |count| {
        let names = lines(count, |n| format!("DEF_VAR V{n}"));
        let open = lines(count, |n| format!("FOR V{n} = 1 TO 2"));
        check(&(names + &open + &lines(count, |n| format!("NEXT V{n}"))))
    });
    require_linear("jumps into blocks in blocks", |count| {
        let (jumps, open) = ("GOTO L:\n".repeat(count), "WHILE KB_HIT\n".repeat(count));
        check(&format!("{jumps}{open}L:\n{}", "WEND\n".repeat(count)))
    });
}

#[test]
fn no_suggestion_is_searched_for_a_mistake_that_is_not_shown() {
    let undeclared = |count| lines(count, |n| format!("SLEEP VALUE{n}X"));
    let declared = lines(500, |n| format!("DEF_VAR VALUE{n}"));
    let labels = lines(500, |n| format!("L{n}: REM"));
    let kinds: [(&str, &dyn Fn(usize) -> String); 3] = [
        ("unknown words", &|count| "WIAT_INPOS ALL\n".repeat(count)),
        ("unknown variables", &|count| {
            declared.clone() + &undeclared(count)
        }),
        ("unknown labels", &|count| {
            labels.clone() + &lines(count, |n| format!("GOTO ELSEWHERE{n}:"))
        }),
    ];
    for (kind, text) in kinds {
        // Each time as many again: what grows by doubling costs as much for each.
        let each = |count: usize| (check(&text(2 * count)) - check(&text(count))) / count as u64;
        let (shown, kept) = (each(128), each(1_024));
        assert!(
            kept + LISTED < shown,
            "{kind}: {shown} bytes each, then {kept}"
        );
    }
}

/// The bytes that a list of names to compare takes at least.
const LISTED: u64 = 1_000;

/// Three mistakes that are put right in two words, and a third that is not.
const WRONG: &str = "SLEPE 20 ; WIAT_INPOS ALL ; GOTOO L\n";

#[test]
fn fixes_are_tried_within_a_budget() {
    let options = Options::default();
    let tries = |count: usize| {
        let text = format!("3.1\ntest\n{}END\n", WRONG.repeat(count));
        let loaded = load("test.prg", text.as_bytes(), &options);
        let reading = measure(|| drop(load("test.prg", text.as_bytes(), &options)));
        let trying = measure(|| {
            let tried = loaded.clone();
            drop(preview(tried, &options, Applicability::Likely));
            drop(confirm(loaded, &options));
        });
        (trying.bytes_total / reading.bytes_total.max(1)) as usize * text.len()
    };
    // A quarter of a megabyte is read again each time, or the file once.
    for count in [25, 100, 400, 1_600] {
        let bytes = tries(count);
        assert!(bytes < 3 << 18, "{count} lines: {bytes} bytes");
    }
}

#[test]
fn diagnostics_are_capped_and_the_others_counted() {
    let options = Options::default();
    for (mistake, count) in [(":", 250_000), ("ENDWHILE\n", 20_000), ("SLEEP V\n", 1_500)] {
        let mistakes = match mistake {
            "SLEEP V\n" => lines(count, |n| format!("SLEEP V{n}")),
            _ => mistake.repeat(count),
        };
        let text = format!("3.1\ntest\n{mistakes}\nEND\n");
        let mut loaded = None;
        let info = measure(|| loaded = Some(load("test.prg", text.as_bytes(), &options)));
        let loaded = loaded.expect("it was loaded");
        assert!(loaded.program.is_none());
        assert_eq!(loaded.diagnostics.len(), MAX_DIAGNOSTICS, "{mistake}");
        let all = loaded.omitted.count() + MAX_DIAGNOSTICS;
        assert!((count..=count + 2).contains(&all), "{mistake}: {all}");
        // What is kept of them does not grow with their number.
        let most = 40_000_000 + 200 * text.len() as u64;
        assert!(info.bytes_max < most, "{mistake}: {}", info.bytes_max);
    }
}

#[test]
fn errors_are_reported_before_warnings() {
    let unused = lines(2 * MAX_DIAGNOSTICS, |n| format!("DEF_VAR V{n}"));
    let text = format!("3.1\ntest\n{unused}FOO\nEND\n");
    let loaded = load("test.prg", text.as_bytes(), &Options::default());
    let last = loaded.diagnostics.last().expect("there is one");
    assert_eq!(last.code, tipc::code::Code::UnknownCommand);
    assert_eq!(loaded.omitted.count(), MAX_DIAGNOSTICS + 1);
}
