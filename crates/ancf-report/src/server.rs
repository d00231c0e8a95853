use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use sha2::{Digest, Sha256};

use crate::file::file;
use crate::page::{live_page, zipped};
use crate::request::{Refused, Request};
use crate::response::{Body, Response};

/// Requests at once; further ones wait for the system to refuse them.
const AT_ONCE: usize = 16;
/// How often it is asked whether to stop.
const PAUSE: Duration = Duration::from_millis(20);

/// Where a [`Server`] has its scenes from.
pub trait Source: Sync {
    /// A number that is another one once the scene is: it is asked for at each request.
    fn version(&self) -> u64;

    /// The scene as a [`container`](crate::container); asked for only when the version has changed.
    ///
    /// # Errors
    /// If there is none; the browser gets a status of 500.
    fn scene(&self) -> io::Result<Vec<u8>>;
}

/// Serves a page with a scene, and the files of a folder, to browsers on this machine.
///
/// | path | what |
/// |---|---|
/// | `/` | the page |
/// | `/scene` | the scene, in gzip (as such, not as an encoding), with an `ETag` |
/// | `/files/..` | regular files of the folder |
///
/// It listens on 127.0.0.1 only and answers only requests whose `Host` is this machine by one of its own names, so that
/// no page from elsewhere can read it by a name that it has rebound. One request a connection; requests are read by
/// `httparse` within limits of size, time and number.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    folder: PathBuf,
    stop: Stop,
}

/// What ends a [`Server`] from elsewhere.
#[derive(Clone, Debug, Default)]
pub struct Stop(Arc<AtomicBool>);

impl Stop {
    /// Ends it soon.
    pub fn stop(&self) {
        self.0.store(true, Ordering::SeqCst);
    }

    /// Whether it is to end.
    pub fn is_set(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}

/// The last scene that was made.
#[derive(Default)]
struct Made {
    version: Option<u64>,
    bytes: Arc<Vec<u8>>,
    tag: String,
}

impl Server {
    /// A server for a folder at a port of 127.0.0.1, or at any that is free if it is 0.
    ///
    /// # Errors
    /// If the port is taken.
    pub fn bind(port: u16, folder: impl Into<PathBuf>) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok(Self { listener, address, folder: folder.into(), stop: Stop::default() })
    }

    /// Where it listens.
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// What to open in a browser.
    pub fn url(&self) -> String {
        format!("http://{}/", self.address)
    }

    /// What ends it.
    pub fn stopper(&self) -> Stop {
        self.stop.clone()
    }

    /// Answers requests until it is [stopped](Stop::stop).
    ///
    /// # Errors
    /// If it cannot listen any more.
    pub fn serve(&self, source: &dyn Source) -> io::Result<()> {
        let (made, busy) = (Mutex::default(), AtomicUsize::new(0));
        thread::scope(|scope| {
            while !self.stop.is_set() {
                if busy.load(Ordering::SeqCst) >= AT_ONCE {
                    thread::sleep(PAUSE);
                    continue;
                }
                match self.listener.accept() {
                    Ok((stream, _)) => {
                        busy.fetch_add(1, Ordering::SeqCst);
                        let (made, busy) = (&made, &busy);
                        let answer = move || {
                            self.answer(stream, source, made);
                            busy.fetch_sub(1, Ordering::SeqCst);
                        };
                        if thread::Builder::new().spawn_scoped(scope, answer).is_err() {
                            busy.fetch_sub(1, Ordering::SeqCst);
                        }
                    }
                    Err(error) if is_passing(&error) => thread::sleep(PAUSE),
                    Err(error) => return Err(error),
                }
            }
            Ok(())
        })
    }

    /// Answers one request. That the browser went away is nothing to tell anybody.
    fn answer(&self, mut stream: TcpStream, source: &dyn Source, made: &Mutex<Made>) {
        if stream.set_nonblocking(false).is_err() {
            return;
        }
        let (response, head) = match Request::read(&mut stream, &self.stop) {
            Ok(request) => (self.response(&request, source, made), request.method == "HEAD"),
            Err(Refused::Malformed) => (Response::status(400), false),
            Err(Refused::Large) => (Response::status(431), false),
            Err(Refused::Lost) => return,
        };
        let _ = response.send(&mut stream, head);
    }

    fn response(&self, request: &Request, source: &dyn Source, made: &Mutex<Made>) -> Response {
        if !request.is_local() {
            return Response::status(403);
        }
        if request.method != "GET" && request.method != "HEAD" {
            return Response::status(405);
        }
        match request.path.as_str() {
            "/" => {
                let body = Body::Bytes(live_page().into_bytes());
                Response { status: 200, kind: "text/html; charset=utf-8", tag: None, body }
            }
            "/scene" => scene(request, source, made).unwrap_or_else(|_| Response::status(500)),
            path => match path.strip_prefix("/files/") {
                Some(path) => file(&self.folder, path),
                None => Response::status(404),
            },
        }
    }
}

/// The scene, made anew if it is another one; without a body if the browser has it.
fn scene(request: &Request, source: &dyn Source, made: &Mutex<Made>) -> io::Result<Response> {
    let (bytes, tag) = {
        let mut made = made.lock().unwrap_or_else(PoisonError::into_inner);
        let version = source.version();
        if made.version != Some(version) {
            let bytes = zipped(&source.scene()?);
            let hash: String =
                Sha256::digest(&bytes).iter().take(16).map(|byte| format!("{byte:02x}")).collect();
            *made = Made { version: Some(version), bytes: Arc::new(bytes), tag: format!("\"{hash}\"") };
        }
        (Arc::clone(&made.bytes), made.tag.clone())
    };
    let known = |known: &String| *known == "*" || known.trim_start_matches("W/") == tag;
    let status = if request.tags.iter().any(known) { 304 } else { 200 };
    Ok(Response { status, kind: "application/octet-stream", tag: Some(tag), body: Body::Shared(bytes) })
}

/// Whether an error of accepting is none of the server's.
fn is_passing(error: &io::Error) -> bool {
    use io::ErrorKind::{ConnectionAborted, ConnectionReset, Interrupted, WouldBlock};
    // Too many open files, on some systems: a matter of time.
    const FULL: [i32; 2] = [23, 24];
    matches!(error.kind(), WouldBlock | Interrupted | ConnectionAborted | ConnectionReset)
        || error.raw_os_error().is_some_and(|code| FULL.contains(&code))
}
