//! Violations of the rules in `layers.toml`.

/// A violation: location, finding, and what to do.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Violation {
    /// Tree in which it was found, by index.
    pub(super) tree: usize,
    /// Location (`path` or `path:line`), finding and remedy.
    pub(super) text: String,
}

impl Violation {
    pub(super) fn new(tree: usize, text: String) -> Self {
        Self { tree, text }
    }
}
