use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::joint::Joint;
use crate::model::Model;
use crate::scaling::number;
use crate::units::{Dimension, Scales};

/// Joints that move together: the sum of their angles and displacements, times factors, stays zero. Gears, racks, belts, screws.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupling {
    /// Name in messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// The joints and their factors, 63 at most.
    #[schemars(length(min = 2))]
    pub joints: Vec<Coupled>,
}

/// A joint of a coupling.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Coupled {
    /// Name of the joint.
    pub joint: String,
    /// Factor, not zero: a number for an angle, 1/length for a displacement.
    pub factor: f64,
    /// Which freedom of the joint; by default the angle, if it has one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<Freed>,
}

/// A freedom of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Freed {
    /// The angle about the axis.
    Angle,
    /// The displacement along the axis.
    Displacement,
}

impl Joint {
    /// The freedoms by which it may be coupled.
    pub(crate) const fn freedoms(&self) -> &'static [Freed] {
        match self {
            Self::Revolute { .. } => &[Freed::Angle],
            Self::Cylindrical(_) => &[Freed::Angle, Freed::Displacement],
            Self::Prismatic(_) | Self::Slide(_) => &[Freed::Displacement],
            _ => &[],
        }
    }
}

impl Model {
    /// The joint and the freedom that a part of a coupling names, if they are there.
    pub(crate) fn coupled(&self, part: &Coupled) -> Option<(usize, Freed)> {
        let joint = self.joints.iter().position(|joint| joint.name() == part.joint)?;
        let freedoms = self.joints[joint].freedoms();
        let freed = part.of.or_else(|| freedoms.first().copied())?;
        freedoms.contains(&freed).then_some((joint, freed))
    }

    /// Whether couplings name a freedom of a joint.
    pub(crate) fn is_coupled(&self, joint: usize, freed: Freed) -> bool {
        let mut parts = self.couplings.iter().flat_map(|coupling| &coupling.joints);
        parts.any(|part| self.coupled(part) == Some((joint, freed)))
    }

    /// The couplings in other units.
    pub(crate) fn scaled_couplings(&self, s: &Scales) -> Vec<Coupling> {
        let part = |part: &Coupled| {
            let of = match self.coupled(part) {
                Some((_, Freed::Displacement)) => Dimension::new(-1, 0, 0),
                _ => Dimension::NUMBER,
            };
            Coupled { factor: number(part.factor, of, s), ..part.clone() }
        };
        let joints = |coupling: &Coupling| coupling.joints.iter().map(part).collect();
        self.couplings.iter().map(|c| Coupling { name: c.name.clone(), joints: joints(c) }).collect()
    }
}
