//! `tip drives record`: teaches a motion by hand. The torque is off; what is written is a program.

mod existing;
mod going;
mod mirror;
mod program;
mod thin;

use super::RobotArguments;
use super::robot::Connection;
use super::zero::{positions, relax};
use crate::error::Error;
use crate::message::{Driving, Using};
use crate::run::trial::trial;
use crate::serve::lesson::LessonPage;
use crate::serve::place::OWN;
use crate::{Status, input, interrupt, output, report};
use clap::Args;
use existing::{Existing, Place};
use going::{Gone, go};
use mirror::Mirror;
use program::{Limits, Motion, Pose};
use std::io::{self, IsTerminal, Write};
use std::net::SocketAddr;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use thin::Sample;
use tip_drives::bus::Wire;
use tip_drives::drives::{Failure, Problem};
use tip_drives::guard::Request;
use tip_lint::format::format;
use tip_runtime::command::Target;
use tip_runtime::realtime::Pacer;
use tip_runtime::record::AtomicFile;
use tip_sim::Robot;
use tip_view::live::{LessonPhase, LessonState};
use tipc::language::{Edition, names, reserved};
use tipc::message::Lang;
use tipc::message::list::List;

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip drives record robot.toml -o wave.prg                 pose by pose
  tip drives record robot.toml -o wave.prg --continuous    a motion as it is made
  tip drives record robot.toml -o walk.prg --at end        poses added to a program
  tip drives record robot.toml -o wave.prg --listen        with a page that shows the robot

The torque is off, from the first RETURN on: hold the robot. SPACE adds the pose in which it is, m its
mirror image; < and > choose a pose, n names it, d deletes it; q, ESC, Ctrl-C and a fault end and write
what there is. g moves the robot to the chosen pose and p through all, slowly and with torque: RETURN is
the emergency stop then, and r switches the torque off.
A pose counts if each servo gives two equal positions after the key, within the limits of the file.
With --continuous SPACE begins, and another one ends. The program is tried in simulation, and what goes
wrong there is said. `tip run wave.prg --hardware robot.toml` plays it.

Exit status: 0 if the program is written after q, ESC or SPACE, 130 after Ctrl-C, 3 after an emergency
stop, 1 if nothing was recorded or a fault of the bus ended it.")]
pub(crate) struct Record {
    #[command(flatten)]
    robot: RobotArguments,

    /// The program, or '-' for standard output
    #[arg(short, long, value_name = "PROGRAM|-")]
    out: PathBuf,

    /// Replace a program that exists
    #[arg(long)]
    force: bool,

    /// Add to a program, before a line or its END
    ///
    /// All other lines stay. The program is written only if it has no errors with the new lines; else these
    /// are printed
    #[arg(long, value_name = "LINE|end", value_parser = Place::parse, conflicts_with = "force")]
    at: Option<Place>,

    /// Record a motion instead of poses
    ///
    /// Each control cycle is measured, and as few set points are written as keep every joint within --error
    #[arg(long)]
    continuous: bool,

    /// Largest error of a joint, deg
    ///
    /// 0.2 to 45
    #[arg(long, value_name = "DEG", default_value = "1", value_parser = error, requires = "continuous")]
    error: f64,

    /// Show the robot on a page
    ///
    /// Without an address for this machine alone. Nobody teaches from the page; its emergency stop is for everybody who has
    /// the address. Port 0 selects a free one
    #[arg(long, value_name = "ADDRESS:PORT", num_args = 0..=1, default_missing_value = OWN)]
    listen: Option<SocketAddr>,
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
    let robot = Robot::described(&arguments.robot.description()?);
    // A motion that was taught must not be lost for a file that cannot be written.
    let destination = arguments.begin(&robot)?;
    let page = arguments.listen.map(LessonPage::at).transpose()?;
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
    let page = page.map(|open| {
        let stop = Arc::clone(&connection.robot().host_mut().stop);
        let name = arguments.out.file_name().unwrap_or_default();
        open(&robot, &name.to_string_lossy(), stop, lang)
    });
    report::say(
        match arguments.continuous {
            true => Driving::RecordMotionHow,
            false => Driving::RecordHow,
        },
        lang,
    );
    let existing = match &destination {
        Destination::Existing(existing) => Some(&**existing),
        Destination::New(_) => None,
    };
    let mut recording = Recording {
        page,
        existing,
        is_continuous: arguments.continuous,
        ..Recording::new(&connection, &robot, lang)
    };
    let ended = recording.until_the_end();
    connection.keyboard();
    // What was taught is kept, whatever ended it.
    interrupt::hold();
    let Recording { poses, samples, .. } = recording;
    let status = arguments.keep(&connection, &robot, &poses, &samples, destination)?;
    match ended? {
        Some(stopped) => Ok(stopped),
        None if interrupt::is_requested() => Ok(Status::Interrupted),
        None => Ok(status),
    }
}

