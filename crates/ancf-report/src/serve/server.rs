use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener, TcpStream};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::Duration;

use sha2::{Digest, Sha256};

use super::file::file;
use super::refused::Refused;
use super::request::Request;
use super::response::{Response, ResponseBody};
use super::stop_flag::StopFlag;
use crate::scene::{gzipped, live_page};

/// Maximum number of simultaneous requests.
const MAX_REQUESTS: usize = 16;
/// Interval at which the stop flag is checked.
const CHECK_INTERVAL: Duration = Duration::from_millis(20);

/// Source of the scenes of a [`Server`].
pub trait SceneSource: Sync {
    /// Number that changes with the scene. It is queried at each request.
    fn version(&self) -> u64;

    /// Builds the scene as a [`container`](crate::container). It is called only if the version has changed.
    ///
    /// # Errors
    /// If there is no scene. The response has status 500.
    fn scene(&self) -> io::Result<Vec<u8>>;
}

/// HTTP server of a page, its scene and the files of a folder for browsers on this machine.
///
/// | path | content |
/// |---|---|
/// | `/` | page |
/// | `/scene` | scene as a gzip file (without content encoding), with an `ETag` |
/// | `/files/..` | regular files of the folder |
///
/// The server listens on 127.0.0.1 only. It accepts only requests whose `Host` is a local name of this machine, so that no
/// foreign page can read it through DNS rebinding. Each connection has one request. Requests are parsed by `httparse` within
/// limits of size, time and number.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    folder: PathBuf,
    stop: StopFlag,
}

/// Cached scene.
#[derive(Default)]
struct CachedScene {
    version: Option<u64>,
    bytes: Arc<Vec<u8>>,
    tag: String,
}

impl Server {
    /// Binds a server for a folder to a port of 127.0.0.1; port 0 selects a free port.
    ///
    /// # Errors
    /// If the port is in use.
    pub fn bind(port: u16, folder: impl Into<PathBuf>) -> io::Result<Self> {
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port))?;
        listener.set_nonblocking(true)?;
        let address = listener.local_addr()?;
        Ok(Self { listener, address, folder: folder.into(), stop: StopFlag::default() })
    }

    /// Address of the server.
    pub const fn address(&self) -> SocketAddr {
        self.address
    }

    /// Address of the page for a browser.
    pub fn url(&self) -> String {
        format!("http://{}/", self.address)
    }

    /// Flag that stops the server.
    pub fn stop_flag(&self) -> StopFlag {
        self.stop.clone()
    }

    /// Answers requests until the [stop flag](StopFlag::stop) is set.
    ///
    /// # Errors
    /// If accepting connections fails.
    pub fn serve(&self, source: &dyn SceneSource) -> io::Result<()> {
        let (cache, busy) = (Mutex::default(), AtomicUsize::new(0));
        thread::scope(|scope| {
            while !self.stop.is_set() {
                if busy.load(Ordering::SeqCst) >= MAX_REQUESTS {
                    thread::sleep(CHECK_INTERVAL);
                    continue;
                }
                match self.listener.accept() {
                    Ok((stream, _)) => {
                        busy.fetch_add(1, Ordering::SeqCst);
                        let (cache, busy) = (&cache, &busy);
                        let answer = move || {
                            self.answer(stream, source, cache);
                            busy.fetch_sub(1, Ordering::SeqCst);
                        };
                        if thread::Builder::new().spawn_scoped(scope, answer).is_err() {
                            busy.fetch_sub(1, Ordering::SeqCst);
                        }
                    }
                    Err(error) if is_temporary(&error) => thread::sleep(CHECK_INTERVAL),
                    Err(error) => return Err(error),
                }
            }
            Ok(())
        })
    }

    /// Answers one request. Errors of a closed connection are ignored.
    fn answer(&self, mut stream: TcpStream, source: &dyn SceneSource, cache: &Mutex<CachedScene>) {
        if stream.set_nonblocking(false).is_err() {
            return;
        }
        let (response, head) = match Request::read(&mut stream, &self.stop) {
            Ok(request) => (self.response(&request, source, cache), request.method == "HEAD"),
            Err(Refused::Malformed) => (Response::status(400), false),
            Err(Refused::Large) => (Response::status(431), false),
            Err(Refused::Lost) => return,
        };
        let _ = response.send(&mut stream, head);
    }

    fn response(&self, request: &Request, source: &dyn SceneSource, cache: &Mutex<CachedScene>) -> Response {
        if !request.is_local() {
            return Response::status(403);
        }
        if request.method != "GET" && request.method != "HEAD" {
            return Response::status(405);
        }
        match request.path.as_str() {
            "/" => {
                let body = ResponseBody::Bytes(live_page().into_bytes());
                Response { status: 200, kind: "text/html; charset=utf-8", tag: None, body }
            }
            "/scene" => scene(request, source, cache).unwrap_or_else(|_| Response::status(500)),
            path => match path.strip_prefix("/files/") {
                Some(path) => file(&self.folder, path),
                None => Response::status(404),
            },
        }
    }
}

/// Response with the scene, rebuilt if its version has changed; without a body if the client has it.
fn scene(request: &Request, source: &dyn SceneSource, cache: &Mutex<CachedScene>) -> io::Result<Response> {
    let (bytes, tag) = {
        let mut cached = cache.lock().unwrap_or_else(PoisonError::into_inner);
        let version = source.version();
        if cached.version != Some(version) {
            let bytes = gzipped(&source.scene()?);
            let hash: String =
                Sha256::digest(&bytes).iter().take(16).map(|byte| format!("{byte:02x}")).collect();
            *cached =
                CachedScene { version: Some(version), bytes: Arc::new(bytes), tag: format!("\"{hash}\"") };
        }
        (Arc::clone(&cached.bytes), cached.tag.clone())
    };
    let known = |known: &String| *known == "*" || known.trim_start_matches("W/") == tag;
    let status = if request.tags.iter().any(known) { 304 } else { 200 };
    Ok(Response {
        status,
        kind: "application/octet-stream",
        tag: Some(tag),
        body: ResponseBody::Shared(bytes),
    })
}

/// True if an error of accepting a connection is temporary.
fn is_temporary(error: &io::Error) -> bool {
    use io::ErrorKind::{ConnectionAborted, ConnectionReset, Interrupted, WouldBlock};
    // Too many open files: `ENFILE` and `EMFILE` on Unix.
    const FULL: [i32; 2] = [23, 24];
    matches!(error.kind(), WouldBlock | Interrupted | ConnectionAborted | ConnectionReset)
        || error.raw_os_error().is_some_and(|code| FULL.contains(&code))
}
