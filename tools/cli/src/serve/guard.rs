//! Admission of requests: they must have the token and come from no other site.

use std::fmt::Write as _;
use std::hint::black_box;
use std::net::{IpAddr, SocketAddr};

/// Number of random bytes of a token.
const TOKEN_BYTES: usize = 16;

/// The rules of admission.
#[derive(Clone, Debug)]
pub(super) struct Guard {
    own: SocketAddr,
    token: String,
}

/// The reason why a request is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Rejection {
    /// The host is another one: a name that leads here may belong to someone else (DNS rebinding).
    Host,
    /// The token is missing or wrong.
    Token,
    /// It comes from a page of another site.
    Origin,
}

impl Guard {
    /// Returns the rules of a server at an address, with a new token.
    ///
    /// # Errors
    /// The system has no random numbers.
    pub(super) fn new(own: SocketAddr) -> Result<Self, String> {
        let mut random = [0; TOKEN_BYTES];
        getrandom::fill(&mut random).map_err(|error| format!("no random numbers: {error}"))?;
        let mut token = String::new();
        for byte in random {
            // Writing to a string cannot fail.
            let _ = write!(token, "{byte:02x}");
        }
        Ok(Guard { own, token })
    }

    /// Returns the address of the page.
    pub(super) fn address(&self) -> String {
        let mut shown = self.own;
        if shown.ip().is_unspecified() {
            shown.set_ip(match shown {
                SocketAddr::V4(_) => [127, 0, 0, 1].into(),
                SocketAddr::V6(_) => std::net::Ipv6Addr::LOCALHOST.into(),
            });
        }
        format!("http://{shown}/?token={}", self.token)
    }

    /// Returns an error unless a request with this host and query is admitted.
    pub(super) fn admit(&self, host: Option<&str>, query: &str) -> Result<(), Rejection> {
        if !host.is_some_and(|host| self.is_own(host)) {
            return Err(Rejection::Host);
        }
        let mut parts = query.split('&');
        let token = parts.find_map(|part| part.strip_prefix("token="));
        match token {
            Some(token) if is_same(token, &self.token) => Ok(()),
            _ => Err(Rejection::Token),
        }
    }

    /// Returns an error unless a page of this origin may open a WebSocket at this host.
    pub(super) fn admit_origin(&self, origin: Option<&str>, host: &str) -> Result<(), Rejection> {
        match origin.and_then(|origin| origin.strip_prefix("http://")) {
            Some(origin) if origin.eq_ignore_ascii_case(host) => Ok(()),
            _ => Err(Rejection::Origin),
        }
    }

    /// Returns true if a host is this server: a number, which no name server controls, or `localhost`.
    fn is_own(&self, host: &str) -> bool {
        let (name, port) = match host.rsplit_once(':') {
            Some((name, port)) if !port.contains(']') => (name, port.parse().ok()),
            _ => (host, Some(80)),
        };
        if port != Some(self.own.port()) {
            return false;
        }
        if name.eq_ignore_ascii_case("localhost") {
            return true;
        }
        let inner = name
            .strip_prefix('[')
            .and_then(|name| name.strip_suffix(']'));
        match inner.unwrap_or(name).parse::<IpAddr>() {
            Ok(address) => address.is_loopback() || !self.own.ip().is_loopback(),
            Err(_) => false,
        }
    }
}

/// Compares in constant time.
fn is_same(one: &str, other: &str) -> bool {
    let pairs = one.bytes().zip(other.bytes());
    let differences = pairs.fold(0, |all, (one, other)| black_box(all | (one ^ other)));
    one.len() == other.len() && differences == 0
}

#[cfg(test)]
mod tests {
    use super::*;

    fn guard(own: &str) -> Guard {
        Guard::new(own.parse().expect("an address")).expect("random numbers")
    }

    #[test]
    fn a_token_is_long_and_always_another_one() {
        let (one, other) = (guard("127.0.0.1:8000"), guard("127.0.0.1:8000"));
        assert_eq!((one.token.len(), other.token.len()), (32, 32));
        assert_ne!(one.token, other.token);
        let address = format!("http://127.0.0.1:8000/?token={}", one.token);
        assert_eq!(one.address(), address);
        assert!(
            guard("0.0.0.0:80")
                .address()
                .starts_with("http://127.0.0.1:80/?")
        );
    }

    #[test]
    fn only_the_whole_token_lets_in() {
        let guard = guard("127.0.0.1:8000");
        let host = Some("127.0.0.1:8000");
        let token = guard.token.clone();
        assert_eq!(guard.admit(host, &format!("token={token}")), Ok(()));
        assert_eq!(guard.admit(host, &format!("a=b&token={token}")), Ok(()));
        for query in [
            String::new(),
            "token=".to_owned(),
            format!("token={}", &token[1..]),
            format!("token={token}0"),
            format!("tokens={token}"),
            format!("token={}", "0".repeat(32)),
            format!("token=&token={token}"),
        ] {
            assert_eq!(guard.admit(host, &query), Err(Rejection::Token), "{query}");
        }
    }

    #[test]
    fn only_numbers_and_localhost_are_this_host() {
        let here = guard("127.0.0.1:8000");
        let (all, six) = (guard("0.0.0.0:8000"), guard("[::1]:8000"));
        for (host, by_here, by_all) in [
            ("127.0.0.1:8000", true, true),
            ("localhost:8000", true, true),
            ("LocalHost:8000", true, true),
            ("[::1]:8000", true, true),
            ("192.168.1.5:8000", false, true),
            ("127.0.0.1:8001", false, false),
            ("127.0.0.1", false, false),
            ("evil.example:8000", false, false),
            ("localhost.evil.example:8000", false, false),
            ("127.0.0.1.evil.example:8000", false, false),
            ("", false, false),
            (":8000", false, false),
            ("127.0.0.1:8000:8000", false, false),
        ] {
            assert_eq!(here.is_own(host), by_here, "{host}");
            assert_eq!(all.is_own(host), by_all, "{host}");
        }
        assert!(six.is_own("[::1]:8000"));
        assert!(guard("127.0.0.1:80").is_own("localhost"));
        assert_eq!(here.admit(None, ""), Err(Rejection::Host));
    }

    #[test]
    fn an_origin_is_that_of_the_host() {
        let guard = guard("127.0.0.1:8000");
        let host = "localhost:8000";
        assert_eq!(
            guard.admit_origin(Some("http://localhost:8000"), host),
            Ok(())
        );
        for origin in [
            None,
            Some("null"),
            Some("http://localhost"),
            Some("https://localhost:8000"),
            Some("http://127.0.0.1:8000"),
            Some("http://evil.example"),
            Some("http://localhost:8000.evil.example"),
        ] {
            let refused = guard.admit_origin(origin, host);
            assert_eq!(refused, Err(Rejection::Origin), "{origin:?}");
        }
    }
}
