//! Framing, and servers on connections in memory.

use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;
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

/// A workspace without files.
struct NoFiles;

impl Workspace for NoFiles {
    fn robot(&mut self, _: Option<&Path>, _: Option<&str>, _: Lang) -> Rc<RobotConfig> {
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
    let mut input = Vec::new();
    for message in messages {
        write(&mut input, message).expect("it is in memory");
    }
    let output = Output::default();
    let connection = Connection::new(io::Cursor::new(input), output.clone());
    let is_proper = lsp::serve(connection, NoFiles).expect("it is in memory");
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