/// The place to which the program is written.
#[derive(Debug)]
enum Destination {
    /// A new file; `None` for standard output.
    New(Option<AtomicFile>),
    Existing(Box<Existing>),
}

impl Record {
    /// Begins the file of the program, or reads the one that exists.
    fn begin(&self, robot: &Robot) -> Result<Destination, Error> {
        let (out, lang) = (&self.out, self.robot.lang());
        if let Some(place) = self.at {
            if input::is_stream(out) {
                return Err(Error::usage(Using::RecordAtStream, lang));
            }
            let options = self.robot.output_options();
            let existing = Existing::read(out, place, robot, options)?;
            // It is written at the end; here it is only tried.
            output::begin(out).map_err(|error| Error::cannot_write(out, error))?;
            return Ok(Destination::Existing(Box::new(existing)));
        }
        if input::is_stream(out) {
            return Ok(Destination::New(None));
        }
        output::refuse_same(out, &[&self.robot.file])?;
        if out.exists() && !self.force {
            let file = output::name(out).into();
            return Err(Error::failed(Driving::RecordTaken { file }, lang));
        }
        let file = output::begin(out).map_err(|error| Error::cannot_write(out, error))?;
        interrupt::discards(file.part());
        Ok(Destination::New(Some(file)))
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
        poses: &[Pose],
        samples: &[Sample],
        destination: Destination,
    ) -> Result<Status, Error> {
        if poses.is_empty() && samples.is_empty() {
            return self.nothing();
        }
        let options = self.robot.output_options();
        let limits = limits(connection, robot);
        let Motion {
            mut text,
            points,
            fastest,
        } = match self.continuous {
            true => limits.motion(samples, self.error),
            false => limits.poses(poses),
        };
        if let Destination::Existing(_) = destination {
            text = limits.with_standards(&text);
        }
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
        let (file, lang) = (name.into(), self.robot.lang());
        let (written, lost, said) = match destination {
            Destination::New(None) => {
                output::print(&text)?;
                (Ok(()), text, None)
            }
            // Somebody has written the file meanwhile.
            Destination::New(Some(_)) if self.out.exists() && !self.force => {
                let taken = Error::failed(Driving::RecordTaken { file }, lang);
                (Err(taken), text, None)
            }
            Destination::New(Some(mut out)) => {
                let written = out.write_all(&text).and_then(|()| out.commit());
                let written = written.map_err(|error| Error::cannot_write(&self.out, error));
                (written, text, Some(Driving::Recorded { file, points }))
            }
            Destination::Existing(existing) => {
                let lines = existing.lines(&String::from_utf8_lossy(&text));
                let (whole, read) = (existing.with(&lines), existing.bytes());
                loaded = tip_lint::load(existing.name(), &whole, &robot.options());
                robot.warn(&mut loaded);
                let written = match loaded.program.is_some() {
                    true => output::update(&self.out, &read, &whole, lang),
                    false => Ok(output::print(&lines)?),
                };
                let said = Driving::RecordedLines { file, points };
                (written, lines.into_bytes(), Some(said))
            }
        };
        if let Err(error) = written {
            output::print(&lost)?;
            return Err(error);
        }
        // It has too many lines, for example.
        if loaded.program.is_none() {
            return Err(Error::Refused(Box::new(loaded), options));
        }
        said.map_or(Ok(()), |said| output::say(said, lang))?;
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
        standards: robot.description().standards,
    }
}

/// The end of a lesson, with the status of the command if the robot was stopped.
struct Ended(Option<Status>);

/// The longest name of a pose: the names of its variables end with `_F1`, for example.
const NAME_LIMIT: usize = names::LIMIT - 3;

/// The byte at which a terminal rings.
const BELL: &[u8] = b"\x07";

/// Bytes of keys that delete a character.
const BACKSPACE: u8 = 0x08;
const DELETE: u8 = 0x7F;

