//! The program as it stands in the editor.

use super::finding::{Finding, findings};
use tip_ide::Document;
use tip_sim::{Robot, reach, special};
use tipc::source::{Charset, Encoding, Source};
use tipc::{Loaded, Options};

/// The text that viewers edit, and the file that it comes from.
#[derive(Debug)]
pub(super) struct Draft {
    name: String,
    options: Options,
    /// The file as it was last read or written.
    file: Source,
    /// With LF between lines.
    pub(super) text: String,
    /// Counts its changes.
    pub(super) version: u64,
    /// Which viewer changed it last.
    pub(super) author: String,
    /// What came of the text; none until it is checked.
    document: Option<Document>,
    findings: Vec<Finding>,
    /// The version that is checked.
    pub(super) checked: u64,
    /// The file was changed by someone else, and the text is not what was in it before.
    pub(super) is_overtaken: bool,
}

impl Draft {
    /// That of a file.
    pub(super) fn new(name: String, bytes: &[u8], options: Options, robot: &Robot) -> Self {
        let (file, _) = Source::decode(&*name, bytes, options.encoding);
        let mut draft = Draft {
            name,
            options,
            text: plain(file.text()),
            file,
            version: 1,
            author: String::new(),
            document: None,
            findings: Vec::new(),
            checked: 0,
            is_overtaken: false,
        };
        draft.read(bytes, robot);
        draft
    }

    /// The file has this content, which is checked as it is.
    fn read(&mut self, bytes: &[u8], robot: &Robot) {
        self.keep(tip_lint::load(&self.name, bytes, &self.options), robot);
    }

    /// Another text, by a viewer.
    pub(super) fn edit(&mut self, text: &str, author: String) {
        self.text = plain(text);
        self.author = author;
        self.version += 1;
        self.document = None;
    }

    /// Takes the text of the file.
    pub(super) fn reload(&mut self, bytes: &[u8], robot: &Robot) {
        let (file, _) = Source::decode(&*self.name, bytes, self.options.encoding);
        self.is_overtaken = false;
        self.edit(file.text(), String::new());
        self.file = file;
        self.read(bytes, robot);
    }

    /// Checks the text if it has changed; whether it had.
    pub(super) fn check(&mut self, robot: &Robot) -> bool {
        if self.document.is_some() {
            return false;
        }
        let options = Options {
            encoding: Encoding::Utf8,
            ..self.options
        };
        let loaded = tip_lint::load(&self.name, self.text.as_bytes(), &options);
        self.keep(loaded, robot);
        true
    }

    fn keep(&mut self, mut loaded: Loaded, robot: &Robot) {
        reach::warn(&mut loaded, robot);
        special::warn(&mut loaded, robot);
        self.findings = findings(&loaded);
        self.document = Some(Document::of(loaded, &self.options));
        self.checked = self.version;
    }

    /// What came of the text, if it is checked.
    pub(super) fn loaded(&self) -> Option<&Loaded> {
        self.document().map(Document::loaded)
    }

    /// The text as editors ask about it, if it is checked.
    pub(super) fn document(&self) -> Option<&Document> {
        self.document.as_ref()
    }

    /// Whether the text is checked and loads.
    pub(super) fn is_program(&self) -> bool {
        self.loaded().is_some_and(|loaded| loaded.program.is_some())
    }

    pub(super) fn findings(&self) -> &[Finding] {
        &self.findings
    }

    /// Whether the text is not that of the file.
    pub(super) fn is_changed(&self) -> bool {
        self.text != plain(self.file.text())
    }

    /// Whether the file has these bytes already.
    pub(super) fn is_file(&self, bytes: &[u8]) -> bool {
        self.file.bytes() == bytes
    }

    /// The text in the bytes of the file.
    ///
    /// # Errors
    /// A character that its encoding lacks.
    pub(super) fn bytes(&self) -> Result<Vec<u8>, char> {
        self.file.respelled(&self.text)
    }

    /// The file has these bytes now.
    pub(super) fn saved(&mut self, bytes: &[u8]) {
        // Without its Japanese it would be guessed to be something else.
        let encoding = match self.file.charset() {
            Charset::Utf8 => Encoding::Utf8,
            Charset::ShiftJis => Encoding::ShiftJis,
        };
        (self.file, _) = Source::decode(&*self.name, bytes, encoding);
        self.is_overtaken = false;
    }
}

/// With LF between lines, as editors have it.
fn plain(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n")
}
