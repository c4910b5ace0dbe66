//! What is said of a stop and of a mode.

use super::app::App;
use tip_runtime::controller::Mode;
use tip_sim::debug::{By, Reason};
use tipc::message::Debugging;

/// Where and why the program stands, or that it runs.
pub(crate) fn state(app: &App) -> String {
    if let Some(progress) = app.progress.filter(|_| app.is_going()) {
        let percent = progress.done.saturating_mul(100) / progress.of.unwrap_or(1).max(1);
        let percent = u32::try_from(percent.min(100)).unwrap_or(100);
        return app.say(Debugging::Searching { percent });
    }
    if app.is_going() {
        return app.say(Debugging::Running);
    }
    app.say(match &app.debugger.stop().reason {
        Reason::Start => Debugging::Start,
        Reason::Step => Debugging::Stepped,
        Reason::There => Debugging::There,
        Reason::Breakpoint(_) => Debugging::AtBreakpoint,
        Reason::Watch {
            by: By::Step(step), ..
        } => Debugging::Assigned {
            line: app.debugger.run().program().line(*step),
        },
        Reason::Watch { by: By::Event, .. } => Debugging::AssignedByEvent,
        Reason::Fall(_) => Debugging::Fell,
        Reason::Fault(emergency) => return emergency.to_string(),
        Reason::Ended(_) => Debugging::Ended,
        Reason::Change => Debugging::Changed,
        _ => Debugging::Interrupted,
    })
}

/// How something is controlled.
pub(crate) fn mode(mode: Mode) -> Debugging {
    match mode {
        Mode::Rest => Debugging::AtRest,
        Mode::Position => Debugging::Position,
        Mode::Compliance => Debugging::Compliance,
        Mode::Velocity => Debugging::Velocity,
        Mode::Effort => Debugging::Effort,
    }
}
