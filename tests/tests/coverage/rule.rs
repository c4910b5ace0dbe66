//! What can come of a statement: rules over the table of commands, never over what a case shows.

use super::form::{Form, Head};
use super::outcome::Outcome;
use super::sentence::{CONDITION, EQUATION, LABEL, Sentence};
use tip_runtime::command::Op;
use tip_runtime::model::Family;
use tipc::Robot;
use tipc::commands::Robots;

/// That something can happen, or why it cannot, in a word.
pub type Possible = Result<(), &'static str>;

fn rule(holds: bool, why: &'static str) -> Possible {
    if holds { Ok(()) } else { Err(why) }
}

/// Whether a statement of this form can come to an outcome on a robot; if not, why.
pub fn of_command(form: &Form, robot: Robot, outcome: Outcome) -> Possible {
    let has_command = form.command.robots.contains(robot);
    if outcome == Outcome::UnknownCommand {
        return rule(!has_command, "known");
    }
    if !has_command {
        return Err("no such command");
    }
    let has_head = form.head.is_none_or(|head| head.is_on(robot));
    if outcome == Outcome::Lacking {
        let numbered = form.head.is_some_and(|head| head.is_numbered());
        return match form.head {
            None => Err("no target"),
            Some(_) => rule(!has_head || numbered, "has it"),
        };
    }
    if !has_head {
        return Err("no such target");
    }
    match outcome {
        Outcome::Valid => rule(
            form.op() != Some(Op::Special) || robot.signature().family == Family::Hand,
            "no native code",
        ),
        Outcome::Surplus => Ok(()),
        Outcome::Missing | Outcome::Malformed => rule(form.length() > 0, "no argument"),
        Outcome::WrongType | Outcome::UnknownVariable => {
            rule(!form.values.is_empty(), "no operand")
        }
        Outcome::WrongFlag => rule(form.is_motion() && !form.values.is_empty(), "no flag"),
        Outcome::WrongTarget => rule(form.head.is_some(), "no target"),
        Outcome::NeverAssigned | Outcome::Unassigned => rule(form.reads(), "reads nothing"),
        Outcome::OutOfRange => rule(form.has_limit() && form.takes_constants(), "no limit"),
        Outcome::Domain => rule(
            form.has_limit() || form.op() == Some(Op::Special),
            "no limit",
        ),
        Outcome::OutOfReach => rule(form.op().is_some_and(is_sent_to_a_place), "no place"),
        Outcome::Mode => mode(form),
        _ => Err("control only"),
    }
}

/// Whether the command refuses a place that cannot be reached ([7.2], [7.3], [7.4], [7.44]).
fn is_sent_to_a_place(op: Op) -> bool {
    use Op::{Ptp, PtpAngle, RelPtp, RelPtpAngle, SitDown, StandUp};
    matches!(
        op,
        Ptp | RelPtp | PtpAngle | RelPtpAngle | StandUp | SitDown
    )
}

/// WAIT_NEAR of a foot or joint that nothing controls ([7.16]); STAND_UP among forces ([7.44]), which
/// its robots do not have.
fn mode(form: &Form) -> Possible {
    match form.op() {
        Some(Op::WaitNear) if form.head != Some(Head::All) => Ok(()),
        Some(Op::WaitNear) => Err("passes"),
        Some(Op::StandUp | Op::SitDown) if form.command.robots == Robots::TITAN => {
            Err("no force mode")
        }
        _ => Err("any mode"),
    }
}

