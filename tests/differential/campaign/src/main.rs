//! `--programs N` runs programs until N are done, those of earlier calls included; `mass --programs N` does so on walking
//! robots with mass; `flavours --programs N` compares builds; `report` prints what is done, `mass report` with mass.
//! `3.2` before these words means programs of that edition.

use campaign::batch::Effort;
use campaign::build::{Flavour, Workshop};
use campaign::hunt::{differing, shrink};
use campaign::progress::{Progress, time_left};
use campaign::report::report;
use lockstep::Figures;
use random_programs::{Edition, Specimen, program};
use signal_hook::consts::{SIGINT, SIGTERM};
use signal_hook::flag;
use std::collections::BTreeMap;
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};
use std::time::Instant;
use std::{env, fs, io};

/// Files of the figures of both campaigns.
const FIGURES: &str = "figures";
const HEAVY_FIGURES: &str = "figures-mass";

/// Programs per build.
const BATCH: u64 = 1000;

/// Runs of every program.
const EFFORT: Effort = Effort {
    runs: 2,
    cycles: 8_000,
    simulated_one_in: 10,
    simulated_cycles: 1000,
    heavy_cycles: 100,
};

/// Runs of every program of a walking robot in the campaign with mass.
const HEAVY: Effort = Effort {
    runs: 0,
    cycles: 0,
    simulated_one_in: 1,
    simulated_cycles: 0,
    heavy_cycles: 2000,
};

/// Every so many batches one is optimised, as users' programs are.
const OPTIMISED_ONE_IN: u64 = 20;

/// Ctrl-C was pressed; the batch that runs gets it too, and ends.
static INTERRUPTED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

fn main() -> ExitCode {
    for signal in [SIGINT, SIGTERM] {
        // The second one ends the process. Without handlers, the first one does.
        let _ = flag::register_conditional_shutdown(signal, 130, Arc::clone(&INTERRUPTED));
        let _ = flag::register(signal, Arc::clone(&INTERRUPTED));
    }
    let arguments: Vec<String> = env::args().skip(1).collect();
    let words: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let (edition, words) = match &words[..] {
        ["3.2", rest @ ..] => (Edition::V3_2, rest),
        rest => (Edition::V3_1, rest),
    };
    let figures = match edition {
        Edition::V3_1 => String::new(),
        later => format!("-{later}"),
    };
    let of = |kept: &str| format!("{kept}{figures}");
    let done = match *words {
        ["--programs", count] => {
            number(count).and_then(|count| campaign(edition, count, &of(FIGURES), &EFFORT))
        }
        ["mass", "--programs", count] => {
            number(count).and_then(|count| campaign(edition, count, &of(HEAVY_FIGURES), &HEAVY))
        }
        ["flavours", "--programs", count] => {
            number(count).and_then(|count| flavours(edition, count))
        }
        ["report"] => show(&of(FIGURES)),
        ["mass", "report"] => show(&of(HEAVY_FIGURES)),
        _ => Err(io::Error::other(
            "usage: campaign [3.2] [mass] --programs N | [3.2] flavours --programs N | [3.2] [mass] report",
        )),
    };
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(_) if INTERRUPTED.load(Ordering::Relaxed) => {
            eprintln!("interrupted; what is done is kept, and the next call continues after it");
            ExitCode::from(130)
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn number(text: &str) -> io::Result<u64> {
    text.parse().map_err(io::Error::other)
}

fn progress(workshop: &Workshop, kept: &str) -> Progress {
    Progress(workshop.papers().join(kept))
}

fn show(kept: &str) -> io::Result<bool> {
    let figures = progress(&Workshop::new(), kept).sum()?;
    print!("{}", report(&figures));
    Ok(figures.get("differences") == 0)
}

/// Goes through batch after batch, those done before left out.
fn campaign(edition: Edition, programs: u64, kept: &str, effort: &Effort) -> io::Result<bool> {
    let workshop = Workshop::new();
    let progress = progress(&workshop, kept);
    let batches = programs.div_ceil(BATCH);
    let open: Vec<u64> = (0..batches).filter(|batch| !progress.has(*batch)).collect();
    let begin = Instant::now();
    for (done, &batch) in (1..).zip(&open) {
        if INTERRUPTED.load(Ordering::Relaxed) {
            return Err(io::ErrorKind::Interrupted.into());
        }
        let flavour = match batch % OPTIMISED_ONE_IN {
            1 => Flavour::Optimised,
            _ => Flavour::Quick,
        };
        let mut specimens =
            specimens(edition, batch * BATCH, BATCH.min(programs - batch * BATCH));
        specimens.retain(|specimen| effort.concerns(specimen.robot));
        let printed = workshop.run(&specimens, flavour, effort)?;
        for (place, told) in differing(&specimens, &printed) {
            keep(&workshop, flavour, effort, &specimens[place], &told)?;
        }
        let figures = Figures::parse(&printed);
        let left = u32::try_from(open.len()).unwrap_or(u32::MAX) - done;
        eprintln!(
            "batch {batch} of {batches}: {} cycles, {} differences, {} left",
            figures.get("cycles"),
            figures.get("differences"),
            time_left(begin.elapsed(), done, left)
        );
        progress.keep(batch, &figures)?;
    }
    show(kept)
}

fn specimens(edition: Edition, first: u64, count: u64) -> Vec<Specimen> {
    let seeds = first..first + count;
    seeds.map(|seed| program(edition, seed)).collect()
}

/// Shrinks a program and writes it down as a case of the language.
fn keep(
    workshop: &Workshop,
    flavour: Flavour,
    effort: &Effort,
    specimen: &Specimen,
    told: &str,
) -> io::Result<()> {
    let (specimen, told) = shrink(workshop, flavour, effort, specimen, told)?;
    let folder = workshop.package.join("found");
    let (first, rest) = told.split_once('\n').unwrap_or((&told, ""));
    let options = first.splitn(3, ' ').nth(2).unwrap_or_default();
    let robot = specimen.robot.name();
    let header = format!("# clauses: \n# args: --robot {robot} {options}\n");
    let sides: String = rest.lines().map(|line| format!("# {line}\n")).collect();
    fs::create_dir_all(&folder)?;
    fs::write(
        folder.join(format!("seed_{}.prg", specimen.seed)),
        &specimen.source,
    )?;
    fs::write(
        folder.join(format!("seed_{}.trace", specimen.seed)),
        format!("{header}{sides}...\n"),
    )?;
    eprintln!(
        "seed {} differs:\n{}\n{told}",
        specimen.seed, specimen.source
    );
    Ok(())
}

/// Every flavour of build gives the same fingerprints.
fn flavours(edition: Edition, programs: u64) -> io::Result<bool> {
    let workshop = Workshop::new();
    let specimens = specimens(edition, 0, programs);
    let effort = Effort {
        cycles: 1000,
        ..EFFORT
    };
    let mut outcomes: BTreeMap<String, Vec<Flavour>> = BTreeMap::new();
    for flavour in [
        Flavour::Quick,
        Flavour::Optimised,
        Flavour::Debug,
    ] {
        let printed = workshop.run(&specimens, flavour, &effort)?;
        eprintln!(
            "{flavour:?}: {} cycles",
            Figures::parse(&printed).get("cycles")
        );
        outcomes.entry(printed).or_default().push(flavour);
    }
    for flavours in outcomes.values() {
        println!("the same to the bit: {flavours:?}");
    }
    Ok(outcomes.len() == 1)
}
