//! `tip drives record`: teaches a motion by hand. The torque is off; what is written is a program.

mod mirror;
mod program;
mod thin;

use super::RobotArguments;
use super::robot::Connection;
use super::zero::{positions, relax};
use crate::error::Error;
use crate::message::{Driving, Using};
use crate::run::trial::trial;
use crate::{Status, input, interrupt, output, report};
use clap::Args;
use mirror::Mirror;
use program::{Limits, Motion};
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use thin::Sample;
use tip_drives::bus::Wire;
use tip_drives::drives::{Failure, Problem};
use tip_drives::guard::Request;
use tip_lint::format::format;
use tip_runtime::command::Target;
use tip_runtime::record::AtomicFile;
use tip_sim::Robot;
use tipc::message::Lang;
use tipc::message::list::List;

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip drives record robot.toml -o wave.prg                 pose by pose
  tip drives record robot.toml -o wave.prg --continuous    a motion as it is made

The torque is off, from the first RETURN to the end: hold the robot. SPACE adds the pose in which it is,
m its mirror image; d deletes the last one; q, ESC, Ctrl-C and a fault end and write what there is.
A pose counts if each servo gives two equal positions after the key, within the limits of the file.
With --continuous SPACE begins, and another one ends. The program is tried in simulation, and what goes
wrong there is said. `tip run wave.prg --hardware robot.toml` plays it.

Exit status: 0 if the program is written after q, ESC or SPACE, 130 after Ctrl-C, 1 if nothing was
recorded or a fault of the bus ended it.")]
pub(crate) struct Record {
    #[command(flatten)]
    robot: RobotArguments,

    /// The program, or '-' for standard output
    #[arg(short, long, value_name = "PROGRAM|-")]
    out: PathBuf,

    /// Replace a program that exists
    #[arg(long)]
    force: bool,

    /// Record a motion instead of poses
    ///
    /// Each control cycle is measured, and as few set points are written as keep every joint within --error
    #[arg(long)]
    continuous: bool,

    /// The error of a motion at each joint, deg
    ///
    /// 0.2 to 45
    #[arg(long, value_name = "DEG", default_value = "1", value_parser = error, requires = "continuous")]
    error: f64,
}

/// Parses the error of a motion.
fn error(text: &str) -> Result<f64, Using> {
    // A tenth of a degree is what a program is rounded to.
    let number = text.parse().ok().filter(|it| (0.2..=45.0).contains(it));
    number.ok_or_else(|| Using::RecordError {
        text: text.to_owned(),
    })
}

/// Time between two lines of the pose, µs.
const SHOWN_EVERY: u64 = 100_000;

pub(super) fn record(arguments: &Record) -> Result<Status, Error> {
    interrupt::catch();
    let lang = arguments.robot.lang();
    if !io::stdin().is_terminal() {
        return Err(Error::failed(Driving::OnlyOnTerminal, lang));
    }
    // A motion that was taught must not be lost for a file that cannot be written.
    let file = arguments.begin()?;
    let robot = Robot::described(&arguments.robot.description()?);
    let connection = arguments.robot.connect_to_measure()?;
    let stiff = connection.robot().drives_mut().stiff();
    let question = match stiff.is_empty() {
        true => Driving::RecordFree,
        false => Driving::ZeroReleases {
            joints: List(connection.setup.names(&stiff)),
        },
    };
    input::forget_typed();
    report::complain(&format!("{}: ", question.in_lang(lang)));
    if !input::is_confirmed()? {
        return arguments.nothing();
    }
    relax(&connection, lang)?;
    report::say(
        match arguments.continuous {
            true => Driving::RecordMotionHow,
            false => Driving::RecordHow,
        },
        lang,
    );
    let mut recording = Recording::new(&connection, &robot, arguments.continuous, lang);
    let failed = recording.until_the_end().err();
    connection.keyboard();
    // What was taught is kept, whatever ended it.
    interrupt::hold();
    let status = arguments.keep(&connection, &robot, &recording.taken, file)?;
    match failed {
        _ if interrupt::is_requested() => Ok(Status::Interrupted),
        Some(error) => Err(error),
        None => Ok(status),
    }
}

impl Record {
    /// Begins the file of the program; `None` for standard output.
    fn begin(&self) -> Result<Option<AtomicFile>, Error> {
        let (out, lang) = (&self.out, self.robot.lang());
        if input::is_stream(out) {
            return Ok(None);
        }
        output::refuse_inputs(out, &[&self.robot.file])?;
        if out.exists() && !self.force {
            let file = output::name(out).into();
            return Err(Error::failed(Driving::RecordTaken { file }, lang));
        }
        let file = output::begin(out).map_err(|error| Error::cannot_write(out, error))?;
        interrupt::discards(file.part());
        Ok(Some(file))
    }

    /// Says that there is nothing to write.
    fn nothing(&self) -> Result<Status, Error> {
        let file = output::name(&self.out).into();
        report::say(Driving::RecordNothing { file }, self.robot.lang());
        Ok(match interrupt::is_requested() {
            true => Status::Interrupted,
            false => Status::Failure,
        })
    }

