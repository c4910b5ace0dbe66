//! Connections of a live page: each has a thread, and their number is limited. Requests of HTTP/1.1 must have the token and come
//! from no other site; they get a page or a WebSocket.

use super::hub::{HubEvent, HubSender, Outbox};
use crate::error::Error as CommandError;
use crate::sweep;
use std::collections::VecDeque;
use std::fmt::Write as _;
use std::hint::black_box;
use std::io::{self, Read, Write};
use std::net::{IpAddr, Shutdown, SocketAddr, TcpListener, TcpStream};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};
use tip_view::live::{ClientRequest, MOST_BYTES};
use tipc::message::Lang;
use tungstenite::error::CapacityError;
use tungstenite::handshake::server::{create_response, write_response};
use tungstenite::http::Request;
use tungstenite::protocol::frame::coding::CloseCode;
use tungstenite::protocol::{CloseFrame, Role, WebSocketConfig};
use tungstenite::{Error, Message, WebSocket};

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

/// The content that those who have the token are served.
pub(super) enum Content {
    /// A page with a live run.
    Run(HubSender),
    /// A page with a table, and pages with its runs.
    Table(Table),
}

/// The table of a sweep, read again for each request.
pub(super) struct Table {
    file: PathBuf,
    lang: Lang,
    /// Locked during a simulation, so that one run is simulated at a time. At most `MAX_ADMITTED` requests wait.
    simulates: Mutex<()>,
}

impl Table {
    pub(super) fn new(file: PathBuf, lang: Lang) -> Self {
        Table {
            file,
            lang,
            simulates: Mutex::default(),
        }
    }

    /// Answers a request with the page of the table, or of a run.
    fn answer(&self, stream: &mut TcpStream, path: &str) -> io::Result<()> {
        let case = path.strip_prefix("/case/").map(str::parse::<u64>);
        let page = match (path, case) {
            ("/", _) => sweep::page(&self.file, true, self.lang).map(|(page, _)| page),
            (_, Some(Ok(case))) => {
                let one = self.simulates.lock();
                let _one = one.unwrap_or_else(PoisonError::into_inner);
                sweep::record(&self.file, case, self.lang).map(|recording| recording.to_page())
            }
            _ => return send_error(stream, "404 Not Found", "there is nothing here"),
        };
        match page {
            Ok(page) => send_page(stream, &page),
            Err(error) => {
                let status = match error {
                    CommandError::Usage(_) => "404 Not Found",
                    _ => "500 Internal Server Error",
                };
                send_error(stream, status, &error.text(self.lang))
            }
        }
    }
}

