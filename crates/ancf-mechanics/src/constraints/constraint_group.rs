use std::ops::Range;

use ancf_solver::equations::{LOCAL, Local, LocalMatrix, MAX_UNKNOWNS, Term, Weights};

use super::bilinear_row::{BilinearRow, QuadraticConstraint};

/// Constraints of a joint or a rigid body as one term: one gather, one scatter, and one lane of a batch.
///
/// All constraints are at most quadratic in the coordinates and have consecutive multipliers. The evaluation is that of the
/// constraints. Batches evaluate their rows instead (`BilinearRow`).
pub struct ConstraintGroup {
    coordinates: Vec<usize>,
    multipliers: Range<usize>,
    parts: Vec<Part>,
}

/// Constraint that can belong to a group.
pub struct GroupedConstraint(Box<dyn QuadraticConstraint>);

/// Constraint in a group: the places of its coordinates and of its first multiplier.
struct Part {
    term: Box<dyn QuadraticConstraint>,
    places: Vec<usize>,
    first: usize,
}

impl std::fmt::Debug for ConstraintGroup {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { coordinates, multipliers, .. } = self;
        let mut debug = f.debug_struct("ConstraintGroup");
        debug.field("coordinates", coordinates).field("multipliers", multipliers).finish_non_exhaustive()
    }
}

impl std::fmt::Debug for GroupedConstraint {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("GroupedConstraint").field("rows", &self.0.rows()).finish_non_exhaustive()
    }
}

impl GroupedConstraint {
    /// Copies a constraint, if it is quadratic.
    pub(super) fn new(constraint: &(impl QuadraticConstraint + Clone)) -> Option<Self> {
        constraint.rows().map(|_| Self(Box::new(constraint.clone())))
    }
}

impl ConstraintGroup {
    /// Creates groups of constraints in the order of their multipliers. A group has at most the size of a term in a batch,
    /// or one constraint.
    pub fn groups(constraints: impl IntoIterator<Item = GroupedConstraint>) -> Vec<Self> {
        let mut groups: Vec<Vec<GroupedConstraint>> = Vec::new();
        for constraint in constraints {
            match groups.last_mut() {
                Some(group) if can_follow(group, &constraint) => group.push(constraint),
                _ => groups.push(vec![constraint]),
            }
        }
        groups.into_iter().map(|group| Self::over(union_coordinates(&group, None), group)).collect()
    }

    /// Creates the group of some constraints with consecutive multipliers over sorted coordinates.
    pub(crate) fn over(coordinates: Vec<usize>, constraints: Vec<GroupedConstraint>) -> Self {
        let first = constraints.first().map_or(0, |first| first.0.multipliers().start);
        let last = constraints.last().map_or(0, |last| last.0.multipliers().end);
        let place = |c: &usize| {
            coordinates.binary_search(c).expect("the coordinates of a group contain those of its constraints")
        };
        let part = |GroupedConstraint(term): GroupedConstraint| {
            let places = term.coordinates().iter().map(place).collect();
            Part { first: term.multipliers().start - first, places, term }
        };
        Self { parts: constraints.into_iter().map(part).collect(), multipliers: first..last, coordinates }
    }

    /// Returns the rows over the coordinates of the group, one for each multiplier.
    pub(crate) fn rows(&self) -> Vec<BilinearRow> {
        let rows = |part: &Part| {
            let own = part.term.rows().into_iter().flatten();
            own.map(|row| row.within(&part.places)).collect::<Vec<_>>()
        };
        self.parts.iter().flat_map(rows).collect()
    }

    /// Adds the tangents of the constraints, each computed in the storage.
    fn add_tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>, storage: &mut [f64]) {
        for part in &self.parts {
            let mut block = LocalMatrix::zero(part.size(), storage);
            part.evaluate(at, |own| part.term.tangent(own, w, &mut block));
            for j in 0..part.size() {
                for i in j..part.size() {
                    let (row, column) = (part.place(i, at.q.len()), part.place(j, at.q.len()));
                    k.add(row.max(column), row.min(column), block.get(i, j));
                }
            }
        }
    }
}

