use ancf_solver::equations::{
    Energy, LOCAL, Local, LocalMatrix, LocalStep, State, Term, Weights, correct_work,
};

use crate::constraints::{BilinearMeasure, MeasureTarget, Wrench, add_outer};

/// Spring and parallel damper that resist the change of a measure.
///
/// U = ½ k x (x − 2c), x = g(q) − g₀, is ½ k (x − c)² minus its reference value, with the set point c(t). The damper
/// dissipates d ẋ². The forces are (k (x − c) + d ẋ) ∂g/∂q. A moving set point supplies −k x ċ.
///
/// For quadratic g the derivative of the damper force by q is not symmetric. The tangent contains its symmetric part.
///
/// Units: k is energy, d energy × time, each per square of the measure.
#[derive(Clone, Debug)]
pub struct Spring {
    global: BilinearMeasure,
    measure: BilinearMeasure,
    stiffness: f64,
    damping: f64,
    rest: MeasureTarget,
    coordinates: Vec<usize>,
}

impl Spring {
    /// Creates a spring without force in the reference state.
    pub fn new(measure: BilinearMeasure, stiffness: f64, damping: f64) -> Self {
        Self::with_set_point(measure, stiffness, damping, MeasureTarget::NONE)
    }

    /// Creates a spring with a set point, scaled by the load factor.
    pub fn with_set_point(
        measure: BilinearMeasure,
        stiffness: f64,
        damping: f64,
        rest: MeasureTarget,
    ) -> Self {
        let coordinates = measure.coordinates();
        let local = measure.within(&coordinates);
        Self { global: measure, measure: local, stiffness, damping, rest, coordinates }
    }

    fn force(&self, at: &Local<'_>) -> f64 {
        let stretch = self.measure.change(at.q) - self.rest.value(at);
        self.stiffness * stretch + self.damping * self.measure.slope(at.q, at.v)
    }

    /// Returns the force and moment on the first body.
    pub fn reaction(&self, s: &State) -> Wrench {
        let at = Local { q: &s.q, v: &s.v, a: &s.a, lambda: &[], t: s.t, load: s.load };
        let stretch = self.global.change(at.q) - self.rest.value(&at);
        let force = self.stiffness * stretch + self.damping * self.global.slope(at.q, at.v);
        self.global.wrench(s, -force)
    }

    /// Returns the elastic force of a step: that of the weighted stretches of both ends at the set point of the middle.
    fn elastic_force(&self, step: &LocalStep<'_>) -> f64 {
        let [start, end] = step.shares();
        let stretch = start * self.measure.change(step.from.q) + end * self.measure.change(step.to.q);
        self.stiffness * (stretch - self.rest.value(&step.middle))
    }

    /// Adds the tangent of a force on the measure with the given stiffness.
    fn add_tangent(&self, at: &Local<'_>, w: Weights, [stiffness, force]: [f64; 2], k: &mut LocalMatrix<'_>) {
        let (n, gradient, mut turned) = (at.q.len(), self.gradient(at), [0.0; LOCAL]);
        add_outer(&gradient, &gradient, stiffness, n, k);
        self.measure.add_curvature(at.q, w.q * force, k);
        if self.damping > 0.0 {
            self.measure.add_gradient_slope(at.q, at.v, 1.0, &mut turned[..n]);
            add_outer(&gradient, &turned, w.q * self.damping, n, k);
        }
    }

    fn gradient(&self, at: &Local<'_>) -> [f64; LOCAL] {
        let mut gradient = [0.0; LOCAL];
        self.measure.add_gradient(at.q, 1.0, &mut gradient[..at.q.len()]);
        gradient
    }
}

impl Term for Spring {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.measure.add_gradient(at.q, self.force(at), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let n = at.q.len();
        let of_change = self.measure.add_rounding(at.q, self.force(at), floor);
        let mut of_rate = [0.0; LOCAL];
        let mut slopes = 0.0;
        let gradient = self.gradient(at);
        self.measure.add_rounding(at.q, 1.0, &mut of_rate[..n]);
        for i in 0..n {
            slopes += (of_rate[i] + f64::EPSILON * gradient[i].abs()) * at.v[i].abs();
        }
        let of_set = f64::EPSILON * self.rest.size(at);
        let error = 2.0 * (self.stiffness * (of_change + of_set) + self.damping * slopes);
        for i in 0..n {
            floor[i] += error * gradient[i].abs();
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        self.add_tangent(at, w, [w.q * self.stiffness + w.v * self.damping, self.force(at)], k);
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        let middle = &step.middle;
        let damping = self.damping * self.measure.slope(middle.q, middle.v);
        let force = self.elastic_force(step);
        self.measure.add_gradient(middle.q, force + damping, r);
        if !self.measure.is_quadratic() {
            let (mut moved, mut floor) = ([0.0; LOCAL], [0.0; LOCAL]);
            let n = middle.q.len();
            (0..n).for_each(|i| moved[i] = step.to.q[i] - step.from.q[i]);
            let change = self.measure.change(step.to.q) - self.measure.change(step.from.q);
            let missed = force * (change - self.measure.slope(middle.q, &moved[..n]));
            let of_change = self.measure.add_rounding(middle.q, force, &mut floor[..n]);
            let of_force: f64 = floor.iter().zip(moved).map(|(floor, moved)| floor * moved.abs()).sum();
            correct_work(step, [missed, 2.0 * (force * of_change).abs() + of_force], r);
        }
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let middle = &step.middle;
        let force = self.elastic_force(step) + self.damping * self.measure.slope(middle.q, middle.v);
        let stiffness = 2.0 * step.shares()[1] * w.q * self.stiffness + w.v * self.damping;
        self.add_tangent(middle, w, [stiffness, force], k);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let stretch = self.measure.slope(at.q, by.q) - by.load * self.rest.by_load(at);
        self.measure.add_curvature(at.q, self.stiffness * stretch, k);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let change = self.measure.change(at.q);
        let strain = 0.5 * self.stiffness * change * (change - 2.0 * self.rest.value(at));
        Energy { strain, ..Energy::default() }
    }

    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let [moved, _] = self.rest.rates(at.t);
        -self.stiffness * self.measure.change(at.q) * moved
    }
}
