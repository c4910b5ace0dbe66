//! Connections: each has a thread, and there are not many.

use super::guard::{Guard, Stranger};
use super::head::{BadHead, Head};
use super::hub::Post;
use super::{reply, viewer};
use std::collections::VecDeque;
use std::io;
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// The most connections at once that know the token.
const MOST: usize = 64;
/// The most others. One more takes the place of the oldest one: whoever knows the token says so at once.
const STRANGERS: usize = 32;
/// The most threads; those of connections that were cut off end by themselves.
const THREADS: usize = MOST + 2 * STRANGERS;
/// How long it waits after a connection that could not be accepted.
const PAUSE: Duration = Duration::from_millis(50);
/// How often it looks whether a thread has ended.
const STEP: Duration = Duration::from_millis(1);

/// Begins to listen.
pub(super) fn open(address: SocketAddr) -> io::Result<TcpListener> {
    TcpListener::bind(address)
}

/// Answers connections from now on, while the command goes on.
pub(super) fn accept(listener: TcpListener, guard: Guard, post: Post) {
    let door = Arc::new(Door {
        guard,
        post,
        strangers: Mutex::default(),
        guests: AtomicUsize::new(0),
    });
    thread::spawn(move || {
        for (number, stream) in listener.incoming().enumerate() {
            let Ok(stream) = stream else {
                thread::sleep(PAUSE);
                continue;
            };
            // Nothing is read or written here: who waits to be let in waits for nobody.
            if !door.has_come(number, &stream) {
                continue;
            }
            // Each thread holds the door. Those that were cut off wait for no client, so there is soon room.
            while Arc::strong_count(&door) > THREADS {
                thread::sleep(STEP);
            }
            let own = Arc::clone(&door);
            let thread = thread::Builder::new().spawn(move || {
                // A client that goes away is no news.
                let _ = own.answer(number, stream);
                own.has_gone(number);
            });
            if thread.is_err() {
                door.has_gone(number);
            }
        }
    });
}

/// Where connections come in.
struct Door {
    guard: Guard,
    post: Post,
    /// Those that have not shown the token, the oldest first.
    strangers: Mutex<VecDeque<(usize, TcpStream)>>,
    /// How many have.
    guests: AtomicUsize,
}

impl Door {
    /// Remembers a connection, and cuts off the oldest stranger if there are too many; false if that is not possible.
    fn has_come(&self, number: usize, stream: &TcpStream) -> bool {
        let Ok(own) = stream.try_clone() else {
            return false;
        };
        let mut strangers = self.strangers();
        strangers.push_back((number, own));
        if strangers.len() > STRANGERS
            && let Some((_, oldest)) = strangers.pop_front()
        {
            let _ = oldest.shutdown(Shutdown::Both);
        }
        true
    }

    /// Forgets a stranger; whether it was still there.
    fn has_gone(&self, number: usize) -> bool {
        let mut strangers = self.strangers();
        let place = strangers.iter().position(|(other, _)| *other == number);
        place.is_some_and(|place| strangers.remove(place).is_some())
    }

    fn strangers(&self) -> MutexGuard<'_, VecDeque<(usize, TcpStream)>> {
        self.strangers
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
    }

    /// Answers one request.
    fn answer(&self, number: usize, mut stream: TcpStream) -> io::Result<()> {
        stream.set_nodelay(true)?;
        let head = match Head::read(&mut stream) {
            Ok(head) => head,
            Err(BadHead::Gone) => return Ok(()),
            Err(BadHead::Long) => {
                let status = "431 Request Header Fields Too Large";
                return reply::refusal(&mut stream, status, "too long");
            }
            Err(BadHead::Malformed) => {
                return reply::refusal(&mut stream, "400 Bad Request", "this is not HTTP");
            }
        };
        if let Err(stranger) = self.guard.admits(head.field("host"), &head.query) {
            return refuse(&mut stream, stranger);
        }
        if !self.has_gone(number) {
            // It was cut off when it began to speak.
            return Ok(());
        }
        let before = self.guests.fetch_add(1, Ordering::Relaxed);
        let answered = match before < MOST {
            true => self.let_in(stream, head),
            false => reply::refusal(&mut stream, "503 Service Unavailable", "too many viewers"),
        };
        self.guests.fetch_sub(1, Ordering::Relaxed);
        answered
    }

    /// Answers one who knows the token: with the page, or by making it a viewer.
    fn let_in(&self, mut stream: TcpStream, head: Head) -> io::Result<()> {
        match (&*head.method, &*head.path) {
            ("GET", "/") => reply::page(&mut stream, &tip_view::live::page()),
            ("GET", "/live") => {
                let host = head.field("host").unwrap_or_default();
                match self.guard.admits_origin(head.field("origin"), host) {
                    Ok(()) => viewer::serve(stream, head, &self.post),
                    Err(stranger) => refuse(&mut stream, stranger),
                }
            }
            ("GET", _) => reply::refusal(&mut stream, "404 Not Found", "there is nothing here"),
            _ => reply::refusal(&mut stream, "405 Method Not Allowed", "only GET is served"),
        }
    }
}

fn refuse(stream: &mut TcpStream, stranger: Stranger) -> io::Result<()> {
    let (status, word) = match stranger {
        Stranger::Host => (
            "421 Misdirected Request",
            "this server is reached by the number of its address, or as localhost",
        ),
        Stranger::Token => (
            "403 Forbidden",
            "the address that tip serve printed has a token; this one has another one, or none",
        ),
        Stranger::Origin => ("403 Forbidden", "a page from elsewhere is not served"),
    };
    reply::refusal(stream, status, word)
}
