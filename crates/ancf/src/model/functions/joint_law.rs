use std::sync::Arc;

use ancf_mechanics::functions::{ExpressionError, InputSignal};
use ancf_mechanics::laws::{
    ForceLaw, LawExpression, LawStateVariable, LawUnits, LawVariables, Resistance, StateLaw, StateLawError,
    UserForceLaw,
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::law_signal::LawSignal;
use super::law_state::LawStateEquation;
use super::time_function::TimeMode;
use crate::units::{Scaled, Scales};

/// Law of a force or moment of a joint: a formula of displacement and rate, or a function of the calling program.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum JointLaw {
    /// Formula in the coordinate x, its rate v, the time t and the names of inputs.
    Expression {
        /// Formula, such as `-4*x - 10*x^3 - 0.1*v`.
        #[schemars(length(min = 1))]
        text: String,
        /// States of first order, which the formula may contain; none by default. For coordinates of joints in motions; other
        /// analyses keep their values at the start.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        #[schemars(length(max = 8))]
        states: Vec<LawStateEquation>,
        /// Values of other parts of the model that the formulas may contain; none by default. For coordinates of joints in motions.
        #[serde(default, skip_serializing_if = "Vec::is_empty")]
        #[schemars(length(max = 8))]
        signals: Vec<LawSignal>,
        /// Units of length, time and force of the model, measured in units of the formula; equal by default.
        #[serde(default = "Scales::unit_scales", skip_serializing_if = "Scales::is_unit")]
        units: Scales,
        /// Inputs of the model with their signals in an assembled model.
        #[serde(skip)]
        #[unit(none)]
        #[schemars(skip)]
        inputs: Vec<(String, InputSignal)>,
    },
    /// External law, which the calling program supplies by name. The command line supplies none.
    External {
        /// Name by which the program supplies the law.
        #[schemars(length(min = 1))]
        name: String,
        /// True if the force depends on x and v alone. Then it has an energy; otherwise it counts as work.
        #[serde(default)]
        autonomous: bool,
        /// Units of length, time and force of the model, measured in units of the law; equal by default.
        #[serde(default = "Scales::unit_scales", skip_serializing_if = "Scales::is_unit")]
        units: Scales,
        /// Supplied law ([`Model::supply_law`](crate::model::Model::supply_law)).
        #[serde(skip)]
        #[unit(none)]
        #[schemars(skip)]
        supplied: Option<UserForceLaw>,
    },
}

/// Force or moment of a law, with its sign and its variables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LawKind {
    /// Tensile force between two points: it pulls both ends together. x is the elongation.
    Tension,
    /// Force on the first end in the direction of the displacement x.
    Force,
    /// Moment on the first end in the direction of the angle x.
    Moment,
}

/// Law in the data of a joint.
#[derive(Clone, Copy, Debug)]
pub struct LawUse<'a> {
    /// Key of the law: `"tension"`, `"force"` or `"moment"`.
    pub key: &'static str,
    /// Law.
    pub law: &'a JointLaw,
    /// Kind of the force.
    pub kind: LawKind,
}

impl LawKind {
    /// Variables of formulas.
    pub const fn variables(self) -> LawVariables {
        match self {
            Self::Tension => LawVariables { position: "length", rate: "speed" },
            Self::Force => LawVariables { position: "displacement", rate: "speed" },
            Self::Moment => LawVariables { position: "angle", rate: "rate" },
        }
    }

    /// Key of a law of this kind.
    pub const fn key(self) -> &'static str {
        match self {
            Self::Tension => "tension",
            Self::Force => "force",
            Self::Moment => "moment",
        }
    }

    const fn units(self, units: &Scales) -> LawUnits {
        let Scales { length, time, force } = *units;
        match self {
            Self::Tension | Self::Force => LawUnits { position: length, time, force },
            Self::Moment => LawUnits { position: 1.0, time, force: force * length },
        }
    }
}

impl<'a> LawUse<'a> {
    /// Law of a kind under the key of this kind.
    pub const fn new(law: &'a JointLaw, kind: LawKind) -> Self {
        Self { key: kind.key(), law, kind }
    }
}

impl JointLaw {
    /// Law by a formula.
    pub fn formula(text: &str) -> Self {
        Self::with_states(text, Vec::new())
    }

    /// Law by a formula with states of first order.
    pub fn with_states(text: &str, states: Vec<LawStateEquation>) -> Self {
        Self::with_signals(text, states, Vec::new())
    }

    /// Law by a formula with states of first order and signals.
    pub fn with_signals(text: &str, states: Vec<LawStateEquation>, signals: Vec<LawSignal>) -> Self {
        Self::Expression { text: text.into(), states, signals, units: Scales::UNIT, inputs: Vec::new() }
    }

