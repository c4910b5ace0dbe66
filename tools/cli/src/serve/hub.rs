//! The one thread that holds the session: it lets time pass, hands over requests, and gives each viewer what it does not know.
//! What may take long is done elsewhere: viewers' threads read requests, and one thread checks texts.

use super::super::robot::ChosenRobot;
use super::file::ServedFile;
use super::is_over;
use super::outbox::Outbox;
use std::collections::VecDeque;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use tip_view::live::{Asked, Host, Reader, Reading, Session, Unread, Viewer};

/// How often the run goes on.
const TICK: Duration = Duration::from_millis(4);
/// How long it goes on at most before others have their turn.
const TURN: Duration = Duration::from_millis(20);
/// How many requests are heard before the run goes on.
const WAITING: usize = 64;
/// How many requests of one viewer wait for the thread that checks texts.
const QUESTIONS: usize = 8;

/// What the hub receives.
pub(super) enum News {
    /// A viewer has come.
    Came(Arc<Outbox>),
    /// A viewer asks for something, after so many emergency stops.
    Asked(Arc<Outbox>, Asked, u64),
    /// A text is checked.
    Checked(Reading),
    /// The file may have changed.
    FileChanged,
}

/// The way to the hub. Whoever sends never waits: viewers that send too much are refused.
#[derive(Clone)]
pub(super) struct Post {
    news: Sender<News>,
    stops: Sender<(Arc<Outbox>, Asked)>,
    /// How many emergency stops there were.
    stopped: Arc<AtomicU64>,
}

impl Post {
    /// Sends news; false if nobody hears them any more.
    pub(super) fn send(&self, news: News) -> bool {
        self.news.send(news).is_ok()
    }

    /// Passes on what a viewer asks for; false if nobody hears it any more.
    pub(super) fn ask(&self, outbox: &Arc<Outbox>, asked: Asked) -> bool {
        let outbox = Arc::clone(outbox);
        if asked.is_stop() {
            self.stopped.fetch_add(1, Ordering::Relaxed);
            return self.stops.send((outbox, asked)).is_ok();
        }
        if !outbox.begins() {
            outbox.put(asked.refused_many());
            return true;
        }
        let stops = self.stopped.load(Ordering::Relaxed);
        self.send(News::Asked(outbox, asked, stops))
    }
}

/// The session, and who looks at it.
pub(super) struct Hub {
    session: Session,
    file: ServedFile,
    news: Receiver<News>,
    /// Emergency stops, which overtake all other news.
    stops: Receiver<(Arc<Outbox>, Asked)>,
    stopped: Arc<AtomicU64>,
    desk: Arc<Desk>,
    viewers: Vec<(Arc<Outbox>, Viewer)>,
}

impl Hub {
    /// A hub that hears what is sent there.
    pub(super) fn new(mut session: Session, file: ServedFile, robot: ChosenRobot) -> (Self, Post) {
        let (news, received) = channel();
        let (stops, received_stops) = channel();
        let post = Post {
            news,
            stops,
            stopped: Arc::default(),
        };
        let desk = Arc::<Desk>::default();
        session.hand_over();
        let (own, sender) = (Arc::clone(&desk), post.clone());
        thread::spawn(move || {
            // It was made once already.
            if let Ok(robot) = robot.simulated() {
                own.work(Reader::new(robot), &sender);
            }
        });
        let hub = Hub {
            session,
            file,
            news: received,
            stops: received_stops,
            stopped: Arc::clone(&post.stopped),
            desk,
            viewers: Vec::new(),
        };
        (hub, post)
    }

    /// Runs until Ctrl-C; then the viewers are sent away.
    pub(super) fn run(mut self) {
        self.lay();
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
            self.stop();
            let left = until.saturating_duration_since(Instant::now());
            match self.news.recv_timeout(left) {
                Ok(news) => self.take(news),
                Err(RecvTimeoutError::Timeout) => break,
                Err(RecvTimeoutError::Disconnected) => {
                    thread::sleep(left);
                    break;
                }
            }
        }
        self.stop();
    }

    /// Does the emergency stops that have come.
    fn stop(&mut self) {
        while let Ok((outbox, asked)) = self.stops.try_recv() {
            if let Some(answer) = self.session.ask(&asked, &mut self.file) {
                outbox.put(answer);
            }
        }
    }

    fn take(&mut self, news: News) {
        match news {
            News::Came(outbox) => self.viewers.push((outbox, Viewer::default())),
            News::Asked(outbox, asked, stops) => self.fulfil(outbox, asked, stops),
            News::Checked(reading) => self.session.checked(reading),
            News::FileChanged => {
                if let Ok(bytes) = self.file.read() {
                    self.session.file_changed(&bytes);
                }
            }
        }
        self.lay();
    }

    /// Has the text checked if it is another one.
    fn lay(&mut self) {
        if let Some(unread) = self.session.unread() {
            self.desk.lay(unread);
        }
    }

    fn fulfil(&mut self, outbox: Arc<Outbox>, asked: Asked, stops: u64) {
        // A stop overtakes requests: what came before it moves no robot after it.
        let answer = if asked.moves() && stops != self.stopped.load(Ordering::Relaxed) {
            Some(asked.refused_stopped())
        } else {
            self.session.ask(&asked, &mut self.file)
        };
        match answer {
            Some(answer) => outbox.answer(answer),
            None => self.desk.ask(outbox, asked, stops),
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

/// What waits for the thread that checks texts and answers an editor's questions about them.
#[derive(Default)]
struct Desk {
    waiting: Mutex<Waiting>,
    comes: Condvar,
}

#[derive(Default)]
struct Waiting {
    /// The newest text; an older one that nobody has begun to check is left out.
    text: Option<Unread>,
    asked: VecDeque<(Arc<Outbox>, Asked, u64)>,
}

impl Desk {
    fn lay(&self, text: Unread) {
        self.waiting().text = Some(text);
        self.comes.notify_one();
    }

    fn ask(&self, outbox: Arc<Outbox>, asked: Asked, stops: u64) {
        let mut waiting = self.waiting();
        let own = waiting
            .asked
            .iter()
            .filter(|(other, ..)| Arc::ptr_eq(other, &outbox));
        if own.count() >= QUESTIONS {
            drop(waiting);
            outbox.answer(asked.refused_many());
        } else {
            waiting.asked.push_back((outbox, asked, stops));
            self.comes.notify_one();
        }
    }

    /// Checks each text before it answers what was asked about it, until the hub ends.
    fn work(&self, mut reader: Reader, post: &Post) {
        let mut goes_on = true;
        while goes_on {
            let mut waiting = self.waiting();
            if let Some(text) = waiting.text.take() {
                drop(waiting);
                goes_on = post.send(News::Checked(reader.read(text)));
            } else if let Some((outbox, asked, stops)) = waiting.asked.pop_front() {
                drop(waiting);
                match reader.answer(&asked) {
                    Some(answer) => outbox.answer(answer),
                    // The text that it was to wait for is checked.
                    None => goes_on = post.send(News::Asked(outbox, asked, stops)),
                }
            } else {
                let woken = self.comes.wait(waiting);
                drop(woken.unwrap_or_else(PoisonError::into_inner));
            }
        }
    }

    fn waiting(&self) -> std::sync::MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
