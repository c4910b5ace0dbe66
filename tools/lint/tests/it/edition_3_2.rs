//! Edition 3.2: listings, counts of cycles, the formatter, and the way there from 3.1.

use tip_lint::cycles::{self, Sampling, Span, Stop};
use tip_lint::format::format;
use tip_lint::migrate::{NoteKind, migrate_to};
use tip_lint::{Loaded, listing, load};
use tipc::language::Edition;
use tipc::source::Encoding;
use tipc::{Options, Robot};

fn loaded(statements: &str) -> Loaded {
    let text = format!("3.2\ntitle\n{statements}\nEND\n");
    let loaded = load("next.prg", text.as_bytes(), &Options::default());
    assert!(loaded.program.is_some(), "{:#?}", loaded.diagnostics);
    loaded
}

fn formal(statements: &str) -> String {
    let loaded = loaded(statements);
    listing::formal(&loaded.source, &loaded.module).replace('\t', "|")
}

// clauses: 12.5 13.1
#[test]
fn a_constant_shows_its_value_in_formal_tmp() {
    let lines = formal(
        "define far 1e20\nDEFINE NEAR -2\nDEFINE LESS -NEAR\nDEFINE R 7\nDEF_VAR a\na = -far + near\n\
         IF a > -less THEN\nENDIF\nPTP F1 R 0 R 0 R near\nSLEEP R\nAD_IN BOARD 13 a\nDEFINE BOARD 0\n\
         MESSAGE %far% far\nF_MESSAGE  far\\n",
    );
    let expected = "\
A|=|-1E20|+|-2.0
IF|A|>|-2.0|THEN
ENDIF
PTP|F1|R|0|R|0|R|-2.0
SLEEP|7.0
AD_IN|0.0|13|A
MESSAGE|%far% far
F_MESSAGE|far\\n
END
";
    assert_eq!(lines, expected);
}

// clauses: 12.5
#[test]
fn a_thread_has_a_kind_of_its_own_in_label_tmp() {
    let loaded = loaded(
        "START_THREAD T:\nL1: CALL S:\nEXIT\nSUBROUTINE S:\nSUBEND\nTHREAD T:\nSTOP_THREAD T:\nTHREADEND",
    );
    let program = loaded.program.expect("a program");
    assert_eq!(listing::label(&program), "L\tL1:\t1\nS\tS:\t4\nT\tT:\t6\n");
    let thread = &program.threads()[0];
    assert_eq!(
        (thread.name.as_str(), thread.first, thread.last),
        ("T", 6, 8)
    );
    assert_eq!(
        formal("START_THREAD t:\nWAIT_THREAD t:\nEXIT\nTHREAD t:\nTHREADEND"),
        "START_THREAD|T:\nWAIT_THREAD|T:\nEXIT\nTHREAD|T:\nTHREADEND\nEND\n"
    );
}

/// Returns a record of TIP.OBJ: `Cmd Target Type=Value …` up to its last argument.
fn record(statements: &str, step: usize) -> String {
    let loaded = loaded(statements);
    let program = loaded.program.expect("a program");
    let text = listing::object(&loaded.source, &loaded.module, &program);
    let record = text.split('[').nth(step + 1).expect("a step");
    let fields: Vec<&str> = record
        .lines()
        .filter_map(|line| Some(line.split_once(" = ")?.1))
        .collect();
    let (kinds, values) = fields[2..].split_at((fields.len() - 2) / 2);
    let mut words = vec![fields[0].to_owned(), fields[1].to_owned()];
    words.extend(
        kinds
            .iter()
            .zip(values)
            .map(|(kind, value)| format!("{kind}={value}")),
    );
    while words.last().is_some_and(|word| word == "ARG_NONE=0.000000") {
        words.pop();
    }
    words.join(" ")
}

