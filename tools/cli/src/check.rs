//! `tip check`: reports everything that is wrong with programs.

use super::arguments::SourceArguments;
use super::choices::Format;
use super::deny::Deny;
use super::error::Error;
use super::loader::{self, NotLoaded};
use super::watch::Watch;
use super::{Status, fix, input, interrupt, project, report};
use crate::message::{Checking, Using};
use clap::Args;
use std::io::{self, IsTerminal};
use std::path::PathBuf;
use tipc::diagnostic::Applicability;

/// `tip check`
#[derive(Debug, Args)]
#[command(after_help = "Examples:
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

    /// Apply the fixes that are certain, and write the files; from standard input to standard output
    #[arg(long)]
    fix: bool,

    /// Apply likely fixes as well
    #[arg(long, requires = "fix")]
    unsafe_fixes: bool,

    /// Check again whenever a file changes
    #[arg(long, conflicts_with = "fix")]
    pub(super) watch: bool,

    /// Say nothing of programs in which nothing is found
    #[arg(long, short)]
    quiet: bool,

    #[command(flatten)]
    pub(super) source: SourceArguments,

    #[command(flatten)]
    pub(super) deny: Deny,
}

impl Check {
    /// How sure a fix must be to be applied, if any is.
    fn least(&self) -> Option<Applicability> {
        self.fix.then_some(match self.unsafe_fixes {
            true => Applicability::Likely,
            false => Applicability::Certain,
        })
    }
}

/// Checks each file, once or whenever one changes.
pub(super) fn check(arguments: &Check) -> Result<Status, Error> {
    match arguments.watch {
        true => again_and_again(arguments),
        false => once(arguments),
    }
}

/// Checks until Ctrl-C.
fn again_and_again(arguments: &Check) -> Result<Status, Error> {
    let lang = arguments.source.shown.lang();
    if arguments.files.iter().any(|file| input::is_stream(file)) {
        return Err(Error::Usage(Using::WatchInput.in_lang(lang).to_string()));
    }
    interrupt::catch();
    let programs = arguments.files.iter().map(PathBuf::as_path);
    let mut watch = Watch::begin(programs.chain(arguments.source.robot().file()))?;
    let is_human = arguments.source.shown.message_format == Format::Human;
    let says = |message: Checking| {
        if is_human {
            report::complain(&format!("{RULE} {} {RULE}\n", message.in_lang(lang)));
        }
    };
    for count in 2.. {
        watch.extend(arguments.files.iter().flat_map(|file| project::files(file)));
        once(arguments)?;
        let files = arguments.files.len().into();
        says(Checking::Watching { files });
        if !watch.changed() {
            break;
        }
        if is_human && io::stderr().is_terminal() {
            report::clear();
        }
        says(Checking::Again { count });
    }
    Ok(Status::Interrupted)
}

/// What parts the findings of one check from those of the next.
const RULE: &str = "────────";

/// Checks each file; one that does not load makes the whole command fail.
fn once(arguments: &Check) -> Result<Status, Error> {
    let shown = arguments.source.shown;
    let mut total = report::Total::new(shown, arguments.quiet);
    let mut status = Status::Success;
    let mut fixable = fix::Fixable::default();
    for file in &arguments.files {
        let mut source = arguments.source.clone();
        let given = source.complete(file).map_err(NotLoaded::Found);
        let found = given.and_then(|_| match arguments.least() {
            Some(least) => {
                let robot = source.robot().load()?.simulated()?;
                let loaded = fix::fix(file, &source, &robot, least, &total)?;
                Ok((loaded, source.options(robot.options().robot)))
            }
            None => {
                let subject = loader::check(file, &source)?;
                let options = source.options(subject.chosen.robot());
                let loaded = fix::offered(subject.loaded, &options, shown);
                total.check(&loaded, shown)?;
                Ok((loaded, options))
            }
        });
        let (loaded, options) = match found {
            Ok(found) => found,
            Err(NotLoaded::Found(loaded)) => {
                total.check(&loaded, shown)?;
                total.add(&loaded);
                total.report(shown)?;
                return Ok(Status::Failure);
            }
            Err(NotLoaded::Failed(error)) => return Err(error),
        };
        total.add(&loaded);
        fixable.add(&loaded, &options, shown);
        if arguments.deny.refuses(&loaded) || loaded.program.is_none() {
            status = Status::Failure;
        }
    }
    total.report(shown)?;
    fixable.report(shown);
    Ok(status)
}
