//! `tip drives zero`: sign and offset of each joint, found by turning it by hand.

use super::RobotArguments;
use super::robot::Connection;
use crate::error::Error;
use crate::message::Driving;
use crate::{Status, input, interrupt, output, report};
use clap::Args;
use std::fmt::Write as _;
use tip_drives::bus::BusError;
use tip_drives::described;
use tip_drives::description::Joint;
use tip_drives::family::{Query, Reading};
use tip_drives::model::Model;
use tip_runtime::model::Range;
use tipc::message::Lang;
use tipc::message::list::List;
use tipc::{description, embed};

#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  tip drives zero robot.toml            print sign and offset of each [[drive]]
  tip drives zero robot.toml --write    write them into the file

The place of a joint at the key counts, from two equal answers after it. A joint that was skipped, or
that was not turned, keeps its sign and its offset. What was found is kept when Ctrl-C, a fault or the
end of the input ends the command.

Exit status: 0 if each joint was turned or skipped, 130 after Ctrl-C, 1 if a servo does not answer or
the input ended before the last joint.")]
pub(crate) struct Zero {
    #[command(flatten)]
    robot: RobotArguments,

    /// Write the results into the description
    ///
    /// Only these two keys change: comments and order stay
    #[arg(long)]
    write: bool,
}

/// Number of times that a servo is asked for two equal positions in a row.
const READINGS: u32 = 50;
/// Difference of positions that count as equal, deg.
const STILL: f64 = 1.0;
/// Smallest and largest angle by which a hand turns a motor, deg. Beyond the largest, nobody can tell the way that it took.
const TURNED: Range = Range::new(3.0, 120.0);

/// An answer to a question about a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Answer {
    /// It is in its place.
    Done,
    /// It is left out.
    Skip,
    /// The input has ended, or the command was interrupted.
    Ended,
}

/// Asks until the answer is RETURN alone, `s`, or the end of the input.
fn answer(question: &Driving, lang: Lang) -> Result<Answer, Error> {
    loop {
        report::complain(&format!("{}: ", question.in_lang(lang)));
        let Some(line) = input::line()? else {
            return Ok(Answer::Ended);
        };
        match line.trim() {
            "" => return Ok(Answer::Done),
            "s" => return Ok(Answer::Skip),
            other => {
                let text = other.to_owned();
                report::say(Driving::NotAnAnswer { text }, lang);
            }
        }
    }
}

pub(super) fn zero(arguments: &Zero) -> Result<Status, Error> {
    interrupt::catch();
    let lang = arguments.robot.lang();
    let connection = arguments.robot.connect_to_measure()?;
    let joints = 0..connection.setup.joints.len();
    // The joints from this one on have neither a result nor were they skipped.
    let unfinished = |first: usize| {
        let left: Vec<usize> = (first..joints.end).collect();
        let joints = List(connection.setup.names(&left));
        Error::failed(Driving::ZeroUnfinished { joints }, lang)
    };
    if !release(&connection, lang)? {
        return match interrupt::is_requested() {
            true => Ok(Status::Interrupted),
            false => Err(unfinished(0)),
        };
    }
    report::say(Driving::ZeroHow, lang);
    let mut found = Vec::new();
    let mut failure = None;
    for place in joints.clone() {
        match zero_one(&connection, place, lang) {
            Ok(Zeroing::Found(one)) => found.push(one),
            Ok(Zeroing::Skipped) => {
                let joint = connection.setup.name(place);
                report::say(Driving::ZeroSkipped { joint }, lang);
            }
            Ok(Zeroing::Ended) => {
                failure = Some(unfinished(place));
                break;
            }
            Err(error) => {
                failure = Some(error);
                break;
            }
        }
    }
    // What was found is kept, whatever ended it.
    interrupt::hold();
    let status = keep(arguments, &found)?;
    match failure {
        _ if interrupt::is_requested() => Ok(Status::Interrupted),
        Some(error) => Err(error),
        None => Ok(status),
    }
}

