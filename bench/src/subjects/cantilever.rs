use ancf::{Model, ModelErrors};

/// Maximum number of elements of the cantilever with a length of 1 m. With more elements, the length of an element is constant.
const DIVIDED: u32 = 100;
/// Time step in seconds.
pub const STEP: f64 = 1e-3;

/// Kind of the elements of a cantilever.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CantileverKind {
    /// Two-node beam elements with 24 coordinates in the continuum formulation (Kim et al. 2017).
    Beam,
    /// Two-node cable elements with 12 coordinates.
    Cable,
}

/// Returns the model file of a cantilever under its own weight, released from the straight state, with steps of 1 ms.
///
/// It is the steel rod of Kim et al. (2017) with a diameter of 20 mm. Its length is 1 m up to 100 elements and proportional to
/// the number of elements beyond, because elements of a micrometre would not be realistic.
pub fn cantilever(kind: CantileverKind, elements: u32, steps: u32) -> String {
    let length = f64::from(elements.max(DIVIDED)) / f64::from(DIVIDED);
    let duration = f64::from(steps) * STEP;
    let kind = match kind {
        CantileverKind::Beam => "kind = \"beam\"\nformulation = \"continuum\"",
        CantileverKind::Cable => "kind = \"cable\"",
    };
    format!(
        r#"
gravity = [0.0, -9.81, 0.0]

[materials.steel]
density = 8030.0
young = 193e9
poisson = 0.0

[sections.rod]
kind = "circle"
diameter = 0.02

[[bodies]]
{kind}
name = "beam"
from = [0.0, 0.0, 0.0]
to = [{length:?}, 0.0, 0.0]
elements = {elements}
section = "rod"
material = "steel"

[[joints]]
kind = "clamp"
name = "root"
a = {{ body = "beam", at = "start" }}

[[probes]]
name = "tip"
on = {{ body = "beam", at = "end" }}

[analysis]
kind = "dynamics"
scheme = "adams"
duration = {duration:?}
step = {STEP:?}
"#
    )
}

/// Returns the model of a cantilever.
///
/// # Errors
/// If the model is invalid.
pub fn read_cantilever(kind: CantileverKind, elements: u32, steps: u32) -> Result<Model, ModelErrors> {
    Model::parse(&cantilever(kind, elements, steps))
}
