//! FLOOR 0: functions of time, pure numbers by which loads grow and joints turn.

mod expression;
mod grammar;
mod integral;
mod table;
mod varying;

pub use expression::Expression;
pub use grammar::ExpressionError;
pub use integral::Integral;
pub use table::Table;
pub use varying::{Function, Instant};
