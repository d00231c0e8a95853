use std::collections::HashSet;
use std::sync::OnceLock;

use ancf_mechanics::functions::InputSignal;
use ancf_solver::equations::State;
use ancf_solver::newton::Interrupt;

use super::end_conditions::unknown_values;
use crate::assembly::Assembly;
use crate::diagnosis::model_warnings;
use crate::errors::{ModelError, ModelErrors, quoted};
use crate::estimate::HalvedModel;
use crate::initial::{GivenState, StartState};
use crate::joints::{CustomJoint, Joint, JointKind};
use crate::loads::{CustomLoad, Load, LoadKind};
use crate::model::{Analysis, Model, Section, SectionObject, Statics};
use crate::reading::ValidModel;
use crate::results::{Column, counted_angles};
use crate::units::{ChosenScales, Scales};

/// Assembled model, ready to run.
#[derive(Debug)]
pub struct Simulation {
    pub(crate) scaled: Model,
    pub(crate) chosen: ChosenScales,
    pub(crate) assembly: Assembly,
    /// Signals of the inputs, in the order of the model.
    pub(crate) inputs: Vec<InputSignal>,
    pub(crate) interrupt: Interrupt,
    /// Warnings that follow from the model.
    pub(crate) warnings: Vec<String>,
    /// Finer model, by which the errors of a motion with shells are estimated.
    halved: OnceLock<Option<Result<HalvedModel, String>>>,
}

impl Simulation {
    /// Checks, scales and assembles a model.
    ///
    /// # Errors
    /// All errors of the model.
    pub fn new(model: &Model) -> Result<Self, ModelErrors> {
        model.check()?;
        Self::of_checked(model)
    }

    /// Scales and assembles a valid model.
    ///
    /// # Errors
    /// Errors that depend on the assembled equations, such as gaps that cannot be closed.
    pub fn of_valid(model: &ValidModel) -> Result<Self, ModelErrors> {
        Self::of_checked(model)
    }

    fn of_checked(model: &Model) -> Result<Self, ModelErrors> {
        let chosen = model.scales();
        let mut scaled = model.scaled(&chosen.scales);
        let inputs = scaled.connect_inputs();
        let assembly = scaled.assemble_scaled()?;
        let repeated = repeated_columns(&assembly);
        if !repeated.is_empty() {
            return Err(ModelErrors(repeated));
        }
        let (interrupt, mut warnings) = (Interrupt::default(), assembly.undetermined_friction());
        warnings.extend(model_warnings(model));
        let halved = OnceLock::new();
        let simulation = Self { scaled, chosen, assembly, inputs, interrupt, warnings, halved };
        let columns = simulation.columns();
        let equal = equal_columns(&columns);
        if !equal.is_empty() {
            return Err(ModelErrors(equal));
        }
        let unknown = unknown_values(model, &columns);
        if unknown.is_empty() { Ok(simulation) } else { Err(ModelErrors(unknown)) }
    }

    /// Sets the interrupt flag that stops a run. Its outcome is then [`Outcome::Stopped`](crate::Outcome::Stopped).
    #[must_use]
    pub fn with_interrupt(self, interrupt: Interrupt) -> Self {
        Self { interrupt, ..self }
    }

    /// Equations of motion of the model.
    pub fn assembly(&self) -> &Assembly {
        &self.assembly
    }

    /// State of this simulation in the user's units, from which a simulation of the same structure can start. `source` describes
    /// it, for messages and reports.
    ///
    /// Its velocities satisfy the constraints of this simulation, without the error of its time steps. A simulation with the same joints
    /// thus starts without impulses.
    pub fn given_state(&self, state: &State, source: impl Into<String>) -> GivenState {
        let consistent = self.without_velocity_error(state);
        let state = consistent.as_ref().unwrap_or(state);
        GivenState::new(&self.assembly, self.scales(), state, source.into())
    }

    /// State of a motion without the error of its time steps in the velocities along constraints. `None` if there is none.
    pub(crate) fn without_velocity_error(&self, state: &State) -> Option<State> {
        let motion = self.scaled.analysis.dynamics()?;
        let step = motion.step.typical(motion.duration);
        self.assembly.without_velocity_error(state, motion.scheme.numbers(), step)
    }

    /// Columns of angles whose turns are counted during a run, since a state does not contain them.
    pub fn counted_angles(&self) -> Vec<String> {
        counted_angles(&self.assembly)
    }

    /// Start of this simulation in a given state.
    ///
    /// # Errors
    /// If the state belongs to another structure, or cannot be released because the load factor of statics is 0.
    pub fn start_from(&self, given: &GivenState) -> Result<StartState, ModelErrors> {
        if matches!(&self.scaled.analysis, Analysis::Statics(own) if own.load == 0.0) {
            return Err(ModelErrors(vec![ModelError::new("analysis.load", "0", Statics::RELEASING)]));
        }
        let state = given.state(&self.assembly, self.scales())?;
        Ok(StartState { state, source: given.source().to_owned(), angles: given.angles().to_vec() })
    }

