//! The state of a session: initialization and shutdown, open programs and settings, and the messages that the server sends on
//! its own. It does no input or output.

use super::client::{self, Client, Positions};
use super::{RobotConfig, Workspace, convert};
use crate::Document;
use gen_lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    PublishDiagnosticsParams, TextDocumentContentChangeEvent as Change, Uri,
};
use lsp_server::{ErrorCode, Message, Notification, Request, Response, ResponseError};
use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::PathBuf;
use std::rc::Rc;
use std::thread;
use tipc::diagnostic::Diagnostic;
use tipc::source::{Encoding, Source, Unit};

/// A session with one editor.
#[derive(Debug)]
pub struct Server<W> {
    pub(super) workspace: W,
    /// `None` before `initialize`.
    client: Option<Client>,
    /// True after `shutdown`.
    is_shut_down: bool,
    /// After `exit`, true if `shutdown` came before it.
    exit: Option<bool>,
    /// The open programs by address.
    buffers: BTreeMap<String, Buffer>,
    /// The errors about robots that were shown already.
    shown_errors: Vec<String>,
}

/// Returns the error of a request.
pub(super) fn failure(code: ErrorCode, message: impl Into<String>) -> ResponseError {
    ResponseError {
        code: code as i32,
        message: message.into(),
        data: None,
    }
}

/// The open program that a request is about.
pub(super) struct OpenProgram<'a, W> {
    pub(super) uri: &'a str,
    pub(super) document: &'a Document,
    pub(super) client: &'a Client,
    pub(super) workspace: &'a mut W,
}

impl<W: Workspace> Server<W> {
    /// Returns a session before its first message.
    pub fn new(workspace: W) -> Self {
        Server {
            workspace,
            client: None,
            is_shut_down: false,
            exit: None,
            buffers: BTreeMap::new(),
            shown_errors: Vec::new(),
        }
    }

    /// After `exit`, returns true if `shutdown` came before it.
    pub fn exit(&self) -> Option<bool> {
        self.exit
    }

    /// Returns false once the process of the client has ended.
    pub fn has_client(&mut self) -> bool {
        let process = self.client.as_ref().and_then(|client| client.process);
        process.is_none_or(|process| self.workspace.is_running(process))
    }

    /// Handles a message; returns the response to a request, and requests to the client.
    pub fn handle(&mut self, message: Message) -> Vec<Message> {
        match message {
            Message::Request(request) => {
                let id = request.id.clone();
                let response_result = self.request(request);
                vec![
                    Response {
                        id,
                        response_result,
                    }
                    .into(),
                ]
            }
            Message::Notification(notification) => self.notification(notification),
            // The only request to clients is the one to watch files; a refusal changes nothing here.
            Message::Response(_) => Vec::new(),
        }
    }

    /// Returns the addresses of the programs that have changed since the last call: their diagnostics are due.
    pub fn take_due(&mut self) -> Vec<String> {
        let due = self.buffers.iter_mut().filter_map(|(uri, buffer)| {
            let is_due = std::mem::take(&mut buffer.is_due);
            is_due.then(|| uri.clone())
        });
        due.collect()
    }

    /// Returns the addresses of all open programs.
    pub fn open(&self) -> Vec<String> {
        self.buffers.keys().cloned().collect()
    }

    /// Computes what hovers and hints need of an open program; for moments without requests.
    pub fn prepare(&self, uri: &str) {
        if let Some(buffer) = self.buffers.get(uri) {
            buffer.prepare();
        }
    }

    fn request(&mut self, request: Request) -> Result<Value, ResponseError> {
        let Request { method, params, .. } = request;
        match (method.as_str(), &self.client) {
            _ if self.is_shut_down => Err(failure(
                ErrorCode::InvalidRequest,
                "the session is shut down",
            )),
            ("initialize", None) => Ok(self.initialize(&params)),
            ("initialize", Some(_)) => Err(failure(
                ErrorCode::InvalidRequest,
                "the session is initialized already",
            )),
            (_, None) => Err(failure(
                ErrorCode::ServerNotInitialized,
                "initialize comes first",
            )),
            ("shutdown", Some(_)) => {
                self.is_shut_down = true;
                Ok(Value::Null)
            }
            (_, Some(_)) => self.answer(&method, params),
        }
    }

    fn initialize(&mut self, params: &Value) -> Value {
        let client = Client::new(params);
        let encoding = client.encoding();
        self.client = Some(client);
        json!({
            "serverInfo": { "name": "tip", "version": env!("CARGO_PKG_VERSION") },
            "capabilities": capabilities(encoding),
        })
    }

