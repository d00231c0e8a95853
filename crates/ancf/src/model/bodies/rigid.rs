use nalgebra::Matrix3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::display::DisplayShape;
use super::parts::InitialMotion;
use super::surface::BodySurface;
use crate::units::Scaled;

/// Rigid body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Rigid {
    /// Name of the body in joints, loads and probes.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Centre of mass at the start, length.
    #[unit(length)]
    pub center: [f64; 3],
    /// Mass, force time²/length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(mass)]
    pub mass: f64,
    /// Moments of inertia `[xx, yy, zz]` about the centre along the global axes at the start, mass length².
    #[unit(mass * length^2)]
    pub inertia: [f64; 3],
    /// Off-diagonal entries `[xy, xz, yz]` of the inertia tensor, mass length²; zero by default.
    #[serde(default)]
    #[unit(mass * length^2)]
    pub products: [f64; 3],
    /// Surface in contacts with obstacles; none by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<BodySurface>,
    /// Shapes of the body in pictures; by default its contact surface, or a box with its inertia.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub display: Vec<DisplayShape>,
    /// Initial velocities in dynamics; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}

impl Rigid {
    /// Inertia tensor about the centre of mass.
    pub fn tensor(&self) -> Matrix3<f64> {
        let ([xx, yy, zz], [xy, xz, yz]) = (self.inertia, self.products);
        Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
    }

    /// True if a display shape is the mesh of a file.
    pub fn has_mesh(&self) -> bool {
        self.display.iter().any(|shape| matches!(shape, DisplayShape::Mesh { .. }))
    }
}

/// Point mass, without orientation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct PointMass {
    /// Name of the mass in joints, loads and probes.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Position at the start, length.
    #[unit(length)]
    pub center: [f64; 3],
    /// Mass, force time²/length.
    #[schemars(extend("exclusiveMinimum" = 0))]
    #[unit(mass)]
    pub mass: f64,
    /// Surface in contacts with obstacles, a ball; none by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub surface: Option<BodySurface>,
    /// Initial velocities in dynamics; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}
