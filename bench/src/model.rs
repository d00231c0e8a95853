//! The models that are measured: the cantilever of Kim et al. (2017) and the same of cable elements.

use ancf::{Model, ModelErrors};

/// Elements of the cantilever of 1 m up to which it keeps its length; beyond, elements stay as long as then.
const DIVIDED: u32 = 100;
/// Step, s.
pub const STEP: f64 = 1e-3;

/// What a cantilever is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Two-node beam elements of 24 coordinates, in the formulation of the paper.
    Beam,
    /// Two-node cable elements of 12 coordinates.
    Cable,
}

/// A steel rod of 20 mm, clamped at one end, under its own weight from straight, followed so many steps of 1 ms.
///
/// It is 1 m long up to a hundred elements; with more it grows, since elements of a micrometre are nobody's model.
pub fn cantilever(kind: Kind, elements: u32, steps: u32) -> String {
    let length = f64::from(elements.max(DIVIDED)) / f64::from(DIVIDED);
    let duration = f64::from(steps) * STEP;
    let kind = match kind {
        Kind::Beam => "beam",
        Kind::Cable => "cable",
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
kind = "{kind}"
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
duration = {duration:?}
step = {STEP:?}
"#
    )
}

/// The same, read.
///
/// # Errors
/// If the library does not take it.
pub fn read(kind: Kind, elements: u32, steps: u32) -> Result<Model, ModelErrors> {
    Model::parse(&cantilever(kind, elements, steps))
}
