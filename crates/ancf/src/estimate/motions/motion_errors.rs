use serde::{Deserialize, Serialize};

use super::super::finer::FinerMesh;
use super::super::value_errors::ValueError;
use crate::errors::percentage;

/// Relative error above which the linear estimate states the order of magnitude.
const LARGE: f64 = 0.1;

/// Estimated errors of a motion, in the user's units.
///
/// The errors of the time steps are relative to exact integration of the same mesh. The errors of the mesh are relative to Reissner's
/// and Simo's rod from the same start. In models with shells they follow from a second motion on a finer mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MotionErrors {
    /// Errors of the probes that record a motion.
    pub probes: Vec<ProbeErrors>,
    /// False if the equations of the errors had no solution.
    pub are_steps_known: bool,
    /// False if joints act between the nodes of elements, the tension of a taut element vanished at an end, or the second motion of a
    /// model with shells failed.
    pub is_mesh_known: bool,
    /// True if the errors of the mesh are orders of magnitude: loads within elements are not known in detail, elements are strongly
    /// curved, taut elements are neither rods nor strings, or shells do not converge regularly.
    pub is_rough: bool,
    /// Number of steps in which stops, ropes, dry friction or other laws with kinks act in part, which the errors of the steps lack.
    #[serde(default)]
    pub kinked_steps: u64,
    /// Bound of the relative difference between the rod and the strains of the elements.
    pub law: f64,
    /// Second motion of a model with shells.
    #[serde(default)]
    pub finer: Option<FinerMesh>,
    /// Sum of both errors in the last recorded state. Empty if one of them is not known.
    pub values: Vec<ValueError>,
}

/// Largest errors of the position of a probe over the recorded instants.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct ProbeErrors {
    /// Name of the probe.
    pub probe: String,
    /// Largest displacement.
    pub displacement: f64,
    /// Largest error of the time steps.
    pub steps: f64,
    /// Largest error of the mesh.
    pub mesh: f64,
}

/// Displacement, relative to the largest one of all probes, below which a probe does not move.
const STILL: f64 = 1e-6;

impl MotionErrors {
    /// Probe with the largest sum of the known errors, relative to its largest displacement, and its relative errors of the time
    /// steps and of the mesh. `None` without a probe that moves.
    pub fn worst(&self) -> Option<(&ProbeErrors, [f64; 2])> {
        let largest = self.probes.iter().map(|probe| probe.displacement).fold(0.0, f64::max);
        let known = [self.are_steps_known, self.is_mesh_known];
        let relative = |probe: &ProbeErrors| {
            let [steps, mesh] = [probe.steps, probe.mesh].map(|error| error / probe.displacement);
            [if known[0] { steps } else { 0.0 }, if known[1] { mesh } else { 0.0 }]
        };
        let moving = self.probes.iter().filter(|probe| probe.displacement > STILL * largest);
        let errors = moving.map(|probe| (probe, relative(probe)));
        errors.max_by(|(_, a), (_, b)| (a[0] + a[1]).total_cmp(&(b[0] + b[1])))
    }

    /// Sentence for the end of a run.
    pub fn sentence(&self) -> String {
        let Some((probe, [steps, mesh])) = self.worst() else {
            return "errors: no probe that moves records its position".into();
        };
        let part = |is_known: bool, is_rough: bool, error: f64| match is_known {
            false => "not known".to_owned(),
            true if error > 1.0 => "more than 100 %".to_owned(),
            true if is_rough || error > LARGE => format!("about {}", percentage(error)),
            true => percentage(error),
        };
        let ending = match &self.finer {
            Some(finer) => finer.ending(true),
            None => format!("; section law within {}", percentage(self.law)),
        };
        let kinks = match self.kinked_steps {
            0 => String::new(),
            1 => " without a kink of a force law in one step".to_owned(),
            count => format!(" without the kinks of force laws in {count} steps"),
        };
        format!(
            "errors of `{}`, relative to its largest displacement: time steps {}{kinks}, mesh {}{ending}",
            probe.probe,
            part(self.are_steps_known, self.kinked_steps > 0, steps),
            part(self.is_mesh_known, self.is_rough, mesh),
        )
    }
}
