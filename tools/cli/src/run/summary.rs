//! The summary of a run, its status line, and the report of a fall.

use crate::drives::realtime::Histogram;
use crate::drives::robot::Connection;
use crate::message::count::Cycles;
use crate::message::{Along, Aside, Figure, How, Running, Until, Upright, Waiting, Weight};
use crate::output::width;
use crate::report::{fixed, step_location};
use serde::Serialize;
use std::fmt::{self, Write as _};
use tip_drives::drives::Counts;
use tip_runtime::command::Op;
use tip_runtime::machine::Emergency;
use tip_runtime::plant::{Motion, Travel, Unmodelled};
use tip_runtime::printable::Printable;
use tip_runtime::program::End;
use tip_runtime::record::Ending;
use tip_sim::{
    Approach, Fall, FallKind, Grasp, Interpreter, Peak, Run, Summary, TravelFigures, Wait,
    WaitCircle, WaitFigure,
};
use tipc::language::Keyword;
use tipc::message::{Lang, Message};
use tipc::program::Action;
use tipc::source::Source;

/// Returns the summary: how and where the run ended, what it waited for then, and what the robot did. A robot without such figures
/// has no lines about them.
pub(super) fn summary(
    run: &Run,
    ending: Ending,
    wait: Option<&Wait>,
    figures: &Summary,
    source: &Source,
    lang: Lang,
) -> String {
    let program = run.program();
    let by = |word| How::By { word };
    let how = match ending {
        Ending::Program(End::End) => by(Keyword::End),
        Ending::Program(End::Exit) => by(Keyword::Exit),
        Ending::Emergency(_) => How::Emergency,
        Ending::Interrupted => How::Interrupted,
        Ending::Limit => How::Limit,
    };
    let step = last_step(run, ending);
    let ended = Running::Ended {
        file: Printable::line(source.name()).to_string().into(),
        how,
        line: program.line(step),
        cycles: (run.cycles() as usize).into(),
        time: seconds(run.time()),
    };
    let mut lines = Lines {
        text: format!("{}\n", ended.in_lang(lang)),
        lang,
    };
    if let Ending::Interrupted | Ending::Limit = ending {
        lines.next(run);
        if let Some(wait) = wait.map(wait_message) {
            lines.add(Figure::Waits, &Running::IsWaiting { wait });
        }
    }
    if let Some(travel) = run.travel() {
        lines.travel(&travel);
    }
    if let Some(moved) = run.motion() {
        lines.motion(&moved, figures, run);
    }
    if run.motion().is_none() {
        lines.effort(figures);
    }
    lines.collisions(run);
    if let Some(held) = run.grasp() {
        lines.grasp(&held);
    }
    for wait in &figures.waits {
        lines.waited(wait);
    }
    lines.text
}

/// Returns the step that ran last, or that comes next in a run that was cut off.
fn last_step(run: &Run, ending: Ending) -> u32 {
    let next = run.program().at();
    match ending {
        // A thread may have ended the program.
        Ending::Program(_) => (run.steps().last()).map_or(next, |step| step.from.step),
        Ending::Emergency(Emergency { step, .. }) => step,
        Ending::Interrupted | Ending::Limit => next,
    }
}

/// The summary as JSON: docs/files.md lists its keys.
#[derive(Serialize)]
struct Report<'a> {
    file: &'a str,
    end: &'static str,
    error: Option<String>,
    line: u32,
    #[serde(flatten)]
    figures: &'a Summary,
}

/// Returns the summary as a line of JSON.
pub(super) fn json(run: &Run, ending: Ending, figures: &Summary, source: &Source) -> String {
    let report = Report {
        file: source.name(),
        end: match ending {
            Ending::Program(End::End) => Keyword::End.word(),
            Ending::Program(End::Exit) => Keyword::Exit.word(),
            Ending::Emergency(_) => "EMERGENCY",
            Ending::Interrupted => "INTERRUPTED",
            Ending::Limit => "LIMIT",
        },
        error: match ending {
            Ending::Emergency(emergency) => Some(emergency.fault.to_string()),
            _ => None,
        },
        line: run.program().line(last_step(run, ending)),
        figures,
    };
    // No value of it can fail to be written.
    serde_json::to_string(&report).unwrap_or_default() + "\n"
}

