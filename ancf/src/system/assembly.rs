use std::fmt;
use std::sync::Arc;

use super::{
    Energy, EquationsOfMotion, LOCAL, Level, Local, LocalMatrix, Pattern, SparseMatrix, State, Term, Weights,
};

/// Equations of motion as the sum of terms: gather, evaluate, scatter.
pub struct System {
    coordinates: usize,
    multipliers: usize,
    terms: Vec<Box<dyn Term>>,
    /// The terms that have multipliers.
    constraints: Vec<usize>,
    pattern: Arc<Pattern>,
    /// Where the lower triangle of each term's matrix goes, term after term.
    slots: Vec<u32>,
}

impl fmt::Debug for System {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("System")
            .field("coordinates", &self.coordinates)
            .field("multipliers", &self.multipliers)
            .field("terms", &self.terms.len())
            .finish_non_exhaustive()
    }
}

/// The unknowns of one term, gathered from a state.
struct Gathered {
    q: [f64; LOCAL],
    v: [f64; LOCAL],
    a: [f64; LOCAL],
    lambda: [f64; LOCAL],
}

impl Gathered {
    const EMPTY: Self = Self { q: [0.0; LOCAL], v: [0.0; LOCAL], a: [0.0; LOCAL], lambda: [0.0; LOCAL] };

    fn gather<'a>(&'a mut self, s: &State, term: &dyn Term) -> Local<'a> {
        let (coordinates, multipliers) = (term.coordinates(), term.multipliers());
        for (i, &c) in coordinates.iter().enumerate() {
            self.q[i] = s.q[c];
            self.v[i] = s.v[c];
            self.a[i] = s.a[c];
        }
        let (n, m) = (coordinates.len(), multipliers.len());
        self.lambda[..m].copy_from_slice(&s.lambda[multipliers]);
        Local {
            q: &self.q[..n],
            v: &self.v[..n],
            a: &self.a[..n],
            lambda: &self.lambda[..m],
            t: s.t,
            load: s.load,
        }
    }
}

impl System {
    /// The sum of `terms` over so many coordinates and multipliers.
    ///
    /// # Panics
    /// If a term has more than [`LOCAL`] unknowns or names one that is not there: a mistake in code, not in input.
    pub fn new(coordinates: usize, multipliers: usize, terms: Vec<Box<dyn Term>>) -> Self {
        let unknowns: Vec<Vec<usize>> =
            terms.iter().map(|term| unknowns(term.as_ref(), coordinates)).collect();
        assert!(unknowns.iter().all(|u| u.len() <= LOCAL), "a term has at most {LOCAL} unknowns");
        let pattern = Pattern::new(coordinates, multipliers, &unknowns);
        let slots = unknowns
            .iter()
            .flat_map(|u| (0..u.len()).flat_map(move |j| (j..u.len()).map(move |i| (u[i], u[j]))))
            .map(|(i, j)| pattern.slot(i, j))
            .collect();
        let constraints = (0..terms.len()).filter(|&i| !terms[i].multipliers().is_empty()).collect();
        Self { coordinates, multipliers, terms, constraints, pattern: Arc::new(pattern), slots }
    }

    /// The terms.
    pub fn terms(&self) -> &[Box<dyn Term>] {
        &self.terms
    }

    /// A zero matrix of this pattern.
    pub fn matrix(&self) -> SparseMatrix {
        SparseMatrix::zero(Arc::clone(&self.pattern))
    }

