use std::fmt;
use std::sync::Arc;

use num_dual::Dual2_64;

/// Number with its first two derivatives, the scalar of user force laws with automatic derivatives.
pub type LawNumber = Dual2_64;

/// State of the coordinate of a force law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LawState {
    /// Time t.
    pub t: f64,
    /// Coordinate x: elongation, displacement or angle.
    pub x: f64,
    /// Rate v = dx/dt.
    pub v: f64,
}

/// Force of a law with its derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct LawValue {
    /// Force or moment f.
    pub force: f64,
    /// Derivative ∂f/∂x.
    pub by_position: f64,
    /// Derivative ∂f/∂v.
    pub by_rate: f64,
}

/// Law of a force along one coordinate: f(t, x, v).
///
/// Calls come from any thread, also concurrently, for arguments in any order. The result must depend on the arguments alone.
/// A force that is not a number ends the analysis as divergence.
pub trait ForceLaw: fmt::Debug + Send + Sync {
    /// Returns the force with its exact derivatives. They determine the convergence of the iterations, and modes and
    /// linear models.
    fn at(&self, state: LawState) -> LawValue;

    /// True if the force depends on x and v alone.
    ///
    /// Then f(x, 0) has the potential −∫ f dx, which is part of the energy, and f(x, v) − f(x, 0) is dissipated. Otherwise f(t, x, 0)
    /// counts as supplied work.
    fn is_autonomous(&self) -> bool;
}

/// Force law of a program: a shared [`ForceLaw`].
///
/// Clones are the same law and compare equal. Separately created laws differ.
#[derive(Clone, Debug)]
pub struct UserForceLaw(Arc<dyn ForceLaw>);

impl UserForceLaw {
    /// Creates a law from an implementation.
    pub fn new(law: impl ForceLaw + 'static) -> Self {
        Self(Arc::new(law))
    }

    /// Creates a law from a function of t, x and v with its derivatives.
    pub fn with_derivatives(
        f: impl Fn(LawState) -> LawValue + Send + Sync + 'static,
        autonomous: bool,
    ) -> Self {
        Self::new(Closure { law: f, autonomous })
    }

    /// Creates a law from a function of t, x and v. The derivatives are exact, by dual numbers: two evaluations per value.
    ///
    /// ```
    /// use ancf_mechanics::laws::{ForceLaw, LawNumber, LawState, UserForceLaw};
    ///
    /// let duffing = |_t: f64, x: LawNumber, v: LawNumber| -(x * 4.0 + x * x * x * 10.0 + v * 0.1);
    /// let law = UserForceLaw::by_dual_numbers(duffing, true);
    /// let value = law.get().at(LawState { t: 0.0, x: 0.5, v: 0.0 });
    /// assert_eq!(value.by_position, -(4.0 + 30.0 * 0.25));
    /// assert_eq!(value.by_rate, -0.1);
    /// ```
    pub fn by_dual_numbers(
        f: impl Fn(f64, LawNumber, LawNumber) -> LawNumber + Send + Sync + 'static,
        autonomous: bool,
    ) -> Self {
        let law = move |LawState { t, x, v }: LawState| {
            let along_x = f(t, LawNumber::new(x, 1.0, 0.0), LawNumber::from_re(v));
            let along_v = f(t, LawNumber::from_re(x), LawNumber::new(v, 1.0, 0.0));
            LawValue { force: along_x.re, by_position: along_x.v1, by_rate: along_v.v1 }
        };
        Self::with_derivatives(law, autonomous)
    }

    /// Returns the law.
    pub fn get(&self) -> &Arc<dyn ForceLaw> {
        &self.0
    }
}

impl PartialEq for UserForceLaw {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// Law by a function.
struct Closure<F> {
    law: F,
    autonomous: bool,
}

impl<F> fmt::Debug for Closure<F> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ForceLaw").field("autonomous", &self.autonomous).finish_non_exhaustive()
    }
}

impl<F: Fn(LawState) -> LawValue + Send + Sync> ForceLaw for Closure<F> {
    fn at(&self, state: LawState) -> LawValue {
        (self.law)(state)
    }

    fn is_autonomous(&self) -> bool {
        self.autonomous
    }
}