/// Starts a thread that accepts connections.
pub(super) fn accept(listener: TcpListener, guard: Guard, content: Content) {
    let connections = Arc::new(Connections {
        guard,
        content,
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
    content: Content,
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
                return send_error(&mut stream, status, "too long");
            }
            Err(BadHead::Malformed) => {
                return send_error(&mut stream, "400 Bad Request", "this is not HTTP");
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
            true => self.answer_admitted(number, stream, head),
            false => send_error(&mut stream, "503 Service Unavailable", "too many viewers"),
        };
        self.admitted.fetch_sub(1, Ordering::Relaxed);
        answered
    }

    /// Answers a request with the token: with a page, or by a WebSocket.
    fn answer_admitted(&self, number: usize, mut stream: TcpStream, head: Head) -> io::Result<()> {
        if head.method != "GET" {
            return send_error(&mut stream, "405 Method Not Allowed", "only GET is served");
        }
        match (&self.content, &*head.path) {
            (Content::Table(table), path) => table.answer(&mut stream, path),
            (Content::Run(_), "/") => send_page(&mut stream, &tip_view::live::page()),
            (Content::Run(hub), "/live") => {
                let host = head.field("host").unwrap_or_default();
                match self.guard.admit_origin(head.field("origin"), host) {
                    Ok(()) => serve_viewer(number as u64, stream, head, hub),
                    Err(rejection) => refuse(&mut stream, rejection),
                }
            }
            (Content::Run(_), _) => {
                send_error(&mut stream, "404 Not Found", "there is nothing here")
            }
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
    send_error(stream, status, word)
}

/// Number of random bytes of a token.
const TOKEN_BYTES: usize = 16;

/// The rules of admission.
#[derive(Clone, Debug)]
pub(super) struct Guard {
    own: SocketAddr,
    token: String,
}

/// The reason why a request is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Rejection {
    /// The host is another one: a name that leads here may belong to someone else (DNS rebinding).
    Host,
    /// The token is missing or wrong.
    Token,
    /// It comes from a page of another site.
    Origin,
}

impl Guard {
    /// Returns the rules of a server at an address, with a new token.
    ///
    /// # Errors
    /// The system has no random numbers.
    pub(super) fn new(own: SocketAddr) -> Result<Self, String> {
        let mut random = [0; TOKEN_BYTES];
        getrandom::fill(&mut random).map_err(|error| format!("no random numbers: {error}"))?;
        let mut token = String::new();
        for byte in random {
            // Writing to a string cannot fail.
            let _ = write!(token, "{byte:02x}");
        }
        Ok(Guard { own, token })
    }

    /// Returns true if only this machine reaches the server.
    pub(super) fn is_local(&self) -> bool {
        self.own.ip().is_loopback()
    }

    /// Returns the address of the page.
    pub(super) fn address(&self) -> String {
        let mut shown = self.own;
        if shown.ip().is_unspecified() {
            shown.set_ip(match shown {
                SocketAddr::V4(_) => [127, 0, 0, 1].into(),
                SocketAddr::V6(_) => std::net::Ipv6Addr::LOCALHOST.into(),
            });
        }
        self.address_at(shown)
    }

    /// Returns the address of the page at an address of this machine.
    pub(super) fn address_at(&self, shown: SocketAddr) -> String {
        format!("http://{shown}/?token={}", self.token)
    }

    /// Returns an error unless a request with this host and query is admitted.
    fn admit(&self, host: Option<&str>, query: &str) -> Result<(), Rejection> {
        if !host.is_some_and(|host| self.is_own(host)) {
            return Err(Rejection::Host);
        }
        let mut parts = query.split('&');
        let token = parts.find_map(|part| part.strip_prefix("token="));
        match token {
            Some(token) if is_same(token, &self.token) => Ok(()),
            _ => Err(Rejection::Token),
        }
    }

    /// Returns an error unless a page of this origin may open a WebSocket at this host.
    fn admit_origin(&self, origin: Option<&str>, host: &str) -> Result<(), Rejection> {
        match origin.and_then(|origin| origin.strip_prefix("http://")) {
            Some(origin) if origin.eq_ignore_ascii_case(host) => Ok(()),
            _ => Err(Rejection::Origin),
        }
    }

    /// Returns true if a host is this server: a number, which no name server controls, or `localhost`.
    fn is_own(&self, host: &str) -> bool {
        let (name, port) = match host.rsplit_once(':') {
            Some((name, port)) if !port.contains(']') => (name, port.parse().ok()),
            _ => (host, Some(80)),
        };
        if port != Some(self.own.port()) {
            return false;
        }
        if name.eq_ignore_ascii_case("localhost") {
            return true;
        }
        let inner = name
            .strip_prefix('[')
            .and_then(|name| name.strip_suffix(']'));
        match inner.unwrap_or(name).parse::<IpAddr>() {
            Ok(address) => address.is_loopback() || !self.own.ip().is_loopback(),
            Err(_) => false,
        }
    }
}

/// Compares in constant time.
fn is_same(one: &str, other: &str) -> bool {
    let pairs = one.bytes().zip(other.bytes());
    let differences = pairs.fold(0, |all, (one, other)| black_box(all | (one ^ other)));
    one.len() == other.len() && differences == 0
}

/// Maximum length of a head, bytes, and number of its fields.
const MAX_HEAD: usize = 8 << 10;
const MAX_FIELDS: usize = 64;
/// Time for a client to send its head: it may not know the token.
const HEAD_TIMEOUT: Duration = Duration::from_secs(2);

/// The head of a request.
#[derive(Clone, Debug, PartialEq, Eq)]
struct Head {
    method: String,
    /// The path, without the query.
    path: String,
    /// The query, after `?`.
    query: String,
    fields: Vec<(String, String)>,
    /// The bytes that were read after the head.
    rest: Vec<u8>,
}

/// The error of a head.
#[derive(Debug)]
enum BadHead {
    /// The client closed the connection or takes too long.
    Gone,
    /// It is too long.
    Long,
    /// It is not HTTP.
    Malformed,
}

impl From<io::Error> for BadHead {
    fn from(_: io::Error) -> Self {
        BadHead::Gone
    }
}

impl Head {
    /// Reads a head.
    fn read(stream: &mut TcpStream) -> Result<Self, BadHead> {
        let end = Instant::now() + HEAD_TIMEOUT;
        let mut bytes = Vec::new();
        let mut part = [0; 2048];
        loop {
            if let Some(head) = Head::parse(&bytes)? {
                return Ok(head);
            }
            if bytes.len() >= MAX_HEAD {
                return Err(BadHead::Long);
            }
            let left = end.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Err(BadHead::Gone);
            }
            stream.set_read_timeout(Some(left))?;
            match stream.read(&mut part)? {
                0 => return Err(BadHead::Gone),
                read => bytes.extend_from_slice(&part[..read]),
            }
        }
    }

    /// Parses the head at the beginning of some bytes, if it is complete.
    fn parse(bytes: &[u8]) -> Result<Option<Self>, BadHead> {
        let mut fields = [httparse::EMPTY_HEADER; MAX_FIELDS];
        let mut request = httparse::Request::new(&mut fields);
        let length = match request.parse(bytes) {
            Ok(httparse::Status::Complete(length)) => length,
            Ok(httparse::Status::Partial) => return Ok(None),
            Err(httparse::Error::TooManyHeaders) => return Err(BadHead::Long),
            Err(_) => return Err(BadHead::Malformed),
        };
        let target = request.path.unwrap_or_default();
        let (path, query) = target.split_once('?').unwrap_or((target, ""));
        let fields = request.headers.iter().map(|field| {
            let value = String::from_utf8_lossy(field.value);
            (field.name.to_ascii_lowercase(), value.into_owned())
        });
        Ok(Some(Head {
            method: request.method.unwrap_or_default().to_owned(),
            path: path.to_owned(),
            query: query.to_owned(),
            fields: fields.collect(),
            rest: bytes[length..].to_vec(),
        }))
    }

    /// Returns the value of a field by its name in small letters; `None` if there are several.
    fn field(&self, name: &str) -> Option<&str> {
        let mut values = self.fields.iter().filter(|(own, _)| own == name);
        let (_, value) = values.next()?;
        values.next().is_none().then_some(value)
    }
}

