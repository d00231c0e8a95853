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

    /// Creates a formula from its syntax tree, in which t has the number 0.
    pub(crate) const fn of(root: SyntaxNode) -> Self {
        Self { root }
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

#[cfg(test)]
mod tests {
    use super::*;

    fn at(text: &str, t: f64) -> [f64; 3] {
        let FunctionValue { value, rate, acceleration } = Expression::parse(text).unwrap().at(t);
        [value, rate, acceleration]
    }

    /// Saturated tanh and powers of zero have their values and derivatives.
    #[test]
    fn formulas_are_finite_where_their_values_are() {
        assert_eq!(at("tanh(2000*(t - 0.3))", 0.7), [1.0, 0.0, 0.0]);
        assert_eq!(at("tanh(-800*t)", 1.0), [-1.0, 0.0, 0.0]);
        let slope = 1.0 - 0.3_f64.tanh().powi(2);
        let [value, rate, acceleration] = at("tanh(t)", 0.3);
        assert!((value - 0.3_f64.tanh()).abs() < 1e-15 && (rate - slope).abs() < 1e-15);
        assert!((acceleration + 2.0 * 0.3_f64.tanh() * slope).abs() < 1e-15);
        assert_eq!(at("t^2.5", 0.0), [0.0; 3]);
        assert_eq!(at("t^1.5", 0.0)[..2], [0.0; 2]);
        assert_eq!(at("t^0.5", 0.0)[0], 0.0);
        assert_eq!(at("max(t, 0)^1.5", -1.0), [0.0; 3]);
        assert_eq!(at("0^t", 2.0), [0.0; 3]);
        assert_eq!(at("sqrt(t^2)", 0.0)[..2], [0.0; 2]);
        assert_eq!(at("t^1.5", 4.0), [8.0, 3.0, 0.375]);
        assert!(at("t^1.5", -1.0)[0].is_nan());
    }
}