/// Whether a statement of this form can come to an outcome on a robot; if not, why.
pub fn of_sentence(form: &Sentence, robot: Robot, outcome: Outcome) -> Possible {
    let has = |word: &str| form.text.split(' ').any(|part| part == word);
    let name = form.name;
    let is = |names: &[&str]| names.contains(&name);
    if name == EQUATION {
        return of_equation(form, outcome);
    }
    if name == CONDITION {
        return of_condition(form, robot, outcome);
    }
    let text = is(&["MESSAGE", "REM"]);
    let lone = is(&["ELSE", "ENDIF", "WEND", "REPEAT"]);
    let compares = has("condition");
    let jumps = has("label:") || is(&["CALL", "GOTO"]) || has("GOTO");
    match outcome {
        Outcome::Valid => Ok(()),
        Outcome::Argument => rule(!text && !lone && name != "END", "any words"),
        Outcome::Format => rule(
            lone || has("name:") || has("name,") || has("text") && name == "MESSAGE",
            "no text",
        ),
        Outcome::LongString => rule(name == "MESSAGE" && has("text"), "no text"),
        Outcome::UnknownLabel => rule(jumps, "no jump"),
        Outcome::DuplicateLabel => rule(is(&["SUBROUTINE", LABEL]), "no label"),
        Outcome::Structure => rule(
            jumps
                || lone
                || has("THEN")
                || is(&["WHILE", "UNTIL", "FOR", "NEXT", "SUBROUTINE", "SUBEND"]),
            "no block",
        ),
        Outcome::NoEnd => rule(name == "END", "not END"),
        Outcome::UnknownVariable => rule(compares || has("VAR") || has("S"), "no operand"),
        Outcome::NeverAssigned => rule(compares || has("S") || has("%VAR%"), "reads nothing"),
        Outcome::Unassigned => rule(
            compares || has("S") || has("%VAR%") || name == "NEXT",
            "reads nothing",
        ),
        Outcome::OutOfRange => rule(has("STEP"), "no limit"),
        Outcome::Domain => rule(has("STEP") || name == "NEXT", "no limit"),
        Outcome::Return => rule(is(&["RETURN", "SUBEND"]), "no return"),
        Outcome::Depth => rule(is(&["CALL", "GOSUB"]) || has("GOSUB"), "no call"),
        _ => Err("commands only"),
    }
}

fn of_condition(form: &Sentence, robot: Robot, outcome: Outcome) -> Possible {
    let compares = form.text.starts_with('S') && !form.text.starts_with("SPECIAL");
    let palm = form.text.ends_with("ANTENNA_ON");
    let numbered = ["_F", "_J", "FLAG"]
        .iter()
        .any(|end| form.text.ends_with(end));
    let lacks = palm && robot != Robot::Hand;
    match outcome {
        Outcome::Valid => rule(!lacks, "no palm"),
        Outcome::Argument => rule(compares || lacks || numbered, "has it"),
        Outcome::UnknownVariable | Outcome::NeverAssigned | Outcome::Unassigned => {
            rule(compares, "no operand")
        }
        _ => Err("conditions only"),
    }
}

fn of_equation(form: &Sentence, outcome: Outcome) -> Possible {
    match outcome {
        Outcome::Valid
        | Outcome::Equation
        | Outcome::UnknownVariable
        | Outcome::NeverAssigned
        | Outcome::Unassigned => Ok(()),
        Outcome::OutOfRange => rule(has_a_domain(&form.text), "no limit"),
        Outcome::Domain => rule(can_overflow(&form.text), "always finite"),
        _ => Err("equations only"),
    }
}

/// Whether a constant alone can leave the equation without a result ([4.9]).
fn has_a_domain(equation: &str) -> bool {
    let Some(("S", right)) = equation.split_once(' ') else {
        return false;
    };
    let narrow = ["SQRT", "ASIN", "ACOS", "ATAN", "ATAN2"];
    right == "/= S"
        || right.ends_with("S / S")
        || right.split(' ').any(|word| narrow.contains(&word))
}

/// Whether a value can be no finite number, or the function has none ([4.9]).
fn can_overflow(equation: &str) -> bool {
    let Some(value) = equation.split_once(" = ").map(|(_, value)| value) else {
        return true;
    };
    let tame = ["INT", "ABS", "SIN", "COS", "TAN", "DEG2RAD"];
    let first = value.split(' ').next().unwrap_or_default();
    value.contains(' ') && !tame.contains(&first)
}
