//! Model texts of one rigid body with one joint.

/// Rigid body of mass 2 with its centre at (0.4, 0.1, −0.2), held at the origin by a joint with the given keys.
pub(crate) fn jointed_body(keys: &str) -> String {
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

/// Generalized-α method over one second.
pub(crate) const DYNAMICS: &str =
    "[analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = { spectral_radius = 0.8 }\n";

/// Static equilibrium to rounding.
pub(crate) const STATICS: &str =
    "[analysis]\nkind = \"statics\"\nstop = { rule = \"energy\", tolerance = 1e-10 }\n";
