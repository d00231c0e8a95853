//! Single cable elements for all choices of integration rule, slope length and direction.

use std::sync::Arc;

use ancf::mechanics::elements::{Cable12, CableDamping, CableProfile, CableRule, CableSection};
use ancf::mechanics::kinematics::BeamShape;
use nalgebra::{Rotation3, Vector3};

/// Length of an element.
pub(crate) const LENGTH: f64 = 0.7;
/// Section of a stubby element, so that all parts of the energy are of one magnitude.
pub(crate) const SECTION: CableSection = CableSection { axial: 2.0, bending: 0.3, line_density: 0.14 };
/// Strong damping, so that all parts of the force are of one magnitude.
pub(crate) const DAMPING: CableDamping = CableDamping { stretch: 0.3, bending: 0.3, mass: 0.5 };

/// Cable element with its reference coordinates.
pub(crate) struct Cable {
    pub(crate) name: String,
    pub(crate) term: Cable12,
    pub(crate) reference: [Vector3<f64>; 4],
    pub(crate) slope: f64,
    pub(crate) rule: CableRule,
}

/// Returns one element for each combination of rule, slope length and direction.
pub(crate) fn cables(damping: CableDamping, gravity: Vector3<f64>) -> Vec<Cable> {
    let tilted = Rotation3::from_euler_angles(0.4, -1.1, 2.3) * Vector3::x();
    let mut cables = Vec::new();
    for rule in [CableRule::Full, CableRule::Reduced, CableRule::Lobatto] {
        for slope in [1.0, LENGTH] {
            for direction in [Vector3::x(), tilted] {
                let shape = BeamShape { length: LENGTH, slope };
                let profile =
                    CableProfile::new(shape, SECTION, gravity).with_damping(damping).with_rule(rule);
                cables.push(Cable {
                    name: format!("{rule:?} cable, slope length {slope}, along {:.1?}", direction.as_slice()),
                    term: Cable12::new(std::array::from_fn(|i| i), direction, Arc::new(profile)),
                    reference: [Vector3::zeros(), direction * slope, direction * LENGTH, direction * slope],
                    slope,
                    rule,
                });
            }
        }
    }
    cables
}
