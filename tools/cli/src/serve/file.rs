//! The file that is served: the only one that is read or written.

use super::super::output;
use std::fs;
use std::path::PathBuf;
use tip_view::live::Host;
use tipc::embed::{LIMIT, open_file, read_stream};
use tipc::message::{Lang, Reading};

/// A program's file. Links on the way to it were followed once, when it was served; one that takes its place is not.
#[derive(Debug)]
pub(super) struct ServedFile {
    /// The path without links.
    place: PathBuf,
    /// The content that was read or written last: another program's edit is never overwritten unseen.
    known: Vec<u8>,
    lang: Lang,
}

impl ServedFile {
    pub(super) fn new(place: PathBuf, known: Vec<u8>, lang: Lang) -> Self {
        ServedFile { place, known, lang }
    }

    /// Returns the content of the file, unless a link has taken its place or that of a folder above it.
    fn content(&self) -> Result<Vec<u8>, Reading> {
        let file = open_file(&self.place)?;
        let opened = file.metadata().ok();
        // What was opened is compared after that with what stands there, so that no link can come between.
        let is_unlinked = fs::canonicalize(&self.place).is_ok_and(|real| real == self.place);
        let entry = fs::symlink_metadata(&self.place).ok();
        match opened.zip(entry) {
            Some((opened, entry)) if is_unlinked && output::is_one(&opened, &entry) => {
                read_stream(file, LIMIT)
            }
            _ => Err(Reading::Linked),
        }
    }
}

impl Host for ServedFile {
    fn write(&mut self, bytes: &[u8]) -> Result<(), String> {
        let lang = self.lang;
        let written = match self.content() {
            Ok(content) if content == self.known => {
                output::update(&self.place, &content, bytes, lang)
            }
            // Some editors move the file away first, and a link would be there.
            Err(Reading::NoFile) if fs::symlink_metadata(&self.place).is_err() => {
                output::replace(&self.place, bytes)
            }
            Ok(_) => return Err(Reading::Changed.in_lang(lang).to_string()),
            Err(reason) => return Err(reason.in_lang(lang).to_string()),
        };
        written.map_err(|error| error.to_string())?;
        self.known = bytes.to_vec();
        Ok(())
    }

    fn read(&mut self) -> Result<Vec<u8>, String> {
        let read = self.content();
        self.known = read.map_err(|reason| reason.in_lang(self.lang).to_string())?;
        Ok(self.known.clone())
    }
}
