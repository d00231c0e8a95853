//! What stops a run: Ctrl-C, and SIGTERM where there is such.
//!
//! SIGHUP does not: under `nohup` it is ignored, and is to stay so.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

use ancf::analysis::Interrupt;
use anyhow::{Context, Result};

/// Whether SIGTERM came.
static TERMINATED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Listens from now on.
pub fn interrupt() -> Result<Interrupt> {
    let stop = Arc::new(AtomicBool::new(false));
    let heard = Arc::clone(&stop);
    ctrlc::set_handler(move || heard.store(true, Ordering::Relaxed)).context("cannot listen to Ctrl-C")?;
    #[cfg(unix)]
    signal_hook::flag::register(signal_hook::consts::SIGTERM, Arc::clone(&TERMINATED))
        .context("cannot listen to SIGTERM")?;
    Ok(Interrupt::new(move || stop.load(Ordering::Relaxed) || is_terminated()))
}

/// Whether it was SIGTERM that stopped the run.
pub fn is_terminated() -> bool {
    TERMINATED.load(Ordering::Relaxed)
}
