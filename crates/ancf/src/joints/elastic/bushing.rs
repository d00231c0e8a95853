use ancf_mechanics::constraints::{BilinearMeasure, TwistAngle};
use ancf_mechanics::forces::SwingSpring;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::joints::parts::{End, JointBuilder, JointKind, JointSymbol, measures};
use crate::model::{Capability, Place};
use crate::units::Scaled;

/// Bushing: springs and dampers between two coincident places, along and about three axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Bushing {
    /// Name in outputs and messages.
    #[schemars(length(min = 1))]
    pub name: String,
    /// First end, on which the reaction acts.
    pub a: Place,
    /// Second end, to which the axes are fixed; the ground by default. The axes are initially parallel to the global axes.
    #[serde(default)]
    pub b: End,
    /// Stiffnesses along x, y, z, force/length, and about x, y, z, force length. The rotation is a twist about the axis of least
    /// stiffness, of any number of turns, and a swing of this axis. The moments are linear in it.
    #[unit([force / length; 3], [force * length / radian; 3])]
    pub stiffness: [f64; 6],
    /// Dampings along x, y, z, force time/length, and about x, y, z, force length time; none by default.
    #[unit([force * time / length; 3], [force * length * time / radian; 3])]
    #[serde(default)]
    pub damping: [f64; 6],
}

impl JointKind for Bushing {
    fn word(&self) -> &'static str {
        "bushing"
    }

    fn name(&self) -> &str {
        &self.name
    }

    fn ends(&self) -> (&Place, &End) {
        (&self.a, &self.b)
    }

    fn removes(&self) -> usize {
        0
    }

    fn build(&self, builder: &mut JointBuilder<'_>) {
        for (k, measure) in measures::displacements(builder.a(), builder.b()).into_iter().enumerate() {
            if self.acts(k) {
                builder.spring(measure, self.stiffness[k], self.damping[k]);
            }
        }
        self.build_rotation(builder);
    }

    fn needs(&self) -> [Option<(Capability, &'static str)>; 2] {
        [Some((Capability::Section, "a bushing")); 2]
    }

    fn symbol(&self) -> JointSymbol {
        JointSymbol::Line("bushing")
    }
}

impl Bushing {
    /// True if there is a spring or a damper along or about an axis.
    fn acts(&self, k: usize) -> bool {
        self.stiffness[k] > 0.0 || self.damping[k] > 0.0
    }

    /// Number of the axis of twist: the one with the least stiffness against rotation, and of equal ones the first.
    pub fn twist_axis(&self) -> usize {
        let [x, y, z]: [f64; 3] = [3, 4, 5].map(|k| self.stiffness[k]);
        if x <= y && x <= z { 0 } else { 1 + usize::from(z < y) }
    }

    /// Adds springs and dampers of the twist about one axis and of its swing about the other two.
    fn build_rotation(&self, builder: &mut JointBuilder<'_>) {
        let (a, b, axis) = (builder.a(), builder.b(), self.twist_axis());
        let numbers = [0, 1, 2].map(|k| (axis + k) % 3);
        let axes = [Vector3::x(), Vector3::y(), Vector3::z()];
        let [e, u, v] = numbers.map(|k| axes[k]);
        let [twist, swing @ ..] = numbers.map(|k| k + 3);
        if self.acts(twist) {
            let (own, multiplier) = (builder.coordinate(), builder.multipliers(1));
            let directions = [a, b].map(|end| [u, v].map(|axis| end.direction(axis)));
            let [own_directions, other_directions] = directions;
            builder.add(TwistAngle::new(own, own_directions, other_directions, multiplier));
            let measure = BilinearMeasure::coordinate(own);
            builder.spring(measure, self.stiffness[twist], self.damping[twist]);
        }
        if swing.iter().any(|&k| self.acts(k)) {
            let [stiffness, damping] = [self.stiffness, self.damping].map(|all| swing.map(|k| all[k]));
            builder.add(SwingSpring::new(measures::swing(a, b, [e, u, v]), stiffness, damping));
        }
    }
}
