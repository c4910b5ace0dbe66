//! The address where a page is reached, on this machine and, as a QR code for the camera of a phone, from others.

use super::connections::Guard;
use crate::error::Error;
use crate::report;
use qrcode::QrCode;
use qrcode::render::unicode::Dense1x2;
use std::io::{self, IsTerminal};
use std::net::{IpAddr, Ipv4Addr, Ipv6Addr, SocketAddr, TcpListener, UdpSocket};

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
        let reached = own.and_then(reached_at);
        let address = reached.map(|reached| self.guard.address_at(reached));
        let address = address.filter(|_| io::stderr().is_terminal());
        if let Some((code, address)) = address.and_then(|it| Some((code(&it)?, it))) {
            report::complain(&format!("{address}\n{code}\n"));
        }
    }
}

/// Returns the address at which other machines reach a server; `None` if only this machine does, or if it is in no network.
fn reached_at(own: SocketAddr) -> Option<SocketAddr> {
    if own.ip().is_loopback() {
        return None;
    }
    let ip = match own.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => {
            sends_from((Ipv4Addr::UNSPECIFIED, 0).into(), (DOCUMENTED_V4, 9).into())
        }
        IpAddr::V6(ip) if ip.is_unspecified() => {
            sends_from((Ipv6Addr::UNSPECIFIED, 0).into(), (DOCUMENTED_V6, 9).into())
        }
        ip => Some(ip),
    };
    ip.map(|ip| SocketAddr::new(ip, own.port()))
}

/// Addresses for documentation, which nobody has.
const DOCUMENTED_V4: Ipv4Addr = Ipv4Addr::new(192, 0, 2, 1);
const DOCUMENTED_V6: Ipv6Addr = Ipv6Addr::new(0x2001, 0xdb8, 0, 0, 0, 0, 0, 1);

/// Returns the address of this machine from which it would send elsewhere. Nothing is sent.
fn sends_from(own: SocketAddr, other: SocketAddr) -> Option<IpAddr> {
    let socket = UdpSocket::bind(own).ok()?;
    socket.connect(other).ok()?;
    let ip = socket.local_addr().ok()?.ip();
    (!ip.is_loopback() && !ip.is_unspecified()).then_some(ip)
}

/// Returns an address as a QR code of half blocks, light on dark, as cameras read it on terminals of either scheme.
fn code(address: &str) -> Option<String> {
    let code = QrCode::new(address).ok()?;
    // The quiet zone is drawn as well, so that the colours of the terminal do not matter.
    let (dark, light) = (Dense1x2::Light, Dense1x2::Dark);
    Some(
        code.render::<Dense1x2>()
            .dark_color(dark)
            .light_color(light)
            .build(),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_server_of_this_machine_alone_invites_nobody() {
        for own in ["127.0.0.1:80", "[::1]:80"] {
            assert_eq!(reached_at(own.parse().expect("an address")), None);
        }
        let own: SocketAddr = "192.0.2.7:8000".parse().expect("an address");
        assert_eq!(reached_at(own), Some(own));
        let all = reached_at("0.0.0.0:8000".parse().expect("an address"));
        assert!(all.is_none_or(|it| it.port() == 8000 && !it.ip().is_unspecified()));
    }

    /// A symbol has 17 modules and 4 for each version; four light ones are around it, and a line holds two rows.
    #[test]
    fn a_code_is_a_square_with_a_quiet_zone() {
        let address = "http://192.168.100.100:8000/?token=0123456789abcdef0123456789abcdef";
        let code = code(address).expect("it fits");
        let lines: Vec<&str> = code.lines().collect();
        let width = lines[0].chars().count();
        assert!(lines.iter().all(|line| line.chars().count() == width));
        assert_eq!((width - 8 - 17) % 4, 0, "{width}");
        assert_eq!(lines.len(), width.div_ceil(2));
        assert!(
            lines[..2]
                .iter()
                .all(|line| line.chars().all(|it| it == '█'))
        );
    }
}
