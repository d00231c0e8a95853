use std::io::{self, Read};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use super::refused::Refused;
use super::stop_flag::StopFlag;

/// Maximum number of bytes of request line and headers. Bodies are not read.
const MAX_BYTES: usize = 8 << 10;
/// Maximum number of headers.
const MAX_HEADERS: usize = 64;
/// Maximum time for a request to arrive.
const TIMEOUT: Duration = Duration::from_secs(5);
/// Interval at which the stop flag is checked.
const CHECK_INTERVAL: Duration = Duration::from_millis(100);

/// HTTP request.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Request {
    pub method: String,
    /// Path as received, without query and fragment.
    pub path: String,
    /// Values of `Host`: one, if the request is valid.
    pub hosts: Vec<String>,
    /// Entity tags of `If-None-Match`.
    pub tags: Vec<String>,
}

impl Request {
    /// Reads request line and headers until they are complete or the stop flag is set.
    pub fn read(stream: &mut TcpStream, stop: &StopFlag) -> Result<Self, Refused> {
        let end = Instant::now() + TIMEOUT;
        let (mut bytes, mut piece) = (Vec::new(), [0; 1024]);
        loop {
            let left = end.saturating_duration_since(Instant::now());
            let wait = left.clamp(Duration::from_millis(1), CHECK_INTERVAL);
            let broken = stream.set_read_timeout(Some(wait)).is_err();
            if left.is_zero() || broken || stop.is_set() {
                return Err(Refused::Lost);
            }
            match stream.read(&mut piece) {
                Ok(0) => return Err(Refused::Lost),
                Ok(count) => bytes.extend(&piece[..count]),
                Err(error) if is_waiting(&error) => continue,
                Err(_) => return Err(Refused::Lost),
            }
            if let Some(request) = Self::parse(&bytes)? {
                return Ok(request);
            }
            if bytes.len() > MAX_BYTES {
                return Err(Refused::Large);
            }
        }
    }

    /// Parses a request; `None` if the bytes are incomplete.
    fn parse(bytes: &[u8]) -> Result<Option<Self>, Refused> {
        let mut headers = [httparse::EMPTY_HEADER; MAX_HEADERS];
        let mut parsed = httparse::Request::new(&mut headers);
        match parsed.parse(bytes) {
            Ok(httparse::Status::Complete(_)) => {}
            Ok(httparse::Status::Partial) => return Ok(None),
            Err(httparse::Error::TooManyHeaders) => return Err(Refused::Large),
            Err(_) => return Err(Refused::Malformed),
        }
        let (Some(method), Some(target)) = (parsed.method, parsed.path) else {
            return Err(Refused::Malformed);
        };
        let values = |name: &str| {
            let named = parsed.headers.iter().filter(|header| header.name.eq_ignore_ascii_case(name));
            named.map(|header| String::from_utf8_lossy(header.value).trim().to_owned()).collect::<Vec<_>>()
        };
        let path = target.split(['?', '#']).next().unwrap_or_default();
        let tags = values("if-none-match");
        let tags = tags.iter().flat_map(|list| list.split(',')).map(|tag| tag.trim().to_owned());
        Ok(Some(Self {
            method: method.to_owned(),
            path: path.to_owned(),
            hosts: values("host"),
            tags: tags.collect(),
        }))
    }

    /// True if the host is a name of this machine. Other names may have been rebound to its address by a foreign page.
    pub fn is_local(&self) -> bool {
        let [host] = self.hosts.as_slice() else { return false };
        let name = match host.rsplit_once(':') {
            Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
            _ => host,
        };
        name.eq_ignore_ascii_case("localhost") || name == "127.0.0.1" || name == "[::1]"
    }
}

/// True if a read timed out or was interrupted.
fn is_waiting(error: &io::Error) -> bool {
    use io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
    matches!(error.kind(), Interrupted | TimedOut | WouldBlock)
}
