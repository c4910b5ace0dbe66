//! Possible outcomes of a statement: rules over the table of commands, never over what a case shows.

use super::form::{Form, Head};
use super::outcome::Outcome;
use super::sentence::{CONDITION, EQUATION, LABEL, NATIVE, Sentence};
use tip_runtime::command::Op;
use tip_runtime::fault::Fault;
use tip_runtime::model::Family;
use tipc::Robot;
use tipc::language::Edition;
use tipc::language::commands::{self, Command, Robots};

/// Possibility of an outcome, or the reason against it, in a word.
pub type Possible = Result<(), &'static str>;

fn rule(holds: bool, why: &'static str) -> Possible {
    if holds { Ok(()) } else { Err(why) }
}

/// Returns the possibility of an outcome for a statement of this form on a robot.
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
        Outcome::Surplus => rule(!is_optional(form, form.length() + 1), "optional"),
        Outcome::Missing if is_optional(form, form.length()) => Err("optional"),
        Outcome::Missing | Outcome::Malformed => rule(form.length() > 0, "no argument"),
        Outcome::WrongType | Outcome::UnknownVariable => {
            rule(!form.values.is_empty(), "no operand")
        }
        Outcome::WrongFlag => rule(form.is_motion() && !form.values.is_empty(), "no flag"),
        Outcome::WrongTarget => rule(form.head.is_some(), "no target"),
        Outcome::NeverAssigned | Outcome::Unassigned => rule(form.reads(), "reads nothing"),
        Outcome::OutOfRange => rule(form.has_limit() && form.takes_constants(), "no limit"),
        Outcome::Domain => rule(
            fails(form.command, |fault| *fault == Fault::Domain),
            "no limit",
        ),
        Outcome::OutOfReach => reach(form),
        Outcome::JointLimit => limit(form, robot),
        Outcome::Sensor => rule(senses(form, robot), "no sensor"),
        Outcome::Mode => mode(form),
        _ => Err("control only"),
    }
}

/// Returns true if the command can do with and without the last of so many arguments.
pub fn is_optional(form: &Form, count: usize) -> bool {
    match form.command.form {
        commands::Form::KeyIn => count == 1,
        commands::Form::Special => (2..=3).contains(&count),
        _ => false,
    }
}

/// Returns true if a command can fail so, as the table of commands says.
fn fails(command: &Command, is_so: fn(&Fault) -> bool) -> bool {
    command.failures().iter().any(|(fault, _)| is_so(fault))
}

fn reach(form: &Form) -> Possible {
    let fails = fails(form.command, |fault| matches!(fault, Fault::OutOfReach(_)));
    rule(fails, "no place")?;
    rule(!ends_anywhere(form.command), "later")
}

/// A finger whose joint is at its limit goes on by the others.
fn limit(form: &Form, robot: Robot) -> Possible {
    let fails = fails(form.command, |fault| matches!(fault, Fault::JointLimit(..)));
    let several = form.command.unit.starts_with("mm") && robot.signature().family == Family::Hand;
    rule(fails, "no limit")?;
    rule(!ends_anywhere(form.command), "later")?;
    rule(!several, "others turn")
}

/// Returns true if what a command sets off may come to a limit, but need not: torques, springs and searches end where something
/// stops them. A velocity goes on until it does.
fn ends_anywhere(command: &Command) -> bool {
    let on_its_way = fails(command, |fault| matches!(fault, Fault::JointLimit(..)));
    on_its_way && !command.unit.ends_with("/s")
}

/// A search feels with soles where a robot has them ([7.45]), else with torques.
fn senses(form: &Form, robot: Robot) -> bool {
    let is_input = form.command.form == commands::Form::AdIn;
    let fails = fails(form.command, |fault| matches!(fault, Fault::Sensor(_)));
    fails && (is_input || Head::Paw.is_on(robot))
}

/// A command that wants a mode passes where ALL is its target ([7.16]); no force can be in the way of one that no robot
/// with forces has ([7.44]).
fn mode(form: &Form) -> Possible {
    if form.head == Some(Head::All) {
        return Err("passes");
    }
    if form.command.robots == Robots::TITAN {
        return Err("no force mode");
    }
    let wants = fails(form.command, |fault| *fault == Fault::InvalidMode);
    rule(wants, "any mode")
}