/// Returns a line of the summary.
pub(crate) fn line(figure: Figure, value: impl fmt::Display, lang: Lang) -> String {
    let label = figure.in_lang(lang).to_string();
    let gap = " ".repeat(8_usize.saturating_sub(width(&label)));
    format!("  {label}{gap}{value}\n")
}

/// Returns the lines about the bus of a real robot.
pub(super) fn driven(connection: &Connection, jitter: Option<&Histogram>, lang: Lang) -> String {
    let robot = connection.robot();
    let drives = robot.drives();
    let counts = drives.counts();
    let time = bus_time(drives.joints().count(), &counts, connection.period());
    let answers = Running::BusAnswers {
        missing: counts.missing.to_string(),
        asked: drives.bus().counters().asked.to_string(),
        implausible: counts.implausible.to_string(),
        slowed: counts.slowed.to_string(),
        clipped: counts.clipped.to_string(),
    };
    let mut text = line(Figure::Bus, &time, lang) + &line(Figure::Answers, &answers, lang);
    if let Some(jitter) = jitter {
        let [p50, p99, p999] = [0.5, 0.99, 0.999].map(|part| jitter.quantile(part));
        let worst = jitter.worst().to_string();
        let jitter = Running::CycleJitter {
            p50,
            p99,
            p999,
            worst,
        };
        text += &line(Figure::Jitter, &jitter, lang);
    }
    text
}

/// Returns the time of a bus in a cycle, of which a program may have changed the sampling time, ms.
fn bus_time(servos: usize, counts: &Counts, first: f64) -> Running {
    let cycles = counts.commanded.max(1) as f64;
    let mean = counts.busy as f64 / cycles / 1000.0;
    let period = match counts.commanded {
        0 => first,
        _ => (counts.time as f64 / cycles / 100.0).round() / 10.0,
    };
    let (share, mean) = (mean / period, format!("{mean:.2}"));
    let longest = format!("{:.2}", counts.longest as f64 / 1000.0);
    match share > 1.0 {
        true => Running::BusOverrun {
            servos,
            mean,
            period,
            longest,
        },
        false => Running::BusTime {
            servos,
            mean,
            period,
            share: format!("{:.0}", share * 100.0),
            longest,
        },
    }
}

/// A summary while it is written.
struct Lines {
    text: String,
    lang: Lang,
}

impl Lines {
    fn add(&mut self, figure: Figure, value: &Running) {
        self.text += &line(figure, value.in_lang(self.lang), self.lang);
    }

    /// Adds the next statement, and what it waits for.
    fn next(&mut self, run: &Run) {
        let at = run.program().at() as usize;
        let program = run.engine::<Interpreter>().map(Interpreter::program);
        let Some(step) = program.and_then(|program| program.steps().get(at)) else {
            return;
        };
        let (line, statement) = (step.line, step.text.to_string().into());
        let waits_for = |thread: usize| {
            let (name, _) = run.program().thread(u8::try_from(thread + 1).ok()?)?;
            Some(Until::Thread {
                name: name.to_owned().into(),
            })
        };
        let until = match step.action {
            Action::WaitThread { thread } => waits_for(thread),
            _ => until(&step.action),
        };
        let next = match until {
            Some(until) => Running::Waits {
                line,
                statement,
                until,
            },
            None => Running::Next { line, statement },
        };
        self.add(Figure::Next, &next);
    }

    fn travel(&mut self, travel: &Travel) {
        let (y, along) = sense(travel.y, Along::Forward, Along::Backward);
        let (x, aside) = sense(travel.x, Aside::Right, Aside::Left);
        let (z, upright) = sense(travel.z, Upright::Up, Upright::Down);
        let travelled = Running::Travel {
            y,
            along,
            x,
            aside,
            z,
            upright,
        };
        self.add(Figure::Travel, &travelled);
        let (angle, aside) = sense(travel.turn, Aside::Left, Aside::Right);
        self.add(Figure::Turn, &Running::Turn { angle, aside });
    }

