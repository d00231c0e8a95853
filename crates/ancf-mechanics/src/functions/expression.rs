use super::grammar::{ExpressionError, parse};
use super::instant::Instant;
use super::node::{Jet, Node};

/// A formula in t, with exact derivatives by dual numbers.
///
/// Operators, from loose to tight: comparisons (1 if true, 0 if not), + and −, * and /, the sign, ^. A power of a power
/// wants brackets. −t^2 is −(t²).
#[derive(Clone, Debug)]
pub struct Expression {
    root: Node,
}

impl Expression {
    /// Reads a formula.
    ///
    /// # Errors
    /// Where it is not understood, and what is wanted there.
    ///
    /// ```
    /// use ancf::function::Expression;
    ///
    /// let formula = Expression::parse("if(t < 2, t^2/4, 1)")?;
    /// assert_eq!(formula.at(1.0).value, 0.25);
    /// assert_eq!(formula.at(1.0).rate, 0.5);
    /// # Ok::<(), ancf::function::ExpressionError>(())
    /// ```
    pub fn parse(text: &str) -> Result<Self, ExpressionError> {
        Ok(Self { root: parse(text)? })
    }

    /// Its value, first and second derivative.
    pub fn at(&self, t: f64) -> Instant {
        let Jet { re, v1, v2 } = self.root.at(Jet::new(t, 1.0, 0.0));
        Instant { value: re, rate: v1, acceleration: v2 }
    }
}
