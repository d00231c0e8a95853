//! Imports between TypeScript files, resolved through re-exports to the file that defines the name.

mod collect;
mod declarations;

pub(super) use collect::imports;
