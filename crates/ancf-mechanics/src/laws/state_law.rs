use super::force_law::{LawState, LawValue};
use super::law_expression::LawVariables;
use crate::functions::{ExpressionError, InputSignal, Jet, Operand as _, SyntaxNode, parse};

/// Force law f(t, x, v, z, s) with states z of first order, dz/dt = g(t, x, v, z, s), and signals s from elsewhere, by formulas:
/// actuators, filters, controllers, hysteresis.
///
/// Formulas contain the variables of force laws, the names of inputs and those of all states and signals.
#[derive(Clone, Debug)]
pub struct StateLaw {
    force: SyntaxNode,
    rates: Vec<SyntaxNode>,
    /// Values of the states at the start.
    start: Vec<f64>,
    /// Number of signals.
    signals: usize,
    /// Value of t after one unit of time of the inputs.
    unit_of_time: f64,
    inputs: Vec<InputSignal>,
}

/// State of a force law.
#[derive(Clone, Debug, PartialEq)]
pub struct LawStateVariable<'a> {
    /// Name in formulas.
    pub name: &'a str,
    /// Formula of its rate.
    pub rate: &'a str,
    /// Value at the start.
    pub start: f64,
}

/// Error of a formula of a law with states: number of the state, `None` for the force.
pub type StateLawError = (Option<usize>, ExpressionError);

/// Numbers of the variables in the list of names; inputs and states follow.
const TIME: usize = 0;
const COORDINATES: [usize; 2] = [1, 2];
const INPUTS: usize = 5;

/// Variable along which a formula is differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Along {
    Position,
    Rate,
    /// State or signal: signals follow the states.
    State(usize),
}

impl StateLaw {
    /// Parses the formulas of the force and of the rates of the states, with the names of signals.
    ///
    /// # Errors
    /// If a formula is invalid.
    pub fn parse(
        force: &str,
        states: &[LawStateVariable<'_>],
        signals: &[&str],
        variables: &LawVariables,
        inputs: &[(String, InputSignal)],
    ) -> Result<Self, StateLawError> {
        let mut names = variables.names().to_vec();
        names.extend(inputs.iter().map(|(name, _)| name.as_str()));
        names.extend(states.iter().map(|state| state.name));
        names.extend(signals);
        let force = parse(force, &names).map_err(|error| (None, error))?;
        let rate = |(k, state): (usize, &LawStateVariable<'_>)| {
            parse(state.rate, &names).map_err(|error| (Some(k), error))
        };
        let rates = states.iter().enumerate().map(rate).collect::<Result<_, _>>()?;
        let inputs = inputs.iter().map(|(_, signal)| signal.clone()).collect();
        Ok(Self {
            force,
            rates,
            start: states.iter().map(|state| state.start).collect(),
            signals: signals.len(),
            unit_of_time: 1.0,
            inputs,
        })
    }

    /// Sets the value of t after one unit of time of the inputs; 1 by default.
    #[must_use]
    pub fn with_unit_of_time(self, unit_of_time: f64) -> Self {
        Self { unit_of_time, ..self }
    }

    /// Number of states.
    pub fn states(&self) -> usize {
        self.rates.len()
    }

    /// Number of signals.
    pub fn signals(&self) -> usize {
        self.signals
    }

    /// Values of the states at the start.
    pub fn start(&self) -> &[f64] {
        &self.start
    }

    /// True if a formula contains the input with a number.
    pub fn contains_input(&self, number: usize) -> bool {
        self.formulas().any(|formula| formula.contains(INPUTS + number))
    }

    /// True if the formula of the force contains the time.
    pub fn contains_time(&self) -> bool {
        self.force.contains(TIME)
    }

    fn formulas(&self) -> impl Iterator<Item = &SyntaxNode> {
        [&self.force].into_iter().chain(&self.rates)
    }

    fn along(&self, formula: &SyntaxNode, at: LawState, z: &[f64], along: Along) -> Jet {
        let of = |variable| f64::from(u8::from(along == variable));
        let first_state = INPUTS + self.inputs.len();
        formula.at(&|variable| match variable {
            TIME => Jet::number(at.t),
            _ if COORDINATES.contains(&variable) => Jet::new(at.x, of(Along::Position), 0.0),
            _ if variable < INPUTS => Jet::new(at.v, of(Along::Rate), 0.0),
            _ if variable < first_state => {
                Jet::number(self.inputs[variable - INPUTS].at(at.t / self.unit_of_time).value)
            }
            _ => {
                let k = variable - first_state;
                Jet::new(z[k], of(Along::State(k)), 0.0)
            }
        })
    }

    /// Force with its derivatives by x and v. `z` are the values of the states and of the signals.
    pub fn force(&self, at: LawState, z: &[f64]) -> LawValue {
        Self::derived(|along| self.along(&self.force, at, z, along))
    }

    /// Rate of the state k with its derivatives by x and v.
    pub fn rate(&self, k: usize, at: LawState, z: &[f64]) -> LawValue {
        Self::derived(|along| self.along(&self.rates[k], at, z, along))
    }

    fn derived(value: impl Fn(Along) -> Jet) -> LawValue {
        let along_x = value(Along::Position);
        LawValue { force: along_x.re, by_position: along_x.v1, by_rate: value(Along::Rate).v1 }
    }

    /// Derivative of the force by a state or a signal.
    pub fn force_by(&self, variable: usize, at: LawState, z: &[f64]) -> f64 {
        self.along(&self.force, at, z, Along::State(variable)).v1
    }

    /// Rate of the state k, and its derivative by a state or a signal.
    pub fn rate_by(&self, k: usize, variable: usize, at: LawState, z: &[f64]) -> [f64; 2] {
        let rate = self.along(&self.rates[k], at, z, Along::State(variable));
        [rate.re, rate.v1]
    }
}
