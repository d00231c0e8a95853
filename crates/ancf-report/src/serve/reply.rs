//! Responses of the server.

use std::io;
use std::sync::Arc;

use futures_util::TryStreamExt;
use http_body_util::combinators::BoxBody;
use http_body_util::{BodyExt, Full, StreamBody};
use hyper::body::{Bytes, Frame};
use hyper::header::{
    ALLOW, CACHE_CONTROL, CONTENT_LENGTH, CONTENT_TYPE, ETAG, HeaderValue, REFERRER_POLICY,
    X_CONTENT_TYPE_OPTIONS,
};
use hyper::{Response, StatusCode};
use tokio::fs::File;
use tokio::io::AsyncReadExt;
use tokio_util::io::ReaderStream;

/// Response with its body.
pub(super) type Reply = Response<BoxBody<Bytes, io::Error>>;

/// Media type of plain text.
pub(super) const TEXT: &str = "text/plain; charset=utf-8";

/// Bytes that several responses share.
struct SharedBytes(Arc<Vec<u8>>);

impl AsRef<[u8]> for SharedBytes {
    fn as_ref(&self) -> &[u8] {
        &self.0
    }
}

/// Response with a status and its reason phrase as body.
pub(super) fn status(status: StatusCode) -> Reply {
    let mut reply = bytes(TEXT, format!("{status}\n").into());
    *reply.status_mut() = status;
    if status == StatusCode::METHOD_NOT_ALLOWED {
        reply.headers_mut().insert(ALLOW, HeaderValue::from_static("GET, HEAD"));
    }
    reply
}

/// Response with bytes of a media type.
pub(super) fn bytes(kind: &'static str, bytes: Bytes) -> Reply {
    with_headers(kind, Full::new(bytes).map_err(|never| match never {}).boxed())
}

/// Response with a scene and its entity tag.
pub(super) fn scene(scene: Arc<Vec<u8>>, tag: &str) -> Reply {
    tagged(bytes("application/octet-stream", Bytes::from_owner(SharedBytes(scene))), tag)
}

/// Response to a client that has the scene.
pub(super) fn not_modified(tag: &str) -> Reply {
    let mut reply = bytes("application/octet-stream", Bytes::new());
    *reply.status_mut() = StatusCode::NOT_MODIFIED;
    tagged(reply, tag)
}

/// Response with a file. A growing file is sent up to its present length.
pub(super) fn file(kind: &'static str, file: File, length: u64) -> Reply {
    let stream = ReaderStream::new(file.take(length)).map_ok(Frame::data);
    let mut reply = with_headers(kind, BodyExt::boxed(StreamBody::new(stream)));
    reply.headers_mut().insert(CONTENT_LENGTH, length.into());
    reply
}

fn tagged(mut reply: Reply, tag: &str) -> Reply {
    if let Ok(tag) = HeaderValue::from_str(tag) {
        reply.headers_mut().insert(ETAG, tag);
    }
    reply
}

fn with_headers(kind: &'static str, body: BoxBody<Bytes, io::Error>) -> Reply {
    let mut reply = Response::new(body);
    let headers = reply.headers_mut();
    for (name, value) in [
        (CONTENT_TYPE, kind),
        (X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (CACHE_CONTROL, "no-store"),
        (REFERRER_POLICY, "no-referrer"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.insert("cross-origin-resource-policy", HeaderValue::from_static("same-origin"));
    reply
}