    /// Writes what was taught as a program, after a trial in simulation.
    fn keep(
        &self,
        connection: &Connection,
        robot: &Robot,
        taken: &[Sample],
        file: Option<AtomicFile>,
    ) -> Result<Status, Error> {
        if taken.is_empty() {
            return self.nothing();
        }
        let options = self.robot.output_options();
        let limits = limits(connection, robot);
        let Motion {
            text,
            points,
            fastest,
        } = match self.continuous {
            true => limits.motion(taken, self.error),
            false => limits.poses(taken),
        };
        if let Some((place, speed)) = fastest {
            let joint = connection.setup.name(place);
            let (speed, most) = (format!("{speed:.0}"), limits.speeds[place]);
            report::say(
                Driving::RecordFast { joint, speed, most },
                self.robot.lang(),
            );
        }
        let name = output::name(&self.out);
        let text = format(&name, text.as_bytes(), &robot.options()).unwrap_or(text.into_bytes());
        let mut loaded = tip_lint::load(&name, &text, &robot.options());
        robot.warn(&mut loaded);
        if let Some(program) = &loaded.program {
            report::diagnostics(&loaded, options);
            let trial = trial(&loaded, program, robot, options);
            if !trial.is_empty() {
                report::say(Driving::RecordTried, self.robot.lang());
                report::write_stderr(&trial);
            }
        }
        let is_file = file.is_some();
        match file {
            None => output::print(&text)?,
            Some(mut file) => {
                let written = file.write_all(&text).and_then(|()| file.commit());
                if let Err(error) = written {
                    output::print(&text)?;
                    return Err(Error::cannot_write(&self.out, error));
                }
            }
        }
        // It has too many lines, for example.
        if loaded.program.is_none() {
            return Err(Error::Refused(Box::new(loaded), options));
        }
        if is_file {
            let (file, poses) = (name.into(), points);
            output::say(Driving::Recorded { file, poses }, self.robot.lang())?;
        }
        Ok(Status::Success)
    }
}

/// Returns what a program has to know of a robot.
fn limits(connection: &Connection, robot: &Robot) -> Limits {
    let setup = &connection.setup;
    let speeds: Vec<f64> = setup.joints.iter().map(|joint| joint.speed).collect();
    Limits {
        of_leg: setup.of_leg,
        joints: setup.joints.iter().map(|joint| joint.limits).collect(),
        period: setup.period,
        slow: speeds.iter().copied().fold(setup.bus.start, f64::min),
        speeds,
        acceleration: robot.anatomy().standards.omega_dot_max,
    }
}

/// A motion while it is taught.
struct Recording<'a> {
    connection: &'a Connection,
    mirror: Result<Mirror, usize>,
    lang: Lang,
    /// True for a motion, false for poses.
    is_continuous: bool,
    taken: Vec<Sample>,
    /// Time from which on answers belong to the next sample of a motion, µs; `None` while none is recorded.
    sampled: Option<u64>,
    /// True while a joint is outside of its limits.
    is_outside: bool,
    /// The pose that is shown, and since when, µs.
    shown: String,
    shown_at: u64,
}

impl<'a> Recording<'a> {
    fn new(connection: &'a Connection, robot: &Robot, is_continuous: bool, lang: Lang) -> Self {
        Recording {
            connection,
            mirror: Mirror::of(&robot.anatomy()),
            lang,
            is_continuous,
            taken: vec![],
            sampled: None,
            is_outside: false,
            shown: String::new(),
            shown_at: 0,
        }
    }

    /// Follows the keys until one of them, a signal or a fault of the bus ends it.
    fn until_the_end(&mut self) -> Result<(), Error> {
        let ended = loop {
            if let Err(failure) = self.connection.measure() {
                if matches!(failure.problem, Problem::Port | Problem::Alarm(_)) {
                    break Err(self.connection.failed(failure));
                }
                // A servo that is silent for a while, or hot, endangers nothing. Its pose is not taken while it does not answer.
                self.connection.robot().drives_mut().clear_failure();
            }
            self.sample();
            self.show();
            // RETURN stops nothing: there is no torque.
            if self.connection.request() == Some(Request::End) {
                break Ok(());
            }
            match self.keys() {
                Ok(true) => {}
                Ok(false) => break Ok(()),
                Err(error) => break Err(error),
            }
        };
        self.end_line();
        ended
    }

    /// Obeys the keys that were typed; returns false if one of them ends the lesson.
    fn keys(&mut self) -> Result<bool, Error> {
        while let Some(key) = self.connection.key() {
            match key {
                b'q' => return Ok(false),
                b' ' if self.is_continuous && self.sampled.is_some() => return Ok(false),
                b' ' if self.is_continuous => {
                    self.sampled = Some(self.now());
                    self.say(Driving::RecordBegun);
                }
                b' ' => self.add(None)?,
                b'm' if !self.is_continuous => self.add_image()?,
                b'd' if !self.is_continuous => self.delete(),
                _ => {}
            }
        }
        Ok(true)
    }

    fn now(&self) -> u64 {
        self.connection.robot().drives_mut().bus_mut().now()
    }

