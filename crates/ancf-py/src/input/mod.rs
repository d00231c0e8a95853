//! Models from Python data.

mod callables;
mod data;
mod errors;
mod model;
mod part;
mod sequence;
mod signals;
mod threads;

pub(crate) use data::{DataReader, read_table, to_python, to_python_with};
pub(crate) use errors::{FaultArguments, faults, model_error, value_error};
pub(crate) use model::{diagnose, read, scaled, schema, substitute, to_toml, valid_model};
pub(crate) use part::{check_part, deserialize_part, nearest};
pub(crate) use sequence::{Stage, stages, stages_of_file};
pub(crate) use signals::Signals;
pub(crate) use threads::{detached, record_process};
