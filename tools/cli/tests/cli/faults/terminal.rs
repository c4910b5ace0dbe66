//! A terminal for a run to read keys from.

use rustix::io::{read, write};
use rustix::pty::{OpenptFlags, grantpt, ioctl_tiocgptpeer, openpt, unlockpt};
use rustix::termios::tcgetattr;
use std::os::fd::OwnedFd;
use std::process::Stdio;

const FLAGS: OpenptFlags = OpenptFlags::RDWR.union(OpenptFlags::NOCTTY);

/// Both ends of a pseudo terminal.
pub(crate) struct Pty {
    fingers: OwnedFd,
    line: OwnedFd,
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
        assert_eq!(write(&self.fingers, &[key]), Ok(1));
    }

    /// What is shown until every process that had the line is gone.
    pub(crate) fn shown(self) -> String {
        let Pty { fingers, line } = self;
        drop(line);
        let (mut shown, mut piece) = (Vec::new(), [0; 4096]);
        // A terminal that nobody holds any more fails to be read.
        while let Ok(count @ 1..) = read(&fingers, &mut piece) {
            shown.extend_from_slice(&piece[..count]);
        }
        String::from_utf8(shown).expect("UTF-8")
    }

    /// How it treats keys, in words that can be compared.
    pub(crate) fn behaviour(&self) -> String {
        format!("{:?}", tcgetattr(&self.line).expect("a terminal"))
    }
}
