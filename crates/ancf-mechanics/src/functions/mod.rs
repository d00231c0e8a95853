//! Functions of time and user-defined forces.

mod expression;
mod external_function;
mod force;
mod function;
mod function_value;
mod grammar;
mod syntax_node;
mod time_table;

pub use expression::Expression;
pub use external_function::External;
pub use force::ForceFunction;
pub use function::{Function, Integral};
pub use function_value::Instant;
pub use grammar::ExpressionError;
pub use time_table::Table;
