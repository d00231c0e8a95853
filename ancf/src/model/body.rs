use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A body of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Body {
    /// A straight beam of two-node, 24-coordinate, fully parameterised elements.
    Beam(Beam),
}

impl Body {
    /// The name by which joints, loads and probes refer to the body.
    pub fn name(&self) -> &str {
        &self.beam().name
    }

    /// The body as a beam; so far every body is one.
    pub const fn beam(&self) -> &Beam {
        match self {
            Self::Beam(beam) => beam,
        }
    }
}

/// A straight prismatic beam of two-node, 24-coordinate, fully parameterised ANCF elements.
///
/// Source: Kim et al. (2017), section 2; Yakoub & Shabana (2001); Garcia-Vallejo et al. (2007).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Beam {
    /// The name by which joints, loads and probes refer to the beam.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Where the axis starts, length.
    pub from: [f64; 3],
    /// Where the axis ends, length.
    pub to: [f64; 3],
    /// A direction that fixes the section's y-axis: its part normal to the axis. Global y by default, global z for
    /// a beam along y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<[f64; 3]>,
    /// Number of elements, all of one length.
    #[schemars(range(min = 1))]
    pub elements: u32,
    /// Name of the section, a key of `sections`.
    pub section: String,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// What the nodal slope coordinates are.
    #[serde(default)]
    pub slopes: Slopes,
}

/// What the slope coordinates of a node are: ℓ r_x, ℓ r_y, ℓ r_z.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Slopes {
    /// The gradients themselves, ℓ = 1 (Kim et al. 2017, eq. 2).
    #[default]
    Gradient,
    /// The gradients times the length of an element, ℓ = l (Kim et al. 2017, eq. 10).
    Length,
}

/// A point on the axis of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Name of the body.
    pub body: String,
    /// Where on its axis.
    pub at: At,
}

/// A position along the axis of a body: `"start"`, `"end"` or the arc length from the start.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum At {
    /// One of the two ends.
    End(AtEnd),
    /// Arc length from the start in the undeformed state, length.
    Length(#[schemars(extend("minimum" = 0))] f64),
}

/// The two ends of an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum AtEnd {
    /// Where the axis starts.
    Start,
    /// Where the axis ends.
    End,
}

impl Beam {
    /// Length of the axis.
    pub fn length(&self) -> f64 {
        (Vector3::from(self.to) - Vector3::from(self.from)).norm()
    }

    /// Length l of one element.
    pub fn element_length(&self) -> f64 {
        self.length() / f64::from(self.elements)
    }

    /// Slope length ℓ, by which nodal gradients are multiplied.
    pub fn slope_length(&self) -> f64 {
        match self.slopes {
            Slopes::Gradient => 1.0,
            Slopes::Length => self.element_length(),
        }
    }

    /// Orthonormal directions of the axis and of the section's y and z at the reference state.
    ///
    /// `None` if the beam has no length or `up` is along the axis.
    pub fn frame(&self) -> Option<[Vector3<f64>; 3]> {
        let axis = (Vector3::from(self.to) - Vector3::from(self.from)).try_normalize(0.0)?;
        let up = match self.up {
            Some(up) => Vector3::from(up).try_normalize(0.0)?,
            None if axis.y.abs() > 1.0 - 1e-6 => Vector3::z(),
            None => Vector3::y(),
        };
        let y = (up - axis * axis.dot(&up)).try_normalize(1e-9)?;
        Some([axis, y, axis.cross(&y)])
    }

    /// Arc length of a position on the axis.
    pub fn arc_length(&self, at: At) -> f64 {
        match at {
            At::End(AtEnd::Start) => 0.0,
            At::End(AtEnd::End) => self.length(),
            At::Length(s) => s,
        }
    }
}