    fn motion(&mut self, motion: &Motion, figures: &Summary, run: &Run) {
        let moved = |travel: &&TravelFigures| tenths(travel.speed_mm_s.abs()) != "0.0";
        if let Some(travel) = figures.travel.as_ref().filter(moved) {
            let (value, along) = sense(travel.speed_mm_s, Along::Forward, Along::Backward);
            self.add(Figure::Speed, &Running::Speed { value, along });
        }
        self.add(Figure::Falls, &falls(motion, run.first_fall(), run));
        match &figures.slip {
            Some(slip) if tenths(slip.value) != "0.0" => self.largest(Figure::Slip, slip),
            _ => self.add(Figure::Slip, &Running::AtMost { value: tenths(0.0) }),
        }
        if let Some(Peak {
            value, unit, at, ..
        }) = &figures.margin
        {
            let least = Running::Least {
                value: tenths(*value),
                unit,
                time: seconds(at.time_s * 1000.0),
                cycle: at.cycle.to_string(),
                line: at.line,
            };
            self.add(Figure::Margin, &least);
        }
        self.effort(figures);
        let following = motion.tracking_errors;
        if let Some(unmodelled) = motion.unmodelled {
            self.unmodelled(&unmodelled);
        }
        let strayed = Running::Strays {
            cycles: (following.strays as usize).into(),
            by: tenths(following.farthest_stray),
        };
        let hurried = Running::Hurries {
            cycles: (following.hurries as usize).into(),
        };
        self.counted(following.hurries, Figure::Joint, &hurried);
        self.counted(following.strays, Figure::Path, &strayed);
        let matters = |unmodelled: Unmodelled| !unmodelled.is_empty() || !following.is_empty();
        if motion.unmodelled.is_some_and(matters) {
            self.add(Figure::Note, &Running::MassMatters);
        }
    }

    /// Adds the lines about joints.
    fn effort(&mut self, figures: &Summary) {
        for (figure, peak) in [
            (Figure::Rate, &figures.rate),
            (Figure::Torque, &figures.torque),
        ] {
            if let Some(peak) = peak.as_ref().filter(|peak| tenths(peak.value) != "0.0") {
                self.largest(figure, peak);
            }
        }
        if let Some(energy) = figures.energy {
            let value = tenths(energy.work_j);
            let work = match energy.cost_of_transport {
                Some(cost) => Running::WorkAndCost {
                    value,
                    cost: format!("{cost:.2}"),
                },
                None => Running::Work { value },
            };
            self.add(Figure::Energy, &work);
        }
    }

    fn largest(&mut self, figure: Figure, peak: &Peak) {
        let (value, unit, at) = (tenths(peak.value), peak.unit, peak.at);
        let of = peak.of.clone().unwrap_or_default().into();
        let (time, cycle, line) = (seconds(at.time_s * 1000.0), at.cycle.to_string(), at.line);
        let largest = match peak.limit {
            Some(limit) => Running::LargestOf {
                value,
                unit,
                limit: limit.to_string(),
                of,
                time,
                cycle,
                line,
            },
            None => Running::Largest {
                value,
                unit,
                of,
                time,
                cycle,
                line,
            },
        };
        self.add(figure, &largest);
    }

    fn waited(&mut self, wait: &WaitFigure) {
        let ([first, last], length) = (wait.lines, tenths(wait.length_s));
        let (time, cycle) = (seconds(wait.at.time_s * 1000.0), wait.at.cycle.to_string());
        let until = wait.until.clone().map(Message::from);
        let waited = match until {
            Some(until) if first == last => Running::WaitedAtFor {
                length,
                line: first,
                until,
                time,
                cycle,
            },
            Some(until) => Running::WaitedInFor {
                length,
                first,
                last,
                until,
                time,
                cycle,
            },
            None if first == last => Running::WaitedAt {
                length,
                line: first,
                time,
                cycle,
            },
            None => Running::WaitedIn {
                length,
                first,
                last,
                time,
                cycle,
            },
        };
        self.add(Figure::Waited, &waited);
    }

    /// Adds a line about collisions, if there were any.
    fn collisions(&mut self, run: &Run) {
        let Some((clearance, nearest)) = run.clearance().zip(run.nearest_approach()) else {
            return;
        };
        let [one, other] = nearest.gap.parts;
        let collisions = Running::Collisions {
            cycles: (clearance.collisions as usize).into(),
            by: tenths(-nearest.gap.distance),
            one,
            other,
            time: seconds(nearest.time),
            line: run.program().line(nearest.step),
        };
        self.counted(clearance.collisions, Figure::Gap, &collisions);
    }

    /// Adds a line about something that was counted, unless the count is 0.
    fn counted(&mut self, count: u32, figure: Figure, text: &Running) {
        if count > 0 {
            self.add(figure, text);
        }
    }

