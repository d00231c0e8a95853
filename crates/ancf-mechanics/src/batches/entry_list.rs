use std::collections::HashMap;

/// Entries of a tangent that can differ from zero, in the order of their numbers.
#[derive(Debug, Default)]
pub(super) struct EntryList {
    pub list: Vec<[u8; 2]>,
    numbers: HashMap<[u8; 2], usize>,
}

impl EntryList {
    /// Returns the number of an entry of the symmetric matrix.
    pub fn number(&mut self, i: usize, j: usize) -> usize {
        let entry = [i.max(j) as u8, i.min(j) as u8];
        *self.numbers.entry(entry).or_insert_with(|| {
            self.list.push(entry);
            self.list.len() - 1
        })
    }

    /// Returns the numbers of (i + k, j + k) for the three components k of two vectors.
    pub fn diagonal(&mut self, i: usize, j: usize) -> [usize; 3] {
        [0, 1, 2].map(|k| self.number(i + k, j + k))
    }

    /// Returns the numbers of (i, j + k) for the three components k of a vector.
    pub fn row(&mut self, i: usize, j: usize) -> [usize; 3] {
        [0, 1, 2].map(|k| self.number(i, j + k))
    }
}
