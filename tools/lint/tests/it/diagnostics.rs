//! Wrong programs as people write them, with all that they read about each, in both languages.

use std::fs;
use std::path::{Path, PathBuf};
use tip_lint::{Loaded, Options, load, recognize_robot};
use tipc::Robot;
use tipc::code::{Code, Level};
use tipc::message::{Lang, Message};
use tipc::render::{Style, human};

/// Returns the programs, in order.
fn programs() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/diagnostics");
    let entries = fs::read_dir(folder).expect("the folder of programs");
    let mut programs: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry").path())
        .filter(|path| path.extension().is_some_and(|end| end == "prg"))
        .collect();
    programs.sort();
    programs
}

/// Returns all that is said of a program, line ends without blanks before them.
fn shown(program: &Path, lang: Lang) -> String {
    let bytes = fs::read(program).expect("a program");
    let name = program.file_name().expect("a name").to_string_lossy();
    let loaded = load(&name, &bytes, &Options::default());
    let style = Style::default().lang(lang);
    let texts = loaded.diagnostics.iter();
    let texts = texts.map(|diagnostic| human(&loaded.source, diagnostic, style));
    let text = texts.collect::<Vec<_>>().join("\n");
    let lines = text.lines().map(|line| line.trim_end().to_owned() + "\n");
    lines.collect()
}

