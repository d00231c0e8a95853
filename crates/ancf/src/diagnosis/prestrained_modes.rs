use crate::errors::listed;
use crate::loads::Load;
use crate::model::{About, Analysis, Model};

/// Warning of modes about the undeformed state of bodies with prestrain, which they do not contain.
pub(crate) fn prestrain_warning(model: &Model) -> Option<String> {
    let Analysis::Modes(modes) = &model.analysis else { return None };
    if modes.about != About::Reference {
        return None;
    }
    let mut bodies: Vec<String> = Vec::new();
    for load in &model.loads {
        if let Load::Prestrain(_) | Load::SurfacePrestrain(_) = load {
            bodies.extend(load.kind().bodies().into_iter().map(|(_, body)| format!("`{body}`")));
        }
    }
    bodies.dedup();
    (!bodies.is_empty()).then(|| {
        format!(
            "modes about the undeformed state do not contain the prestrain of {}; `about = \"equilibrium\"` does",
            listed(bodies, "and")
        )
    })
}
