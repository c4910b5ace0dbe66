//! Messages on a stream: a header that says how long each is, an empty line, and its bytes.

use std::io::{self, BufRead, Write};

/// A message longer than this is no debugger's.
const LONGEST: usize = 16 << 20;

/// A header longer than this is none.
const LONGEST_HEADER: u64 = 4096;

/// What came from a client.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Frame {
    /// A message.
    Message(Vec<u8>),
    /// A header that says no length, or one that cannot be.
    Broken,
}

/// The next message; none at the end of the stream.
pub(crate) fn read(from: &mut impl BufRead) -> io::Result<Option<Frame>> {
    let mut length = None;
    let mut is_broken = false;
    loop {
        let mut line = Vec::new();
        let read = io::Read::take(&mut *from, LONGEST_HEADER).read_until(b'\n', &mut line)?;
        if read == 0 {
            return Ok(None);
        }
        let line = line.trim_ascii();
        if line.is_empty() {
            break;
        }
        let text = str::from_utf8(line).unwrap_or_default();
        match text.split_once(':') {
            Some((name, value)) if name.trim().eq_ignore_ascii_case("content-length") => {
                length = value.trim().parse::<usize>().ok();
                is_broken |= length.is_none();
            }
            Some(_) => {}
            None => is_broken = true,
        }
    }
    match length {
        Some(length) if length <= LONGEST && !is_broken => {
            let mut message = vec![0; length];
            match from.read_exact(&mut message) {
                Ok(()) => Ok(Some(Frame::Message(message))),
                Err(error) if error.kind() == io::ErrorKind::UnexpectedEof => Ok(None),
                Err(error) => Err(error),
            }
        }
        _ => Ok(Some(Frame::Broken)),
    }
}

/// Sends a message.
pub(crate) fn write(to: &mut impl Write, message: &str) -> io::Result<()> {
    write!(to, "Content-Length: {}\r\n\r\n{message}", message.len())?;
    to.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn messages_are_read_as_they_are_written() {
        let mut stream = Vec::new();
        for message in ["{}", "{\"a\":\"歩く\"}", ""] {
            write(&mut stream, message).expect("memory takes it");
        }
        let mut stream = &stream[..];
        for message in ["{}", "{\"a\":\"歩く\"}", ""] {
            let frame = read(&mut stream).expect("it is in memory");
            assert_eq!(frame, Some(Frame::Message(message.as_bytes().to_vec())));
        }
        assert_eq!(read(&mut stream).expect("it is in memory"), None);
    }

    #[test]
    fn what_says_no_length_is_broken_and_the_next_message_is_read() {
        for broken in [
            "Content-Length: x\r\n\r\n",
            "\r\n",
            "nonsense\r\n\r\n",
            "Content-Length: 99999999999\r\n\r\n",
        ] {
            let stream = format!("{broken}Content-Length: 2\r\nContent-Type: a\r\n\r\n{{}}");
            let mut stream = stream.as_bytes();
            let mut next = || read(&mut stream).expect("it is in memory");
            assert_eq!(next(), Some(Frame::Broken), "{broken:?}");
            assert_eq!(next(), Some(Frame::Message(b"{}".to_vec())), "{broken:?}");
        }
        let mut cut = &b"Content-Length: 9\r\n\r\n{}"[..];
        assert_eq!(read(&mut cut).expect("it is in memory"), None);
    }
}
