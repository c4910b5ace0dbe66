//! A run that goes on while people look at it and act on it: requests in, updates out.
//!
//! A [`Session`] uses no clock, no file and no network. Its host tells it how much time has passed
//! ([`Session::advance`]), hands over requests of viewers ([`Session::request`]) and takes the update for each of them
//! ([`Session::update`]). Requests and updates are JSON objects; `page/src/session.js` lists them. A viewer that looks
//! seldom gets fewer and larger updates; nothing waits for it.
//!
//! A [`DrivenSession`] shows a run on the servos of a real robot, which goes forward alone. A [`Driver`] decides which of its viewers
//! drives the robot, and what the silence of that one leads to. A [`LessonSession`] shows a robot that a hand teaches.
//!
//! ```
//! use tip_view::live::{NoFile, Session, Setup, Viewer};
//! use tip_view::tip_sim::Robot;
//!
//! let robot = Robot::named("titan8")?;
//! let setup = Setup::new("wave.prg", b"3.1\nwaves\nAGAIN:\nSLEEP 20\nGOTO AGAIN:\nEND\n", robot);
//! let mut session = Session::new(setup).map_err(|loaded| format!("{:?}", loaded.diagnostics))?;
//! let mut viewer = Viewer::default();
//! let first = session.update(&mut viewer).expect("it has seen nothing");
//! assert!(first.starts_with(r#"{"type":"run","#));
//! let answer = session.request(r#"{"do":"play","id":1}"#, &mut NoFile);
//! assert_eq!(answer, r#"{"type":"answer","id":1,"ok":true}"#);
//! session.advance(1000.0, || true);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod driven;
mod driver;
mod lesson;
mod request;
mod runner;
mod session;
mod text;
mod viewer;

pub use driven::{DrivenSession, LetRest, Order, Phase, Prepared, RobotState, ServoState};
pub use driver::{ARMING, Driver, Rules, SIGN, STICKS, Sign, Stage};
pub use lesson::{LessonPhase, LessonSession, LessonState};
pub use request::{ClientRequest, Driving};
pub use session::{Session, Setup};
pub use text::{CheckedText, TextChecker, UncheckedText};
pub use viewer::Viewer;

/// The most bytes that a request may have; the text of a program takes most of it.
pub const MOST_BYTES: usize = 2 << 20;

/// Returns the page that shows a session at the other end of a WebSocket: `/live` of the server
/// that it comes from, with the same query.
pub fn page() -> String {
    crate::page::live()
}

/// The file of the program, which only the one who holds the session can reach.
pub trait Host {
    /// Gives the file these bytes, all of them or none.
    ///
    /// # Errors
    /// The reason, in words for the viewer.
    fn write(&mut self, bytes: &[u8]) -> Result<(), String>;

    /// Reads the present bytes of the file.
    ///
    /// # Errors
    /// The reason why it cannot be read, in words for the viewer.
    fn read(&mut self) -> Result<Vec<u8>, String>;
}

/// A host without a file: the program is only in the page.
#[derive(Clone, Copy, Debug, Default)]
pub struct NoFile;

impl Host for NoFile {
    fn write(&mut self, _: &[u8]) -> Result<(), String> {
        Err("there is no file".to_owned())
    }

    fn read(&mut self) -> Result<Vec<u8>, String> {
        Err("there is no file".to_owned())
    }
}
