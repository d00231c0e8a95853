//! Stability of the states of a dynamic analysis, examined at intervals. Buckling becomes a warning.

use ancf_solver::equations::{EquationsOfMotion, State};
use serde::{Deserialize, Serialize};

use super::stability::{Instability, instability, is_supported};
use crate::assembly::Assembly;
use crate::errors::short;
use crate::model::{Body, Model};
use crate::units::Scales;

/// Minimum number of steps between examinations. It limits their cost to a few percent of the steps.
const STEPS: u64 = 50;
/// Maximum number of examinations within the duration.
const EXAMINATIONS: f64 = 32.0;
/// Number of consecutive unstable examinations that is reported. A single one belongs to a vibration.
const PERSISTENT: u32 = 2;

/// Examinations of stability during a dynamic analysis.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct StabilityMonitor {
    /// Earliest time and number of steps of the next examination.
    next: (f64, u64),
    /// True if the model is supported; `None` before the first examination.
    supported: Option<bool>,
    /// Minimum time between examinations.
    interval: f64,
    /// Current instability: number of consecutive examinations, start time and first finding.
    current: Option<(u32, f64, Instability)>,
    /// First persistent instability: start time, end time and first finding.
    reported: Option<(f64, Option<f64>, Instability)>,
}

impl StabilityMonitor {
    /// Monitor of a dynamic analysis. Models without beams are not examined.
    pub(crate) fn new(model: &Model) -> Self {
        let beams = model.bodies.iter().any(|body| matches!(body, Body::Beam(_)));
        let duration =
            model.analysis.dynamics().filter(|_| beams).map_or(f64::INFINITY, |settings| settings.duration);
        let interval = duration / EXAMINATIONS;
        Self { next: (model.initial.start_time + interval, STEPS), interval, ..Self::default() }
    }

    /// True if the findings belong to a system with this number of coordinates.
    pub(crate) fn is_valid_for(&self, coordinates: usize) -> bool {
        let findings = [self.current.map(|(_, _, found)| found), self.reported.map(|(_, _, found)| found)];
        findings.iter().flatten().all(|found| found.at < coordinates)
    }

    /// Adds the result of an examination.
    fn add(&mut self, t: f64, found: Option<Instability>) {
        let Some(found) = found else {
            if let Some((_, end @ None, _)) = &mut self.reported {
                *end = Some(t);
            }
            self.current = None;
            return;
        };
        let (count, since, first) =
            self.current.map_or((1, t, found), |(n, since, first)| (n + 1, since, first));
        self.current = Some((count, since, first));
        if count == PERSISTENT && self.reported.is_none() {
            self.reported = Some((since, None, first));
        }
    }
}

impl StabilityMonitor {
    /// Examines the stability of a state after a number of steps, if an examination is due.
    pub(crate) fn examine(&mut self, assembly: &Assembly, s: &State, steps: u64) {
        let (time, step) = self.next;
        if s.t < time || steps < step {
            return;
        }
        if !*self.supported.get_or_insert_with(|| is_supported(assembly)) {
            self.next.1 = u64::MAX;
            return;
        }
        self.next = (s.t + self.interval, steps + STEPS);
        // Coriolis forces may stabilise a state without stiffness, such as a shaft above its critical speed.
        let is_decisive = assembly.system.skew_damping(s).is_empty();
        let found = if is_decisive { instability(assembly, s) } else { None };
        self.add(s.t, found.filter(|found| is_on_beam(assembly, found.at)));
    }

    /// Warning of the first persistent instability.
    pub(crate) fn warning(&self, assembly: &Assembly, scales: Scales) -> Option<String> {
        let (since, end, found) = self.reported?;
        let until = end.map_or(String::new(), |end| format!(" to t = {}", short(end * scales.time)));
        let place = assembly.name_in(found.at, scales.length);
        let directions = found.directions();
        Some(format!(
            "from about t = {}{until} the state was unstable in {directions} (buckling), most at {place}; a small \
             imperfection or side load determines the time and the direction of the buckling",
            short(since * scales.time)
        ))
    }
}

/// True if a coordinate belongs to a body with significant bending stiffness; slack cables are not reported.
fn is_on_beam(assembly: &Assembly, coordinate: usize) -> bool {
    let owner = assembly.bodies().find(|(_, body)| body.locate_coordinate(coordinate).is_some());
    owner.and_then(|(_, body)| body.mesh()).is_some_and(|mesh| mesh.has_sections())
}
