use std::io::{self, Read};
use std::net::TcpStream;
use std::time::{Duration, Instant};

use crate::Stop;

/// Bytes that a request may have before its body, which is not read.
const LARGEST: usize = 8 << 10;
/// Headers that it may have.
const HEADERS: usize = 64;
/// How long it may take to arrive.
const PATIENCE: Duration = Duration::from_secs(5);

/// How often it is asked whether to stop.
const PAUSE: Duration = Duration::from_millis(100);

/// What is asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Request {
    pub method: String,
    /// The path as it was sent, without what follows a question mark.
    pub path: String,
    /// The names of the host: one, if all is well.
    pub hosts: Vec<String>,
    /// What the browser has already.
    pub tags: Vec<String>,
}

/// Why there is no request.
pub(crate) enum Refused {
    /// It is none.
    Malformed,
    /// It is too long.
    Large,
    /// The connection broke, or was too slow.
    Lost,
}

impl Request {
    /// Reads a request's lines and headers, as long as it is not to stop.
    pub fn read(stream: &mut TcpStream, stop: &Stop) -> Result<Self, Refused> {
        let end = Instant::now() + PATIENCE;
        let (mut bytes, mut piece) = (Vec::new(), [0; 1024]);
        loop {
            let left = end.saturating_duration_since(Instant::now());
            let broken = stream.set_read_timeout(Some(left.clamp(Duration::from_millis(1), PAUSE))).is_err();
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
            if bytes.len() > LARGEST {
                return Err(Refused::Large);
            }
        }
    }

    /// A request, if these bytes have all of it.
    fn parse(bytes: &[u8]) -> Result<Option<Self>, Refused> {
        let mut headers = [httparse::EMPTY_HEADER; HEADERS];
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

    /// Whether it was meant for this machine by name: pages from elsewhere may have given a name of theirs to its address.
    pub fn is_local(&self) -> bool {
        let [host] = self.hosts.as_slice() else { return false };
        let name = match host.rsplit_once(':') {
            Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
            _ => host,
        };
        name.eq_ignore_ascii_case("localhost") || name == "127.0.0.1" || name == "[::1]"
    }
}

/// Whether nothing has come yet.
fn is_waiting(error: &io::Error) -> bool {
    use io::ErrorKind::{Interrupted, TimedOut, WouldBlock};
    matches!(error.kind(), Interrupted | TimedOut | WouldBlock)
}
