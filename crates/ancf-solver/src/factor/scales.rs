//! Equilibration D of a matrix K: D K D has entries of size one.

use std::ops::Range;

use crate::sparse::{Border, SparseMatrix};
use crate::vectors::{for_each_chunk, largest_of_chunks};

/// Computes the equilibration D: the inverse root of the diagonal. For multipliers it is the inverse of the largest
/// scaled entry, since their diagonal is zero.
///
/// A diagonal below the rounding error of the largest one is no scale. That of a rigid body in statics is zero without
/// multipliers and a rounding error with them. The scales of constrained coordinates are therefore limited.
///
/// Returns the rounding error ε max |Kᵢᵢ| of the diagonal.
///
/// A coordinate without mass may have a diagonal close to zero, like a multiplier. Its scale is therefore limited.
/// At the limit it matches the other coordinates in an equation that determines it.
pub(super) fn equilibrate(k: &SparseMatrix, d: &mut [f64], [largest, bound]: [&mut [f64]; 2]) -> f64 {
    for_each_chunk(d, |range, d| {
        d.iter_mut().zip(k.diagonal_from(range.start)).for_each(|(d, diagonal)| *d = diagonal);
    });
    let largest_of = |range: Range<usize>| d[range].iter().map(|d| d.abs()).fold(0.0, f64::max);
    let rounding = f64::EPSILON * largest_of_chunks(d.len(), largest_of);
    for_each_chunk(d, |_, d| {
        d.iter_mut().for_each(|d| *d = if *d == 0.0 { 1.0 } else { 1.0 / d.abs().sqrt() });
    });
    let massless = k.pattern().massless();
    if !massless.is_empty() {
        massless.iter().for_each(|&at| d[at] = 0.0);
        bound_scales(k, d, [&mut *largest, &mut *bound]);
        for &at in massless {
            let own = 1.0 / k.values()[k.pattern().diagonal(at)].abs().sqrt();
            d[at] = Some(own.min(bound[at])).filter(|d| d.is_finite()).unwrap_or(1.0);
        }
    }
    let limit = 1.0 / rounding.sqrt();
    for at in k.pattern().constrained() {
        d[at] = d[at].min(limit);
    }
    scale_multipliers(k, d, largest);
    rounding
}

/// Changes the scales of constrained coordinates without stiffness beyond `rounding`, in an equilibration by [`equilibrate`], to
/// match those of the other coordinates in their constraints.
///
/// The stiffness of a rigid body in statics is zero, a rounding error, or that of small constraint forces. Its constraints would have
/// this scale, and a compliance relative to it would make them soft.
///
/// If no coordinate has a stiffness but for that of constraint forces and springs of joints, as in statics of rigid bodies, all have one
/// scale: that of the largest stiffness. Scales of chains of constraints would have those of rounding errors of their entries. Returns
/// true in this case.
pub(super) fn match_scales(
    k: &SparseMatrix,
    rounding: f64,
    d: &mut [f64],
    [largest, bound]: [&mut [f64]; 2],
) -> bool {
    if !k.has_inertia() && has_rigid_bodies_only(k) {
        let stiffness = k.diagonal().map(f64::abs).fold(1.0, f64::max);
        d.fill(1.0 / stiffness.sqrt());
        scale_multipliers(k, d, largest);
        return true;
    }
    let constrained = || k.pattern().constrained();
    let is_zero = |at: usize| k.values()[k.pattern().diagonal(at)].abs() <= rounding;
    constrained().filter(|&at| is_zero(at)).for_each(|at| d[at] = 0.0);
    if !k.has_inertia() {
        k.pattern().without_stiffness().iter().for_each(|&at| d[at] = 0.0);
    }
    let mut open = d.contains(&0.0);
    if !open {
        return false;
    }
    // The multipliers get their scales at the end.
    k.pattern().border().iter().for_each(|border| d[border.multiplier as usize] = 0.0);
    let softest = Some(d.iter().copied().fold(0.0, f64::max)).filter(|d| *d > 0.0).unwrap_or(1.0);
    k.pattern().border().iter().for_each(|border| d[border.multiplier as usize] = 1.0);
    while open {
        bound_scales(k, d, [&mut *largest, &mut *bound]);
        open = false;
        for at in constrained() {
            if d[at] == 0.0 && bound[at].is_finite() {
                (d[at], open) = (bound[at].min(softest), true);
            }
        }
    }
    // Coordinates without any stiffness in their chain of constraints.
    d.iter_mut().filter(|d| **d == 0.0).for_each(|d| *d = softest);
    scale_multipliers(k, d, largest);
    false
}

/// True if all coordinates with mass are those of bodies without stiffness.
fn has_rigid_bodies_only(k: &SparseMatrix) -> bool {
    let pattern = k.pattern();
    let mut others = vec![true; pattern.size()];
    pattern.without_stiffness().iter().chain(pattern.massless()).for_each(|&at| others[at] = false);
    pattern.border().iter().for_each(|border| others[border.multiplier as usize] = false);
    !others.contains(&true)
}

/// Entry of a constraint, relative to its largest one, that may be a rounding error and gives no scale.
const NEGLIGIBLE: f64 = 1e-9;

/// Computes bounds of the scales that are zero: they match the largest scaled entry of a constraint. Infinite without one.
///
/// Entries that may be rounding errors neither have a bound nor give one.
fn bound_scales(k: &SparseMatrix, d: &[f64], [largest, bound]: [&mut [f64]; 2]) {
    bound.fill(f64::INFINITY);
    let border = k.pattern().border();
    // The bounds of multipliers are the largest entries of their rows.
    border.iter().for_each(|border| bound[border.multiplier as usize] = 0.0);
    for &Border { multiplier, slot, .. } in border {
        let row = &mut bound[multiplier as usize];
        *row = row.max(k.values()[slot].abs());
    }
    let significant = |bound: &[f64], &Border { coordinate, multiplier, slot }: &Border| {
        let entry = k.values()[slot].abs();
        (entry > NEGLIGIBLE * bound[multiplier as usize]).then_some((
            coordinate as usize,
            multiplier as usize,
            entry,
        ))
    };
    largest.fill(0.0);
    for (coordinate, multiplier, entry) in border.iter().filter_map(|border| significant(bound, border)) {
        largest[multiplier] = largest[multiplier].max(entry * d[coordinate]);
    }
    for border in border {
        let Some((coordinate, multiplier, entry)) = significant(bound, border) else { continue };
        if d[coordinate] == 0.0 && largest[multiplier] > 0.0 {
            bound[coordinate] = bound[coordinate].min(largest[multiplier] / entry);
        }
    }
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
    for &Border { coordinate, multiplier, slot } in k.pattern().border() {
        let (entry, largest) = (k.values()[slot].abs(), &mut largest[multiplier as usize]);
        *largest = largest.max(entry * d[coordinate as usize]);
    }
}
