use ancf_mechanics::kinematics::Curve;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::motion::InitialMotion;
use super::rigid::{PointMass, Rigid};
use super::shape::Shape;

/// Rounding of a position along an axis, relative to its length.
pub(crate) const ON_AXIS: f64 = 1e-9;

/// A body of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Body {
    /// A beam that bends, twists, stretches and shears.
    Beam(Beam),
    /// A cable: a line that stretches and bends, equally about every axis across, and has no torsion.
    Cable(Cable),
    /// A body that does not deform.
    Rigid(Rigid),
    /// A point mass.
    Mass(PointMass),
}

impl Body {
    /// The name by which joints, loads and probes refer to the body.
    pub fn name(&self) -> &str {
        match self {
            Self::Beam(beam) => &beam.name,
            Self::Cable(cable) => &cable.name,
            Self::Rigid(rigid) => &rigid.name,
            Self::Mass(mass) => &mass.name,
        }
    }

    /// Names of section, at the start, and material of a flexible body.
    pub fn stuff(&self) -> Option<(&str, &str)> {
        match self {
            Self::Beam(beam) => Some((&beam.section, &beam.material)),
            Self::Cable(cable) => Some((&cable.section, &cable.material)),
            Self::Rigid(_) | Self::Mass(_) => None,
        }
    }

    /// Whether it is a beam or a cable.
    pub const fn is_flexible(&self) -> bool {
        matches!(self, Self::Beam(_) | Self::Cable(_))
    }

    /// How it moves at the start.
    pub const fn motion(&self) -> &InitialMotion {
        match self {
            Self::Beam(beam) => &beam.motion,
            Self::Cable(cable) => &cable.motion,
            Self::Rigid(rigid) => &rigid.motion,
            Self::Mass(mass) => &mass.motion,
        }
    }

    /// Number of elements; none of a rigid body.
    pub const fn elements(&self) -> u32 {
        match self {
            Self::Beam(beam) => beam.elements,
            Self::Cable(cable) => cable.elements,
            Self::Rigid(_) | Self::Mass(_) => 0,
        }
    }

    /// Start and end of the axis; of a rigid body, its centre.
    pub const fn span(&self) -> [[f64; 3]; 2] {
        match self {
            Self::Beam(beam) => [beam.from, beam.to],
            Self::Cable(cable) => [cable.from, cable.to],
            Self::Rigid(Rigid { center, .. }) | Self::Mass(PointMass { center, .. }) => [*center; 2],
        }
    }

    /// The axis in the reference state, with its start as the origin; `None` if there is no such curve.
    ///
    /// Seen from its start, a curve is the same wherever in the world it is.
    pub fn curve(&self) -> Option<Curve> {
        let [from, to] = self.span().map(Vector3::from);
        match self {
            Self::Beam(beam) => beam.shape.curve(from, to),
            Self::Cable(_) => Shape::Straight.curve(from, to),
            Self::Rigid(_) | Self::Mass(_) => None,
        }
    }

    /// Length of the axis; 0 if there is none.
    pub fn length(&self) -> f64 {
        self.curve().map_or(0.0, |curve| curve.length())
    }

    /// Arc length of a position on the axis.
    pub fn arc_length(&self, at: At) -> f64 {
        match at {
            At::Named(Named::Start) | At::Point(_) => 0.0,
            At::Named(Named::Center) => 0.5 * self.length(),
            At::Named(Named::End) => self.length(),
            At::Length(s) => s,
        }
    }

    /// The point of a position in the reference state; `None` if the body has no such position.
    pub fn point(&self, at: At) -> Option<Vector3<f64>> {
        let from = Vector3::from(self.span()[0]);
        match (self, at) {
            (Self::Beam(_) | Self::Cable(_), At::Named(_) | At::Length(_)) => {
                let (curve, s) = (self.curve()?, self.arc_length(at));
                (s <= curve.length() * (1.0 + ON_AXIS)).then(|| from + curve.at(s).0)
            }
            (Self::Rigid(_), At::Point(point)) => Some(Vector3::from(point)),
            (Self::Rigid(_) | Self::Mass(_), At::Named(Named::Center)) => Some(from),
            _ => None,
        }
    }

    /// Slope length ℓ, by which nodal gradients are multiplied.
    pub fn slope_length(&self) -> f64 {
        let slopes = match self {
            Self::Beam(beam) => beam.slopes,
            Self::Cable(cable) => cable.slopes,
            Self::Rigid(_) | Self::Mass(_) => Slopes::Gradient,
        };
        match slopes {
            Slopes::Gradient => 1.0,
            Slopes::Length => self.length() / f64::from(self.elements()),
        }
    }

