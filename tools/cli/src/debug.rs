//! `tip debug`: a debugger on the terminal.

mod app;
mod figure;
mod screen;

#[cfg(test)]
mod tests;

use super::arguments::RunArguments;
use super::error::Error;
use super::{Status, interrupt, loader};
use crate::message::Using;
use app::App;
use clap::Args;
use ratatui::DefaultTerminal;
use ratatui::crossterm::event::{self, Event, KeyEventKind};
use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};
use tip_sim::debug::Debugger;

/// `tip debug`
#[derive(Debug, Args)]
#[command(after_long_help = "Examples:
  tip debug walk.prg                            stops before the first step
  tip debug walk.prg --events '120:key F'       a key is pressed before cycle 120
  tip debug --robot hand grasp.prg --scene scene.toml

Keys: r runs, n goes over the next step, s into routines, o out of one, c one control cycle,
l to the line of the cursor, g to a cycle; the same in capitals goes back. t looks at the next thread. b places and removes a
breakpoint, B one with a condition and a count of passes, f stops before each command, label or
routine of a name. w watches a variable, W goes back to the last assignment of one. i applies an event,
such as 'key F', 'VR1=8' or 'N = 5'; e shows the value of an expression. Esc interrupts, ? explains, q ends.")]
pub(super) struct Debug {
    #[command(flatten)]
    pub(super) run: RunArguments,
}

/// Time to wait for a key before checking for signals.
const PATIENCE: Duration = Duration::from_millis(200);

/// Time between two drawings of the screen while the program runs.
const FRAME: Duration = Duration::from_millis(40);

/// Number of control cycles between two looks at the keyboard.
const PORTION: u64 = 200;

/// Debugs a program until the user quits.
pub(super) fn debug(arguments: &Debug) -> Result<Status, Error> {
    let app = load(&arguments.run)?;
    if !io::stdin().is_terminal() || !io::stdout().is_terminal() {
        let reason = "tip debug needs a terminal; editors start tip dap";
        return Err(Error::Usage(reason.to_owned()));
    }
    interrupt::catch();
    // From here on a panic gives the terminal back, too.
    let terminal = ratatui::try_init();
    let done = terminal.and_then(|mut terminal| show(app, &mut terminal));
    ratatui::restore();
    interrupt::hold();
    match done {
        Ok(()) if interrupt::is_requested() => Ok(Status::Interrupted),
        Ok(()) => Ok(Status::Success),
        Err(error) => Err(Error::Failed(format!(
            "the terminal cannot be used: {error}"
        ))),
    }
}

fn load(run: &RunArguments) -> Result<App, Error> {
    let output_options = run.source.output_options;
    let refusal = Using::ProcessRunsOnce { command: "debug" };
    let subject = loader::load(&run.file, run, Some(refusal))?;
    let (subject, program) = loader::sound(subject, output_options, false)?;
    let usage = |refused: &dyn std::fmt::Display| Error::Usage(refused.to_string());
    let mut debugger = Debugger::new(program, &subject.robot)
        .map_err(|mismatch| usage(&mismatch))?
        .with_events(&run.inputs.inputs().events)
        .map_err(|refused| usage(&refused))?;
    debugger.stop_at_fall(true);
    let lang = output_options.lang();
    let source = subject.loaded.source;
    Ok(App::new(debugger, source, &subject.robot, lang))
}

/// Draws the screen and handles keys until the user quits.
fn show(mut app: App, terminal: &mut DefaultTerminal) -> io::Result<()> {
    let mut drawn = None;
    while !app.is_over() && !interrupt::is_requested() {
        let is_due = drawn.is_none_or(|at: Instant| at.elapsed() >= FRAME);
        if is_due || !app.is_going() {
            terminal.draw(|frame| screen::draw(&app, frame))?;
            drawn = Some(Instant::now());
        }
        let patience = match app.is_going() {
            true => Duration::ZERO,
            false => PATIENCE,
        };
        if event::poll(patience)? {
            if let Event::Key(key) = event::read()?
                && key.kind != KeyEventKind::Release
            {
                app::press(&mut app, key);
            }
        } else {
            app.work(PORTION);
        }
    }
    Ok(())
}