/// Time for a client to receive a response.
const WRITE_TIMEOUT: Duration = Duration::from_secs(30);

/// Time to read what a client sends after its request: closing earlier would lose the response.
const LINGER: Duration = Duration::from_millis(200);

/// Fields of every response: it is not cached, guessed, framed, or passed on to other sites.
const RESPONSE_FIELDS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n\
    Referrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\nConnection: close\r\n";

/// Sends the page.
fn send_page(stream: &mut TcpStream, page: &str) -> io::Result<()> {
    send(stream, "200 OK", "text/html; charset=utf-8", page)
}

/// Sends an error, such as `404 Not Found`, with a reason.
fn send_error(stream: &mut TcpStream, status: &str, word: &str) -> io::Result<()> {
    send(
        stream,
        status,
        "text/plain; charset=utf-8",
        &format!("{word}\n"),
    )
}

fn send(stream: &mut TcpStream, status: &str, kind: &str, body: &str) -> io::Result<()> {
    stream.set_write_timeout(Some(WRITE_TIMEOUT))?;
    let length = body.len();
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n{RESPONSE_FIELDS}\r\n"
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body.as_bytes())?;
    stream.flush()?;
    close(stream);
    Ok(())
}

/// Closes a connection: shuts down writing, and reads for a moment what still comes.
fn close(stream: &mut TcpStream) {
    let end = Instant::now() + LINGER;
    let mut part = [0; 4096];
    let mut goes_on = stream.shutdown(Shutdown::Write).is_ok();
    while goes_on {
        let left = end.saturating_duration_since(Instant::now());
        goes_on = !left.is_zero()
            && stream.set_read_timeout(Some(left)).is_ok()
            && matches!(stream.read(&mut part), Ok(1..));
    }
}

