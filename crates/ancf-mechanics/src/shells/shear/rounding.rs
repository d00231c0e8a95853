//! Bounds of the rounding errors of the forces of a shear-deformable shell element.

use super::forms::{QUAD_VECTORS, STRAINS, Strains, Weighting};
use super::profile::{ShearProfile, ShearTables};

/// Roundings in a sum of eight products, relative to the sum of their magnitudes.
const SUM: f64 = 4.0 * f64::EPSILON;

/// Adds the bounds for an element with displacements and velocities of the given magnitudes.
pub(crate) fn add_rounding(
    tables: &ShearTables,
    profile: &ShearProfile,
    [q, v]: [&Weighting; 2],
    (strains, stress): (&Strains, &Strains),
    bound: &mut Weighting,
) {
    let time = profile.medium.retardation;
    let mut gradients = [[0.0; QUAD_VECTORS]; STRAINS];
    let mut errors = [0.0; STRAINS];
    for (k, form) in tables.forms.iter().enumerate() {
        for a in 0..QUAD_VECTORS {
            let moved: f64 = form[a].iter().zip(q).map(|(w, q)| w.abs() * q).sum();
            gradients[k][a] = profile.gradients[k][a].norm() + moved;
            errors[k] += SUM * gradients[k][a] * (q[a] + time * v[a]);
        }
    }
    for k in 0..STRAINS {
        let row = profile.stiffness.row(k);
        let error: f64 =
            row.iter().enumerate().map(|(l, c)| c.abs() * (errors[l] + SUM * strains[l].abs())).sum();
        for (bound, gradient) in bound.iter_mut().zip(&gradients[k]) {
            *bound += (error + SUM * stress[k].abs()) * gradient;
        }
    }
}
