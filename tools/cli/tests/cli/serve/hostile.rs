//! Clients that mean no good, and those that do not know better.

use super::client::Server;
use super::counts;
use serde_json::json;
use std::io::Write;
use std::net::TcpStream;
use tungstenite::{Error, Message};

#[track_caller]
fn is_refused(reply: &str, status: u16) {
    assert!(
        reply.starts_with(&format!("HTTP/1.1 {status} ")),
        "{reply:.300}"
    );
    assert!(!reply.contains("<script"), "{status}");
}

#[test]
fn without_the_token_there_is_nothing() {
    let server = Server::begin(&counts("serve-token"), &["counts.prg", "--paused"]);
    for target in [
        "/",
        "/?token=",
        "/?token=0123456789abcdef0123456789abcdef",
        "/live",
        "/other",
    ] {
        is_refused(&server.get(target, &[]), 403);
    }
    let almost = server.target("/").replace("token=", "token=0");
    is_refused(&server.get(&almost, &[]), 403);
    let origin = format!("http://{}", server.host());
    assert_eq!(server.open("/live", Some(&origin)).err(), Some(403));
    assert_eq!(server.open("/live?token=0", Some(&origin)).err(), Some(403));
    is_refused(&server.get(&server.target("/counts.prg"), &[]), 404);
    is_refused(&server.get(&server.target("/../../etc/passwd"), &[]), 404);
    server.viewer().does(json!({"do": "step", "cycles": 1}));
}

#[test]
fn a_page_from_elsewhere_may_not_look() {
    let server = Server::begin(&counts("serve-origin"), &["counts.prg", "--paused"]);
    let (own, live) = (format!("http://{}", server.host()), server.target("/live"));
    for origin in [
        None,
        Some("null"),
        Some("http://evil.example"),
        Some("http://localhost"),
        Some("file://"),
    ] {
        assert_eq!(server.open(&live, origin).err(), Some(403), "{origin:?}");
    }
    assert!(server.open(&live, Some(&own)).is_ok());
    // A name that leads here may belong to someone else.
    let port = server.host().rsplit(':').next().expect("a port");
    for host in [
        "evil.example",
        &format!("evil.example:{port}"),
        "127.0.0.1",
        "127.0.0.1:1",
    ] {
        is_refused(&server.get(&server.target("/"), &[("Host", host)]), 421);
    }
    is_refused(
        &server.get(
            &server.target("/"),
            &[("Host", server.host()), ("Host", "b")],
        ),
        421,
    );
    let reply = server.get(
        &server.target("/"),
        &[("Host", &format!("localhost:{port}"))],
    );
    assert!(reply.starts_with("HTTP/1.1 200 "), "{reply:.100}");
}

#[test]
fn what_is_no_http_is_refused() {
    let server = Server::begin(&counts("serve-http"), &["counts.prg", "--paused"]);
    is_refused(&server.say(b"\x16\x03\x01\x02\x00\x01\x00\r\n\r\n"), 400);
    is_refused(
        &server.say(format!("GET /{} ", "a".repeat(100_000)).as_bytes()),
        431,
    );
    let host = server.host();
    let post = format!(
        "POST {} HTTP/1.1\r\nHost: {host}\r\nContent-Length: 0\r\n\r\n",
        server.target("/")
    );
    is_refused(&server.say(post.as_bytes()), 405);
    let origin = format!("http://{host}");
    is_refused(
        &server.get(&server.target("/live"), &[("Origin", &origin)]),
        426,
    );
    // A client that says nothing, and one that goes in the middle.
    let silent = TcpStream::connect(host).expect("it listens");
    let mut hasty = TcpStream::connect(host).expect("it listens");
    hasty.write_all(b"GET / HT").expect("it reads");
    drop(hasty);
    server.viewer().does(json!({"do": "step", "cycles": 1}));
    drop(silent);
}

