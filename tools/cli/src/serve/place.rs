//! The place where a page is reached: an address of this machine, which other machines are invited to.

use super::connections::Guard;
use super::invitation;
use crate::error::Error;
use crate::report;
use std::io::{self, IsTerminal};
use std::net::{SocketAddr, TcpListener};

/// The address that this machine alone reaches, with a free port.
pub(crate) const OWN: &str = "127.0.0.1:0";

/// The place where the page is reached.
pub(super) struct Place {
    pub(super) listener: TcpListener,
    pub(super) guard: Guard,
}

impl Place {
    /// Claims the address.
    pub(super) fn bind(listen: SocketAddr) -> Result<Self, Error> {
        let failed = |error: io::Error| Error::Failed(format!("{listen}: {error}"));
        let listener = TcpListener::bind(listen).map_err(failed)?;
        let own = listener.local_addr().map_err(failed)?;
        let guard = Guard::new(own).map_err(Error::Failed)?;
        Ok(Place { listener, guard })
    }

    /// Shows the address for other machines, which a phone reads by its camera, if there is a terminal to show it on.
    pub(super) fn invite(&self) {
        let own = self.listener.local_addr().ok();
        let reached = own.and_then(invitation::reached_at);
        let address = reached.map(|reached| self.guard.address_at(reached));
        let address = address.filter(|_| io::stderr().is_terminal());
        if let Some((code, address)) = address.and_then(|it| Some((invitation::code(&it)?, it))) {
            report::complain(&format!("{address}\n{code}\n"));
        }
    }
}