    /// Adds a line for each effect that the simulation leaves out and that would have mattered.
    fn unmodelled(&mut self, unmodelled: &Unmodelled) {
        let counts = [unmodelled.tips, unmodelled.slides, unmodelled.crossings];
        let [tips, slides, crosses] = counts.map(|count| Cycles::from(count as usize));
        let lines = [
            (
                Figure::Zmp,
                Running::ZmpOutside {
                    cycles: tips,
                    by: tenths(-unmodelled.least_zmp_margin),
                },
            ),
            (Figure::Grip, Running::NoGrip { cycles: slides }),
            (Figure::Contact, Running::Crosses { cycles: crosses }),
        ];
        for ((figure, text), count) in lines.into_iter().zip(counts) {
            self.counted(count, figure, &text);
        }
    }

    fn grasp(&mut self, grasp: &Grasp) {
        for (object, held) in (1..).zip(&grasp.objects) {
            let (now, most) = (tenths(held.clearance), tenths(held.highest));
            self.add(Figure::Lift, &Running::Lift { object, now, most });
        }
        for (finger, tip) in (1..).zip(&grasp.fingertips) {
            let (now, most) = (
                format!("{:.2}", tip.force()),
                format!("{:.2}", tip.greatest),
            );
            self.add(Figure::Force, &Running::Force { finger, now, most });
        }
    }
}

/// Returns the line about falls.
fn falls(motion: &Motion, first: Option<Fall>, run: &Run) -> Running {
    let Some(Fall { time, step, .. }) = first else {
        return Running::NoFall;
    };
    let count = motion.falls.to_string();
    let (time, line) = (seconds(time), run.program().line(step));
    match motion.upright_falls {
        0 => Running::Falls { count, time, line },
        upright if upright == motion.falls && motion.unmodelled.is_some() => {
            Running::WouldFall { count, time, line }
        }
        upright => Running::UprightFalls {
            count,
            upright: upright.to_string(),
            time,
            line,
        },
    }
}

/// Returns the status in one line: the time, the motion, and the wait or the next statement.
pub(super) fn status(run: &Run, wait: Option<&Wait>, source: &Source, lang: Lang) -> String {
    let program = run.program();
    let line = program.line(program.at());
    let mut text = format!("{} s", seconds(run.time()));
    // Writing to a String cannot fail.
    if let Some(motion) = run.motion() {
        let (y, along) = sense(motion.travel.y, Along::Forward, Along::Backward);
        let walks = Running::Walks {
            y,
            along,
            margin: tenths(motion.margin),
            falls: motion.falls.to_string(),
        };
        let _ = write!(text, " | {}", walks.in_lang(lang));
    }
    if let Some(grasp) = run.grasp() {
        for object in &grasp.objects {
            let value = tenths(object.clearance);
            let _ = write!(text, " | {}", Running::Lifts { value }.in_lang(lang));
        }
        let forces = grasp.fingertips.iter();
        let forces = forces.map(|tip| format!("{:.2}", tip.force()));
        let forces = forces.collect::<Vec<_>>().join(" ");
        let _ = write!(text, " | {}", Running::Pushes { forces }.in_lang(lang));
    }
    if let Some(wait) = wait {
        let _ = write!(text, " | {}", wait_message(wait).in_lang(lang));
        return text;
    }
    let statement = Printable::line(source.line_text(line).trim());
    let statement = statement.to_string().into();
    let next = Running::Next { line, statement };
    let _ = write!(text, " | {}", next.in_lang(lang));
    text
}

/// Returns the report of a fall, with its statement.
pub(super) fn fall(
    fall: &Fall,
    weight: &Weight,
    kind: FallKind,
    source: &Source,
    program: &Interpreter,
    lang: Lang,
) -> String {
    let (time, cycle) = (seconds(fall.time), fall.cycle.to_string());
    let fell = match kind {
        FallKind::Fell => Running::Fell { time, cycle },
        FallKind::WouldFall => Running::WouldHaveFallen { time, cycle },
        FallKind::LostSupport => Running::Unsupported { time, cycle },
    };
    let location = step_location(source, program.program(), fall.step);
    format!(
        "{}: {}\n{location}",
        weight.in_lang(lang),
        fell.in_lang(lang)
    )
}

