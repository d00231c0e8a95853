//! Documents with generated parts.

mod description;
pub(crate) mod key_tables;