#[test]
fn bad_messages_are_answered_and_worse_ones_end_the_viewer_alone() {
    let server = Server::begin(&counts("serve-bad"), &["counts.prg", "--paused"]);
    let mut good = server.viewer();
    let mut bad = server.viewer();
    for (text, error) in [
        ("", "malformed"),
        ("{\"do\":", "malformed"),
        ("[1]", "malformed"),
        ("{\"do\":\"format_disk\"}", "unknown"),
        ("{\"do\":\"event\",\"event\":\"jump\"}", "unknown"),
        ("{\"do\":\"save\",\"path\":\"/etc/passwd\"}", "unknown"),
    ] {
        bad.say(text);
        let answer = bad.update("answer");
        assert_eq!(
            (&answer["ok"], &answer["error"]),
            (&json!(false), &json!(error)),
            "{text}"
        );
    }
    let nested = "[".repeat(200_000);
    bad.say(&nested);
    assert_eq!(bad.update("answer")["error"], "malformed");
    bad.does(json!({"do": "step", "cycles": 1}));
    // Binary, too long, not UTF-8.
    bad.socket
        .send(Message::binary(vec![0; 10]))
        .expect("it is there");
    assert!(bad.is_over());
    let mut huge = server.viewer();
    let sent = huge.socket.send(Message::text("x".repeat(9 << 20)));
    assert!(
        matches!(sent, Ok(()) | Err(Error::Io(_) | Error::ConnectionClosed)),
        "{sent:?}"
    );
    assert!(huge.is_over());
    good.does(json!({"do": "step", "cycles": 1}));
}

#[test]
fn a_flood_ends_the_flooder_alone() {
    let server = Server::begin(&counts("serve-flood"), &["counts.prg", "--paused"]);
    let mut good = server.viewer();
    let mut flooder = server.viewer();
    let flood = Message::text("{\"do\":\"event\",\"event\":\"key A\"}");
    let mut sent = 0;
    while sent < 200_000 && flooder.socket.send(flood.clone()).is_ok() {
        sent += 1;
    }
    assert!(flooder.is_over());
    good.does(json!({"do": "step", "cycles": 1}));
    good.until(|viewer| viewer.cycles == 2);
}

#[test]
fn there_are_not_too_many_viewers() {
    let server = Server::begin(&counts("serve-many"), &["counts.prg", "--paused"]);
    let all: Vec<_> = (0..64).map(|_| server.viewer()).collect();
    let reply = server.get(&server.target("/"), &[]);
    is_refused(&reply, 503);
    drop(all);
    let begin = std::time::Instant::now();
    while server
        .get(&server.target("/"), &[])
        .starts_with("HTTP/1.1 503 ")
    {
        assert!(begin.elapsed().as_secs() < 60, "nobody is there any more");
        std::thread::sleep(std::time::Duration::from_millis(50));
    }
}

#[test]
fn strangers_keep_nobody_out_who_knows_the_token() {
    let server = Server::begin(&counts("serve-crowd"), &["counts.prg", "--paused"]);
    let mut viewer = server.viewer();
    let crowd = || {
        let begun = (0..150).map(|_| {
            let mut stream = TcpStream::connect(server.host()).expect("it listens");
            // The oldest ones are cut off.
            let _ = stream.write_all(b"GET / HT");
            stream
        });
        begun.collect::<Vec<_>>()
    };
    let before = crowd();
    // Nothing of what a refused client sends is waited for.
    for _ in 0..3 {
        let reply = server.get(&server.target("/"), &[]);
        assert!(reply.starts_with("HTTP/1.1 200 "), "{reply:.100}");
    }
    let mut later = server.viewer();
    let after = crowd();
    viewer.does(json!({"do": "step", "cycles": 1}));
    later.does(json!({"do": "step", "cycles": 1}));
    drop((before, after));
}

#[test]
fn an_emergency_stop_waits_for_no_text() {
    let server = Server::begin(&counts("serve-stop-now"), &["counts.prg", "--paused"]);
    let (mut one, mut other) = (server.viewer(), server.viewer());
    other.until(|viewer| viewer.findings["version"] == 1);
    let wrong = format!(
        "3.1\n\n\n{}END\n",
        "SLEPE 20\nWIAT_INPOS ALL\nGOTOO L\n".repeat(11_000)
    );
    one.until(|viewer| viewer.version == 1);
    one.does(json!({"do": "edit", "text": wrong, "base": 1, "by": "one"}));
    other.until(|viewer| viewer.version == 2);
    one.say(&json!({"do": "restart", "id": 1000}).to_string());
    other.does(json!({"do": "event", "event": "key 0x0D"}));
    other.until(|viewer| viewer.status["outcome"]["how"] == "emergency");
    assert_eq!(
        other.findings["version"], 1,
        "the text is still being checked"
    );
}
