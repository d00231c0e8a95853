use nalgebra::Vector3;

use crate::functions::{ExpressionError, Jet, Operand as _, SyntaxNode, parse};

/// Formula in the place on a shell: the position x, y, z in the reference state, and the parameters u, v of a patch.
#[derive(Clone, Debug)]
pub struct PlaceFormula {
    root: SyntaxNode,
}

/// Names of the variables. A mesh has no parameters.
const NAMES: [&str; 5] = ["x", "y", "z", "u", "v"];
/// Number of the names of a mesh.
const OF_MESH: usize = 3;

impl PlaceFormula {
    /// Parses a formula. Those of a patch may contain u and v.
    ///
    /// # Errors
    /// If the formula is invalid. The error contains the position and the expected input.
    ///
    /// ```
    /// use ancf_mechanics::shells::PlaceFormula;
    /// use nalgebra::Vector3;
    ///
    /// let formula = PlaceFormula::parse("0.01*(2 - u) + x^2", true)?;
    /// assert_eq!(formula.at(&Vector3::new(3.0, 0.0, 0.0), [1.0, 0.0]), 9.01);
    /// # Ok::<(), ancf_mechanics::functions::ExpressionError>(())
    /// ```
    pub fn parse(text: &str, is_patch: bool) -> Result<Self, ExpressionError> {
        let names = if is_patch { &NAMES } else { &NAMES[..OF_MESH] };
        Ok(Self { root: parse(text, names)? })
    }

    /// Returns the value at a position with parameters. Those of a mesh are ignored.
    pub fn at(&self, position: &Vector3<f64>, parameters: [f64; 2]) -> f64 {
        let value = |variable: usize| match variable {
            OF_MESH.. => parameters[variable - OF_MESH],
            _ => position[variable],
        };
        self.root.at(&|variable| Jet::number(value(variable))).re
    }
}
