use ancf_solver::equations::{Batch, Energy, LANES, Lanes, Level, LocalLanes, Weights};
use pulp::Simd;

use crate::lanes::{Lane, Pass, PassJob, run, total};

/// Computations of one pass over a batch of elements, from which a [`Batch`] is built. See there for `at`, `r` and `k`.
pub(crate) trait BatchKernel: Send + Sync {
    fn count(&self) -> usize;

    /// Returns true if any force depends on velocities.
    fn is_damped(&self) -> bool;

    /// Returns true for constraints only ([`Batch::is_constraint`]).
    fn is_constraint(&self) -> bool {
        false
    }

    /// Returns the entries of sparse tangents.
    fn entries(&self) -> Option<&[[u8; 2]]> {
        None
    }

    fn add_residual<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, r: &mut [Lanes]);

    fn set_tangent<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]);

    /// Sets the stiffness with predicted stresses ([`Batch::predicted_stiffness`]).
    #[inline(always)]
    fn set_predicted<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, _from: &[Lanes], k: &mut [Lanes]) {
        self.set_tangent(pass, at, Weights::STIFFNESS, k);
    }

    /// Adds the constraints of terms with multipliers.
    fn add_constraints<S: Simd>(&self, _: Pass<S>, _: &LocalLanes<'_>, _: Level, _: &mut [Lanes]) {}

    /// Returns kinetic, strain and potential energies.
    fn energies<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>) -> [Lane<S>; 3];

    /// Marks lanes with inadmissible states. Lanes of other passes remain unchanged.
    fn check_admissible<S: Simd>(&self, pass: Pass<S>, at: &LocalLanes<'_>, admissible: &mut [bool; LANES]);
}

/// Kernel as a [`Batch`].
pub(crate) struct KernelBatch<K>(pub(crate) K);

impl<K: BatchKernel> Batch for KernelBatch<K> {
    fn count(&self) -> usize {
        self.0.count()
    }

    fn residual(&self, at: &LocalLanes<'_>, r: &mut [Lanes]) {
        run(self.0.count(), ResidualJob { kernel: &self.0, at, r });
    }

    fn tangent(&self, at: &LocalLanes<'_>, w: Weights, k: &mut [Lanes]) {
        run(self.0.count(), TangentJob { kernel: &self.0, at, w, k });
    }

    fn predicted_stiffness(&self, at: &LocalLanes<'_>, from: &[Lanes], k: &mut [Lanes]) {
        run(self.0.count(), PredictedJob { kernel: &self.0, at, from, k });
    }

    fn entries(&self) -> Option<&[[u8; 2]]> {
        self.0.entries()
    }

    fn constraints(&self, at: &LocalLanes<'_>, level: Level, phi: &mut [Lanes]) {
        run(self.0.count(), ConstraintsJob { kernel: &self.0, at, level, phi });
    }

    fn energy(&self, at: &LocalLanes<'_>) -> Energy {
        let (count, mut parts) = (self.0.count(), [Lanes::default(); 3]);
        run(count, EnergyJob { kernel: &self.0, at, parts: &mut parts });
        let [kinetic, strain, potential] = parts.map(|part| total(&part, count));
        Energy { kinetic, strain, potential }
    }

    fn inadmissible(&self, at: &LocalLanes<'_>) -> Option<usize> {
        let (count, mut admissible) = (self.0.count(), [true; LANES]);
        run(count, AdmissibleJob { kernel: &self.0, at, admissible: &mut admissible });
        admissible[..count].iter().position(|admissible| !admissible)
    }

    fn is_constraint(&self) -> bool {
        self.0.is_constraint()
    }

    fn is_damped(&self) -> bool {
        self.0.is_damped()
    }

    fn damping_forces(&self, at: &LocalLanes<'_>, r: &mut [Lanes]) {
        if self.is_damped() {
            add_velocity_forces(self, at, r);
        }
    }
}

/// Adds the velocity-dependent forces f(q, v) − f(q, 0).
fn add_velocity_forces(batch: &dyn Batch, at: &LocalLanes<'_>, r: &mut [Lanes]) {
    let zeros = [Lanes::default(); 32];
    let mut still = zeros;
    let (n, a) = (at.q.len(), &zeros[..at.q.len()]);
    batch.residual(&LocalLanes { a, load: 0.0, ..*at }, r);
    batch.residual(&LocalLanes { a, v: a, load: 0.0, ..*at }, &mut still[..n]);
    for (r, still) in r.iter_mut().zip(&still) {
        r.0.iter_mut().zip(still.0).for_each(|(r, still)| *r -= still);
    }
}

struct ResidualJob<'a, K> {
    kernel: &'a K,
    at: &'a LocalLanes<'a>,
    r: &'a mut [Lanes],
}

impl<K: BatchKernel> PassJob for ResidualJob<'_, K> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, pass: Pass<S>) {
        self.kernel.add_residual(pass, self.at, self.r);
    }
}

struct TangentJob<'a, K> {
    kernel: &'a K,
    at: &'a LocalLanes<'a>,
    w: Weights,
    k: &'a mut [Lanes],
}

impl<K: BatchKernel> PassJob for TangentJob<'_, K> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, pass: Pass<S>) {
        self.kernel.set_tangent(pass, self.at, self.w, self.k);
    }
}

struct PredictedJob<'a, K> {
    kernel: &'a K,
    at: &'a LocalLanes<'a>,
    from: &'a [Lanes],
    k: &'a mut [Lanes],
}

impl<K: BatchKernel> PassJob for PredictedJob<'_, K> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, pass: Pass<S>) {
        self.kernel.set_predicted(pass, self.at, self.from, self.k);
    }
}

struct ConstraintsJob<'a, K> {
    kernel: &'a K,
    at: &'a LocalLanes<'a>,
    level: Level,
    phi: &'a mut [Lanes],
}

impl<K: BatchKernel> PassJob for ConstraintsJob<'_, K> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, pass: Pass<S>) {
        self.kernel.add_constraints(pass, self.at, self.level, self.phi);
    }
}

struct EnergyJob<'a, K> {
    kernel: &'a K,
    at: &'a LocalLanes<'a>,
    parts: &'a mut [Lanes; 3],
}

impl<K: BatchKernel> PassJob for EnergyJob<'_, K> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, pass: Pass<S>) {
        let energies = self.kernel.energies(pass, self.at);
        self.parts.iter_mut().zip(energies).for_each(|(part, energy)| pass.store(part, energy));
    }
}

struct AdmissibleJob<'a, K> {
    kernel: &'a K,
    at: &'a LocalLanes<'a>,
    admissible: &'a mut [bool; LANES],
}

impl<K: BatchKernel> PassJob for AdmissibleJob<'_, K> {
    #[inline(always)]
    fn run<S: Simd>(&mut self, pass: Pass<S>) {
        self.kernel.check_admissible(pass, self.at, self.admissible);
    }
}
