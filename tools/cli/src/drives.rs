//! `tip drives`: finds, names, zeroes, moves and watches the servos of a real robot.

mod port;
pub(crate) mod realtime;
pub(crate) mod robot;
mod simulated;

use crate::choices::LangName;
use crate::error::Error;
use crate::input;
use crate::message::Driving;
use crate::{Status, choices, interrupt, output, report};
use clap::{Args, Subcommand};
use port::{AnyPort, open_serial};
use robot::{Connection, Setup};
use simulated::Mishaps;
use std::fmt::Write as _;
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use tip_drives::bus::{Bus, BusError, Timing, Wire};
use tip_drives::family::{self, FAMILIES, Family, Query, Reading};
use tip_drives::guard::{Request, Step};
use tip_drives::model::Model;
use tipc::message::Lang;
use tipc::{description, embed};

/// The commands of `tip drives`.
#[derive(Debug, Subcommand)]
pub(crate) enum DrivesVerb {
    /// List the servos that answer on a bus
    Scan(Scan),
    /// Give a servo another identity
    Id(Id),
    /// Find sign and offset of each joint by turning it by hand
    Zero(Zero),
    /// Turn one joint by keys
    Jog(Jog),
    /// Show angle, load, voltage and temperature of each joint
    Monitor(Monitor),
    /// Simulate the servos of a robot on a pseudo-terminal
    Simulate(Simulate),
}

/// Reads the name of a family.
fn family(name: &str) -> Result<&'static dyn Family, String> {
    family::named(name).ok_or_else(|| {
        let known: Vec<&str> = FAMILIES.iter().map(|family| family.key()).collect();
        format!("one of {}", known.join(", "))
    })
}

/// A port without a robot.
#[derive(Debug, Args)]
struct PortArguments {
    /// The serial port
    #[arg(long, value_name = "PORT")]
    port: String,

    /// The speed of the bus, bit/s
    #[arg(long, default_value_t = 1_000_000, value_parser = clap::value_parser!(u32).range(9600..=4_500_000))]
    baud: u32,

    /// The delay of adapter and driver, ms
    #[arg(long, value_name = "MS", default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..=1000))]
    latency: u32,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

impl PortArguments {
    fn lang(&self) -> Lang {
        choices::lang(self.lang)
    }

    fn bus(&self) -> Result<Bus<AnyPort>, Error> {
        let port = open_serial(&self.port, self.baud, self.lang())?;
        let timing = Timing {
            baud: self.baud,
            return_delay: 500,
            latency: self.latency * 1000,
        };
        Ok(Bus::new(port, timing))
    }
}

/// A robot whose description has a bus.
#[derive(Debug, Args)]
struct RobotArguments {
    /// The robot, described with [bus] and [[drive]]
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,

    /// The serial port, or 'simulated'
    ///
    /// By default that of the description
    #[arg(long, value_name = "PORT")]
    port: Option<String>,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

impl RobotArguments {
    fn lang(&self) -> Lang {
        choices::lang(self.lang)
    }

    fn setup(&self) -> Result<Setup, Error> {
        let options = choices::OutputOptions::of(LangName::of(self.lang()));
        let description = input::describe(&self.file).map_err(Error::refused(options))?;
        Setup::new(&self.file, &description, self.lang())
    }

    fn connect(&self) -> Result<Connection, Error> {
        self.open(self.setup()?)
    }

    fn open(&self, setup: Setup) -> Result<Connection, Error> {
        let mut connection = setup.open(&self.file, self.port.as_deref(), self.lang())?;
        connection.connect(false)?;
        Ok(connection)
    }
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip drives scan --port /dev/ttyUSB0                 all families, at 1 Mbaud
  tip drives scan --port /dev/ttyUSB0 --family x --baud 57600

Exit status: 0 if a servo answers, 1 otherwise.")]
pub(crate) struct Scan {
    #[command(flatten)]
    port: PortArguments,

    /// The servos' family: ax, x, sts, lx or moteus; else all are tried
    #[arg(long, value_parser = family)]
    family: Option<&'static dyn Family>,

    /// The largest identity that is tried
    #[arg(long, default_value_t = 252, value_parser = clap::value_parser!(u8).range(0..=252))]
    to: u8,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  tip drives id 1 12 --family sts --port /dev/ttyACM0   new servos have the identity 1: name one at a time

Exit status: 0 if the servo answers with its new identity, 1 otherwise.")]
pub(crate) struct Id {
    /// The identity that the servo has
    #[arg(value_parser = clap::value_parser!(u8).range(0..=252))]
    from: u8,

    /// Its new one
    #[arg(value_parser = clap::value_parser!(u8).range(0..=252))]
    to: u8,

