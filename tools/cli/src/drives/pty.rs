//! Simulated servos on a pseudo-terminal, in real time: a bus for this command and for other masters.

use super::robot::{Mishaps, Setup};
use crate::error::Error;
use crate::{Status, interrupt};
use std::io;
use std::time::{Duration, Instant};
use tipc::message::Lang;

/// Serves a bus until it is interrupted; `announce` gets the name of its port.
#[cfg(unix)]
pub(super) fn serve(
    setup: &Setup,
    mut mishaps: Mishaps,
    _: Lang,
    announce: impl FnOnce(String) -> Result<(), Error>,
) -> Result<Status, Error> {
    use nix::fcntl::{OFlag, open};
    use nix::poll::{PollFd, PollFlags, ppoll};
    use nix::pty::{grantpt, posix_openpt, ptsname_r, unlockpt};
    use nix::sys::stat::Mode;
    use nix::sys::termios::{SetArg, cfmakeraw, tcgetattr, tcsetattr};
    use nix::sys::time::TimeSpec;
    use nix::unistd::{read, write};
    use std::os::fd::AsFd;
    let failed = |error: nix::Error| Error::Failed(io::Error::from(error).to_string());

    let pty = posix_openpt(OFlag::O_RDWR | OFlag::O_NOCTTY).map_err(failed)?;
    grantpt(&pty).map_err(failed)?;
    unlockpt(&pty).map_err(failed)?;
    let name = ptsname_r(&pty).map_err(failed)?;
    // Kept open, so that masters can come and go.
    let flags = OFlag::O_RDWR | OFlag::O_NOCTTY;
    let other = open(name.as_str(), flags, Mode::empty()).map_err(failed)?;
    let mut settings = tcgetattr(&other).map_err(failed)?;
    cfmakeraw(&mut settings);
    tcsetattr(&other, SetArg::TCSANOW, &settings).map_err(failed)?;
    announce(name)?;

    let mut bus = setup.simulated(&mishaps);
    let start = Instant::now();
    while !interrupt::is_requested() {
        let now = start.elapsed().as_micros() as u64;
        bus.advance(now);
        mishaps.happen(&mut bus, now);
        let due = bus.take_bytes(now, 4096);
        let mut left = &due[..];
        while !left.is_empty() {
            let count = write(&pty, left).map_err(failed)?;
            left = &left[count..];
        }
        let until = bus.next_byte().unwrap_or(now + 5000);
        let wait = TimeSpec::from_duration(Duration::from_micros(until.saturating_sub(now)));
        let mut polled = [PollFd::new(pty.as_fd(), PollFlags::POLLIN)];
        match ppoll(&mut polled, Some(wait), None) {
            Ok(0) | Err(nix::Error::EINTR) => continue,
            Ok(_) => {}
            Err(error) => return Err(failed(error)),
        }
        let mut bytes = [0; 1024];
        let count = read(&pty, &mut bytes).map_err(failed)?;
        bus.receive(&bytes[..count], start.elapsed().as_micros() as u64);
    }
    Ok(Status::Interrupted)
}

#[cfg(not(unix))]
pub(super) fn serve(
    _: &Setup,
    _: Mishaps,
    lang: Lang,
    _: impl FnOnce(String) -> Result<(), Error>,
) -> Result<Status, Error> {
    let _ = (
        io::stdin(),
        Instant::now(),
        Duration::ZERO,
        interrupt::is_requested(),
    );
    Err(Error::failed(super::message::Driving::NotHere, lang))
}
