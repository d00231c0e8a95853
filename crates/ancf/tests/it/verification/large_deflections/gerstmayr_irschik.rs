//! Cable element under a large tip load of a cantilever.
//!
//! ```text
//!   |/|==============
//!   |/|              \
//!                     | F = 3EI/L², L = 2, section 0.1 × 0.1, E = 2.07e11
//! ```
//!
//! Source: Gerstmayr & Irschik (2008), one element: (−0.3622447299, −0.9941447587). Other meshes: test "ANCFcantileverTest"
//! of `ANCFCable2D` of EXUDYN, full integration, free stretch of the clamped node. Its converged list has 1, 2, 4, 8 and 64
//! elements; n = 16 is from a later list with an earlier end of the Newton iterations, error 2e-10.
//! Limit by shooting of the rod without shear: (−0.508537304326, −1.207239854550).

use ancf::mechanics::elements::{CableProfile, CableRule, CableSection};
use ancf::mechanics::kinematics::BeamShape;
use nalgebra::Vector3;

use super::cable_chain::{CableCantilever, Root};
use crate::common::assertions::assert_near;

fn tip(elements: u32, rule: CableRule, slope: f64, root: Root) -> Vector3<f64> {
    let (young, side) = (2.07e11, 0.1_f64);
    let section =
        CableSection { axial: young * side * side, bending: young * side.powi(4) / 12.0, line_density: 78.0 };
    let shape = BeamShape { length: 2.0 / f64::from(elements), slope };
    let profile = CableProfile::new(shape, section, Vector3::zeros()).with_rule(rule);
    let force = Vector3::new(0.0, -0.75 * section.bending, 0.0);
    let chain = CableCantilever::new(elements as usize, profile, force, root);
    let (state, _) = chain.equilibrium(5);
    chain.moved(&state)
}

fn assert_tip(moved: Vector3<f64>, [x, y]: [f64; 2], tolerance: f64) {
    assert_near("x", moved.x, x, tolerance);
    assert_near("y", moved.y, y, tolerance);
    assert_eq!(moved.z, 0.0, "displacement out of the plane");
}

#[test]
fn full_integration_equals_the_published_tips() {
    for (elements, reference, tolerance) in [
        (1, [-0.362_244_729_890_505_43, -0.994_144_758_724_973], 1e-12),
        (2, [-0.488_926_308_341_485_8, -1.175_222_865_055_166_6], 1e-12),
        (4, [-0.507_428_715_118_889_2, -1.205_533_702_233_540_4], 1e-12),
        (8, [-0.508_509_236_497_080_2, -1.207_197_756_019_828_1], 1e-12),
        (16, [-0.508_536_579_914_955_6, -1.207_238_895_003_594], 2e-10),
        (64, [-0.508_537_302_970_094_7, -1.207_239_853_336_073_8], 1e-11),
    ] {
        assert_tip(tip(elements, CableRule::Full, 1.0, Root::Direction), reference, tolerance);
    }
}

/// Results do not depend on the slope length.
#[test]
fn slope_length_does_not_change_the_tip() {
    let reference = [-0.507_428_715_118_889_2, -1.205_533_702_233_540_4];
    assert_tip(tip(4, CableRule::Full, 0.5, Root::Direction), reference, 1e-12);
}

/// All integration rules and clamps have the same limit. On coarse meshes Lobatto points are the most accurate.
#[test]
fn integration_rules_have_one_limit() {
    let limit = [-0.508_537_304_326, -1.207_239_854_550];
    for rule in [CableRule::Full, CableRule::Reduced, CableRule::Lobatto] {
        for root in [Root::Direction, Root::Gradient] {
            assert_tip(tip(64, rule, 1.0, root), limit, 2e-8);
        }
    }
    let errors = [CableRule::Lobatto, CableRule::Full, CableRule::Reduced]
        .map(|rule| (tip(2, rule, 1.0, Root::Direction).y - limit[1]).abs());
    assert!(errors[0] < 0.3 * errors[1] && errors[1] < errors[2], "{errors:?}");
}
