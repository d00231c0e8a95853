//! Violations of the rules in `layers.toml`.

/// A violation: location, finding, and what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::layers) struct Violation {
    /// Tree in which it was found, by index.
    pub(in crate::layers) tree: usize,
    /// Location (`path` or `path:line`), finding and remedy.
    pub(in crate::layers) text: String,
}

impl Violation {
    pub(in crate::layers) fn new(tree: usize, text: String) -> Self {
        Self { tree, text }
    }
}
