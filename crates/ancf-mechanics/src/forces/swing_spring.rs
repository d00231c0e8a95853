use ancf_solver::equations::{
    Energy, Inadmissibility, LOCAL, Local, LocalMatrix, LocalStep, State, Term, Weights, middle_residual,
};

use super::angle_ratio::{inadmissible_angle, passes_half_turn, ratio};
use super::measure_set::MeasureSet;
use crate::constraints::{BilinearMeasure, Wrench, add_outer};

/// Springs and parallel dampers that resist the swing of an axis x of one body from an axis e of another one.
///
/// The swing is the vector s = β c/|c|, c = e × x, of the smallest rotation that takes e to x, with the angle β between
/// them. In directions u, v = e × u of the other body: s_u = −f(C) x·v, s_v = f(C) x·u, C = x·e, f = β/sin β. A rotation
/// of either body about its own axis has no effect on |s|. U = ½ (k_u s_u² + k_v s_v²); the dampers dissipate
/// d_u ṡ_u² + d_v ṡ_v². The swing is regular below half a turn. A larger one is inadmissible.
///
/// The derivative of the damper forces by q is not symmetric. The tangent contains its symmetric part.
///
/// Units: stiffness moment/radian, damping moment × time/radian.
#[derive(Clone, Debug)]
pub struct SwingSpring {
    /// x·e, x·u and x·v.
    measures: MeasureSet<3>,
    stiffness: [f64; 2],
    damping: [f64; 2],
}

/// Products whose sign and number give s_u and s_v.
const PARTS: [(usize, f64); 2] = [(2, -1.0), (1, 1.0)];
/// Norm of the changes of the products in a step below which the forces of their means do its work.
const SMALL_CHANGE: f64 = 1e-10;

/// Component of the swing with its derivatives by the products C and m.
#[derive(Clone, Copy)]
struct Component {
    /// Number of the product m.
    part: usize,
    value: f64,
    /// Derivatives by C and m, and by C, C and C, m.
    by: [f64; 2],
    second: [f64; 2],
    /// Rate, and generalised force k s + d ṡ.
    rate: f64,
    force: f64,
}

impl SwingSpring {
    /// Creates springs and dampers about u and v from the products x·e, x·u and x·v, which are 1, 0 and 0 in the reference
    /// state.
    pub fn new(products: [BilinearMeasure; 3], stiffness: [f64; 2], damping: [f64; 2]) -> Self {
        Self { measures: MeasureSet::new(products), stiffness, damping }
    }

    /// Returns the components of the swing for the changes of the products and their rates.
    fn components(&self, products: [f64; 3], rates: [f64; 3]) -> [Component; 2] {
        let [f, slope, curvature] = ratio(-products[0]);
        [0, 1].map(|k| {
            let (part, sign) = PARTS[k];
            let (m, by) = (products[part], [sign * slope * products[part], sign * f]);
            let (value, rate) = (sign * f * m, by[0] * rates[0] + by[1] * rates[part]);
            let force = self.stiffness[k] * value + self.damping[k] * rate;
            Component { part, value, by, second: [sign * curvature * m, sign * slope], rate, force }
        })
    }

    /// Returns the potential and the elastic forces on the products, from the changes of the products.
    fn elastic(&self, products: [f64; 3]) -> (f64, [f64; 3]) {
        let [f, slope, _] = ratio(-products[0]);
        let (mut energy, mut forces) = (0.0, [0.0; 3]);
        for (k, (part, sign)) in PARTS.into_iter().enumerate() {
            let (value, stiffness) = (sign * f * products[part], self.stiffness[k]);
            energy += 0.5 * stiffness * value * value;
            forces[0] += stiffness * value * sign * slope * products[part];
            forces[part] += stiffness * value * sign * f;
        }
        (energy, forces)
    }

    fn now(&self, at: &Local<'_>) -> [Component; 2] {
        self.components(self.measures.changes(at.q), self.measures.slopes(at.q, at.v))
    }

    /// Returns the generalised forces on the products.
    fn forces(components: &[Component; 2]) -> [f64; 3] {
        let mut forces = [0.0; 3];
        for Component { part, by, force, .. } in components {
            forces[0] += force * by[0];
            forces[*part] += force * by[1];
        }
        forces
    }

    /// Returns the force and moment on the body of x.
    pub fn reaction(&self, s: &State) -> Wrench {
        let [changes, rates] = self.measures.of_state(s);
        self.measures.reaction(s, Self::forces(&self.components(changes, rates)))
    }

