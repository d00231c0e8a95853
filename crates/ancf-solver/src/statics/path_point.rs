use super::equilibrium::Equilibrium;

/// Step sizes along an equilibrium path as arc lengths σ. At the start of the path dσ is the change of the load factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcLengthSteps {
    /// First step size.
    pub first: f64,
    /// Smallest permitted step size.
    pub smallest: f64,
    /// Largest permitted step size.
    pub largest: f64,
    /// Target for the Newton iterations per step. The next step is scaled by √(target/actual), between ½ and 2.
    pub iterations: u32,
}

impl ArcLengthSteps {
    /// Creates adaptive step sizes from a first change of the load factor.
    pub const fn from(first: f64) -> Self {
        Self { first, smallest: 1e-8 * first, largest: f64::INFINITY, iterations: 7 }
    }
}

/// End conditions of an equilibrium path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndConditions {
    /// Load factor at which the path ends exactly, at the first crossing.
    pub load: Option<f64>,
    /// Maximum number of points.
    pub points: u32,
    /// Maximum arc length.
    pub length: f64,
}

/// Condition that ended the path.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EndReason {
    /// The load factor was reached.
    Load,
    /// The number of points was reached.
    Points,
    /// The arc length was reached.
    Length,
    /// The caller stopped the path.
    Stopped,
}

/// Limit point of the load factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitPoint {
    /// Local maximum of the load factor.
    Maximum,
    /// Local minimum of the load factor.
    Minimum,
}

/// Point on an equilibrium path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// Report of the equilibrium solution.
    pub equilibrium: Equilibrium,
    /// Arc length σ from the start of the path.
    pub length: f64,
    /// Slope ds/dσ of the load factor.
    pub slope: f64,
    /// Type of the limit point, if the slope vanishes here.
    pub limit: Option<LimitPoint>,
}
