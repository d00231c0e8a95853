//! Parameter studies: one model, many cases, one table.
//!
//! ```text
//! source -> study -> design -> cases on worker threads -> rows -> results -> Parquet table
//!                                                            \-> observer
//! ```
//!
//! ```no_run
//! use ancf::solver::newton::Interrupt;
//! use ancf_study::{StudyRun, StudySettings, StudySource};
//!
//! let source = StudySource::read("study.toml".as_ref())?;
//! let settings = StudySettings { folder: "out".into(), part: None, retry: false };
//! let mut run = StudyRun::prepare(source, &settings)?;
//! let interrupt = Interrupt::new(|| false);
//! run.execute(4, &interrupt, |results| println!("{} of {}", results.done(), results.requested()))?;
//! # Ok::<(), ancf_study::StudyError>(())
//! ```
//!
//! Samples depend on the seed, on the path of the parameter and on their index only, those of a Sobol sequence also on the
//! position of the parameter. They are the same on every machine and in the Python package.

mod cases;
mod engine;
mod evaluation;
mod part;
mod source;
mod statement;
mod table;

pub use cases::{
    BaseModel, CaseDesign, CaseOutcome, CaseRow, ObjectiveGauges, ParameterAxis, reduce_column, run_cases,
};
pub use engine::{StudyRun, StudySettings};
pub use evaluation::{
    Convergence, LinearFit, ParameterSensitivity, RecordedColumn, Sensitivity, StudyRecord, convergence,
    linear_fit, observed_orders, sensitivity,
};
pub use part::StudyPart;
pub use source::StudySource;
pub use statement::{
    CaseLayout, Combine, MAX_CASES, MAX_SOBOL_DIMENSION, Objective, Objectives, Parameter, Sampling, Study,
    TABLE_COLUMNS, Take, ValueRule, check_places, sobol_points, zip_errors,
};
pub use table::{
    ObjectiveRange, ParameterType, StudyError, StudyOutcome, StudyResults, StudyTable, TableError, read_rows,
};