    /// Model with elements of half the size, or the reason for which there is none, if the errors of a model with shells are to be
    /// estimated.
    pub(super) fn halved(&self) -> Option<&Result<HalvedModel, String>> {
        self.halved.get_or_init(|| HalvedModel::requested(&self.scaled)).as_ref()
    }

    /// Units in which the equations are solved.
    pub fn scales(&self) -> Scales {
        self.chosen.scales
    }

    /// Gradient of the warping function of a section of a flexible body at an arc length and at (y, z) of the section, in solver units.
    pub fn warping_gradient(&self, body: usize, s: f64, at: [f64; 2]) -> [f64; 2] {
        self.scaled.warping_gradient(&self.scaled.bodies[body], s, at)
    }

    /// True if the velocities of the states are shapes of modes or critical loads.
    pub fn has_shapes(&self) -> bool {
        self.scaled.analysis.has_shapes()
    }

    /// True if stresses also depend on velocities: a material has a retardation time.
    pub fn has_damped_strains(&self) -> bool {
        self.scaled.materials.values().any(|material| material.damping.has_retardation())
    }
}

/// Finds joints that record two coordinates under the same name.
fn repeated_columns(assembly: &Assembly) -> Vec<ModelError> {
    let columns: Vec<_> =
        assembly.joint_coordinates().map(|(joint, own)| (joint, own.columns()[0])).collect();
    let repeated = columns.windows(2).filter(|pair| pair[0] == pair[1]).map(|pair| pair[0]);
    repeated
        .map(|(joint, column)| {
            let found = format!("two coordinates `{column}` of joint {}", quoted(joint));
            ModelError::new("joints", found, "at most one of a name")
        })
        .collect()
}

/// Finds columns of the results with equal names, such as that of a state of a force law and that of a reaction.
fn equal_columns(columns: &[Column]) -> Vec<ModelError> {
    let mut names = HashSet::new();
    let equal = columns.iter().filter(|column| !names.insert(column.name.as_str()));
    let error = |column: &Column| {
        let found = format!("two columns {} of the results", quoted(&column.name));
        let expected = "different names of joints, states of force laws, probes, gases and bodies";
        ModelError::new("output", found, expected)
    };
    equal.map(error).collect()
}

/// Part of a user-defined kind that a program adds to a model.
#[derive(Clone, Debug)]
pub enum Extension {
    /// A joint.
    Joint(CustomJoint),
    /// A load.
    Load(CustomLoad),
    /// A section under its name.
    Section(String, Section),
}

impl Extension {
    /// Joint of a user-defined kind.
    pub fn joint(joint: impl JointKind + 'static) -> Self {
        Self::Joint(CustomJoint::new(joint))
    }

    /// Load of a user-defined kind.
    pub fn load(load: impl LoadKind + 'static) -> Self {
        Self::Load(CustomLoad::new(load))
    }

    /// A section of a kind of the program's own, under the name by which bodies refer to it.
    pub fn section(name: &str, section: impl SectionObject) -> Self {
        Self::Section(name.to_owned(), Section::custom(section))
    }
}

/// Builder of a [`Simulation`] with parts of user-defined kinds.
///
/// Added parts are checked, converted into solver units and assembled after those of the model. The model file in a results
/// folder does not contain them.
#[derive(Clone, Debug)]
pub struct SimulationBuilder {
    model: Model,
    interrupt: Interrupt,
}

impl SimulationBuilder {
    /// Creates a builder for a model.
    pub fn new(model: &Model) -> Self {
        Self { model: model.clone(), interrupt: Interrupt::default() }
    }

    /// Adds a part. A section replaces that of the same name, which a model file states for its bodies.
    #[must_use]
    pub fn with(mut self, extension: Extension) -> Self {
        match extension {
            Extension::Joint(joint) => self.model.joints.push(Joint::Custom(joint)),
            Extension::Load(load) => self.model.loads.push(Load::Custom(load)),
            Extension::Section(name, section) => {
                self.model.sections.insert(name, section);
            }
        }
        self
    }

    /// Sets the interrupt flag that stops a run.
    #[must_use]
    pub fn with_interrupt(mut self, interrupt: Interrupt) -> Self {
        self.interrupt = interrupt;
        self
    }

    /// Checks, scales and assembles the model.
    ///
    /// # Errors
    /// All errors of the model and of its added parts.
    pub fn build(self) -> Result<Simulation, ModelErrors> {
        Ok(Simulation::new(&self.model)?.with_interrupt(self.interrupt))
    }
}

impl Simulation {
    /// Creates a builder that accepts parts of user-defined kinds.
    pub fn builder(model: &Model) -> SimulationBuilder {
        SimulationBuilder::new(model)
    }
}