/// Switches the torque off, after a key if a servo has any; returns false if the operator does not want that.
fn release(connection: &Connection, lang: Lang) -> Result<bool, Error> {
    let stiff = connection.robot().drives_mut().stiff();
    if !stiff.is_empty() {
        let joints = List(connection.setup.names(&stiff));
        let question = Driving::ZeroReleases { joints };
        if !matches!(answer(&question, lang)?, Answer::Done) {
            return Ok(false);
        }
    }
    relax(connection, lang)?;
    Ok(true)
}

/// Switches the torque of every servo off, and has each confirm it.
pub(super) fn relax(connection: &Connection, lang: Lang) -> Result<(), Error> {
    let mut robot = connection.robot();
    let drives = robot.drives_mut();
    // The drives do not expect the servos to hold any more. Each servo confirms below that its torque is off.
    let _ = drives.release();
    for place in 0..connection.setup.joints.len() {
        let mut tries = (0..READINGS).map(|_| drives.relax(place));
        if !tries.any(|confirmed| confirmed == Ok(true)) {
            let joints = List(connection.setup.names(&[place]));
            return Err(Error::failed(Driving::PerhapsStiff { joints }, lang));
        }
    }
    Ok(())
}

/// The result of a joint.
enum Zeroing {
    Found(Zeroed),
    Skipped,
    Ended,
}

/// Asks for the two places of a joint until they make sense.
fn zero_one(connection: &Connection, place: usize, lang: Lang) -> Result<Zeroing, Error> {
    let joint = connection.setup.name(place);
    let own = connection.setup.joints[place];
    loop {
        let question = Driving::AtZero {
            joint: joint.clone(),
        };
        match answer(&question, lang)? {
            Answer::Ended => return Ok(Zeroing::Ended),
            Answer::Skip => return Ok(Zeroing::Skipped),
            Answer::Done => {}
        }
        let Some(first) = position(connection, place, lang)? else {
            continue;
        };
        let question = Driving::AtPositive {
            joint: joint.clone(),
        };
        match answer(&question, lang)? {
            Answer::Ended => return Ok(Zeroing::Ended),
            Answer::Skip => return Ok(Zeroing::Skipped),
            Answer::Done => {}
        }
        let Some(second) = position(connection, place, lang)? else {
            continue;
        };
        let turned = Turned::between(own.model, first, second);
        let angle = turned.angle;
        if turned.is_ambiguous {
            let (joint, angle) = (joint.clone(), format!("{:.0}", angle.abs()));
            report::say(Driving::TurnedTooFar { joint, angle }, lang);
            continue;
        }
        // Neither its sign nor the place of its 0 is certain then: the hand may have turned another joint.
        if angle.abs() < TURNED.min {
            let joint = joint.clone();
            report::say(Driving::NotTurned { joint }, lang);
            continue;
        }
        if turned.crosses_the_end {
            let (joint, end) = (joint.clone(), own.model.largest.unsigned_abs());
            report::say(Driving::OverTheEnd { joint, end }, lang);
        }
        let offset = own.model.angle(first.into());
        return Ok(Zeroing::Found(Zeroed {
            place,
            joint,
            sign: angle.signum(),
            offset: (offset * 10.0).round() / 10.0,
        }));
    }
}

/// A turn of a motor by hand.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Turned {
    /// deg
    angle: f64,
    /// True if the motor may have turned the other way round, or through angles that the servo cannot measure.
    is_ambiguous: bool,
    /// True if it went from the largest position to 0, or the other way.
    crosses_the_end: bool,
}

impl Turned {
    /// Returns the turn from one position to another.
    fn between(model: &Model, from: i32, to: i32) -> Self {
        let (counts, range) = (f64::from(to - from), f64::from(model.largest) + 1.0);
        let is_ring = range == model.turn;
        let shortest = match is_ring {
            true => counts - model.turn * (counts / model.turn).round(),
            false => counts,
        };
        let angle = shortest * 360.0 / model.turn;
        Turned {
            angle,
            // A servo that counts turns is never in doubt.
            is_ambiguous: range <= model.turn && angle.abs() > TURNED.max,
            crosses_the_end: shortest != counts,
        }
    }
}

