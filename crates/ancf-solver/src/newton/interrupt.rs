use std::fmt;
use std::sync::Arc;

/// Interrupt flag that stops an analysis.
///
/// The flag is checked before each Newton iteration and before each solution of an eigenvalue search. Long steps
/// therefore stop early too. Once set, the flag should remain set.
///
/// ```
/// use std::sync::Arc;
/// use std::sync::atomic::{AtomicBool, Ordering};
///
/// use ancf_solver::newton::Interrupt;
///
/// let stop = Arc::new(AtomicBool::new(false));
/// let flag = Arc::clone(&stop);
/// let interrupt = Interrupt::new(move || flag.load(Ordering::Relaxed));
/// assert!(!interrupt.is_set());
/// stop.store(true, Ordering::Relaxed);
/// assert!(interrupt.is_set());
/// ```
#[derive(Clone, Default)]
pub struct Interrupt(Option<Arc<dyn Fn() -> bool + Send + Sync>>);

impl Interrupt {
    /// Creates an interrupt flag that is read by `is_set`.
    pub fn new(ask: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(ask)))
    }

    /// Returns true if the analysis must stop. The default flag is never set.
    pub fn is_set(&self) -> bool {
        self.0.as_ref().is_some_and(|ask| ask())
    }
}

impl fmt::Debug for Interrupt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Interrupt").finish_non_exhaustive()
    }
}
