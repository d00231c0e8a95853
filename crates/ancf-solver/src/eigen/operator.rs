use nalgebra::DVector;
use thiserror::Error;

use super::columns::Columns;
use super::full_rows::FullRows;
use crate::factor::{Factor, SingularMatrix};
use crate::newton::Interrupt;
use crate::sparse::SparseMatrix;
use crate::vectors::PseudoRandom;

/// Cause of failure of an eigenvalue analysis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
pub enum EigenError {
    /// The matrix to be inverted has no usable factorisation.
    #[error("the matrix is singular: a joint is redundant, or a motion is unconstrained")]
    Singular,
    /// The inner product is not positive definite: missing stiffness or negative mass.
    #[error("the matrix of the inner product is not positive definite: the state is unstable")]
    Indefinite,
    /// The loads have no potential, so critical loads of equilibria do not determine stability.
    #[error("the loads have no potential: their stiffness is not symmetric, and the structure may flutter")]
    Nonconservative,
    /// Gyroscopic forces couple displacements and velocities, so modes without damping do not exist.
    #[error("the motion has gyroscopic forces, which couple the undamped modes")]
    Gyroscopic,
    /// The derivative of the forces by the velocities is not known exactly.
    #[error(
        "a force is not differentiable in this state, or its derivative by the velocities is not known exactly"
    )]
    NotDifferentiable,
    /// The limit of restarts was reached.
    #[error("the eigenvalues did not converge")]
    NotConverged,
    /// An eigenvalue is of the order of its rounding error.
    #[error("an eigenvalue is not known beyond its rounding error: a motion has hardly any stiffness")]
    Unresolved,
    /// The inertia of the shifted matrix contradicts the computed eigenvalues.
    #[error(
        "the number of computed eigenvalues differs from their number by the inertia of the shifted matrix"
    )]
    Missed,
    /// The interrupt flag was set.
    #[error("the eigenvalue search was interrupted")]
    Interrupted,
}

impl From<SingularMatrix> for EigenError {
    fn from(_: SingularMatrix) -> Self {
        Self::Singular
    }
}

/// Operator T = S⁻¹ A on the x with Φ_q x = 0, self-adjoint in the inner product xᵀ B y.
///
/// S is bordered, [S, Φ_qᵀ; Φ_q, 0], and all vectors have zeros instead of multipliers. The borders of A and B
/// therefore have no effect.
#[derive(Debug)]
pub(super) struct Operator<'a> {
    /// Factors of S.
    pub(super) factor: &'a mut Factor,
    /// Matrix D S D, bordered by Φ_q D.
    pub(super) left: &'a SparseMatrix,
    /// Diagonal of D, with ones for the multipliers.
    pub(super) scales: &'a [f64],
    /// Matrix A.
    pub(super) right: &'a FullRows,
    /// Matrix B of the inner product.
    pub(super) inner: &'a FullRows,
    /// Number of coordinates.
    pub(super) coordinates: usize,
    /// Interrupt flag that stops the search.
    pub(super) interrupt: &'a Interrupt,
}

/// Largest number of corrections of the constraints of a solution.
const CLOSINGS: usize = 6;