/// Asks the servos of some joints, and nobody else: their answers are younger than the call.
fn read(
    connection: &Connection,
    places: &[usize],
    turn: u32,
) -> Result<Vec<Option<Reading>>, BusError> {
    let joints = places.iter().map(|place| connection.setup.joints[*place]);
    let query = |joint: Joint| Query {
        id: joint.id,
        turn,
        is_late: false,
    };
    let queries: Vec<Query> = joints.map(query).collect();
    let mut found = vec![None; places.len()];
    let mut robot = connection.robot();
    let drives = robot.drives_mut();
    if let Some(family) = drives.family() {
        let bus = drives.bus_mut();
        let read = family.read(bus, &queries, u64::MAX, false, &mut |query, reading| {
            found[query] = Some(reading).filter(|it| it.is_plausible);
        });
        match read {
            Ok(_) | Err(BusError::NoAnswer) => {}
            Err(error) => return Err(error),
        }
    }
    Ok(found)
}

/// Measures the positions of joints that rest, all at one time; `None`, with a message, if they do not.
pub(super) fn positions(
    connection: &Connection,
    places: &[usize],
    lang: Lang,
) -> Result<Option<Vec<i32>>, Error> {
    let mut last: Vec<Option<i32>> = vec![None; places.len()];
    let mut moving = places.to_vec();
    for turn in 0..READINGS {
        let Ok(readings) = read(connection, places, turn) else {
            return Err(Error::failed(Driving::PortGone, lang));
        };
        moving.clear();
        for ((place, reading), last) in places.iter().zip(readings).zip(&mut last) {
            let now = reading.map(|reading| reading.position);
            let degree = connection.setup.joints[*place].model.turn / 360.0;
            let is_equal =
                |(last, now): (i32, i32)| f64::from((now - last).abs()) <= STILL * degree;
            if !last.zip(now).is_some_and(is_equal) {
                moving.push(*place);
            }
            *last = now.or(*last);
        }
        if moving.is_empty() {
            return Ok(last.into_iter().collect());
        }
        if interrupt::is_requested() {
            return Ok(None);
        }
        connection.robot().wait();
    }
    let joints = List(connection.setup.names(&moving));
    report::say(Driving::NotStill { joints }, lang);
    Ok(None)
}

/// Measures the position of a joint that rests; `None`, with a message, if it does not.
fn position(connection: &Connection, place: usize, lang: Lang) -> Result<Option<i32>, Error> {
    let found = positions(connection, &[place], lang)?;
    Ok(found.and_then(|found| found.first().copied()))
}

/// Writes what was found into the description, or prints it.
fn keep(arguments: &Zero, found: &[Zeroed]) -> Result<Status, Error> {
    let lang = arguments.robot.lang();
    let path = &arguments.robot.file;
    let file = || path.display().to_string().into();
    if found.is_empty() {
        report::say(Driving::ZeroNone { file: file() }, lang);
        return Ok(Status::Success);
    }
    if arguments.write {
        let text = embed::read_file(path, embed::LIMIT).unwrap_or_default();
        if let Some(new) = with_zeros(&text, found) {
            output::update(path, &text, new.as_bytes(), lang)?;
            let joints = List(found.iter().map(|it| it.joint.clone()).collect());
            let file = file();
            output::say(Driving::ZeroWritten { joints, file }, lang)?;
            return Ok(Status::Success);
        }
        report::say(Driving::ZeroKept { file: file() }, lang);
    }
    let result = Driving::ZeroResult { file: file() };
    let mut text = format!("{}\n", result.in_lang(lang));
    for Zeroed {
        joint,
        sign,
        offset,
        ..
    } in found
    {
        // Writing to a String cannot fail.
        let _ = writeln!(
            text,
            "joint = \"{joint}\", sign = {sign}, offset = {offset}"
        );
    }
    output::print(text)?;
    Ok(match arguments.write {
        true => Status::Failure,
        false => Status::Success,
    })
}

/// Sign and offset of a joint.
struct Zeroed {
    /// Its number, from 0.
    place: usize,
    joint: String,
    sign: f64,
    offset: f64,
}

