//! HTTP server for the page of a run, on this machine only.

mod file;
mod refused;
mod request;
mod response;
mod server;
mod stop_flag;

pub use server::{SceneSource, Server};
pub use stop_flag::StopFlag;
