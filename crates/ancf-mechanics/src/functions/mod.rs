//! Functions of time and user-defined forces.

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
