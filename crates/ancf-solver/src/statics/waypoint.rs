use super::equilibrium::Equilibrium;

/// Sizes of the steps along a path, as arc lengths σ: where the path begins, dσ is the change of the load factor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArcSteps {
    /// The first step.
    pub first: f64,
    /// The least that is tried.
    pub smallest: f64,
    /// The largest that is made.
    pub largest: f64,
    /// Newton iterations that a step should take: the next one is longer by √(wanted/taken), between ½ and 2.
    pub iterations: u32,
}

impl ArcSteps {
    /// Steps that begin with a change of the load factor and adapt themselves.
    pub const fn from(first: f64) -> Self {
        Self { first, smallest: 1e-8 * first, largest: f64::INFINITY, iterations: 7 }
    }
}

/// When to leave a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Until {
    /// At this load factor, exactly, as soon as the path crosses it.
    pub load: Option<f64>,
    /// After so many points.
    pub points: u32,
    /// After so much arc length.
    pub length: f64,
}

/// Why a path was left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Left {
    /// The load factor was reached.
    Load,
    /// So many points were found.
    Points,
    /// The arc length was gone.
    Length,
    /// The receiver of the points wanted no more.
    Broken,
}

/// A load factor beyond which a path turns back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limit {
    /// The largest load near by.
    Maximum,
    /// The least load near by.
    Minimum,
}

/// A point of a path of equilibria.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PathPoint {
    /// How it was found.
    pub equilibrium: Equilibrium,
    /// Arc length σ from the start of the path.
    pub length: f64,
    /// ds/dσ, the slope of the load factor.
    pub slope: f64,
    /// Whether it is a limit point, where the slope vanishes.
    pub limit: Option<Limit>,
}
