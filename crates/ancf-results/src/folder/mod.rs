//! Results folder: paths, lock, summary, and writing of whole files.

mod checksum;
mod run_folder;
mod sequence;
mod summary_file;
mod whole_file;

pub(crate) use checksum::{damaged, sha256};
pub use run_folder::Folder;
pub(crate) use run_folder::{erase_signature, sign};
pub(crate) use sequence::sequence_folders;
pub use sequence::{sequence_file, write_sequence};
pub use summary_file::SummaryFile;
pub(crate) use summary_file::{has_summary_checksum, read_summary, write_summary};
pub use whole_file::write_atomically;
pub(crate) use whole_file::{create, part_path, remove, remove_all, rename, replace, with_path};
