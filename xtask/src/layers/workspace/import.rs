//! Imports between files.

/// Index of a file in the list of source files.
pub(in crate::layers) type FileId = usize;

/// Import of a name by one file from the file that defines it.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub(in crate::layers) struct Import {
    /// Importing file.
    pub(in crate::layers) from: FileId,
    /// Defining file.
    pub(in crate::layers) to: FileId,
    /// Imported name.
    pub(in crate::layers) name: String,
    /// Line of the import or of the path, from 1.
    pub(in crate::layers) line: usize,
}
