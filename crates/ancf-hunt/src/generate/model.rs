use ancf::Model;
use serde_json::{Value, json};

use super::draft::{Draft, list};
use super::{analysis, bodies, contacts, joints, loads, probes, shells};
use crate::random::Random;

/// Returns the model of a seed.
///
/// # Errors
/// If the model does not have the form of a model file: an error of this generator.
pub fn model(random: Random) -> Result<Model, String> {
    let mut draft = Draft::new(random);
    bodies::add(&mut draft);
    shells::add(&mut draft);
    joints::close(&mut draft);
    loads::add(&mut draft);
    contacts::add(&mut draft);
    probes::add(&mut draft);
    let analysis = analysis::choose(&mut draft);
    let gravity = gravity(&mut draft);
    let data = json!({
        "gravity": gravity,
        "materials": draft.materials,
        "sections": draft.sections,
        "bodies": draft.bodies,
        "joints": draft.joints,
        "couplings": draft.couplings,
        "loads": draft.loads,
        "contacts": draft.contacts,
        "probes": draft.probes,
        "analysis": analysis,
    });
    serde_json::from_value(data.clone()).map_err(|error| format!("{error}\n{data:#}"))
}

fn gravity(draft: &mut Draft) -> Value {
    let is_needed = !draft.contacts.is_empty();
    if !is_needed && draft.random.chance(0.4) {
        return json!([0.0, 0.0, 0.0]);
    }
    let magnitude = draft.random.spread(0.05, 1.0) * draft.sizes.force() / draft.sizes.mass();
    if is_needed {
        return json!([0.0, 0.0, -magnitude]);
    }
    list(&draft.vector(magnitude))
}
