//! Models of a body held by a joint.

use ancf::Model;

/// A model by its text.
pub(crate) fn model(text: &str) -> Model {
    Model::parse(text)
        .unwrap_or_else(|errors| panic!("{:#?}", errors.iter().map(ToString::to_string).collect::<Vec<_>>()))
}

/// A rigid body of mass 2 with its centre at (0.4, 0.1, −0.2), held at the origin by a joint of these keys.
pub(crate) fn body(keys: &str) -> String {
    format!(
        r#"
bodies = [{{ kind = "rigid", name = "body", center = [0.4, 0.1, -0.2], mass = 2, inertia = [0.05, 0.07, 0.06], products = [0.01, 0, 0.005] }}]
probes = [{{ name = "center", on = {{ body = "body", at = "center" }}, record = ["motion", "rotation"] }}]
[[joints]]
name = "joint"
a = {{ body = "body", at = [0, 0, 0] }}
{keys}
"#
    )
}

/// One second by generalized-α.
pub(crate) const DYNAMICS: &str =
    "[analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = { spectral_radius = 0.8 }\n";

/// Equilibrium to rounding.
pub(crate) const STATICS: &str =
    "[analysis]\nkind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-10 }\n";
