//! Counts reasoned by hand from the cycle of each step (clauses 2.3 to 2.19).

use super::{Sampling, human, json, parts, short};
use crate::{Options, load};
use tipc::program::Program;

const TITAN: Sampling = Sampling {
    standard: 20.0,
    longest: 1000.0,
};

fn program(statements: &str) -> Program {
    let text = format!("3.1\ntest\n{statements}\n");
    let loaded = load("test.prg", text.as_bytes(), &Options::default());
    let reported = loaded.diagnostics;
    loaded
        .program
        .unwrap_or_else(|| panic!("{reported:#?}\n{text}"))
}

/// Returns the parts as lines without the file's name; line 3 is the first of the statements.
fn counts(statements: &str) -> Vec<String> {
    let program = program(statements);
    let text = short(&program, &parts(&program, TITAN), TITAN);
    text.lines()
        .map(|line| line.trim_start_matches("test.prg:").to_owned())
        .collect()
}

// clauses: 2.15 2.16
#[test]
fn a_call_counts_with_its_subroutine() {
    let found = counts("GOSUB R:\nEXIT\nR: IF KB_HIT THEN\nMESSAGE x\nENDIF\nRETURN\nEND");
    // R: label, IF, perhaps MESSAGE, ENDIF, RETURN. The start: GOSUB, R, EXIT.
    assert_eq!(
        found,
        [
            "5: subroutine R: 4 to 5 cycles, 80 to 100 ms",
            "3: start to END: 6 to 7 cycles, 120 to 140 ms",
            "5: R to RETURN: 4 to 5 cycles, 80 to 100 ms",
        ]
    );
}

// clauses: 2.12 2.13
#[test]
fn a_for_over_constants_counts_its_turns() {
    let left = "DEF_VAR I\nFOR I = 1 TO 3\nREM\nIF KB_HIT GOTO OUT:\nNEXT\nREM\nOUT: EXIT\nEND";
    // All turns: FOR, 3 of REM IF NEXT, REM. Left early: FOR, up to 2 of them, REM IF.
    assert_eq!(
        counts(left),
        [
            "4: turn of FOR I = 1 TO 3, 3 in all: 3 cycles, 60 ms",
            "4: start to OUT: 3 to 11 cycles, 60 to 220 ms",
            "9: OUT to END: 2 cycles, 40 ms",
        ]
    );
    let nested = "DEF_VAR I J\nFOR I = 1 TO 2\nFOR J = 4 TO 0 STEP -2\nREM\nNEXT\nNEXT\nEND";
    // Inside: REM NEXT three times after FOR: 7. Outside: twice that and NEXT, after FOR: 17; END.
    assert_eq!(
        counts(nested),
        [
            "4: turn of FOR I = 1 TO 2, 2 in all: 8 cycles, 160 ms",
            "5: turn of FOR J = 4 TO 0 STEP -2, 3 in all: 2 cycles, 40 ms",
            "4: start to END: 18 cycles, 360 ms",
        ]
    );
    let empty = "DEF_VAR I\nFOR I = 1 TO 3\nNEXT\nEND";
    assert_eq!(
        counts(empty),
        [
            "4: turn of FOR I = 1 TO 3, 3 in all: 1 cycle, 20 ms",
            "4: start to END: 5 cycles, 100 ms",
        ]
    );
    let passed = "DEF_VAR I\nFOR I = 2 TO 1\nNEXT\nEND";
    assert_eq!(counts(passed)[1], "4: start to END: 2 cycles, 40 ms");
}

// clauses: 2.12 2.13
#[test]
fn a_for_that_something_meddles_with_has_no_bound() {
    let in_body = "DEF_VAR I\nFOR I = 1 TO 3\nI = 1\nNEXT\nEND";
    let in_call = "DEF_VAR I\nFOR I = 1 TO 3\nGOSUB R:\nNEXT\nEXIT\nR: I = 1\nRETURN\nEND";
    let by_limit = "DEF_VAR I N\nN = 3\nFOR I = 1 TO N\nNEXT\nEND";
    for (statements, count) in [
        // FOR, one turn of two, END.
        (in_body, "start to END: 4 or more cycles, 80 or more ms"),
        // FOR, one turn of GOSUB, label, equation, RETURN, NEXT, then EXIT.
        (in_call, "start to END: 7 or more cycles, 140 or more ms"),
        // The equation, FOR, END: it may not be entered.
        (by_limit, "start to END: 3 or more cycles, 60 or more ms"),
    ] {
        let found = counts(statements);
        assert!(found.iter().any(|line| line.ends_with(count)), "{found:#?}");
    }
    let entered = "DEF_VAR I\nI = 1\nIF KB_HIT GOTO L:\nFOR I = 1 TO 3\nL: NEXT\nEND";
    // The label's step and NEXT, until NEXT leads on to END.
    assert!(counts(entered).contains(&"7: L to END: 3 cycles, 60 ms".to_owned()));
}

// clauses: 2.10 2.11 2.14
#[test]
fn open_loops_count_by_the_turn() {
    let found = counts("WHILE KB_HIT\nREM\nWEND\nREPEAT\nUNTIL KB_HIT\nLOOP: REM\nGOTO\nEND");
    assert_eq!(
        found,
        [
            "3: turn of WHILE KB_HIT: 3 cycles, 60 ms",
            "6: turn of REPEAT: 2 cycles, 40 ms",
            "8: turn of LOOP: 3 cycles, 60 ms",
            "3: start to LOOP: 3 or more cycles, 60 or more ms",
            "8: LOOP to LOOP: 3 cycles, 60 ms",
        ]
    );
}

