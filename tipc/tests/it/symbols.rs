//! The table of names: every definition and use at its place. Expected lists are read off the programs.

mod cases;
mod rename;

use tipc::symbols::{Access, Definition, DefinitionKind, Use};
use tipc::{Loaded, Options, load};

fn program(statements: &str) -> Loaded {
    let text = format!("3.1\nsymbols\n{statements}\nEND\n");
    load("symbols.prg", text.as_bytes(), &Options::default())
}

/// Formats one use: `line:column name access`, then the member from 0 and the sign if there are any. Lines count from
/// the first statement; a name that is left out is written as `()`.
fn line(loaded: &Loaded, it: &Use) -> String {
    let (line, column) = loaded.source.line_column(it.span.start);
    let name = match loaded.source.slice(it.span) {
        "" => "()",
        name => name,
    };
    let access = match it.access {
        Access::Define => "defines",
        Access::Read => "reads",
        Access::Assign => "assigns",
        Access::Update => "updates",
        Access::Count => "counts",
        Access::Jump => "jumps",
        Access::Call => "calls",
        Access::Start => "starts",
        Access::Control => "names",
        Access::Unclear => "unclear",
    };
    let member = it.member.map(|member| format!(" .{member}"));
    let sign = if it.negative { " -" } else { "" };
    let line = line - 2;
    format!(
        "{line}:{column} {name} {access}{}{sign}",
        member.unwrap_or_default()
    )
}

/// Compares every use of a program with a list.
fn check(statements: &str, expected: &str) {
    let loaded = program(statements);
    let found: Vec<String> = loaded
        .symbols
        .all_uses()
        .iter()
        .map(|it| line(&loaded, it))
        .collect();
    let expected: Vec<&str> = expected.lines().map(str::trim).collect();
    assert_eq!(found, expected, "{statements}");
}

#[test]
fn equations_assign_their_left_side_and_read_the_right_one() {
    check(
        "DEF_VAR a, B\nDEF_POS P\na = -p.y\nB += A*-B\nP.x=NORM P\np = ROT_Z P B\nB = CHAR_A",
        "1:9 a defines
         1:12 B defines
         2:9 P defines
         3:1 a assigns
         3:6 p reads .1 -
         4:1 B updates
         4:6 A reads
         4:9 B reads -
         5:1 P assigns .0
         5:10 P reads
         6:1 p assigns
         6:11 P reads
         6:13 B reads
         7:1 B assigns",
    );
}

#[test]
fn loops_count_and_conditions_read() {
    check(
        "DEF_VAR I, N\nFOR i = -N TO N STEP 2\nWHILE I < N\nWEND\nNEXT\nFOR I = 1 TO 2\nNEXT I\n\
         IF N == 1 THEN\nELSEIF N > I THEN\nENDIF\nREPEAT\nUNTIL KB_HIT",
        "1:9 I defines
         1:12 N defines
         2:5 i updates
         2:10 N reads -
         2:15 N reads
         3:7 I reads
         3:11 N reads
         5:5 () counts
         6:5 I updates
         7:6 I counts
         8:4 N reads
         9:8 N reads
         9:12 I reads",
    );
}

#[test]
fn labels_are_defined_jumped_to_and_called() {
    check(
        "Start: GOSUB sub:\nLOOP:\nIF KB_HIT GOTO start:\nIF KB_HIT GOTO\nIF KB_HIT GOSUB SUB:\nGOTO LOOP:\n\
         LOOP: GOTO loop:\nCALL Sub:\nEXIT\nSUBROUTINE sub:\nRETURN\nSUBEND",
        "1:1 Start defines
         1:14 sub calls
         2:1 LOOP defines
         3:16 start jumps
         4:15 () jumps
         5:17 SUB calls
         6:6 LOOP jumps
         7:1 LOOP defines
         7:12 loop jumps
         8:6 Sub calls
         10:12 sub defines",
    );
    // The jump in line 7 leads to the LOOP on its line, those above to the one before.
    let loaded = program("LOOP:\nGOTO\nLOOP: GOTO LOOP:");
    let ids: Vec<usize> = loaded
        .symbols
        .all_uses()
        .iter()
        .map(|it| it.definition.index())
        .collect();
    assert_eq!(ids, [1, 1, 2, 2]);
}

#[test]
fn commands_read_their_values_and_fill_their_variables() {
    check(
        "DEF_VAR V, X\nDEF_POS P\nDEF_JOINT Q\nPTP F1 R V A -P.Z 0\nPTP F1 P\nTEACH_POSITION F2 P\n\
         TEACH_ANGLE F1 Q\nTEACH_ANGLE J12 Q.J3\nAD_IN VR1 V\nAD_IN 0 13 X\nKEY_IN\nKEY_IN v\nSPECIAL 1 V X\nSLEEP VAR_KEY",
        "1:9 V defines
         1:12 X defines
         2:9 P defines
         3:11 Q defines
         4:10 V reads
         4:15 P reads .2 -
         5:8 P reads
         6:19 P assigns
         7:16 Q assigns
         8:17 Q assigns .2
         9:11 V assigns
         10:12 X assigns
         11:7 () assigns
         12:8 v assigns
         13:11 V reads
         13:13 X reads
         14:7 VAR_KEY reads",
    );
}

#[test]
fn placeholders_of_messages_are_reads() {
    check(
        "DEF_VAR A, B\nDEF_POS P\nMESSAGE %A% \u{3042} %b.2%%A% 5% A %P% %A.8%",
        "1:9 A defines
         1:12 B defines
         2:9 P defines
         3:10 A reads
         3:16 b reads
         3:21 A reads",
    );
}

