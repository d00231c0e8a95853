use std::io::{self, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// How long a browser may take to accept a piece of an answer.
const PATIENCE: Duration = Duration::from_secs(20);

/// What is given back.
pub(crate) struct Response {
    pub status: u16,
    pub kind: &'static str,
    pub tag: Option<String>,
    pub body: Body,
}

/// What it is made of.
pub(crate) enum Body {
    Bytes(Vec<u8>),
    Shared(std::sync::Arc<Vec<u8>>),
    File(std::fs::File, u64),
}

impl Response {
    /// A status and its words.
    pub fn status(status: u16) -> Self {
        let body = Body::Bytes(format!("{status} {}\n", reason(status)).into_bytes());
        Self { status, kind: TEXT, tag: None, body }
    }

    /// Sends it; without the body, if only the head was asked for.
    pub fn send(self, stream: &mut TcpStream, head: bool) -> io::Result<()> {
        stream.set_write_timeout(Some(PATIENCE))?;
        let length = match &self.body {
            Body::Bytes(bytes) => bytes.len() as u64,
            Body::Shared(bytes) => bytes.len() as u64,
            Body::File(_, length) => *length,
        };
        let mut lines = format!(
            "HTTP/1.1 {} {}\r\nContent-Type: {}\r\nX-Content-Type-Options: nosniff\r\nCache-Control: no-store\r\n\
             Cross-Origin-Resource-Policy: same-origin\r\nReferrer-Policy: no-referrer\r\nConnection: close\r\n",
            self.status,
            reason(self.status),
            self.kind,
        );
        if let Some(tag) = &self.tag {
            lines.push_str(&format!("ETag: {tag}\r\n"));
        }
        if self.status == 405 {
            lines.push_str("Allow: GET, HEAD\r\n");
        }
        let empty = self.status == 304;
        if !empty {
            lines.push_str(&format!("Content-Length: {length}\r\n"));
        }
        lines.push_str("\r\n");
        stream.write_all(lines.as_bytes())?;
        if !head && !empty {
            match self.body {
                Body::Bytes(bytes) => stream.write_all(&bytes)?,
                Body::Shared(bytes) => stream.write_all(&bytes)?,
                // A file that grows meanwhile is sent as long as it was said to be.
                Body::File(file, length) => {
                    io::copy(&mut file.take(length), stream)?;
                }
            }
        }
        stream.flush()
    }
}

/// Plain text.
pub(crate) const TEXT: &str = "text/plain; charset=utf-8";

const fn reason(status: u16) -> &'static str {
    match status {
        200 => "OK",
        304 => "Not Modified",
        400 => "Bad Request",
        403 => "Forbidden",
        404 => "Not Found",
        405 => "Method Not Allowed",
        431 => "Request Header Fields Too Large",
        _ => "Internal Server Error",
    }
}
