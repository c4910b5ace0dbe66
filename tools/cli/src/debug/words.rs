//! What is said of a stop.

use super::app::App;
use tip_sim::debug::{By, Reason};
use tip_sim::message::Debugging;

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
