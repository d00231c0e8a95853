use nalgebra::{DMatrix, DVector};

use super::columns::Columns;
use super::full_rows::FullRows;
use super::krylov::{EigenSearch, KrylovSpace};
use super::modes::{SturmCount, modes};
use super::operator::{EigenError, Operator};
use super::refinement::{ACCURATE, CORRECTIONS, PROGRESS, combined, independent, projected};
use super::softening::softening;
use crate::equations::{EquationsOfMotion, State, Weights};
use crate::factor::{Factor, SingularMatrix, is_zero_on_motions};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;

/// Critical load factor with its buckling shape.
#[derive(Clone, Debug, PartialEq)]
pub struct CriticalLoad {
    /// Critical factor s of the loads at load factor one, in addition to the loads already applied in the state.
    pub factor: f64,
    /// Buckling shape x over the coordinates with xᵀ M x = 1.
    pub shape: Vec<f64>,
    /// Residual |K₀⁻¹ (K₀ x + s K_g x)| / |x| in the norm of K₀, in which K₀⁻¹ K_g is self-adjoint. It bounds the distance to
    /// the next 1/s, relative to 1/s.
    pub residual: f64,
}

/// Lowest critical loads of a state.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CriticalLoads {
    /// Critical loads by increasing magnitude.
    pub loads: Vec<CriticalLoad>,
    /// Verified number of critical loads, `None` if K₀ + s K_g has no symmetric factorisation or the loads have both
    /// directions.
    pub sturm: Option<SturmCount>,
    /// Coordinates and multipliers of first order that the loads cause at load factor one. Empty without loads.
    pub response: Vec<f64>,
}

/// Direction of the loads.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum LoadDirection {
    /// Stated direction: s > 0.
    #[default]
    Stated,
    /// Reversed direction: s < 0.
    Reversed,
    /// Both directions, by increasing magnitude.
    Either,
}

/// Residual tolerance of converged eigenpairs.
const TOLERANCE: f64 = 1e-7;
/// Number of block vectors in addition to the requested factors.
const GUARD: usize = 4;
/// Number of blocks per Krylov space.
const DEPTH: usize = 16;
/// Maximum number of restarts.
const PASSES: usize = 8;
/// Smallest significant eigenvalue 1/s, relative to the largest. Smaller ones belong to unloaded parts.
const MIN_EIGENVALUE: f64 = 1e-9;
/// Smallest significant share of the stiffness that the loads remove at load factor one. Smaller ones are rounding errors.
const MIN_SOFTENING: f64 = 1e-13;
/// Relative change of an image in a further step of refinement above which it is a rounding error.
const NOISE: f64 = 0.02;
/// Smallest gap between factors at which they are counted, relative to the larger factor.
const MIN_GAP: f64 = 1e-3;
/// Softening per load below which a shape with a large residual consists of rounding errors.
const MIN_CERTAIN_SOFTENING: f64 = 1e-9;
/// Residual of such a shape.
const ROUGH: f64 = 1e-3;
/// Distance of the shift of inverse iterations from the factor, relative to the factor.
const SHIFT: f64 = 1e-6;
/// Relative difference of factors of equal magnitude.
const EQUAL: f64 = 1e-8;

