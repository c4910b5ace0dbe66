//! Framing, and servers on connections in memory.

use serde_json::{Value, json};
use std::cell::RefCell;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::{Path, PathBuf};
use std::rc::Rc;
use std::sync::{Arc, Mutex};
use tip_ide::lsp::{self, RobotConfig, Workspace};
use tip_ide::transport::{Connection, Frame, read, write};
use tipc::Options;
use tipc::diagnostic::Diagnostic;
use tipc::message::Lang;

fn next(stream: &mut impl BufRead) -> Option<Frame> {
    read(stream).expect("it is in memory")
}

#[test]
fn messages_are_read_as_they_are_written() {
    let mut stream = Vec::new();
    let messages = ["{}", "{\"a\":\"歩く\"}", ""];
    for message in messages {
        write(&mut stream, message).expect("it is in memory");
    }
    let mut stream = &stream[..];
    for message in messages {
        let frame = next(&mut stream);
        assert_eq!(frame, Some(Frame::Message(message.as_bytes().to_vec())));
    }
    assert_eq!(next(&mut stream), None);
}

#[test]
fn a_header_without_a_length_is_malformed_and_the_next_message_is_read() {
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
        let frame = next(&mut stream);
        assert!(matches!(frame, Some(Frame::Malformed(_))), "{bad:?}");
        assert_eq!(next(&mut stream), Some(Frame::Message(b"{}".to_vec())));
        assert_eq!(next(&mut stream), None);
    }
    let mut cut = &b"Content-Length: 9\r\n\r\n{}"[..];
    assert_eq!(next(&mut cut), None);
}

/// An endless stream of one byte.
struct Endless(u8);

impl Read for Endless {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        buffer.fill(self.0);
        Ok(buffer.len())
    }
}

#[test]
fn a_long_header_line_is_cut() {
    let message = Some(Frame::Message(b"{}".to_vec()));
    let rest = &b"\r\nContent-Length: 2\r\n\r\n{}"[..];
    let mut stream = BufReader::new(Endless(b'x').take(100 << 20).chain(rest));
    assert_eq!(next(&mut stream), message, "the line after it is read");
    // The 9 is beyond the part that is kept.
    let long = b"Content-Length: 2".chain(Endless(b' ').take(5000));
    let mut stream = BufReader::new(long.chain(&b"9\r\n\r\n{}"[..]));
    assert_eq!(next(&mut stream), message);
    let mut stream = BufReader::new(Endless(b' ').take(5000).chain(rest));
    assert_eq!(next(&mut stream), message, "blanks do not end the header");
    let mut stream = BufReader::new(Endless(b'x').take(10 << 20));
    assert_eq!(next(&mut stream), None, "the line never ends");
}

/// A workspace without files. It notes the paths of programs, and panics for one that is called `panic.prg`.
#[derive(Clone, Default)]
struct NoFiles(Rc<RefCell<Vec<Option<PathBuf>>>>);

impl Workspace for NoFiles {
    fn robot(&mut self, path: Option<&Path>, _: Option<&str>, _: Lang) -> Rc<RobotConfig> {
        self.0.borrow_mut().push(path.map(Path::to_owned));
        let is_bad = path.is_some_and(|path| path.ends_with("panic.prg"));
        assert!(!is_bad, "a defect");
        Rc::new(RobotConfig {
            options: Options::default(),
            robot: None,
            error: None,
        })
    }

    fn other_robot(&mut self, _: &Path, _: Option<&str>) -> Option<Diagnostic> {
        None
    }

    fn page(&mut self, _: &str, _: Lang) -> Option<String> {
        None
    }

    fn encoding(&mut self, _: &Path) -> Option<String> {
        None
    }

    fn is_running(&mut self, _: u32) -> bool {
        true
    }

    fn invalidate(&mut self) {}
}

/// An output that the test can read.
#[derive(Clone, Default)]
struct Output(Arc<Mutex<Vec<u8>>>);

