//! The state of a session: its beginning and end, the open programs, and who answers what.

use super::client::{self, Client};
use super::findings;
use super::open::Open;
use super::surroundings::{Chosen, Surroundings};
use super::tokens;
use gen_lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    PublishDiagnosticsParams, Uri,
};
use lsp_server::{ErrorCode, Message, Notification, Request, Response};
use serde::de::IgnoredAny;
use serde::{Deserialize, Deserializer};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::rc::Rc;
use tip_ide::Document;

/// A session with one editor.
pub(crate) struct Server<S> {
    pub(super) around: S,
    /// None before `initialize`.
    client: Option<Client>,
    /// `shutdown` was asked for.
    is_over: bool,
    /// Whether the end was announced, once there is one.
    end: Option<bool>,
    open: BTreeMap<String, Open>,
    /// What was complained of already.
    complaints: Vec<String>,
}

/// Why there is no answer.
#[derive(Debug)]
pub(super) struct Failure {
    code: ErrorCode,
    message: String,
}

impl Failure {
    pub(super) fn new(code: ErrorCode, message: impl Into<String>) -> Self {
        Failure {
            code,
            message: message.into(),
        }
    }
}

/// A program that is asked about.
pub(super) struct Asked<'a, S> {
    pub(super) uri: &'a str,
    pub(super) document: &'a Document,
    pub(super) client: &'a Client,
    pub(super) around: &'a mut S,
}

impl<S: Surroundings> Server<S> {
    /// A session before its first message.
    pub(crate) fn new(around: S) -> Self {
        Server {
            around,
            client: None,
            is_over: false,
            end: None,
            open: BTreeMap::new(),
            complaints: Vec::new(),
        }
    }

    /// How the session ended, if it did: whether `shutdown` came before `exit`.
    pub(crate) fn end(&self) -> Option<bool> {
        self.end
    }

    /// Takes a message; what there is to say to it at once.
    pub(crate) fn take(&mut self, message: Message) -> Vec<Message> {
        match message {
            Message::Request(request) => {
                let id = request.id.clone();
                vec![match self.request(request) {
                    Ok(result) => Response::new_ok(id, result).into(),
                    Err(failure) => {
                        Response::new_err(id, failure.code as i32, failure.message).into()
                    }
                }]
            }
            Message::Notification(notification) => self.notification(notification),
            // Whether the editor watches files changes nothing here.
            Message::Response(_) => Vec::new(),
        }
    }

    /// Findings that are not sent yet.
    pub(crate) fn due(&mut self) -> Vec<Message> {
        let mut messages = Vec::new();
        let due = self.open.iter().filter(|(_, open)| open.is_due);
        let due: Vec<String> = due.map(|(uri, _)| uri.clone()).collect();
        for uri in due {
            messages.extend(self.published(&uri));
        }
        messages
    }

    /// Uses a moment in which nothing is asked.
    pub(crate) fn rest(&self) {
        self.open.values().for_each(Open::prepare);
    }