#[test]
fn people_read_what_stands_beside_each_program() {
    let programs = programs();
    assert!(programs.len() >= 60, "{}", programs.len());
    let mut wrong = Vec::new();
    for program in programs {
        for (lang, end) in [(Lang::English, "en"), (Lang::Japanese, "ja")] {
            let expected = fs::read_to_string(program.with_extension(end)).unwrap_or_default();
            let shown = shown(&program, lang);
            assert!(!shown.is_empty(), "{}: nothing is wrong", program.display());
            if shown != expected {
                let name = program.display();
                wrong.push(format!("{name}, {end}:\n{shown}instead of\n{expected}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn one_mistake_is_one_error() {
    // Programs with more than one mistake.
    let several = [
        "else_colon.prg",
        "label_and_jump_bare.prg",
        "loop_without_colon.prg",
        "not_declared.prg",
        "subroutine_without_colon.prg",
    ];
    for program in programs() {
        let name = program.file_name().expect("a name").to_string_lossy();
        let bytes = fs::read(&program).expect("a program");
        let found = load(&name, &bytes, &Options::default()).diagnostics;
        let limit = if several.contains(&&*name) { 2 } else { 1 };
        assert_eq!(found.len(), limit, "{name}: {found:#?}");
    }
}

fn check(statements: &str) -> Loaded {
    let text = format!("3.1\nA title\n{statements}\nEND\n");
    load("findings.prg", text.as_bytes(), &Options::default())
}

#[test]
fn a_comment_of_c_ends_where_it_ends() {
    let help = |statements: &str| {
        let loaded = check(statements);
        let [diagnostic] = loaded.diagnostics.as_slice() else {
            panic!("{statements}: {:#?}", loaded.diagnostics);
        };
        diagnostic.help.as_ref().map(Message::to_string)
    };
    let mark = Some("a comment starts with `//`".to_owned());
    assert_eq!(help("/* one; two */"), mark);
    assert_eq!(help("/* see http://example.com */"), mark);
    let each = Some("start each line of a comment with `//`".to_owned());
    assert_eq!(help("/* one\n FOO; two */"), each);
    assert_eq!(help("/* never closed\nFOO"), each);
    // What follows the comment is judged again.
    let after = check("/* one; two */\nFOO");
    assert_eq!(after.diagnostics.len(), 2);
}

#[test]
fn jumps_belong_to_the_first_label_without_its_colon() {
    let loaded = check("START\nSTART\nGOTO START:\nGOTO START:");
    let labels: Vec<usize> = loaded
        .diagnostics
        .iter()
        .map(|one| one.labels.len())
        .collect();
    assert_eq!(labels, [2, 0], "{:#?}", loaded.diagnostics);
}

#[test]
fn an_error_is_not_the_rest_of_a_warning() {
    let text = "3.1\nA title\nDEF_JOINT Q\n-1 2\nEND\n";
    let loaded = load("minus.prg", text.as_bytes(), &Options::default());
    assert!(loaded.program.is_none());
    let codes: Vec<Code> = loaded.diagnostics.iter().map(|one| one.code).collect();
    assert!(codes.contains(&Code::UnknownCommand), "{codes:?}");
}

#[test]
fn any_character_may_stand_in_what_another_language_shows() {
    for shown in [
        "PRINT ｱTRQ1.J1",
        "PRINT \"歩く\", ｱ",
        "SAY 歩.く",
        "MESSAGE(ｱ)",
        "PRINT 1ｱ",
    ] {
        let text = format!("3.1\nA title\n{shown}\nEND\n");
        let loaded = load("shown.prg", text.as_bytes(), &Options::default());
        assert_eq!(
            loaded.diagnostics.len(),
            1,
            "{shown}: {:?}",
            loaded.diagnostics
        );
    }
}

// clauses: 3.1 5.1 7.32
#[test]
fn foreign_declarations_inputs_and_conditions() {
    let help = |statements: &str| {
        let loaded = check(statements);
        let [diagnostic] = loaded.diagnostics.as_slice() else {
            panic!("{statements}: {:#?}", loaded.diagnostics);
        };
        diagnostic.help.as_ref().map(Message::to_string)
    };
    let declare = Some(
        "declare variables with `DEF_VAR A` (a number), `DEF_POS P` or `DEF_JOINT Q`".to_owned(),
    );
    assert_eq!(help("DEF_INT N\nN = 3\nSLEEP N"), declare.clone());
    assert_eq!(
        help("DEF_POINT P\nTEACH_POSITION F1 P\nPTP F1 P"),
        declare.clone()
    );
    assert_eq!(
        help("DEF_ANGLE Q\nTEACH_ANGLE F1 Q\nPTP_ANGLE F1 Q"),
        declare
    );
    let read = Some("read an input with `AD_IN VR1 A`".to_owned());
    assert_eq!(help("DEF_VAR V\nV = AD_IN(VR1)\nSLEEP V"), read);
    let conditions = Some("a condition is a comparison of two numbers, as `A >= 5`, or an event flag, as `KB_HIT` or `!KB_HIT`".to_owned());
    assert_eq!(help("IF THEN\nALL_STOP\nENDIF"), conditions);
}

/// A program for the hand is no mistake of its own on each line of another robot.
#[test]
fn a_program_for_another_robot_is_one_error() {
    let errors = |statements: &str, robot: Robot| {
        let text = format!("3.1\nt\n{statements}\nEND\n");
        let options = Options {
            robot,
            ..Options::default()
        };
        let mut loaded = load("p.prg", text.as_bytes(), &options);
        recognize_robot(&mut loaded, text.as_bytes(), &options);
        let found = loaded.diagnostics.iter();
        let found = found.filter(|it| it.level() == Level::Error);
        found.map(|it| it.reason.to_string()).collect::<Vec<_>>()
    };
    let grasp = "PTP FLOOR 0 0 0\nTORQUE J11 200\nTORQUE J21 100\nTORQUE J31 100";
    let one = "this looks like a program for hand: it has no errors there, and many for titan8";
    assert_eq!(errors(grasp, Robot::Titan8), [one]);
    assert!(errors(grasp, Robot::Hand).is_empty());
    // Too few to tell, and a program that has errors on the hand too.
    assert_eq!(
        errors("TORQUE J11 200\nTORQUE J21 100", Robot::Titan8).len(),
        2
    );
    let wrong = format!("{grasp}\nSLEEP X");
    assert_eq!(errors(&wrong, Robot::Titan8).len(), 5);
}
