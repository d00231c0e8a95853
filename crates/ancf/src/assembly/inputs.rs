//! Functions of the user at one instant: which of them is no number.

use ancf_mechanics::functions::{ForceFunction, Function};
use ancf_mechanics::kinematics::Marker;
use ancf_solver::equations::State;

use crate::model::{Load, Model, TimeMode, loads_of};

/// The functions of a model, with the paths of their keys.
#[derive(Debug, Default)]
pub(crate) struct Inputs {
    /// Functions of time; of those that drive joints, rates count too.
    times: Vec<(String, Function, bool)>,
    /// Forces that the program computes, and where they act.
    forces: Vec<(String, Marker, ForceFunction)>,
}

/// A function that is no number.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct NoNumber {
    /// The path of its key, such as `loads[0].time`.
    pub(crate) path: String,
    /// What of it is none: "value", "rate" or "acceleration".
    pub(crate) what: &'static str,
    /// What it is instead.
    pub(crate) value: f64,
}

impl Inputs {
    /// The first of the user's functions that is no number at the time of a state, if there is one.
    pub(crate) fn no_number(&self, s: &State) -> Option<NoNumber> {
        let of_time = |(path, function, drives): &(String, Function, bool)| {
            let now = function.at(s.t);
            let all = [("value", now.value), ("rate", now.rate), ("acceleration", now.acceleration)];
            let counted = if *drives { &all[..] } else { &all[..1] };
            let (what, value) = counted.iter().copied().find(|(_, x)| !x.is_finite())?;
            Some(NoNumber { path: path.clone(), what, value })
        };
        let of_force = |(path, point, force): &(String, Marker, ForceFunction)| {
            let (x, v) = (point.value(s), point.sum(&s.v));
            let value = force.at(s.t, x.into(), v.into()).into_iter().find(|f| !f.is_finite())?;
            Some(NoNumber { path: path.clone(), what: "value", value })
        };
        self.times.iter().find_map(of_time).or_else(|| self.forces.iter().find_map(of_force))
    }
}

impl Model {
    /// Functions of an assembly of this model.
    pub(crate) fn inputs(
        &self,
        bodies: &[(String, ancf_mechanics::bodies::BodyTerms)],
        time_mode: TimeMode,
    ) -> Inputs {
        let times = self.time_functions().into_iter();
        let times = times.map(|(path, time)| {
            let drives = path.starts_with("joints");
            (path, time_mode.function(time), drives)
        });
        let forces = loads_of(self).filter_map(|(path, load)| {
            let Load::External(external) = load else { return None };
            Some((path, self.attachment(bodies, &external.on).point, external.function(time_mode)?))
        });
        Inputs { times: times.filter(|(_, f, _)| !f.is_constant()).collect(), forces: forces.collect() }
    }

    /// Breaks of all functions of time, in order.
    pub(crate) fn breaks(&self, time_mode: TimeMode) -> Vec<f64> {
        let functions = self.time_functions().into_iter();
        let mut breaks: Vec<f64> =
            functions.flat_map(|(_, time)| time_mode.function(time).breaks()).collect();
        breaks.sort_unstable_by(f64::total_cmp);
        breaks.dedup();
        breaks
    }
}
