use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::bodies::Place;

/// A place where motion, section forces, strain or stress are recorded.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name in the outputs: the columns are `name.x`, `name.vx`, `name.ax` and so on.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The place on the axis.
    pub on: Place,
    /// Coordinates (y, z) of the point in the section, lengths; on the axis by default.
    #[serde(default)]
    pub offset: [f64; 2],
    /// What is recorded; the motion by default.
    #[serde(default = "Probe::motion")]
    #[schemars(length(min = 1))]
    pub record: Vec<Quantity>,
}

impl Probe {
    /// A probe of the motion of a point on the axis.
    pub fn of_motion(name: &str, on: Place) -> Self {
        Self { name: name.into(), on, offset: [0.0; 2], record: Self::motion() }
    }

    fn motion() -> Vec<Quantity> {
        vec![Quantity::Motion]
    }
}

/// What a probe records.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Quantity {
    /// Position, velocity and acceleration of the point.
    Motion,
    /// Euler parameters of the rotation of the section or the rigid body since the undeformed state, and its angular velocity
    /// in the global frame: `e0`, `e1`, `e2`, `e3`, `wx`, `wy`, `wz`.
    Rotation,
    /// Axial force, shear forces, torque and bending moments of the section, as the part beyond exerts them on the part before,
    /// in the frame of the section: `N`, `Qy`, `Qz`, `T`, `My`, `Mz`.
    SectionForces,
    /// Green's strain at the point in the frame of the section: `exx`, `eyy`, `ezz`, `exy`, `exz`, `eyz`.
    Strain,
    /// Second Piola-Kirchhoff stress at the point: `sxx` and so on.
    Stress,
}

/// What is written, and how often.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Output {
    /// Time between recorded instants, on each of which a step ends; every step is recorded if left out.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub interval: Option<f64>,
    /// Record every so many of these; the first and the last instant always are.
    #[schemars(range(min = 1))]
    pub every: u32,
    /// Record the strain energy of each body by part.
    pub energy_parts: bool,
    /// Write `probes.csv`.
    pub csv: bool,
    /// Write `results.parquet`.
    pub parquet: bool,
    /// Keep about so many states for pictures and reports, evenly spaced in time, the first and the last among them; of
    /// equilibria, modes and critical loads all, unless 0.
    pub states: u32,
}

impl Default for Output {
    fn default() -> Self {
        Self { interval: None, every: 1, energy_parts: false, csv: true, parquet: true, states: 200 }
    }
}