    /// The family of the servo: ax, x, sts, lx or moteus
    #[arg(long, value_parser = family)]
    family: &'static dyn Family,

    #[command(flatten)]
    port: PortArguments,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  tip drives zero robot.toml            print sign and offset of each [[drive]]
  tip drives zero robot.toml --write    write them into the file

Exit status: 0, or 1 if a servo does not answer.")]
pub(crate) struct Zero {
    #[command(flatten)]
    robot: RobotArguments,

    /// Write the results into the description
    ///
    /// Only these two keys change: comments and order stay
    #[arg(long)]
    write: bool,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  tip drives jog robot.toml J11

Exit status: 0, 3 if the robot was stopped, 1 if it cannot start.")]
pub(crate) struct Jog {
    #[command(flatten)]
    robot: RobotArguments,

    /// The joint: J11 to J99
    joint: String,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip drives monitor robot.toml            until Ctrl-C
  tip drives monitor robot.toml --once     one table

Exit status: 0 with --once, 130 after Ctrl-C, 1 if a servo does not answer.")]
pub(crate) struct Monitor {
    #[command(flatten)]
    robot: RobotArguments,

    /// Print one table and end
    #[arg(long)]
    once: bool,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip drives simulate robot.toml                                 prints the name of a port
  tip drives simulate robot.toml --mishaps faults=0.01,unplug=7@20

Exit status: 130 after Ctrl-C, 1 if it cannot start.")]
pub(crate) struct Simulate {
    /// The robot, described with [bus] and [[drive]]
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,