/// Computes the `count` lowest critical load factors of a stable equilibrium by linear buckling analysis:
/// K₀ x + Φ_qᵀ μ = −s K_g x, Φ_q x = 0.
///
/// K_g is the stiffness of the stresses and multipliers that the loads at load factor one cause in first order,
/// [K₀, Φ_qᵀ; Φ_q, 0] (q₁, λ₁) = −∂r/∂(load factor), at the configuration of the state
/// ([`EquationsOfMotion::stress_stiffness`]).
///
/// The reference configuration is an equilibrium at load factor zero. There the analysis is the classical theory, which
/// neglects prebuckling deformation. It gives Euler's load of a column except for P/EA, and the loads of Prandtl and
/// Michell for lateral buckling of a strip. In-plane bending before buckling raises the load of such a strip by about
/// 1/√((1 − EI₂/EI₁)(1 − GJ/EI₁)) if both ratios are small.
///
/// For an equilibrium under load, K₀ includes the displacement so far. The remaining factor is zero where the nonlinear
/// path is critical. [`ArcLength`](crate::statics::ArcLength) finds that point by the negative pivots of K.
///
/// Returns fewer than `count` factors if the loads have no more in this direction. `matrix` is any matrix of the
/// pattern of `eom`. The number of factors below the last gap is compared with the number of negative eigenvalues of
/// K₀ + s K_g.
///
/// Source: Bathe (2014), section 6.8.2, with stresses of first order only; Timoshenko & Gere (1961), chapters 2, 6;
/// Trahair & Woolcock (1973). The largest 1/s of −K₀⁻¹ K_g, self-adjoint in the inner product of K₀, are found by the
/// block Lanczos method.
///
/// # Errors
/// If K₀ is singular or not positive definite, the loads have no potential, the iteration does not converge, or it is
/// interrupted.
pub fn buckling(
    eom: &dyn EquationsOfMotion,
    matrix: SparseMatrix,
    s: &State,
    count: usize,
    sense: LoadDirection,
    interrupt: &Interrupt,
) -> Result<CriticalLoads, EigenError> {
    let lowest = modes(eom, matrix.clone(), s, 1, interrupt)?.modes;
    match lowest.first().map(|mode| mode.omega_squared) {
        None => return Ok(CriticalLoads::default()),
        Some(0.0) => return Err(EigenError::Singular),
        Some(squared) if squared < 0.0 => return Err(EigenError::Indefinite),
        Some(_) => {}
    }
    let mut stiffness = matrix.clone();
    eom.tangent(s, Weights::STIFFNESS, &mut stiffness);
    let mut factor = Factor::new(matrix.pattern())?;
    factor.factorise(&stiffness)?;
    let skew = eom.skew_stiffness(&State { load: 1.0, ..s.clone() });
    if !is_zero_on_motions(&skew, eom.coordinates(), &stiffness, &mut factor)? {
        return Err(EigenError::Nonconservative);
    }
    let (softening, response) = softening(eom, s, &stiffness, &mut factor)?;
    if softening.values().iter().all(|value| *value == 0.0) {
        return Ok(CriticalLoads { response, ..CriticalLoads::default() });
    }
    let mut mass = matrix;
    eom.tangent(s, Weights::MASS, &mut mass);
    let (rows, scales) = ([&softening, &stiffness].map(FullRows::new), vec![1.0; mass.pattern().size()]);
    let mut pencil = BucklingPencil { eom, s, stiffness, softening, rows, scales, mass, factor, interrupt };
    // The last factor may have a neighbour of the same magnitude and the other sign.
    let requested = count + usize::from(sense == LoadDirection::Either);
    let mut start = pencil.operator().start(requested + GUARD, 0)?;
    let (degrees, mut failure) = (eom.degrees_of_freedom(s), EigenError::NotConverged);
    for pass in 0..PASSES {
        let (op, size) = (&mut pencil.operator(), start.count());
        let mut space = KrylovSpace::new(op, start, degrees)?;
        let found = space.extend(op, &sense.search(requested), [0, DEPTH])?;
        let vectors = space.vectors(&found, size);
        if found.largest <= MIN_SOFTENING || !pencil.is_determined(&vectors[..found.requested])? {
            return Ok(CriticalLoads { response, ..CriticalLoads::default() });
        }
        start = Columns::of(pencil.stiffness.pattern().size(), &vectors);
        if found.converged {
            // A final application of T makes x satisfy the constraints to the accuracy of the linear solver.
            let shapes: Result<Vec<_>, _> =
                vectors.iter().map(|x| pencil.operator().apply(x.as_slice())).collect();
            let mut loads = pencil.refined(shapes?, found.requested, sense)?;
            loads.retain(|load| {
                load.residual <= ROUGH || found.largest.min(load.factor.recip().abs()) > MIN_CERTAIN_SOFTENING
            });
            if let Some(mut found) = pencil.counted(loads, sense)? {
                found.loads.truncate(count);
                found.response = response;
                return Ok(found);
            }
            failure = EigenError::Missed;
            let further = pencil.restored()?.start(GUARD, 1 + pass as u64)?;
            further.vectors().iter().for_each(|x| start.push(x.as_slice()));
        }
    }
    Err(failure)
}

