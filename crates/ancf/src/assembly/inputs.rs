//! Functions of the user, and the search for values that are not finite.

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::functions::{ForceFunction, Function};
use ancf_mechanics::kinematics::BodyVector;
use ancf_solver::dynamics::{TimeFunctions, UnseenVariation};
use ancf_solver::equations::State;

use crate::model::{IndexedModel, Load, Model, TimeMode, loads_of};

/// Functions of a model, with the paths of their keys.
#[derive(Debug, Default)]
pub(crate) struct Inputs {
    /// Functions of time. The flag is true for drives, whose rates are used.
    times: Vec<(String, Function, bool)>,
    /// Force laws that contain the time.
    laws: Vec<Function>,
    /// External forces with their points of application.
    forces: Vec<(String, BodyVector, ForceFunction)>,
}

/// Function with a value that is not finite.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NoNumber {
    /// Path of its key, such as `loads[0].time`.
    pub(crate) path: String,
    /// "value", "rate" or "acceleration".
    pub(crate) what: &'static str,
    /// Value that is not finite.
    pub(crate) value: f64,
}

/// Functions of time of a model for the step size control.
#[derive(Debug)]
struct StepFunctions {
    functions: Vec<Function>,
    /// Spacing of the samples of external functions.
    spacing: f64,
}

/// Number of samples of external functions over the duration.
const SAMPLES: f64 = 1000.0;

impl TimeFunctions for StepFunctions {
    fn unseen(&self, from: f64, to: f64, found: &mut Vec<UnseenVariation>) {
        let variation = |function: &Function| function.unseen_variation(from, to, self.spacing);
        let variations = self.functions.iter().filter_map(variation);
        found.extend(variations.map(|one| UnseenVariation { at: one.at, width: one.width }));
    }
}

impl Inputs {
    /// Times up to a time at which formulas jump or have a kink.
    pub(crate) fn switches(&self, until: f64) -> impl Iterator<Item = f64> + '_ {
        self.functions().flat_map(move |function| function.switches(until))
    }

    /// Functions of time, and force laws as such.
    fn functions(&self) -> impl Iterator<Item = &Function> {
        self.times.iter().map(|(_, function, _)| function).chain(&self.laws)
    }

    /// Functions of time for the step size control of a duration.
    pub(crate) fn step_functions(&self, duration: f64) -> Box<dyn TimeFunctions> {
        let functions = self.functions().cloned().collect();
        Box::new(StepFunctions { functions, spacing: duration / SAMPLES })
    }

    /// First function with a value that is not finite at the time of a state.
    pub(crate) fn no_number(&self, s: &State) -> Option<NoNumber> {
        let of_time = |(path, function, drives): &(String, Function, bool)| {
            let now = function.at(s.t);
            let all = [("value", now.value), ("rate", now.rate), ("acceleration", now.acceleration)];
            let counted = if *drives { &all[..] } else { &all[..1] };
            let (what, value) = counted.iter().copied().find(|(_, x)| !x.is_finite())?;
            Some(NoNumber { path: path.clone(), what, value })
        };
        let of_force = |(path, point, force): &(String, BodyVector, ForceFunction)| {
            let (x, v) = (point.value(s), point.velocity(s));
            let value = force.at(s.t, x.into(), v.into()).into_iter().find(|f| !f.is_finite())?;
            Some(NoNumber { path: path.clone(), what: "value", value })
        };
        self.times.iter().find_map(of_time).or_else(|| self.forces.iter().find_map(of_force))
    }
}

impl IndexedModel<'_> {
    /// Functions of an assembly of this model.
    pub(crate) fn inputs(&self, bodies: &[(String, BodyTerms)], time_mode: TimeMode) -> Inputs {
        let times = self.time_functions().into_iter();
        let times = times.map(|(path, time)| {
            let drives = path.starts_with("joints");
            (path, time_mode.function(time), drives)
        });
        let forces = loads_of(self).filter_map(|(path, load)| {
            let Load::External(external) = load else { return None };
            Some((path, self.attachment(bodies, &external.on).point, external.function(time_mode)?))
        });
        Inputs {
            times: times.filter(|(_, f, _)| !f.is_constant()).collect(),
            laws: self.laws_of_time().map(|(_, law)| law).collect(),
            forces: forces.collect(),
        }
    }
}

impl Model {
    /// Breaks of all functions of time, in ascending order: points of tables, and jumps and kinks of formulas in the duration of a
    /// motion.
    pub(crate) fn breaks(&self, time_mode: TimeMode) -> Vec<f64> {
        let until = self.end_time();
        let functions = self.time_functions().into_iter().map(|(_, time)| time_mode.function(time));
        let switches = |function: &Function| function.switches(until);
        let mut breaks: Vec<f64> =
            functions.flat_map(|function| [function.breaks(), switches(&function)].concat()).collect();
        breaks.extend(self.laws_of_time().flat_map(|(_, law)| switches(&law)));
        breaks.sort_unstable_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }
}
