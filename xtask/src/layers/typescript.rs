//! Imports between TypeScript files.

use super::import::Import;
use super::source::SourceFile;

/// Collects the imports of a tree.
pub(super) fn imports(_tree: usize, _files: &mut [SourceFile]) -> Vec<Import> {
    Vec::new()
}
