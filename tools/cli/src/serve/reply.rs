//! Answers of HTTP.

use std::io::{self, Read, Write};
use std::net::{Shutdown, TcpStream};
use std::time::{Duration, Instant};

/// A client has so long to take a page.
const PATIENCE: Duration = Duration::from_secs(30);

/// What a client sends on after its request is read for so long: who closes before loses the answer.
const PARTING: Duration = Duration::from_millis(200);

/// What every answer says: nothing is cached, guessed, framed, or passed on to other sites.
const FIELDS: &str = "Cache-Control: no-store\r\nX-Content-Type-Options: nosniff\r\nX-Frame-Options: DENY\r\n\
    Referrer-Policy: no-referrer\r\nCross-Origin-Resource-Policy: same-origin\r\nConnection: close\r\n";

/// Sends the page.
pub(super) fn page(stream: &mut TcpStream, page: &str) -> io::Result<()> {
    send(stream, "200 OK", "text/html; charset=utf-8", page)
}

/// Sends a refusal, such as `404 Not Found`, with a word for people.
pub(super) fn refusal(stream: &mut TcpStream, status: &str, word: &str) -> io::Result<()> {
    send(
        stream,
        status,
        "text/plain; charset=utf-8",
        &format!("{word}\n"),
    )
}

fn send(stream: &mut TcpStream, status: &str, kind: &str, body: &str) -> io::Result<()> {
    stream.set_write_timeout(Some(PATIENCE))?;
    let length = body.len();
    let head = format!(
        "HTTP/1.1 {status}\r\nContent-Type: {kind}\r\nContent-Length: {length}\r\n{FIELDS}\r\n"
    );
    stream.write_all(head.as_bytes())?;
    stream.write_all(body.as_bytes())?;
    stream.flush()?;
    part(stream);
    Ok(())
}

/// Ends a conversation: nothing more is said, and what comes is taken for a moment, however slowly it comes.
pub(super) fn part(stream: &mut TcpStream) {
    let end = Instant::now() + PARTING;
    let mut part = [0; 4096];
    let mut goes_on = stream.shutdown(Shutdown::Write).is_ok();
    while goes_on {
        let left = end.saturating_duration_since(Instant::now());
        goes_on = !left.is_zero()
            && stream.set_read_timeout(Some(left)).is_ok()
            && matches!(stream.read(&mut part), Ok(1..));
    }
}
