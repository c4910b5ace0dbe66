//! A served program, and a viewer of it.

use crate::support::Folder;
use rustix::process::{Pid, Signal, WaitOptions, kill_process, waitpid};
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};
use tungstenite::client::IntoClientRequest;
use tungstenite::http::HeaderValue;
use tungstenite::{Error, Message, WebSocket};

/// Nothing takes so long, on however busy a machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// Time between two signs of life of a viewer that drives.
const SOON: Duration = Duration::from_millis(50);

/// `tip serve` while it runs.
pub(super) struct Server {
    child: Child,
    address: String,
}

impl Server {
    pub(super) fn begin(folder: &Folder, arguments: &[&str]) -> Self {
        Self::with_keys(folder, arguments, Stdio::null())
    }

    /// Begins with a keyboard.
    pub(super) fn with_keys(folder: &Folder, arguments: &[&str], keys: Stdio) -> Self {
        let mut command = folder.command(&[&["serve", "--quiet"], arguments].concat());
        command.stdin(keys).stdout(Stdio::piped());
        let mut child = command.spawn().expect("tip starts");
        let mut address = String::new();
        let mut lines = BufReader::new(child.stdout.take().expect("piped"));
        lines.read_line(&mut address).expect("UTF-8");
        Server {
            child,
            address: address.trim_end().to_owned(),
        }
    }

    pub(super) fn address(&self) -> &str {
        &self.address
    }

    /// `127.0.0.1:PORT`
    pub(super) fn host(&self) -> &str {
        let rest = self.address.strip_prefix("http://").expect("an address");
        rest.split('/').next().expect("a host")
    }

    /// A path with the token.
    pub(super) fn target(&self, path: &str) -> String {
        let (_, query) = self.address.split_once('?').expect("a token");
        format!("{path}?{query}")
    }

    /// Returns the response of the server to some bytes.
    pub(super) fn say(&self, bytes: &[u8]) -> String {
        let mut stream = TcpStream::connect(self.host()).expect("it listens");
        stream.set_read_timeout(Some(PATIENCE)).expect("a timeout");
        stream.write_all(bytes).expect("it reads");
        let mut reply = Vec::new();
        // It may close while bytes are on their way to it.
        let _ = stream.read_to_end(&mut reply);
        String::from_utf8_lossy(&reply).into_owned()
    }

    /// Returns the response of the server to a GET with these fields; the host is that of the server unless one is given.
    pub(super) fn get(&self, target: &str, fields: &[(&str, &str)]) -> String {
        let mut request = format!("GET {target} HTTP/1.1\r\n");
        if fields.iter().all(|(name, _)| *name != "Host") {
            request += &format!("Host: {}\r\n", self.host());
        }
        for (name, value) in fields {
            request += &format!("{name}: {value}\r\n");
        }
        self.say(format!("{request}\r\n").as_bytes())
    }

    /// Opens a WebSocket as a page of this origin does; the status if it is refused.
    pub(super) fn open(
        &self,
        target: &str,
        origin: Option<&str>,
    ) -> Result<WebSocket<TcpStream>, u16> {
        open(self.host(), target, origin)
    }

    /// A viewer, as the page makes one.
    pub(super) fn viewer(&self) -> Socket {
        Socket::of(&self.address)
    }

    /// Suspends the process, and lets it go on.
    pub(super) fn suspend(&self) {
        let pid = Pid::from_child(&self.child);
        kill_process(pid, Signal::STOP).expect("it runs");
        waitpid(Some(pid), WaitOptions::UNTRACED).expect("it is suspended");
        kill_process(pid, Signal::CONT).expect("it is there");
    }

