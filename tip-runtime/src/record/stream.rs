//! Formatted text into a file or pipe.

use core::fmt;
use std::io;

/// An adapter that makes any [`io::Write`] a [`fmt::Write`] and keeps the error that `fmt::Write`
/// cannot report.
#[derive(Debug)]
pub struct Stream<W> {
    writer: W,
    error: Option<io::Error>,
}

impl<W: io::Write> Stream<W> {
    /// Writes to `writer`, which does its own buffering.
    pub fn new(writer: W) -> Self {
        Stream {
            writer,
            error: None,
        }
    }

    /// Flushes, and returns the first error of all writing so far.
    ///
    /// # Errors
    /// The first error of the writer; output after it was not written.
    pub fn finish(&mut self) -> io::Result<()> {
        match self.error.take() {
            Some(error) => Err(error),
            None => self.writer.flush(),
        }
    }

    /// Returns the writer.
    pub fn into_inner(self) -> W {
        self.writer
    }
}

impl<W: io::Write> fmt::Write for Stream<W> {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        if self.error.is_some() {
            return Err(fmt::Error);
        }
        self.writer.write_all(text.as_bytes()).map_err(|error| {
            self.error = Some(error);
            fmt::Error
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use core::fmt::Write;
    use std::vec::Vec;

    #[test]
    fn text_goes_through() {
        let mut stream = Stream::new(Vec::new());
        assert_eq!(write!(stream, "a{}", 1), Ok(()));
        assert!(stream.finish().is_ok());
        assert_eq!(stream.writer, b"a1");
    }

    #[test]
    fn the_first_error_is_kept_and_ends_all_writing() {
        let mut room = [0; 3];
        let mut stream = Stream::new(room.as_mut_slice());
        assert_eq!(stream.write_str("abc"), Ok(()));
        assert!(stream.write_str("d").is_err());
        assert!(stream.write_str("").is_err());
        let error = stream.finish().expect_err("no room");
        assert_eq!(error.kind(), io::ErrorKind::WriteZero);
    }
}
