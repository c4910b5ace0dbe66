//! A viewer: a WebSocket with a thread of its own.

use super::http;
use super::http::Head;
use super::hub::{HubEvent, HubSender, Outbox};
use std::io;
use std::net::TcpStream;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tip_view::live::{ClientRequest, MOST_BYTES};
use tungstenite::error::CapacityError;
use tungstenite::handshake::server::{create_response, write_response};
use tungstenite::http::Request;
use tungstenite::protocol::frame::coding::CloseCode;
use tungstenite::protocol::{CloseFrame, Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

/// Time to wait for a message before looking for updates to send.
const TICK: Duration = Duration::from_millis(3);
/// Time after which a viewer that receives nothing is disconnected.
const PATIENCE: Duration = Duration::from_secs(5);
/// Time between two pings.
const PING: Duration = Duration::from_secs(15);
/// Maximum rate of requests, 1/s, and size of a burst.
const RATE: f64 = 400.0;
const BURST: f64 = 800.0;

/// The reason why a connection ends.
enum End {
    /// The viewer left, or does not answer.
    Gone,
    /// It is closed with a code and a reason.
    Close(CloseCode, &'static str),
}

impl From<Error> for End {
    fn from(error: Error) -> Self {
        match error {
            Error::Capacity(CapacityError::MessageTooLong { .. }) => {
                End::Close(CloseCode::Size, "too long")
            }
            Error::Utf8(_) => End::Close(CloseCode::Invalid, "not UTF-8"),
            Error::Protocol(_) => End::Close(CloseCode::Protocol, "not WebSocket"),
            _ => End::Gone,
        }
    }
}

/// Serves a WebSocket until it is closed.
pub(super) fn serve(mut stream: TcpStream, head: Head, hub: &HubSender) -> io::Result<()> {
    let Some(response) = upgrade(&head) else {
        let word = "this is for WebSockets";
        return http::send_error(&mut stream, "426 Upgrade Required", word);
    };
    stream.set_write_timeout(Some(PATIENCE))?;
    write_response(&mut stream, &response).map_err(io::Error::other)?;
    stream.set_read_timeout(Some(TICK))?;
    let config = WebSocketConfig::default()
        .max_message_size(Some(MOST_BYTES))
        .max_frame_size(Some(MOST_BYTES));
    let socket = WebSocket::from_partially_read(stream, head.rest, Role::Server, Some(config));
    let outbox = Arc::new(Outbox::default());
    if !hub.send(HubEvent::Joined(Arc::clone(&outbox))) {
        return Ok(());
    }
    let mut socket = Socket {
        socket,
        outbox,
        hub,
        rate_limit: RateLimit::full(),
        pinged: Instant::now(),
    };
    let end = socket.run();
    socket.outbox.close();
    socket.close(end);
    Ok(())
}

/// Returns the response to a request for a WebSocket, if it is one.
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

struct Socket<'a> {
    socket: WebSocket<TcpStream>,
    outbox: Arc<Outbox>,
    hub: &'a HubSender,
    rate_limit: RateLimit,
    pinged: Instant,
}

impl Socket<'_> {
    /// Sends and receives until the connection ends.
    fn run(&mut self) -> End {
        loop {
            if self.outbox.is_closed() {
                return End::Close(CloseCode::Away, "it ends");
            }
            if let Err(end) = self.send().and_then(|()| self.receive()) {
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

    fn receive(&mut self) -> Result<(), End> {
        let text = match self.socket.read() {
            Ok(Message::Text(text)) => text,
            Ok(Message::Binary(_)) => return Err(End::Close(CloseCode::Unsupported, "not text")),
            Ok(Message::Close(_)) => return Err(End::Gone),
            Ok(_) => return Ok(()),
            Err(Error::Io(error)) if is_timeout(&error) => return Ok(()),
            Err(error) => return Err(error.into()),
        };
        if !self.rate_limit.spend() {
            return Err(End::Close(CloseCode::Policy, "too many requests"));
        }
        match self
            .hub
            .ask(&self.outbox, ClientRequest::read(text.as_str()))
        {
            true => Ok(()),
            false => Err(End::Gone),
        }
    }

    /// Sends the reason and reads what still comes: closing earlier would lose the reason.
    fn close(mut self, end: End) {
        if let End::Close(code, word) = end {
            let reason = word.into();
            let _ = self.socket.close(Some(CloseFrame { code, reason }));
            let _ = self.socket.flush();
        }
        // After an error the library must not read on.
        http::close(self.socket.get_mut());
    }
}

/// Returns true if nothing has arrived yet.
fn is_timeout(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut
    )
}

/// A limit of the rate of requests.
struct RateLimit {
    left: f64,
    since: Instant,
}

impl RateLimit {
    fn full() -> Self {
        RateLimit {
            left: BURST,
            since: Instant::now(),
        }
    }

    /// Counts a request; returns false if the rate is too high.
    fn spend(&mut self) -> bool {
        let now = Instant::now();
        let passed = (now - std::mem::replace(&mut self.since, now)).as_secs_f64();
        self.left = (self.left + passed * RATE).min(BURST) - 1.0;
        self.left >= 0.0
    }
}
