//! FLOOR 0: functions of time, pure numbers by which loads grow and joints turn.

mod expression;
mod grammar;
mod table;
mod varying;

pub use expression::Expression;
pub use grammar::ExpressionError;
pub use table::Table;
pub use varying::{Function, Instant};
