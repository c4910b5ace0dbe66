//! Requests and responses of HTTP/1.1.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

/// Maximum length of a head, bytes, and number of its fields.
const MAX_HEAD: usize = 8 << 10;
const MAX_FIELDS: usize = 64;
/// Time for a client to send its head: it may not know the token.
const HEAD_TIMEOUT: Duration = Duration::from_secs(2);

/// The head of a request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) method: String,
    /// The path, without the query.
    pub(super) path: String,
    /// The query, after `?`.
    pub(super) query: String,
    fields: Vec<(String, String)>,
    /// The bytes that were read after the head.
    pub(super) rest: Vec<u8>,
}

/// The error of a head.
#[derive(Debug)]
pub(super) enum BadHead {
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
    pub(super) fn read(stream: &mut TcpStream) -> Result<Self, BadHead> {
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
    pub(super) fn field(&self, name: &str) -> Option<&str> {
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
pub(super) fn send_page(stream: &mut TcpStream, page: &str) -> io::Result<()> {
    send(stream, "200 OK", "text/html; charset=utf-8", page)
}

/// Sends an error, such as `404 Not Found`, with a reason.
pub(super) fn send_error(stream: &mut TcpStream, status: &str, word: &str) -> io::Result<()> {
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
pub(super) fn close(stream: &mut TcpStream) {
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

#[cfg(test)]
mod tests {
    use super::*;

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
