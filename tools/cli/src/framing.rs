//! Messages of the Language Server Protocol and the Debug Adapter Protocol on a stream: header lines, one of which says how
//! long the message is, an empty line, and its bytes.

use std::io::{self, BufRead, Read, Write};

/// The longest message that is read, bytes.
const LONGEST: usize = 256 << 20;

/// The longest header line that is read, bytes.
const LONGEST_LINE: u64 = 4096;

/// One message of a stream, or the header of one that cannot be read.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Frame {
    /// The bytes of a message.
    Message(Vec<u8>),
    /// A header without a usable length, and the reason.
    Bad(String),
}

/// Returns the next message; none at the end of the stream.
pub(super) fn read(from: &mut impl BufRead) -> io::Result<Option<Frame>> {
    let mut length = Err("Content-Length is missing".to_owned());
    loop {
        let Some(line) = header_line(from)? else {
            return Ok(None);
        };
        let line = String::from_utf8_lossy(&line);
        match line.split_once(':') {
            Some((name, value)) if name.trim().eq_ignore_ascii_case("Content-Length") => {
                let value = value.trim();
                let number = value.parse::<usize>().ok();
                let number = number.filter(|length| *length <= LONGEST);
                length = number.ok_or_else(|| format!("`{value}` is not a length"));
            }
            None if line.trim_end_matches(['\r', '\n']).is_empty() => break,
            _ => {}
        }
    }
    let length = match length {
        Ok(length) => length,
        Err(reason) => return Ok(Some(Frame::Bad(reason))),
    };
    // Memory grows with what arrives, not with what is promised.
    let mut message = Vec::new();
    from.take(length as u64).read_to_end(&mut message)?;
    Ok((message.len() == length).then_some(Frame::Message(message)))
}

/// Returns the next header line with its end; none at the end of the stream. Of a line that is too long the beginning is kept.
fn header_line(from: &mut impl BufRead) -> io::Result<Option<Vec<u8>>> {
    let mut line = Vec::new();
    from.take(LONGEST_LINE).read_until(b'\n', &mut line)?;
    let mut is_whole = line.ends_with(b"\n") || (line.len() as u64) < LONGEST_LINE;
    while !is_whole {
        let mut rest = Vec::new();
        let read = from.take(LONGEST_LINE).read_until(b'\n', &mut rest)?;
        is_whole = read == 0 || rest.ends_with(b"\n");
    }
    Ok(Some(line).filter(|line| !line.is_empty()))
}

/// Sends a message.
pub(super) fn write(to: &mut impl Write, message: &str) -> io::Result<()> {
    write!(to, "Content-Length: {}\r\n\r\n{message}", message.len())?;
    to.flush()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn next(stream: &mut impl BufRead) -> Option<Frame> {
        read(stream).expect("it is in memory")
    }

    #[test]
    fn messages_are_read_as_they_are_written() {
        let mut stream = Vec::new();
        let messages = ["{}", "{\"a\":\"歩く\"}", ""];
        for message in messages {
            write(&mut stream, message).expect("memory takes it");
        }
        let mut stream = &stream[..];
        for message in messages {
            let frame = next(&mut stream);
            assert_eq!(frame, Some(Frame::Message(message.as_bytes().to_vec())));
        }
        assert_eq!(next(&mut stream), None);
    }

    #[test]
    fn a_header_without_a_length_is_bad_and_the_next_message_is_read() {
        for bad in [
            "Content-Length: many\r\n\r\n",
            "\r\n",
            "nonsense\r\n\r\n",
            "Something: else\r\n\r\n",
            "Content-Length: -1\r\n\r\n",
            "Content-Length: 99999999999\r\n\r\n",
            "Content-Length: 99999999999999999999\r\n\r\n",
        ] {
            let stream = format!("{bad}content-length: 2\nContent-Type: a\n\n{{}}");
            let mut stream = stream.as_bytes();
            assert!(matches!(next(&mut stream), Some(Frame::Bad(_))), "{bad:?}");
            assert_eq!(next(&mut stream), Some(Frame::Message(b"{}".to_vec())));
            assert_eq!(next(&mut stream), None);
        }
        let mut cut = &b"Content-Length: 9\r\n\r\n{}"[..];
        assert_eq!(next(&mut cut), None);
    }

    /// A stream of one byte without end.
    struct Endless(u8);

    impl Read for Endless {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            buffer.fill(self.0);
            Ok(buffer.len())
        }
    }

    #[test]
    fn a_long_header_line_is_kept_in_part_only() {
        let long = Endless(b'x').take(100 << 20);
        let mut stream = io::BufReader::new(long.chain(&b"\r\nContent-Length: 2\r\n\r\n{}"[..]));
        let line = header_line(&mut stream).expect("it is in memory");
        assert_eq!(line.map(|line| line.len()), Some(4096));
        assert_eq!(
            next(&mut stream),
            Some(Frame::Message(b"{}".to_vec())),
            "what follows the line is a header of its own"
        );
        // A long line of blanks is no end of a header.
        let long = Endless(b' ').take(5000);
        let rest = &b"\r\nContent-Length: 2\r\n\r\n{}"[..];
        let mut stream = io::BufReader::new(long.chain(rest));
        assert_eq!(next(&mut stream), Some(Frame::Message(b"{}".to_vec())));
        // A line that never ends is the end of the stream.
        let mut stream = io::BufReader::new(Endless(b'x').take(10 << 20));
        assert_eq!(next(&mut stream), None);
    }
}
