//! What a run says about itself: its summary, and a fall.

use super::super::place::place;
use super::super::report::plural;
use std::fmt::Write as _;
use tip_runtime::machine::Emergency;
use tip_runtime::plant::Motion;
use tip_runtime::printable::Printable;
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{Fall, Grasp, Interpreter, Run};
use tipc::language::Keyword;
use tipc::source::Source;

/// How and where it ended, and what the robot did. A robot without such figures has no lines about them.
pub(super) fn summary(run: &Run, ending: Ending, source: &Source) -> String {
    let program = run.program();
    let (how, step) = match ending {
        Ending::Program(End::End) => (Keyword::End.word(), program.at()),
        Ending::Program(End::Exit) => (Keyword::Exit.word(), program.at()),
        Ending::Emergency(Emergency { step, .. }) => ("emergency stop", step),
        Ending::Interrupted => ("interrupted", program.at()),
        Ending::Limit => ("--cycles used up", program.at()),
    };
    let (name, line) = (Printable::line(source.name()), program.line(step));
    let cycles = plural(run.cycles() as usize, "cycle");
    let time = seconds(run.time());
    let mut text = format!("{name}: {how} at line {line} after {cycles}, {time} of robot time\n");
    if let Some(moved) = run.motion() {
        text += &motion(&moved, run.first_fall(), run);
    }
    if let Some(held) = run.grasp() {
        text += &grasp(&held);
    }
    text
}

fn motion(motion: &Motion, first: Option<Fall>, run: &Run) -> String {
    let travel = &motion.travel;
    let (forward, right) = (
        sense(travel.y, "forward", "backward"),
        sense(travel.x, "to the right", "to the left"),
    );
    let (up, turn) = (
        sense(travel.z, "up", "down"),
        sense(travel.turn, "to the left", "to the right"),
    );
    let falls = match first {
        None => "none".to_owned(),
        Some(Fall { time, step, .. }) => {
            let (time, line) = (seconds(time), run.program().line(step));
            format!("{}, the first after {time} at line {line}", motion.falls)
        }
    };
    let (slip, margin) = (tenths(motion.slip), tenths(motion.least_margin));
    format!(
        "  travel  {} mm {}, {} mm {}, {} mm {}\n  turn    {} deg {}\n  falls   {falls}\n  \
         slip    {slip} mm at most\n  margin  {margin} mm at least\n",
        forward.0, forward.1, right.0, right.1, up.0, up.1, turn.0, turn.1
    )
}

fn grasp(grasp: &Grasp) -> String {
    let mut text = String::new();
    // Writing to a String cannot fail.
    for (n, object) in (1..).zip(&grasp.objects) {
        let (now, most) = (tenths(object.clearance), tenths(object.highest));
        let _ = writeln!(text, "  lift    object {n}: {now} mm, {most} mm at most");
    }
    for (n, tip) in (1..).zip(&grasp.fingertips) {
        let (now, most) = (tip.force(), tip.greatest);
        let _ = writeln!(text, "  force   F{n}: {now:.2} N, {most:.2} N at most");
    }
    text
}

/// How the robot is now, in one line: the time, its motion, and the statement that is next.
pub(super) fn status(run: &Run, source: &Source) -> String {
    let program = run.program();
    let line = program.line(program.at());
    let mut text = seconds(run.time());
    // Writing to a String cannot fail.
    if let Some(motion) = run.motion() {
        let (forward, margin) = (tenths(motion.travel.y), tenths(motion.margin));
        let falls = motion.falls;
        let _ = write!(
            text,
            " | {forward} mm forward, margin {margin} mm, falls {falls}"
        );
    }
    if let Some(grasp) = run.grasp() {
        for object in &grasp.objects {
            let _ = write!(text, " | lift {} mm", tenths(object.clearance));
        }
        let forces = grasp
            .fingertips
            .iter()
            .map(|tip| format!(" {:.2}", tip.force()));
        let _ = write!(text, " | force{} N", forces.collect::<String>());
    }
    let statement = source.line_text(line).trim();
    let _ = write!(text, " | line {line}: {}", Printable::line(statement));
    text
}

/// A fall, with the statement that ran.
pub(super) fn fall(fall: &Fall, level: &str, source: &Source, program: &Interpreter) -> String {
    let Fall {
        cycle, time, step, ..
    } = fall;
    let time = seconds(*time);
    let place = place(source, program.program(), *step);
    format!("{level}: the robot fell after {time}, in cycle {cycle}\n{place}")
}

/// Of ms.
pub(super) fn seconds(time: f64) -> String {
    format!("{:.3} s", time / 1000.0)
}

/// One decimal, and no -0.0.
pub(super) fn tenths(value: f64) -> String {
    let text = format!("{value:.1}");
    if text == "-0.0" {
        "0.0".to_owned()
    } else {
        text
    }
}

/// How much, and which way.
fn sense(value: f64, positive: &'static str, negative: &'static str) -> (String, &'static str) {
    let way = if tenths(value).starts_with('-') {
        negative
    } else {
        positive
    };
    (tenths(value.abs()), way)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_is_less_than_nothing() {
        assert_eq!(tenths(-0.04), "0.0");
        assert_eq!(tenths(-0.06), "-0.1");
        let told = |value| {
            let (much, way) = sense(value, "up", "down");
            format!("{much} {way}")
        };
        assert_eq!(told(-0.04), "0.0 up");
        assert_eq!(told(-3.21), "3.2 down");
        assert_eq!(told(3.21), "3.2 up");
    }
}
