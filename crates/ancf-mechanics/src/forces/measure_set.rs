use ancf_solver::equations::{LOCAL, Local, LocalStep, State, correct_work};

use crate::constraints::{BilinearMeasure, Wrench};

/// Products of vectors on whose changes a potential depends, over their common coordinates.
#[derive(Clone, Debug)]
pub(super) struct MeasureSet<const N: usize> {
    global: [BilinearMeasure; N],
    local: [BilinearMeasure; N],
    coordinates: Vec<usize>,
}

impl<const N: usize> MeasureSet<N> {
    pub(super) fn new(global: [BilinearMeasure; N]) -> Self {
        let mut coordinates: Vec<usize> = global.iter().flat_map(BilinearMeasure::coordinates).collect();
        coordinates.sort_unstable();
        coordinates.dedup();
        let local = global.each_ref().map(|measure| measure.within(&coordinates));
        Self { global, local, coordinates }
    }

    pub(super) fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    pub(super) fn measure(&self, k: usize) -> &BilinearMeasure {
        &self.local[k]
    }

    /// Returns the changes of the products from the reference state.
    pub(super) fn changes(&self, q: &[f64]) -> [f64; N] {
        self.local.each_ref().map(|measure| measure.change(q))
    }

    /// Returns the derivatives of the products along a change of the coordinates.
    pub(super) fn slopes(&self, q: &[f64], along: &[f64]) -> [f64; N] {
        self.local.each_ref().map(|measure| measure.slope(q, along))
    }

    /// Returns the changes of the products from the reference state and their rates in a state of the system.
    pub(super) fn of_state(&self, s: &State) -> [[f64; N]; 2] {
        let changes = self.global.each_ref().map(|measure| measure.change(&s.q));
        [changes, self.global.each_ref().map(|measure| measure.slope(&s.q, &s.v))]
    }

    /// Returns the force and moment on the first body for forces on the products.
    pub(super) fn reaction(&self, s: &State, forces: [f64; N]) -> Wrench {
        self.global.iter().zip(forces).map(|(measure, force)| measure.wrench(s, -force)).sum()
    }

    /// Returns the derivatives of the products by the coordinates.
    pub(super) fn gradients(&self, q: &[f64]) -> [[f64; LOCAL]; N] {
        self.local.each_ref().map(|measure| {
            let mut gradient = [0.0; LOCAL];
            measure.add_gradient(q, 1.0, &mut gradient[..q.len()]);
            gradient
        })
    }

    /// Adds the generalised forces of forces on the products.
    pub(super) fn add_forces(&self, q: &[f64], forces: [f64; N], r: &mut [f64]) {
        for (measure, force) in self.local.iter().zip(forces) {
            measure.add_gradient(q, force, r);
        }
    }

    /// Adds bounds of the rounding errors of the generalised forces for exact forces on the products. Returns those of the change and
    /// of the rate of each product.
    pub(super) fn add_rounding(
        &self,
        at: &Local<'_>,
        forces: [f64; N],
        gradients: &[[f64; LOCAL]; N],
        floor: &mut [f64],
    ) -> [[f64; 2]; N] {
        let n = at.q.len();
        std::array::from_fn(|i| {
            let mut of_rate = [0.0; LOCAL];
            let change = self.local[i].add_rounding(at.q, forces[i], floor);
            self.local[i].add_rounding(at.q, 1.0, &mut of_rate[..n]);
            let error = |j: usize| (of_rate[j] + f64::EPSILON * gradients[i][j].abs()) * at.v[j].abs();
            [change, (0..n).map(error).sum()]
        })
    }

    /// Replaces the elastic forces of the middle of a step by others, and corrects their work to that along the changes of the products.
    pub(super) fn replace_step_forces(
        &self,
        step: &LocalStep<'_>,
        [of_middle, forces]: [&[f64; N]; 2],
        moved: [f64; N],
        r: &mut [f64],
    ) {
        let (n, mut change) = (step.to.q.len(), [0.0; LOCAL]);
        (0..n).for_each(|i| change[i] = step.to.q[i] - step.from.q[i]);
        let (mut rest, mut bound) = (0.0, 0.0);
        for (i, measure) in self.local.iter().enumerate() {
            measure.add_gradient(step.middle.q, forces[i] - of_middle[i], r);
            if !measure.is_quadratic() {
                let mut floor = [0.0; LOCAL];
                let of_change = measure.add_rounding(step.middle.q, forces[i], &mut floor[..n]);
                rest += forces[i] * (moved[i] - measure.slope(step.middle.q, &change[..n]));
                bound += 2.0 * (forces[i] * of_change).abs();
                bound += floor.iter().zip(change).map(|(floor, change)| floor * change.abs()).sum::<f64>();
            }
        }
        correct_work(step, [rest, bound], r);
    }
}
