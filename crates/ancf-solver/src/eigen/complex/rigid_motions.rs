use nalgebra::{DMatrix, DVector};

use crate::eigen::full_rows::FullRows;
use crate::eigen::modes::Mode;

/// Dissipation of a rigid motion that is a rounding error, in multiples of the bound for all rigid motions.
const SAFE: f64 = 64.0;
/// Largest damping force of a rigid motion without dissipation, relative to the sums of the magnitudes of its terms in all rigid motions.
/// Larger ones are of dampers that also drive.
const FORCE: f64 = 1e-6;

/// Rigid-body motions of a system with symmetric matrices, orthonormal in M.
///
/// Those without damping have a double eigenvalue λ = 0 with one vector. Rounding errors ε of a matrix split it by √ε, which may be
/// as large as the eigenvalues of the structure. The motions orthogonal to these are invariant, and the double eigenvalues do not
/// occur among them. Those with damping have no stiffness, but for rounding errors that would exceed a weak damping.
pub(super) struct RigidMotions {
    /// Motions, those without damping first.
    motions: Vec<Motion>,
    /// Number of the motions without damping.
    free: usize,
    /// Largest residual of the undamped modes.
    residual: f64,
}

/// Shape x over the unknowns, with zeros instead of multipliers, and M x.
struct Motion {
    shape: DVector<f64>,
    image: DVector<f64>,
}

impl RigidMotions {
    pub(super) const NONE: Self = Self { motions: Vec::new(), free: 0, residual: 0.0 };

    /// Finds the motions among the undamped modes, for symmetric matrices of stiffness and damping.
    ///
    /// The eigenvectors of the dissipation between rigid-body modes separate those without damping from the others.
    pub(super) fn new(modes: &[Mode], mass: &FullRows, damping: &FullRows) -> Self {
        let size = mass.diagonal().len();
        let whole = |shape: &[f64]| {
            let mut x = DVector::zeros(size);
            x.as_mut_slice()[..shape.len()].copy_from_slice(shape);
            x
        };
        let modes = || modes.iter().filter(|mode| mode.omega_squared == 0.0);
        let rigid: Vec<DVector<f64>> = modes().map(|mode| whole(&mode.shape)).collect();
        if rigid.is_empty() {
            return Self::NONE;
        }
        let forces: Vec<Vec<f64>> = rigid.iter().map(|x| damping.times(x.as_slice())).collect();
        let dot = |i: usize, j: usize| rigid[i].iter().zip(&forces[j]).map(|(x, f)| x * f).sum::<f64>();
        let dissipation = DMatrix::from_fn(rigid.len(), rigid.len(), |i, j| 0.5 * (dot(i, j) + dot(j, i)));
        let eigen = dissipation.symmetric_eigen();
        let largest = |of: &dyn Fn(&[f64]) -> f64| rigid.iter().map(|x| of(x.as_slice())).fold(0.0, f64::max);
        let bound = SAFE * f64::EPSILON * largest(&|x| damping.magnitude(x));
        let terms = largest(&|x| damping.magnitudes(x).into_iter().fold(0.0, f64::max));
        let (mut motions, mut damped) = (Vec::new(), Vec::new());
        for (value, weights) in eigen.eigenvalues.iter().zip(eigen.eigenvectors.column_iter()) {
            let mut shape = DVector::zeros(size);
            rigid.iter().zip(&weights).for_each(|(own, weight)| shape.axpy(*weight, own, 1.0));
            let force = damping.times(shape.as_slice());
            let is_free = value.abs() <= bound && force.iter().all(|force| force.abs() <= FORCE * terms);
            let image = DVector::from_vec(mass.times(shape.as_slice()));
            if is_free { &mut motions } else { &mut damped }.push(Motion { shape, image });
        }
        let free = motions.len();
        motions.append(&mut damped);
        let residual = modes().map(|mode| mode.residual).fold(0.0, f64::max);
        Self { motions, free, residual }
    }

    /// Returns the shapes of the motions without damping.
    pub(super) fn free(&self) -> impl Iterator<Item = &DVector<f64>> {
        self.motions[..self.free].iter().map(|motion| &motion.shape)
    }

    /// Returns a bound of the residuals.
    pub(super) const fn residual(&self) -> f64 {
        self.residual
    }

    /// Removes the motions without damping from a vector over the unknowns.
    pub(super) fn remove_free(&self, x: &mut DVector<f64>) {
        remove(&self.motions[..self.free], x);
    }

    /// Removes all motions from a vector over the unknowns.
    pub(super) fn remove_from(&self, x: &mut DVector<f64>) {
        remove(&self.motions, x);
    }

    /// Removes forces that work on the motions, which the stiffness does not have.
    pub(super) fn remove_from_force(&self, force: &mut DVector<f64>) {
        for Motion { shape, image } in &self.motions {
            let part = shape.dot(force);
            force.axpy(-part, image, 1.0);
        }
    }
}

fn remove(motions: &[Motion], x: &mut DVector<f64>) {
    for Motion { shape, image } in motions {
        let part = image.dot(x);
        x.axpy(-part, shape, 1.0);
    }
}