// clauses: 12.5
#[test]
fn the_new_words_have_their_records_in_tip_obj() {
    let thread = "START_THREAD T:\nWAIT_THREAD T:\nEXIT\nTHREAD T:\nTHREADEND";
    assert_eq!(record(thread, 0), "START_THREAD NO_TARGET LABEL=3.000000");
    assert_eq!(record(thread, 1), "WAIT_THREAD NO_TARGET LABEL=3.000000");
    assert_eq!(record(thread, 3), "THREAD NO_TARGET");
    assert_eq!(record(thread, 4), "THREADEND NO_TARGET");
    for (statement, expected) in [
        ("START_TIMER 3", "START_TIMER NO_TARGET CONSTANT=3.000000"),
        ("TIP_SPEED_UP N", "TIP_SPEED_UP NO_TARGET VAR=1.000000"),
        ("DIRECT F1", "DIRECT TARGET_F1"),
        ("UNLOCK ALL", "UNLOCK TARGET_ALL"),
        ("RESET_LIMIT J11", "RESET_LIMIT TARGET_J11"),
        (
            "SET_LIMIT J11 -5 HALF",
            "SET_LIMIT TARGET_J11 CONSTANT=-5.000000 CONSTANT=0.500000",
        ),
        (
            "SET_LIMIT F1 @AGL_F1 U",
            "SET_LIMIT TARGET_F1 AGL_F1=0.000000 JNT=0.000000",
        ),
        ("SLEEP @TIMER0", "SLEEP NO_TARGET TIMER0=0.000000"),
        (
            "PTP_ANGLE J11 -@AGL_J12",
            "PTP_ANGLE TARGET_J11 MINUS_AGL_J12=0.000000",
        ),
        ("PTP F1 R @POS_F1", "PTP TARGET_F1 REL_POS_F1=0.000000"),
        (
            "PTP_ANGLE F1 @AGL_J11 0 @AGL_J11",
            "PTP_ANGLE TARGET_F1 AGL_J11=0.000000 CONSTANT=0.000000 AGL_J11=0.000000",
        ),
        (
            "N = @POS_F1.Z",
            "EQUAL NO_TARGET VAR=1.000000 POS_F1_Z=0.000000",
        ),
        (
            "N = -HALF",
            "EQUAL NO_TARGET VAR=1.000000 CONSTANT=-0.500000",
        ),
        (
            "N = @AGL_F1.J2",
            "EQUAL NO_TARGET VAR=1.000000 AGL_F1_2=0.000000",
        ),
        (
            "P = @POS_F1",
            "EQUAL NO_TARGET POS=0.000000 POS_F1=0.000000",
        ),
        (
            "VAR_SPECIAL_3 = N",
            "EQUAL NO_TARGET VAR_SPECIAL=3.000000 VAR=1.000000",
        ),
        (
            "N = POS_SPECIAL_2.X",
            "EQUAL NO_TARGET VAR=1.000000 POS_SPECIAL_X=2.000000",
        ),
        (
            "JNT_SPECIAL_0.J1 = N",
            "EQUAL NO_TARGET JNT_SPECIAL_1=0.000000 VAR=1.000000",
        ),
    ] {
        let given = "DEFINE HALF 0.5\nDEF_VAR N\nDEF_POS P\nDEF_JOINT U\nTEACH_ANGLE F1 U\nN = 1\n";
        let program = format!(
            "{given}{statement}\nSLEEP N\nSLEEP HALF\nP = @POS_F1\nPTP F1 P\nPTP_ANGLE F1 U"
        );
        assert_eq!(record(&program, 2), expected, "{statement}");
    }
    let texts = "MESSAGE one\nF_MESSAGE two\\n\nMESSAGE three";
    assert_eq!(record(texts, 0), "MESSAGE NO_TARGET STRING=0.000000");
    assert_eq!(record(texts, 1), "F_MESSAGE NO_TARGET STRING=1.000000");
    assert_eq!(record(texts, 2), "MESSAGE NO_TARGET STRING=2.000000");
}

// clauses: 12.6
#[test]
fn a_part_counts_in_steps_of_its_own_thread() {
    let program = |rest: &str| {
        let text = format!("{rest}START_THREAD T:\nEXIT\nTHREAD T:\nREM a\nREM b\nTHREADEND");
        loaded(&text).program.expect("a program")
    };
    let sampling = Sampling::of(Robot::Titan8);
    let alone = program("");
    let parts = cycles::parts(&alone, sampling);
    let counted: Vec<(Span, u64)> = parts
        .counted
        .iter()
        .map(|part| (part.span.clone(), part.cycles.min))
        .collect();
    let stretch = |from, to| Span::Stretch { from, to };
    let expected = [(stretch(0, Stop::End), 2), (stretch(2, Stop::ThreadEnd), 4)];
    assert_eq!(counted, expected);
    let note = "sets the steps of a cycle";
    assert!(!cycles::human(&alone, &parts, sampling).contains(note));
    let fast = program("TIP_SPEED_UP 2\n");
    let parts = cycles::parts(&fast, sampling);
    for shown in [
        cycles::human(&fast, &parts, sampling),
        cycles::short(&fast, &parts, sampling),
        cycles::json(&fast, &parts, sampling),
    ] {
        assert!(shown.contains(&format!("line 3 {note}")), "{shown}");
    }
}