impl Write for Output {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().expect("no panic").write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Serves a language client that sends messages; returns the responses, and the result of the session.
fn served(messages: &[&str]) -> (Vec<String>, bool) {
    served_in(NoFiles::default(), messages)
}

fn served_in(files: NoFiles, messages: &[&str]) -> (Vec<String>, bool) {
    let mut input = Vec::new();
    for message in messages {
        write(&mut input, message).expect("it is in memory");
    }
    let output = Output::default();
    let connection = Connection::new(io::Cursor::new(input), output.clone());
    let is_proper = lsp::serve(connection, files).expect("it is in memory");
    let bytes = output.0.lock().expect("no panic").clone();
    let mut stream = &bytes[..];
    let mut sent = Vec::new();
    while let Some(Frame::Message(message)) = next(&mut stream) {
        sent.push(String::from_utf8(message).expect("it is JSON"));
    }
    (sent, is_proper)
}

#[test]
fn a_language_server_needs_no_process() {
    let begin = r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}"#;
    let shutdown = r#"{"jsonrpc":"2.0","id":2,"method":"shutdown"}"#;
    let exit = r#"{"jsonrpc":"2.0","method":"exit"}"#;
    let (sent, is_proper) = served(&[begin, "nonsense", shutdown, exit]);
    assert!(is_proper, "shutdown comes before exit");
    assert_eq!(sent.len(), 3, "{sent:?}");
    assert!(
        sent[0].starts_with(r#"{"jsonrpc":"2.0","id":1,"result""#),
        "{}",
        sent[0]
    );
    assert!(
        sent[1].contains(r#""id":null"#) && sent[1].contains("-32700"),
        "{}",
        sent[1]
    );
    assert!(sent[2].contains(r#""id":2,"result":null"#), "{}", sent[2]);
    assert!(!served(&[begin, exit]).1, "exit without shutdown");
    assert!(!served(&[begin]).1, "the stream ends");
}

const BEGIN: &str =
    r#"{"jsonrpc":"2.0","id":1,"method":"initialize","params":{"capabilities":{}}}"#;

fn opened(uri: &str) -> String {
    let document =
        json!({ "uri": uri, "languageId": "tip", "version": 1, "text": "3.1\nT\nEND\n" });
    let params = json!({ "textDocument": document });
    json!({ "jsonrpc": "2.0", "method": "textDocument/didOpen", "params": params }).to_string()
}

#[test]
fn a_defect_in_one_program_leaves_the_others_their_diagnostics() {
    let open = ["file:///a.prg", "file:///panic.prg", "file:///z.prg"].map(opened);
    let (sent, _) = served(&[BEGIN, &open[0], &open[1], &open[2]]);
    let sent = sent.iter().skip(1);
    let sent = sent.map(|message| {
        let message: Value = serde_json::from_str(message).expect("it is JSON");
        let params = &message["params"];
        let text = params["uri"].as_str().or(params["message"].as_str());
        (
            message["method"].as_str().unwrap_or_default().to_owned(),
            text.unwrap_or_default().to_owned(),
        )
    });
    let published = |uri: &str| ("textDocument/publishDiagnostics".to_owned(), uri.to_owned());
    let reported = "file:///panic.prg: tip failed; this is a defect of tip, please report it";
    let expected = [
        published("file:///a.prg"),
        ("window/logMessage".to_owned(), reported.to_owned()),
        published("file:///z.prg"),
    ];
    // Documents that arrive later may be in a later round; each round keeps this order, and none repeats the defect.
    let mut sent: Vec<(String, String)> = sent.collect();
    sent.sort_by(|one, other| one.1.cmp(&other.1));
    assert_eq!(sent, expected);
}

#[test]
fn addresses_lead_to_paths_and_the_others_to_none() {
    let path = |uri: &str| {
        let files = NoFiles::default();
        served_in(files.clone(), &[BEGIN, &opened(uri)]);
        let asked = files.0.borrow();
        asked.first().expect("the program is checked").clone()
    };
    for (uri, expected) in [
        ("file:///robot/walk.prg", Some("/robot/walk.prg")),
        ("file:/robot/walk.prg", Some("/robot/walk.prg")),
        ("file://localhost/robot/walk.prg", Some("/robot/walk.prg")),
        ("file:///C:/walk.prg", Some("C:/walk.prg")),
        ("file:///c%3A/walk.prg", Some("c:/walk.prg")),
        ("file:///%C3%A9:/x.prg", Some("/\u{E9}:/x.prg")),
        ("file:///%E6%AD%A9.prg", Some("/\u{6B69}.prg")),
        ("file:///\u{6B69}%20.prg", Some("/\u{6B69} .prg")),
        ("file:///100%", Some("/100%")),
        ("file:///%+1%zz%4.prg", Some("/%+1%zz%4.prg")),
        ("file:///%\u{E9}1.prg", Some("/%\u{E9}1.prg")),
        // No text, no file of this machine, no path from the root, or no file at all.
        ("file:///%FF.prg", None),
        ("file://host/walk.prg", None),
        ("file://localhosts/walk.prg", None),
        ("file:%C3%A9:/x.prg", None),
        ("file:x.prg", None),
        ("file:", None),
        ("file://", None),
        ("untitled:Untitled-1", None),
        ("\u{E9}", None),
        ("", None),
    ] {
        assert_eq!(path(uri), expected.map(PathBuf::from), "{uri}");
    }
}
