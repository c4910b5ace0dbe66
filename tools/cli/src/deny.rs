//! What makes a command fail although it need not: `--deny`.

use super::report::{self, plural};
use clap::Args;
use tipc::Loaded;
use tipc::code::{Code, Level};
use tipc::language::Edition;

/// What the command line denies.
#[derive(Clone, Debug, Args)]
pub(super) struct Deny {
    /// Fail over these: the codes of warnings, as W112; 'warnings' for all of them; 'falls' of the robot in a run
    #[arg(long, value_name = "WHAT,...", value_delimiter = ',', value_parser = denial)]
    deny: Vec<Denial>,
}

/// One thing that is denied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Denial {
    /// The robot fell, or would have: its body came down, or its support was lost.
    Falls,
    /// Every warning.
    Warnings,
    /// A warning.
    Warning(Code),
}

const FALLS: &str = "falls";
const WARNINGS: &str = "warnings";

fn denial(word: &str) -> Result<Denial, String> {
    let warnings = || {
        let codes = Code::ALL.iter().copied();
        codes.filter(|code| code.level(Edition::default()) == Level::Warning)
    };
    match word {
        FALLS => Ok(Denial::Falls),
        WARNINGS => Ok(Denial::Warnings),
        _ => match warnings().find(|code| code.id().eq_ignore_ascii_case(word)) {
            Some(code) => Ok(Denial::Warning(code)),
            None => {
                let codes: Vec<&str> = warnings().map(Code::id).collect();
                let codes = codes.join(", ");
                Err(format!(
                    "what can be denied is {FALLS}, {WARNINGS}, {codes}"
                ))
            }
        },
    }
}

impl Deny {
    /// Whether a fall fails a run.
    pub(super) fn falls(&self) -> bool {
        self.deny.contains(&Denial::Falls)
    }

    /// Whether a program has a warning that is denied; which ones is reported.
    pub(super) fn refuses(&self, loaded: &Loaded) -> bool {
        let is_denied = |code: Code| {
            code.level(Edition::default()) == Level::Warning
                && (self.deny.contains(&Denial::Warnings)
                    || self.deny.contains(&Denial::Warning(code)))
        };
        let codes = loaded.diagnostics.iter().map(|finding| finding.code);
        let mut denied: Vec<Code> = codes.filter(|code| is_denied(*code)).collect();
        let omitted = loaded.omitted.codes();
        let omitted = omitted.filter(|(code, _)| is_denied(*code));
        let mut count = denied.len();
        for (code, more) in omitted {
            denied.push(code);
            count += more;
        }
        denied.sort_unstable();
        denied.dedup();
        if count > 0 {
            let codes: Vec<&str> = denied.into_iter().map(Code::id).collect();
            let (name, codes) = (loaded.source.name(), codes.join(", "));
            let warnings = plural(count, "denied warning");
            report::complain(&format!("error: {name}: {warnings}: {codes}\n"));
        }
        count > 0
    }
}
