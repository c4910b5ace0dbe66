//! The classical listing files, line for line (T.I.P. 3.1 §10-4).

use std::path::{Path, PathBuf};
use std::{env, fs};
use tip_lint::{listing, load};
use tipc::program::{Program, VariableKind};
use tipc::syntax::StatementKind;
use tipc::{Loaded, Options, Robot};

fn loaded(text: &str, robot: Robot) -> Loaded {
    let options = Options {
        robot,
        ..Options::default()
    };
    load("listing.prg", text.as_bytes(), &options)
}

fn program(text: &str, robot: Robot) -> Program {
    let loaded = loaded(text, robot);
    let found = loaded.diagnostics;
    loaded.program.unwrap_or_else(|| panic!("{found:#?}"))
}

/// FORMAL.TMP of a program for TITAN VIII, a bar for each tab.
fn formal(statements: &str) -> String {
    let text = format!("3.1\nformal\n{statements}\nEND\n");
    let loaded = loaded(&text, Robot::Titan8);
    assert!(loaded.program.is_some(), "{:#?}", loaded.diagnostics);
    listing::formal(&loaded.source, &loaded.module).replace('\t', "|")
}

// clauses: 9.1 1.7 1.12 2.1
#[test]
fn a_line_for_each_step_and_none_for_the_rest() {
    let lines =
        formal("def_var n // declared\n\n// nothing\nstart : n = 1 ; ; sleep n\n  goto Start:");
    assert_eq!(lines, "START:\nN|=|1\nSLEEP|N\nGOTO|START:\nEND\n");
}

// clauses: 9.1
#[test]
fn equations_are_cut_at_their_operators() {
    let lines = formal(
        "DEF_VAR a\nDEF_POS p\na=-a+p.x\na -= -1.50\np.z=atan2 a,-a\np = p*p\np=rot_z p -a\na=1e3",
    );
    let expected = "\
A|=|-A|+|P.X
A|-=|-1.50
P.Z|=|ATAN2|A|-A
P|=|P|*|P
P|=|ROT_Z|P|-A
A|=|1E3
END
";
    assert_eq!(lines, expected);
}

// clauses: 9.1 7.20
#[test]
fn control_words_and_conditions_are_fields() {
    let lines = formal(
        "DEF_VAR i\nLOOP:\nif i<>-2 then\nelseif !kb_hit then\nelse\nendif\nif KB_HIT goto\n\
         if i>=1 goto l1:\nif i==1 gosub l1:\nwhile i<3\nwend\nrepeat\nuntil inpos_all\n\
         for i=1 to 5\nnext\nfor i = 5 to -1 step -2\nnext i\ncall s1:\ngosub s1:\ngoto loop:\n\
         l1: return\nsubroutine s1:\nexit\nsubend",
    );
    let expected = "\
LOOP:
IF|I|<>|-2|THEN
ELSEIF|!KB_HIT|THEN
ELSE
ENDIF
IF|KB_HIT|GOTO
IF|I|>=|1|GOTO|L1:
IF|I|==|1|GOSUB|L1:
WHILE|I|<|3
WEND
REPEAT
UNTIL|INPOS_ALL
FOR|I|=|1|TO|5
NEXT
FOR|I|=|5|TO|-1|STEP|-2
NEXT|I
CALL|S1:
GOSUB|S1:
GOTO|LOOP:
L1:
RETURN
SUBROUTINE|S1:
EXIT
SUBEND
END
";
    assert_eq!(lines, expected);
}

// clauses: 9.1 1.11
#[test]
fn commands_keep_their_flags_and_aliases() {
    let lines = formal(
        "DEF_POS p\nteach_pos f1 , p\nptp hs F1 r 0.0,R 1 a -p.x\nptp\tf2  r\tp\nwait_in_pos all\n\
         ad_in 0 13 var_key\nkey_in\nmessage_clear",
    );
    let expected = "\
TEACH_POS|F1|P
PTP|HS|F1|R|0.0|R|1|A|-P.X
PTP|F2|R|P
WAIT_IN_POS|ALL
AD_IN|0|13|VAR_KEY
KEY_IN
MESSAGE_CLEAR
END
";
    assert_eq!(lines, expected);
}

// clauses: 9.1 7.47
#[test]
fn a_message_keeps_its_text_and_rem_loses_it() {
    let lines =
        formal("message   Left  hand, %n% // gone\nMESSAGE\nMessage ;\nrem some words\nREM");
    assert_eq!(
        lines,
        "MESSAGE|Left  hand, %n%\nMESSAGE\nMESSAGE\nREM\nREM\nEND\n"
    );
}

// clauses: 9.2 2.1
#[test]
fn labels_stand_with_their_steps_and_kinds() {
    let text = "3.1\nlabels\nDEF_VAR n\nloop: a: n = 1\ngoto b:\nLOOP:\nb: exit\nsubroutine s:\n\
                inner: sleep n\nsubend\nEND\n";
    let expected = "\
L\tLOOP:\t0
L\tA:\t1
L\tLOOP:\t4
L\tB:\t5
S\tS:\t7
L\tINNER:\t8
";
    assert_eq!(listing::label(&program(text, Robot::Titan8)), expected);
}

