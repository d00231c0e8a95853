use std::ops::{Index, Range};

/// Lists of indices in contiguous storage.
#[derive(Clone, Debug)]
pub(crate) struct IndexLists {
    starts: Vec<usize>,
    items: Vec<u32>,
}

impl IndexLists {
    /// Creates an empty collection.
    pub(crate) fn new() -> Self {
        Self { starts: vec![0], items: Vec::new() }
    }

    /// Appends a list.
    pub(crate) fn push(&mut self, list: impl IntoIterator<Item = u32>) {
        self.items.extend(list);
        self.starts.push(self.items.len());
    }

    /// Groups items by key and keeps their order.
    pub(crate) fn by_key(keys: usize, pairs: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        let mut starts = vec![0; keys + 1];
        pairs.clone().for_each(|(key, _)| starts[key as usize + 1] += 1);
        (0..keys).for_each(|key| starts[key + 1] += starts[key]);
        let (mut next, mut items) = (starts.clone(), vec![0; starts[keys]]);
        for (key, item) in pairs {
            items[next[key as usize]] = item;
            next[key as usize] += 1;
        }
        Self { starts, items }
    }

    /// Returns the range of a list among the items of all lists.
    pub(crate) fn range(&self, list: usize) -> Range<usize> {
        self.starts[list]..self.starts[list + 1]
    }

    /// Returns the number of lists.
    pub(crate) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    /// Returns an iterator over the lists.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &[u32]> + Clone {
        self.starts.windows(2).map(|range| &self.items[range[0]..range[1]])
    }
}

impl Index<usize> for IndexLists {
    type Output = [u32];

    fn index(&self, i: usize) -> &[u32] {
        &self.items[self.range(i)]
    }
}

impl<L: IntoIterator<Item = u32>> FromIterator<L> for IndexLists {
    fn from_iter<T: IntoIterator<Item = L>>(lists: T) -> Self {
        let mut all = Self::new();
        lists.into_iter().for_each(|list| all.push(list));
        all
    }
}