/// Time to wait for a message before looking for updates to send.
const VIEWER_TICK: Duration = Duration::from_millis(3);
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
fn serve_viewer(number: u64, mut stream: TcpStream, head: Head, hub: &HubSender) -> io::Result<()> {
    let Some(response) = upgrade(&head) else {
        let word = "this is for WebSockets";
        return send_error(&mut stream, "426 Upgrade Required", word);
    };
    stream.set_write_timeout(Some(PATIENCE))?;
    write_response(&mut stream, &response).map_err(io::Error::other)?;
    stream.set_read_timeout(Some(VIEWER_TICK))?;
    let config = WebSocketConfig::default()
        .max_message_size(Some(MOST_BYTES))
        .max_frame_size(Some(MOST_BYTES));
    let socket = WebSocket::from_partially_read(stream, head.rest, Role::Server, Some(config));
    let outbox = Arc::new(Outbox::new(number));
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
    hub.leave(&socket.outbox);
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
            unless_interrupted(self.socket.write(Message::text(text)))?;
        }
        if self.pinged.elapsed() > PING {
            self.pinged = Instant::now();
            unless_interrupted(self.socket.write(Message::Ping(Vec::new().into())))?;
        }
        unless_interrupted(self.socket.flush())
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
        let asked = ClientRequest::read(text.as_str());
        // Nobody sends too many emergency stops.
        if !self.rate_limit.spend() && !asked.is_stop() {
            return Err(End::Close(CloseCode::Policy, "too many requests"));
        }
        match self.hub.ask(&self.outbox, asked) {
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
        close(self.socket.get_mut());
    }
}

/// Returns true if an error only says that nothing has arrived yet. A read with a time-out is also interrupted when a suspended
/// process continues.
fn is_timeout(error: &io::Error) -> bool {
    matches!(
        error.kind(),
        io::ErrorKind::WouldBlock | io::ErrorKind::TimedOut | io::ErrorKind::Interrupted
    )
}

