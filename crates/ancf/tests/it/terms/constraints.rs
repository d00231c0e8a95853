//! Two bodies with constraints and loads.

use ancf::mechanics::bodies::{BeamMesh, MeshParameters};
use ancf::mechanics::constraints::{
    BilinearMeasure, CoincidenceConstraint, ConstantAngle, ConstraintGroup, GroupedConstraint,
    MeasureConstraint, MeasureFactor, RotationDrive,
};
use ancf::mechanics::elements::{BeamMaterial, TwoNodeLaw};
use ancf::mechanics::forces::Force;
use ancf::mechanics::functions::Function;
use ancf::mechanics::kinematics::{Marker, ReferenceNode};
use ancf::mechanics::sections::DeformationFactors;
use ancf::model::{Material, Section};
use ancf::solver::equations::Term;
use nalgebra::{DVector, Rotation3, Vector3};

use crate::common::random::Random;
use crate::common::sample::{Sample, residual};

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
        retardation: DeformationFactors::default(),
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
        ("group of constraints", Box::new(group(grouped_constraints().map(|(_, part)| part)))),
        ("force", Box::new(Force::new(&point_a, Vector3::new(0.3, -2.0, 0.7)))),
    ]
}

/// Constraints of a joint at nodes of both bodies, with their copies for a group.
fn grouped_constraints() -> [(Box<dyn Term>, GroupedConstraint); 3] {
    let [a, b] = bodies();
    let (along, across) = (Vector3::new(0.6, 0.0, 0.8), Vector3::new(0.48, 0.8, -0.36));
    let (point, direction, other) = (a.point(LENGTH), a.direction(0.0, along), b.direction(0.0, across));
    let factors = [MeasureFactor::Other(&other.clone().into()), MeasureFactor::Point(&point.clone().into())];
    let position = CoincidenceConstraint::points(&point, b.point(LENGTH), 5).closed();
    let angle = ConstantAngle::new(&direction, &other, 8);
    let [axis, of] = factors;
    let measure = MeasureConstraint::new(BilinearMeasure::new([(0.7, axis, of)]), 9);
    let [one, two, three] = [position.grouped(), angle.grouped(), measure.grouped()].map(Option::unwrap);
    [(Box::new(position), one), (Box::new(angle), two), (Box::new(measure), three)]
}

/// Constraints with consecutive multipliers as one term.
fn group(constraints: [GroupedConstraint; 3]) -> ConstraintGroup {
    let mut groups = ConstraintGroup::groups(constraints);
    assert_eq!(groups.len(), 1);
    groups.remove(0)
}

/// The residual of a group is the sum of those of its constraints.
#[test]
fn a_group_is_the_sum_of_its_constraints() {
    let parts = grouped_constraints();
    let group = group(grouped_constraints().map(|(_, part)| part));
    let (n, s) = (group.coordinates().len(), Sample::random(&group, &mut Random(3)));
    let mut sum = DVector::zeros(n + s.lambda.len());
    for (part, _) in &parts {
        let places: Vec<usize> = part
            .coordinates()
            .iter()
            .map(|c| group.coordinates().iter().position(|other| other == c).unwrap())
            .collect();
        let first = part.multipliers().start - group.multipliers().start;
        let of = |x: &DVector<f64>| DVector::from_iterator(places.len(), places.iter().map(|&i| x[i]));
        let lambda = s.lambda.rows(first, part.multipliers().len()).into_owned();
        let rows = residual(part.as_ref(), &Sample { q: of(&s.q), v: of(&s.v), a: of(&s.a), lambda });
        for (i, row) in rows.iter().enumerate() {
            sum[places.get(i).copied().unwrap_or_else(|| n + first + i - places.len())] += row;
        }
    }
    let found = residual(&group, &s);
    assert!((&found - &sum).amax() <= 1e-14 * sum.amax(), "{found} {sum}");
}
