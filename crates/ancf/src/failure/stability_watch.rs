//! Looks at the stability of a motion now and then: columns that buckle are told, though the motion goes on.

use ancf_solver::equations::State;
use serde::{Deserialize, Serialize};

use super::stability::{Instability, instability, is_held};
use crate::assembly::Assembly;
use crate::model::{Body, Model};
use crate::units::Scales;

/// Looks are so many steps apart, which keeps their cost at a few percent of that of the steps,
const STEPS: u64 = 50;
/// and no more than so many in a duration.
const LOOKS: f64 = 32.0;
/// Shapes that are unstable at one look only are those of vibrations.
const PERSISTENT: u32 = 2;

/// The looks so far.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(crate) struct Watch {
    /// No look before this time and this number of steps.
    next: (f64, u64),
    /// Whether there is anything to look at, once it is known.
    held: Option<bool>,
    /// The time between looks.
    interval: f64,
    /// The present instability: at how many looks in a row, since when, and what it was first.
    present: Option<(u32, f64, Instability)>,
    /// The first that lasted, and when it was over.
    told: Option<(f64, Option<f64>, Instability)>,
}

impl Watch {
    /// Over a motion of a model with beams; of others nothing is asked.
    pub(crate) fn over(model: &Model) -> Self {
        let beams = model.bodies.iter().any(|body| matches!(body, Body::Beam(_)));
        let duration = model.analysis.dynamics().filter(|_| beams).map_or(f64::INFINITY, |own| own.duration);
        let interval = duration / LOOKS;
        Self { next: (interval, STEPS), interval, ..Self::default() }
    }

    /// Whether what was seen is of a system with so many coordinates.
    pub(crate) fn fits(&self, coordinates: usize) -> bool {
        let seen = [self.present.map(|(_, _, seen)| seen), self.told.map(|(_, _, seen)| seen)];
        seen.iter().flatten().all(|seen| seen.at < coordinates)
    }

    fn note(&mut self, t: f64, found: Option<Instability>) {
        let Some(found) = found else {
            if let Some((_, over @ None, _)) = &mut self.told {
                *over = Some(t);
            }
            self.present = None;
            return;
        };
        let (looks, since, first) =
            self.present.map_or((1, t, found), |(n, since, first)| (n + 1, since, first));
        self.present = Some((looks, since, first));
        if looks == PERSISTENT && self.told.is_none() {
            self.told = Some((since, None, first));
        }
    }
}

impl Watch {
    /// Examines the stability of a state of a motion after a number of steps, if an examination is due.
    pub(crate) fn look(&mut self, assembly: &Assembly, s: &State, steps: u64) {
        let (time, step) = self.next;
        if s.t < time || steps < step {
            return;
        }
        if !*self.held.get_or_insert_with(|| is_held(assembly)) {
            self.next.1 = u64::MAX;
            return;
        }
        self.next = (s.t + self.interval, steps + STEPS);
        let found = instability(assembly, s).filter(|found| is_on_beam(assembly, found.at));
        self.note(s.t, found);
    }

    /// The instability that was found, as a warning.
    pub(crate) fn warning(&self, assembly: &Assembly, scales: Scales) -> Option<String> {
        let (since, over, seen) = self.told?;
        let until = over.map_or(String::new(), |over| format!(" to t = {:.4}", over * scales.time));
        let place = assembly.name_in(seen.at, scales.length);
        let directions = seen.directions();
        Some(format!(
            "from about t = {:.4}{until} the shape was unstable in {directions} under its loads, most at {place}: it buckles; \
             a small imperfection or side load decides when and which way",
            since * scales.time
        ))
    }
}

/// True if a coordinate belongs to a body with significant bending stiffness; slack cables are not reported.
fn is_on_beam(assembly: &Assembly, coordinate: usize) -> bool {
    let owner = assembly.bodies().find(|(_, body)| body.locate_coordinate(coordinate).is_some());
    owner.and_then(|(_, body)| body.mesh()).is_some_and(|mesh| mesh.has_sections())
}
