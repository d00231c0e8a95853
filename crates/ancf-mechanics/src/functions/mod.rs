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
pub use external_function::ExternalFunction;
pub use force::ForceFunction;
pub use function::{Function, Integral};
pub use function_value::FunctionValue;
pub use grammar::ExpressionError;
pub use time_table::TimeTable;
