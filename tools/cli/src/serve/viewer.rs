//! A viewer: a WebSocket with a thread of its own.

use super::head::Head;
use super::hub::{News, Post};
use super::outbox::Outbox;
use super::reply;
use std::io;
use std::net::TcpStream;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tip_view::live::{Asked, MOST_BYTES};
use tungstenite::error::CapacityError;
use tungstenite::handshake::server::{create_response, write_response};
use tungstenite::http::Request;
use tungstenite::protocol::frame::coding::CloseCode;
use tungstenite::protocol::{CloseFrame, Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

/// How long it listens before it looks whether there is something to send.
const TICK: Duration = Duration::from_millis(3);
/// A viewer that takes nothing for so long has gone.
const PATIENCE: Duration = Duration::from_secs(5);
/// How often a viewer is asked whether it is still there.
const PING: Duration = Duration::from_secs(15);
/// How many requests a second are heard, and how many at once.
const RATE: f64 = 400.0;
const BURST: f64 = 800.0;

/// Why a viewer is sent away.
enum End {
    /// It has gone by itself, or does not answer.
    Gone,
    /// With a word.
    Sent(CloseCode, &'static str),
}

impl From<Error> for End {
    fn from(error: Error) -> Self {
        match error {
            Error::Capacity(CapacityError::MessageTooLong { .. }) => {
                End::Sent(CloseCode::Size, "too long")
            }
            Error::Utf8(_) => End::Sent(CloseCode::Invalid, "not UTF-8"),
            Error::Protocol(_) => End::Sent(CloseCode::Protocol, "not WebSocket"),
            _ => End::Gone,
        }
    }
}

/// Makes a client that has asked for it a viewer, until it goes.
pub(super) fn serve(mut stream: TcpStream, head: Head, post: &Post) -> io::Result<()> {
    let Some(response) = upgrade(&head) else {
        let word = "this is for WebSockets";
        return reply::refusal(&mut stream, "426 Upgrade Required", word);
    };
    stream.set_write_timeout(Some(PATIENCE))?;
    write_response(&mut stream, &response).map_err(io::Error::other)?;
    stream.set_read_timeout(Some(TICK))?;
    let config = WebSocketConfig::default()
        .max_message_size(Some(MOST_BYTES))
        .max_frame_size(Some(MOST_BYTES));
    let socket = WebSocket::from_partially_read(stream, head.rest, Role::Server, Some(config));
    let outbox = Arc::new(Outbox::default());
    if !post.send(News::Came(Arc::clone(&outbox))) {
        return Ok(());
    }
    let mut conversation = Conversation {
        socket,
        outbox,
        post,
        allowance: Allowance::full(),
        pinged: Instant::now(),
    };
    let end = conversation.go_on();
    conversation.outbox.close();
    conversation.close(end);
    Ok(())
}

/// The answer to a request for a WebSocket, if it is one.
fn upgrade(head: &Head) -> Option<tungstenite::http::Response<()>> {
    let mut request = Request::builder().uri(&*head.path);
    for name in [
        "host",
        "connection",
        "upgrade",
        "sec-websocket-version",
        "sec-websocket-key",
    ] {
        request = request.header(name, head.field(name)?);
    }
    create_response(&request.body(()).ok()?).ok()
}

struct Conversation<'a> {
    socket: WebSocket<TcpStream>,
    outbox: Arc<Outbox>,
    post: &'a Post,
    allowance: Allowance,
    pinged: Instant,
}

impl Conversation<'_> {
    /// Sends and hears, until one of both ends it.
    fn go_on(&mut self) -> End {
        loop {
            if self.outbox.is_closed() {
                return End::Sent(CloseCode::Away, "it ends");
            }
            if let Err(end) = self.send().and_then(|()| self.hear()) {
                return end;
            }
        }
    }

    fn send(&mut self) -> Result<(), End> {
        while let Some(text) = self.outbox.take() {
            self.socket.write(Message::text(text))?;
        }
        if self.pinged.elapsed() > PING {
            self.pinged = Instant::now();
            self.socket.write(Message::Ping(Vec::new().into()))?;
        }
        Ok(self.socket.flush()?)
    }

    fn hear(&mut self) -> Result<(), End> {
        let text = match self.socket.read() {
            Ok(Message::Text(text)) => text,
            Ok(Message::Binary(_)) => return Err(End::Sent(CloseCode::Unsupported, "not text")),
            Ok(Message::Close(_)) => return Err(End::Gone),
            Ok(_) => return Ok(()),
            Err(Error::Io(error)) if is_pause(&error) => return Ok(()),
            Err(error) => return Err(error.into()),
        };
        if !self.allowance.spend() {
            return Err(End::Sent(CloseCode::Policy, "too many requests"));
        }
        match self.post.ask(&self.outbox, Asked::read(text.as_str())) {
            true => Ok(()),
            false => Err(End::Gone),
        }
    }

    /// Says why, and takes what is still on its way: who closes before loses the last word.
    fn close(mut self, end: End) {
        if let End::Sent(code, word) = end {
            let reason = word.into();
            let _ = self.socket.close(Some(CloseFrame { code, reason }));
            let _ = self.socket.flush();
        }
        // After an error the library must not read on.
        reply::part(self.socket.get_mut());
    }
}

/// Whether nothing has come yet.
fn is_pause(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut
    )
}

/// How many requests a viewer may still send.
struct Allowance {
    left: f64,
    since: Instant,
}

impl Allowance {
    fn full() -> Self {
        Allowance {
            left: BURST,
            since: Instant::now(),
        }
    }

    /// Takes one request from it; false if there is none left.
    fn spend(&mut self) -> bool {
        let now = Instant::now();
        let passed = (now - std::mem::replace(&mut self.since, now)).as_secs_f64();
        self.left = (self.left + passed * RATE).min(BURST) - 1.0;
        self.left >= 0.0
    }
}
