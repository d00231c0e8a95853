use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::units::Scaled;

/// Contact surface of a rigid body or a point mass: a ball, a box or balls about points.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(default, deny_unknown_fields)]
pub struct BodySurface {
    /// Radius of the balls, length; 0 for points and the corners of a box.
    #[unit(length)]
    #[schemars(extend("minimum" = 0))]
    pub radius: f64,
    /// Edges of a box about the centre along the global axes at the start, length. Its corners are in contact.
    #[unit(length)]
    #[serde(skip_serializing_if = "Option::is_none")]
    pub edges: Option<[f64; 3]>,
    /// Centres of the balls in the initial state, length; the centre of mass by default.
    #[unit(length)]
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<[f64; 3]>,
}

impl BodySurface {
    /// Centres of the balls in the initial state of a body with this centre of mass.
    pub(crate) fn centres(&self, centre: [f64; 3]) -> Vec<Vector3<f64>> {
        let centre = Vector3::from(centre);
        match self.edges {
            Some(edges) => (0..8)
                .map(|corner| {
                    let sign = |k: usize| if corner >> k & 1 == 0 { -0.5 } else { 0.5 };
                    centre + Vector3::from_fn(|k, _| sign(k) * edges[k])
                })
                .collect(),
            None if self.points.is_empty() => vec![centre],
            None => self.points.iter().map(|point| Vector3::from(*point)).collect(),
        }
    }

    /// Largest dimension.
    pub(crate) fn size(&self, centre: [f64; 3]) -> f64 {
        let centres = self.centres(centre);
        let pairs = centres.iter().flat_map(|a| centres.iter().map(move |b| (a - b).norm()));
        pairs.fold(0.0, f64::max) + 2.0 * self.radius
    }
}
