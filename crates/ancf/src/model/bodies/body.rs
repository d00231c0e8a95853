use ancf_mechanics::bodies::ShellPlace;
use ancf_mechanics::kinematics::ReferenceCurve;
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::formulation::Formulation;
use super::parts::{At, InitialMotion, NamedPosition};
use super::rigid::{PointMass, Rigid};
use super::shape::Shape;
use super::shells::{FieldShell, Layup, Membrane, ShearShell, Shell};
use super::surface::BodySurface;
use crate::units::Scaled;

/// Rounding of a position along an axis, relative to its length.
pub(crate) const ON_AXIS: f64 = 1e-9;

/// Body of the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Body {
    /// Beam with bending, torsion, axial and shear deformation.
    Beam(Beam),
    /// Cable with axial and isotropic bending deformation, without torsion.
    Cable(Cable),
    /// Thin shell or plate.
    Shell(Shell),
    /// Shear-deformable shell or plate on a mesh of quadrilaterals and triangles.
    ShearShell(ShearShell),
    /// Rigid body.
    Rigid(Rigid),
    /// Point mass.
    Mass(PointMass),
}

impl Body {
    /// Name of the body in joints, loads and probes.
    pub fn name(&self) -> &str {
        match self {
            Self::Beam(beam) => &beam.name,
            Self::Cable(cable) => &cable.name,
            Self::Shell(shell) => &shell.name,
            Self::ShearShell(shell) => &shell.name,
            Self::Rigid(rigid) => &rigid.name,
            Self::Mass(mass) => &mass.name,
        }
    }

    /// Names of the start section and of the material of a flexible body.
    pub fn section_and_material(&self) -> Option<(&str, &str)> {
        match self {
            Self::Beam(beam) => Some((&beam.section, &beam.material)),
            Self::Cable(cable) => Some((&cable.section, &cable.material)),
            Self::Shell(_) | Self::ShearShell(_) | Self::Rigid(_) | Self::Mass(_) => None,
        }
    }

    /// True for beams and cables.
    pub const fn is_flexible(&self) -> bool {
        matches!(self, Self::Beam(_) | Self::Cable(_))
    }

    /// Contact surface of a rigid body or a point mass.
    pub const fn surface(&self) -> Option<&BodySurface> {
        match self {
            Self::Rigid(rigid) => rigid.surface.as_ref(),
            Self::Mass(mass) => mass.surface.as_ref(),
            Self::Beam(_) | Self::Cable(_) | Self::Shell(_) | Self::ShearShell(_) => None,
        }
    }

    /// Initial motion.
    pub const fn motion(&self) -> &InitialMotion {
        match self {
            Self::Beam(beam) => &beam.motion,
            Self::Cable(cable) => &cable.motion,
            Self::Shell(shell) => &shell.motion,
            Self::ShearShell(shell) => &shell.motion,
            Self::Rigid(rigid) => &rigid.motion,
            Self::Mass(mass) => &mass.motion,
        }
    }

    /// Number of elements; 0 for rigid bodies and point masses.
    pub const fn elements(&self) -> u32 {
        match self {
            Self::Beam(beam) => beam.elements,
            Self::Cable(cable) => cable.elements,
            Self::Shell(shell) => shell.elements[0].saturating_mul(shell.elements[1]),
            Self::ShearShell(shell) => shell.mesh.elements.len() as u32,
            Self::Rigid(_) | Self::Mass(_) => 0,
        }
    }

    /// Sets the number of elements of a beam or cable.
    pub const fn set_elements(&mut self, count: u32) {
        match self {
            Self::Beam(beam) => beam.elements = count,
            Self::Cable(cable) => cable.elements = count,
            Self::Shell(_) | Self::ShearShell(_) | Self::Rigid(_) | Self::Mass(_) => {}
        }
    }

    /// Order of convergence of displacements by the size of the elements.
    pub(crate) const fn convergence_order(&self) -> f64 {
        match self {
            Self::Beam(beam) if beam.formulation.has_shear_locking() => 2.0,
            Self::ShearShell(_) => 2.0,
            _ => 4.0,
        }
    }

    /// Start and end of the axis; opposite corners of the box around a shell; the centre of a rigid body, twice.
    pub fn span(&self) -> [[f64; 3]; 2] {
        match self {
            Self::Beam(beam) => [beam.from, beam.to],
            Self::Cable(cable) => [cable.from, cable.to],
            Self::Shell(shell) => shell.corners(),
            Self::ShearShell(shell) => shell.corners(),
            Self::Rigid(Rigid { center, .. }) | Self::Mass(PointMass { center, .. }) => [*center; 2],
        }
    }

