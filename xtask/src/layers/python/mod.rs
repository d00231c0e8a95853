//! Imports between Python files, resolved through `__init__.py` to the module that defines the name.

mod collect;
mod module;
mod names;
mod statements;

pub(super) use collect::imports;
