//! Connections: each has a thread, and there are not many.

use super::guard::{Guard, Stranger};
use super::head::{BadHead, Head};
use super::hub::News;
use super::{reply, viewer};
use std::io;
use std::net::{SocketAddr, TcpListener, TcpStream};
use std::sync::Arc;
use std::sync::mpsc::SyncSender;
use std::thread;
use std::time::Duration;

/// The most connections at once.
const MOST: usize = 64;
/// How long it waits after a connection that could not be accepted.
const PAUSE: Duration = Duration::from_millis(50);

/// Begins to listen.
pub(super) fn open(address: SocketAddr) -> io::Result<TcpListener> {
    TcpListener::bind(address)
}

/// Answers connections from now on, while the command goes on.
pub(super) fn accept(listener: TcpListener, guard: Guard, news: SyncSender<News>) {
    let guard = Arc::new(guard);
    thread::spawn(move || {
        for stream in listener.incoming() {
            let Ok(mut stream) = stream else {
                thread::sleep(PAUSE);
                continue;
            };
            // Each thread holds the guard.
            if Arc::strong_count(&guard) > MOST {
                let _ = reply::refusal(&mut stream, "503 Service Unavailable", "too many viewers");
                continue;
            }
            let (guard, news) = (Arc::clone(&guard), news.clone());
            thread::spawn(move || {
                // A client that goes away is no news.
                let _ = answer(stream, &guard, &news);
            });
        }
    });
}

/// Answers one request: with the page, or by making its client a viewer.
fn answer(mut stream: TcpStream, guard: &Guard, news: &SyncSender<News>) -> io::Result<()> {
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
    let host = head.field("host").map(str::to_owned);
    if let Err(stranger) = guard.admits(host.as_deref(), &head.query) {
        return refuse(&mut stream, stranger);
    }
    match (&*head.method, &*head.path) {
        ("GET", "/") => reply::page(&mut stream, &tip_view::live::page()),
        ("GET", "/live") => {
            let host = host.unwrap_or_default();
            match guard.admits_origin(head.field("origin"), &host) {
                Ok(()) => viewer::serve(stream, head, news),
                Err(stranger) => refuse(&mut stream, stranger),
            }
        }
        ("GET", _) => reply::refusal(&mut stream, "404 Not Found", "there is nothing here"),
        _ => reply::refusal(&mut stream, "405 Method Not Allowed", "only GET is served"),
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
            "the address that tipc serve printed has a token; this one has another one, or none",
        ),
        Stranger::Origin => ("403 Forbidden", "a page from elsewhere is not served"),
    };
    reply::refusal(stream, status, word)
}
