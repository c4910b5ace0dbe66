//! The program as it stands in the editor, its checks and answers about it. They may take long and so are kept out of the run.

use super::request::{
    self, Answer, ClientRequest, LanguageAnswer, PageDiagnostic, Refusal, Request, findings,
    refuse, refuse_since,
};
use super::{Host, MOST_BYTES};
use tip_ide::Document;
use tip_sim::Robot;
use tipc::source::{Charset, Encoding, Source};
use tipc::{Loaded, Options};

/// The longest name by which a viewer calls itself.
const NAME: usize = 64;

/// The text that viewers edit, and the file that it comes from.
#[derive(Debug)]
pub(super) struct Buffer {
    name: String,
    options: Options,
    /// The file as it was last read or written.
    file: Source,
    /// The text, with LF between lines.
    pub(super) text: String,
    /// Counts its changes.
    pub(super) version: u64,
    /// The viewer that changed it last.
    pub(super) author: String,
    /// True if the text is that of the file, which may be in another encoding.
    is_file: bool,
    /// The last version that was given away to be checked.
    given: u64,
    reading: CheckedText,
    /// True if the file was changed elsewhere, and the text is not what was in it before.
    pub(super) is_overtaken: bool,
}

impl Buffer {
    /// Creates a buffer of a file's text, not checked yet.
    pub(super) fn new(name: String, bytes: &[u8], options: Options) -> Self {
        let (file, _) = Source::decode(&*name, bytes, options.encoding);
        Buffer {
            name,
            options,
            text: plain(file.text()),
            file,
            version: 1,
            author: String::new(),
            is_file: true,
            given: 0,
            reading: CheckedText::default(),
            is_overtaken: false,
        }
    }

    /// Returns the name of the file.
    pub(super) fn name(&self) -> &str {
        &self.name
    }

    /// Replaces the text, on behalf of a viewer.
    fn edit(&mut self, text: &str, author: String) {
        self.text = plain(text);
        self.author = author;
        self.version += 1;
        self.is_file = false;
    }

    /// Takes a viewer's text in the place of the version `base`.
    pub(super) fn take_edit(&mut self, text: &str, base: u64, by: &str) -> Result<(), Refusal> {
        if base != self.version {
            return refuse("stale");
        }
        if by.len() > NAME || text.len() > MOST_BYTES {
            return refuse("long");
        }
        self.edit(text, by.to_owned());
        Ok(())
    }

    /// Writes the text to the file.
    pub(super) fn save(&mut self, host: &mut dyn Host) -> Result<(), Refusal> {
        let bytes = match self.bytes() {
            Ok(bytes) => bytes,
            Err(char) => return refuse_since("unspelled", char),
        };
        match host.write(&bytes) {
            Ok(()) => self.saved(&bytes),
            Err(reason) => return refuse_since("unsaved", reason),
        }
        Ok(())
    }

    /// Takes the text of the file.
    pub(super) fn reload(&mut self, bytes: &[u8]) {
        let (file, _) = Source::decode(&*self.name, bytes, self.options.encoding);
        self.is_overtaken = false;
        self.edit(file.text(), String::new());
        self.file = file;
        self.is_file = true;
    }

    /// Returns the text if it has to be checked and was not given away before.
    pub(super) fn unchecked(&mut self) -> Option<UncheckedText> {
        if self.given == self.version {
            return None;
        }
        self.given = self.version;
        let (bytes, encoding) = match self.is_file {
            true => (self.file.bytes(), self.options.encoding),
            false => (self.text.clone().into_bytes(), Encoding::Utf8),
        };
        Some(UncheckedText {
            version: self.version,
            name: self.name.clone(),
            bytes,
            options: Options {
                encoding,
                ..self.options
            },
        })
    }

    /// Lets the text be given away again, to a viewer who has seen none.
    pub(super) fn forget_given(&mut self) {
        self.given = 0;
    }

    /// Keeps what was found in a text, unless a later one was checked already.
    pub(super) fn keep(&mut self, reading: CheckedText) {
        if reading.version > self.reading.version {
            self.reading = reading;
        }
    }

    /// Returns true if the present text has been checked.
    pub(super) fn is_checked(&self) -> bool {
        self.reading.version == self.version
    }

    /// Returns the program of the last checked text, if it is one.
    pub(super) fn program(&self) -> Option<&Loaded> {
        self.reading.program.as_deref()
    }

    pub(super) fn findings(&self) -> &[PageDiagnostic] {
        &self.reading.findings
    }

    /// Returns the version of the text that was checked last.
    pub(super) fn checked(&self) -> u64 {
        self.reading.version
    }

    /// Returns true if the text is not that of the file.
    pub(super) fn is_changed(&self) -> bool {
        self.text != plain(self.file.text())
    }

    /// Returns true if the file has these bytes already.
    pub(super) fn is_file(&self, bytes: &[u8]) -> bool {
        self.file.bytes() == bytes
    }

    /// Returns the text in the bytes of the file.
    ///
    /// # Errors
    /// A character that its encoding lacks.
    fn bytes(&self) -> Result<Vec<u8>, char> {
        self.file.encode(&self.text)
    }

    /// Notes that the file has these bytes now.
    fn saved(&mut self, bytes: &[u8]) {
        // Without its Japanese it would be guessed to be something else.
        let encoding = match self.file.charset() {
            Charset::Utf8 => Encoding::Utf8,
            Charset::ShiftJis => Encoding::ShiftJis,
        };
        (self.file, _) = Source::decode(&*self.name, bytes, encoding);
        self.is_overtaken = false;
    }
}

/// Converts line ends to LF, as editors have them.
fn plain(text: &str) -> String {
    text.replace("\r\n", "\n").replace('\r', "\n")
}

/// A text that is still to be checked.
#[derive(Debug)]
pub struct UncheckedText {
    pub(super) version: u64,
    pub(super) name: String,
    pub(super) bytes: Vec<u8>,
    pub(super) options: Options,
}

/// Result of reading a text.
#[derive(Debug, Default)]
pub struct CheckedText {
    pub(super) version: u64,
    pub(super) findings: Vec<PageDiagnostic>,
    /// None if there are errors in it.
    pub(super) program: Option<Box<Loaded>>,
}

/// A checker of texts, which keeps the last one.
#[derive(Debug)]
pub struct TextChecker {
    robot: Robot,
    document: Option<Document>,
}

impl TextChecker {
    /// Creates a checker for programs of a robot.
    pub fn new(robot: Robot) -> Self {
        TextChecker {
            robot,
            document: None,
        }
    }

    /// Checks a text.
    pub fn read(&mut self, unchecked: UncheckedText) -> CheckedText {
        let UncheckedText {
            version,
            name,
            bytes,
            options,
        } = unchecked;
        let mut loaded = tip_lint::load(&name, &bytes, &options);
        self.robot.warn(&mut loaded);
        let reading = CheckedText {
            version,
            findings: findings(&loaded),
            program: loaded.program.is_some().then(|| Box::new(loaded.clone())),
        };
        self.document = Some(Document::of(loaded, &options));
        reading
    }

    /// Answers what an editor asks about the last text; none if something else is asked.
    pub fn answer(&self, asked: &ClientRequest) -> Option<String> {
        let document = self.document.as_ref();
        let known: Option<LanguageAnswer> = match &asked.request {
            Ok(Request::Hover { at }) => document.map(|it| request::hover(it, *at)),
            Ok(Request::Complete { at }) => document.map(|it| request::completions(it, *at)),
            _ => return None,
        };
        Some(Answer::new(asked.id, Ok(known)).text())
    }
}
