use super::stopping::NewtonReport;

/// Reduction of the energies of the increments beyond which they may be rounding errors.
const EXHAUSTED: f64 = 1e-24;

/// Increment of the coordinates, relative to their size, below which an iteration may end at rounding errors; smallest limit.
const SETTLED: f64 = 0.1;
const LEAST_LIMIT: f64 = 1e-6;

/// Progress of one iteration.
#[derive(Default)]
pub(crate) struct IterationProgress {
    pub(crate) report: NewtonReport,
    /// Energy of the first increment.
    pub(crate) first: Option<f64>,
    /// Smallest energy of an increment so far.
    least: Option<f64>,
    /// Energy of the last increment.
    pub(crate) last: Option<f64>,
    /// Energies of the two increments before it.
    before: [f64; 2],
    /// Smallest norm of the gaps of the constraints before an increment, in statics.
    pub(crate) gap: Option<f64>,
    /// Largest norm of these gaps.
    pub(crate) widest: f64,
    /// Number of consecutive iterations that did not halve the energy.
    pub(crate) stagnant: u32,
}

impl IterationProgress {
    /// Returns the rate θ of the last two increments in the norm whose square is the energy.
    pub(crate) fn rate(&self, energy: f64) -> Option<f64> {
        self.last.map(|last| (energy / last).sqrt())
    }

    /// Returns the largest energy of the last three increments.
    pub(crate) fn recent(&self) -> Option<f64> {
        self.last.map(|last| self.before.into_iter().fold(last, f64::max))
    }

    /// Returns true if the energies have decreased by more than the stopping rule requires of a motion.
    ///
    /// Where joints carry all loads, there is no energy of a motion to compare with, and increments may decrease without limit. The
    /// energies are compared with that of the first increment. Later ones may be larger by any factor: an increment along straight
    /// tangents stretches slender bodies.
    pub(crate) fn is_exhausted(&self) -> bool {
        self.last.zip(self.first).is_some_and(|(last, first)| last <= EXHAUSTED * first)
    }

    /// Returns true if the last increment is small compared with coordinates of this norm.
    ///
    /// A state with large increments is no equilibrium, even if its residual is a rounding error, which grows with the strains: a free
    /// part of a body is first stretched without limit.
    pub(crate) fn is_settled(&self, size: f64) -> bool {
        self.report.increment <= (SETTLED * size).max(LEAST_LIMIT)
    }

    pub(crate) fn record(&mut self, energy: f64) {
        self.before = [self.last.unwrap_or(0.0), self.before[0]];
        let stagnant = self.least.is_some_and(|least| energy >= 0.5 * least);
        self.stagnant = if stagnant { self.stagnant + 1 } else { 0 };
        self.last = Some(energy);
        self.least = Some(self.least.map_or(energy, |least| least.min(energy)));
    }
}
