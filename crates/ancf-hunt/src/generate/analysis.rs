//! Analyses with steps that resolve the motion.

use serde_json::{Value, json};

use super::draft::{Draft, Task};
use crate::random::rounded;

/// Returns the analysis of a draft.
pub(super) fn choose(draft: &mut Draft) -> Value {
    let stop = match draft.random.index(4) {
        0 => json!({ "rule": "energy", "tolerance": 1e-8 }),
        _ => json!({ "rule": "energy", "tolerance": 1e-11 }),
    };
    match draft.task {
        Task::Dynamics => dynamics(draft, &stop),
        Task::Statics => {
            let first = draft.random.choose(&[1.0, 0.25, 0.1]);
            json!({ "kind": "statics", "first": first, "stop": stop })
        }
        Task::Path => {
            let (first, largest) = (draft.random.choose(&[0.05, 0.2]), draft.random.choose(&[0.2, 1.0]));
            json!({ "kind": "path", "first": first, "largest": largest, "points": 60, "stop": stop })
        }
        Task::Modes => {
            let about =
                if draft.is_free { "reference" } else { draft.random.choose(&["reference", "equilibrium"]) };
            json!({ "kind": "modes", "count": 1 + draft.random.index(6), "about": about })
        }
        Task::Buckling => {
            json!({ "kind": "buckling", "count": 1 + draft.random.index(2), "sense": draft.random.choose(&["stated", "either"]) })
        }
    }
}

fn dynamics(draft: &mut Draft, stop: &Value) -> Value {
    let step = rounded(draft.sizes.period() / draft.random.within(40.0, 120.0));
    let steps = 20 + draft.random.index(40);
    let scheme = match draft.random.index(8) {
        0 | 1 => json!("adams"),
        2 => json!("average_acceleration"),
        3 => json!({ "alpha": -0.1 }),
        4 => json!({ "spectral_radius": 0.5 }),
        _ => json!({ "spectral_radius": 0.8 }),
    };
    let newton = draft.random.choose(&["modified", "modified", "full"]);
    let is_adaptive = scheme != json!("adams") && draft.random.chance(0.08);
    let duration = rounded(step * steps as f64);
    let step = if is_adaptive { json!({ "tolerance": 1e-3, "initial": step }) } else { json!(step) };
    json!({ "kind": "dynamics", "duration": duration, "step": step, "scheme": scheme, "newton": newton, "stop": stop })
}
