use std::convert::Infallible;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, TcpListener};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

use hyper::body::Incoming;
use hyper::header::{HOST, IF_NONE_MATCH};
use hyper::server::conn::http1;
use hyper::service::service_fn;
use hyper::{Method, Request, StatusCode};
use hyper_util::rt::{TokioIo, TokioTimer};
use tokio::net::TcpStream;
use tokio::runtime::Builder;
use tokio::time::sleep;
use tokio_util::sync::CancellationToken;

use super::connections::{Connections, HasRequest};
use super::file::file;
use super::reply::{self, Reply};
use super::scene_cache::{SceneCache, SceneSource};

/// Maximum time for a request to arrive.
const REQUEST_TIMEOUT: Duration = Duration::from_secs(5);
/// Maximum number of bytes of request line and headers. Bodies are not read.
const MAX_BYTES: usize = 8 << 10;
/// Maximum number of headers.
const MAX_HEADERS: usize = 64;
/// Pause after a temporary error of accepting a connection.
const PAUSE: Duration = Duration::from_millis(20);

/// HTTP server of a page, its scene and the files of a folder for browsers on this machine.
///
/// | path | content |
/// |---|---|
/// | `/` | page |
/// | `/scene` | scene as a gzip file (without content encoding), with an `ETag` |
/// | `/files/..` | regular files of the folder |
///
/// The server listens on 127.0.0.1 only. It accepts only requests whose `Host` is a local name of this machine, so that no
/// foreign page can read it through DNS rebinding. Each connection has one request, of limited size and time. The number of
/// connections is limited; connections without a request give way to new ones.
#[derive(Debug)]
pub struct Server {
    listener: TcpListener,
    address: SocketAddr,
    folder: PathBuf,
    stop: StopFlag,
}

/// Flag that stops a [`Server`] from another thread.
#[derive(Clone, Debug, Default)]
pub struct StopFlag(CancellationToken);

impl StopFlag {
    /// Sets the flag.
    pub fn stop(&self) {
        self.0.cancel();
    }

    /// True if the flag is set.
    pub fn is_set(&self) -> bool {
        self.0.is_cancelled()
    }
}

/// Folder and scene of the responses.
struct Content {
    folder: PathBuf,
    cache: SceneCache,
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
    pub fn serve(&self, source: Arc<dyn SceneSource>) -> io::Result<()> {
        let content = Arc::new(Content { folder: self.folder.clone(), cache: SceneCache::new(source) });
        let runtime = Builder::new_current_thread().enable_all().build()?;
        let served = runtime.block_on(self.accept(&content));
        // Scenes that are being built are not awaited.
        runtime.shutdown_background();
        served
    }

    async fn accept(&self, content: &Arc<Content>) -> io::Result<()> {
        let listener = tokio::net::TcpListener::from_std(self.listener.try_clone()?)?;
        let mut connections = Connections::default();
        loop {
            let accepted = tokio::select! {
                () = self.stop.0.cancelled() => return Ok(()),
                accepted = listener.accept() => accepted,
            };
            match accepted {
                Ok((stream, _)) => {
                    let has_request = HasRequest::default();
                    let connection = answer(stream, Arc::clone(content), has_request.clone());
                    connections.add(tokio::spawn(connection), has_request);
                }
                Err(error) if is_temporary(&error) => sleep(PAUSE).await,
                Err(error) => return Err(error),
            }
        }
    }
}

/// Answers the request of a connection. Errors of a closed connection are ignored.
async fn answer(stream: TcpStream, content: Arc<Content>, has_request: HasRequest) {
    let service = service_fn(|request| {
        has_request.set();
        let content = Arc::clone(&content);
        async move { Ok::<_, Infallible>(content.reply(&request).await) }
    });
    let mut connection = http1::Builder::new();
    connection.timer(TokioTimer::new()).header_read_timeout(REQUEST_TIMEOUT).keep_alive(false);
    connection.max_buf_size(MAX_BYTES).max_headers(MAX_HEADERS);
    let _ = connection.serve_connection(TokioIo::new(stream), service).await;
}

impl Content {
    async fn reply(self: &Arc<Self>, request: &Request<Incoming>) -> Reply {
        if !is_local(request) {
            return reply::status(StatusCode::FORBIDDEN);
        }
        if request.method() != Method::GET && request.method() != Method::HEAD {
            return reply::status(StatusCode::METHOD_NOT_ALLOWED);
        }
        match request.uri().path() {
            "/" => self.page().await,
            "/scene" => self.scene(request).await,
            path => match path.strip_prefix("/files/") {
                Some(path) => self.file(path).await,
                None => reply::status(StatusCode::NOT_FOUND),
            },
        }
    }

    async fn page(self: &Arc<Self>) -> Reply {
        let content = Arc::clone(self);
        match tokio::task::spawn_blocking(move || content.cache.page()).await {
            Ok(Ok(page)) => reply::bytes("text/html; charset=utf-8", page.into()),
            _ => reply::status(StatusCode::INTERNAL_SERVER_ERROR),
        }
    }

    /// Response with the scene; without a body if the client has it.
    async fn scene(self: &Arc<Self>, request: &Request<Incoming>) -> Reply {
        let content = Arc::clone(self);
        let built = tokio::task::spawn_blocking(move || content.cache.scene()).await;
        let Ok(Ok(scene)) = built else { return reply::status(StatusCode::INTERNAL_SERVER_ERROR) };
        let sent = request.headers().get_all(IF_NONE_MATCH).iter().filter_map(|tags| tags.to_str().ok());
        let mut known = sent.flat_map(|tags| tags.split(',')).map(str::trim);
        if known.any(|known| known == "*" || known.trim_start_matches("W/") == scene.tag) {
            return reply::not_modified(&scene.tag);
        }
        reply::scene(scene.bytes, &scene.tag)
    }

    /// Response with a file of the folder.
    async fn file(&self, path: &str) -> Reply {
        let (folder, path) = (self.folder.clone(), path.to_owned());
        let opened = tokio::task::spawn_blocking(move || file(&folder, &path)).await;
        match opened {
            Ok(Some(file)) => reply::file(file.kind, file.file.into(), file.length),
            _ => reply::status(StatusCode::NOT_FOUND),
        }
    }
}

/// True if the host is a name of this machine. Other names may have been rebound to its address by a foreign page.
fn is_local(request: &Request<Incoming>) -> bool {
    let hosts: Vec<_> = request.headers().get_all(HOST).iter().collect();
    let [host] = hosts.as_slice() else { return false };
    let Ok(host) = host.to_str() else { return false };
    let name = match host.rsplit_once(':') {
        Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
        _ => host,
    };
    name.eq_ignore_ascii_case("localhost") || name == "127.0.0.1" || name == "[::1]"
}

/// True if an error of accepting a connection is temporary.
fn is_temporary(error: &io::Error) -> bool {
    use io::ErrorKind::{ConnectionAborted, ConnectionReset, Interrupted, WouldBlock};
    // Too many open files: `ENFILE` and `EMFILE` on Unix.
    const FULL: [i32; 2] = [23, 24];
    matches!(error.kind(), WouldBlock | Interrupted | ConnectionAborted | ConnectionReset)
        || error.raw_os_error().is_some_and(|code| FULL.contains(&code))
}
