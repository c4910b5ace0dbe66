//! The original's own example lines that do not load: the list of docs/language.md, each line with the diagnostic it gives.

use crate::reference::read;
use tipc::code::Level;
use tipc::diagnostic::Diagnostic;
use tipc::{Options, Robot, load};

/// Section, line, robot on which it comes nearest to loading, diagnostic.
const LINES: [(&str, &str, Robot, &str); 20] = [
    (
        "§1-1",
        "VAR01 = VAR02 + VAR03 + VAR04",
        Robot::Titan8,
        EQUATION,
    ),
    ("§1-1", "FOR VAR01 VAR02 TO VAR03", Robot::Titan8, ARGUMENT),
    ("§5", "VAR02 = SQRT VAR01 + VAR03", Robot::Titan8, EQUATION),
    ("§5", "POS01 = NORM POS02", Robot::Titan8, EQUATION),
    ("§5", "AGL01 = DEG2RAD AGL02", Robot::Titan8, EQUATION),
    ("§7-4-3", "WAIT_NEAR F1 10.0", Robot::Titan8, ARGUMENT),
    ("§7-4-3", "WAIT_NEAR J12 5.0", Robot::Titan8, ARGUMENT),
    (
        "§7-4-3",
        "WAIT_NEAR_POS J12 -VAR02",
        Robot::Titan8,
        "Unknown command \"WAIT_NEAR_POS\"",
    ),
    ("§7-5-2", "TEACH_ANGLE J11 AGL01", Robot::Titan8, ARGUMENT),
    ("§7-5-3", "TEACH_TORQUE J11 TRQ01", Robot::Hand, ARGUMENT),
    ("§7-5-4", "TEACH_FORCE J23 POS02", Robot::Hand, ARGUMENT),
    ("§7-8-1-5", "SET_A_MAX _NORMAL ALL", Robot::Titan8, ARGUMENT),
    ("§7-8-1-6", "SET_V_MAX _NORMAL ALL", Robot::Titan8, ARGUMENT),
    (
        "§7-8-2-5",
        "SET_OMEGA_MAX _NORMAL ALL",
        Robot::Titan8,
        ARGUMENT,
    ),
    (
        "§7-8-3-3",
        "SET_TORQUE_MAX_FAST J11",
        Robot::Hand,
        "Unknown command \"SET_TORQUE_MAX_FAST\"",
    ),
    (
        "§7-8-3-3",
        "SET_TORQUE_MAX _NORMAL ALL",
        Robot::Hand,
        ARGUMENT,
    ),
    ("§7-9-3", "L2: /* … */", Robot::Titan8, "Format error"),
    ("§7-11-3", "DETECT_FLOOR 1", Robot::Titan8, ARGUMENT),
    ("§8-3", "4.0", Robot::Hand, VERSION),
    ("§10-4-1", "2.0", Robot::Titan8, VERSION),
];

const ARGUMENT: &str = "Wrong argument";
const EQUATION: &str = "Wrong equation format";
const VERSION: &str = "Wrong version number";

/// Returns the diagnostics of the line, on a robot.
fn diagnostics(line: &str, diagnostic: &str, robot: Robot) -> Vec<String> {
    let text = match diagnostic {
        VERSION => format!("{line}\nan example\nEND\n"),
        _ => format!(
            "3.1\nan example\nDEF_VAR VAR01, VAR02, VAR03, VAR04\nDEF_POS POS01, POS02\nDEF_JOINT AGL01, AGL02, TRQ01\n\
             {line}\n{}END\n",
            if line.starts_with("FOR ") {
                "NEXT\n"
            } else {
                ""
            }
        ),
    };
    let options = Options {
        robot,
        ..Options::default()
    };
    let found = load("example.prg", text.as_bytes(), &options).diagnostics;
    let errors = found.iter().filter(|one| one.level() == Level::Error);
    errors.map(Diagnostic::message).collect()
}

// clauses: 10.1
#[test]
fn the_examples_of_the_original_that_do_not_load_are_listed() {
    let document = read("docs/language.md");
    let (_, list) = document
        .split_once("### Examples of the original that do not load\n")
        .expect("the list");
    let (list, _) = list.split_once("\n## ").expect("the next chapter");
    for (section, line, robot, diagnostic) in LINES {
        let found = diagnostics(line, diagnostic, robot);
        assert_eq!(
            found.first().map(String::as_str),
            Some(diagnostic),
            "{line}: {found:?}"
        );
        for robot in Robot::ALL {
            assert_ne!(diagnostics(line, diagnostic, *robot), [""; 0], "{line}");
        }
        let row = format!("| {section} | `{line}` | `{diagnostic}` |");
        assert!(list.contains(&row), "{row}");
    }
    assert_eq!(list.matches("\n| §").count(), LINES.len());
}