impl LoadDirection {
    /// Selection of the eigenvalues 1/s.
    fn search(self, count: usize) -> EigenSearch {
        let key: fn(f64) -> f64 = match self {
            Self::Stated => |theta| theta,
            Self::Reversed => |theta| -theta,
            Self::Either => f64::abs,
        };
        EigenSearch { count, key, least: MIN_EIGENVALUE, tolerance: TOLERANCE, capacity: usize::MAX }
    }
}

/// Critical loads and the matrix of all xᵀ K₀ x.
type Measured = (Vec<CriticalLoad>, DMatrix<f64>);

/// Matrices K₀, −K_g and M of a state, and the factors of K₀.
struct BucklingPencil<'a> {
    eom: &'a dyn EquationsOfMotion,
    s: &'a State,
    stiffness: SparseMatrix,
    softening: SparseMatrix,
    /// −K_g and K₀ by rows.
    rows: [FullRows; 2],
    scales: Vec<f64>,
    mass: SparseMatrix,
    factor: Factor,
    interrupt: &'a Interrupt,
}

impl BucklingPencil<'_> {
    /// Operator T = −K₀⁻¹ K_g.
    fn operator(&mut self) -> Operator<'_> {
        let Self { eom, stiffness, rows: [softening, inner], scales, factor, interrupt, .. } = self;
        let coordinates = eom.coordinates();
        Operator { factor, left: stiffness, scales, right: softening, inner, coordinates, interrupt }
    }

    /// Factorises K₀ again.
    fn restored(&mut self) -> Result<Operator<'_>, EigenError> {
        self.factor.factorise(&self.stiffness)?;
        Ok(self.operator())
    }

    /// Refines shapes by inverse iteration and the Rayleigh-Ritz method, until the residuals of the first `count` are small or no
    /// longer decrease. Products with K₀ are summed term by term, as for modes.
    fn refined(
        &mut self,
        shapes: Vec<DVector<f64>>,
        count: usize,
        sense: LoadDirection,
    ) -> Result<Vec<CriticalLoad>, EigenError> {
        let shapes = independent(shapes, count, |x| DVector::from(self.mass.times(x.as_slice())));
        let (shapes, count) = self.softened(shapes, count);
        let worst =
            |loads: &[CriticalLoad]| loads.iter().take(count).map(|load| load.residual).fold(0.0, f64::max);
        let (mut loads, _) = self.measured(shapes)?;
        for _ in 0..CORRECTIONS {
            let before = worst(&loads);
            if before <= ACCURATE {
                break;
            }
            let mut shapes = Vec::new();
            for (k, load) in loads.iter().enumerate() {
                let is_accurate = k >= count || load.residual <= ACCURATE;
                let next = if is_accurate { None } else { self.inverse_iterate(load).ok() };
                shapes.push(next.unwrap_or_else(|| self.extended(load)));
            }
            self.factor.factorise(&self.stiffness)?;
            let (rough, of_rough) = self.measured(shapes)?;
            let Some(shapes) = self.ritz(&rough, &of_rough, sense) else { break };
            let (next, _) = self.measured(shapes)?;
            let after = worst(&next);
            if after < before {
                loads = next;
            }
            if after > PROGRESS * before {
                break;
            }
        }
        put_positive_first(&mut loads);
        loads.truncate(count);
        Ok(loads)
    }

    /// Computes (K₀ + s K_g)⁻¹ K_g x for a shift s next to the factor. Factorises another matrix than K₀.
    ///
    /// Corrections by K₀⁻¹ K_g would multiply an error along the shape of a factor r by s/r. Shapes of large factors lose their
    /// accuracy by those of smaller factors, which may be of the other sign and not among the shapes.
    fn inverse_iterate(&mut self, load: &CriticalLoad) -> Result<DVector<f64>, SingularMatrix> {
        let mut x = DVector::from(self.softening.times(self.extended(load).as_slice()));
        let n = self.eom.coordinates();
        x.as_mut_slice()[n..].fill(0.0);
        let loaded = self.factorise_loaded(load.factor * (1.0 + SHIFT))?;
        self.factor.solve(&loaded, x.as_mut_slice())?;
        x.as_mut_slice()[n..].fill(0.0);
        Ok(x)
    }

    /// Factorises K₀ + s K_g.
    fn factorise_loaded(&mut self, factor: f64) -> Result<SparseMatrix, SingularMatrix> {
        let mut loaded = self.stiffness.clone();
        let softening = self.softening.values();
        loaded.values_mut().iter_mut().zip(softening).for_each(|(value, k)| *value -= factor * k);
        self.factor.factorise(&loaded)?;
        Ok(loaded)
    }

    /// Returns true if −K₀⁻¹ K_g x is more than a rounding error for one of the requested shapes x. Where joints carry the loads, K_g x
    /// consists of reactions, and the solution of their rounding errors.
    fn is_determined(&mut self, shapes: &[DVector<f64>]) -> Result<bool, EigenError> {
        let n = self.eom.coordinates();
        for x in shapes {
            let mut force = self.softening.times(x.as_slice());
            force[n..].fill(0.0);
            let mut image = force.clone();
            if force.iter().all(|x| *x == 0.0) {
                continue;
            }
            self.factor.solve(&self.stiffness, &mut image)?;
            let refined = self.factor.refined(&self.stiffness, &force, &image)?;
            let mut change: Vec<f64> = image.iter().zip(refined).map(|(a, b)| a - b).collect();
            let square = |x: &mut [f64]| {
                x[n..].fill(0.0);
                let product = self.mass.times(x);
                x.iter().zip(product).map(|(x, product)| x * product).sum::<f64>()
            };
            if square(&mut change) <= NOISE * NOISE * square(&mut image) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    /// Removes shapes that the loads do not soften beyond rounding errors, and after the first `count` those that they hardly
    /// soften. Returns the number of the first ones that remain.
    fn softened(&self, shapes: Vec<DVector<f64>>, count: usize) -> (Vec<DVector<f64>>, usize) {
        let share = |x: &DVector<f64>| {
            let [softening, stiffness] = [&self.softening, &self.stiffness]
                .map(|matrix| x.dot(&DVector::from(matrix.times(x.as_slice()))).abs());
            softening / stiffness
        };
        let shares: Vec<f64> = shapes.iter().map(share).collect();
        let largest = shares.iter().copied().fold(0.0, f64::max);
        let is_kept = |k: usize| {
            let least = if k < count { 0.0 } else { MIN_EIGENVALUE * largest };
            shares[k] > least.max(MIN_SOFTENING)
        };
        let first = (0..count.min(shares.len())).filter(|k| is_kept(*k)).count();
        (shapes.into_iter().enumerate().filter(|(k, _)| is_kept(*k)).map(|(_, x)| x).collect(), first)
    }

    /// Shape of a load as a vector over all unknowns.
    fn extended(&self, load: &CriticalLoad) -> DVector<f64> {
        let mut x = DVector::zeros(self.stiffness.pattern().size());
        x.as_mut_slice()[..load.shape.len()].copy_from_slice(&load.shape);
        x
    }

    /// Computes s = xᵀ K₀ x / −xᵀ K_g x, with an error quadratic in that of x, for x with xᵀ M x = 1, and the matrix of all xᵀ K₀ x.
    fn measured(&mut self, shapes: Vec<DVector<f64>>) -> Result<Measured, EigenError> {
        let size = |matrix: &SparseMatrix, x: &DVector<f64>| {
            x.dot(&DVector::from(matrix.times(x.as_slice()))).max(0.0).sqrt()
        };
        let shapes: Vec<_> = shapes.into_iter().map(|x| &x / size(&self.mass, &x)).collect();
        let of_terms = self.eom.stiffness_products(self.s, &shapes);
        let mut loads = Vec::new();
        for (k, (x, product)) in shapes.iter().zip(&of_terms.products).enumerate() {
            let softened = DVector::from(self.softening.times(x.as_slice()));
            let factor = of_terms.squares[k] / x.dot(&softened);
            let correction = self.operator().solve(product - softened * factor)?;
            let residual = size(&self.stiffness, &correction) / of_terms.squares[k].sqrt();
            let shape = x.as_slice()[..self.eom.coordinates()].to_vec();
            loads.push(CriticalLoad { factor, shape, residual });
        }
        let rows = self.stiffness.pattern().size();
        let [shapes, products] = [shapes, of_terms.products].map(|x| Columns::of(rows, &x));
        Ok((loads, shapes.products(&products)))
    }

    /// Returns the Ritz vectors of the span of the shapes, by descending keys of 1/s.
    fn ritz(
        &self,
        loads: &[CriticalLoad],
        forms: &DMatrix<f64>,
        sense: LoadDirection,
    ) -> Option<Vec<DVector<f64>>> {
        let shapes: Vec<_> = loads.iter().map(|load| self.extended(load)).collect();
        let images: Vec<_> =
            shapes.iter().map(|x| DVector::from(self.softening.times(x.as_slice()))).collect();
        let count = shapes.len();
        let softened = DMatrix::from_fn(count, count, |i, j| {
            0.5 * (shapes[i].dot(&images[j]) + shapes[j].dot(&images[i]))
        });
        let (values, weights) = projected(&softened, &(0.5 * (forms + forms.transpose())))?;
        let key = sense.search(count).key;
        let mut order: Vec<usize> = (0..count).collect();
        order.sort_by(|&a, &b| key(values[b]).total_cmp(&key(values[a])));
        Some(order.iter().map(|&k| combined(&shapes, weights.column(k).as_slice())).collect())
    }

    /// Verifies the number of factors below the last gap. Returns `None` if it differs from the number of loads there.
    fn counted(
        &mut self,
        loads: Vec<CriticalLoad>,
        sense: LoadDirection,
    ) -> Result<Option<CriticalLoads>, EigenError> {
        let factors: Vec<f64> = loads.iter().map(|load| load.factor).collect();
        let has_gap = |k: &usize| (factors[*k] - factors[*k - 1]).abs() > MIN_GAP * factors[*k].abs();
        let gap = (1..factors.len()).rev().find(has_gap).filter(|_| sense != LoadDirection::Either);
        let Some(gap) = gap else { return Ok(Some(CriticalLoads { loads, ..CriticalLoads::default() })) };
        let below = 0.5 * (factors[gap - 1] + factors[gap]);
        self.factorise_loaded(below)?;
        let negative = self.factor.negative_pivots();
        let count = negative.map(|negative| negative.saturating_sub(self.eom.multipliers()));
        let sturm = count.map(|count| SturmCount { below, count });
        Ok(count.is_none_or(|count| count == gap).then_some(CriticalLoads {
            loads,
            sturm,
            response: Vec::new(),
        }))
    }
}

/// Exchanges neighbours of equal magnitude such that the positive factor is first: rounding errors determine their order.
fn put_positive_first(loads: &mut [CriticalLoad]) {
    for k in 1..loads.len() {
        let [before, after] = [loads[k - 1].factor, loads[k].factor];
        if before < 0.0 && after > 0.0 && (before + after).abs() <= EQUAL * after {
            loads.swap(k - 1, k);
        }
    }
}
