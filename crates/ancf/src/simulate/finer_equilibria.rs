use std::ops::ControlFlow;

use ancf_solver::equations::{State, System};
use ancf_solver::newton::Interrupt;
use ancf_solver::statics::LoadStepper;

use super::run::finer_failure;
use crate::assembly::Assembly;
use crate::estimate::{DiscretisationErrors, GIVEN_START, HalvedModel, MeshComparison};
use crate::failure::{RunFailure, require_support, unloaded};
use crate::initial::{equilibrium_failure, load_stepper};
use crate::model::{Model, Statics};
use crate::units::Scales;

/// Equilibria of a model with shells on a mesh with elements of half the size, at the same load factors.
pub(super) struct FinerEquilibria<'a> {
    comparison: MeshComparison<'a>,
    finer: Result<FinerStatics<'a>, String>,
    /// Last load factor and the errors there.
    last: Option<(f64, DiscretisationErrors)>,
}

struct FinerStatics<'a> {
    halved: &'a HalvedModel,
    statics: LoadStepper<'a, System>,
}

impl<'a> FinerEquilibria<'a> {
    /// Starts in the undeformed state. `is_given` is true if the analysis starts in another state.
    pub(super) fn new(
        (model, assembly, scales): (&'a Model, &'a Assembly, Scales),
        halved: &'a Result<HalvedModel, String>,
        (settings, is_given): (&Statics, bool),
        interrupt: &Interrupt,
    ) -> Self {
        let comparison = MeshComparison::new(model, assembly, scales);
        let finer = match (comparison.obstacle(), halved) {
            (Some(reason), _) => Err(reason.to_owned()),
            _ if is_given => Err(GIVEN_START.into()),
            (None, Err(reason)) => Err(reason.clone()),
            (None, Ok(halved)) => FinerStatics::new(halved, scales, settings, interrupt),
        };
        Self { comparison, finer, last: None }
    }

    /// Estimates the errors of an equilibrium. Load factors are those of consecutive equilibria.
    pub(super) fn compare(&mut self, given: &State) -> DiscretisationErrors {
        if let Some((load, errors)) = &self.last
            && *load == given.load
        {
            return errors.clone();
        }
        let scales = self.comparison.scales();
        let found = match &mut self.finer {
            Ok(finer) => finer.advance(given.load, scales),
            Err(reason) => Err(reason.clone()),
        };
        let errors = match found {
            Ok((halved, state)) => self.comparison.equilibrium(given, halved, state),
            Err(reason) => {
                let errors = self.comparison.unknown(reason.as_str());
                self.finer = Err(reason);
                errors
            }
        };
        self.last = Some((given.load, errors.clone()));
        errors
    }
}

impl<'a> FinerStatics<'a> {
    fn new(
        halved: &'a HalvedModel,
        scales: Scales,
        settings: &Statics,
        interrupt: &Interrupt,
    ) -> Result<Self, String> {
        let assembly = &halved.assembly;
        let start = unloaded(assembly);
        let failed = |failure: RunFailure| finer_failure(failure, halved, scales);
        require_support(assembly, &start, scales).map_err(failed)?;
        // One increment for each equilibrium on the given mesh.
        let settings = Statics { first: 1.0, largest: 1.0, ..settings.clone() };
        let statics = load_stepper(&assembly.system, &settings, start, interrupt);
        let mut statics = statics.map_err(|error| failed(error.into()))?;
        statics.include_near_terms().map_err(|error| failed(error.into()))?;
        Ok(Self { halved, statics })
    }

    /// Equilibrium at a load factor.
    fn advance(&mut self, load: f64, scales: Scales) -> Result<(&'a HalvedModel, &State), String> {
        let Self { halved, statics } = self;
        if let Err(error) = statics.advance(load, |_, _| ControlFlow::Continue(())) {
            let failure = equilibrium_failure(&halved.assembly, statics.state(), error);
            return Err(finer_failure(failure, halved, scales));
        }
        Ok((*halved, statics.state()))
    }
}
