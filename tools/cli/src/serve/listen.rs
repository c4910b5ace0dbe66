//! Connections: each has a thread, and their number is limited.

use super::guard::{Guard, Rejection};
use super::http::{BadHead, Head};
use super::hub::HubSender;
use super::{http, viewer};
use std::collections::VecDeque;
use std::io;
use std::net::{Shutdown, SocketAddr, TcpListener, TcpStream};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

/// Maximum number of connections with the token.
const MAX_ADMITTED: usize = 64;
/// Maximum number of connections without it so far. One more replaces the oldest: clients with the token send it immediately.
const MAX_PENDING: usize = 32;
/// Maximum number of threads; those of closed connections end by themselves.
const MAX_THREADS: usize = MAX_ADMITTED + 2 * MAX_PENDING;
/// Pause after a connection that could not be accepted.
const PAUSE: Duration = Duration::from_millis(50);
/// Pause while there are too many threads.
const STEP: Duration = Duration::from_millis(1);

pub(super) fn open(address: SocketAddr) -> io::Result<TcpListener> {
    TcpListener::bind(address)
}

/// Starts a thread that accepts connections.
pub(super) fn accept(listener: TcpListener, guard: Guard, hub: HubSender) {
    let connections = Arc::new(Connections {
        guard,
        hub,
        pending: Mutex::default(),
        admitted: AtomicUsize::new(0),
    });
    thread::spawn(move || {
        for (number, stream) in listener.incoming().enumerate() {
            let Ok(stream) = stream else {
                thread::sleep(PAUSE);
                continue;
            };
            // Nothing is read or written here, so that no client delays another.
            if !connections.add(number, &stream) {
                continue;
            }
            // Each thread has a reference. Those of closed connections wait for no client, and end soon.
            while Arc::strong_count(&connections) > MAX_THREADS {
                thread::sleep(STEP);
            }
            let own = Arc::clone(&connections);
            let thread = thread::Builder::new().spawn(move || {
                // A client may close its connection at any time.
                let _ = own.answer(number, stream);
                own.remove(number);
            });
            if thread.is_err() {
                connections.remove(number);
            }
        }
    });
}

/// The state that all connections share.
struct Connections {
    guard: Guard,
    hub: HubSender,
    /// Connections that have not sent the token, the oldest first.
    pending: Mutex<VecDeque<(usize, TcpStream)>>,
    /// Number of connections that have.
    admitted: AtomicUsize,
}

impl Connections {
    /// Adds a connection, and closes the oldest one without the token if there are too many; returns false if that is not possible.
    fn add(&self, number: usize, stream: &TcpStream) -> bool {
        let Ok(own) = stream.try_clone() else {
            return false;
        };
        let mut pending = self.pending();
        pending.push_back((number, own));
        if pending.len() > MAX_PENDING
            && let Some((_, oldest)) = pending.pop_front()
        {
            let _ = oldest.shutdown(Shutdown::Both);
        }
        true
    }

    /// Removes a connection without the token; returns true if it was still there.
    fn remove(&self, number: usize) -> bool {
        let mut pending = self.pending();
        let index = pending.iter().position(|(other, _)| *other == number);
        index.is_some_and(|index| pending.remove(index).is_some())
    }

    fn pending(&self) -> MutexGuard<'_, VecDeque<(usize, TcpStream)>> {
        self.pending.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Answers one request.
    fn answer(&self, number: usize, mut stream: TcpStream) -> io::Result<()> {
        stream.set_nodelay(true)?;
        let head = match Head::read(&mut stream) {
            Ok(head) => head,
            Err(BadHead::Gone) => return Ok(()),
            Err(BadHead::Long) => {
                let status = "431 Request Header Fields Too Large";
                return http::send_error(&mut stream, status, "too long");
            }
            Err(BadHead::Malformed) => {
                return http::send_error(&mut stream, "400 Bad Request", "this is not HTTP");
            }
        };
        if let Err(rejection) = self.guard.admit(head.field("host"), &head.query) {
            return refuse(&mut stream, rejection);
        }
        if !self.remove(number) {
            // It was closed to make room for another one.
            return Ok(());
        }
        let before = self.admitted.fetch_add(1, Ordering::Relaxed);
        let answered = match before < MAX_ADMITTED {
            true => self.answer_admitted(stream, head),
            false => http::send_error(&mut stream, "503 Service Unavailable", "too many viewers"),
        };
        self.admitted.fetch_sub(1, Ordering::Relaxed);
        answered
    }

    /// Answers a request with the token: with the page, or by a WebSocket.
    fn answer_admitted(&self, mut stream: TcpStream, head: Head) -> io::Result<()> {
        match (&*head.method, &*head.path) {
            ("GET", "/") => http::send_page(&mut stream, &tip_view::live::page()),
            ("GET", "/live") => {
                let host = head.field("host").unwrap_or_default();
                match self.guard.admit_origin(head.field("origin"), host) {
                    Ok(()) => viewer::serve(stream, head, &self.hub),
                    Err(rejection) => refuse(&mut stream, rejection),
                }
            }
            ("GET", _) => http::send_error(&mut stream, "404 Not Found", "there is nothing here"),
            _ => http::send_error(&mut stream, "405 Method Not Allowed", "only GET is served"),
        }
    }
}

fn refuse(stream: &mut TcpStream, rejection: Rejection) -> io::Result<()> {
    let (status, word) = match rejection {
        Rejection::Host => (
            "421 Misdirected Request",
            "this server is reached by the number of its address, or as localhost",
        ),
        Rejection::Token => (
            "403 Forbidden",
            "the address that tip serve printed has a token; this one has another one, or none",
        ),
        Rejection::Origin => ("403 Forbidden", "a page from elsewhere is not served"),
    };
    http::send_error(stream, status, word)
}
