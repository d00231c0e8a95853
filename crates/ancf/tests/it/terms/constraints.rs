//! Two bodies with constraints and loads.

use ancf::mechanics::bodies::{BeamMesh, MeshParameters};
use ancf::mechanics::constraints::{CoincidenceConstraint, ConstantAngle, RotationDrive};
use ancf::mechanics::elements::{BeamMaterial, TwoNodeLaw};
use ancf::mechanics::forces::Force;
use ancf::mechanics::functions::Function;
use ancf::mechanics::kinematics::{Marker, ReferenceNode};
use ancf::model::{Material, Section};
use ancf::solver::equations::Term;
use nalgebra::{Rotation3, Vector3};

/// Length of an element.
const LENGTH: f64 = 0.7;
/// Start of the first body.
pub(super) const ORIGIN: Vector3<f64> = Vector3::new(0.1, -0.2, 0.3);

/// Builds a rotated body of two elements.
pub(super) fn mesh(first: usize, origin: Vector3<f64>, rotation: Rotation3<f64>) -> BeamMesh {
    let section = Section::circle(0.3).cross_section(0.3);
    let lame = Material::elastic(2.0, 30.0, 0.3).lame();
    let medium = BeamMaterial {
        lame,
        neo_hookean: false,
        density: 2.0,
        retardation: 0.0,
        mass_damping: 0.0,
        gravity: Vector3::zeros(),
    };
    let of = |_| section.clone();
    let blueprint = MeshParameters {
        first,
        origin,
        length: LENGTH,
        slope: LENGTH,
        medium: &medium,
        section: &of,
        prismatic: true,
    };
    let frame = [Vector3::x(), Vector3::y(), Vector3::z()].map(|axis| rotation * axis);
    let nodes = [0.0, 1.0, 2.0].map(|k| ReferenceNode { position: frame[0] * (k * LENGTH), frame });
    BeamMesh::two_node(&blueprint, &nodes, TwoNodeLaw::Continuum)
}

/// Builds two bodies of two elements each, the second one rotated.
pub(super) fn bodies() -> [BeamMesh; 2] {
    let tilted = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    [mesh(0, ORIGIN, Rotation3::identity()), mesh(36, ORIGIN, tilted)]
}

/// Returns constraints and loads on two bodies, at nodes and inside elements.
pub(super) fn constraints_and_loads() -> Vec<(&'static str, Box<dyn Term>)> {
    let [a, b] = bodies();
    let (along, across) = (Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.48, 0.8, -0.36));
    let ground = Marker::fixed(across);
    let (point_a, point_b) = (a.point(0.31), b.point(LENGTH));
    let (direction_a, direction_b) = (a.direction(0.31, along), b.direction(2.0 * LENGTH, across));
    vec![
        ("points", Box::new(CoincidenceConstraint::points(&point_a, &point_b, 5))),
        ("point and ground", Box::new(CoincidenceConstraint::points(&point_a, &ground, 5))),
        ("points of one body", Box::new(CoincidenceConstraint::points(&point_a, a.point(0.0), 5))),
        ("directions", Box::new(CoincidenceConstraint::directions(&direction_a, &direction_b, 5))),
        ("gap to a point", Box::new(CoincidenceConstraint::toward(&point_a, across, 5))),
        (
            "drive",
            Box::new(RotationDrive::new(
                &direction_a,
                Vector3::z(),
                2.0,
                Function::Ramp { start: 0.0, end: 2.0 },
                5,
            )),
        ),
        ("direction and ground", Box::new(CoincidenceConstraint::directions(&direction_a, &ground, 5))),
        ("perpendicular", Box::new(ConstantAngle::new(&direction_a, &direction_b, 5))),
        ("perpendicular to the ground", Box::new(ConstantAngle::new(&direction_a, &ground, 5))),
        (
            "perpendicular within a body",
            Box::new(ConstantAngle::new(&direction_a, &a.direction(0.0, across), 5)),
        ),
        ("force", Box::new(Force::new(&point_a, Vector3::new(0.3, -2.0, 0.7)))),
    ]
}
