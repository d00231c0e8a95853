use nalgebra::DVector;

use super::krylov::{EigenError, Operator, Random, Search, krylov};
use super::modes::modes;
use crate::system::{EquationsOfMotion, Factor, SparseMatrix, State, Weights};

/// A load factor at which a state buckles, and the motion in which it does.
#[derive(Clone, Debug, PartialEq)]
pub struct Critical {
    /// s: the loads at load factor one, s times, on top of those that the state bears already.
    pub factor: f64,
    /// x over the coordinates with xᵀ M x = 1.
    pub shape: Vec<f64>,
}

/// Which way the loads grow.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Sense {
    /// As they are: s > 0.
    #[default]
    Stated,
    /// Reversed: s < 0.
    Reversed,
    /// Either way: the smallest in size.
    Either,
}

/// Converged when residuals are below this.
const TOLERANCE: f64 = 1e-7;
/// Vectors of a block beyond the number of factors.
const GUARD: usize = 4;
/// Blocks of a space.
const DEPTH: usize = 16;
/// Spaces, each with better vectors.
const PASSES: usize = 8;
/// Eigenvalues 1/s smaller than this part of the largest are those of an unloaded rest.
const LOADED: f64 = 1e-6;
/// How much the stiffness changes over a step along the path.
const CHANGE: f64 = 1e-3;

/// The `count` lowest critical load factors of a stable equilibrium by linear buckling: K₀ x + Φ_qᵀ μ = −s K_g x, Φ_q x = 0.
///
/// K_g = dK/ds is the derivative of the stiffness along the path of equilibria, (q + s q₁, λ + s λ₁) with
/// [K₀, Φ_qᵀ; Φ_q, 0] (q₁, λ₁) = −∂r/∂(load factor). It holds all that depends on stress, displacement, multipliers and
/// load factor; directions that joints leave free stay those of the state. The reference configuration is an equilibrium
/// under load factor zero.
///
/// Straight on along that path, good are only the loads of bodies that do not turn before they buckle, such as columns.
/// Where a beam bends first, as in lateral buckling, sections that turn seem to stretch, and a stiffness linear in s
/// vanishes far too early. The remedy is a state nearer to the critical one: an equilibrium under most of the load, about
/// which the rest is small.
///
/// Fewer than `count` if loads in this sense have no more. `matrix` is any matrix of the pattern of `eom`.
///
/// Source: Brendel & Ramm (1980), the accompanying linear eigenproblem; the largest 1/s of −K₀⁻¹ K_g, self-adjoint in
/// the inner product of K₀, by block Krylov spaces.
///
/// # Errors
/// If K₀ is singular or not positive definite, or the iteration does not converge.
pub fn buckling(
    eom: &dyn EquationsOfMotion,
    matrix: SparseMatrix,
    s: &State,
    count: usize,
    sense: Sense,
) -> Result<Vec<Critical>, EigenError> {
    let lowest = modes(eom, matrix.clone(), s, 1)?.modes;
    match lowest.first().map(|mode| mode.squared) {
        None => return Ok(Vec::new()),
        Some(0.0) => return Err(EigenError::Singular),
        Some(squared) if squared < 0.0 => return Err(EigenError::Indefinite),
        Some(_) => {}
    }
    let (mut stiffness, n) = (matrix.clone(), eom.coordinates());
    eom.tangent(s, Weights::STIFFNESS, &mut stiffness);
    let mut factor = Factor::new(matrix.pattern())?;
    factor.factorise(&stiffness)?;
    let path = Path::new(eom, s, &stiffness, &mut factor)?;
    let Some(softening) = path.softening(matrix.clone()) else { return Ok(Vec::new()) };
    let inner = &stiffness;
    let mut op = Operator { factor: &mut factor, left: inner, right: &softening, inner, coordinates: n };
    let key: fn(f64) -> f64 = match sense {
        Sense::Stated => |theta| theta,
        Sense::Reversed => |theta| -theta,
        Sense::Either => f64::abs,
    };
    let search = Search { count, key, least: LOADED, tolerance: TOLERANCE, depth: DEPTH };
    let mut start = op.start(count + GUARD)?;
    let mut mass = matrix;
    eom.tangent(s, Weights::MASS, &mut mass);
    for _ in 0..PASSES {
        let found = krylov(&mut op, start, &search)?;
        if found.converged {
            // Once more through T: x then obeys the constraints as well as equations are solved.
            let shapes: Result<Vec<_>, _> =
                found.pairs[..found.wanted].iter().map(|pair| op.apply(&pair.vector)).collect();
            return Ok(shapes?.iter().map(|x| critical(x, &stiffness, &softening, &mass, n)).collect());
        }
        start = found.pairs.into_iter().map(|pair| pair.vector).collect();
    }
    Err(EigenError::NotConverged)
}

