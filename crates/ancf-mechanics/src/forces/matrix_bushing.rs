use ancf_solver::equations::{
    Energy, Inadmissibility, LOCAL, Local, LocalMatrix, LocalStep, State, Term, Weights, middle_residual,
};
use nalgebra::{Matrix6, Vector6};

use super::angle_ratio::{inadmissible_angle, passes_half_turn, ratio};
use super::measure_set::MeasureSet;
use crate::constraints::{BilinearMeasure, Wrench, add_outer};

/// Bushing with full matrices: forces and moments that are linear in the displacement and the rotation of one body relative
/// to another one.
///
/// ζ = (d, φ) with the displacement d_i = b_i·(r_a − r_b) and the rotation vector φ in the axes b_i of the second body:
/// φ = f(C) m, m_i = sin β n_i, C = cos β, f = β/sin β, for the rotation by β about n. U = ½ ζᵀ K ζ + s p·ζ with the preload p and
/// the load factor s. The forces are ζ_qᵀ (K ζ + D ζ̇ + s p); the damper dissipates ζ̇ᵀ D ζ̇. ζ is regular below half a turn. A larger
/// rotation is inadmissible.
///
/// The derivative of the damper forces by q is not symmetric. The tangent contains its symmetric part.
#[derive(Clone, Debug)]
pub struct MatrixBushing {
    /// Displacements, C and m.
    measures: MeasureSet<MEASURES>,
    matrices: BushingMatrices,
}

/// Stiffness, damping and preload of a bushing. The matrices are symmetric.
///
/// Units: force/length, force and force × length/radian in the blocks of K, times time in those of D.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BushingMatrices {
    /// Stiffness K.
    pub stiffness: Matrix6<f64>,
    /// Damping D.
    pub damping: Matrix6<f64>,
    /// Force and moment p on the second body in the reference state.
    pub preload: Vector6<f64>,
}

/// Number of products: three displacements, C and three components of m.
const MEASURES: usize = 7;
/// Number of the product C.
const COSINE: usize = 3;
/// Change of C below which a difference quotient equals the derivative in the middle up to rounding.
const SMALL_CHANGE: f64 = 1e-5;

type Products = [f64; MEASURES];

/// Displacement and rotation with their derivatives by the products.
struct Deformation {
    value: Vector6<f64>,
    /// Derivative of each component by its own product.
    own: [f64; 6],
    /// Derivative of each component by C.
    by_cosine: [f64; 6],
    /// Second derivatives by C, and by C and the own product.
    second: [[f64; 2]; 6],
}

/// Number of the own product of a component.
const fn own_product(component: usize) -> usize {
    if component < 3 { component } else { component + 1 }
}

impl Deformation {
    /// Returns the deformation for the changes of the products from the reference state.
    fn of(products: &Products) -> Self {
        let [f, slope, curvature] = ratio(-products[COSINE]);
        let (mut value, mut own, mut by_cosine, mut second) =
            (Vector6::zeros(), [1.0; 6], [0.0; 6], [[0.0; 2]; 6]);
        for k in 0..6 {
            let m = products[own_product(k)];
            value[k] = m;
            if k >= 3 {
                value[k] = f * m;
                own[k] = f;
                by_cosine[k] = slope * m;
                second[k] = [curvature * m, slope];
            }
        }
        Self { value, own, by_cosine, second }
    }

    /// Returns the derivative along a change of the products.
    fn along(&self, changes: &Products) -> Vector6<f64> {
        Vector6::from_fn(|k, _| self.own[k] * changes[own_product(k)] + self.by_cosine[k] * changes[COSINE])
    }

    /// Returns the generalised forces on the products for those on the components.
    fn on_products(&self, forces: &Vector6<f64>) -> Products {
        let mut products = [0.0; MEASURES];
        for k in 0..6 {
            products[own_product(k)] += self.own[k] * forces[k];
            products[COSINE] += self.by_cosine[k] * forces[k];
        }
        products
    }
}

impl MatrixBushing {
    /// Creates a bushing from the displacements, C − 1 and m as products, which are zero in the reference state.
    pub fn new(
        displacements: [BilinearMeasure; 3],
        cosine: BilinearMeasure,
        sines: [BilinearMeasure; 3],
        matrices: BushingMatrices,
    ) -> Self {
        let ([a, b, c], [x, y, z]) = (displacements, sines);
        Self { measures: MeasureSet::new([a, b, c, cosine, x, y, z]), matrices }
    }

    /// Returns the forces on the components: K ζ + D ζ̇ + s p.
    fn forces(&self, value: &Vector6<f64>, rate: &Vector6<f64>, load: f64) -> Vector6<f64> {
        let BushingMatrices { stiffness, damping, preload } = &self.matrices;
        stiffness * value + damping * rate + preload * load
    }

