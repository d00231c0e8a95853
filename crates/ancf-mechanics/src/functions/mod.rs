//! Functions of time and user-defined forces.

mod expression;
mod external_function;
mod function;
mod function_bounds;
mod function_value;
mod grammar;
mod input_signal;
mod interval;
mod resolution;
mod syntax_node;
mod time_table;
mod variation;

pub use expression::Expression;
pub use external_function::{ExternalFunction, ForceFunction};
pub use function::{Function, Integral};
pub use function_value::FunctionValue;
pub use grammar::ExpressionError;
pub(crate) use grammar::{is_reserved, parse};
pub use input_signal::{InputSignal, InputTransition};
pub(crate) use syntax_node::{Jet, Operand, SyntaxNode};
pub use time_table::TimeTable;
pub use variation::Variation;
