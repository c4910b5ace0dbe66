//! `cargo run -p special`: see the README beside it.
#![allow(
    clippy::disallowed_macros,
    clippy::disallowed_methods,
    reason = "an example talks to people"
)]

use special::run::{Plant, Run, interpreter, run};
use special::{Dance, SOURCE};
use std::error::Error;
use std::io::{self, Write};
use std::process::ExitCode;
use tip_runtime::model::titan8;
use tip_runtime::record::Ending;

fn main() -> Result<ExitCode, Box<dyn Error>> {
    let plant = Plant::new(&titan8::MODEL);
    let compiled = run(Dance::new(), plant.clone())?;
    let text = interpreter("dance.prg", SOURCE).ok_or("dance.prg has errors")?;
    let interpreted = run(text, plant)?;

    let identical = compiled.trace == interpreted.trace;
    let mut out = io::stdout();
    writeln!(out, "{}", compiled.said.join("\n"))?;
    report(&mut out, &compiled, identical)?;
    let good = identical && matches!(compiled.ending, Ending::Program(_));
    Ok(if good {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    })
}

/// Prints the body's path, the run's end, and whether both engines agree.
fn report(out: &mut dyn Write, run: &Run, identical: bool) -> io::Result<()> {
    writeln!(
        out,
        "\nbody   {:.1} mm from its start at most, {:.1} mm in the end\n\
         slip   {:.2} mm at most of a foot that carries",
        run.excursion(),
        run.rest(),
        run.plant.worst_slip()
    )?;
    if let Ending::Emergency(emergency) = run.ending {
        writeln!(out, "end    {emergency}")?;
    }
    if identical {
        let records = run.trace.lines().count();
        writeln!(
            out,
            "traces identical: {records} records, compiled and interpreted"
        )
    } else {
        writeln!(out, "traces DIFFER")
    }
}
