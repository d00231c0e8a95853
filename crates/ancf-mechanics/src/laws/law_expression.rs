use std::sync::Arc;

use super::force_law::{ForceLaw, LawState, LawValue};
use crate::functions::{
    Expression, ExpressionError, Function, InputSignal, Jet, Operand as _, SyntaxNode, is_reserved, parse,
};

/// Force law by a formula in time, coordinate, rate and inputs, with exact derivatives by dual numbers.
#[derive(Clone, Debug)]
pub struct LawExpression {
    root: SyntaxNode,
    /// Added to x for the variable of absolute position.
    origin: f64,
    /// Value of t after one unit of time of the inputs.
    unit_of_time: f64,
    inputs: Vec<InputSignal>,
    autonomous: bool,
    has_rate: bool,
}

/// Names of the variables of a formula of a force law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LawVariables {
    /// Second name of the coordinate x, such as `angle`; or the name of the absolute position, such as `length`.
    pub position: &'static str,
    /// Second name of the rate v.
    pub rate: &'static str,
}

/// Numbers of the variables in the list of names; inputs follow.
const TIME: usize = 0;
const COORDINATE: usize = 1;
const POSITION: usize = 2;
const RATES: [usize; 2] = [3, 4];
const INPUTS: usize = 5;

impl LawVariables {
    /// Names without inputs.
    pub const fn names(&self) -> [&'static str; INPUTS] {
        ["t", "x", self.position, "v", self.rate]
    }
}

impl LawExpression {
    /// Parses a formula with inputs.
    ///
    /// # Errors
    /// If the formula is invalid. The error contains the position and the expected input.
    pub fn parse(
        text: &str,
        variables: &LawVariables,
        inputs: &[(String, InputSignal)],
    ) -> Result<Self, ExpressionError> {
        let mut names = variables.names().to_vec();
        names.extend(inputs.iter().map(|(name, _)| name.as_str()));
        let root = parse(text, &names)?;
        let varies = (INPUTS..names.len()).any(|input| root.contains(input)) || root.contains(TIME);
        let has_rate = RATES.iter().any(|&rate| root.contains(rate));
        let inputs = inputs.iter().map(|(_, signal)| signal.clone()).collect();
        Ok(Self { root, origin: 0.0, unit_of_time: 1.0, inputs, autonomous: !varies, has_rate })
    }

    /// Sets the value of the variable of absolute position at x = 0.
    #[must_use]
    pub fn with_origin(self, origin: f64) -> Self {
        Self { origin, ..self }
    }

    /// Sets the value of t after one unit of time of the inputs; 1 by default.
    #[must_use]
    pub fn with_unit_of_time(self, unit_of_time: f64) -> Self {
        Self { unit_of_time, ..self }
    }

    /// True if the formula contains the time.
    pub fn contains_time(&self) -> bool {
        self.root.contains(TIME)
    }

    /// Returns the force as a function of the time of the model, for x = v = 1 and the inputs at time 0; `None` if the formula does not
    /// contain the time. It shows when the force varies, not by how much.
    pub fn function_of_time(&self) -> Option<Function> {
        let value = |variable| match variable {
            TIME => None,
            POSITION => Some(1.0 + self.origin),
            INPUTS.. => Some(self.inputs[variable - INPUTS].at(0.0).value),
            _ => Some(1.0),
        };
        let formula = Arc::new(Expression::of(self.root.with_values(&value)));
        self.contains_time().then_some(Function::Expression { formula, unit: self.unit_of_time })
    }

    /// True if the formula contains the input with a number.
    pub fn contains_input(&self, number: usize) -> bool {
        self.root.contains(INPUTS + number)
    }

    /// Returns value and derivative along x or v.
    fn along(&self, LawState { t, x, v }: LawState, [of_x, of_v]: [f64; 2]) -> Jet {
        self.root.at(&|variable| match variable {
            TIME => Jet::number(t),
            COORDINATE => Jet::new(x, of_x, 0.0),
            POSITION => Jet::new(x + self.origin, of_x, 0.0),
            INPUTS.. => Jet::number(self.inputs[variable - INPUTS].at(t / self.unit_of_time).value),
            _ => Jet::new(v, of_v, 0.0),
        })
    }
}

impl ForceLaw for LawExpression {
    fn at(&self, state: LawState) -> LawValue {
        let along_x = self.along(state, [1.0, 0.0]);
        let by_rate = if self.has_rate { self.along(state, [0.0, 1.0]).v1 } else { 0.0 };
        LawValue { force: along_x.re, by_position: along_x.v1, by_rate }
    }

    fn is_autonomous(&self) -> bool {
        self.autonomous
    }
}

/// True if a name of an input has another meaning in formulas of force laws.
pub fn is_law_name(name: &str, variables: &LawVariables) -> bool {
    variables.names().contains(&name) || is_reserved(name)
}
