//! Imports between files.

/// Index of a file in the list of source files.
pub(super) type FileId = usize;

/// Import of a name by one file from the file that defines it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Import {
    /// Importing file.
    pub(super) from: FileId,
    /// Defining file.
    pub(super) to: FileId,
    /// Imported name.
    pub(super) name: String,
    /// Line of the import or of the path, from 1.
    pub(super) line: usize,
}
