//! Scene of the server, rebuilt if it has changed.

use std::io;
use std::sync::{Arc, Mutex, PoisonError};

use sha2::{Digest, Sha256};

use crate::scene::{gzipped, live_page};

/// Source of the page and of the scenes of a [`Server`](crate::Server).
pub trait SceneSource: Send + Sync {
    /// Returns the page. By default it is the viewer, which requests the scene.
    ///
    /// # Errors
    /// If there is no page. The response has status 500.
    fn page(&self) -> io::Result<String> {
        Ok(live_page())
    }

    /// Number that changes with the scene. It is queried at each request.
    fn version(&self) -> u64;

    /// Builds the scene as a [`container`](crate::container). It is called only if the version has changed.
    ///
    /// # Errors
    /// If there is no scene. The response has status 500.
    fn scene(&self) -> io::Result<Vec<u8>>;
}

/// Source with its last scene.
pub(super) struct SceneCache {
    source: Arc<dyn SceneSource>,
    last: Mutex<CachedScene>,
}

/// Compressed scene.
#[derive(Clone, Default)]
pub(super) struct CachedScene {
    version: Option<u64>,
    pub(super) bytes: Arc<Vec<u8>>,
    /// Entity tag.
    pub(super) tag: String,
}

impl SceneCache {
    pub(super) fn new(source: Arc<dyn SceneSource>) -> Self {
        Self { source, last: Mutex::default() }
    }

    /// Returns the page.
    pub(super) fn page(&self) -> io::Result<String> {
        self.source.page()
    }

    /// Returns the scene, built once per version.
    pub(super) fn scene(&self) -> io::Result<CachedScene> {
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        let version = self.source.version();
        if last.version != Some(version) {
            let bytes = gzipped(&self.source.scene()?);
            let hash: String =
                Sha256::digest(&bytes).iter().take(16).map(|byte| format!("{byte:02x}")).collect();
            *last =
                CachedScene { version: Some(version), bytes: Arc::new(bytes), tag: format!("\"{hash}\"") };
        }
        Ok(last.clone())
    }
}