// clauses: 15.1 13.1 17.2
#[test]
fn the_formatter_knows_the_new_statements() {
    let text = "3.2\ntitle\ndefine  n   char_a\nstart_thread t:\nsleep n\nexit\nthread  t :\n\
                f_message   a  b\\n\na = @agl_j11\ndef_var a\nsleep a\nthreadend\nend\n";
    let expected = "3.2\ntitle\nDEFINE N CHAR_A\nSTART_THREAD T:\nSLEEP N\nEXIT\nTHREAD T:\n  \
                    F_MESSAGE a  b\\n\n  A = @AGL_J11\n  DEF_VAR A\n  SLEEP A\nTHREADEND\nEND\n";
    let formatted = format("next.prg", text.as_bytes(), &Options::default());
    let formatted = formatted.expect("it loads");
    assert_eq!(String::from_utf8_lossy(&formatted), expected);
}

fn migrated(text: &str) -> (Option<String>, Vec<(NoteKind, u32)>) {
    let migration = migrate_to(Edition::V3_2, "old.prg", text.as_bytes(), Encoding::Auto);
    let migration = migration.expect("text");
    let notes = migration.notes().iter().map(|note| (note.kind, note.line));
    let bytes = migration
        .bytes()
        .map(|bytes| String::from_utf8_lossy(bytes).into_owned());
    (bytes, notes.collect())
}

// clauses: 12.1
#[test]
fn a_migration_writes_line_1_and_renames_what_3_2_reserves() {
    use NoteKind::Change;
    let old = "3.1 // old\ntitle\nDEF_VAR lock, N\nlock = 1 ; N = LOCK\nDIRECT: MESSAGE %lock% %N%\nGOTO DIRECT:\nEND\n";
    let new = "3.2 // old\ntitle\nDEF_VAR lock_1, N\nlock_1 = 1 ; N = LOCK_1\nDIRECT_1: MESSAGE %lock_1% %N%\nGOTO DIRECT_1:\nEND\n";
    let (bytes, notes) = migrated(old);
    assert_eq!(bytes.as_deref(), Some(new));
    assert_eq!(notes, [(Change, 1), (Change, 3), (Change, 5)]);
    assert_eq!(migrated(new), (Some(new.to_owned()), vec![]));
    // A program of version 2 becomes one of 3.1 first.
    let (bytes, _) = migrated("2.0\ntitle\nVAR01 = 1\nA_MAX ALL VAR01\nEND\n");
    let new = "3.2\ntitle\nDEF_VAR VAR01\nVAR01 = 1\nSET_A_MAX ALL VAR01\nEND\n";
    assert_eq!(bytes.as_deref(), Some(new));
}

// clauses: 12.1 12.2
#[test]
fn a_migration_asks_about_what_3_2_refuses_and_shows() {
    for (statement, line) in [
        ("SLEEP -1", 4),
        ("MESSAGE %P%", 4),
        ("MESSAGE %P.X%", 4),
        ("MESSAGE %@TIMER0%", 4),
        ("SUBROUTINE S:\nSUBEND", 4),
    ] {
        let (bytes, notes) = migrated(&format!(
            "3.1\ntitle\nDEF_POS P\n{statement}\nEXIT\nPTP F1 P\nTEACH_POSITION F1 P\nEND\n"
        ));
        assert_eq!(bytes, None, "{statement}");
        assert_eq!(
            notes.last(),
            Some(&(NoteKind::Question, line)),
            "{statement}"
        );
    }
    let sound = "3.1\ntitle\nDEF_POS P\nTEACH_POSITION F1 P\nMESSAGE 50% of %Q%\nPTP F1 P\nEND\n";
    assert!(migrated(sound).0.is_some());
}