    /// Faults to inject, separated by commas
    ///
    /// faults, corrupt, drop, duplicate, delay or truncate=PROBABILITY of an answer;
    /// unplug, reset, overheat, block or sag=ID@SECONDS
    #[arg(long, value_name = "LIST", default_value = "")]
    mishaps: String,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

pub(crate) fn drives(verb: &DrivesVerb) -> Result<Status, Error> {
    match verb {
        DrivesVerb::Scan(arguments) => scan(arguments),
        DrivesVerb::Id(arguments) => id(arguments),
        DrivesVerb::Zero(arguments) => zero(arguments),
        DrivesVerb::Jog(arguments) => jog(arguments),
        DrivesVerb::Monitor(arguments) => monitor(arguments),
        DrivesVerb::Simulate(arguments) => simulate(arguments),
    }
}

fn scan(arguments: &Scan) -> Result<Status, Error> {
    let lang = arguments.port.lang();
    let families = arguments
        .family
        .as_ref()
        .map_or(&FAMILIES[..], std::slice::from_ref);
    let (mut text, mut count) = (String::new(), 0);
    for family in families.iter().copied() {
        let mut bus = arguments.port.bus()?;
        bus.set_tries(2);
        for id in 0..=arguments.to.min(family.last_id()) {
            let wire: &mut dyn Wire = &mut bus;
            let number = match wire.repeat(|wire| family.identify(wire, id)) {
                Ok(number) => number,
                Err(BusError::NoAnswer) => continue,
                Err(error) => return Err(Error::Failed(error.to_string())),
            };
            let model = number.and_then(|number| Model::numbered(family, number));
            // Protocol 1 and Feetech share their frames: a servo of the one looks like a strange one of the other.
            if number.is_some() && model.is_none() && arguments.family.is_none() {
                continue;
            }
            let name = match (model, number) {
                (Some(model), _) => model.name.to_owned(),
                (None, Some(number)) => format!("#{number}"),
                (None, None) => "?".to_owned(),
            };
            let shown = |value: Option<String>| value.unwrap_or_else(|| "?".to_owned());
            let delay = family.return_delay(&mut bus, id).ok();
            let reading = values(family, &mut bus, id);
            let volts = reading.and_then(|it| it.voltage);
            let celsius = reading.and_then(|it| it.temperature);
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{id:3}  {name:13}  {:>6}  {:>4.4} V  {:>3} °C  {:>3} µs  {}",
                shown(reading.map(|it| it.position.to_string())),
                shown(volts.map(|it| it.to_string())),
                shown(celsius.map(|it| it.to_string())),
                shown(delay.map(|it| it.to_string())),
                family.name()
            );
            count += 1;
        }
    }
    if count == 0 {
        return Err(Error::failed(Driving::NothingFound, lang));
    }
    text.insert_str(
        0,
        " id  model          counts  supply    temp   delay  family\n",
    );
    let found = Driving::Found { servos: count };
    let _ = writeln!(text, "{}", found.in_lang(lang));
    output::print(text)?;
    Ok(Status::Success)
}

/// Reads what a servo measures; a few times, because some do not tell everything in one answer.
fn values(family: &dyn Family, bus: &mut Bus<AnyPort>, id: u8) -> Option<Reading> {
    let mut found: Option<Reading> = None;
    for turn in 0..3 {
        let query = Query {
            id,
            turn,
            is_late: false,
        };
        // A servo that is silent now has answered before.
        let _ = family.read(bus, &[query], u64::MAX, false, &mut |_, reading| {
            let old = found.unwrap_or(reading);
            found = Some(Reading {
                voltage: reading.voltage.or(old.voltage),
                temperature: reading.temperature.or(old.temperature),
                ..reading
            });
        });
    }
    found
}

fn id(arguments: &Id) -> Result<Status, Error> {
    let (lang, family) = (arguments.port.lang(), arguments.family);
    let (from, to) = (arguments.from, arguments.to);
    let mut bus = arguments.port.bus()?;
    if from != to && family.identify(&mut bus, to).is_ok() {
        return Err(Error::failed(Driving::IdTaken { id: to.into() }, lang));
    }
    family.set_id(&mut bus, from, to).map_err(|error| {
        let (id, to) = (from.into(), to.into());
        match error {
            BusError::Unsupported => Error::failed(Driving::OwnTool { id, to }, lang),
            error => Error::Failed(error.to_string()),
        }
    })?;
    let renamed = Driving::Renamed {
        id: from.into(),
        to: to.into(),
    };
    output::say(renamed, lang)?;
    Ok(Status::Success)
}

/// An answer to a question about a joint.
enum Answer {
    /// It is in its place.
    Done,
    /// It is left out.
    Skip,
    /// The input has ended.
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
            _ => {}
        }
    }
}

fn zero(arguments: &Zero) -> Result<Status, Error> {
    let lang = arguments.robot.lang();
    let mut setup = arguments.robot.setup()?;
    // Where the joints are is what is to be found.
    for joint in &mut setup.joints {
        joint.limits = tip_runtime::model::Range::new(-1e6, 1e6);
    }
    let connection = arguments.robot.open(setup)?;
    connection.robot().drives_mut().release();
    report::say(Driving::ZeroHow, lang);
    let mut found = Vec::new();
    for place in 0..connection.setup.joints.len() {
        let joint = connection.setup.name(place);
        let own = connection.setup.joints[place];
        let question = Driving::AtZero {
            joint: joint.clone(),
        };
        match answer(&question, lang)? {
            Answer::Ended => break,
            Answer::Skip => continue,
            Answer::Done => {}
        }
        let offset = motor_angle(&connection, place)?;
        let question = Driving::AtPositive {
            joint: joint.clone(),
        };
        let turned = match answer(&question, lang)? {
            Answer::Done => motor_angle(&connection, place)? - offset,
            Answer::Skip | Answer::Ended => 0.0,
        };
        let sign = if turned.abs() < 3.0 {
            report::say(Driving::NotTurned, lang);
            own.sign
        } else {
            turned.signum()
        };
        let offset = (offset * 10.0).round() / 10.0;
        found.push(Zeroed {
            place,
            joint,
            sign,
            offset,
        });
    }
    let path = &arguments.robot.file;
    let file = || path.display().to_string().into();
    if found.is_empty() {
        report::say(Driving::ZeroNone { file: file() }, lang);
        return Ok(Status::Success);
    }
    if arguments.write {
        let text = embed::read_file(path, embed::LIMIT).unwrap_or_default();
        if let Some(new) = with_zeros(&text, &found) {
            output::update(path, &text, new.as_bytes(), lang)?;
            let joints: Vec<&str> = found.iter().map(|it| it.joint.as_str()).collect();
            let (joints, file) = (joints.join(", "), file());
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
    } in &found
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
    let old = description::parse_for_servos("", text, &input::servos()).ok()?;
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
    let read = description::parse_for_servos("", new.as_bytes(), &input::servos()).ok()?;
    (read.bus() == Some(&expected)).then_some(new)
}

/// Measures the motor angle of a joint, deg.
fn motor_angle(connection: &Connection, place: usize) -> Result<f64, Error> {
    // Each of them in turn may be read one by one.
    for _ in 0..4 {
        let read = connection.measure();
        read.map_err(|failure| connection.failed(failure))?;
    }
    let measured = connection.robot().drives().measured(place);
    let model = connection.setup.joints[place].model;
    Ok(measured.map_or(0.0, |measured| model.angle(measured.counts.into())))
}

fn jog(arguments: &Jog) -> Result<Status, Error> {
    interrupt::catch();
    let lang = arguments.robot.lang();
    if !io::stdin().is_terminal() {
        return Err(Error::failed(Driving::OnlyOnTerminal, lang));
    }
    let setup = arguments.robot.setup()?;
    let mut joints = 0..setup.joints.len();
    let Some(place) = joints.find(|place| setup.name(*place) == arguments.joint) else {
        let joint = arguments.joint.clone();
        return Err(Error::failed(Driving::NoSuchJoint { joint }, lang));
    };
    let (limits, speed) = (setup.joints[place].limits, setup.bus.start);
    let connection = arguments.robot.open(setup)?;
    let joint = arguments.joint.clone();
    report::say(Driving::JogHow { joint }, lang);
    connection.take_over();
    let mut step = connection.robot().hold();
    let mut to: Vec<f64> = connection.angles();
    let stopped = loop {
        if let Some(status) = connection.ended(step) {
            break status;
        }
        let mut robot = connection.robot();
        let mut is_over = false;
        while let Some(key) = robot.host_mut().key() {
            match key {
                b'+' => to[place] += 1.0,
                b'-' => to[place] -= 1.0,
                b'q' => is_over = true,
                _ => {}
            }
        }
        to[place] = to[place].clamp(limits.min, limits.max);
        step = match is_over {
            true => Ok(robot.obey(Request::End)),
            false => robot.step(&to, speed),
        };
        let angle = robot.drives().angle(place).unwrap_or_default();
        let status = format!(
            "\r{} {angle:7.1} -> {:7.1} deg ",
            arguments.joint, to[place]
        );
        // Nothing is lost with a status that cannot be shown.
        let _ = io::stderr().write_all(status.as_bytes());
        if !matches!(step, Ok(Step::Moving | Step::Arrived)) {
            report::complain("\n");
        }
    };
    Ok(match stopped {
        // Ctrl-C and ESC end it as q does.
        Status::Interrupted => Status::Success,
        stopped => stopped,
    })
}

fn monitor(arguments: &Monitor) -> Result<Status, Error> {
    interrupt::catch();
    let connection = arguments.robot.connect()?;
    let rewrites = io::stdout().is_terminal() && !arguments.once;
    let mut failure = None;
    loop {
        // As many readings as a table needs, where servos are read one by one.
        for _ in 0..3 {
            failure = failure.or(connection.measure().err());
        }
        let text = table(&connection);
        let shown = if rewrites {
            format!("\x1b[2J\x1b[H{text}")
        } else {
            text
        };
        let mut out = io::stdout().lock();
        if out
            .write_all(shown.as_bytes())
            .and_then(|()| out.flush())
            .is_err()
        {
            return Ok(Status::Success);
        }
        if let Some(failure) = failure {
            return Err(connection.failed(failure));
        }
        if arguments.once {
            return Ok(Status::Success);
        }
        if interrupt::is_requested() {
            return Ok(Status::Interrupted);
        }
        realtime::wait_until(Instant::now() + Duration::from_millis(200));
    }
}

/// Returns a value with this many decimals, or a sign that it is not known.
fn shown(value: Option<f64>, decimals: usize) -> String {
    value.map_or_else(|| "?".to_owned(), |value| format!("{value:.decimals$}"))
}

/// Returns the table of `tip drives monitor`.
fn table(connection: &Connection) -> String {
    let robot = connection.robot();
    let drives = robot.drives();
    let mut text =
        String::from("joint  servo  model          counts      deg    load     V   °C\n");
    for (place, joint) in connection.setup.joints.iter().enumerate() {
        let name = connection.setup.name(place);
        let head = format!("{name:5}  {:5}  {:13}", joint.id, joint.model.name);
        let _ = match drives.measured(place) {
            Some(it) => writeln!(
                text,
                "{head}  {:6}  {:7.1}  {:>5} %  {:>4}  {:>3}",
                it.counts,
                joint.angle(it.counts),
                shown(it.load.map(|load| load * 100.0), 0),
                shown(it.voltage, 1),
                shown(it.temperature, 0)
            ),
            None => writeln!(text, "{head}       -"),
        };
    }
    let bus = drives.bus().counters();
    let _ = writeln!(
        text,
        "{} / {} answers, {} B discarded",
        bus.answered, bus.asked, bus.discarded
    );
    text
}

fn simulate(arguments: &Simulate) -> Result<Status, Error> {
    interrupt::catch();
    let lang = choices::lang(arguments.lang);
    let robot = RobotArguments {
        file: arguments.file.clone(),
        port: None,
        lang: arguments.lang,
    };
    let mishaps: Mishaps =
        (arguments.mishaps.parse()).map_err(|wrong: Driving| Error::usage(wrong, lang))?;
    let setup = robot.setup()?;
    simulated::serve(&setup, mishaps, lang, |port| {
        let servos = setup.joints.len();
        let port = port.into();
        output::say(Driving::Simulates { servos, port }, lang)
    })
}
