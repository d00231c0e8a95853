//! The server provides a page, a scene and the files of one folder to this machine only.

use std::fs;
use std::io::{self, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use ancf_report::{SceneSource, Server};
use flate2::read::GzDecoder;

/// Source of scenes that contain their version, with a counter of built scenes.
#[derive(Default)]
struct Counter {
    version: AtomicU64,
    made: AtomicU64,
}

impl SceneSource for Counter {
    fn version(&self) -> u64 {
        self.version.load(Ordering::SeqCst)
    }

    fn scene(&self) -> io::Result<Vec<u8>> {
        self.made.fetch_add(1, Ordering::SeqCst);
        match self.version() {
            99 => Err(io::Error::other("no such run")),
            version => Ok(format!("scene {version}").into_bytes()),
        }
    }
}

/// Response with its status, headers in lower case, and body.
struct Answer {
    status: u16,
    head: String,
    body: Vec<u8>,
}

fn raw(address: SocketAddr, request: &str) -> Answer {
    let mut stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(Duration::from_secs(20))).unwrap();
    let _ = stream.write_all(request.as_bytes());
    let mut bytes = Vec::new();
    let _ = stream.read_to_end(&mut bytes);
    let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").unwrap_or(bytes.len());
    let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
    let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
    Answer { status, head: head.to_lowercase(), body: bytes.get(end + 4..).unwrap_or_default().to_vec() }
}

fn get(address: SocketAddr, path: &str) -> Answer {
    raw(address, &format!("GET {path} HTTP/1.1\r\nHost: localhost:{}\r\n\r\n", address.port()))
}

/// Serves a folder during a test.
fn serving(folder: &Path, test: impl FnOnce(SocketAddr, &Counter)) {
    let server = Server::bind(0, folder).unwrap();
    let (source, stop, address) = (Arc::new(Counter::default()), server.stop_flag(), server.address());
    thread::scope(|scope| {
        let served: Arc<dyn SceneSource> = source.clone();
        let serving = scope.spawn(|| server.serve(served));
        let tested = std::panic::catch_unwind(std::panic::AssertUnwindSafe(|| test(address, &source)));
        stop.stop();
        serving.join().unwrap().unwrap();
        tested.unwrap_or_else(|panic| std::panic::resume_unwind(panic));
    });
}

fn folder() -> tempfile::TempDir {
    let outer = tempfile::tempdir().unwrap();
    fs::create_dir_all(outer.path().join("run/deep")).unwrap();
    fs::write(outer.path().join("secret.txt"), "secret").unwrap();
    fs::write(outer.path().join("run/probes.csv"), "t,x\n").unwrap();
    fs::write(outer.path().join("run/deep/a b.txt"), "deep").unwrap();
    outer
}

#[test]
fn it_listens_on_loopback_only() {
    let server = Server::bind(0, ".").unwrap();
    assert!(server.address().ip().is_loopback());
    assert_ne!(server.address().port(), 0);
    assert_eq!(server.url(), format!("http://127.0.0.1:{}/", server.address().port()));
}