/// Ignores an interruption by a suspension of the process: the library keeps the bytes that are not written yet.
fn unless_interrupted(written: Result<(), Error>) -> Result<(), End> {
    match written {
        Err(Error::Io(error)) if error.kind() == io::ErrorKind::Interrupted => Ok(()),
        written => Ok(written?),
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn guard(own: &str) -> Guard {
        Guard::new(own.parse().expect("an address")).expect("random numbers")
    }

    #[test]
    fn a_token_is_long_and_always_another_one() {
        let (one, other) = (guard("127.0.0.1:8000"), guard("127.0.0.1:8000"));
        assert_eq!((one.token.len(), other.token.len()), (32, 32));
        assert_ne!(one.token, other.token);
        let address = format!("http://127.0.0.1:8000/?token={}", one.token);
        assert_eq!(one.address(), address);
        assert!(
            guard("0.0.0.0:80")
                .address()
                .starts_with("http://127.0.0.1:80/?")
        );
    }

    #[test]
    fn only_the_whole_token_lets_in() {
        let guard = guard("127.0.0.1:8000");
        let host = Some("127.0.0.1:8000");
        let token = guard.token.clone();
        assert_eq!(guard.admit(host, &format!("token={token}")), Ok(()));
        assert_eq!(guard.admit(host, &format!("a=b&token={token}")), Ok(()));
        for query in [
            String::new(),
            "token=".to_owned(),
            format!("token={}", &token[1..]),
            format!("token={token}0"),
            format!("tokens={token}"),
            format!("token={}", "0".repeat(32)),
            format!("token=&token={token}"),
        ] {
            assert_eq!(guard.admit(host, &query), Err(Rejection::Token), "{query}");
        }
    }

    #[test]
    fn only_numbers_and_localhost_are_this_host() {
        let here = guard("127.0.0.1:8000");
        let (all, six) = (guard("0.0.0.0:8000"), guard("[::1]:8000"));
        for (host, by_here, by_all) in [
            ("127.0.0.1:8000", true, true),
            ("localhost:8000", true, true),
            ("LocalHost:8000", true, true),
            ("[::1]:8000", true, true),
            ("192.168.1.5:8000", false, true),
            ("127.0.0.1:8001", false, false),
            ("127.0.0.1", false, false),
            ("evil.example:8000", false, false),
            ("localhost.evil.example:8000", false, false),
            ("127.0.0.1.evil.example:8000", false, false),
            ("", false, false),
            (":8000", false, false),
            ("127.0.0.1:8000:8000", false, false),
        ] {
            assert_eq!(here.is_own(host), by_here, "{host}");
            assert_eq!(all.is_own(host), by_all, "{host}");
        }
        assert!(six.is_own("[::1]:8000"));
        assert!(guard("127.0.0.1:80").is_own("localhost"));
        assert_eq!(here.admit(None, ""), Err(Rejection::Host));
    }

    #[test]
    fn an_origin_is_that_of_the_host() {
        let guard = guard("127.0.0.1:8000");
        let host = "localhost:8000";
        assert_eq!(
            guard.admit_origin(Some("http://localhost:8000"), host),
            Ok(())
        );
        for origin in [
            None,
            Some("null"),
            Some("http://localhost"),
            Some("https://localhost:8000"),
            Some("http://127.0.0.1:8000"),
            Some("http://evil.example"),
            Some("http://localhost:8000.evil.example"),
        ] {
            let refused = guard.admit_origin(origin, host);
            assert_eq!(refused, Err(Rejection::Origin), "{origin:?}");
        }
    }

    #[test]
    fn a_head_is_read_when_it_is_complete() {
        let bytes =
            b"GET /live?token=1 HTTP/1.1\r\nHost: a\r\nORIGIN: b\r\nX: 1\r\nX: 2\r\n\r\nrest";
        for end in 0..bytes.len() - 4 {
            assert!(matches!(Head::parse(&bytes[..end]), Ok(None)), "{end}");
        }
        let head = Head::parse(bytes).expect("HTTP").expect("complete");
        assert_eq!(
            (&*head.method, &*head.path, &*head.query),
            ("GET", "/live", "token=1")
        );
        assert_eq!(
            (head.field("host"), head.field("origin")),
            (Some("a"), Some("b"))
        );
        assert_eq!(
            (head.field("x"), head.field("y")),
            (None, None),
            "two say nothing"
        );
        assert_eq!(head.rest, b"rest");
    }

    #[test]
    fn what_is_no_head_is_refused() {
        for bytes in [
            &b"\x16\x03\x01\x02\x00"[..],
            b"GET\r\n\r\n",
            b"GET / HTTP/9\r\n\r\n",
            b"GET / HTTP/1.1\r\nA B: 1\r\n\r\n",
        ] {
            assert!(
                matches!(Head::parse(bytes), Err(BadHead::Malformed)),
                "{bytes:?}"
            );
        }
        let many = format!(
            "GET / HTTP/1.1\r\n{}\r\n",
            "A: 1\r\n".repeat(MAX_FIELDS + 1)
        );
        assert!(matches!(Head::parse(many.as_bytes()), Err(BadHead::Long)));
    }
}
