//! FLOOR 0: functions of time, pure numbers by which loads grow and joints turn, and forces that a program computes.

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
