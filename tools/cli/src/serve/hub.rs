//! The hub: the thread that owns the session. It lets time pass, handles requests, and fills the outbox of each viewer. Threads of
//! viewers parse requests, and one thread checks texts, so that the run goes on meanwhile.

use crate::interrupt;
use crate::serve::controls::Controls;
use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, Weak};
use std::thread;
use std::time::{Duration, Instant};
use tip_sim::Robot;
use tip_view::live::{CheckedText, ClientRequest, TextChecker, UncheckedText, Viewer};

/// Time between two advances of the run.
const TICK: Duration = Duration::from_millis(4);
/// Maximum time of an advance, so that requests are answered.
const TURN: Duration = Duration::from_millis(20);
/// Maximum number of requests between two advances.
const MAX_EVENTS: usize = 64;
/// Maximum number of requests of one viewer that wait for the thread that checks texts.
const MAX_QUESTIONS: usize = 8;

/// Time without requests to move after an emergency stop, until viewers other than the one that stopped the robot may move it: one
/// that asks again and again must not undo the stop.
const QUIET: Duration = Duration::from_secs(1);

/// An emergency stop that lasts.
struct Hold {
    by: Weak<Outbox>,
    /// The last request of another viewer to move the robot, or the stop.
    since: Instant,
}

/// An event of the hub.
pub(super) enum HubEvent {
    /// A viewer has joined.
    Joined(Arc<Outbox>),
    /// A viewer sent a request; the number is that of the emergency stops before it.
    ClientRequest(Arc<Outbox>, ClientRequest, u64),
    /// A text was checked.
    Checked(CheckedText),
    /// The file may have changed.
    FileChanged,
}

/// A session that a hub shows to viewers.
pub(super) trait LiveSession {
    /// Lets time pass, as long as `goes_on` agrees.
    fn advance(&mut self, elapsed: Duration, goes_on: &dyn Fn() -> bool);
    /// Does what a viewer asks for; no answer if the thread that checks texts has to give it, or to check the text first.
    fn ask(&mut self, viewer: &Outbox, asked: &ClientRequest) -> Option<String>;
    /// Returns the next update for a viewer; none if it has everything.
    fn update(&self, outbox: &Outbox, viewer: &mut Viewer) -> Option<String>;
    /// Returns the text that is to be checked, once.
    fn unchecked(&mut self) -> Option<UncheckedText> {
        None
    }
    /// Takes what was found in a text.
    fn checked(&mut self, _: CheckedText) {}
    /// Reads the file, which may have changed.
    fn file_changed(&mut self) {}
}

/// The sending end of the hub. It never blocks: viewers that send too much are refused.
#[derive(Clone)]
pub(super) struct HubSender {
    events: Sender<HubEvent>,
    stops: Sender<(Arc<Outbox>, ClientRequest)>,
    /// Number of emergency stops so far.
    stopped: Arc<AtomicU64>,
    /// The controls of a robot on servos: its driver and its emergency stop wait for no hub.
    controls: Option<Arc<Controls>>,
}

impl HubSender {
    /// Sends an event; returns false if the hub has ended.
    pub(super) fn send(&self, event: HubEvent) -> bool {
        self.events.send(event).is_ok()
    }

    /// Sends a request of a viewer; returns false if the hub has ended.
    pub(super) fn ask(&self, outbox: &Arc<Outbox>, asked: ClientRequest) -> bool {
        if let Some(controls) = &self.controls {
            if asked.is_stop() {
                controls.stop();
            }
            if let Some(driving) = asked.driving() {
                if let Some(answer) = controls.drive(outbox.number, driving, &asked) {
                    outbox.put(answer);
                }
                return true;
            }
        }
        let outbox = Arc::clone(outbox);
        if asked.is_stop() {
            self.stopped.fetch_add(1, Ordering::Relaxed);
            return self.stops.send((outbox, asked)).is_ok();
        }
        if !outbox.add_request() {
            outbox.put(asked.refused_many());
            return true;
        }
        let stops = self.stopped.load(Ordering::Relaxed);
        self.send(HubEvent::ClientRequest(outbox, asked, stops))
    }

    /// Tells that a viewer has left.
    pub(super) fn leave(&self, outbox: &Outbox) {
        if let Some(controls) = &self.controls {
            controls.leave(outbox.number);
        }
    }
}

/// The session and its viewers.
pub(super) struct Hub<S> {
    session: S,
    events: Receiver<HubEvent>,
    /// Emergency stops, which overtake all other events.
    stops: Receiver<(Arc<Outbox>, ClientRequest)>,
    stopped: Arc<AtomicU64>,
    hold: Option<Hold>,
    checks: Arc<CheckQueue>,
    viewers: Vec<(Arc<Outbox>, Viewer)>,
}