#[test]
fn it_gives_a_page_and_the_files_of_its_folder() {
    let outer = folder();
    serving(&outer.path().join("run"), |address, _| {
        let page = get(address, "/?theme=dark");
        assert_eq!(page.status, 200);
        assert!(page.head.contains("content-type: text/html"));
        assert!(String::from_utf8_lossy(&page.body).contains("data-src=\"/scene\""));
        let csv = get(address, "/files/probes.csv");
        assert_eq!((csv.status, csv.body.as_slice()), (200, &b"t,x\n"[..]));
        assert_eq!(get(address, "/files/deep/a%20b.txt").body, b"deep");
        for answer in [page, csv, get(address, "/nothing"), get(address, "/scene")] {
            assert!(answer.head.contains("x-content-type-options: nosniff"), "{}", answer.head);
            assert!(answer.head.contains("cache-control: no-store"));
        }
        let head = raw(address, "HEAD /files/probes.csv HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
        assert_eq!((head.status, head.body.len()), (200, 0));
        assert!(head.head.contains("content-length: 4"));
    });
}

#[test]
fn it_gives_nothing_beyond_its_folder() {
    let outer = folder();
    #[cfg(unix)]
    {
        use std::os::unix::fs::symlink;
        symlink(outer.path().join("secret.txt"), outer.path().join("run/link.txt")).unwrap();
        symlink(outer.path(), outer.path().join("run/up")).unwrap();
        symlink("probes.csv", outer.path().join("run/inside.csv")).unwrap();
    }
    let absolute = outer.path().join("secret.txt").display().to_string();
    serving(&outer.path().join("run"), |address, _| {
        let paths = [
            "/files/../secret.txt",
            "/files/%2e%2e/secret.txt",
            "/files/%2e%2e%2fsecret.txt",
            "/files/..%2fsecret.txt",
            "/files/..%5csecret.txt",
            "/files/deep/../../secret.txt",
            "/files/deep/%2E%2E/%2E%2E/secret.txt",
            "/files/%252e%252e/secret.txt",
            "/files/link.txt",
            "/files/up/secret.txt",
            "/files/deep",
            "/files/",
            "/files",
            "/files/.",
            "/files/probes.csv%00.txt",
            "/files/%ff",
            "/files/%2",
            "/files/no.csv",
            "/../secret.txt",
            "/etc/passwd",
            "/files//etc/passwd",
            "/files/%2fetc%2fpasswd",
        ];
        for path in paths
            .iter()
            .copied()
            .chain([format!("/files/{absolute}").as_str(), format!("/files{absolute}").as_str()])
        {
            let answer = get(address, path);
            assert_eq!(answer.status, 404, "{path}");
            assert!(!String::from_utf8_lossy(&answer.body).contains("secret"), "{path}");
        }
        #[cfg(unix)]
        assert_eq!(get(address, "/files/inside.csv").body, b"t,x\n", "links within the folder are followed");
    });
}

#[test]
fn other_methods_and_other_hosts_are_refused() {
    let outer = folder();
    serving(outer.path(), |address, _| {
        for method in ["POST", "PUT", "DELETE", "OPTIONS", "PATCH"] {
            let answer = raw(address, &format!("{method} / HTTP/1.1\r\nHost: localhost\r\n\r\n"));
            assert_eq!(answer.status, 405, "{method}");
            assert!(answer.head.contains("allow: get, head"));
        }
        for host in ["localhost", "LOCALHOST:80", "127.0.0.1", "127.0.0.1:8000", "[::1]", "[::1]:8000"] {
            let answer = raw(address, &format!("GET / HTTP/1.1\r\nHost: {host}\r\n\r\n"));
            assert_eq!(answer.status, 200, "{host}");
        }
        let hosts = [
            "evil.example",
            "localhost.evil.example",
            "127.0.0.1.evil.example:80",
            "",
            "localhost@evil",
            "10.0.0.1",
        ];
        for host in hosts {
            let answer = raw(address, &format!("GET /scene HTTP/1.1\r\nHost: {host}\r\n\r\n"));
            assert_eq!(answer.status, 403, "{host}");
        }
        assert_eq!(raw(address, "GET / HTTP/1.1\r\n\r\n").status, 403, "no host");
        assert_eq!(raw(address, "GET / HTTP/1.1\r\nHost: localhost\r\nHost: evil\r\n\r\n").status, 403);
    });
}

#[test]
fn a_scene_is_made_once_until_it_is_another_one() {
    let outer = folder();
    serving(outer.path(), |address, source| {
        let first = get(address, "/scene");
        assert_eq!(first.status, 200);
        let tag = first.head.lines().find_map(|line| line.strip_prefix("etag: ")).expect("a tag").to_owned();
        let mut text = String::new();
        GzDecoder::new(first.body.as_slice()).read_to_string(&mut text).unwrap();
        assert_eq!(text, "scene 0");
        let ask = |tag: &str| {
            raw(address, &format!("GET /scene HTTP/1.1\r\nHost: localhost\r\nIf-None-Match: {tag}\r\n\r\n"))
        };
        let known = ask(&tag);
        assert_eq!((known.status, known.body.len()), (304, 0));
        assert_eq!(ask(&format!("\"other\", W/{tag}")).status, 304);
        assert_eq!(ask("\"other\"").status, 200);
        assert_eq!(source.made.load(Ordering::SeqCst), 1);
        source.version.store(1, Ordering::SeqCst);
        assert_eq!(ask(&tag).status, 200);
        assert_eq!(source.made.load(Ordering::SeqCst), 2);
        source.version.store(99, Ordering::SeqCst);
        assert_eq!(ask(&tag).status, 500);
    });
}

#[test]
fn giant_and_broken_requests_are_refused() {
    let outer = folder();
    serving(outer.path(), |address, _| {
        let long = "a".repeat(100_000);
        for request in [
            format!("GET /{long} HTTP/1.1\r\nHost: localhost\r\n\r\n"),
            format!("GET / HTTP/1.1\r\nHost: localhost\r\nX: {long}\r\n\r\n"),
            format!("GET / HTTP/1.1\r\n{}\r\n", "A: b\r\n".repeat(1000)),
        ] {
            // The connection may be reset before the request is complete.
            assert!([431, 0].contains(&raw(address, &request).status));
        }
        assert_eq!(raw(address, "\u{1}\u{2}\u{3} nonsense\r\n\r\n").status, 400);
        assert_eq!(get(address, "/").status, 200, "the server continues");
    });
}

/// 500 connections, more than the server keeps, of which half are idle and half have sent a part of a request.
#[test]
fn waiting_connections_delay_nobody() {
    let outer = folder();
    serving(outer.path(), |address, _| {
        let waiting: Vec<_> = (0..500)
            .map(|k| {
                let mut stream = TcpStream::connect(address).unwrap();
                let _ = stream.write_all(if k % 2 == 0 { b"" } else { b"GET / HT" });
                stream
            })
            .collect();
        let begin = Instant::now();
        for _ in 0..10 {
            assert_eq!(get(address, "/").status, 200);
        }
        assert!(begin.elapsed() < Duration::from_secs(2), "{:?}", begin.elapsed());
        drop(waiting);
    });
}

#[test]
fn it_ends_when_it_is_told_to_whoever_waits() {
    let outer = folder();
    let (begin, mut idle) = (Instant::now(), Vec::new());
    serving(outer.path(), |address, _| {
        // Browsers open connections in advance.
        idle.push(TcpStream::connect(address).unwrap());
        thread::sleep(Duration::from_millis(100));
    });
    assert!(begin.elapsed() < Duration::from_secs(3), "{:?}", begin.elapsed());
}
