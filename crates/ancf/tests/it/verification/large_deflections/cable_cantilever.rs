//! Cantilevers of cable elements under a tip load and under their own weight.

use std::f64::consts::PI;

use ancf::mechanics::elements::{CableProfile, CableSection};
use ancf::mechanics::kinematics::BeamShape;
use ancf::solver::equations::Weights;
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::Vector3;

use super::cable_chain::{CableCantilever, Root};
use crate::common::assertions::assert_near;

const GRAVITY: Vector3<f64> = Vector3::new(0.0, -9.81, 0.0);

/// Rod of Kim et al. (2017): L = 1, d = 0.02, E = 193e9, ρ = 8030.
fn rod() -> CableSection {
    let (area, young) = (PI * 0.02 * 0.02 / 4.0, 193e9);
    CableSection {
        axial: young * area,
        bending: young * PI * 0.02_f64.powi(4) / 64.0,
        line_density: 8030.0 * area,
    }
}

fn cantilever(
    length: f64,
    elements: u32,
    section: CableSection,
    gravity: Vector3<f64>,
    force: Vector3<f64>,
) -> CableCantilever {
    let shape = BeamShape { length: length / f64::from(elements), slope: 1.0 };
    let profile = CableProfile::new(shape, section, gravity);
    CableCantilever::new(elements as usize, profile, force, Root::Direction)
}

/// L = 2, ρA = 78, EA = 1e6, EI = 833.333 under own weight, ρAgL³/EI = 7.35.
///
/// Source: cable element of EXUDYN, converged.
#[test]
fn heavy_cable_equals_exudyn() {
    let section = CableSection { axial: 1e6, bending: 1e4 / 12.0, line_density: 78.0 };
    let chain = cantilever(2.0, 64, section, GRAVITY, Vector3::zeros());
    let (state, _) = chain.equilibrium(5);
    let moved = chain.moved(&state);
    assert_near("x", moved.x, -0.501_305_85, 1e-8);
    assert_near("y", moved.y, -1.232_510_06, 1e-8);
}

/// PL²/EI = 10. Elastica (0.445004402246249, 0.810609024880296) by Bisshopp & Drucker (1945).
///
/// With the stretch of the rod (0.445033517081, 0.810808827703), by shooting. Root moment P x, axial tip force P sin θ.
#[test]
fn cable_cantilever_is_the_elastica() {
    let section = rod();
    let load = 10.0 * section.bending;
    let chain = cantilever(1.0, 64, section, Vector3::zeros(), Vector3::new(0.0, load, 0.0));
    let (state, _) = chain.equilibrium(4);
    let tip = chain.tip.value(&state);
    assert_near("x", tip.x, 0.445_033_517_081, 2e-8);
    assert_near("y", tip.y, 0.810_808_827_703, 2e-8);

    let (_, root) = chain.resultants(&state, 0, 0.0);
    assert!((root - Vector3::z() * (load * tip.x)).norm() < 1e-2 * load * tip.x, "{root}");
    let (force, moment) = chain.resultants(&state, 63, 1.0);
    let slope = Vector3::x() + Vector3::from_column_slice(&state.q[6 * 64 + 3..]);
    assert_near("axial force", force, load * slope.normalize().y, 1e-2 * load);
    assert!(moment.norm() < 1e-3 * root.norm(), "{moment}");
}

/// Own weight in one load step with EA = 4e4 EI/L² and up to 1000 elements.
///
/// Limit without shear: 2.040778175 mm (inextensible, by shooting).
#[test]
fn own_weight_converges_with_many_cable_elements() {
    for elements in [50, 300, 500, 700, 1000] {
        let chain = cantilever(1.0, elements, rod(), GRAVITY, Vector3::zeros());
        let mut state = chain.rest();
        let mut newton = Newton::new(chain.system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
        let report = newton.solve(&chain.system, &mut state, Weights::STIFFNESS).unwrap();
        assert!(report.iterations <= 5, "{elements} elements: {} iterations", report.iterations);
        assert_near("tip", chain.moved(&state).y, -0.002_040_778_175, 1e-11);
    }
}
