//! The commands of `tip`: each is one row with its name, its group, its help, its arguments and what it runs. `tip completions`
//! and `tip man` are here, because they write what the rows say.

use crate::Action;
use crate::choices::{Format, LangName, robot_names};
use crate::error::Error;
use crate::{
    Arguments, Status, check, compare, debug, drives, explain, new, output, playground, record,
    robot, run, serve, servers, sweep, translate, verify,
};
use clap::builder::EnumValueParser;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, CommandFactory};
use clap_complete::Shell;
use std::path::{Path, PathBuf};
use std::{fs, io};
use tipc::message::Lang;

/// A group of commands by what people do with them, in the order of the list of commands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Group {
    Write,
    Run,
    See,
    Robots,
    EditorsAndShells,
}

impl Group {
    /// The groups in their order.
    pub(crate) const ALL: [Group; 5] = [
        Group::Write,
        Group::Run,
        Group::See,
        Group::Robots,
        Group::EditorsAndShells,
    ];

    /// Returns the heading of the group.
    pub(crate) const fn heading(self, lang: Lang) -> &'static str {
        match self {
            Group::Write => lang.pick("Write", "書く"),
            Group::Run => lang.pick("Run", "実行する"),
            Group::See => lang.pick("See", "見る"),
            Group::Robots => lang.pick("Robots", "ロボット"),
            Group::EditorsAndShells => lang.pick("Editors and shells", "エディタとシェル"),
        }
    }
}

/// A command. Its options and their English help are in its arguments, the Japanese help is in `help/ja.toml`.
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) group: Group,
    /// One line of help.
    about: &'static str,
    arguments: fn(Command) -> Command,
    execute: fn(&ArgMatches) -> Result<Status, Error>,
}

impl Row {
    const fn of<A: Action>(group: Group, name: &'static str, about: &'static str) -> Self {
        Row {
            name,
            group,
            about,
            arguments: A::augment_args,
            execute: execute::<A>,
        }
    }
}

/// The commands, group by group as the help lists them.
static ROWS: &[Row] = &[
    Row::of::<new::New>(
        Group::Write,
        "new",
        "Make a crate with a robot that moves, a test and editor settings",
    ),
    Row::of::<check::Check>(
        Group::Write,
        "check",
        "Check programs and report all errors and warnings",
    ),
    Row::of::<translate::Fmt>(Group::Write, "fmt", "Format programs in the standard style"),
    Row::of::<explain::Explain>(
        Group::Write,
        "explain",
        "Explain a code such as E205, with a wrong and a right program",
    ),
    Row::of::<translate::Migrate>(
        Group::Write,
        "migrate",
        "Migrate a program of an older version to version 3.1",
    ),
    Row::of::<translate::Emit>(Group::Write, "emit", "Write a program in another form"),
    Row::of::<run::Run>(Group::Run, "run", "Run a program on the simulated robot"),
    Row::of::<debug::Debug>(
        Group::Run,
        "debug",
        "Debug a program in the terminal, forwards and backwards",
    ),
    Row::of::<verify::Verify>(
        Group::Run,
        "verify",
        "Compare a program's compiled code with the reference interpreter",
    ),
    Row::of::<translate::Cycles>(
        Group::Run,
        "cycles",
        "Count the control cycles that the parts of a program take",
    ),
    Row::of::<sweep::Sweep>(
        Group::Run,
        "sweep",
        "Run a program many times over ranges of values",
    ),
    Row::of::<record::View>(
        Group::See,
        "view",
        "Write a page that replays a run, or compares two, in 3-D",
    ),
    Row::of::<serve::Serve>(
        Group::See,
        "serve",
        "Run a program live in a web page, with controls and an editor",
    ),
    Row::of::<playground::Playground>(
        Group::See,
        "playground",
        "Write a page with compiler, simulator and lessons",
    ),
    Row::of::<record::Plot>(Group::See, "plot", "Draw diagrams of a run: SVG"),
    Row::of::<compare::Compare>(Group::See, "compare", "Compare the figures of two runs"),
    Row::of::<record::Log>(
        Group::See,
        "log",
        "Write the log of a run for other tools: MCAP or CSV",
    ),
    Row::of::<robot::RobotArguments>(
        Group::Robots,
        "robot",
        "Work with robots and their descriptions",
    ),
    Row::of::<drives::DrivesArguments>(
        Group::Robots,
        "drives",
        "Find, zero, move, teach and watch the servos of a real robot",
    ),
    Row::of::<drives::realtime::Jitter>(
        Group::Robots,
        "jitter",
        "Measure how late control cycles start on this machine",
    ),
    Row::of::<servers::Lsp>(
        Group::EditorsAndShells,
        "lsp",
        "Start the language server for editors",
    ),
    Row::of::<servers::Dap>(
        Group::EditorsAndShells,
        "dap",
        "Start the debug adapter for editors (Debug Adapter Protocol)",
    ),
    Row::of::<Completions>(
        Group::EditorsAndShells,
        "completions",
        "Print a completion script for a shell",
    ),
    Row::of::<Man>(Group::EditorsAndShells, "man", "Write manual pages"),
];