    /// Returns the force and moment on the first body.
    pub fn reaction(&self, s: &State) -> Wrench {
        let [changes, rates] = self.measures.of_state(s);
        let deformation = Deformation::of(&changes);
        let forces = self.forces(&deformation.value, &deformation.along(&rates), s.load);
        self.measures.reaction(s, deformation.on_products(&forces))
    }

    /// Returns the deformation, the rates of the products and the forces on the components.
    fn now(&self, at: &Local<'_>) -> (Deformation, Products, Vector6<f64>) {
        let deformation = Deformation::of(&self.measures.changes(at.q));
        let rates = self.measures.slopes(at.q, at.v);
        let forces = self.forces(&deformation.value, &deformation.along(&rates), at.load);
        (deformation, rates, forces)
    }

    /// Adds the second derivative of Σ p ζ for forces p on the components.
    fn add_curvature(
        &self,
        q: &[f64],
        gradients: &[[f64; LOCAL]; MEASURES],
        deformation: &Deformation,
        forces: &Vector6<f64>,
        k: &mut LocalMatrix<'_>,
    ) {
        let n = q.len();
        let (mut twice, mut mixed) = (0.0, [0.0; LOCAL]);
        for (i, [of_cosine, of_both]) in deformation.second.into_iter().enumerate().skip(3) {
            twice += forces[i] * of_cosine;
            add(&mut mixed, &gradients[own_product(i)], forces[i] * of_both);
        }
        add_outer(&gradients[COSINE], &gradients[COSINE], twice, n, k);
        add_outer(&gradients[COSINE], &mixed, 2.0, n, k);
        for (i, force) in deformation.on_products(forces).into_iter().enumerate() {
            self.measures.measure(i).add_curvature(q, force, k);
        }
    }

    /// Adds the symmetric part of the change of the damper forces by the change of ζ̇ with q.
    fn add_turning(
        &self,
        at: &Local<'_>,
        gradients: &[[f64; LOCAL]; MEASURES],
        slopes: &[[f64; LOCAL]; 6],
        rates: &Products,
        weight: f64,
        k: &mut LocalMatrix<'_>,
    ) {
        let (n, deformation) = (at.q.len(), Deformation::of(&self.measures.changes(at.q)));
        let mut turned = [[0.0; LOCAL]; 6];
        for (i, turned) in turned.iter_mut().enumerate() {
            let own = own_product(i);
            let [of_cosine, of_both] = deformation.second[i];
            add(turned, &gradients[COSINE], of_cosine * rates[COSINE] + of_both * rates[own]);
            add(turned, &gradients[own], of_both * rates[COSINE]);
            let measure = self.measures.measure(own);
            measure.add_gradient_slope(at.q, at.v, deformation.own[i], &mut turned[..n]);
            if i >= 3 {
                let (factor, cosine) = (deformation.by_cosine[i], self.measures.measure(COSINE));
                cosine.add_gradient_slope(at.q, at.v, factor, &mut turned[..n]);
            }
        }
        for (i, slope) in slopes.iter().enumerate() {
            let damped = weighted(&turned, |j| self.matrices.damping[(i, j)]);
            add_outer(slope, &damped, weight, n, k);
        }
    }
}

/// Adds a multiple of a vector.
fn add(x: &mut [f64; LOCAL], y: &[f64; LOCAL], factor: f64) {
    x.iter_mut().zip(y).for_each(|(x, y)| *x += factor * y);
}

/// Returns a sum of vectors with weights.
fn weighted(vectors: &[[f64; LOCAL]; 6], weight: impl Fn(usize) -> f64) -> [f64; LOCAL] {
    let mut sum = [0.0; LOCAL];
    vectors.iter().enumerate().for_each(|(j, vector)| add(&mut sum, vector, weight(j)));
    sum
}

