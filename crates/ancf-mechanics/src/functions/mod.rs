//! Functions of time, and forces that a program supplies.

mod expression;
mod external;
mod force;
mod grammar;
mod integral;
mod table;
mod varying;

pub use expression::Expression;
pub use external::External;
pub use force::ForceFunction;
pub use grammar::ExpressionError;
pub use integral::Integral;
pub use table::Table;
pub use varying::{Function, Instant};
