/// Maximum number of unknowns (coordinates and multipliers) of one term. Local arrays are kept on the stack.
pub const LOCAL: usize = 96;

/// State variables of a term: its own coordinates and multipliers in local order.
#[derive(Clone, Copy, Debug)]
pub struct Local<'a> {
    /// Coordinates.
    pub q: &'a [f64],
    /// Velocities.
    pub v: &'a [f64],
    /// Accelerations.
    pub a: &'a [f64],
    /// Multipliers of the term, then those that it observes ([`Term::observed_multipliers`](super::term::Term::observed_multipliers)).
    pub lambda: &'a [f64],
    /// Time.
    pub t: f64,
    /// Load factor s, which multiplies all loads.
    pub load: f64,
}

/// State variables of a term at both ends and in the middle of a step of the energy-momentum scheme.
///
/// The middle has the mean coordinates, velocities and time of both ends. Its accelerations are the mean ones of the step,
/// its multipliers those of the step.
#[derive(Clone, Copy, Debug)]
pub struct LocalStep<'a> {
    /// Start of the step.
    pub from: Local<'a>,
    /// Middle of the step.
    pub middle: Local<'a>,
    /// End of the step.
    pub to: Local<'a>,
    /// Numerical damping χ: strains have the weights ½ − χ at the start and ½ + χ at the end.
    pub damping: f64,
}

impl LocalStep<'_> {
    /// Returns the weights ½ − χ and ½ + χ of both ends.
    pub const fn shares(&self) -> [f64; 2] {
        [0.5 - self.damping, 0.5 + self.damping]
    }
}

/// Symmetric matrix over the coordinates and then the multipliers of a term, stored as the lower triangle by columns.
#[derive(Debug)]
pub struct LocalMatrix<'a> {
    size: usize,
    values: &'a mut [f64],
}

impl<'a> LocalMatrix<'a> {
    /// Creates a zero matrix of `size` rows in `storage`, which has at least size (size + 1)/2 numbers.
    pub fn zero(size: usize, storage: &'a mut [f64]) -> Self {
        let values = &mut storage[..size * (size + 1) / 2];
        values.fill(0.0);
        Self { size, values }
    }

    /// Adds to entry (i, j), i ≥ j.
    #[inline]
    pub fn add(&mut self, i: usize, j: usize, value: f64) {
        debug_assert!(i >= j && i < self.size, "entries are in the lower triangle");
        self.values[self.at(i, j)] += value;
    }

    /// Returns the entries (j, j) to (n − 1, j) of column j.
    #[inline]
    pub fn column_mut(&mut self, j: usize) -> &mut [f64] {
        let first = self.at(j, j);
        &mut self.values[first..first + self.size - j]
    }

    /// Adds the lower triangle of a matrix, stated by its entries (i, j), over the first `size` unknowns.
    #[inline]
    pub fn add_lower(&mut self, size: usize, entry: impl Fn(usize, usize) -> f64) {
        for j in 0..size {
            let column = self.column_mut(j);
            (j..size).for_each(|i| column[i - j] += entry(i, j));
        }
    }

    /// Returns entry (i, j), i ≥ j.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        self.values[self.at(i, j)]
    }

    /// Returns the lower triangle by columns.
    pub fn lower(&self) -> &[f64] {
        self.values
    }

    /// Returns the index of entry (i, j): column j ends with row n − 1 at (j + 1) n − j (j + 1)/2 − 1.
    #[inline]
    const fn at(&self, i: usize, j: usize) -> usize {
        j * self.size - j * (j + 1) / 2 + i
    }

    /// Subtracts a matrix of the same size.
    pub(super) fn subtract(&mut self, other: &LocalMatrix<'_>) {
        self.values.iter_mut().zip(&*other.values).for_each(|(value, other)| *value -= other);
    }
}
