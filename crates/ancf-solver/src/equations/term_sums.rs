//! State variables of single terms, and sums over terms that are needed once per step, increment or analysis.

use std::sync::Arc;

use super::terms::{LOCAL, Local, LocalStep, Power, State, StepStates, Term};

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

/// Visits entries of the derivatives of one term in a state, such as the skew ones.
type DerivativePart = fn(&dyn Term, &Local<'_>, &mut dyn FnMut(usize, usize, f64));

/// Returns the entries that terms visit, with the numbers of their coordinates and with repetitions.
pub(super) fn visited_entries(
    terms: &[Arc<dyn Term>],
    s: &State,
    of: DerivativePart,
) -> Vec<(usize, usize, f64)> {
    let (mut gathered, mut entries) = (LocalState::EMPTY, Vec::new());
    for term in terms {
        let (term, coordinates) = (term.as_ref(), term.coordinates());
        of(term, &gathered.gather(s, term), &mut |i, j, value| {
            entries.push((coordinates[i], coordinates[j], value));
        });
    }
    entries
}

/// Returns the sum of a skew matrix of all terms: lower entries in ascending order without repetition.
pub(super) fn skew_entries(
    terms: &[Arc<dyn Term>],
    s: &State,
    of: DerivativePart,
) -> Vec<(usize, usize, f64)> {
    let lower = |(a, b, value): (usize, usize, f64)| if a > b { (a, b, value) } else { (b, a, -value) };
    let mut entries: Vec<_> = visited_entries(terms, s, of).into_iter().map(lower).collect();
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

/// Returns the powers of terms without batches, except those of damping forces.
pub(super) fn powers<'a>(terms: impl Iterator<Item = &'a Arc<dyn Term>>, s: &State) -> Power {
    let mut gathered = LocalState::EMPTY;
    let power = |term: &Arc<dyn Term>| {
        let at = gathered.gather(s, term.as_ref());
        let flow = term.flow_power(&at);
        Power { work: term.supplied_power(&at) + flow, dissipation: flow }
    };
    let mut sum = Power::default();
    terms.map(power).for_each(|power| sum += power);
    sum
}

/// Velocity with which forces are determined from their power.
const VELOCITY: f64 = 1e-3;

/// Returns the sum of the magnitudes of the forces that supply work, by coordinate.
pub(super) fn supplied_forces<'a>(terms: impl Iterator<Item = &'a Arc<dyn Term>>, s: &State) -> f64 {
    let (mut gathered, mut v) = (LocalState::EMPTY, vec![0.0; LOCAL]);
    let forces = |term: &Arc<dyn Term>| {
        let at = gathered.gather(s, term.as_ref());
        let n = at.q.len();
        // Prescribed motions supply power at rest.
        let at_rest = term.supplied_power(&Local { v: &v[..n], ..at });
        let mut power = |i: usize| {
            v[i] = VELOCITY;
            let power = term.supplied_power(&Local { v: &v[..n], ..at });
            v[i] = 0.0;
            power
        };
        (0..n).map(|i| ((power(i) - at_rest) / VELOCITY).abs()).sum::<f64>()
    };
    terms.map(forces).sum()
}

/// Number of coordinates and of multipliers up to which the state of a term is on the stack. To clear more would take longer than to
/// evaluate a small term.
pub(super) const USUAL: usize = 48;

/// State variables of one term, gathered from a global state.
#[derive(Clone, Debug)]
pub struct LocalState {
    /// q, v, a and λ of usual terms.
    small: [[f64; USUAL]; 4],
    /// Those of larger terms, one after the other.
    large: Vec<f64>,
}

impl LocalState {
    /// State of no term.
    pub const EMPTY: Self = Self { small: [[0.0; USUAL]; 4], large: Vec::new() };

    /// Gathers the state variables of a term.
    pub fn gather<'a>(&'a mut self, s: &State, term: &dyn Term) -> Local<'a> {
        let (coordinates, multipliers) = (term.coordinates(), term.multipliers());
        let observed = term.observed_multipliers();
        let (n, m) = (coordinates.len(), multipliers.len());
        let all = m + observed.len();
        let (q, v, a, lambda): (&mut [f64], &mut [f64], &mut [f64], &mut [f64]) = if n.max(all) <= USUAL {
            let [q, v, a, lambda] = &mut self.small;
            (q, v, a, lambda)
        } else {
            self.large.resize(4 * LOCAL, 0.0);
            let (first, second) = self.large.split_at_mut(2 * LOCAL);
            let ((q, v), (a, lambda)) = (first.split_at_mut(LOCAL), second.split_at_mut(LOCAL));
            (q, v, a, lambda)
        };
        for (i, &c) in coordinates.iter().enumerate() {
            q[i] = s.q[c];
            v[i] = s.v[c];
            a[i] = s.a[c];
        }
        lambda[..m].copy_from_slice(&s.lambda[multipliers]);
        for (k, &other) in observed.iter().enumerate() {
            lambda[m + k] = s.lambda[other];
        }
        Local { q: &q[..n], v: &v[..n], a: &a[..n], lambda: &lambda[..all], t: s.t, load: s.load }
    }
}

/// State variables of one term at both ends of a step.
pub(super) struct LocalEnds([LocalState; 2]);

impl LocalEnds {
    pub(super) const EMPTY: Self = Self([LocalState::EMPTY, LocalState::EMPTY]);

    pub(super) fn gather<'a>(
        &'a mut self,
        step: &StepStates<'_>,
        middle: Local<'a>,
        term: &dyn Term,
    ) -> LocalStep<'a> {
        let [from, to] = &mut self.0;
        LocalStep {
            from: from.gather(step.from, term),
            middle,
            to: to.gather(step.to, term),
            damping: step.damping,
        }
    }
}
