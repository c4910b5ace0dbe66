//! From a program whose engines part to the shortest that still shows it.

use crate::batch::Effort;
use crate::build::{Flavour, Workshop};
use random_programs::Specimen;
use std::collections::BTreeSet;
use std::io;
use tipc::Options;

/// Returns the differing programs of a batch's output: index in the batch, and text.
pub fn differing(specimens: &[Specimen], printed: &str) -> Vec<(usize, String)> {
    let mut place = 0;
    let mut found: Vec<(usize, String)> = Vec::new();
    for line in printed.lines() {
        if line.starts_with("same ") {
            place += 1;
        } else if line.starts_with("differs ") {
            found.push((place, format!("{line}\n")));
            place += 1;
        } else if let (Some((_, text)), Some(more)) = (found.last_mut(), line.strip_prefix("| ")) {
            text.push_str(more);
            text.push('\n');
        }
    }
    assert_eq!(
        place,
        specimens.len(),
        "a line for each program:\n{printed}"
    );
    found
}

/// Leaves statements out as long as the engines still part. Each round compiles all that could be next in one batch.
///
/// # Errors
/// A batch cannot be built.
pub fn shrink(
    workshop: &Workshop,
    flavour: Flavour,
    effort: &Effort,
    specimen: &Specimen,
    told: &str,
) -> io::Result<(Specimen, String)> {
    let mut best = (specimen.clone(), told.to_owned());
    loop {
        let shorter = candidates(&best.0);
        if shorter.is_empty() {
            return Ok(best);
        }
        let printed = workshop.run(&shorter, flavour, effort)?;
        let found = differing(&shorter, &printed);
        let shortest = found
            .into_iter()
            .min_by_key(|(place, _)| shorter[*place].source.len());
        match shortest {
            Some((place, told)) => best = (shorter[place].clone(), told),
            None => return Ok(best),
        }
    }
}

/// Returns a program without some of its lines, if it loads.
fn candidates(specimen: &Specimen) -> Vec<Specimen> {
    let lines: Vec<&str> = specimen.source.lines().collect();
    let without = |gone: &dyn Fn(usize) -> bool| {
        let kept = (0..).zip(&lines).filter(|(n, _)| !gone(*n));
        kept.map(|(_, line)| format!("{line}\n"))
            .collect::<String>()
    };
    let mut sources = BTreeSet::new();
    let mut size = lines.len() / 2;
    while size > 0 {
        for from in (2..lines.len()).step_by(size.div_ceil(2)) {
            sources.insert(without(&|n| (from..from + size).contains(&n)));
        }
        size /= 2;
    }
    // The two ends of a block, without what is in it.
    for (first, line) in lines.iter().enumerate().skip(2) {
        let depth = indent(line);
        let mut behind = lines.iter().enumerate().skip(first + 1);
        if let Some((last, _)) = behind.find(|(_, line)| indent(line) <= depth) {
            sources.insert(without(&|n| n == first || n == last));
        }
    }
    sources.remove(&specimen.source);
    let with_source = |source| Specimen {
        source,
        ..specimen.clone()
    };
    sources.into_iter().map(with_source).filter(loads).collect()
}

fn indent(line: &str) -> usize {
    line.len() - line.trim_start().len()
}

fn loads(specimen: &Specimen) -> bool {
    let options = Options {
        robot: specimen.robot,
        ..Options::default()
    };
    tipc::load("candidate.prg", specimen.source.as_bytes(), &options)
        .program
        .is_some()
}