impl Term for MatrixBushing {
    fn coordinates(&self) -> &[usize] {
        self.measures.coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let (deformation, _, forces) = self.now(at);
        self.measures.add_forces(at.q, deformation.on_products(&forces), r);
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let (n, gradients) = (at.q.len(), self.measures.gradients(at.q));
        let (deformation, rates, forces) = self.now(at);
        let products = deformation.on_products(&forces);
        let errors = self.measures.add_rounding(at, products, &gradients, floor);
        let (mut of_value, mut of_rate, mut turning) = (Vector6::zeros(), Vector6::zeros(), [0.0; 6]);
        for k in 0..6 {
            let (own, [of_cosine, of_both]) = (own_product(k), deformation.second[k].map(f64::abs));
            let along = |of: usize| {
                deformation.own[k].abs() * errors[own][of]
                    + deformation.by_cosine[k].abs() * errors[COSINE][of]
            };
            turning[k] = of_cosine * errors[COSINE][0]
                + of_both * (errors[COSINE][0] + errors[own][0])
                + f64::EPSILON * (deformation.own[k].abs() + deformation.by_cosine[k].abs());
            of_value[k] = along(0) + f64::EPSILON * deformation.value[k].abs();
            of_rate[k] = along(1) + turning[k] * (rates[own].abs() + rates[COSINE].abs());
        }
        let BushingMatrices { stiffness, damping, preload } = &self.matrices;
        let of_forces = stiffness.abs() * of_value
            + damping.abs() * of_rate
            + (stiffness.abs() * deformation.value.abs() + preload.abs() * at.load.abs()) * f64::EPSILON;
        for k in 0..6 {
            let size = deformation.own[k].abs() + deformation.by_cosine[k].abs();
            let error = 2.0 * (of_forces[k] * size + turning[k] * forces[k].abs());
            for i in 0..n {
                floor[i] += error * (gradients[COSINE][i].abs() + gradients[own_product(k)][i].abs());
            }
        }
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let (n, gradients) = (at.q.len(), self.measures.gradients(at.q));
        let (deformation, rates, forces) = self.now(at);
        let mut slopes = [[0.0; LOCAL]; 6];
        for (i, slope) in slopes.iter_mut().enumerate() {
            add(slope, &gradients[own_product(i)], deformation.own[i]);
            add(slope, &gradients[COSINE], deformation.by_cosine[i]);
        }
        let matrix = self.matrices.stiffness * w.q + self.matrices.damping * w.v;
        for (i, slope) in slopes.iter().enumerate() {
            add_outer(slope, &weighted(&slopes, |j| matrix[(i, j)]), 1.0, n, k);
        }
        self.add_curvature(at.q, &gradients, &deformation, &(forces * w.q), k);
        if self.matrices.damping != Matrix6::zeros() {
            self.add_turning(at, &gradients, &slopes, &rates, w.q, k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        middle_residual(self, step, r);
        let [from, middle, to] = [step.from.q, step.middle.q, step.to.q].map(|q| self.measures.changes(q));
        let moved: Products = std::array::from_fn(|i| to[i] - from[i]);
        let (_, of_middle) = self.elastic(&middle, step.middle.load);
        let forces = self.of_step(&from, &to, step);
        self.measures.replace_step_forces(step, [&of_middle, &forces], moved, r);
    }

    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let deformation = Deformation::of(&self.measures.changes(at.q));
        let moved = self.measures.slopes(at.q, by.q);
        let forces = self.forces(&deformation.along(&moved), &Vector6::zeros(), by.load);
        self.add_curvature(at.q, &self.measures.gradients(at.q), &deformation, &forces, k);
    }

    fn inadmissibility(&self, at: &Local<'_>) -> Option<Inadmissibility> {
        inadmissible_angle(self.measures.measure(COSINE).change(at.q))
    }

    fn has_half_turn(&self) -> bool {
        true
    }

    fn passes_half_turn(&self, from: &Local<'_>, to: &Local<'_>) -> bool {
        let [from, to] = [from, to].map(|at| self.measures.changes(at.q));
        passes_half_turn([from[COSINE], to[COSINE]], [&from[COSINE + 1..], &to[COSINE + 1..]])
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let (strain, _) = self.elastic(&self.measures.changes(at.q), at.load);
        Energy { strain, ..Energy::default() }
    }
}

impl MatrixBushing {
    /// Returns the elastic forces of a step on the products, which do exactly the work of the potential for χ = 0.
    ///
    /// ΔU = p·Δζ for the forces p of the mean deformation, Δφ = f̄ Δm + m̄ Δf with the means f̄ and m̄ of both ends, and the
    /// quotient Δf/ΔC.
    fn of_step(&self, from: &Products, to: &Products, step: &LocalStep<'_>) -> Products {
        let ([start, end], BushingMatrices { stiffness, preload, .. }) = (step.shares(), &self.matrices);
        let value = Deformation::of(from).value * start + Deformation::of(to).value * end;
        let forces = stiffness * value + preload * step.middle.load;
        let [[before, ..], [now, ..]] = [from, to].map(|products| ratio(-products[COSINE]));
        let (changed, [_, slope, _]) = (to[COSINE] - from[COSINE], ratio(-0.5 * (from[COSINE] + to[COSINE])));
        let quotient = if changed.abs() > SMALL_CHANGE { (now - before) / changed } else { slope };
        let mut products = [0.0; MEASURES];
        for k in 0..6 {
            let own = own_product(k);
            let is_rotation = k >= 3;
            products[own] = forces[k] * if is_rotation { 0.5 * (before + now) } else { 1.0 };
            products[COSINE] +=
                if is_rotation { forces[k] * 0.5 * (from[own] + to[own]) * quotient } else { 0.0 };
        }
        products
    }

    /// Returns the potential and the elastic forces on the products.
    fn elastic(&self, products: &Products, load: f64) -> (f64, Products) {
        let deformation = Deformation::of(products);
        let BushingMatrices { stiffness, preload, .. } = &self.matrices;
        let (value, preload) = (deformation.value, preload * load);
        let elastic = stiffness * value;
        (value.dot(&(elastic * 0.5 + preload)), deformation.on_products(&(elastic + preload)))
    }
}