/// A motion while it is taught.
struct Recording<'a> {
    connection: &'a Connection,
    mirror: Result<Mirror, usize>,
    /// The program to which the poses are added.
    existing: Option<&'a Existing>,
    lang: Lang,
    /// True for a motion, false for poses.
    is_continuous: bool,
    samples: Vec<Sample>,
    poses: Vec<Pose>,
    /// The place of the chosen pose.
    chosen: usize,
    /// The part of its new name that was typed; `None` while no name is asked for.
    naming: Option<String>,
    /// Time in which the robot had torque, ms. It does not count as time between two poses.
    moved: f64,
    /// Time from which on answers belong to the next sample of a motion, µs; `None` while none is recorded.
    sampled: Option<u64>,
    /// True while a joint is outside of its limits.
    is_outside: bool,
    /// The pose that is shown, and since when, µs.
    shown: String,
    shown_at: u64,
    /// The page that shows the robot.
    page: Option<LessonPage>,
    /// The last failure of the robot, until a cycle without one.
    failure: Option<Failure>,
    /// Servos that are simulated keep real time by it.
    pacer: Pacer,
}

impl<'a> Recording<'a> {
    fn new(connection: &'a Connection, robot: &Robot, lang: Lang) -> Self {
        Recording {
            connection,
            mirror: Mirror::of(&robot.description()),
            existing: None,
            lang,
            is_continuous: false,
            samples: vec![],
            poses: vec![],
            chosen: 0,
            naming: None,
            moved: 0.0,
            sampled: None,
            is_outside: false,
            shown: String::new(),
            shown_at: 0,
            page: None,
            failure: None,
            pacer: Pacer::start(),
        }
    }

    /// Follows the keys until one of them, a signal or a fault of the bus ends it; returns the status with which the command ends
    /// if the robot was stopped on its way to a pose.
    fn until_the_end(&mut self) -> Result<Option<Status>, Error> {
        let ended = loop {
            // The stop of a page stops nothing: there is no torque.
            let order = Ordering::Relaxed;
            self.connection.robot().host_mut().stop.store(false, order);
            self.connection.pace(&mut self.pacer);
            self.failure = self.connection.measure().err();
            if let Some(failure) = self.failure {
                if matches!(failure.problem, Problem::Port | Problem::Alarm(_)) {
                    break Err(self.connection.failed(failure));
                }
                // A servo that is silent for a while, or hot, endangers nothing. Its pose is not taken while it does not answer.
                self.connection.robot().drives_mut().clear_failure();
            }
            self.sample();
            self.show();
            self.show_page(LessonPhase::Limp, self.chosen);
            let request = self.connection.request();
            if request == Some(Request::End) {
                break Ok(None);
            }
            match self.keys() {
                Ok(None) => {}
                Ok(Some(Ended(status))) => break Ok(status),
                Err(error) => break Err(error),
            }
            // RETURN stops nothing: there is no torque.
            if request == Some(Request::EmergencyStop) {
                self.rename();
            }
        };
        self.end_line();
        ended
    }

    /// Obeys the keys that were typed; returns the end of the lesson if one of them ends it.
    fn keys(&mut self) -> Result<Option<Ended>, Error> {
        while let Some(key) = self.connection.key() {
            if let Some(name) = &mut self.naming {
                match key {
                    BACKSPACE | DELETE => drop(name.pop()),
                    b'0'..=b'9' | b'A'..=b'Z' | b'a'..=b'z' | b'_' if name.len() < NAME_LIMIT => {
                        name.push(char::from(key.to_ascii_uppercase()));
                    }
                    // The bytes of a character after its first one.
                    0x80..=0xBF => {}
                    _ => {
                        self.end_line();
                        let _ = io::stderr().write_all(BELL);
                        self.say(Driving::NotInAName { most: NAME_LIMIT });
                    }
                }
                continue;
            }
            match key {
                b'q' => return Ok(Some(Ended(None))),
                b' ' if self.is_continuous && self.sampled.is_some() => {
                    return Ok(Some(Ended(None)));
                }
                b' ' if self.is_continuous => {
                    self.sampled = Some(self.now());
                    self.say(Driving::RecordBegun);
                }
                b' ' => self.add(None)?,
                _ if self.is_continuous => {}
                b'm' => self.add_image()?,
                b'd' => self.delete(),
                b'<' | b',' => self.choose(self.chosen.saturating_sub(1)),
                b'>' | b'.' => self.choose(self.chosen + 1),
                b'n' if self.poses.is_empty() => self.say(Driving::NoPose),
                b'n' => {
                    self.end_line();
                    self.naming = Some(String::new());
                }
                b'g' | b'p' => {
                    if let Some(ended) = self.go(key == b'p')? {
                        return Ok(Some(ended));
                    }
                }
                _ => {}
            }
        }
        Ok(None)
    }