    /// Axis in the reference state, relative to its start; `None` if there is no such curve.
    ///
    /// With the origin at the start, rounding errors are independent of the position of the body.
    pub fn curve(&self) -> Option<ReferenceCurve> {
        let [from, to] = self.span().map(Vector3::from);
        match self {
            Self::Beam(beam) => beam.shape.curve(from, to),
            Self::Cable(_) => Shape::Straight.curve(from, to),
            Self::Shell(_) | Self::ShearShell(_) | Self::Rigid(_) | Self::Mass(_) => None,
        }
    }

    /// Length of the axis, or diagonal of the box around a shell; 0 for rigid bodies and point masses.
    pub fn length(&self) -> f64 {
        match self {
            Self::Shell(shell) => return shell.extent(),
            Self::ShearShell(shell) => return shell.extent(),
            _ => {}
        }
        self.curve().map_or(0.0, |curve| curve.length())
    }

    /// Arc length of a position on the axis.
    pub fn arc_length(&self, at: &At) -> f64 {
        if self.is_shell() {
            return 0.0;
        }
        match at {
            At::Named(NamedPosition::Center) => 0.5 * self.length(),
            At::Named(NamedPosition::End) => self.length(),
            At::Length(s) => *s,
            _ => 0.0,
        }
    }

    /// Point of a position in the reference state; `None` if the body has no such position.
    pub fn point(&self, at: &At) -> Option<Vector3<f64>> {
        let from = Vector3::from(self.span()[0]);
        match (self, at) {
            (Self::Beam(_) | Self::Cable(_), At::Named(_) | At::Length(_)) => {
                let (curve, s) = (self.curve()?, self.arc_length(at));
                (s <= curve.length() * (1.0 + ON_AXIS)).then(|| from + curve.at(s).0)
            }
            (Self::Shell(shell), at) => Some(shell.point(at.on_surface()?)),
            (Self::ShearShell(shell), at) => Some(shell.point_at(shell.place(at)?)),
            (Self::Rigid(_), At::Point(point)) => Some(Vector3::from(*point)),
            (Self::Rigid(_) | Self::Mass(_), At::Named(NamedPosition::Center)) => Some(from),
            _ => None,
        }
    }

    /// Place of a position on a shell; `None` for other bodies and positions.
    pub fn shell_place(&self, at: &At) -> Option<ShellPlace> {
        match self {
            Self::Shell(_) => at.on_surface().map(ShellPlace::Patch),
            Self::ShearShell(shell) => shell.place(at).map(ShellPlace::Element),
            _ => None,
        }
    }

    /// Thickness, material and layers of a shell of either kind.
    pub fn layup(&self) -> Option<Layup<'_>> {
        match self {
            Self::Shell(shell) => Some(shell.layup()),
            Self::ShearShell(shell) => Some(shell.layup()),
            _ => None,
        }
    }

    /// Shell whose section may vary; `None` for other bodies.
    pub(crate) fn field_shell(&self) -> Option<&dyn FieldShell> {
        match self {
            Self::Shell(shell) => Some(shell),
            Self::ShearShell(shell) => Some(shell),
            _ => None,
        }
    }

    /// Thickness of a shell at some places; `None` for other bodies, and for invalid formulas.
    pub fn thickness_at(&self, places: impl IntoIterator<Item = ShellPlace>) -> Option<Vec<f64>> {
        let shell = self.field_shell()?;
        let (fields, points) = (shell.fields().ok()?, shell.field_points());
        let at = |place: ShellPlace| match (place, self) {
            (ShellPlace::Patch(at), Self::Shell(shell)) => shell.element_at(at),
            (ShellPlace::Patch(at), _) => (0, at),
            (ShellPlace::Element(place), _) => (place.element, place.at),
        };
        let thickness = |(element, at)| fields.at(&points(element, at)).thickness;
        Some(places.into_iter().map(at).map(thickness).collect())
    }

    /// Area of the middle surface of a shell; 0 for other bodies.
    pub fn area(&self) -> f64 {
        match self {
            Self::Shell(shell) => shell.area(),
            Self::ShearShell(shell) => shell.area(),
            _ => 0.0,
        }
    }

    /// Data of a shear-deformable shell.
    pub(crate) const fn shear_shell(&self) -> Option<&ShearShell> {
        if let Self::ShearShell(shell) = self { Some(shell) } else { None }
    }

    /// Law of the membrane forces of a shell.
    pub(crate) const fn membrane(&self) -> Option<&Membrane> {
        match self {
            Self::Shell(shell) => shell.membrane.as_ref(),
            Self::ShearShell(shell) => shell.membrane.as_ref(),
            _ => None,
        }
    }

    /// True for shells of either kind.
    pub const fn is_shell(&self) -> bool {
        matches!(self, Self::Shell(_) | Self::ShearShell(_))
    }

    /// Slope length ℓ, the factor of the nodal gradients.
    pub fn slope_length(&self) -> f64 {
        let slopes = match self {
            Self::Beam(beam) => beam.slopes,
            Self::Cable(cable) => cable.slopes,
            Self::Shell(_) | Self::ShearShell(_) | Self::Rigid(_) | Self::Mass(_) => Slopes::Gradient,
        };
        match slopes {
            Slopes::Gradient => 1.0,
            Slopes::Length => self.length() / f64::from(self.elements()),
        }
    }

    /// Direction of the y-axis of the section at the start; `None` if `up` is parallel to the tangent.
    pub fn up(&self) -> Option<Vector3<f64>> {
        let (_, tangent) = self.curve()?.at(0.0);
        let up = match self {
            Self::Beam(Beam { up: Some(up), .. }) | Self::Cable(Cable { up: Some(up), .. }) => {
                Vector3::from(*up).try_normalize(0.0)?
            }
            _ if tangent.y.abs() > 1.0 - 1e-6 => Vector3::z(),
            _ => Vector3::y(),
        };
        (up - tangent * tangent.dot(&up)).try_normalize(1e-9)
    }
}