#[test]
fn a_flag_is_no_variable_even_if_one_has_its_name() {
    check(
        "DEF_VAR R, A\nA = 1\nR = A\nPTP F1 R 1 A 2 3",
        "1:9 R defines
         1:12 A defines
         2:1 A assigns
         3:1 R assigns
         3:5 A reads",
    );
}

#[test]
fn wrong_statements_name_what_they_name() {
    check(
        "DEF_VAR V, v\nDEF_POS P\nV = P\nPTP F1 V\nIF V > FOO GOTO L1:\nP.W = V\nV = (V + P.V)\nL1:\nL1: GOTO NO:\nCALL L1:\nGOTO L1\nFOO L1, -v",
        "1:9 V defines
         1:12 v defines
         2:9 P defines
         3:1 V unclear
         3:5 P reads
         4:8 V unclear
         5:4 V unclear
         5:17 L1 jumps
         6:1 P unclear
         6:7 V unclear
         7:1 V unclear
         7:6 V unclear
         7:10 P unclear
         8:1 L1 defines
         9:1 L1 defines
         10:6 L1 calls
         11:6 L1 jumps
         12:5 L1 unclear
         12:10 v unclear",
    );
}

#[test]
fn definitions_are_the_variables_then_the_labels() {
    let loaded = program("L1: DEF_POS p\nDEF_VAR n\nLOOP:\nSUBROUTINE S:\nSUBEND\nL1: DEF_JOINT Q");
    let kinds: Vec<(&str, &str, Option<usize>)> = loaded
        .symbols
        .definitions()
        .iter()
        .map(|Definition { name, kind, span }| {
            let kind = match kind {
                DefinitionKind::Variable(_) => "variable",
                DefinitionKind::Label => "label",
                DefinitionKind::Subroutine => "subroutine",
                DefinitionKind::Thread => "thread",
                DefinitionKind::Constant => "constant",
            };
            let line = span.map(|span| loaded.source.line_column(span.start).0 as usize - 2);
            (name.as_str(), kind, line)
        })
        .collect();
    let expected = [
        ("VAR_KEY", "variable", None),
        ("P", "variable", Some(1)),
        ("N", "variable", Some(2)),
        ("Q", "variable", Some(6)),
        ("L1", "label", Some(1)),
        ("LOOP", "label", Some(3)),
        ("S", "subroutine", Some(4)),
    ];
    assert_eq!(kinds, expected);
}

#[test]
fn a_place_leads_to_what_it_names() {
    let loaded =
        program("DEF_VAR LONG\nDEF_POS P\nDEF_JOINT Q\nP.X=LONG\nQ.J2 = -LONG\nLOOP: GOTO");
    let text = loaded.source.text();
    let named = |before: &str, behind: &str| {
        let offset = text
            .find(&format!("{before}{behind}"))
            .expect("it stands there");
        let it = loaded.symbols.at(offset + before.len())?;
        Some(loaded.symbols.definition(it.definition).name.as_str())
    };
    for (before, behind, name) in [
        ("DEF_VAR ", "LONG", Some("LONG")),
        ("DEF_VAR", " LONG", None),
        ("DEF_VAR LONG", "\n", Some("LONG")),
        ("", "P.X=", Some("P")),
        ("P", ".X=", Some("P")),
        ("P.X", "=LONG", Some("P")),
        ("P.X=", "LONG", Some("LONG")),
        ("Q.", "J2 ", Some("Q")),
        ("Q.J2", " = ", Some("Q")),
        ("Q.J2 ", "= -", None),
        ("= ", "-LONG", None),
        ("= -LO", "NG", Some("LONG")),
        ("LOOP", ": GOTO", Some("LOOP")),
        ("LOOP:", " GOTO", None),
        (": GOTO", "\n", None),
        ("", "3.1", None),
    ] {
        assert_eq!(named(before, behind), name, "{before}|{behind}");
    }
    assert_eq!(loaded.symbols.at(text.len() + 10), None);
}

#[test]
fn a_definition_has_its_uses_and_a_statement_its_own() {
    let loaded = program("DEF_VAR A, B\nA = 1; B = A\nSLEEP A; SLEEP B");
    let symbols = &loaded.symbols;
    let lines =
        |uses: Vec<&Use>| -> Vec<String> { uses.into_iter().map(|it| line(&loaded, it)).collect() };
    let a = symbols
        .at(loaded.source.text().find("A,").expect("A"))
        .expect("A");
    let expected = [
        "1:9 A defines",
        "2:1 A assigns",
        "2:12 A reads",
        "3:7 A reads",
    ];
    assert_eq!(lines(symbols.uses(a.definition).collect()), expected);
    let second = loaded.module.statements[2].span;
    let expected = ["2:8 B assigns", "2:12 A reads"];
    assert_eq!(lines(symbols.within(second).iter().collect()), expected);
    let end = loaded.module.statements[5].span;
    assert_eq!(symbols.within(end), []);
}

#[test]
fn a_file_that_cannot_be_read_names_nothing() {
    for bytes in [
        &b"2.0\nold\nDEF_VAR A\nEND\n"[..],
        b"3.1\n\xFF\xFF\nA:\nEND\n",
    ] {
        let loaded = load("bad.prg", bytes, &Options::default());
        assert!(loaded.program.is_none());
        assert_eq!(loaded.symbols.all_uses(), []);
    }
}