impl<S: LiveSession> Hub<S> {
    /// Returns a hub and its sending end. The session does not check texts.
    pub(super) fn new(
        session: S,
        robot: Robot,
        controls: Option<Arc<Controls>>,
    ) -> (Self, HubSender) {
        let (events, received) = channel();
        let (stops, received_stops) = channel();
        let sender = HubSender {
            events,
            stops,
            stopped: Arc::default(),
            controls,
        };
        let checks = Arc::<CheckQueue>::default();
        let (queue, own) = (Arc::clone(&checks), sender.clone());
        thread::spawn(move || queue.work(TextChecker::new(robot), &own));
        let hub = Hub {
            session,
            events: received,
            stops: received_stops,
            stopped: Arc::clone(&sender.stopped),
            hold: None,
            checks,
            viewers: Vec::new(),
        };
        (hub, sender)
    }

    /// Runs until Ctrl-C; then disconnects the viewers.
    pub(super) fn run(mut self) {
        self.queue_text();
        let mut last = Instant::now();
        while !interrupt::is_requested() {
            self.receive(last + TICK);
            let now = Instant::now();
            let elapsed = now - std::mem::replace(&mut last, now);
            let turn = now + TURN;
            self.session.advance(elapsed, &|| Instant::now() < turn);
            self.send_updates();
        }
        for (outbox, _) in &self.viewers {
            outbox.close();
        }
        let end = Instant::now() + Duration::from_millis(500);
        let is_here = |outbox: &Arc<Outbox>| Arc::strong_count(outbox) > 1;
        while self.viewers.iter().any(|(outbox, _)| is_here(outbox)) && Instant::now() < end {
            thread::sleep(TICK);
        }
    }

    /// Handles events until a time.
    fn receive(&mut self, until: Instant) {
        for _ in 0..MAX_EVENTS {
            self.handle_stops();
            let left = until.saturating_duration_since(Instant::now());
            match self.events.recv_timeout(left) {
                Ok(event) => self.handle(event),
                Err(RecvTimeoutError::Timeout) => break,
                Err(RecvTimeoutError::Disconnected) => {
                    thread::sleep(left);
                    break;
                }
            }
        }
        self.handle_stops();
    }

    /// Handles the emergency stops that have arrived.
    fn handle_stops(&mut self) {
        while let Ok((outbox, asked)) = self.stops.try_recv() {
            self.hold = Some(Hold {
                by: Arc::downgrade(&outbox),
                since: Instant::now(),
            });
            if let Some(answer) = self.session.ask(&outbox, &asked) {
                outbox.put(answer);
            }
        }
    }

    /// Counts a request to move the robot; returns true if an emergency stop forbids it.
    fn is_held(&mut self, outbox: &Arc<Outbox>) -> bool {
        let Some(hold) = &mut self.hold else {
            return false;
        };
        let now = Instant::now();
        let is_quiet = now - std::mem::replace(&mut hold.since, now) >= QUIET;
        if is_quiet || Weak::ptr_eq(&hold.by, &Arc::downgrade(outbox)) {
            self.hold = None;
        }
        self.hold.is_some()
    }

    fn handle(&mut self, event: HubEvent) {
        match event {
            HubEvent::Joined(outbox) => self.viewers.push((outbox, Viewer::default())),
            HubEvent::ClientRequest(outbox, asked, stops) => {
                self.handle_request(outbox, asked, stops)
            }
            HubEvent::Checked(reading) => self.session.checked(reading),
            HubEvent::FileChanged => self.session.file_changed(),
        }
        self.queue_text();
    }

    /// Queues the text for checking if it has changed.
    fn queue_text(&mut self) {
        if let Some(unchecked) = self.session.unchecked() {
            self.checks.queue_text(unchecked);
        }
    }

    fn handle_request(&mut self, outbox: Arc<Outbox>, asked: ClientRequest, stops: u64) {
        // A stop overtakes requests: an earlier one must not move the robot after it.
        let is_late = stops != self.stopped.load(Ordering::Relaxed);
        let answer = if asked.moves() && (is_late || self.is_held(&outbox)) {
            Some(asked.refused_stopped())
        } else {
            self.session.ask(&outbox, &asked)
        };
        match answer {
            Some(answer) => outbox.answer(answer),
            None => self.checks.ask(outbox, asked, stops),
        }
    }