/// Beam of ANCF elements.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Beam {
    /// Name of the beam in joints, loads and probes.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Start of the axis, length.
    #[unit(length)]
    pub from: [f64; 3],
    /// End of the axis, length.
    #[unit(length)]
    pub to: [f64; 3],
    /// Shape of the axis between start and end; straight by default. This state is free of stress.
    #[serde(default, skip_serializing_if = "Shape::is_straight")]
    pub shape: Shape,
    /// Direction of the y-axis of the section at the start; its component along the axis has no effect. By default
    /// global y, or global z for a beam along y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(none)]
    pub up: Option<[f64; 3]>,
    /// Rotation of the section about the axis from start to end, in radians. This state is free of stress.
    #[serde(default)]
    #[unit(radian)]
    pub twist: f64,
    /// Number of elements of equal length.
    #[schemars(range(min = 1))]
    pub elements: u32,
    /// Element type and elasticity law.
    #[serde(default)]
    pub formulation: Formulation,
    /// Name of the section, a key of `sections`.
    pub section: String,
    /// Name of the section at the end, of the same kind; by default the start section. Dimensions, or the constants of general sections, vary linearly.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub section_end: Option<String>,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// Definition of the nodal slope coordinates.
    #[serde(default)]
    pub slopes: Slopes,
    /// Initial velocities in dynamics; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}

impl Beam {
    /// Straight beam with default values otherwise.
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
            formulation: Formulation::default(),
            section: section.into(),
            section_end: None,
            material: material.into(),
            slopes: Slopes::Gradient,
            motion: InitialMotion::default(),
        }
    }
}

/// Cable of gradient-deficient ANCF elements with two nodes and 12 coordinates.
///
/// Source: Gerstmayr & Shabana (2006); Gerstmayr & Irschik (2008).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Cable {
    /// Name of the cable in joints, loads and probes.
    #[schemars(length(min = 1))]
    pub name: String,
    /// Start of the axis, length.
    #[unit(length)]
    pub from: [f64; 3],
    /// End of the axis, length.
    #[unit(length)]
    pub to: [f64; 3],
    /// Direction of the y-axis of the frame of the section forces at the start, in the straight state; its component
    /// along the axis has no effect. By default global y, or global z for a cable along y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[unit(none)]
    pub up: Option<[f64; 3]>,
    /// Number of elements of equal length.
    #[schemars(range(min = 1))]
    pub elements: u32,
    /// Name of the section, a key of `sections`. Its two second moments of area must be equal.
    pub section: String,
    /// Name of the material, a key of `materials`.
    pub material: String,
    /// Definition of the nodal slope coordinates.
    #[serde(default)]
    pub slopes: Slopes,
    /// Initial velocities in dynamics; at rest by default.
    #[serde(default, skip_serializing_if = "InitialMotion::is_rest")]
    pub motion: InitialMotion,
}

/// Slope coordinates of a node: ℓ r_x, ℓ r_y, ℓ r_z.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(rename_all = "snake_case")]
pub enum Slopes {
    /// Gradients, ℓ = 1 (Kim et al. 2017, eq. 2).
    #[default]
    Gradient,
    /// Gradients times the element length, ℓ = l (Kim et al. 2017, eq. 10).
    Length,
}