    fn notification(&mut self, notification: Notification) -> Vec<Message> {
        let Notification { method, params } = notification;
        if method == "exit" {
            self.exit = Some(self.is_shut_down);
            return Vec::new();
        }
        let Some(client) = &self.client else {
            return Vec::new();
        };
        if method == "initialized" {
            return client.can_watch.then(watch_request).into_iter().collect();
        }
        let unit = client.unit;
        // Invalid notifications are ignored.
        match method.as_str() {
            "textDocument/didOpen" => {
                if let Ok(params) = serde_json::from_value::<DidOpenTextDocumentParams>(params) {
                    self.workspace.invalidate();
                    let item = params.text_document;
                    let buffer = Buffer::new(item.version, item.text);
                    self.buffers.insert(item.uri.0, buffer);
                }
            }
            "textDocument/didChange" => {
                if let Ok(params) = serde_json::from_value::<DidChangeTextDocumentParams>(params) {
                    let uri = params.text_document.text_document_identifier.uri.0;
                    if let Some(buffer) = self.buffers.get_mut(&uri) {
                        let version = params.text_document.version;
                        buffer.change(version, params.content_changes, unit);
                    }
                }
            }
            "textDocument/didClose" => {
                if let Ok(params) = serde_json::from_value::<DidCloseTextDocumentParams>(params) {
                    let uri = params.text_document.uri;
                    self.buffers.remove(&uri.0);
                    return vec![publish(uri.0, None, Vec::new())];
                }
            }
            "workspace/didChangeConfiguration" => {
                let settings = params.get("settings").unwrap_or(&Value::Null);
                let robot = client::configured_robot(settings);
                if let Some(client) = &mut self.client {
                    client.robot = robot;
                }
                self.invalidate();
            }
            "workspace/didChangeWatchedFiles" => {
                self.workspace.invalidate();
                self.invalidate();
            }
            _ => {}
        }
        Vec::new()
    }

    fn invalidate(&mut self) {
        self.buffers.values_mut().for_each(Buffer::invalidate);
    }

    /// Returns the open program at an address, checked for its robot; `None` if it is not open.
    pub(super) fn open_program<'a>(
        &'a mut self,
        uri: &'a str,
    ) -> Option<(OpenProgram<'a, W>, Rc<RobotConfig>)> {
        let client = self.client.as_ref()?;
        let (path, configured) = (path(uri), client.robot.as_deref());
        let workspace = &mut self.workspace;
        let config = workspace.robot(path.as_deref(), configured, client.lang);
        let buffer = self.buffers.get_mut(uri)?;
        let other_robot = || workspace.other_robot(path.as_deref()?, configured);
        let program = OpenProgram {
            uri,
            document: buffer.document(uri, &config, other_robot),
            client,
            workspace,
        };
        Some((program, config))
    }

    /// Returns the diagnostics of an open program, and the error about its robot unless it was shown before.
    pub fn diagnostics(&mut self, uri: &str) -> Vec<Message> {
        let Some((program, config)) = self.open_program(uri) else {
            return Vec::new();
        };
        let loaded = program.document.loaded();
        let diagnostics = convert::diagnostics(loaded, uri, program.client, program.workspace);
        let version = self.buffers.get(uri).map(|buffer| buffer.version);
        let mut messages = vec![publish(uri.to_owned(), version, diagnostics)];
        if let Some(error) = &config.error
            && !self.shown_errors.contains(error)
        {
            self.shown_errors.push(error.clone());
            let params = json!({ "type": 1, "message": error });
            messages.push(Notification::new("window/showMessage".to_owned(), params).into());
        }
        messages
    }
}

/// A program that is open in the editor.
#[derive(Debug)]
struct Buffer {
    version: i32,
    text: String,
    /// `None` until it is needed.
    document: Option<Document>,
    /// Its diagnostics have not been sent yet.
    is_due: bool,
}

impl Buffer {
    fn new(version: i32, text: String) -> Self {
        Buffer {
            version,
            text,
            document: None,
            is_due: true,
        }
    }

    /// Applies changes of the text in their order.
    fn change(&mut self, version: i32, changes: Vec<Change>, unit: Unit) {
        self.version = version;
        self.is_due = true;
        for change in changes {
            match change {
                Change::TextDocumentContentChangeWholeDocument(whole) => self.text = whole.text,
                Change::TextDocumentContentChangePartial(part) => {
                    let decoded = || Source::decode("", self.text.as_bytes(), Encoding::Utf8).0;
                    let bytes = match &self.document {
                        Some(document) => bytes(document.source(), part.range, unit),
                        None => bytes(&decoded(), part.range, unit),
                    };
                    self.text.replace_range(bytes, &part.text);
                }
            }
            self.invalidate();
        }
    }

    /// Drops the document; its diagnostics are due again.
    fn invalidate(&mut self) {
        self.is_due = true;
        if let Some(past) = self.document.take() {
            // Freeing a large document takes a while, and would delay the next answer.
            let _ = thread::Builder::new().spawn(|| drop(past));
        }
    }

    /// Computes what the next requests are likely to need.
    fn prepare(&self) {
        if let Some(document) = &self.document {
            document.prepare();
        }
    }