    /// Adds f times the second derivative of a component.
    fn add_curvature(
        &self,
        q: &[f64],
        gradients: &[[f64; LOCAL]; 3],
        Component { part, by, second, .. }: &Component,
        f: f64,
        k: &mut LocalMatrix<'_>,
    ) {
        let n = q.len();
        add_outer(&gradients[0], &gradients[0], f * second[0], n, k);
        add_outer(&gradients[0], &gradients[*part], 2.0 * f * second[1], n, k);
        self.measures.measure(0).add_curvature(q, f * by[0], k);
        self.measures.measure(*part).add_curvature(q, f * by[1], k);
    }
}

/// Returns α x + β y.
fn sum(alpha: f64, x: &[f64; LOCAL], beta: f64, y: &[f64; LOCAL]) -> [f64; LOCAL] {
    std::array::from_fn(|i| alpha * x[i] + beta * y[i])
}

impl Term for SwingSpring {
    fn coordinates(&self) -> &[usize] {
        self.measures.coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.measures.add_forces(at.q, Self::forces(&self.now(at)), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (n, components, gradients) = (at.q.len(), self.now(at), self.measures.gradients(at.q));
        let errors = self.measures.add_rounding(at, Self::forces(&components), &gradients, floor);
        for (k, Component { part, by, second, force, rate, .. }) in components.iter().enumerate() {
            let along = |of: usize| by[0].abs() * errors[0][of] + by[1].abs() * errors[*part][of];
            let turning = second[0].abs() * errors[0][0]
                + second[1].abs() * (errors[0][0] + errors[*part][0])
                + f64::EPSILON * (by[0].abs() + by[1].abs());
            let of_rate = along(1) + turning * rate.abs() / by[1].abs();
            let of_force = self.stiffness[k] * along(0) + self.damping[k] * of_rate;
            for i in 0..n {
                let size = gradients[0][i].abs() + gradients[*part][i].abs();
                floor[i] += 4.0 * (of_force * (by[0].abs() + by[1].abs()) + turning * force.abs()) * size;
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (n, gradients) = (at.q.len(), self.measures.gradients(at.q));
        let rates = self.measures.slopes(at.q, at.v);
        for (i, component) in self.now(at).iter().enumerate() {
            let Component { part, by, second, force, .. } = *component;
            let slope = sum(by[0], &gradients[0], by[1], &gradients[part]);
            add_outer(&slope, &slope, w.q * self.stiffness[i] + w.v * self.damping[i], n, k);
            self.add_curvature(at.q, &gradients, component, w.q * force, k);
            if self.damping[i] > 0.0 {
                let of_c = second[0] * rates[0] + second[1] * rates[part];
                let mut turned = sum(of_c, &gradients[0], second[1] * rates[0], &gradients[part]);
                for (product, by) in [0, part].into_iter().zip(by) {
                    self.measures.measure(product).add_gradient_slope(at.q, at.v, by, &mut turned[..n]);
                }
                add_outer(&slope, &turned, w.q * self.damping[i], n, k);
            }
        }
    }

    /// The elastic forces on the products do exactly the work of the potential: those of the mean products, corrected along
    /// the change of the products.
    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        middle_residual(self, step, r);
        let [from, middle, to] = [step.from.q, step.middle.q, step.to.q].map(|q| self.measures.changes(q));
        let mean = [0, 1, 2].map(|i| 0.5 * (from[i] + to[i]));
        let moved = [0, 1, 2].map(|i| to[i] - from[i]);
        let (_, of_middle) = self.elastic(middle);
        let (_, mut forces) = self.elastic(mean);
        let work = self.elastic(to).0 - self.elastic(from).0;
        let missed = work - (0..3).map(|i| forces[i] * moved[i]).sum::<f64>();
        let square: f64 = moved.iter().map(|x| x * x).sum();
        if square > SMALL_CHANGE * SMALL_CHANGE {
            (0..3).for_each(|i| forces[i] += missed / square * moved[i]);
        }
        self.measures.replace_step_forces(step, [&of_middle, &forces], moved, r);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let gradients = self.measures.gradients(at.q);
        let moved = self.measures.slopes(at.q, by.q);
        for (i, component) in self.now(at).iter().enumerate() {
            let turn = component.by[0] * moved[0] + component.by[1] * moved[component.part];
            self.add_curvature(at.q, &gradients, component, self.stiffness[i] * turn, k);
        }
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        inadmissible_angle(self.measures.measure(0).change(at.q))
    }

    fn has_half_turn(&self) -> bool {
        true
    }

    fn passes_half_turn(&self, from: &Local<'_>, to: &Local<'_>) -> bool {
        let [from, to] = [from, to].map(|at| self.measures.changes(at.q));
        passes_half_turn([from[0], to[0]], [&from[1..], &to[1..]])
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let components = self.now(at);
        let strain = (0..2).map(|k| 0.5 * self.stiffness[k] * components[k].value.powi(2)).sum();
        Energy { strain, ..Energy::default() }
    }
}
