//! `tip drives`: finds, names, zeroes, moves and watches the servos of a real robot.

pub(crate) mod realtime;
pub(crate) mod robot;

use crate::choices::LangName;
use crate::commands::Action;
use crate::error::Error;
use crate::input;
use crate::message::Driving;
use crate::{Status, choices, interrupt, output, report};
use clap::{Args, Subcommand, ValueEnum};
use robot::{AnyPort, Connection, Mishaps, Setup, open_serial};
use std::fmt::Write as _;
use std::io::{self, BufRead, IsTerminal, Write};
use std::path::PathBuf;
use std::time::{Duration, Instant};
use tip_drives::bus::{Bus, Timing};
use tip_drives::frame::LAST_ID;
use tip_drives::model::{self, Family, Model};
use tip_runtime::console::{Console, Terminal};
use tip_runtime::hardware::JointCommand;
use tipc::message::Lang;
use tipc::{description, embed};

/// The command `tip drives`.
#[derive(Debug, Args)]
pub(crate) struct DrivesArguments {
    #[command(subcommand)]
    verb: DrivesVerb,
}

/// The commands of `tip drives`.
#[derive(Debug, Subcommand)]
enum DrivesVerb {
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

/// The family of the servos on a bus.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum FamilyName {
    /// Dynamixel AX and MX, protocol 1
    Ax,
    /// Dynamixel X, protocol 2
    X,
    /// Feetech STS
    Sts,
    /// mjbots moteus, behind an fdcanusb adapter
    Moteus,
}