/// s = xᵀ K₀ x / −xᵀ K_g x, which the error of x enters by its square only, and x with xᵀ M x = 1.
fn critical(
    x: &DVector<f64>,
    stiffness: &SparseMatrix,
    softening: &SparseMatrix,
    mass: &SparseMatrix,
    n: usize,
) -> Critical {
    let product = |matrix: &SparseMatrix| x.dot(&DVector::from(matrix.times(x.as_slice())));
    let size = product(mass).max(0.0).sqrt();
    let shape = x.iter().take(n).map(|x| x / size).collect();
    Critical { factor: product(stiffness) / product(softening), shape }
}

/// The linear path of equilibria on which a state starts.
struct Path<'a> {
    eom: &'a dyn EquationsOfMotion,
    s: &'a State,
    stiffness: &'a SparseMatrix,
    /// (q₁, λ₁).
    direction: Vec<f64>,
    /// Whether the loads move anything.
    moves: bool,
}

impl<'a> Path<'a> {
    fn new(
        eom: &'a dyn EquationsOfMotion,
        s: &'a State,
        stiffness: &'a SparseMatrix,
        factor: &mut Factor,
    ) -> Result<Self, EigenError> {
        let n = eom.coordinates();
        let residual = |load| {
            let (mut moved, mut r) = (s.clone(), vec![0.0; n + eom.multipliers()]);
            moved.load = load;
            eom.residual(&moved, &mut r);
            r
        };
        // The residual is affine in the load factor.
        let (here, there) = (residual(s.load), residual(s.load + 1.0));
        let force: Vec<f64> = here.iter().zip(&there).map(|(here, there)| here - there).collect();
        let mut direction = force.clone();
        factor.solve(stiffness, &mut direction)?;
        let held = |i: usize| match stiffness.diagonal_of(i).abs() {
            0.0 => 0.0,
            stiffness => force[i].powi(2) / stiffness,
        };
        let work: f64 = (0..n).map(|i| force[i] * direction[i]).sum();
        let moves = work.abs() > 1e-12 * (0..n).map(held).sum::<f64>();
        Ok(Self { eom, s, stiffness, direction, moves })
    }

    /// −K_g by central differences of order four over a step that changes the stiffness by a thousandth.
    ///
    /// For stiffness quadratic in the coordinates, that of St. Venant-Kirchhoff elements, they are exact but for
    /// rounding; otherwise their error is of the order of 10⁻¹².
    fn softening(&self, mut matrix: SparseMatrix) -> Option<SparseMatrix> {
        let h = self.step()?;
        let mut negative = vec![0.0; matrix.values().len()];
        for (times, weight) in [(1.0, -8.0), (-1.0, 8.0), (2.0, 1.0), (-2.0, -1.0)] {
            self.stiffness_at(times * h, &mut matrix);
            for (sum, value) in negative.iter_mut().zip(matrix.values()) {
                *sum += weight / (12.0 * h) * value;
            }
        }
        matrix.values_mut().copy_from_slice(&negative);
        Some(matrix)
    }

    fn stiffness_at(&self, h: f64, matrix: &mut SparseMatrix) {
        let (mut moved, z) = (self.s.clone(), self.direction.iter().map(|z| h * z).collect::<Vec<_>>());
        moved.add(&z, Weights::STIFFNESS);
        moved.load += h;
        self.eom.tangent(&moved, Weights::STIFFNESS, matrix);
    }

    /// The step over which the stiffness changes by about [`CHANGE`]; `None` if the loads change nothing.
    ///
    /// The change is that of D K D ξ with D one over the root of K's diagonal and ξ random: free of units.
    fn step(&self) -> Option<f64> {
        let (mut random, n) = (Random(2), self.eom.coordinates());
        let scale = |i| match self.stiffness.diagonal_of(i).abs() {
            0.0 => 0.0,
            diagonal => 1.0 / diagonal.sqrt(),
        };
        let scale: Vec<f64> = (0..n).map(scale).collect();
        let mut x = vec![0.0; self.direction.len()];
        x.iter_mut().zip(&scale).for_each(|(x, scale)| *x = random.number() * scale);
        let image = |k: &SparseMatrix| -> DVector<f64> {
            DVector::from_iterator(n, k.times(&x).iter().zip(&scale).map(|(y, scale)| y * scale))
        };
        let (here, mut matrix, mut h) = (image(self.stiffness), self.stiffness.clone(), 1.0);
        for _ in 0..if self.moves { 100 } else { 0 } {
            self.stiffness_at(h, &mut matrix);
            let change = (image(&matrix) - &here).norm() / (CHANGE * here.norm());
            if (0.2..5.0).contains(&change) {
                return Some(h);
            }
            h *= if change.is_finite() { (1.0 / change).clamp(1e-4, 1e4) } else { 1e-4 };
        }
        None
    }
}