/// Returns a description with new signs and offsets, and every other line as it was; `None` if it is not one then, or is written in
/// a form that lines do not show.
fn with_zeros(text: &[u8], found: &[Zeroed]) -> Option<String> {
    let key_of = |line: &str| line.split_once('=').map(|(key, _)| key.trim().to_owned());
    let old = description::parse_for_servos("", text, &described::servos()).ok()?;
    let mut lines: Vec<String> = str::from_utf8(text)
        .ok()?
        .split_inclusive('\n')
        .map(str::to_owned)
        .collect();
    for zeroed in found {
        let names_it = |line: &String| {
            let name = line.split_once('=').map(|(_, name)| name.trim());
            key_of(line).is_some_and(|key| key == "joint")
                && name.is_some_and(|name| {
                    let quoted = name.get(1..).unwrap_or_default();
                    quoted.starts_with(&zeroed.joint) && name.starts_with(['"', '\''])
                })
        };
        let joint = lines.iter().position(names_it)?;
        let is_head = |line: &String| line.trim_start().starts_with('[');
        let first = lines[..joint].iter().rposition(is_head)?;
        let end = lines[joint..].iter().position(is_head);
        let mut end = end.map_or(lines.len(), |after| joint + after);
        for (key, value) in [("offset", zeroed.offset), ("sign", zeroed.sign)] {
            let has_key = |line: &String| key_of(line).is_some_and(|own| own == key);
            let place = lines[first..end].iter().position(has_key);
            match place.and_then(|place| lines.get_mut(first + place)) {
                Some(line) => {
                    let (head, old) = line.split_once('=')?;
                    let rest = old.trim_start().find([' ', '\t', '#', '\r', '\n']);
                    let rest = rest.map_or("", |rest| &old.trim_start()[rest..]);
                    *line = format!("{head}= {value}{rest}");
                }
                None => {
                    let is_dos = lines[joint].ends_with("\r\n");
                    let line_end = if is_dos { "\r\n" } else { "\n" };
                    lines.insert(joint + 1, format!("{key} = {value}{line_end}"));
                    end += 1;
                }
            }
        }
    }
    let new = lines.concat();
    let mut expected = old.bus()?.clone();
    for zeroed in found {
        let drive = expected.drives.get_mut(zeroed.place)?;
        (drive.sign, drive.offset) = (zeroed.sign, zeroed.offset);
    }
    let read = description::parse_for_servos("", new.as_bytes(), &described::servos()).ok()?;
    (read.bus() == Some(&expected)).then_some(new)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn turned(model: &str, from: i32, to: i32) -> Turned {
        Turned::between(Model::named(model).expect("a model"), from, to)
    }

    /// 4096 counts are a ring: from 4000 to 132 it is 228 counts, 20.04 deg, and not 340 the other way.
    #[test]
    fn a_turn_over_the_end_is_the_shorter_one() {
        for model in ["STS3215", "XL430-W250", "MX-28"] {
            let over = turned(model, 4000, 132);
            assert!((over.angle - 20.04).abs() < 0.01, "{over:?}");
            assert!(over.crosses_the_end && !over.is_ambiguous);
            let back = turned(model, 132, 4000);
            assert!((back.angle + 20.04).abs() < 0.01, "{back:?}");
            let inside = turned(model, 1000, 1228);
            assert!((inside.angle - 20.04).abs() < 0.01 && !inside.crosses_the_end);
            // 1500 counts are 132 deg.
            assert!(turned(model, 1000, 2500).is_ambiguous);
            assert!(turned(model, 3800, 1204).is_ambiguous);
        }
    }

    /// These measure less than a turn: what lies between their ends cannot be seen.
    #[test]
    fn a_turn_through_the_gap_is_in_doubt() {
        // 300 deg in 1024 counts, 240 deg in 1001.
        for (model, one_degree) in [("AX-12", 3.413), ("LX-16A", 4.167)] {
            let near = turned(model, 500, 580);
            assert!((near.angle - 80.0 / one_degree).abs() < 0.1 && !near.is_ambiguous);
            assert!(turned(model, 980, 20).is_ambiguous, "{model}");
            assert!(!turned(model, 980, 20).crosses_the_end, "{model}");
        }
    }

    #[test]
    fn a_servo_that_counts_turns_is_never_in_doubt() {
        let wide = turned("moteus-mj5208", 500_000, 750_000);
        assert_eq!((wide.angle, wide.is_ambiguous), (900.0, false));
    }
}