impl Operator<'_> {
    /// Computes T x.
    pub(super) fn apply(&mut self, x: &[f64]) -> Result<DVector<f64>, EigenError> {
        self.solve(self.right.times(x).into())
    }

    /// Computes T x and, at the places of the multipliers, the reactions λ in S T x + Φ_qᵀ λ = A x.
    pub(super) fn apply_with_reactions(
        &mut self,
        x: &[f64],
    ) -> Result<(DVector<f64>, DVector<f64>), EigenError> {
        let mut image = DVector::from(self.right.times(x));
        image.as_mut_slice()[self.coordinates..].fill(0.0);
        self.solve_whole(&mut image)?;
        let mut reactions = image.clone();
        reactions.as_mut_slice()[..self.coordinates].fill(0.0);
        image.as_mut_slice()[self.coordinates..].fill(0.0);
        Ok((image, reactions))
    }

    /// Computes S⁻¹ f.
    pub(super) fn solve(&mut self, mut f: DVector<f64>) -> Result<DVector<f64>, EigenError> {
        let n = self.coordinates;
        f.as_mut_slice()[n..].fill(0.0);
        self.solve_whole(&mut f)?;
        f.as_mut_slice()[n..].fill(0.0);
        Ok(f)
    }

    /// Computes the z with Φ_q z = Φ_q x and S z = r up to reactions. The vector x − z satisfies the constraints.
    ///
    /// The solution has the force r less the reactions, whose rounding error may exceed z. Reactions that are not known are those of
    /// a first solution.
    pub(super) fn correction(
        &mut self,
        x: &DVector<f64>,
        mut r: DVector<f64>,
        reactions: Option<&DVector<f64>>,
    ) -> Result<DVector<f64>, EigenError> {
        let (n, size) = (self.coordinates, r.len());
        if n == size {
            return self.solve(r);
        }
        r.rows_mut(n, size - n).fill(0.0);
        self.left
            .constraints()
            .for_each(|(multiplier, c, entry)| r[multiplier] += entry / self.scales[c] * x[c]);
        let mut first = None;
        if reactions.is_none() {
            let mut whole = r.clone();
            self.solve_whole(&mut whole)?;
            first = Some(whole);
        }
        if let Some(reactions) = reactions.or(first.as_ref()) {
            self.left
                .constraints()
                .for_each(|(multiplier, c, entry)| r[c] -= entry / self.scales[c] * reactions[multiplier]);
        }
        self.solve_whole(&mut r)?;
        r.rows_mut(n, size - n).fill(0.0);
        Ok(r)
    }

    /// Solves with all equations. The relative error of a solution is undefined for zero.
    ///
    /// The first solution of the factors is checked. Errors of the next ones appear in the residuals of the eigenvectors.
    pub(super) fn solve_whole(&mut self, f: &mut DVector<f64>) -> Result<(), EigenError> {
        if self.interrupt.is_set() {
            return Err(EigenError::Interrupted);
        }
        if f.iter().any(|&x| x != 0.0) {
            let demanded: Vec<f64> =
                f.rows(self.coordinates, f.len() - self.coordinates).iter().copied().collect();
            f.iter_mut().zip(self.scales).for_each(|(f, scale)| *f *= scale);
            self.factor.solve_increment(self.left, f.as_mut_slice(), &[])?;
            self.close_constraints(f, &demanded)?;
            f.iter_mut().zip(self.scales).for_each(|(x, scale)| *x *= scale);
        }
        Ok(())
    }

    /// Corrects a scaled solution by the rounding errors of its constraints.
    ///
    /// The pivot of a point mass or a rigid body without stiffness is −σm, close to zero. Its position is then a difference of forces
    /// divided by this pivot, which leaves the constraints open by more than their own rounding error. A correction has the same relative
    /// error, so that corrections are repeated while they decrease. Constraints of one coordinate have no rounding error of their own:
    /// the square of the unit roundoff, relative to the solution, counts as closed.
    fn close_constraints(&mut self, x: &mut DVector<f64>, demanded: &[f64]) -> Result<(), EigenError> {
        let (n, mut last) = (self.coordinates, f64::INFINITY);
        let mut rows = DVector::<f64>::zeros(x.len() - n);
        self.left.constraints().for_each(|(multiplier, _, entry)| rows[multiplier - n] += entry.abs());
        let closed = f64::EPSILON.powi(2) * rows.norm();
        for _ in 0..CLOSINGS {
            let mut open = DVector::zeros(x.len());
            open.as_mut_slice()[n..].copy_from_slice(demanded);
            self.left.constraints().for_each(|(multiplier, c, entry)| open[multiplier] -= entry * x[c]);
            let size = open.norm();
            // Rounding errors of the constraints themselves remain.
            if size <= closed * x.rows(0, n).amax() || size > 0.5 * last {
                break;
            }
            last = size;
            self.factor.solve_increment(self.left, open.as_mut_slice(), &[])?;
            *x += open;
        }
        Ok(())
    }

    /// Applies S⁻¹ to `count` pseudo-random forces, the same in every run and different for each `variant`.
    ///
    /// The forces are scaled by the root of the diagonal of B, which makes them independent of units.
    pub(super) fn start(&mut self, count: usize, variant: u64) -> Result<Columns, EigenError> {
        let mut random = PseudoRandom(24 + variant);
        let size: Vec<f64> = self.inner.diagonal().iter().map(|entry| entry.abs().sqrt()).collect();
        let mut start = Columns::new(size.len());
        for _ in 0..count {
            let force = DVector::from_fn(size.len(), |i, _| size[i] * random.number());
            start.push(self.solve(force)?.as_slice());
        }
        Ok(start)
    }
}
