//! Sums over terms that are needed once per increment or analysis.

use std::sync::Arc;

use super::local_state::LocalState;
use super::state::State;
use super::term::Term;

/// Skew entries below this part of the largest one are zero.
const NEGLIGIBLE: f64 = 1e-14;

/// Largest rotation between two states.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Rotation {
    /// Size, relative to the limit of one load increment ([`Term::rotation`]).
    pub size: f64,
    /// Coordinate of the term that rotates.
    pub at: usize,
}

/// Returns the largest rotation of all terms between two states.
pub(super) fn largest_rotation(terms: &[Arc<dyn Term>], from: &State, to: &State) -> Rotation {
    let (mut before, mut after) = (LocalState::EMPTY, LocalState::EMPTY);
    let mut largest = Rotation::default();
    for term in terms {
        let term = term.as_ref();
        let size = term.rotation(&before.gather(from, term), &after.gather(to, term));
        if size > largest.size {
            largest = Rotation { size, at: term.coordinates().first().copied().unwrap_or(0) };
        }
    }
    largest
}

/// Returns the sum of the skew stiffness of all terms: lower entries in ascending order without repetition.
pub(super) fn skew_stiffness(terms: &[Arc<dyn Term>], s: &State) -> Vec<(usize, usize, f64)> {
    let (mut gathered, mut entries) = (LocalState::EMPTY, Vec::new());
    for term in terms {
        let (term, coordinates) = (term.as_ref(), term.coordinates());
        term.skew_stiffness(&gathered.gather(s, term), &mut |i, j, value| {
            let (a, b) = (coordinates[i], coordinates[j]);
            entries.push(if a > b { (a, b, value) } else { (b, a, -value) });
        });
    }
    entries.sort_by_key(|&(i, j, _)| (i, j));
    entries.dedup_by(|next, kept| {
        let same = (next.0, next.1) == (kept.0, kept.1);
        if same {
            kept.2 += next.2;
        }
        same
    });
    let largest = entries.iter().fold(0.0_f64, |largest, (.., value)| largest.max(value.abs()));
    entries.retain(|(.., value)| value.abs() > NEGLIGIBLE * largest);
    entries
}

/// Returns the global unknowns of a term: its coordinates, then its multipliers numbered after all coordinates.
pub(super) fn unknowns(term: &dyn Term, coordinates: usize) -> impl Iterator<Item = u32> {
    let multipliers = term.multipliers().map(move |m| coordinates + m);
    term.coordinates().iter().copied().chain(multipliers).map(|unknown| unknown as u32)
}