/// Returns the possibility of an outcome for a statement of this form on a robot.
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
    if name == NATIVE {
        let comes = matches!(outcome, Outcome::Valid | Outcome::Domain);
        return rule(comes && robot == Robot::Hand, "no native code");
    }
    let can = |fault: Fault| {
        let command = commands::find_in(name, Edition::V3_2);
        command.is_some_and(|command| command.failures().iter().any(|(of, _)| *of == fault))
    };
    let says = is(&["MESSAGE", "F_MESSAGE"]);
    let text = says || name == "REM";
    let lone = is(&["ELSE", "ENDIF", "WEND", "REPEAT"]);
    let compares = has("condition");
    let jumps = has("label:") || is(&["GOTO"]) || has("GOTO");
    let names_block = is(&["CALL", "START_THREAD", "STOP_THREAD", "WAIT_THREAD"]);
    let labels = is(&["SUBROUTINE", "THREAD", LABEL]);
    match outcome {
        Outcome::Valid => Ok(()),
        Outcome::Argument if is(&["NEXT", "GOTO"]) && form.text.is_empty() => Err("optional"),
        Outcome::Argument => rule(!text && !lone && name != "END", "any words"),
        Outcome::Format => rule(
            lone || labels || has("name,") || has("text") && name == "MESSAGE",
            "names nothing",
        ),
        Outcome::LongString => rule(says && has("text"), "no text"),
        Outcome::UnknownLabel => rule(jumps || names_block, "no jump"),
        Outcome::DuplicateLabel => rule(labels, "no label"),
        Outcome::Structure => rule(
            jumps
                || lone
                || has("THEN")
                || is(&["WHILE", "UNTIL", "FOR", "NEXT", "SUBROUTINE", "SUBEND"])
                || is(&["THREAD", "THREADEND"]),
            "no block",
        ),
        Outcome::NoEnd => rule(name == "END", "not END"),
        Outcome::UnknownVariable => rule(
            compares || has("VAR") || has("S") || has("constant"),
            "no operand",
        ),
        Outcome::NeverAssigned => rule(compares || has("S") || has("%VAR%"), "reads nothing"),
        Outcome::Unassigned => rule(
            compares || has("S") || has("%VAR%") || name == "NEXT",
            "reads nothing",
        ),
        Outcome::OutOfRange => rule(has("STEP"), "no limit"),
        Outcome::Domain => rule(
            can(Fault::Domain) && (has("STEP") || name == "NEXT"),
            "no limit",
        ),
        Outcome::Return => rule(can(Fault::InvalidReturn), "no return"),
        Outcome::Mode => rule(can(Fault::InvalidMode), "no thread"),
        Outcome::Depth => rule(
            can(Fault::TooDeep) && (name != "IF" || has("GOSUB")),
            "no call",
        ),
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

/// Returns true if a constant alone can leave the equation without a result ([4.9]).
fn has_a_domain(equation: &str) -> bool {
    let Some(("S", right)) = equation.split_once(' ') else {
        return false;
    };
    let narrow = ["SQRT", "ASIN", "ACOS", "ATAN", "ATAN2"];
    right == "/= S"
        || right.ends_with("S / S")
        || right.split(' ').any(|word| narrow.contains(&word))
}

/// Returns true if a value can be no finite number, or the function has none ([4.9]).
fn can_overflow(equation: &str) -> bool {
    let mut words = equation.split(' ').skip(1);
    let update = words.next().unwrap_or_default();
    let first = words.next().unwrap_or_default();
    let copies = words.next().is_none();
    let wave = ["SIN", "COS"].contains(&first);
    // A sum with so small a number rounds to the larger one.
    let small = wave || first == "TAN";
    match update {
        "=" => !(copies || small || ["INT", "ABS", "DEG2RAD"].contains(&first)),
        "+=" | "-=" => !small,
        "*=" => !wave,
        _ => true,
    }
}
