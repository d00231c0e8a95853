//! Equilibration D of a matrix K: D K D has entries of size one.

use crate::sparse::SparseMatrix;

/// Computes the equilibration D: the inverse root of the diagonal. For multipliers it is the inverse of the largest
/// scaled entry, since their diagonal is zero.
///
/// A diagonal below the rounding error of the largest one is no scale. That of a rigid body in statics is zero without
/// multipliers and a rounding error with them. The scales of such constrained coordinates match those of the other coordinates
/// in their constraints. Otherwise the multipliers of these constraints would have the scale of a rounding error.
///
/// A coordinate without mass may have a diagonal close to zero, like a multiplier. Its scale is therefore limited.
/// At the limit it matches the other coordinates in an equation that determines it.
///
/// Returns the rounding error ε max |Kᵢᵢ| of the diagonal.
pub(super) fn equilibrate(k: &SparseMatrix, d: &mut [f64], [largest, bound]: [&mut [f64]; 2]) -> f64 {
    d.iter_mut().zip(k.diagonal()).for_each(|(d, diagonal)| *d = diagonal);
    let rounding = f64::EPSILON * d.iter().map(|d| d.abs()).fold(0.0, f64::max);
    for d in &mut *d {
        *d = if *d == 0.0 { 1.0 } else { 1.0 / d.abs().sqrt() };
    }
    let own = |at: usize| k.values()[k.pattern().diagonal(at)].abs();
    let mut open = !k.pattern().massless().is_empty();
    k.pattern().massless().iter().for_each(|&at| d[at] = 0.0);
    for border in k.pattern().border().iter().filter(|border| own(border.coordinate) <= rounding) {
        (d[border.coordinate], open) = (0.0, true);
    }
    let mut massless = k.pattern().massless();
    while open {
        bound.fill(f64::INFINITY);
        largest_entries(k, d, largest);
        for border in k.pattern().border().iter().filter(|border| d[border.coordinate] == 0.0) {
            let (entry, others) = (k.values()[border.slot].abs(), largest[border.multiplier]);
            if entry > 0.0 && others > 0.0 {
                bound[border.coordinate] = bound[border.coordinate].min(others / entry);
            }
        }
        open = false;
        for &at in massless.iter().filter(|&&at| own(at) > rounding) {
            d[at] = bound[at].min(1.0 / own(at).sqrt());
        }
        massless = &[];
        for border in k.pattern().border() {
            let at = border.coordinate;
            if d[at] == 0.0 && bound[at].is_finite() {
                (d[at], open) = (bound[at], true);
            }
        }
    }
    // Coordinates without any stiffness in their chain of constraints.
    d.iter_mut().filter(|d| **d == 0.0).for_each(|d| *d = 1.0);
    scale_multipliers(k, d, largest);
    rounding
}

/// Sets the scales of the multipliers to the inverse of their largest scaled entry.
fn scale_multipliers(k: &SparseMatrix, d: &mut [f64], largest: &mut [f64]) {
    largest_entries(k, d, largest);
    for (d, &largest) in d.iter_mut().zip(&*largest) {
        if largest > 0.0 {
            *d = 1.0 / largest;
        }
    }
}

/// Computes the largest entry of each multiplier, scaled by D of its coordinate.
fn largest_entries(k: &SparseMatrix, d: &[f64], largest: &mut [f64]) {
    largest.fill(0.0);
    for border in k.pattern().border() {
        let entry = k.values()[border.slot].abs() * d[border.coordinate];
        largest[border.multiplier] = largest[border.multiplier].max(entry);
    }
}
