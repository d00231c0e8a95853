use nalgebra::Matrix3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::motion::InitialMotion;

/// A rigid body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Rigid {
    /// The name by which joints, loads and probes refer to the body.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Centre of mass at the start, length.
    pub center: [f64; 3],
    /// Mass, force time²/length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: f64,
    /// Moments of inertia `[xx, yy, zz]` about the centre along the global axes at the start, mass length².
    pub inertia: [f64; 3],
    /// Off-diagonal entries `[xy, xz, yz]` of the same tensor; none by default.
    #[serde(default)]
    pub products: [f64; 3],
    /// How it moves at the start of a motion; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}

impl Rigid {
    /// The tensor of inertia about the centre.
    pub fn tensor(&self) -> Matrix3<f64> {
        let ([xx, yy, zz], [xy, xz, yz]) = (self.inertia, self.products);
        Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
    }
}

/// A point mass, which has no orientation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PointMass {
    /// The name by which joints, loads and probes refer to the mass.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Where it is at the start, length.
    pub center: [f64; 3],
    /// Mass, force time²/length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub mass: f64,
    /// How it moves at the start of a motion; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}
