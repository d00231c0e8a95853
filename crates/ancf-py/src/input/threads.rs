//! Computations without the lock of the interpreter.

use std::process;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// Process that loaded the library.
static LOADED: OnceLock<u32> = OnceLock::new();
/// Forked process with its threads. The process that loaded the library does not lock it.
static FORKED: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Stack size of a thread in bytes, as of a main thread.
const STACK: usize = 8 << 20;

/// Records the process that loads the library.
pub(crate) fn record_process() {
    LOADED.get_or_init(process::id);
}

/// Computes without the lock of the interpreter.
///
/// A forked process has no other threads: work for the pool of its parent would wait for ever. It has a pool of its own.
pub(crate) fn detached<T: Send>(py: Python<'_>, work: impl FnOnce() -> T + Send) -> T {
    py.detach(|| match forked_pool() {
        Some(pool) => pool.install(work),
        None => work(),
    })
}

/// Returns the pool of a forked process; `None` in the process that loaded the library, and without memory for threads.
fn forked_pool() -> Option<Arc<ThreadPool>> {
    let own = process::id();
    if LOADED.get().is_none_or(|loaded| *loaded == own) {
        return None;
    }
    let mut forked = FORKED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((process, pool)) = &*forked
        && *process == own
    {
        return Some(Arc::clone(pool));
    }
    let pool = Arc::new(ThreadPoolBuilder::new().stack_size(STACK).build().ok()?);
    // A pool of the parent has no threads here, which would end it.
    std::mem::forget(forked.replace((own, Arc::clone(&pool))));
    Some(pool)
}
