//! `tip drives`: finds, names, zeroes, moves, teaches and watches the servos of a real robot.

mod port;
pub(crate) mod realtime;
mod record;
pub(crate) mod robot;
mod scan;
mod simulated;
mod zero;

use crate::Action;
use crate::choices::{LangName, OutputOptions};
use crate::error::{Error, is_closed};
use crate::input;
use crate::message::Driving;
use crate::{Status, choices, interrupt, output, report};
use clap::{Args, Subcommand};
use record::Record;
use robot::{Connection, Setup, report_stiff};
use scan::{Id, Scan};
use simulated::FaultInjection;
use std::fmt::Write as _;
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};
use std::slice;
use std::time::{Duration, Instant};
use tip_drives::guard::{Request, Step};
use tipc::description::Description;
use tipc::message::Lang;
use zero::Zero;

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
    /// Teach a motion by hand, and write it as a program
    Record(Record),
    /// Show angle, load, voltage and temperature of each joint
    Monitor(Monitor),
    /// Simulate the servos of a robot on a pseudo-terminal
    Simulate(Simulate),
}

/// Time in which a signal arrives that was sent with an error of the terminal.
const SIGNAL_TIME: Duration = Duration::from_millis(100);

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

    fn output_options(&self) -> OutputOptions {
        OutputOptions::of(LangName::of(self.lang()))
    }

    fn description(&self) -> Result<Description, Error> {
        input::describe(&self.file).map_err(Error::refused(self.output_options()))
    }

    fn setup(&self) -> Result<Setup, Error> {
        Setup::new(&self.file, &self.description()?, self.lang())
    }

    /// Connects to a robot that is to move.
    fn connect(&self, setup: Setup) -> Result<Connection, Error> {
        let connection = setup.open(&self.file, self.port.as_deref(), self.lang())?;
        if let Err(error) = connection.connect(false) {
            report_stiff(&connection, self.lang());
            return Err(error);
        }
        Ok(connection)
    }

    /// Connects to a robot that only the operator moves.
    fn connect_to_measure(&self) -> Result<Connection, Error> {
        let setup = self.setup()?;
        let connection = setup.open(&self.file, self.port.as_deref(), self.lang())?;
        connection.connect_to_measure()?;
        Ok(connection)
    }
}

#[derive(Debug, Args)]
#[command(after_long_help = "Example:
  tip drives jog robot.toml J11

+ and - turn the joint by 1 deg. RETURN is the emergency stop; q, ESC and Ctrl-C end in order.
The servos are left as `at_end` and `in_emergency` of the file say.

Exit status: 0 after q or ESC, 130 after Ctrl-C (143 after SIGTERM, 129 after SIGHUP), 3 if the robot
was stopped, 1 if it cannot start.")]
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

Exit status: 0 with --once, 130 after Ctrl-C or when the reader of the table is gone (129 after SIGHUP,
as when its terminal is closed), 1 if a servo does not answer.")]
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
  tip drives simulate robot.toml --inject faults=0.01,unplug=7@20

Exit status: 130 after Ctrl-C, 1 if it cannot start.")]
pub(crate) struct Simulate {
    /// The robot, described with [bus] and [[drive]]
    #[arg(value_name = "FILE.toml")]
    file: PathBuf,

    /// Faults to inject, separated by commas
    ///
    /// faults, corrupt, drop, duplicate, delay or truncate=PROBABILITY of an answer;
    /// unplug, reset, overheat, block, sag or turn (by hand, by 20 deg)=ID@SECONDS
    #[arg(long, value_name = "LIST", default_value = "")]
    inject: String,

    /// The language of messages; else the locale's
    #[arg(long, value_enum, value_name = "en|ja")]
    lang: Option<LangName>,
}

impl Action for DrivesArguments {
    fn execute(&self) -> Result<Status, Error> {
        match &self.verb {
            DrivesVerb::Scan(arguments) => scan::scan(arguments),
            DrivesVerb::Id(arguments) => scan::id(arguments),
            DrivesVerb::Zero(arguments) => zero::zero(arguments),
            DrivesVerb::Jog(arguments) => jog(arguments),
            DrivesVerb::Record(arguments) => record::record(arguments),
            DrivesVerb::Monitor(arguments) => monitor(arguments),
            DrivesVerb::Simulate(arguments) => simulate(arguments),
        }
    }
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
    let connection = arguments.robot.connect(setup)?;
    let joint = arguments.joint.clone();
    input::forget_typed();
    report::say(Driving::JogHow { joint }, lang);
    connection.take_over(!connection.is_simulated());
    let mut step = connection.robot().hold();
    let mut to: Vec<f64> = connection.angles();
    let stopped = loop {
        if let Some(status) = connection.ended(step) {
            break status;
        }
        let mut is_over = false;
        while let Some(key) = connection.key() {
            let turn = match key {
                b'+' => 1.0,
                b'-' => -1.0,
                b'q' => {
                    is_over = true;
                    break;
                }
                _ => continue,
            };
            let mut next = to.clone();
            next[place] = (to[place] + turn).clamp(limits.min, limits.max);
            match connection.refusal_of_way(slice::from_ref(&next)) {
                None => to = next,
                Some(reason) => report::complain(&format!("\n{reason}\n")),
            }
        }
        let mut robot = connection.robot();
        step = match is_over {
            true => Ok(robot.obey(Request::End)),
            false => robot.step(&to, speed),
        };
        let angle = robot.drives().angle(place).unwrap_or_default();
        // Nobody may read the status: the robot can be left then.
        drop(robot);
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
        // ESC ends it as q does; signals and Ctrl-C end it as they end every command.
        Status::Interrupted if !interrupt::is_requested() => Status::Success,
        stopped => stopped,
    })
}

fn monitor(arguments: &Monitor) -> Result<Status, Error> {
    interrupt::catch();
    let connection = arguments.robot.connect_to_measure()?;
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
        let written = out.write_all(shown.as_bytes()).and_then(|()| out.flush());
        if let Err(error) = written {
            return unread(error, arguments.once);
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

/// Ends a table that nobody can read any more.
fn unread(error: io::Error, once: bool) -> Result<Status, Error> {
    if is_closed(&error) && once {
        return Ok(Status::Success);
    }
    // The signal of a terminal that was closed may come after the error.
    realtime::sleep(SIGNAL_TIME);
    match interrupt::is_requested() || is_closed(&error) {
        true => Ok(Status::Interrupted),
        false => Err(Error::cannot_write(Path::new("standard output"), error)),
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
    let setup = robot.setup()?;
    let injection = FaultInjection::new(&arguments.inject, &setup.ids());
    let injection = injection.map_err(|wrong| Error::usage(wrong, lang))?;
    let bus = setup.simulated(&injection);
    simulated::serve(bus, injection, lang, |port| {
        let servos = setup.joints.len();
        let port = port.into();
        output::say(Driving::Simulates { servos, port }, lang)
    })
}
