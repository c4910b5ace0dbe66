//! `tip check`: reports the diagnostics of programs, once or after each change, and applies fixes.

use crate::Action;
use crate::arguments::SourceArguments;
use crate::choices::{Format, OutputOptions};
use crate::error::Error;
use crate::loader;
use crate::message::{Checking, Using};
use crate::report::{Deny, Total};
use crate::watch::Watch;
use crate::{Status, input, interrupt, output, report};
use clap::Args;
use std::io::{self, IsTerminal};
use std::path::{Path, PathBuf};
use tip_lint::message::Fixing;
use tip_lint::repair::{Repaired, confirm, preview, render_json, render_short, repair};
use tip_runtime::printable::Printable;
use tip_sim::Robot;
use tipc::diagnostic::Applicability;
use tipc::{Loaded, Options};

#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip check walk.prg turn.prg
  tip check --robot hand grasp.prg
  tip check --robot hexapod.toml march.prg   a robot of your own (docs/robots.md)
  tip check --message-format json walk.prg   one object a line, on standard output
  tip check --message-format short *.prg     FILE:LINE:COLUMN: error[E205]: REASON (TIP_ERR:...)
  tip check --message-format sarif *.prg     one document of SARIF 2.1.0, on standard output
  tip check - < walk.prg                     from standard input
  tip check --lang ja walk.prg               reasons and helps in Japanese
  tip check --fix walk.prg                   put right what is certain, and report what is left
  tip check --fix - < walk.prg > new.prg     the program with its fixes on standard output
  tip check --deny warnings walk.prg         exit status 1 if there is a warning
  tip check --deny W112,W117 walk.prg        if there is one of these
  tip check --quiet *.prg                    nothing of the programs that are in order
  tip check --watch walk.prg                 again after each change, until Ctrl-C

A comment silences warnings: '// tip: allow(W112)' at the end of a line, on a line above a statement, or above the
first statement for the whole program.

Exit status: 0 if every program loads (warnings do not count unless denied), 1 otherwise; with --fix, if it loads after its fixes;
130 after --watch.")]
pub(super) struct Check {
    /// The programs; '-' is standard input
    #[arg(value_name = "FILE", required = true)]
    pub(super) files: Vec<PathBuf>,

    /// Apply certain fixes and write the files
    ///
    /// For standard input, the program goes to standard output
    #[arg(long)]
    fix: bool,

    /// Apply likely fixes as well
    #[arg(long, requires = "fix")]
    unsafe_fixes: bool,

    /// Check again whenever a file changes
    #[arg(long, conflicts_with = "fix")]
    pub(super) watch: bool,

    /// Say nothing of programs that are in order
    #[arg(long, short)]
    quiet: bool,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) deny: Deny,
}

impl Check {
    /// Returns the least certainty of the fixes that are applied; `None` without `--fix`.
    fn least_certainty(&self) -> Option<Applicability> {
        self.fix.then_some(match self.unsafe_fixes {
            true => Applicability::Likely,
            false => Applicability::Certain,
        })
    }
}

impl Action for Check {
    fn execute(&self) -> Result<Status, Error> {
        check(self)
    }
}

/// Checks each file, once or whenever one changes.
fn check(arguments: &Check) -> Result<Status, Error> {
    match arguments.watch {
        true => watch(arguments),
        false => check_once(arguments),
    }
}

/// Checks until Ctrl-C.
fn watch(arguments: &Check) -> Result<Status, Error> {
    let lang = arguments.source.output_options.lang();
    if arguments.files.iter().any(|file| input::is_stream(file)) {
        return Err(Error::usage(Using::WatchInput, lang));
    }
    interrupt::catch();
    let programs = arguments.files.iter().map(PathBuf::as_path);
    let mut watcher = Watch::begin(programs.chain(arguments.source.robot().file()))?;
    let is_human = arguments.source.output_options.message_format == Format::Human;
    let says = |message: Checking| {
        if is_human {
            report::complain(&format!("{RULE} {} {RULE}\n", message.in_lang(lang)));
        }
    };
    for count in 2.. {
        watcher.extend(
            arguments
                .files
                .iter()
                .flat_map(|file| loader::settings_files(file)),
        );
        check_once(arguments)?;
        let files = arguments.files.len().into();
        says(Checking::Watching { files });
        if !watcher.changed() {
            break;
        }
        if is_human && io::stderr().is_terminal() {
            report::clear();
        }
        says(Checking::Again { count });
    }
    Ok(Status::Interrupted)
}

/// The rule between two checks.
const RULE: &str = "────────";

