use ancf_solver::equations::EquationsOfMotion;
use toml::Value;

use super::differences::DifferencePair;
use super::error::GradientError;
use super::parameter::ModelNumber;
use crate::assembly::Assembly;
use crate::errors::{ModelError, ModelErrors};
use crate::units::Scales;

/// Number of distances from the number, and the ratio of the next one.
const LEVELS: usize = 5;
const RATIO: f64 = 0.5;
/// Number of larger distances that may be inadmissible, such as a Poisson's ratio above 0.5.
const INADMISSIBLE: i32 = 8;

/// Equations of a model for changed numbers, in the units of the given model.
pub(super) struct VariedModels {
    /// Distances h with the equations at h and −h, the largest one first.
    levels: Vec<(f64, [Assembly; 2])>,
}

impl VariedModels {
    /// Assembles the equations.
    ///
    /// # Errors
    /// If models on both sides of the number are not valid, or have other equations.
    pub(super) fn new(
        data: &Value,
        number: &ModelNumber,
        (scales, given): (&Scales, &Assembly),
    ) -> Result<Self, GradientError> {
        let assembled = |by: f64| -> Result<Assembly, ModelErrors> {
            let mut scaled = number.varied(data, by)?.scaled(scales);
            scaled.connect_inputs();
            scaled.assemble_scaled().map_err(|errors| number.of_changed(errors, by))
        };
        let (mut levels, mut invalid) = (Vec::new(), None);
        for level in 0..LEVELS as i32 + INADMISSIBLE {
            // A change that the floating-point number resolves.
            let h = (number.value + number.largest * RATIO.powi(level)) - number.value;
            if h == 0.0 {
                break;
            }
            match assembled(h).and_then(|after| Ok([after, assembled(-h)?])) {
                Ok(pair) => levels.push((h, pair)),
                Err(errors) if number.is_out_of_range(&errors) => invalid = Some(errors),
                Err(errors) => return Err(errors.into()),
            }
            if levels.len() == LEVELS {
                break;
            }
        }
        if levels.len() < LEVELS {
            return Err(invalid.map_or_else(|| too_small(number), Into::into));
        }
        let size = |assembly: &Assembly| (assembly.system.coordinates(), assembly.system.multipliers());
        let is_other = |(_, pair): &(f64, [Assembly; 2])| pair.iter().any(|own| size(own) != size(given));
        if levels.iter().any(is_other) {
            let path = &number.path;
            return Err(GradientError::failed(format!("the number of equations depends on `{path}`")));
        }
        Ok(Self { levels })
    }

    /// Evaluates functions of the equations and the change h.
    pub(super) fn pairs(&self, mut of: impl FnMut(&Assembly, f64) -> Vec<f64>) -> Vec<DifferencePair> {
        let mut pair = |(step, [after, before]): &(f64, [Assembly; 2])| DifferencePair {
            step: *step,
            values: [of(after, *step), of(before, -step)],
        };
        self.levels.iter().map(&mut pair).collect()
    }
}

fn too_small(number: &ModelNumber) -> GradientError {
    let found = format!("the size {:e} of its change, which the number does not resolve", number.largest);
    ModelErrors(vec![ModelError::new(&number.path, found, "a larger size")]).into()
}
