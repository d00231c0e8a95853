//! Open connections, limited in number.

use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use tokio::task::JoinHandle;

/// Maximum number of open connections, well below the usual limit of 1024 files of a process.
const MAX_CONNECTIONS: usize = 256;

/// Flag of a connection whose request has arrived.
#[derive(Clone, Debug, Default)]
pub(super) struct HasRequest(Arc<AtomicBool>);

impl HasRequest {
    pub(super) fn set(&self) {
        self.0.store(true, Ordering::SeqCst);
    }

    fn is_set(&self) -> bool {
        self.0.load(Ordering::SeqCst)
    }
}

/// Open connections in the order of their begin.
#[derive(Debug, Default)]
pub(super) struct Connections(VecDeque<(JoinHandle<()>, HasRequest)>);

impl Connections {
    /// Adds a connection. At the limit, the oldest connection without a request is closed, or else the oldest one.
    pub(super) fn add(&mut self, connection: JoinHandle<()>, has_request: HasRequest) {
        if self.0.len() >= MAX_CONNECTIONS {
            self.0.retain(|(task, _)| !task.is_finished());
        }
        if self.0.len() >= MAX_CONNECTIONS {
            let idle = self.0.iter().position(|(_, has_request)| !has_request.is_set());
            if let Some((task, _)) = self.0.remove(idle.unwrap_or(0)) {
                task.abort();
            }
        }
        self.0.push_back((connection, has_request));
    }
}