/// Number of unknowns of a constraint between two rigid bodies, and of those that are smaller.
const SMALL: usize = 32;

/// True if a constraint can follow the last one of a group.
fn can_follow(group: &[GroupedConstraint], next: &GroupedConstraint) -> bool {
    let range = |of: &GroupedConstraint| of.0.multipliers();
    let [first, last] = [range(&group[0]), range(&group[group.len() - 1])];
    let size = union_coordinates(group, Some(next)).len() + range(next).end.saturating_sub(first.start);
    last.end == range(next).start && size <= MAX_UNKNOWNS
}

/// Returns the sorted coordinates of some constraints.
fn union_coordinates(group: &[GroupedConstraint], next: Option<&GroupedConstraint>) -> Vec<usize> {
    let all = group.iter().chain(next).flat_map(|constraint| constraint.0.coordinates());
    let mut coordinates: Vec<usize> = all.copied().collect();
    coordinates.sort_unstable();
    coordinates.dedup();
    coordinates
}

impl Part {
    /// Evaluates the constraint with its own coordinates and multipliers.
    fn evaluate<T>(&self, at: &Local<'_>, visit: impl FnOnce(&Local<'_>) -> T) -> T {
        let [mut q, mut v, mut a] = [[0.0; LOCAL]; 3];
        for (i, &place) in self.places.iter().enumerate() {
            (q[i], v[i], a[i]) = (at.q[place], at.v[place], at.a[place]);
        }
        let (n, own) = (self.places.len(), self.first..self.first + self.term.multipliers().len());
        visit(&Local { q: &q[..n], v: &v[..n], a: &a[..n], lambda: &at.lambda[own], ..*at })
    }

    /// Returns the place of a local unknown in a group with a number of coordinates.
    fn place(&self, unknown: usize, coordinates: usize) -> usize {
        let multiplier = unknown.checked_sub(self.places.len());
        multiplier.map_or_else(|| self.places[unknown], |k| coordinates + self.first + k)
    }

    /// Adds rows of the constraint to those of the group.
    fn add(&self, at: &Local<'_>, sum: &mut [f64], share: impl FnOnce(&dyn Term, &Local<'_>, &mut [f64])) {
        let (size, mut rows) = (self.size(), [0.0; LOCAL]);
        self.evaluate(at, |own| share(self.term.as_ref(), own, &mut rows[..size]));
        (0..size).for_each(|i| sum[self.place(i, at.q.len())] += rows[i]);
    }

    fn size(&self) -> usize {
        self.places.len() + self.term.multipliers().len()
    }
}

impl Term for ConstraintGroup {
    fn coordinates(&self) -> &[usize] {
        &self.coordinates
    }

    fn multipliers(&self) -> Range<usize> {
        self.multipliers.clone()
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn constraint_name(&self, k: usize) -> String {
        let part = self.parts.iter().rfind(|part| part.first <= k);
        part.map_or_else(String::new, |part| part.term.constraint_name(k - part.first))
    }

    fn constraint_entries(&self) -> Vec<[usize; 2]> {
        let rows = self.rows();
        let entries = rows.iter().enumerate().flat_map(|(k, row)| row.coordinates().map(move |c| [k, c]));
        let mut entries: Vec<[usize; 2]> = entries.collect();
        entries.sort_unstable();
        entries.dedup();
        entries
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        self.parts.iter().for_each(|part| part.add(at, r, |term, at, rows| term.residual(at, rows)));
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        self.parts.iter().for_each(|part| part.add(at, floor, |term, at, rows| term.rounding(at, rows)));
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        // Clearing the storage of the largest term takes longer than the tangent of a joint of rigid bodies.
        if self.parts.iter().all(|part| part.size() <= SMALL) {
            self.add_tangent(at, w, k, &mut [0.0; SMALL * (SMALL + 1) / 2]);
        } else {
            self.add_tangent(at, w, k, &mut [0.0; LOCAL * (LOCAL + 1) / 2]);
        }
    }
}
