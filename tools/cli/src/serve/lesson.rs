//! The page of `tip drives record`: it shows the robot that is taught. Nobody teaches from it; its emergency stop is for everybody.

use super::connections::{self, Content};
use super::hub::{Hub, LiveSession, Outbox};
use super::place::Place;
use crate::error::Error;
use crate::message::Using;
use crate::report;
use std::net::SocketAddr;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use tip_sim::Robot;
use tip_view::live::{ClientRequest, LessonSession, LessonState, Viewer};
use tipc::message::Lang;

/// Time between two postures of the page.
const SHOWN_EVERY: Duration = Duration::from_millis(50);

/// The angles of the joints, deg, and the state of the lesson.
type Shown = Mutex<Option<(Vec<f64>, LessonState)>>;

/// The page of a lesson, which other threads serve.
pub(crate) struct LessonPage {
    /// The newest posture and state, until the page has taken them.
    shown: Arc<Shown>,
    due: Instant,
}

impl LessonPage {
    /// Claims an address, and returns a function that opens the page: it prints the address, and lets viewers in. `stop` becomes true
    /// at an emergency stop.
    pub(crate) fn at(
        listen: SocketAddr,
    ) -> Result<impl FnOnce(&Robot, &str, Arc<AtomicBool>, Lang) -> Self, Error> {
        let place = Place::bind(listen)?;
        Ok(move |robot: &Robot, name: &str, stop, lang| {
            // Standard output may be the program.
            report::complain(&format!("{}\n", place.guard.address()));
            if !place.guard.is_local() {
                report::say(Using::LessonOthers, lang);
            }
            place.invite();
            let shown = Arc::<Shown>::default();
            let lesson = Lesson {
                session: LessonSession::new(robot, name),
                shown: Arc::clone(&shown),
                stop,
            };
            let (hub, sender) = Hub::new(lesson, robot.clone(), None);
            connections::accept(place.listener, place.guard, Content::Run(sender));
            thread::spawn(move || hub.run());
            LessonPage {
                shown,
                due: Instant::now(),
            }
        })
    }

    /// Shows a posture and a state now and then.
    pub(crate) fn show(&mut self, state: impl FnOnce() -> (Vec<f64>, LessonState)) {
        let now = Instant::now();
        if now >= self.due {
            self.due = now + SHOWN_EVERY;
            let state = state();
            *self.shown.lock().unwrap_or_else(PoisonError::into_inner) = Some(state);
        }
    }
}

/// The session of the page.
struct Lesson {
    session: LessonSession,
    shown: Arc<Shown>,
    stop: Arc<AtomicBool>,
}

impl LiveSession for Lesson {
    fn advance(&mut self, _: Duration, _: &dyn Fn() -> bool) {
        let mut shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((angles, state)) = shown.take() {
            self.session.show(&angles, state);
        }
    }

    fn ask(&mut self, _: &Outbox, asked: &ClientRequest) -> Option<String> {
        if asked.is_stop() {
            self.stop.store(true, Ordering::Relaxed);
        }
        Some(self.session.ask(asked))
    }

    fn update(&self, _: &Outbox, viewer: &mut Viewer) -> Option<String> {
        self.session.update(viewer)
    }
}