    /// Ends it by Ctrl-C, and returns the exit status.
    pub(super) fn end(mut self) -> Option<i32> {
        kill_process(Pid::from_child(&self.child), Signal::INT).expect("it runs");
        self.child.wait().expect("it ends").code()
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Opens a WebSocket at `127.0.0.1:PORT` as a page of this origin does; the status if it is refused.
fn open(host: &str, target: &str, origin: Option<&str>) -> Result<WebSocket<TcpStream>, u16> {
    let address = format!("ws://{host}{target}");
    let mut request = address.into_client_request().expect("a request");
    if let Some(origin) = origin {
        let origin = HeaderValue::from_str(origin).expect("a value");
        request.headers_mut().insert("Origin", origin);
    }
    let stream = TcpStream::connect(host).expect("it listens");
    stream.set_read_timeout(Some(PATIENCE)).expect("a timeout");
    match tungstenite::client(request, stream) {
        Ok((socket, _)) => Ok(socket),
        Err(tungstenite::HandshakeError::Failure(Error::Http(reply))) => {
            Err(reply.status().as_u16())
        }
        Err(error) => panic!("{error}"),
    }
}

/// A viewer, and what it knows.
pub(crate) struct Socket {
    pub(super) socket: WebSocket<TcpStream>,
    id: u64,
    pub(super) run: u64,
    pub(super) cycles: u64,
    frames: BTreeMap<u64, Vec<i64>>,
    scalars: Vec<String>,
    sets: Vec<Value>,
    pub(super) messages: Vec<String>,
    pub(super) text: String,
    pub(super) version: u64,
    pub(super) findings: Value,
    pub(super) status: Value,
    /// The state of a robot on servos, or of a lesson.
    pub(crate) robot: Value,
}

impl Socket {
    /// A viewer, as the page at an address makes one.
    pub(crate) fn of(address: &str) -> Self {
        let rest = address.strip_prefix("http://").expect("an address");
        let (host, query) = rest.split_once("/?").expect("a token");
        let origin = format!("http://{host}");
        let socket = open(host, &format!("/live?{query}"), Some(&origin));
        Socket::new(socket.expect("it may come in"))
    }

    /// The newest motion, in hundredths of mm or deg.
    pub(crate) fn motion(&self) -> &[i64] {
        let newest = self.frames.last_key_value();
        newest.map_or(&[], |(_, motion)| motion)
    }

    fn new(socket: WebSocket<TcpStream>) -> Self {
        Socket {
            socket,
            id: 0,
            run: 0,
            cycles: 0,
            frames: BTreeMap::new(),
            scalars: Vec::new(),
            sets: Vec::new(),
            messages: Vec::new(),
            text: String::new(),
            version: 0,
            findings: Value::Null,
            status: Value::Null,
            robot: Value::Null,
        }
    }

    /// The next update or answer, which it keeps in mind.
    pub(super) fn next(&mut self) -> Value {
        loop {
            match self.socket.read().expect("it is there") {
                Message::Text(text) => {
                    let update = serde_json::from_str(&text).expect("JSON");
                    self.take(&update);
                    return update;
                }
                Message::Ping(_) | Message::Pong(_) => {}
                other => panic!("{other}"),
            }
        }
    }

    fn take(&mut self, update: &Value) {
        match update["type"].as_str().expect("a type") {
            "run" => {
                self.run = update["run"].as_u64().expect("a number");
                self.cycles = 0;
                self.frames.clear();
                self.sets.clear();
                self.messages.clear();
                let names = update["script"]["scalars"].as_array().expect("names");
                let names = names
                    .iter()
                    .map(|name| name.as_str().expect("text").to_owned());
                self.scalars = names.collect();
            }
            "more" => {
                let from = update["from"].as_u64().expect("a cycle");
                self.frames.retain(|cycle, _| *cycle < from);
                for frames in [&update["frames"], &update["now"]] {
                    for (row, cycle) in sums(&frames[0]).into_iter().enumerate() {
                        let motion = frames.as_array().into_iter().flatten().skip(1);
                        let motion = motion.map(|column| sums(column)[row]);
                        self.frames.insert(cycle as u64, motion.collect());
                    }
                }
                self.sets.retain(|set| set[0].as_u64() < Some(from));
                for scalar in 0..self.scalars.len() {
                    let set = &update["log"][format!("set.{scalar}")];
                    for (row, cycle) in sums(&set[0]).into_iter().enumerate() {
                        self.sets.push(json!([cycle, scalar, set[1][row]]));
                    }
                }
                self.sets.sort_by_key(|set| set[0].as_u64());
                let texts = update["log"]["message"][1].as_array().into_iter().flatten();
                let texts = texts.map(|text| text.as_str().expect("text").to_owned());
                self.messages.extend(texts);
                self.cycles = update["cycles"].as_u64().expect("a number");
            }
            "text" => {
                self.text = update["text"].as_str().expect("text").to_owned();
                self.version = update["version"].as_u64().expect("a number");
            }
            "findings" => self.findings = update.clone(),
            "status" => self.status = update.clone(),
            "robot" | "lesson" => self.robot = update.clone(),
            "answer" => {}
            other => panic!("{other}"),
        }
    }

    /// The next update of a type.
    pub(super) fn update(&mut self, kind: &str) -> Value {
        loop {
            let update = self.next();
            if update["type"] == kind {
                return update;
            }
        }
    }

    /// Takes an update if one comes soon.
    pub(super) fn next_soon(&mut self) {
        let wait = |socket: &Self, time| socket.socket.get_ref().set_read_timeout(Some(time));
        wait(self, SOON).expect("a timeout");
        match self.socket.read() {
            Ok(Message::Text(text)) => self.take(&serde_json::from_str(&text).expect("JSON")),
            Ok(Message::Ping(_) | Message::Pong(_)) => {}
            Err(Error::Io(_)) => {}
            other => panic!("{other:?}"),
        }
        wait(self, PATIENCE).expect("a timeout");
    }

    /// Takes updates until it knows something.
    #[track_caller]
    pub(crate) fn until(&mut self, knows: impl Fn(&Self) -> bool) {
        let end = Instant::now() + PATIENCE;
        while !knows(self) {
            assert!(
                Instant::now() < end,
                "{} cycles, {}",
                self.cycles,
                self.status
            );
            self.next();
        }
    }

    /// Asks for something, and returns the answer.
    pub(crate) fn ask(&mut self, mut request: Value) -> Value {
        self.id += 1;
        request["id"] = json!(self.id);
        self.say(&request.to_string());
        loop {
            let answer = self.update("answer");
            if answer["id"] == self.id {
                return answer;
            }
        }
    }

    #[track_caller]
    pub(crate) fn does(&mut self, request: Value) {
        let answer = self.ask(request);
        assert_eq!(answer["ok"], true, "{answer}");
    }

    pub(super) fn say(&mut self, text: &str) {
        let said = self.socket.send(Message::text(text));
        said.expect("it is there");
    }

    /// Returns the number of cycles of a paused run: everything has arrived when an answer has nothing after it.
    pub(super) fn settled(&mut self) -> u64 {
        // Updates are made after answers; the second answer follows all of them.
        for _ in 0..2 {
            self.ask(json!({"do": "pause"}));
            std::thread::sleep(Duration::from_millis(200));
        }
        self.ask(json!({"do": "pause"}));
        self.cycles
    }

    /// Returns the newest cycle as the page shows it.
    pub(super) fn shown(&self) -> String {
        let frame = self.frames.last_key_value();
        let values: Vec<_> = self.scalars.iter().map(|name| self.value(name)).collect();
        format!("{} {frame:?} {values:?}", self.cycles)
    }

    pub(super) fn value(&self, name: &str) -> Option<f64> {
        let scalar = self.scalars.iter().position(|own| own == name)? as u64;
        let mut sets = self.sets.iter().rev();
        sets.find(|set| set[1] == scalar)?[2].as_f64()
    }

    /// Returns true if the server closes the connection.
    pub(super) fn is_over(&mut self) -> bool {
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end {
            match self.socket.read() {
                Ok(Message::Close(_)) | Err(_) => return true,
                Ok(_) => {}
            }
        }
        false
    }
}

/// The numbers of a column that holds their differences.
fn sums(column: &Value) -> Vec<i64> {
    let differences = column.as_array().into_iter().flatten();
    let mut sum = 0;
    let sums = differences.map(|difference| {
        sum += difference.as_i64().expect("a whole number");
        sum
    });
    sums.collect()
}
