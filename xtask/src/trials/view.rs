//! The server of `ancf view`, with requests to it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::Stdio;
use std::time::Duration;

use super::trial::{Trial, expect};
use crate::system::shell::Done;

/// Starts the server, requests its page and its data, and ends it.
pub(super) fn view(trial: &Trial<'_>) -> Done {
    let mut command = trial.program.command(&trial.folder, &["view", "pendulum"]);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::null());
    let mut server = command.spawn().map_err(|error| error.to_string())?;
    let mut address = String::new();
    let read = server.stdout.take().map(|output| BufReader::new(output).read_line(&mut address));
    let tested = match read {
        Some(Ok(_)) => requests(trial, address.trim()),
        other => Err(format!("no address: {other:?}")),
    };
    let _ = server.kill().and_then(|()| server.wait());
    tested
}

fn requests(trial: &Trial<'_>, address: &str) -> Done {
    let rest = address.strip_prefix("http://").ok_or_else(|| format!("not an address: {address}"))?;
    let (host, path) = rest.split_once('/').unwrap_or((rest, ""));
    let page = get(host, &format!("/{path}"))?;
    let start = String::from_utf8_lossy(&page[..page.len().min(400)]).into_owned();
    expect(start.starts_with("HTTP/1.1 200") && page.len() > 50_000, "a page", start)?;
    let missing = get(host, &format!("/{path}no-such-page"))?;
    let start = String::from_utf8_lossy(&missing[..missing.len().min(40)]).into_owned();
    expect(start.starts_with("HTTP/1.1 404"), "404", start)?;
    trial.read("pendulum/probes.csv").map(|_| ())
}

fn get(host: &str, path: &str) -> Result<Vec<u8>, String> {
    let failed = |error: std::io::Error| format!("http://{host}{path}: {error}");
    let mut stream = TcpStream::connect(host).map_err(failed)?;
    stream.set_read_timeout(Some(Duration::from_secs(60))).map_err(failed)?;
    write!(stream, "GET {path} HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n").map_err(failed)?;
    let mut answer = Vec::new();
    stream.read_to_end(&mut answer).map_err(failed)?;
    Ok(answer)
}