    /// States of first order.
    pub fn states(&self) -> &[LawStateEquation] {
        if let Self::Expression { states, .. } = self { states } else { &[] }
    }

    /// Signals.
    pub fn signals(&self) -> &[LawSignal] {
        if let Self::Expression { signals, .. } = self { signals } else { &[] }
    }

    /// Units of the model, measured in units of the law.
    pub const fn units(&self) -> Scales {
        match self {
            Self::Expression { units, .. } | Self::External { units, .. } => *units,
        }
    }

    /// External law, which the calling program supplies by name.
    pub fn external(name: &str, autonomous: bool) -> Self {
        Self::External { name: name.into(), autonomous, units: Scales::UNIT, supplied: None }
    }

    /// Law of a program.
    pub fn supplied(law: UserForceLaw) -> Self {
        let autonomous = law.get().is_autonomous();
        Self::External { name: "law".into(), autonomous, units: Scales::UNIT, supplied: Some(law) }
    }

    /// Compiles a formula for a kind of force. `length` is the length at x = 0 in units of the model. Inputs of this list are
    /// constant.
    ///
    /// # Errors
    /// If the formula has a syntax error.
    pub(crate) fn expression(
        &self,
        kind: LawKind,
        length: f64,
        declared: &[(String, InputSignal)],
    ) -> Result<Option<LawExpression>, ExpressionError> {
        let Self::Expression { text, states, signals, units, inputs } = self else { return Ok(None) };
        let mut inputs = if inputs.is_empty() { declared.to_vec() } else { inputs.clone() };
        // States have their values at the start.
        inputs.extend(states.iter().map(|state| (state.name.clone(), InputSignal::new(state.start))));
        // Laws with signals exist in motions only, by `state_law`.
        inputs.extend(signals.iter().map(|signal| (signal.name.clone(), InputSignal::new(0.0))));
        let law = LawExpression::parse(text, &kind.variables(), &inputs)?;
        let origin = if kind == LawKind::Tension { length * units.length } else { 0.0 };
        Ok(Some(law.with_origin(origin).with_unit_of_time(units.time)))
    }

    /// Law with states or signals of a kind of force along a coordinate of a joint, and its units; `None` for a law without them.
    /// Inputs of this list are constant.
    ///
    /// # Errors
    /// If a formula has a syntax error.
    pub(crate) fn state_law(
        &self,
        kind: LawKind,
        declared: &[(String, InputSignal)],
    ) -> Result<Option<(StateLaw, LawUnits)>, StateLawError> {
        let Self::Expression { text, states, signals, units, inputs } = self else { return Ok(None) };
        if states.is_empty() && signals.is_empty() {
            return Ok(None);
        }
        let inputs = if inputs.is_empty() { declared } else { inputs };
        let variables = states.iter().map(|state| LawStateVariable {
            name: &state.name,
            rate: &state.rate,
            start: state.start,
        });
        let (variables, names) = (variables.collect::<Vec<_>>(), kind.variables());
        let signals: Vec<&str> = signals.iter().map(|signal| signal.name.as_str()).collect();
        let law = StateLaw::parse(text, &variables, &signals, &names, inputs)?;
        Ok(Some((law.with_unit_of_time(units.time), kind.units(units))))
    }

    /// Resistance of the law to the increase of its coordinate in an analysis. `length` is the free length of a strut, and
    /// `reference` its length in the reference state.
    pub(crate) fn resistance(
        &self,
        kind: LawKind,
        [length, reference]: [f64; 2],
        mode: TimeMode,
    ) -> Resistance {
        let (law, units): (Arc<dyn ForceLaw>, _) = match self {
            Self::Expression { units, .. } => {
                let law = self.expression(kind, length, &[]);
                let law = law.expect("the formulas of a checked model have no syntax errors");
                (Arc::new(law.expect("the law is a formula")), units)
            }
            Self::External { supplied, units, .. } => match supplied {
                Some(law) => (law.get().clone(), units),
                None => (UserForceLaw::with_derivatives(|_| Default::default(), true).get().clone(), units),
            },
        };
        let units = kind.units(units);
        let resistance = match kind {
            LawKind::Tension => Resistance::tensile(law, units, length - reference),
            LawKind::Force | LawKind::Moment => Resistance::acting(law, units),
        };
        match mode {
            TimeMode::AsGiven => resistance,
            TimeMode::AtStart | TimeMode::Zero => resistance.frozen_at(0.0),
            TimeMode::One => resistance.frozen_at(units.time),
        }
    }
}
