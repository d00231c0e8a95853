//! Thickness and directions of fibres that vary over a shell.

mod fibres;
mod field_shell;
mod normal;
mod shell_fields;
mod thickness;

pub use fibres::{AngleField, AxisField, FibreAngle, FibreAxis};
pub(crate) use field_shell::{FieldPlace, FieldShell};
pub(crate) use normal::is_parallel;
pub(crate) use shell_fields::GivenFields;
pub(crate) use shell_fields::{FieldDefect, FieldPoint};
pub use thickness::{ShellThickness, ThicknessField};