    /// Returns the document of the text for a robot; `other_robot` returns the warning that the crate around the file is for
    /// another one.
    fn document(
        &mut self,
        name: &str,
        config: &RobotConfig,
        other_robot: impl FnOnce() -> Option<Diagnostic>,
    ) -> &Document {
        self.document.get_or_insert_with(|| {
            let mut document = Document::new(name, &self.text, &config.options);
            document.judge(|loaded| {
                if let Some(robot) = &config.robot {
                    robot.warn(loaded);
                }
                tip_lint::add(loaded, other_robot().into_iter().collect());
            });
            document
        })
    }
}

/// Returns the bytes of a text in a range. A byte order mark is not part of the text's `Source`.
fn bytes(source: &Source, range: gen_lsp_types::Range, unit: Unit) -> Range<usize> {
    let span = Positions { source, unit }.span(range);
    let mark = source.mark().len();
    span.start + mark..span.end + mark
}

fn publish(
    uri: String,
    version: Option<i32>,
    diagnostics: Vec<gen_lsp_types::Diagnostic>,
) -> Message {
    let params = PublishDiagnosticsParams {
        uri: Uri(uri),
        version,
        diagnostics,
    };
    Notification::new("textDocument/publishDiagnostics".to_owned(), params).into()
}

/// Returns the request to be notified when a `tip.toml` or a description of a robot changes.
fn watch_request() -> Message {
    let watched = json!({ "watchers": [{ "globPattern": "**/*.toml" }] });
    let method = "workspace/didChangeWatchedFiles";
    let registrations = json!([{ "id": "toml", "method": method, "registerOptions": watched }]);
    let params = json!({ "registrations": registrations });
    let id = "watch".to_owned().into();
    Request::new(id, "client/registerCapability".to_owned(), params).into()
}

/// Returns the path of a `file:` address: `file:///x`, `file:/x` or `file://localhost/x`; `None` if it names no file of this
/// machine.
pub(super) fn path(uri: &str) -> Option<PathBuf> {
    let path = uri.strip_prefix("file:")?;
    let path = match path.strip_prefix("//") {
        Some(rest) => rest.strip_prefix("localhost").unwrap_or(rest),
        None => path,
    };
    if !path.starts_with('/') {
        return None;
    }
    let path = String::from_utf8(percent_decoded(path)).ok()?;
    // On Windows, the path of the address is /C:/folder.
    let is_drive =
        matches!(path.as_bytes(), [b'/', letter, b':', ..] if letter.is_ascii_alphabetic());
    Some(PathBuf::from(if is_drive { &path[1..] } else { &path }))
}

/// Returns the bytes of a text with `%XX` replaced by the byte. Another `%` stays.
fn percent_decoded(text: &str) -> Vec<u8> {
    let digit = |byte: u8| char::from(byte).to_digit(16);
    let mut bytes = Vec::with_capacity(text.len());
    let mut rest = text.as_bytes();
    while let [first, after @ ..] = rest {
        let code = match after {
            [high, low, ..] if *first == b'%' => digit(*high).zip(digit(*low)),
            _ => None,
        };
        match code {
            Some((high, low)) => {
                bytes.push((high * 16 + low) as u8);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    bytes
}

fn capabilities(encoding: &str) -> Value {
    json!({
        "positionEncoding": encoding,
        "textDocumentSync": { "openClose": true, "change": 2 },
        "hoverProvider": true,
        "definitionProvider": true,
        "referencesProvider": true,
        "documentHighlightProvider": true,
        "documentSymbolProvider": true,
        "renameProvider": { "prepareProvider": true },
        "completionProvider": { "triggerCharacters": [".", "%"] },
        "signatureHelpProvider": { "triggerCharacters": [" ", ","] },
        "codeActionProvider": { "codeActionKinds": ["quickfix", "source.fixAll"] },
        "documentFormattingProvider": true,
        "documentRangeFormattingProvider": true,
        "foldingRangeProvider": true,
        "inlayHintProvider": true,
        "semanticTokensProvider": {
            "legend": { "tokenTypes": convert::token_types(), "tokenModifiers": convert::TOKEN_MODIFIERS },
            "full": true,
            "range": true,
        },
    })
}

/// A message of the client, or the reason why its bytes are not a message.
pub type Incoming = Result<Box<Message>, String>;

/// Parses a message.
///
/// # Errors
/// The bytes are not a message of JSON-RPC.
pub fn parse(bytes: &[u8]) -> Incoming {
    match serde_json::from_slice(bytes) {
        Ok(Message::Notification(_)) if has_id(bytes) => {
            Err("an id is a number of 32 bits or a text".to_owned())
        }
        Ok(message) => Ok(Box::new(message)),
        Err(error) => Err(error.to_string()),
    }
}

/// Returns true if a message has an id, so that its sender waits for an answer.
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
