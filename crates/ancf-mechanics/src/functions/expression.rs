use super::function_bounds::FunctionBounds;
use super::function_value::FunctionValue;
use super::grammar::{ExpressionError, parse};
use super::syntax_node::{Jet, SyntaxNode};

/// Formula in t, with exact derivatives by dual numbers.
///
/// Operators in ascending precedence: comparisons (1 if true, 0 if false), + and −, * and /, the sign, ^. A power of a
/// power requires brackets. −t^2 is −(t²).
#[derive(Clone, Debug)]
pub struct Expression {
    root: SyntaxNode,
}

impl Expression {
    /// Parses a formula.
    ///
    /// # Errors
    /// If the formula is invalid. The error contains the position and the expected input.
    ///
    /// ```
    /// use ancf_mechanics::functions::Expression;
    ///
    /// let formula = Expression::parse("if(t < 2, t^2/4, 1)")?;
    /// assert_eq!(formula.at(1.0).value, 0.25);
    /// assert_eq!(formula.at(1.0).rate, 0.5);
    /// # Ok::<(), ancf_mechanics::functions::ExpressionError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        Ok(Self { root: parse(text, &["t"])? })
    }

    /// Returns the value with its first and second derivative.
    pub fn at(&self, t: f64) -> FunctionValue {
        let Jet { re, v1, v2 } = self.root.at(&|_| Jet::new(t, 1.0, 0.0));
        FunctionValue { value: re, rate: v1, acceleration: v2 }
    }

    /// Bounds value and derivatives over the interval of t.
    pub(crate) fn bounds(&self, t: FunctionBounds) -> FunctionBounds {
        self.root.at(&|_| t)
    }
}
