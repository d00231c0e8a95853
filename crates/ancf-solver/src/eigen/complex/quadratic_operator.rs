use nalgebra::DVector;

use super::arnoldi::ArnoldiOperator;
use super::rigid_motions::RigidMotions;
use crate::eigen::full_rows::FullRows;
use crate::eigen::modes::Mode;
use crate::eigen::operator::EigenError;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{GeneralLu, add_skew_product};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Entries (i, j, value), i > j, of a skew matrix.
type SkewEntries = Vec<(usize, usize, f64)>;

/// Operator T = (A − σ)⁻¹ of the linear form of (λ²M + λC + K) x + Φ_qᵀ μ = 0, Φ_q x = 0.
///
/// Its vectors are z = (x, w) with λ x = σ w. C and K have symmetric and skew parts. T z = (x′, w′) solves
///
/// P x′ = −σ M w − (C + σM) x,  w′ = x′ + x/σ,  P = σ²M + σC + K,
///
/// with the constraints. One step of iterative refinement has the products K x′ term by term, so that the stiffness of single
/// elements leaves no rounding error in the modes of the structure. The inner product is xᵀ M y + wᵀ M u. Vectors are orthogonal to
/// the [rigid motions](RigidMotions) without damping, whose λ is zero.
///
/// Source: Tisseur & Meerbergen (2001), section 5.
pub(super) struct QuadraticOperator<'a> {
    eom: &'a dyn EquationsOfMotion,
    s: &'a State,
    shift: f64,
    mass: FullRows,
    damping: FullRows,
    skew_damping: SkewEntries,
    skew_stiffness: SkewEntries,
    constraints: Vec<(usize, usize, f64)>,
    lu: GeneralLu,
    rigid: RigidMotions,
    interrupt: &'a Interrupt,
}

impl<'a> QuadraticOperator<'a> {
    pub(super) fn new(
        eom: &'a dyn EquationsOfMotion,
        mut matrix: SparseMatrix,
        s: &'a State,
        (shift, undamped): (f64, &[Mode]),
        interrupt: &'a Interrupt,
    ) -> Result<Self, EigenError> {
        let mut of = |q: f64, v: f64, a: f64| {
            eom.tangent(s, Weights { q, v, a }, &mut matrix);
            FullRows::new(&matrix)
        };
        let (mass, damping) = (of(0.0, 0.0, 1.0), of(0.0, 1.0, 0.0));
        let (skew_damping, skew_stiffness) = (eom.skew_damping(s), eom.skew_stiffness(s));
        eom.tangent(s, Weights { q: 1.0, v: shift, a: shift * shift }, &mut matrix);
        let of_damping = skew_damping.iter().map(|&(i, j, value)| (i, j, shift * value));
        let skew: SkewEntries = of_damping.chain(skew_stiffness.iter().copied()).collect();
        let lu = GeneralLu::new(&matrix, &skew, eom.coordinates()).ok_or(EigenError::Singular)?;
        let constraints = matrix.constraints().collect();
        let rigid =
            if skew.is_empty() { RigidMotions::new(undamped, &mass, &damping) } else { RigidMotions::NONE };
        Ok(Self {
            eom,
            s,
            shift,
            mass,
            damping,
            skew_damping,
            skew_stiffness,
            constraints,
            lu,
            rigid,
            interrupt,
        })
    }

    /// True without gyroscopic forces and loads without a potential.
    pub(super) fn is_symmetric(&self) -> bool {
        self.skew_damping.is_empty() && self.skew_stiffness.is_empty()
    }

    /// Returns the rigid-body motions.
    pub(super) fn rigid(&self) -> &RigidMotions {
        &self.rigid
    }

    pub(super) fn coordinates(&self) -> usize {
        self.eom.coordinates()
    }

    /// Returns the halves x and w, with zeros instead of multipliers.
    fn halves(&self, z: &DVector<f64>) -> [DVector<f64>; 2] {
        let (n, size) = (self.coordinates(), self.mass.diagonal().len());
        [0, n].map(|start| {
            let mut half = DVector::zeros(size);
            half.rows_mut(0, n).copy_from(&z.rows(start, n));
            half
        })
    }

    fn joined(&self, [x, w]: [&DVector<f64>; 2]) -> DVector<f64> {
        let n = self.coordinates();
        DVector::from_iterator(2 * n, x.iter().take(n).chain(w.iter().take(n)).copied())
    }

