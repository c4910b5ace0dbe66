//! The one thread that holds the session: it lets time pass, hands over requests, and gives each viewer what it does not know.

use super::file::ServedFile;
use super::is_over;
use super::outbox::Outbox;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::time::{Duration, Instant};
use tip_view::live::{Host, Session, Viewer};

/// How often the run goes on.
const TICK: Duration = Duration::from_millis(4);
/// How long it goes on at most before others have their turn.
const TURN: Duration = Duration::from_millis(20);
/// How many requests wait; viewers wait with the next ones.
const WAITING: usize = 64;

/// What the hub receives.
pub(super) enum News {
    /// A viewer has come.
    Came(Arc<Outbox>),
    /// A viewer asks for something.
    Asked(Arc<Outbox>, String),
    /// The file may have changed.
    FileChanged,
}

/// The session, and who looks at it.
pub(super) struct Hub {
    session: Session,
    file: ServedFile,
    news: Receiver<News>,
    viewers: Vec<(Arc<Outbox>, Viewer)>,
}

impl Hub {
    /// A hub that hears what is sent there.
    pub(super) fn new(session: Session, file: ServedFile) -> (Self, SyncSender<News>) {
        let (sender, news) = sync_channel(WAITING);
        let hub = Hub {
            session,
            file,
            news,
            viewers: Vec::new(),
        };
        (hub, sender)
    }

    /// Runs until Ctrl-C; then the viewers are sent away.
    pub(super) fn run(mut self) {
        let mut last = Instant::now();
        while !is_over() {
            self.hear(last + TICK);
            let now = Instant::now();
            let elapsed = now - std::mem::replace(&mut last, now);
            let turn = now + TURN;
            let goes_on = || Instant::now() < turn;
            self.session
                .advance(elapsed.as_secs_f64() * 1000.0, goes_on);
            self.tell();
        }
        for (outbox, _) in &self.viewers {
            outbox.close();
        }
        let end = Instant::now() + Duration::from_millis(500);
        let is_here = |outbox: &Arc<Outbox>| Arc::strong_count(outbox) > 1;
        while self.viewers.iter().any(|(outbox, _)| is_here(outbox)) && Instant::now() < end {
            std::thread::sleep(TICK);
        }
    }

    /// Does what is asked until a time, but not much longer.
    fn hear(&mut self, until: Instant) {
        for _ in 0..WAITING {
            let left = until.saturating_duration_since(Instant::now());
            match self.news.recv_timeout(left) {
                Ok(News::Came(outbox)) => self.viewers.push((outbox, Viewer::default())),
                Ok(News::Asked(outbox, text)) => {
                    outbox.put(self.session.request(&text, &mut self.file));
                }
                Ok(News::FileChanged) => {
                    if let Ok(bytes) = self.file.read() {
                        self.session.file_changed(&bytes);
                    }
                }
                Err(RecvTimeoutError::Timeout) => return,
                Err(RecvTimeoutError::Disconnected) => {
                    std::thread::sleep(left);
                    return;
                }
            }
        }
    }

    /// Gives each viewer what it does not know, as far as it takes it.
    fn tell(&mut self) {
        let is_here = |outbox: &Arc<Outbox>| !outbox.is_closed() && Arc::strong_count(outbox) > 1;
        self.viewers.retain(|(outbox, _)| is_here(outbox));
        for (outbox, viewer) in &mut self.viewers {
            while outbox.has_room() {
                let Some(update) = self.session.update(viewer) else {
                    break;
                };
                outbox.put(update);
            }
        }
    }
}