    fn request(&mut self, request: Request) -> Result<Value, Failure> {
        let Request { method, params, .. } = request;
        match (method.as_str(), &self.client) {
            _ if self.is_over => Err(Failure::new(
                ErrorCode::InvalidRequest,
                "the session is shut down",
            )),
            ("initialize", None) => Ok(self.initialize(&params)),
            ("initialize", Some(_)) => Err(Failure::new(
                ErrorCode::InvalidRequest,
                "the session is initialized already",
            )),
            (_, None) => Err(Failure::new(
                ErrorCode::ServerNotInitialized,
                "initialize comes first",
            )),
            ("shutdown", Some(_)) => {
                self.is_over = true;
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
            self.end = Some(self.is_over);
            return Vec::new();
        }
        let Some(client) = &self.client else {
            return Vec::new();
        };
        if method == "initialized" {
            return client.can_watch.then(watch).into_iter().collect();
        }
        let unit = client.unit;
        // Nobody waits for the answer to a bad one.
        match method.as_str() {
            "textDocument/didOpen" => {
                if let Ok(params) = serde_json::from_value::<DidOpenTextDocumentParams>(params) {
                    self.around.forget();
                    let item = params.text_document;
                    let open = Open::new(Some(item.version), item.text);
                    self.open.insert(item.uri.0, open);
                }
            }
            "textDocument/didChange" => {
                if let Ok(params) = serde_json::from_value::<DidChangeTextDocumentParams>(params) {
                    let uri = params.text_document.text_document_identifier.uri.0;
                    if let Some(open) = self.open.get_mut(&uri) {
                        let version = Some(params.text_document.version);
                        open.change(version, params.content_changes, unit);
                    }
                }
            }
            "textDocument/didClose" => {
                if let Ok(params) = serde_json::from_value::<DidCloseTextDocumentParams>(params) {
                    let uri = params.text_document.uri;
                    self.open.remove(&uri.0);
                    return vec![publish(uri.0, None, Vec::new())];
                }
            }
            "workspace/didChangeConfiguration" => {
                let settings = params.get("settings").unwrap_or(&Value::Null);
                let robot = client::robot(settings);
                if let Some(client) = &mut self.client {
                    client.robot = robot;
                }
                self.forget();
            }
            "workspace/didChangeWatchedFiles" => {
                self.around.forget();
                self.forget();
            }
            _ => {}
        }
        Vec::new()
    }

    fn forget(&mut self) {
        self.open.values_mut().for_each(Open::forget);
    }

    /// The program of an address, for its robot.
    pub(super) fn asked<'a>(&'a mut self, uri: &'a str) -> Option<(Asked<'a, S>, Rc<Chosen>)> {
        let client = self.client.as_ref()?;
        let (path, robot) = (path(uri), client.robot.as_deref());
        let around = &mut self.around;
        let chosen = around.robot(path.as_deref(), robot, client.lang);
        let open = self.open.get_mut(uri)?;
        let other = || around.other_robot(path.as_deref()?, robot);
        let asked = Asked {
            uri,
            document: open.document(uri, &chosen, other),
            client,
            around,
        };
        Some((asked, chosen))
    }

    /// The findings about a program.
    fn published(&mut self, uri: &str) -> Vec<Message> {
        let Some((asked, chosen)) = self.asked(uri) else {
            return Vec::new();
        };
        let loaded = asked.document.loaded();
        let found = findings::findings(loaded, uri, asked.client, asked.around);
        let mut version = None;
        if let Some(open) = self.open.get_mut(uri) {
            open.is_due = false;
            version = open.version;
        }
        let mut messages = vec![publish(uri.to_owned(), version, found)];
        if let Some(complaint) = &chosen.complaint
            && !self.complaints.contains(complaint)
        {
            self.complaints.push(complaint.clone());
            let params = json!({ "type": 1, "message": complaint });
            messages.push(Notification::new("window/showMessage".to_owned(), params).into());
        }
        messages
    }
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

/// Asks the editor to say when a `tip.toml` or a description changes.
fn watch() -> Message {
    let watched = json!({ "watchers": [{ "globPattern": "**/*.toml" }] });
    let method = "workspace/didChangeWatchedFiles";
    let registrations = json!([{ "id": "toml", "method": method, "registerOptions": watched }]);
    let params = json!({ "registrations": registrations });
    let id = "watch".to_owned().into();
    Request::new(id, "client/registerCapability".to_owned(), params).into()
}

/// The file of an address, if it is one.
pub(super) fn path(uri: &str) -> Option<PathBuf> {
    let path = uri.strip_prefix("file://")?;
    let mut bytes = Vec::new();
    let mut rest = path.as_bytes();
    while let [first, after @ ..] = rest {
        let code = after
            .get(..2)
            .and_then(|digits| std::str::from_utf8(digits).ok());
        let code = code.and_then(|digits| u8::from_str_radix(digits, 16).ok());
        match code.filter(|_| *first == b'%') {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    let path = String::from_utf8(bytes).ok()?;
    // On Windows the address is /C:/folder.
    let is_drive = path.get(2..3) == Some(":");
    Some(PathBuf::from(if is_drive { &path[1..] } else { &path }))
}

/// What the server can do.
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
        "foldingRangeProvider": true,
        "inlayHintProvider": true,
        "semanticTokensProvider": {
            "legend": { "tokenTypes": tokens::legend(), "tokenModifiers": tokens::MODIFIERS },
            "full": true,
            "range": true,
        },
    })
}

/// A message of the editor, or why something that it sent is none.
pub(crate) type Incoming = Result<Box<Message>, String>;

/// Reads a message.
pub(crate) fn parse(bytes: &[u8]) -> Incoming {
    match serde_json::from_slice(bytes) {
        Ok(Message::Notification(_)) if has_id(bytes) => {
            Err("an id is a number of 32 bits or a text".to_owned())
        }
        Ok(message) => Ok(Box::new(message)),
        Err(error) => Err(error.to_string()),
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
