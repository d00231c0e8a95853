use std::io::{self, Read, Write};
use std::net::TcpStream;
use std::time::Duration;

/// Maximum time for a client to accept a part of a response.
const TIMEOUT: Duration = Duration::from_secs(20);

/// HTTP response.
pub(super) struct Response {
    pub status: u16,
    /// Media type.
    pub kind: &'static str,
    /// Entity tag.
    pub tag: Option<String>,
    pub body: ResponseBody,
}

/// Source of the body of a response.
pub(super) enum ResponseBody {
    Bytes(Vec<u8>),
    Shared(std::sync::Arc<Vec<u8>>),
    File(std::fs::File, u64),
}

impl Response {
    /// Response with a status and its reason phrase as body.
    pub fn status(status: u16) -> Self {
        let body = ResponseBody::Bytes(format!("{status} {}\n", reason(status)).into_bytes());
        Self { status, kind: TEXT, tag: None, body }
    }

    /// Sends the response; without its body if `head_only`.
    pub fn send(self, stream: &mut TcpStream, head_only: bool) -> io::Result<()> {
        stream.set_write_timeout(Some(TIMEOUT))?;
        let length = match &self.body {
            ResponseBody::Bytes(bytes) => bytes.len() as u64,
            ResponseBody::Shared(bytes) => bytes.len() as u64,
            ResponseBody::File(_, length) => *length,
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
        if !head_only && !empty {
            match self.body {
                ResponseBody::Bytes(bytes) => stream.write_all(&bytes)?,
                ResponseBody::Shared(bytes) => stream.write_all(&bytes)?,
                // A growing file is sent up to the announced length.
                ResponseBody::File(file, length) => {
                    io::copy(&mut file.take(length), stream)?;
                }
            }
        }
        stream.flush()
    }
}

/// Media type of plain text.
pub(super) const TEXT: &str = "text/plain; charset=utf-8";

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
