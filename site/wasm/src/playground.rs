//! The session of one page.

use crate::setup::Wanted;
use serde_json::json;
use tip_sim::{Interpreter, Limit, Run};
use tip_view::live::{NoFile, Session, Setup, Viewer};

/// Program that runs while the requested text has errors.
const NOTHING: &str = "3.1\n\nEND\n";

/// A session and the one page that looks at it; nothing at first.
#[derive(Debug, Default)]
pub struct Playground {
    session: Option<Session>,
    viewer: Viewer,
}

impl Playground {
    /// Begins a session with what is wanted, a [`Wanted`] in JSON, in the place of the one before. Its run plays. A text with
    /// errors stands in the editor, and runs when it is put right.
    ///
    /// # Errors
    /// It cannot be had, in words for people; the session before goes on.
    pub fn open(&mut self, wanted: &str) -> Result<(), String> {
        let wanted: Wanted = serde_json::from_str(wanted).map_err(|error| error.to_string())?;
        let bench = wanted.bench()?;
        let name = &wanted.program.name;
        let text = wanted.program.text.as_deref().unwrap_or_default();
        let setup = |text: &str| Setup {
            events: bench.events.clone(),
            ..Setup::new(name, text.as_bytes(), bench.robot.clone())
        };
        let impossible = |_| "an event cannot happen to this robot".to_owned();
        let mut session = match bench.loaded.program {
            Some(_) => Session::new(setup(text)).map_err(impossible)?,
            None => {
                let mut session = Session::new(setup(NOTHING)).map_err(impossible)?;
                let edit = json!({ "do": "edit", "text": text, "base": 1, "by": "" });
                session.request(&edit.to_string(), &mut NoFile);
                session
            }
        };
        session.play();
        self.session = Some(session);
        self.viewer = Viewer::default();
        Ok(())
    }

    /// So much time has passed for the page: ms. The run goes on as long as `goes_on` agrees.
    pub fn advance(&mut self, elapsed: f64, goes_on: impl FnMut() -> bool) {
        if let Some(session) = &mut self.session {
            session.advance(elapsed, goes_on);
        }
    }

    /// Does what the page asks for, and answers; nothing without a session.
    pub fn request(&mut self, request: &str) -> Option<String> {
        let session = self.session.as_mut()?;
        Some(session.request(request, &mut NoFile))
    }

    /// Returns the updates that the page has not received, or none.
    pub fn update(&mut self) -> Option<String> {
        self.session.as_ref()?.update(&mut self.viewer)
    }
}

/// The trace of a run as `tip run --trace --trace-state` writes it, of a [`Wanted`] in JSON.
///
/// # Errors
/// It cannot run, in words for people.
pub fn trace(wanted: &str) -> Result<String, String> {
    let wanted: Wanted = serde_json::from_str(wanted).map_err(|error| error.to_string())?;
    let bench = wanted.bench()?;
    let program = bench.loaded.program.ok_or("there is no program")?;
    let run =
        Run::new(Interpreter::new(program), bench.robot).map_err(|error| error.to_string())?;
    let run = run.with_trace(true).with_events(&bench.events);
    let mut run = run.map_err(|error| error.to_string())?;
    run.to_end(wanted.cycles.map_or(Limit::NONE, Limit::cycles));
    Ok(run.trace())
}
