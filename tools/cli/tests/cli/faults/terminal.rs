//! A terminal for a run to read keys from.

use rustix::io::write;
use rustix::pty::{OpenptFlags, grantpt, ioctl_tiocgptpeer, openpt, unlockpt};
use rustix::termios::tcgetattr;
use std::os::fd::OwnedFd;
use std::process::Stdio;

const FLAGS: OpenptFlags = OpenptFlags::RDWR
    .union(OpenptFlags::NOCTTY)
    .union(OpenptFlags::CLOEXEC);

/// Both ends of a pseudo terminal.
pub(crate) struct Pty {
    pub(crate) fingers: OwnedFd,
    pub(crate) line: OwnedFd,
}

impl Pty {
    pub(crate) fn new() -> Self {
        let fingers = openpt(FLAGS).expect("a pseudo terminal");
        grantpt(&fingers).expect("ours");
        unlockpt(&fingers).expect("ours");
        let line = ioctl_tiocgptpeer(&fingers, FLAGS).expect("its other end");
        Pty { fingers, line }
    }

    /// The end that a process reads.
    pub(crate) fn input(&self) -> Stdio {
        self.line.try_clone().expect("another handle").into()
    }

    /// A key is pressed.
    pub(crate) fn press(&self, key: u8) {
        self.send(&[key]);
    }

    /// A key is pressed that has several bytes, such as an arrow; they come together.
    pub(crate) fn send(&self, key: &[u8]) {
        assert_eq!(write(&self.fingers, key), Ok(key.len()));
    }

    /// Returns the settings for keys, in words that can be compared.
    pub(crate) fn behaviour(&self) -> String {
        format!("{:?}", tcgetattr(&self.line).expect("a terminal"))
    }
}
