use std::fmt;
use std::sync::Arc;

/// What may end an analysis from outside: asked before each Newton iteration and each solution in a
/// search for eigenvalues, so that also a long step ends soon.
///
/// Once it has answered yes it should go on to do so.
///
/// ```
/// use std::sync::Arc;
/// use std::sync::atomic::{AtomicBool, Ordering};
///
/// use ancf::analysis::Interrupt;
///
/// let stop = Arc::new(AtomicBool::new(false));
/// let heard = Arc::clone(&stop);
/// let interrupt = Interrupt::new(move || heard.load(Ordering::Relaxed));
/// assert!(!interrupt.is_set());
/// stop.store(true, Ordering::Relaxed);
/// assert!(interrupt.is_set());
/// ```
#[derive(Clone, Default)]
pub struct Interrupt(Option<Arc<dyn Fn() -> bool + Send + Sync>>);

impl Interrupt {
    /// Asks `ask`.
    pub fn new(ask: impl Fn() -> bool + Send + Sync + 'static) -> Self {
        Self(Some(Arc::new(ask)))
    }

    /// Whether the analysis is to end. Never by default.
    pub fn is_set(&self) -> bool {
        self.0.as_ref().is_some_and(|ask| ask())
    }
}

impl fmt::Debug for Interrupt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Interrupt").finish_non_exhaustive()
    }
}