impl FamilyName {
    const fn family(self) -> &'static Family {
        match self {
            FamilyName::Ax => &model::AX,
            FamilyName::X => &model::X,
            FamilyName::Sts => &model::STS,
            FamilyName::Moteus => &model::MOTEUS,
        }
    }
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

    fn bus(&self, family: &Family) -> Result<Bus<AnyPort>, Error> {
        let port = open_serial(&self.port, self.baud, self.lang())?;
        let timing = Timing {
            baud: self.baud,
            return_delay: 500,
            latency: self.latency * 1000,
        };
        Ok(Bus::new(port, family.protocol, timing))
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

    /// The servos' family; else all are tried
    #[arg(long, value_enum)]
    family: Option<FamilyName>,

    /// The largest identity that is tried
    #[arg(long, default_value_t = LAST_ID, value_parser = clap::value_parser!(u8).range(0..=252))]
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

    /// The family of the servo
    #[arg(long, value_enum)]
    family: FamilyName,

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

impl Action for DrivesArguments {
    fn execute(&self) -> Result<Status, Error> {
        match &self.verb {
            DrivesVerb::Scan(arguments) => scan(arguments),
            DrivesVerb::Id(arguments) => id(arguments),
            DrivesVerb::Zero(arguments) => zero(arguments),
            DrivesVerb::Jog(arguments) => jog(arguments),
            DrivesVerb::Monitor(arguments) => monitor(arguments),
            DrivesVerb::Simulate(arguments) => simulate(arguments),
        }
    }
}

fn scan(arguments: &Scan) -> Result<Status, Error> {
    let lang = arguments.port.lang();
    let all = [FamilyName::Sts, FamilyName::Ax, FamilyName::X];
    let families = arguments
        .family
        .as_ref()
        .map_or(&all[..], std::slice::from_ref);
    let (mut text, mut count) = (String::new(), 0);
    for family in families.iter().map(|name| name.family()) {
        let mut bus = arguments.port.bus(family)?;
        let mut found = Vec::new();
        let scanned = bus.scan(family, 0..=arguments.to, |id, number| {
            found.push((id, number))
        });
        scanned.map_err(|error| Error::Failed(error.to_string()))?;
        for (id, number) in found {
            let model = Model::numbered(family, number);
            // Protocol 1 and Feetech share their frames: a servo of the one looks like a strange one of the other.
            if model.is_none() && arguments.family.is_none() && family.protocol != model::X.protocol
            {
                continue;
            }
            let name = match model {
                Some(model) => model.name.to_owned(),
                None if number == 0 => "?".to_owned(),
                None => format!("#{number}"),
            };
            let mut get = |register, unit: f64| {
                let mut tries = (0..3).map(|_| bus.read_register(id, register));
                let value = tries.find_map(Result::ok);
                value.map_or_else(
                    || "?".to_owned(),
                    |value| (f64::from(value) * unit).to_string(),
                )
            };
            let delay = family.return_delay;
            let delay = delay.map_or_else(|| "0".to_owned(), |delay| get(delay, 2.0));
            let (volts, celsius) = (get(family.voltage, 0.1), get(family.temperature, 1.0));
            let counts = get(family.position, 1.0);
            // Writing to a String cannot fail.
            let _ = writeln!(
                text,
                "{id:3}  {name:13}  {counts:>6}  {volts:>4.4} V  {celsius:>3} °C  {delay:>3} µs  {}",
                family.name
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

fn id(arguments: &Id) -> Result<Status, Error> {
    let (lang, family) = (arguments.port.lang(), arguments.family.family());
    let (from, to) = (arguments.from, arguments.to);
    if arguments.family == FamilyName::Moteus {
        let (id, to) = (from.into(), to.into());
        return Err(Error::failed(Driving::OwnTool { id, to }, lang));
    }
    let mut bus = arguments.port.bus(family)?;
    if from != to && bus.read_register(to, family.model).is_ok() {
        return Err(Error::failed(Driving::IdTaken { id: to.into() }, lang));
    }
    bus.set_id(family, from, to)
        .map_err(|error| Error::Failed(error.to_string()))?;
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
        let mut line = String::new();
        let read = io::stdin().lock().read_line(&mut line);
        if read.map_err(|error| Error::Failed(error.to_string()))? == 0 {
            return Ok(Answer::Ended);
        }
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
    let mut connection = arguments.robot.open(setup)?;
    let joints = connection.setup.joints.iter();
    let off: Vec<(u8, i32)> = joints.map(|joint| (joint.id, 0)).collect();
    if let Some(joint) = connection.setup.joints.first() {
        let register = joint.model.family.torque_enable;
        let sent = connection.drives().bus_mut().sync_write(register, &off);
        sent.map_err(|error| Error::Failed(error.to_string()))?;
    }
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
        let offset = motor_angle(&mut connection, place)?;
        let question = Driving::AtPositive {
            joint: joint.clone(),
        };
        let turned = match answer(&question, lang)? {
            Answer::Done => motor_angle(&mut connection, place)? - offset,
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
fn motor_angle(connection: &mut Connection, place: usize) -> Result<f64, Error> {
    connection.tick();
    // Each of them in turn may be read one by one.
    for _ in 0..4 {
        let read = connection.drives().read_cycle();
        read.map_err(|failure| connection.failed(failure))?;
    }
    let measured = connection.drives().measured(place);
    let model = connection.setup.joints[place].model;
    Ok(measured.map_or(0.0, |measured| model.angle(measured.counts.into())))
}

fn jog(arguments: &Jog) -> Result<Status, Error> {
    interrupt::catch();
    let lang = arguments.robot.lang();
    if !io::stdin().is_terminal() {
        return Err(Error::failed(Driving::OnlyOnTerminal, lang));
    }
    let mut connection = arguments.robot.connect()?;
    let joints = 0..connection.setup.joints.len();
    let mut named = joints.filter(|place| connection.setup.name(*place) == arguments.joint);
    let Some(place) = named.next() else {
        let joint = arguments.joint.clone();
        return Err(Error::failed(Driving::NoSuchJoint { joint }, lang));
    };
    let joint = arguments.joint.clone();
    report::say(Driving::JogHow { joint }, lang);
    let held = connection.drives().hold();
    let mut to: Vec<f64> = {
        let drives = connection.drives();
        let joints = 0..connection.setup.joints.len();
        joints
            .map(|joint| drives.angle(joint).unwrap_or_default())
            .collect()
    };
    let mut stopped = held.err();
    let mut keyboard = Terminal::on(io::sink(), false).report_interrupts();
    while stopped.is_none() && !interrupt::is_requested() && !keyboard.interrupted() {
        let due = Instant::now() + Duration::from_secs_f64(connection.period() / 1000.0);
        match keyboard.key(0) {
            Some(b'+') => to[place] += 1.0,
            Some(b'-') => to[place] -= 1.0,
            Some(b'q') => break,
            _ => {}
        }
        let limits = connection.setup.joints[place].limits;
        to[place] = to[place].clamp(limits.min, limits.max);
        connection.tick();
        let (speed, period) = (connection.setup.bus.start, connection.period());
        stopped = connection.drives().approach(&to, speed, period).err();
        let angle = connection.drives().angle(place).unwrap_or_default();
        let status = format!(
            "\r{} {angle:7.1} -> {:7.1} deg ",
            arguments.joint, to[place]
        );
        // Nothing is lost with a status that cannot be shown.
        let _ = io::stderr().write_all(status.as_bytes());
        realtime::wait_until(due);
    }
    drop(keyboard);
    report::complain("\n");
    // The policies are those of a run; nobody wants a jogged robot to fall.
    let commands: Vec<JointCommand> = to.iter().map(|angle| JointCommand::at(*angle)).collect();
    match stopped {
        Some(failure) => {
            report::complain(&format!("{}\n", connection.explain(failure)));
            Ok(Status::Emergency)
        }
        None => {
            let period = connection.period();
            let _ = connection.drives().write_cycle(&commands, period);
            connection.drives().leave();
            Ok(Status::Success)
        }
    }
}

fn monitor(arguments: &Monitor) -> Result<Status, Error> {
    interrupt::catch();
    let mut connection = arguments.robot.connect()?;
    let rewrites = io::stdout().is_terminal() && !arguments.once;
    let mut failure = None;
    loop {
        connection.tick();
        // As many readings as a table needs, where servos are read one by one.
        for _ in 0..3 {
            failure = failure.or(connection.drives().read_cycle().err());
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

/// Returns the table of `tip drives monitor`.
fn table(connection: &Connection) -> String {
    let drives = connection.drives();
    let mut text =
        String::from("joint  servo  model          counts      deg    load     V   °C\n");
    for (place, joint) in connection.setup.joints.iter().enumerate() {
        let name = connection.setup.name(place);
        let head = format!("{name:5}  {:5}  {:13}", joint.id, joint.model.name);
        let _ = match drives.measured(place) {
            Some(it) => writeln!(
                text,
                "{head}  {:6}  {:7.1}  {:5.0} %  {:4.1}  {:3.0}",
                it.counts,
                joint.angle(it.counts),
                it.load * 100.0,
                it.voltage,
                it.temperature
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
    robot::serve(&setup, mishaps, lang, |port| {
        let servos = setup.joints.len();
        let port = port.into();
        output::say(Driving::Simulates { servos, port }, lang)
    })
}
