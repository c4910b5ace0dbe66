//! What waits to be sent to a viewer: little, so that a slow one gets fewer and larger updates instead of a queue.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

/// How many updates wait; the next ones are made when there is room.
const UPDATES: usize = 2;
/// A viewer that takes no answers while it asks for so many is none.
const ANSWERS: usize = 64;

/// How many requests of one viewer wait for their answers.
const REQUESTS: usize = 32;

/// Filled by the hub, emptied by the viewer's own thread.
#[derive(Debug, Default)]
pub(super) struct Outbox {
    texts: Mutex<VecDeque<String>>,
    closed: AtomicBool,
    /// How many requests wait.
    asked: AtomicUsize,
}

impl Outbox {
    /// Whether another update may be put in.
    pub(super) fn has_room(&self) -> bool {
        !self.is_closed() && self.texts().len() < UPDATES
    }

    /// Puts an update or an answer in; too many of them end the viewer.
    pub(super) fn put(&self, text: String) {
        let mut texts = self.texts();
        if texts.len() >= ANSWERS {
            texts.clear();
            self.close();
        } else {
            texts.push_back(text);
        }
    }

    /// Whether another request may wait; then it does until it is answered.
    pub(super) fn begins(&self) -> bool {
        let begins = self.asked.load(Ordering::Relaxed) < REQUESTS;
        if begins {
            self.asked.fetch_add(1, Ordering::Relaxed);
        }
        begins
    }

    /// Answers a request that waits.
    pub(super) fn answer(&self, text: String) {
        self.asked.fetch_sub(1, Ordering::Relaxed);
        self.put(text);
    }

    pub(super) fn take(&self) -> Option<String> {
        self.texts().pop_front()
    }

    /// The viewer has gone, or has to.
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
