//! Results do not depend on units and on the scaling of coordinates.

use ancf::Scales;
use ancf::model::{Body, ScaleChoice, Slopes};

use super::law::{Check, EQUAL, Law, check_twin};
use crate::compare::Case;
use crate::random::Random;
use crate::run::Run;

/// Model in other units of length, time and force.
pub(super) struct UnitsOfModel;

impl Law for UnitsOfModel {
    fn name(&self) -> &'static str {
        "units"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        let mut unit = || random.spread(1e-3, 1e3);
        let scales = Scales { length: unit(), time: unit(), force: unit() };
        let back = |run: &mut Run| {
            for column in &mut run.columns {
                let unit = column.dimension.map_or(1.0, |dimension| scales.unit(dimension));
                column.values.iter_mut().for_each(|x| *x *= unit);
            }
        };
        check_twin(self.name(), case, Some(case.model.scaled(&scales)), back, EQUAL)
    }
}

/// Equations in other units.
pub(super) struct UnitsOfSolver;

impl Law for UnitsOfSolver {
    fn name(&self) -> &'static str {
        "scales"
    }

    fn check(&self, case: &Case, random: &mut Random) -> Check {
        let mut twin = case.model.clone();
        twin.scales = if random.chance(0.5) {
            ScaleChoice::Auto
        } else {
            let mut unit = || random.spread(1e-2, 1e2);
            ScaleChoice::Given { length: unit(), force: unit(), time: Some(unit()) }
        };
        check_twin(self.name(), case, Some(twin), |_| {}, EQUAL)
    }
}

/// Other definition of the slope coordinates.
pub(super) struct SlopeCoordinates;

impl Law for SlopeCoordinates {
    fn name(&self) -> &'static str {
        "slopes"
    }

    fn check(&self, case: &Case, _: &mut Random) -> Check {
        let mut twin = case.model.clone();
        let mut is_flexible = false;
        for body in &mut twin.bodies {
            let slopes = match body {
                Body::Beam(beam) => &mut beam.slopes,
                Body::Cable(cable) => &mut cable.slopes,
                Body::Shell(_) | Body::ShearShell(_) | Body::Rigid(_) | Body::Mass(_) => continue,
            };
            *slopes = if *slopes == Slopes::Gradient { Slopes::Length } else { Slopes::Gradient };
            is_flexible = true;
        }
        check_twin(self.name(), case, is_flexible.then_some(twin), |_| {}, EQUAL)
    }
}