// clauses: 9.2
#[test]
fn a_program_without_labels_has_an_empty_list() {
    assert_eq!(
        listing::label(&program("3.1\nnone\nEND\n", Robot::Titan8)),
        ""
    );
}

/// Returns a gait with as many steps between its labels as the classical example has.
fn gait() -> String {
    let mut text = String::from(
        "3.1\nBody-grounded crawl\nDEF_VAR reach, lift, raw, zero1, zero2, turn, limit\n\n",
    );
    let feet = |text: &mut String, arguments: &str| {
        for foot in 1..=4 {
            text.push_str(&format!("\tptp f{foot} {arguments} // foot {foot}\n"));
        }
    };
    text.push_str("reach = 391\nlift = 50 ; limit = 70\nraw = 0\nset_a_max all 1000\nset_v_max all 500\nset_near_position all 5\n");
    feet(&mut text, "r 0 r 0 r 0");
    text.push_str("\nzero_1:\nwait_inpos all\nad_in vr1 zero1\n\n");
    text.push_str("zero_2 :\nwait_inpos all\nad_in vr2 zero2\n");
    text.push_str("ask :\nwait_inpos all ; ad_in vr1 turn\nturn -= zero1\nturn *= 10\n");
    text.push_str("if turn <= 100 goto not_more:\nturn = 100\n");
    text.push_str("not_more:\nif turn > -100 goto not_less:\nturn = -100\n");
    text.push_str("not_less:\nraw = abs turn\nif raw < limit goto height:\ngoto walk:\n");
    text.push_str(
        "height :\nwait_inpos all\nad_in vr2 raw\nraw -= zero2\nraw *= 20\nraw += -200\n",
    );
    feet(&mut text, "r 0 a reach raw");
    text.push_str("goto ask:\n");
    text.push_str("walk :\n");
    for arguments in [
        "r 0 r 0 r lift",
        "r 0 r 200 r 0",
        "r 0 r 0 r -lift",
        "r 0 r 0 r -lift",
        "r 0 r -200 r 0",
    ] {
        feet(&mut text, arguments);
        text.push_str("wait_inpos all\n\n");
    }
    feet(&mut text, "r 0 a reach raw");
    text.push_str("wait_inpos all\nif halt_request goto out:\ngoto zero_2:\n");
    text.push_str("out :\ninitial_posture\nwait_inpos all\nEND\n");
    text
}

// clauses: 2.1 2.2 9.2
#[test]
fn the_classical_numbering_of_labels() {
    let expected = "\
L\tZERO_1:\t11
L\tZERO_2:\t14
L\tASK:\t17
L\tNOT_MORE:\t24
L\tNOT_LESS:\t27
L\tHEIGHT:\t31
L\tWALK:\t42
L\tOUT:\t75
";
    assert_eq!(listing::label(&program(&gait(), Robot::Titan8)), expected);
}

fn cases(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of cases") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            cases(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "prg") {
            found.push(path);
        }
    }
}

/// Returns a program text from nothing but the listing and the variables.
fn from_listing(loaded: &Loaded, program: &Program) -> String {
    let mut text = format!("{}\nfrom its listing\n", program.edition());
    // Texts keep the names of constants.
    for statement in &loaded.module.statements {
        if let StatementKind::Constant { .. } = statement.kind {
            text += &format!("{}\n", loaded.source.slice(statement.span));
        }
    }
    let declared = program.variables()[1..].iter();
    for variable in declared.filter(|variable| variable.special.is_none()) {
        let keyword = match variable.kind {
            VariableKind::Var => "DEF_VAR",
            VariableKind::Pos => "DEF_POS",
            VariableKind::Joint => "DEF_JOINT",
        };
        text.push_str(&format!("{keyword} {}\n", variable.name));
    }
    text + &listing::formal(&loaded.source, &loaded.module)
}

// clauses: 9.1
#[test]
fn a_listing_is_the_same_program() {
    let mut paths = Vec::new();
    let root = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../tests/language/cases");
    if !root.is_dir() {
        return; // The package alone has no cases.
    }
    cases(&root, &mut paths);
    let mut compared = 0;
    for path in paths {
        let bytes = fs::read(&path).expect("a readable case");
        for robot in Robot::ALL {
            let options = Options {
                robot: *robot,
                ..Options::default()
            };
            let loaded = load("case.prg", &bytes, &options);
            let Some(first) = &loaded.program else {
                continue;
            };
            let again = program(&from_listing(&loaded, first), *robot);
            let actions = |program: &Program| -> Vec<_> {
                program
                    .steps()
                    .iter()
                    .map(|step| step.action.clone())
                    .collect()
            };
            assert_eq!(actions(&again), actions(first), "{}", path.display());
            assert_eq!(again.labels(), first.labels(), "{}", path.display());
            compared += 1;
        }
    }
    assert!(compared > 500, "{compared} programs");
}