    /// Sends each viewer its updates, as far as its outbox has room.
    fn send_updates(&mut self) {
        let is_here = |outbox: &Arc<Outbox>| !outbox.is_closed() && Arc::strong_count(outbox) > 1;
        self.viewers.retain(|(outbox, _)| is_here(outbox));
        for (outbox, viewer) in &mut self.viewers {
            while outbox.has_room() {
                let Some(update) = self.session.update(outbox, viewer) else {
                    break;
                };
                outbox.put(update);
            }
        }
    }
}

/// The queue of the thread that checks texts and answers questions about them.
#[derive(Default)]
struct CheckQueue {
    waiting: Mutex<Waiting>,
    changed: Condvar,
}

#[derive(Default)]
struct Waiting {
    /// The newest text; older ones are not checked.
    text: Option<UncheckedText>,
    asked: VecDeque<(Arc<Outbox>, ClientRequest, u64)>,
}

impl CheckQueue {
    fn queue_text(&self, text: UncheckedText) {
        self.waiting().text = Some(text);
        self.changed.notify_one();
    }

    fn ask(&self, outbox: Arc<Outbox>, asked: ClientRequest, stops: u64) {
        let mut waiting = self.waiting();
        let own = waiting
            .asked
            .iter()
            .filter(|(other, ..)| Arc::ptr_eq(other, &outbox));
        if own.count() >= MAX_QUESTIONS {
            drop(waiting);
            outbox.answer(asked.refused_many());
        } else {
            waiting.asked.push_back((outbox, asked, stops));
            self.changed.notify_one();
        }
    }

    /// Checks each text before answering questions about it, until the hub ends.
    fn work(&self, mut checker: TextChecker, hub: &HubSender) {
        let mut goes_on = true;
        while goes_on {
            let mut waiting = self.waiting();
            if let Some(text) = waiting.text.take() {
                drop(waiting);
                goes_on = hub.send(HubEvent::Checked(checker.read(text)));
            } else if let Some((outbox, asked, stops)) = waiting.asked.pop_front() {
                drop(waiting);
                match checker.answer(&asked) {
                    Some(answer) => outbox.answer(answer),
                    // The request does not need the checked text.
                    None => goes_on = hub.send(HubEvent::ClientRequest(outbox, asked, stops)),
                }
            } else {
                let woken = self.changed.wait(waiting);
                drop(woken.unwrap_or_else(PoisonError::into_inner));
            }
        }
    }

    fn waiting(&self) -> MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Maximum number of updates in an outbox; the next ones are made when there is room.
const MAX_UPDATES: usize = 2;
/// Maximum number of messages in an outbox; a viewer with more is disconnected.
const MAX_MESSAGES: usize = 64;

/// Maximum number of requests of one viewer without a response.
const MAX_REQUESTS: usize = 32;

/// Messages for a viewer, filled by the hub and emptied by the thread of the viewer. A slow viewer gets fewer and larger updates
/// instead of a long queue.
#[derive(Debug)]
pub(super) struct Outbox {
    /// The number of its connection.
    pub(super) number: u64,
    texts: Mutex<VecDeque<String>>,
    closed: AtomicBool,
    /// Number of requests without a response.
    asked: AtomicUsize,
}

impl Outbox {
    pub(super) fn new(number: u64) -> Self {
        Outbox {
            number,
            texts: Mutex::default(),
            closed: AtomicBool::new(false),
            asked: AtomicUsize::new(0),
        }
    }

    /// Returns true if there is room for another update.
    pub(super) fn has_room(&self) -> bool {
        !self.is_closed() && self.texts().len() < MAX_UPDATES
    }

    /// Adds an update or a response; too many of them disconnect the viewer.
    pub(super) fn put(&self, text: String) {
        let mut texts = self.texts();
        if texts.len() >= MAX_MESSAGES {
            texts.clear();
            self.close();
        } else {
            texts.push_back(text);
        }
    }

    /// Counts another request; returns false if there are too many.
    pub(super) fn add_request(&self) -> bool {
        let has_room = self.asked.load(Ordering::Relaxed) < MAX_REQUESTS;
        if has_room {
            self.asked.fetch_add(1, Ordering::Relaxed);
        }
        has_room
    }

    /// Adds the response to a request.
    pub(super) fn answer(&self, text: String) {
        self.asked.fetch_sub(1, Ordering::Relaxed);
        self.put(text);
    }

    pub(super) fn take(&self) -> Option<String> {
        self.texts().pop_front()
    }

    /// Marks the viewer as disconnected.
    pub(super) fn close(&self) {
        self.closed.store(true, Ordering::Relaxed);
    }

    pub(super) fn is_closed(&self) -> bool {
        self.closed.load(Ordering::Relaxed)
    }

    fn texts(&self) -> MutexGuard<'_, VecDeque<String>> {
        self.texts.lock().unwrap_or_else(PoisonError::into_inner)
    }
}