// clauses: 2.7 2.9
#[test]
fn a_branch_that_ends_passes_each_elseif_and_else() {
    let branches = "IF KB_HIT THEN\nREM\nELSEIF HALT_REQUEST THEN\nREM\nREM\nREM\nELSE\nENDIF\nEND";
    // First: IF REM ELSEIF ELSE ENDIF END. Second: IF ELSEIF three REM, ELSE ENDIF END. Third: IF ELSEIF ELSE ENDIF END.
    assert_eq!(
        counts(branches),
        ["3: start to END: 5 to 8 cycles, 100 to 160 ms"]
    );
}

#[test]
fn a_label_in_a_counted_loop_divides_it() {
    let found = counts("DEF_VAR I\nFOR I = 1 TO 3\nL: REM\nNEXT\nEND");
    assert_eq!(
        found[1..],
        [
            "4: start to L: 1 cycle, 20 ms",
            "5: L to L: 3 cycles, 60 ms",
            "5: L to END: 4 cycles, 80 ms",
        ]
    );
}

// clauses: 2.15
#[test]
fn recursion_has_a_least_and_no_most() {
    let found = counts("GOSUB R:\nEXIT\nR: IF KB_HIT GOSUB R:\nRETURN\nEND");
    assert_eq!(found[0], "5: subroutine R: 3 or more cycles, 60 or more ms");
    assert_eq!(
        found[1],
        "3: start to END: 5 or more cycles, 100 or more ms"
    );
    let endless = counts("GOSUB R:\nEXIT\nR: GOSUB R:\nRETURN\nEND");
    assert_eq!(endless, Vec::<String>::new(), "nothing comes to an end");
}

// clauses: 2.17 2.19
#[test]
fn a_wait_counts_as_its_least() {
    let found = counts("SLEEP 100\nL: KEY_IN\nEND");
    assert_eq!(
        found,
        [
            "3: start to L: 5 cycles, 100 ms, waits",
            "4: L to END: 3 cycles, 60 ms, waits",
        ]
    );
    // With the longest sampling time that may be in force it takes two cycles.
    let slower = counts("SET_SAMPLING_TIME 50\nSLEEP 100\nEND");
    assert_eq!(slower, ["3: start to END: 4 cycles, 80 ms, waits"]);
}

#[test]
fn what_nothing_reaches_counts_too() {
    assert_eq!(counts("END"), ["3: start to END: 1 cycle, 20 ms"]);
    let dead = counts("EXIT\nL: REM\nEND");
    assert_eq!(dead[1], "4: L to END: 3 cycles, 60 ms");
}

#[test]
fn people_read_a_table_and_tools_read_objects() {
    let program = program("SET_SAMPLING_TIME 10\nLOOP:\nIF KB_HIT GOTO L:\nGOTO\nL: END");
    let found = parts(&program, TITAN);
    let table = human(&program, &found, TITAN);
    assert_eq!(
        table,
        "test.prg for titan8, 20 ms a cycle\n\
         line 3 sets a sampling time: other times hold while it is in force\n\
         part           lines  cycles  ms\n\
         turn of LOOP   4-6    3       60\n\
         start to LOOP  3-4    1       20\n\
         LOOP to LOOP   4      3       60\n\
         LOOP to L      4-7    2       40\n\
         L to END       7      2       40\n"
    );
    let objects = json(&program, &found, TITAN);
    let first = objects.lines().next().unwrap_or_default();
    assert_eq!(
        first,
        r#"{"part":"turn","name":"LOOP","file":"test.prg","line":4,"min":3,"max":3,"min_ms":60,"max_ms":60,"waits":false}"#
    );
}

#[test]
fn deep_nesting_ends_in_no_bound() {
    let nested = |depth: usize| {
        let opened = "FOR I = 1 TO 1\n".repeat(depth);
        let text = format!("DEF_VAR I\n{opened}{}END", "NEXT\n".repeat(depth));
        let program = program(&text);
        let stretch = parts(&program, TITAN)
            .counted
            .pop()
            .expect("from start to END");
        stretch.cycles.max
    };
    // All loops count the same variable, so that only the innermost is counted at all.
    assert_eq!(nested(2), None);
    assert_eq!(nested(400), None);
    let own = |depth: usize| {
        let names: Vec<String> = (0..depth).map(|n| format!("V{n}")).collect();
        let opened: String = names
            .iter()
            .map(|name| format!("FOR {name} = 1 TO 1\n"))
            .collect();
        let text = format!(
            "DEF_VAR {}\n{opened}{}END",
            names.join(" "),
            "NEXT\n".repeat(depth)
        );
        let stretch = parts(&program(&text), TITAN)
            .counted
            .pop()
            .expect("from start to END");
        stretch.cycles.max
    };
    // FOR and NEXT of each, and END.
    assert_eq!(own(32), Some(65));
    assert_eq!(own(33), None);
    assert_eq!(own(100), None);
}

/// A thread that assigns the counter of another one's loop changes the number of turns.
#[test]
fn a_loop_whose_counter_a_thread_assigns_is_not_counted() {
    let text = |thread: &str| {
        format!(
            "3.2\ntest\nDEF_VAR I, J\nSTART_THREAD T:\nFOR I = 1 TO 3\nNEXT\nEXIT\nTHREAD T:\n{thread}\nTHREADEND\nEND\n"
        )
    };
    let found = |thread: &str| {
        let loaded = load("test.prg", text(thread).as_bytes(), &Options::default());
        let program = loaded.program.expect("it has no errors");
        short(&program, &parts(&program, TITAN), TITAN)
    };
    // START_THREAD, FOR, NEXT three times, EXIT: six steps.
    assert!(
        found("J = 9").contains("start to END: 6 cycles"),
        "{}",
        found("J = 9")
    );
    assert!(
        !found("I = 9").contains("start to END: 6 cycles"),
        "{}",
        found("I = 9")
    );
}
