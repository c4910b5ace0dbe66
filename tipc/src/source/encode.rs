//! A file whose text was changed in an editor, in the bytes of the file.

use super::decode::Charset;
use super::lines::{Line, Lines};
use super::{Source, Span};
use encoding_rs::SHIFT_JIS;
use std::collections::HashMap;

impl Source {
    /// Returns the bytes of this file with another text in the place of its own: encoding, byte order mark and DOS end
    /// of file stay, and so do the bytes of each line that the file has already, which encoding its text again would
    /// not always lead back to. New lines end as the first one does.
    ///
    /// # Errors
    /// A character that the file's encoding lacks.
    pub fn encode(&self, text: &str) -> Result<Vec<u8>, char> {
        let known: HashMap<&str, Line> = self
            .lines()
            .map(|line| (self.slice(line.span), line))
            .collect();
        let first = self.slice(self.line(1).end);
        let usual = if first.is_empty() { "\n" } else { first };
        let mut out = self.mark().to_vec();
        for line in Lines::of(text) {
            let own = text.get(line.span.start..line.span.end).unwrap_or_default();
            let here = self.line(line.number);
            let known = match self.slice(here.span) == own {
                true => Some(&here),
                false => known.get(own),
            };
            match known {
                Some(line) => out.extend_from_slice(self.original(line.span)),
                None => self.encode_line(own, &mut out)?,
            }
            if line.end != Span::new(text.len(), text.len()) {
                let end = known.map(|line| self.slice(line.end)).unwrap_or_default();
                let end = if end.is_empty() { usual } else { end };
                out.extend_from_slice(end.as_bytes());
            }
        }
        out.extend_from_slice(self.tail());
        Ok(out)
    }

    /// Adds a text in the encoding of this file.
    fn encode_line(&self, text: &str, out: &mut Vec<u8>) -> Result<(), char> {
        if self.charset() == Charset::Utf8 {
            out.extend_from_slice(text.as_bytes());
            return Ok(());
        }
        for char in text.chars() {
            let mut buffer = [0; 4];
            let (bytes, _, failed) = SHIFT_JIS.encode(char.encode_utf8(&mut buffer));
            if failed {
                return Err(char);
            }
            out.extend_from_slice(&bytes);
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use crate::source::{Encoding, Source};

    fn source(bytes: &[u8]) -> Source {
        Source::decode("a.prg", bytes, Encoding::Auto).0
    }

    #[test]
    fn the_text_itself_gives_the_bytes_of_the_file() {
        let files: [&[u8]; 6] = [
            b"",
            b"3.1\n\nEND",
            b"\xEF\xBB\xBF3.1\r\nEND\r\n\x1A",
            b"3.1\ra\r\nb\nEND\n",
            // NEC's and IBM's rows have one character twice: EE FA is not what its text is encoded to.
            b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\n",
            b"3.1\n\x83\x7D\n",
        ];
        for bytes in files {
            let source = source(bytes);
            let again = source.encode(source.text());
            assert_eq!(again.as_deref(), Ok(bytes), "{bytes:?}");
        }
    }

    #[test]
    fn lines_that_stay_keep_their_bytes_and_new_ones_are_encoded_alike() {
        // An editor gives back LF.
        let file = source(b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\nEND\r\n\x1A");
        let edited = file
            .text()
            .replace("\r\n", "\n")
            .replace("END", "REM\n// 歩\nEND");
        let bytes = file.encode(&edited);
        let expected = b"3.1\r\n\x95\xE0\x82\xAD \xEE\xFA\r\nREM\r\n// \x95\xE0\r\nEND\r\n\x1A";
        assert_eq!(bytes.as_deref(), Ok(&expected[..]));
    }

    #[test]
    fn what_the_encoding_lacks_is_an_error() {
        let file = source(b"3.1\r\n\x95\xE0\r\n");
        assert_eq!(file.encode("3.1\n\u{1F916}\n"), Err('\u{1F916}'));
        let file = source("3.1\n歩\n".as_bytes());
        let text = "3.1\n\u{1F916}\n";
        assert_eq!(file.encode(text).as_deref(), Ok(text.as_bytes()));
    }
}
