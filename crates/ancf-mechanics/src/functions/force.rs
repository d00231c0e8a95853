use std::fmt;
use std::sync::Arc;

type Law = dyn Fn(f64, [f64; 3], [f64; 3]) -> [f64; 3] + Send + Sync;

/// The force on a point that the program computes from time, position and velocity of the point: F(t, x, v).
///
/// It is called from any thread, from several at once, for arguments in any order, those of iterations on the way to a solution
/// and of differences about them among them. What it returns must depend on its arguments alone. A component that is no
/// number ends the analysis as one that diverged.
///
/// Clones are the same function, and equal; functions made apart are not.
///
/// Units: force, time, length, length/time; all vectors in the global frame.
#[derive(Clone)]
pub struct ForceFunction(Arc<Law>);

impl ForceFunction {
    /// The force at a time t, of a point at x that moves with the velocity v.
    pub fn new(f: impl Fn(f64, [f64; 3], [f64; 3]) -> [f64; 3] + Send + Sync + 'static) -> Self {
        Self(Arc::new(f))
    }

    /// F(t, x, v).
    pub fn at(&self, t: f64, x: [f64; 3], v: [f64; 3]) -> [f64; 3] {
        (self.0)(t, x, v)
    }

    /// The same force in other units, whose lengths, times and forces are so many of its own.
    #[must_use]
    pub fn in_units(&self, length: f64, time: f64, force: f64) -> Self {
        let own = self.clone();
        let speed = length / time;
        Self::new(move |t, x, v| {
            own.at(t * time, x.map(|x| x * length), v.map(|v| v * speed)).map(|f| f / force)
        })
    }

    /// The same force at all times as at this one.
    #[must_use]
    pub fn held(&self, t: f64) -> Self {
        let own = self.clone();
        Self::new(move |_, x, v| own.at(t, x, v))
    }
}

impl PartialEq for ForceFunction {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl fmt::Debug for ForceFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ForceFunction").finish_non_exhaustive()
    }
}