    /// Where the section's y-axis points at the start, if that is normal to the tangent.
    pub fn up(&self) -> Option<Vector3<f64>> {
        let (_, tangent) = self.curve()?.at(0.0);
        let up = match self {
            Self::Beam(Beam { up: Some(up), .. }) => Vector3::from(*up).try_normalize(0.0)?,
            _ if tangent.y.abs() > 1.0 - 1e-6 => Vector3::z(),
            _ => Vector3::y(),
        };
        (up - tangent * tangent.dot(&up)).try_normalize(1e-9)
    }
}

/// A beam of ANCF elements.
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
    /// How the axis goes from start to end; straight by default. Free of stress.
    #[serde(default, skip_serializing_if = "Shape::is_straight")]
    pub shape: Shape,
    /// A direction that fixes the section's y-axis at the start: its part normal to the axis. Global y by default, global z
    /// for a beam along y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub up: Option<[f64; 3]>,
    /// Angle by which the section turns about the axis from start to end, in radians; free of stress.
    #[serde(default)]
    pub twist: f64,
    /// Number of elements, all of one length.
    #[schemars(range(min = 1))]
    pub elements: u32,
    /// Which element, and which of its strains are how stiff.
    #[serde(default)]
    pub formulation: Formulation,
    /// Name of the section, a key of `sections`.
    pub section: String,
    /// Name of the section at the end, of the same kind; sizes in between are interpolated linearly. The same by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section_end: Option<String>,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// What the nodal slope coordinates are.
    #[serde(default)]
    pub slopes: Slopes,
    /// How it moves at the start of a motion; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}

impl Beam {
    /// A straight beam in the continuum formulation, all else by default.
    pub fn straight(
        name: &str,
        [from, to]: [[f64; 3]; 2],
        elements: u32,
        section: &str,
        material: &str,
    ) -> Self {
        Self {
            name: name.into(),
            from,
            to,
            shape: Shape::Straight,
            up: None,
            twist: 0.0,
            elements,
            formulation: Formulation::Continuum,
            section: section.into(),
            section_end: None,
            material: material.into(),
            slopes: Slopes::Gradient,
            motion: InitialMotion::default(),
        }
    }
}

/// Which element, and which of its strains are how stiff.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Formulation {
    /// Two nodes, 24 coordinates, three-dimensional elasticity: that of Kim et al. (2017), with its locking. Bending has
    /// (λ+2G) I for E I, torsion the polar moment of area, and errors fall with 1/(3n²).
    #[default]
    Continuum,
    /// The same element with the elasticity of a rod: Poisson's effect on the axis only, shear factors, St. Venant's torsion
    /// constant (Gerstmayr, Matikainen & Mikkola 2008).
    Enhanced,
    /// The same with linked strains, which frees it from shear locking: one element is exact for end loads.
    Linked,
    /// Three nodes, 27 coordinates, with the elasticity of a rod, integrated at two points (Nachbagauer, Gruber & Gerstmayr
    /// 2013).
    Quadratic,
}

/// A cable of gradient-deficient ANCF elements: two nodes, 12 coordinates.
///
/// Source: Gerstmayr & Shabana (2006); Gerstmayr & Irschik (2008).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cable {
    /// The name by which joints, loads and probes refer to the cable.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Where the axis starts, length.
    pub from: [f64; 3],
    /// Where the axis ends, length.
    pub to: [f64; 3],
    /// Number of elements, all of one length.
    #[schemars(range(min = 1))]
    pub elements: u32,
    /// Name of the section, a key of `sections`; it bends equally about every axis across.
    pub section: String,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// What the nodal slope coordinates are.
    #[serde(default)]
    pub slopes: Slopes,
    /// How it moves at the start of a motion; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
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

/// A point of a body.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Place {
    /// Name of the body.
    pub body: String,
    /// Where on its axis, or where on a rigid body.
    pub at: At,
    /// A rigid arm from there, fixed to the section, in the global frame at the start, length; none by default.
    #[serde(default, skip_serializing_if = "is_zero")]
    pub offset: [f64; 3],
}

fn is_zero(offset: &[f64; 3]) -> bool {
    *offset == [0.0; 3]
}

impl Place {
    /// A place without an arm.
    pub fn new(body: &str, at: At) -> Self {
        Self { body: body.into(), at, offset: [0.0; 3] }
    }
}

/// A position on a body: of a beam or a cable `"start"`, `"center"`, `"end"` or the arc length from the start; of a rigid
/// body `"center"` or a point.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum At {
    /// One that has a name.
    Named(Named),
    /// Arc length from the start in the undeformed state, length.
    Length(#[schemars(extend("minimum" = 0))] f64),
    /// A point of a rigid body, where it is at the start, length.
    Point([f64; 3]),
}

/// Positions that have names.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Named {
    /// Where the axis starts.
    Start,
    /// The middle of the axis, or the centre of mass of a rigid body.
    Center,
    /// Where the axis ends.
    End,
}
