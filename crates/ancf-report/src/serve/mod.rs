//! HTTP server for the page of a run, on this machine only.

mod connections;
mod file;
mod reply;
mod scene_cache;
mod server;

pub use scene_cache::SceneSource;
pub use server::{Server, StopFlag};