    /// Ends the line of the pose, if it is shown.
    fn end_line(&mut self) {
        if !std::mem::take(&mut self.shown).is_empty() {
            report::complain("\n");
        }
    }

    /// Writes a message below the line of the pose.
    fn say(&mut self, message: Driving) {
        self.end_line();
        report::say(message, self.lang);
    }

    /// Adds the mirror image of the pose in which the robot is.
    fn add_image(&mut self) -> Result<(), Error> {
        match self.mirror.clone() {
            Ok(mirror) => self.add(Some(&mirror)),
            Err(leg) => {
                let leg = Target::Foot(leg as u8 + 1).to_string();
                self.say(Driving::NoMirror { leg });
                Ok(())
            }
        }
    }

    /// Adds the pose in which the robot is, or its image, unless a servo gives no two equal positions after the key, or a joint is
    /// outside of its limits.
    fn add(&mut self, mirror: Option<&Mirror>) -> Result<(), Error> {
        let setup = &self.connection.setup;
        let joints: Vec<usize> = (0..setup.joints.len()).collect();
        let time = self.now() as f64 / 1000.0;
        self.end_line();
        let Some(found) = positions(self.connection, &joints, self.lang)? else {
            return Ok(());
        };
        let angles = setup.joints.iter().zip(found);
        let mut angles: Vec<f64> = angles.map(|(joint, counts)| joint.angle(counts)).collect();
        if let Some(failure) = self.outside(&angles) {
            self.complain(failure);
            return Ok(());
        }
        if let Some(mirror) = mirror {
            angles = mirror.image(&angles);
            if let Some(Failure {
                joint: Some(place), ..
            }) = self.outside(&angles)
            {
                let limits = setup.joints[place].limits;
                let (joint, angle) = (setup.name(place), format!("{:.1}", angles[place]));
                let (min, max) = (limits.min, limits.max);
                self.say(Driving::ImageOutside {
                    joint,
                    angle,
                    min,
                    max,
                });
                return Ok(());
            }
        }
        self.taken.push(Sample { time, angles });
        let number = self.taken.len();
        self.say(Driving::PoseAdded { number });
        Ok(())
    }

    fn delete(&mut self) {
        let number = self.taken.len();
        let deleted = self.taken.pop();
        self.say(deleted.map_or(Driving::NoPose, |_| Driving::PoseDeleted { number }));
    }

    /// Returns the first joint that is outside of its limits.
    fn outside(&self, angles: &[f64]) -> Option<Failure> {
        let mut joints = self.connection.setup.joints.iter().zip(angles).enumerate();
        let (number, (joint, angle)) = joints.find(|(_, (joint, angle))| {
            // Rounded to what is written.
            let tenths = (*angle * 10.0).round() / 10.0;
            !joint.limits.contains(tenths)
        })?;
        Some(Failure {
            joint: Some(number),
            servo: Some(joint.id),
            problem: Problem::Outside(*angle),
        })
    }

    fn complain(&mut self, failure: Failure) {
        self.end_line();
        report::complain(&format!("{}\n", self.connection.explain(failure)));
    }

    /// Takes a sample of a motion if each servo has answered since the last one, and each joint is within its limits.
    fn sample(&mut self) {
        let Some(since) = self.sampled else { return };
        if !self.connection.robot().drives().is_measured_since(since) {
            return;
        }
        let (now, angles) = (self.now(), self.connection.angles());
        self.sampled = Some(now);
        let outside = self.outside(&angles);
        let was_outside = std::mem::replace(&mut self.is_outside, outside.is_some());
        match outside {
            None => self.taken.push(Sample {
                time: now as f64 / 1000.0,
                angles,
            }),
            Some(failure) if !was_outside => self.complain(failure),
            Some(_) => {}
        }
    }

    /// Shows the pose in one line, leg by leg, if it has changed.
    fn show(&mut self) {
        let now = self.now();
        if now < self.shown_at + SHOWN_EVERY && self.shown_at > 0 {
            return;
        }
        let line = self.line();
        if line != self.shown {
            // Nobody may read it, and nothing is lost then.
            let _ = io::stderr().write_all(format!("\r{line}").as_bytes());
            self.shown = line;
        }
        self.shown_at = now;
    }

    /// Returns the line of the pose, in whole degrees, which 18 joints fit into 80 columns; `?` for a servo that has not answered for too long.
    fn line(&self) -> String {
        let setup = &self.connection.setup;
        let robot = self.connection.robot();
        let drives = robot.drives();
        let angle = |joint: usize| {
            let is_old = drives.age(joint).is_none_or(|age| age > setup.bus.silence);
            match drives.angle(joint).filter(|_| !is_old) {
                Some(angle) => format!("{:4.0}", angle.round() + 0.0),
                None => "   ?".to_owned(),
            }
        };
        let joints: Vec<String> = (0..setup.joints.len()).map(angle).collect();
        let legs: Vec<String> = joints
            .chunks(setup.of_leg)
            .map(|leg| leg.concat())
            .collect();
        format!("{:2}:{}", self.taken.len(), legs.join("|"))
    }
}