    fn mass_times(&self, x: &DVector<f64>) -> DVector<f64> {
        self.of_coordinates(self.mass.times(x.as_slice()))
    }

    /// Computes C x.
    pub(super) fn damping_times(&self, x: &DVector<f64>) -> DVector<f64> {
        let mut product = self.of_coordinates(self.damping.times(x.as_slice()));
        add_skew_product(&self.skew_damping, x.as_slice(), product.as_mut_slice());
        product
    }

    fn of_coordinates(&self, product: Vec<f64>) -> DVector<f64> {
        let mut product = DVector::from_vec(product);
        product.as_mut_slice()[self.coordinates()..].fill(0.0);
        product
    }

    /// Computes P x, and Φ_q x in the rows of the multipliers.
    fn left_times(&self, x: &DVector<f64>) -> DVector<f64> {
        let mut strained = x.clone();
        self.rigid.remove_from(&mut strained);
        let mut columns = self.eom.stiffness_products(self.s, std::slice::from_ref(&strained)).products;
        let mut product = columns.swap_remove(0);
        self.rigid.remove_from_force(&mut product);
        add_skew_product(&self.skew_stiffness, x.as_slice(), product.as_mut_slice());
        product += self.damping_times(x) * self.shift + self.mass_times(x) * self.shift.powi(2);
        self.constraints.iter().for_each(|&(row, c, value)| product[row] += value * x[c]);
        product
    }

    /// Solves P x + Φ_qᵀ μ = f, Φ_q x = 0.
    fn solve(&self, force: &DVector<f64>) -> Result<DVector<f64>, EigenError> {
        if self.interrupt.is_set() {
            return Err(EigenError::Interrupted);
        }
        let n = self.coordinates();
        let mut whole = force.clone();
        self.lu.solve(whole.as_mut_slice());
        let mut x = whole.clone();
        x.as_mut_slice()[n..].fill(0.0);
        let mut rest = force - self.left_times(&x);
        self.constraints.iter().for_each(|&(row, c, value)| rest[c] -= value * whole[row]);
        self.lu.solve(rest.as_mut_slice());
        x.rows_mut(0, n).zip_apply(&rest.rows(0, n), |x, change| *x += change);
        self.rigid.remove_free(&mut x);
        if x.iter().all(|x| x.is_finite()) { Ok(x) } else { Err(EigenError::Singular) }
    }

    /// Returns a vector (x, x) of a shape without rigid motions; `None` for a rigid motion.
    pub(super) fn double(&self, shape: &[f64]) -> Option<DVector<f64>> {
        let mut x = DVector::zeros(self.mass.diagonal().len());
        x.rows_mut(0, shape.len()).copy_from_slice(shape);
        let before = self.mass.square(x.as_slice());
        self.rigid.remove_free(&mut x);
        (self.mass.square(x.as_slice()) > 0.25 * before).then(|| self.joined([&x, &x]))
    }

    /// Returns P⁻¹ applied to a force, for x and w.
    pub(super) fn start(&self, mut number: impl FnMut() -> f64) -> Result<DVector<f64>, EigenError> {
        let n = self.coordinates();
        let root: Vec<f64> = self.mass.diagonal().iter().map(|entry| entry.abs().sqrt()).collect();
        let mut force = || DVector::from_fn(root.len(), |i, _| if i < n { root[i] * number() } else { 0.0 });
        let [x, w] = [self.solve(&force())?, self.solve(&force())?];
        Ok(self.joined([&x, &w]))
    }

    /// Computes √(xᵀ M x) of a shape.
    pub(super) fn size(&self, x: &DVector<f64>) -> f64 {
        let mut whole = vec![0.0; self.mass.diagonal().len()];
        whole[..x.len()].copy_from_slice(x.as_slice());
        self.mass.square(&whole).max(0.0).sqrt()
    }
}

impl ArnoldiOperator for QuadraticOperator<'_> {
    fn apply(&mut self, z: &DVector<f64>) -> Result<DVector<f64>, EigenError> {
        let [x, w] = self.halves(z);
        let force = -(self.mass_times(&(&w + &x)) * self.shift + self.damping_times(&x));
        let image = self.solve(&force)?;
        let speed = &image + x / self.shift;
        Ok(self.joined([&image, &speed]))
    }

    fn inner_image(&self, z: &DVector<f64>) -> DVector<f64> {
        let [x, w] = self.halves(z).map(|half| self.mass_times(&half));
        self.joined([&x, &w])
    }
}
