//! `tip check --fix`: files with their fixes, and what can be fixed.

use super::arguments::SourceArguments;
use super::choices::Format;
use super::error::Error;
use super::report::Total;
use super::shown::Shown;
use super::{input, loader, output, report};
use std::path::Path;
use tip_lint::message::Fixing;
use tip_lint::repair::{Repaired, confirm, preview, render_json, render_short, repair};
use tip_runtime::printable::Printable;
use tip_sim::Robot;
use tipc::diagnostic::Applicability;
use tipc::{Loaded, Options};

/// Applies fixes to a program and writes it if there were any; what is left is reported and returned.
pub(super) fn fix(
    path: &Path,
    source: &SourceArguments,
    robot: &Robot,
    least: Applicability,
    total: &Total,
) -> Result<Loaded, Error> {
    let shown = source.shown;
    let options = source.options(robot.options().robot);
    let loaded = input::load(path, &options);
    let read = loaded.source.bytes();
    let repaired = repair(loaded, &options, least);
    let said = said(&repaired, shown);
    let Repaired {
        applied,
        mut loaded,
    } = repaired;
    loader::warn(&mut loaded, path, source, robot);
    // Standard output is the program's.
    if input::is_stream(path) && input::was_read(&loaded) {
        output::print(loaded.source.bytes())?;
        report::complain(&said);
        report::findings(&loaded, shown);
        return Ok(loaded);
    }
    if !applied.is_empty() {
        output::update(path, &read, &loaded.source.bytes(), shown.lang())?;
    }
    match shown.message_format {
        Format::Human => report::complain(&said),
        Format::Short | Format::Json => output::print(&said)?,
        // Standard output holds one document of what is left.
        Format::Sarif => (),
    }
    let loaded = offered(loaded, &options, shown);
    total.check(&loaded, shown)?;
    Ok(loaded)
}

/// Of what tools are offered, the fixes that do what they say.
pub(super) fn offered(loaded: Loaded, options: &Options, shown: Shown) -> Loaded {
    match shown.message_format {
        Format::Json | Format::Sarif => confirm(loaded, options),
        Format::Human | Format::Short => loaded,
    }
}

/// What was fixed: for people how much, for tools each in a line.
fn said(repaired: &Repaired, shown: Shown) -> String {
    let lang = shown.lang();
    match shown.message_format {
        Format::Human if repaired.applied.is_empty() => String::new(),
        Format::Human => {
            let findings = repaired.applied.len().into();
            let fixed = Fixing::Fixed { findings };
            let name = Printable::line(repaired.loaded.source.name());
            format!("{name}: {}\n", fixed.in_lang(lang))
        }
        Format::Short => render_short(repaired, lang),
        Format::Json => render_json(repaired, lang),
        Format::Sarif => String::new(),
    }
}

/// How many findings of some files can be fixed.
#[derive(Debug, Default)]
pub(super) struct Fixable {
    certain: usize,
    all: usize,
}

impl Fixable {
    /// Another file, and what is found in it.
    pub(super) fn add(&mut self, loaded: &Loaded, options: &Options, shown: Shown) {
        let is_known = loaded.diagnostics.iter().any(|one| !one.fixes.is_empty());
        if !is_known || shown.message_format != Format::Human {
            return;
        }
        let certain = preview(loaded.clone(), options, Applicability::Certain);
        let likely = preview(certain.loaded, options, Applicability::Likely);
        self.certain += certain.applied.len();
        self.all += certain.applied.len() + likely.applied.len();
    }

    /// Says so, for people.
    pub(super) fn report(self, shown: Shown) {
        let findings = self.certain.into();
        let can = match (self.certain, self.all) {
            (_, 0) => return,
            (0, all) => Fixing::CanFixLikely {
                findings: all.into(),
            },
            (certain, all) if all > certain => Fixing::CanFixMore { findings, all },
            _ => Fixing::CanFix { findings },
        };
        report::complain(&format!("{}\n", can.in_lang(shown.lang())));
    }
}