/// Returns the report of a collision, with its statement.
pub(super) fn collision(
    found: &Approach,
    weight: &Weight,
    source: &Source,
    program: &Interpreter,
    lang: Lang,
) -> String {
    let [one, other] = found.gap.parts;
    let collided = Running::Collided {
        one,
        other,
        by: tenths(-found.gap.distance),
        time: seconds(found.time),
        cycle: found.cycle.to_string(),
    };
    let location = step_location(source, program.program(), found.step);
    format!(
        "{}: {}\n{location}",
        weight.in_lang(lang),
        collided.in_lang(lang)
    )
}

/// Returns the report of threads that wait for each other from the next cycle on, with the first WAIT_THREAD.
pub(super) fn wait_circle(
    found: &WaitCircle,
    run: &Run,
    source: &Source,
    program: &Interpreter,
    lang: Lang,
) -> String {
    let waits = found.threads.iter().map(|(thread, line)| {
        let (thread, line) = (thread.clone(), *line);
        let place = Running::InLine { thread, line };
        place.in_lang(lang).to_string()
    });
    let text = Running::WaitForEachOther {
        waits: waits.collect::<Vec<_>>().join(", ").into(),
        time: seconds(run.time()),
        cycle: run.cycles().to_string(),
    };
    let location = step_location(source, program.program(), found.step);
    format!(
        "{}: {}\n{location}",
        Weight::Warning.in_lang(lang),
        text.in_lang(lang)
    )
}

/// Formats a time, ms, in seconds.
pub(super) fn seconds(time: f64) -> String {
    format!("{:.3}", time / 1000.0)
}

/// Formats a value with one decimal, without -0.0.
pub(super) fn tenths(value: f64) -> String {
    fixed(value, 1)
}

/// Splits a value into its amount and its direction.
fn sense<W>(value: f64, positive: W, negative: W) -> (String, W) {
    let way = if tenths(value).starts_with('-') {
        negative
    } else {
        positive
    };
    (tenths(value.abs()), way)
}

/// Returns the condition that ends a step of several cycles.
fn until(action: &Action) -> Option<Until> {
    let (op, target) = match *action {
        Action::KeyIn { .. } => return Some(Until::Key),
        Action::Command { op, target, .. } => (op, target),
        _ => return None,
    };
    match op {
        Op::Sleep => Some(Until::Time),
        Op::WaitInpos => Some(Until::InPosition { target }),
        Op::WaitNear => Some(Until::Near { target }),
        Op::StandUp | Op::SitDown | Op::InitialPosture => Some(Until::Motion),
        Op::DetectFloor | Op::DetectObject => Some(Until::Touch),
        Op::Special => Some(Until::Native),
        _ => None,
    }
}

/// Returns the message about a wait.
pub(crate) fn wait_message(wait: &Wait) -> Waiting {
    let [first, last] = wait.lines;
    let [since, time] = [wait.since, wait.time].map(|time| tenths(time / 1000.0));
    match wait.on.clone() {
        Some(what) if first == last => Waiting::Line {
            line: first,
            what,
            since,
            time,
        },
        Some(what) => Waiting::Loop {
            first,
            last,
            what,
            since,
            time,
        },
        None if first == last => Waiting::Still {
            line: first,
            since,
            time,
        },
        None => Waiting::Endless {
            first,
            last,
            since,
            time,
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The sampling time is that in force, not that of the file; a time that is longer is no percentage.
    #[test]
    fn the_time_of_a_bus_is_compared_with_the_sampling_time_in_force() {
        let said = |busy, time| {
            let counts = Counts {
                cycles: 15,
                commanded: 10,
                busy,
                time,
                longest: 50_000,
                ..Counts::default()
            };
            let time = bus_time(18, &counts, 20.0);
            time.in_lang(Lang::English).to_string()
        };
        assert_eq!(
            said(380_000, 400_000),
            "18 servos, 38.00 ms of 40 ms in each cycle (95 %), 50.00 ms at most"
        );
        assert_eq!(
            said(412_000, 400_000),
            "18 servos, 41.20 ms in each cycle, longer than its 40 ms: cycles are late; 50.00 ms at most"
        );
    }

    #[test]
    fn nothing_is_less_than_nothing() {
        assert_eq!(tenths(-0.04), "0.0");
        assert_eq!(tenths(-0.06), "-0.1");
        let split = |value| {
            let (much, way) = sense(value, "up", "down");
            format!("{much} {way}")
        };
        assert_eq!(split(-0.04), "0.0 up");
        assert_eq!(split(-3.21), "3.2 down");
        assert_eq!(split(3.21), "3.2 up");
    }
}
