//! The head of a request of HTTP/1.1.

use std::io::{self, Read};
use std::net::TcpStream;
use std::time::{Duration, Instant};

/// The longest head, and the most fields in it.
const LONGEST: usize = 8 << 10;
const FIELDS: usize = 64;
/// A client, of which nobody knows yet whether it has the token, has so long to send it.
const PATIENCE: Duration = Duration::from_secs(2);

/// What a request asks for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) method: String,
    /// Without the query.
    pub(super) path: String,
    /// What follows `?`.
    pub(super) query: String,
    fields: Vec<(String, String)>,
    /// What was read after the head.
    pub(super) rest: Vec<u8>,
}

/// Why there is no head.
#[derive(Debug)]
pub(super) enum BadHead {
    /// The client went away, or takes too long.
    Gone,
    /// It has more than a head may have.
    Long,
    /// It is no HTTP.
    Malformed,
}

impl From<io::Error> for BadHead {
    fn from(_: io::Error) -> Self {
        BadHead::Gone
    }
}

impl Head {
    /// Reads one.
    pub(super) fn read(stream: &mut TcpStream) -> Result<Self, BadHead> {
        let end = Instant::now() + PATIENCE;
        let mut bytes = Vec::new();
        let mut part = [0; 2048];
        loop {
            if let Some(head) = Head::parse(&bytes)? {
                return Ok(head);
            }
            if bytes.len() >= LONGEST {
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

    /// The head that these bytes begin with, if it is complete.
    fn parse(bytes: &[u8]) -> Result<Option<Self>, BadHead> {
        let mut fields = [httparse::EMPTY_HEADER; FIELDS];
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

    /// The value of a field, by its name in small letters; none if there are several.
    pub(super) fn field(&self, name: &str) -> Option<&str> {
        let mut values = self.fields.iter().filter(|(own, _)| own == name);
        let (_, value) = values.next()?;
        values.next().is_none().then_some(value)
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
        let many = format!("GET / HTTP/1.1\r\n{}\r\n", "A: 1\r\n".repeat(FIELDS + 1));
        assert!(matches!(Head::parse(many.as_bytes()), Err(BadHead::Long)));
    }
}
