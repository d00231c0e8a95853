//! Signals that stop a run: Ctrl-C, and SIGTERM on Unix.
//!
//! SIGHUP is not handled: `nohup` ignores it.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

use ancf::solver::newton::Interrupt;
use anyhow::{Context, Result};

/// True after SIGTERM.
static TERMINATED: LazyLock<Arc<AtomicBool>> = LazyLock::new(Arc::default);

/// Installs the signal handlers and returns the interrupt flag.
pub fn interrupt() -> Result<Interrupt> {
    let stop = Arc::new(AtomicBool::new(false));
    let flag = Arc::clone(&stop);
    ctrlc::set_handler(move || flag.store(true, Ordering::Relaxed)).context("cannot handle Ctrl-C")?;
    #[cfg(unix)]
    signal_hook::flag::register(signal_hook::consts::SIGTERM, Arc::clone(&TERMINATED))
        .context("cannot handle SIGTERM")?;
    Ok(Interrupt::new(move || stop.load(Ordering::Relaxed) || is_terminated()))
}

/// True if SIGTERM stopped the run.
pub fn is_terminated() -> bool {
    TERMINATED.load(Ordering::Relaxed)
}
