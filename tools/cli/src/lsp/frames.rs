//! Messages on a stream of bytes: headers, a blank line, JSON.

use lsp_server::{ErrorCode, Message};
use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer};
use serde_json::json;
use std::io::BufRead;

/// The longest message that is read.
const LONGEST: usize = 256 << 20;

/// What is read at once.
pub(crate) enum Frame {
    /// A message.
    Message(Box<Message>),
    /// Something that is no message, and why.
    Bad(String),
}

/// The messages of a stream, up to its end.
pub(crate) struct Frames<R> {
    stream: R,
}

impl<R: BufRead> Frames<R> {
    pub(crate) fn new(stream: R) -> Self {
        Frames { stream }
    }

    /// The length of the next message; none at the end of the stream.
    fn length(&mut self) -> Option<Result<usize, String>> {
        let mut length = Err("Content-Length is missing".to_owned());
        loop {
            let mut line = Vec::new();
            let read = self.stream.read_until(b'\n', &mut line);
            if !matches!(read, Ok(1..)) {
                return None;
            }
            let line = String::from_utf8_lossy(&line);
            let Some((name, value)) = line.trim().split_once(':') else {
                match line.trim().is_empty() {
                    true => return Some(length),
                    false => continue,
                }
            };
            if name.trim().eq_ignore_ascii_case("Content-Length") {
                let value = value.trim();
                let number = value.parse().ok().filter(|length| *length <= LONGEST);
                length = number.ok_or_else(|| format!("`{value}` is not a length"));
            }
        }
    }
}

impl<R: BufRead> Iterator for Frames<R> {
    type Item = Frame;

    fn next(&mut self) -> Option<Frame> {
        let length = match self.length()? {
            Ok(length) => length,
            Err(reason) => return Some(Frame::Bad(reason)),
        };
        let mut bytes = Vec::new();
        let mut stream = std::io::Read::take(&mut self.stream, length as u64);
        let read = std::io::Read::read_to_end(&mut stream, &mut bytes).ok()?;
        if read < length {
            return None;
        }
        Some(match serde_json::from_slice(&bytes) {
            Ok(Message::Notification(_)) if has_id(&bytes) => {
                Frame::Bad("an id is a number of 32 bits or a text".to_owned())
            }
            Ok(message) => Frame::Message(Box::new(message)),
            Err(error) => Frame::Bad(error.to_string()),
        })
    }
}

/// Whether it is a request, whose sender waits for an answer.
fn has_id(bytes: &[u8]) -> bool {
    #[derive(Deserialize)]
    struct Id {
        #[serde(default, deserialize_with = "any")]
        id: bool,
    }
    fn any<'de, D: Deserializer<'de>>(id: D) -> Result<bool, D::Error> {
        IgnoredAny::deserialize(id).map(|_| true)
    }
    serde_json::from_slice(bytes).is_ok_and(|Id { id }| id)
}

/// The answer to something that is no message: nobody knows to which request it belongs.
pub(crate) fn unread(reason: &str) -> Vec<u8> {
    let code = ErrorCode::ParseError as i32;
    let answer =
        json!({ "jsonrpc": "2.0", "id": null, "error": { "code": code, "message": reason } });
    let answer = answer.to_string();
    format!("Content-Length: {}\r\n\r\n{answer}", answer.len()).into_bytes()
}

#[cfg(test)]
mod tests {
    use super::{Frame, Frames};

    #[test]
    fn what_is_no_message_is_passed_over() {
        let good = r#"{"jsonrpc":"2.0","method":"exit"}"#;
        let frame = |text: &str| format!("Content-Length: {}\r\n\r\n{text}", text.len());
        let stream = [
            frame(good),
            frame("{"),
            "Content-Length: many\r\n\r\n".to_owned(),
            "Content-Length: 99999999999999999999\r\n\r\n".to_owned(),
            "Something: else\r\n\r\n".to_owned(),
            frame("[1]"),
            format!("content-length: {}\nX: y\n\n{good}", good.len()),
            "Content-Length: 5\r\n\r\n{".to_owned(),
        ]
        .concat();
        let frames = Frames::new(stream.as_bytes());
        let kinds: Vec<bool> = frames.map(|it| matches!(it, Frame::Message(_))).collect();
        assert_eq!(kinds, [true, false, false, false, false, false, true]);
    }
}