    /// Moves the robot to the chosen pose, or through all; returns the end of the lesson if it was stopped.
    fn go(&mut self, is_all: bool) -> Result<Option<Ended>, Error> {
        let ways = match is_all {
            true => &self.poses[..],
            false => &self.poses[self.chosen..][..self.poses.len().min(1)],
        };
        let ways: Vec<Vec<f64>> = ways.iter().map(|it| it.sample.angles.clone()).collect();
        if ways.is_empty() {
            self.say(Driving::NoPose);
            return Ok(None);
        }
        let begun = self.now();
        self.end_line();
        let first = if is_all { 0 } else { self.chosen };
        let (connection, lang) = (self.connection, self.lang);
        self.failure = None;
        let gone = go(connection, &ways, lang, &mut |phase, place| {
            connection.pace(&mut self.pacer);
            self.show_page(phase, first + place);
        })?;
        self.moved += (self.now() - begun) as f64 / 1000.0;
        Ok(match gone {
            Gone::Left(status) => Some(Ended(status)),
            Gone::Limp => {
                self.say(Driving::RecordLimp);
                None
            }
        })
    }

    /// Shows the robot on the page, if there is one, with the pose that its state is about.
    fn show_page(&mut self, phase: LessonPhase, chosen: usize) {
        let Some(page) = &mut self.page else { return };
        let (connection, failure) = (self.connection, self.failure);
        page.show(|| {
            let state = LessonState {
                phase,
                poses: self.poses.iter().map(|pose| pose.name.clone()).collect(),
                chosen,
                samples: self.is_continuous.then_some(self.samples.len()),
                servos: connection.servos(failure),
                problem: failure.map(|failure| connection.explain(failure)),
            };
            (connection.angles(), state)
        });
    }

    /// Chooses a pose, if there is one at this place.
    fn choose(&mut self, place: usize) {
        let last = self.poses.len().saturating_sub(1);
        self.chosen = place.min(last);
        let number = self.chosen + 1;
        let name = self.poses.get(self.chosen).map(|pose| pose.name.clone());
        self.say(name.map_or(Driving::NoPose, |name| Driving::PoseChosen { number, name }));
    }

    /// Gives the chosen pose the name that was typed.
    fn rename(&mut self) {
        let Some(name) = self.naming.take() else {
            return;
        };
        if name.is_empty() {
            return self.choose(self.chosen);
        }
        let is_own = self.poses[self.chosen].name == name;
        if !is_own && !self.is_free(&name) {
            let most = NAME_LIMIT;
            return self.say(Driving::NotAPoseName { name, most });
        }
        self.poses[self.chosen].name = name;
        self.choose(self.chosen);
    }

    /// Returns true if a pose can have a name: its variables are words that nothing else has.
    fn is_free(&self, name: &str) -> bool {
        let legs = 1..=self.connection.setup.joints.len() / self.connection.setup.of_leg;
        let mut variables = legs.map(|leg| Pose::variable(name, leg));
        !self.poses.iter().any(|pose| pose.name == name)
            && variables.all(|variable| {
                names::is_variable(&variable)
                    && variable.len() <= names::LIMIT
                    && !reserved::is_reserved(&variable, Edition::V3_2)
                    && !self.existing.is_some_and(|it| it.has(&variable))
            })
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
        let time = self.now() as f64 / 1000.0 - self.moved;
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
        let mut numbers = self.poses.len() + 1..;
        let name = numbers.find_map(|number| {
            let name = format!("POSE{number}");
            self.is_free(&name).then_some(name)
        });
        self.poses.push(Pose {
            name: name.unwrap_or_default(),
            sample: Sample { time, angles },
        });
        let number = self.poses.len();
        self.chosen = number - 1;
        self.say(Driving::PoseAdded { number });
        let angles = &self.poses[number - 1].sample.angles;
        if let Some(gap) = self.connection.setup.distances.overlap(angles) {
            let ([one, other], by) = (gap.parts, format!("{:.1}", -gap.distance));
            self.say(Driving::PoseCollides {
                number,
                one,
                other,
                by,
            });
        }
        Ok(())
    }

    /// Deletes the chosen pose, and chooses the one before it.
    fn delete(&mut self) {
        if self.poses.is_empty() {
            return self.say(Driving::NoPose);
        }
        self.poses.remove(self.chosen);
        let number = self.chosen + 1;
        self.chosen = self.chosen.saturating_sub(1);
        self.say(Driving::PoseDeleted { number });
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
            None => self.samples.push(Sample {
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
        if let Some(name) = &self.naming {
            let asked = Driving::PoseNameAsked {
                number: self.chosen + 1,
            };
            // The blanks overwrite the end of a longer name that was shown before.
            let width = NAME_LIMIT + 1;
            return format!("{}: {name:width$}", asked.in_lang(self.lang));
        }
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
        let taken = self.poses.len() + self.samples.len();
        format!("{taken:2}:{}", legs.join("|"))
    }
}