/// Checks each file; one that does not load makes the whole command fail.
fn check_once(arguments: &Check) -> Result<Status, Error> {
    let output_options = arguments.source.output_options;
    let mut total = Total::new(output_options, arguments.quiet);
    let mut status = Status::Success;
    let mut fixable = Fixable::default();
    for file in &arguments.files {
        let mut source = arguments.source.clone();
        let found = source.complete(file);
        let found = found.and_then(|_| match arguments.least_certainty() {
            Some(least) => {
                let robot = source.load_robot()?.simulated()?;
                let loaded = fix(file, &source, &robot, least, &total)?;
                Ok((loaded, source.options(robot.options().robot)))
            }
            None => {
                let subject = loader::check(file, &source)?;
                let options = source.options(subject.chosen.robot());
                let loaded = confirmed(subject.loaded, &options, output_options);
                total.check(&loaded)?;
                Ok((loaded, options))
            }
        });
        let (loaded, options) = match found {
            Ok(found) => found,
            Err(Error::Refused(loaded, _)) => {
                total.check(&loaded)?;
                total.add(&loaded);
                total.report()?;
                return Ok(Status::Failure);
            }
            Err(error) => return Err(error),
        };
        total.add(&loaded);
        fixable.add(&loaded, &options, output_options);
        if arguments.deny.rejects(&loaded) || loaded.program.is_none() {
            status = Status::Failure;
        }
    }
    fixable.report(output_options);
    total.report()?;
    Ok(status)
}

/// Applies fixes to a program and writes it if there were any; reports and returns the remaining diagnostics.
fn fix(
    path: &Path,
    source: &SourceArguments,
    robot: &Robot,
    least: Applicability,
    total: &Total,
) -> Result<Loaded, Error> {
    let output_options = source.output_options;
    let options = source.options(robot.options().robot);
    let loaded = input::load(path, &options);
    let read = loaded.source.bytes();
    let repaired = repair(loaded, &options, least);
    let text = fix_report(&repaired, output_options);
    let Repaired {
        applied,
        mut loaded,
    } = repaired;
    loader::warn(&mut loaded, path, source, robot);
    // Standard output holds the program.
    if input::is_stream(path) && input::was_read(&loaded) {
        output::print(loaded.source.bytes())?;
        report::complain(&text);
        report::diagnostics(&loaded, output_options);
        return Ok(loaded);
    }
    if !applied.is_empty() {
        output::update(path, &read, &loaded.source.bytes(), output_options.lang())?;
    }
    match output_options.message_format {
        Format::Human => report::complain(&text),
        Format::Short | Format::Json => output::print(&text)?,
        // Standard output holds one document of the remaining diagnostics.
        Format::Sarif => (),
    }
    let loaded = confirmed(loaded, &options, output_options);
    total.check(&loaded)?;
    Ok(loaded)
}

/// Keeps only the fixes that were tried, for output that tools read.
fn confirmed(loaded: Loaded, options: &Options, output_options: OutputOptions) -> Loaded {
    match output_options.message_format {
        Format::Json | Format::Sarif => confirm(loaded, options),
        Format::Human | Format::Short => loaded,
    }
}

/// Returns what was fixed: a count for people, a line per fix for tools.
fn fix_report(repaired: &Repaired, output_options: OutputOptions) -> String {
    let lang = output_options.lang();
    match output_options.message_format {
        Format::Human if repaired.applied.is_empty() => String::new(),
        Format::Human => {
            let diagnostics = repaired.applied.len().into();
            let fixed = Fixing::Fixed { diagnostics };
            let name = Printable::line(repaired.loaded.source.name());
            format!("{name}: {}\n", fixed.in_lang(lang))
        }
        Format::Short => render_short(repaired, lang),
        Format::Json => render_json(repaired, lang),
        Format::Sarif => String::new(),
    }
}

/// Number of diagnostics that can be fixed.
#[derive(Debug, Default)]
struct Fixable {
    certain: usize,
    all: usize,
}

impl Fixable {
    /// Counts the fixable diagnostics of a file.
    fn add(&mut self, loaded: &Loaded, options: &Options, output_options: OutputOptions) {
        let is_known = loaded.diagnostics.iter().any(|one| !one.fixes.is_empty());
        if !is_known || output_options.message_format != Format::Human {
            return;
        }
        let certain = preview(loaded.clone(), options, Applicability::Certain);
        let likely = preview(certain.loaded, options, Applicability::Likely);
        self.certain += certain.applied.len();
        self.all += certain.applied.len() + likely.applied.len();
    }

    /// Reports the counts to people.
    fn report(self, output_options: OutputOptions) {
        let diagnostics = self.certain.into();
        let can = match (self.certain, self.all) {
            (_, 0) => return,
            (0, all) => Fixing::CanFixLikely {
                diagnostics: all.into(),
            },
            (certain, all) if all > certain => Fixing::CanFixMore { diagnostics, all },
            _ => Fixing::CanFix { diagnostics },
        };
        report::say(can, output_options.lang());
    }
}
