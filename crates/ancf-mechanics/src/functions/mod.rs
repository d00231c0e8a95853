//! Functions of time, and forces that a program supplies.

mod expression;
mod external;
mod force;
mod function;
mod grammar;
mod instant;
mod node;
mod table;

pub use expression::Expression;
pub use external::External;
pub use force::ForceFunction;
pub use function::{Function, Integral};
pub use grammar::ExpressionError;
pub use instant::Instant;
pub use table::Table;