    /// Sums a vector over the terms: `share` adds to the local rows.
    fn sum(&self, s: &State, sum: &mut [f64], share: impl Fn(&dyn Term, &Local<'_>, &mut [f64])) {
        sum.fill(0.0);
        let (mut gathered, mut rows) = (Gathered::EMPTY, [0.0; LOCAL]);
        for term in &self.terms {
            let term = term.as_ref();
            let local = gathered.gather(s, term);
            let n = local.q.len() + local.lambda.len();
            rows[..n].fill(0.0);
            share(term, &local, &mut rows[..n]);
            let (of_coordinates, of_multipliers) = rows[..n].split_at(local.q.len());
            for (&c, row) in term.coordinates().iter().zip(of_coordinates) {
                sum[c] += row;
            }
            for (m, row) in term.multipliers().zip(of_multipliers) {
                sum[self.coordinates + m] += row;
            }
        }
    }

    /// Sums a matrix over the terms: `share` adds to the lower triangle of the local one.
    fn sum_matrix(&self, k: &mut SparseMatrix, mut share: impl FnMut(&dyn Term, &mut LocalMatrix<'_>)) {
        let values = k.values_mut();
        values.fill(0.0);
        let (mut storage, mut slots) = ([0.0; LOCAL * LOCAL], self.slots.iter());
        for term in &self.terms {
            let term = term.as_ref();
            let size = term.coordinates().len() + term.multipliers().len();
            let mut block = LocalMatrix::zero(size, &mut storage);
            share(term, &mut block);
            for (value, &slot) in block.lower().zip(&mut slots) {
                values[slot as usize] += value;
            }
        }
    }
}

/// Rows of a term's multipliers at q + sign × v.
fn ahead(term: &dyn Term, at: &Local<'_>, sign: f64) -> [f64; LOCAL] {
    let (mut q, mut rows) = ([0.0; LOCAL], [0.0; LOCAL]);
    let (n, m) = (at.q.len(), at.lambda.len());
    for i in 0..n {
        q[i] = at.q[i] + sign * at.v[i];
    }
    term.residual(&Local { q: &q[..n], ..*at }, &mut rows[..n + m]);
    rows.copy_within(n..n + m, 0);
    rows
}

/// Global unknowns of a term: coordinates as they are, multipliers after all coordinates.
fn unknowns(term: &dyn Term, coordinates: usize) -> Vec<usize> {
    term.coordinates().iter().copied().chain(term.multipliers().map(|m| coordinates + m)).collect()
}

impl EquationsOfMotion for System {
    fn coordinates(&self) -> usize {
        self.coordinates
    }

    fn multipliers(&self) -> usize {
        self.multipliers
    }

    fn residual(&self, s: &State, r: &mut [f64]) {
        self.sum(s, r, |term, at, rows| term.residual(at, rows));
    }

    fn constraints(&self, s: &State, level: Level, phi: &mut [f64]) {
        phi.fill(0.0);
        let mut gathered = Gathered::EMPTY;
        for &i in &self.constraints {
            let term = self.terms[i].as_ref();
            let local = gathered.gather(s, term);
            let at = |sign| ahead(term, &local, sign);
            let (mut rates, mut accelerations) = ([0.0; LOCAL], [0.0; LOCAL]);
            let m = local.lambda.len();
            term.drive(s.t, &mut rates[..m], &mut accelerations[..m]);
            let (ahead, here, back) = match level {
                Level::Position => ([0.0; LOCAL], at(0.0), [0.0; LOCAL]),
                Level::Velocity => (at(1.0), [0.0; LOCAL], at(-1.0)),
                Level::Acceleration => (at(1.0), at(0.0), at(-1.0)),
            };
            for (k, row) in term.multipliers().enumerate() {
                phi[row] += match level {
                    Level::Position => here[k],
                    Level::Velocity => 0.5 * (ahead[k] - back[k]) + rates[k],
                    Level::Acceleration => ahead[k] - 2.0 * here[k] + back[k] + accelerations[k],
                };
            }
        }
    }

    fn rounding(&self, s: &State, floor: &mut [f64]) {
        self.sum(s, floor, |term, at, rows| term.rounding(at, rows));
    }

    fn pattern(&self) -> &Pattern {
        &self.pattern
    }

    fn tangent(&self, s: &State, w: Weights, k: &mut SparseMatrix) {
        let mut gathered = Gathered::EMPTY;
        self.sum_matrix(k, |term, block| term.tangent(&gathered.gather(s, term), w, block));
    }

    fn stress_stiffness(&self, s: &State, by: &State, k: &mut SparseMatrix) {
        let (mut at, mut increment) = (Gathered::EMPTY, Gathered::EMPTY);
        self.sum_matrix(k, |term, block| {
            term.stress_stiffness(&at.gather(s, term), &increment.gather(by, term), block);
        });
    }

    fn inadmissible(&self, s: &State) -> Option<usize> {
        let mut gathered = Gathered::EMPTY;
        let wrong = self.terms.iter().find(|term| !term.is_admissible(&gathered.gather(s, term.as_ref())));
        wrong.and_then(|term| term.coordinates().first().copied())
    }

    fn energy(&self, s: &State) -> Energy {
        let (mut gathered, mut energy) = (Gathered::EMPTY, Energy::default());
        for term in &self.terms {
            energy += term.energy(&gathered.gather(s, term.as_ref()));
        }
        energy
    }
}