/// Returns the grammar of the command line, with the options that may stand anywhere.
pub(crate) fn grammar() -> Command {
    let help = Arg::new("help")
        .short('h')
        .long("help")
        .action(ArgAction::HelpShort)
        .help("Print help");
    let lang = Arg::new("lang")
        .long("lang")
        .value_name("en|ja")
        .value_parser(EnumValueParser::<LangName>::new())
        .help("The language of messages; else the locale's");
    add_to(Arguments::command())
        .subcommand_required(true)
        .arg_required_else_help(true)
        .disable_help_flag(true)
        .args([lang.global(true), help.global(true)])
}

/// Adds the commands to the grammar of the command line.
fn add_to(tip: Command) -> Command {
    ROWS.iter().fold(tip, |tip, row| {
        let command = (row.arguments)(Command::new(row.name));
        // The comments of groups of arguments would replace these.
        tip.subcommand(command.about(row.about).long_about(None))
    })
}

/// Returns the names of the commands of a group, in the order of the help. The last line of the help names `help`, the command
/// of clap.
pub(crate) fn of_group(group: Group) -> impl Iterator<Item = &'static str> {
    let rows = ROWS.iter().filter(move |row| row.group == group);
    rows.map(|row| row.name)
}

/// Executes the command of a command line that has been read.
///
/// # Errors
/// The reason why the command did not do what it was asked.
pub(crate) fn execute_command(matches: &ArgMatches) -> Result<Status, Error> {
    let (name, matches) = matches.subcommand().unwrap_or(("", matches));
    match ROWS.iter().find(|row| row.name == name) {
        Some(row) => (row.execute)(matches),
        // The grammar asks for a command, and has those of the rows.
        None => Ok(Status::Usage),
    }
}

fn execute<A: Action>(matches: &ArgMatches) -> Result<Status, Error> {
    // The grammar was made of these arguments, and has checked them.
    let read = A::from_arg_matches(matches);
    let mut arguments = read.map_err(|error| Error::Usage(error.to_string()))?;
    arguments.complete()?;
    if arguments.format() == Some(Format::Sarif) {
        return Err(Error::Usage("only tip check writes SARIF".to_owned()));
    }
    arguments.execute()
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip completions bash > ~/.local/share/bash-completion/completions/tip
  tip completions zsh > ~/.zfunc/_tip
  tip completions fish > ~/.config/fish/completions/tip.fish")]
pub(super) struct Completions {
    /// The shell: bash, elvish, fish, powershell or zsh
    shell: Shell,
}

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip man -o ~/.local/share/man/man1")]
pub(super) struct Man {
    /// The folder for the pages, one for each command
    ///
    /// It is created if necessary
    #[arg(short, long, value_name = "DIR")]
    out: PathBuf,
}

impl Action for Completions {
    fn execute(&self) -> Result<Status, Error> {
        completions(self)
    }
}

/// Prints the completion script of a shell.
fn completions(arguments: &Completions) -> Result<Status, Error> {
    let mut script = Vec::new();
    let mut command = grammar();
    let name = command.get_name().to_owned();
    clap_complete::generate(arguments.shell, &mut command, name, &mut script);
    let script = String::from_utf8_lossy(&script);
    output::print(with_files(&script, arguments.shell))?;
    Ok(Status::Success)
}

/// Completes files wherever the name of a robot is completed, as a description may be there.
fn with_files(script: &str, shell: Shell) -> String {
    let lines = script.lines().map(|line| {
        let names = [robot_names(&[]), robot_names(&["hexapod"])].map(|names| names.join(" "));
        let names = names.iter().find(|names| line.contains(names.as_str()));
        match (shell, names) {
            (Shell::Bash, Some(_)) => line.replace("compgen -W", "compgen -f -W"),
            (Shell::Zsh, Some(names)) => line.replace(
                &format!("({names})"),
                &format!("{{compadd {names}; _files}}"),
            ),
            (Shell::Fish, _) if line.contains("-l robot ") => line.replace(" -r -f ", " -r -F "),
            _ => line.to_owned(),
        }
    });
    lines.map(|line| line + "\n").collect()
}

impl Action for Man {
    fn execute(&self) -> Result<Status, Error> {
        man(self)
    }
}

/// Keeps the lines of examples and tables in the manual pages of a folder, which would be filled like sentences.
fn keep_lines(folder: &Path) -> io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if name.starts_with("tip") && name.ends_with(".1") {
            let page = fs::read_to_string(&path)?;
            fs::write(&path, page.replace("\n.SH EXTRA\n", "\n.SH EXTRA\n.nf\n"))?;
        }
    }
    Ok(())
}

/// Writes the manual pages.
fn man(arguments: &Man) -> Result<Status, Error> {
    let folder = &arguments.out;
    let failed = |error: io::Error| Error::cannot_write(folder, error);
    fs::create_dir_all(folder).map_err(failed)?;
    clap_mangen::generate_to(grammar(), folder).map_err(failed)?;
    keep_lines(folder).map_err(failed)?;
    Ok(Status::Success)
}
