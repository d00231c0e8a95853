//! Cantilever under a dead tip load and under its own weight.
//!
//! ```text
//!   |/|==========
//!   |/|          \\\        α = PL²/EI = 1, 5, 10, along −y
//!                  | P
//! ```
//!
//! Source of the limits: rod of Reissner (1972) with shear coefficient one and ν = 0, by shooting. Source of the numbers for
//! meshes: independent implementation of the element. Both are near the elastica of Bisshopp & Drucker (1945).

use ancf::Model;
use ancf::model::Load;

use crate::common::assertions::assert_near;
use crate::common::models::rod;
use crate::common::solutions::equilibrium;

fn assert_tip(model: &Model, [x, y]: [f64; 2]) {
    let (assembly, state) = equilibrium(model, 10);
    let tip = assembly.probes[0].1.value(&state);
    assert_near("x", tip.x, x, 1e-9);
    assert_near("y", tip.y, y, 1e-9);
}

/// Rod without gravity under P = α EI/L² at its tip.
fn loaded(elements: u32, alpha: f64) -> Model {
    let mut model = rod::cantilever(elements);
    model.gravity = [0.0; 3];
    let force = -alpha * model.materials["steel"].young * model.sections["circle"].moments().yy;
    model.loads = vec![Load::force(rod::end(), [0.0, force, 0.0])];
    model
}

/// Limit (0.9435606328, −0.3017658497).
#[test]
fn tip_of_alpha_1_equals_independent_meshes() {
    for (elements, tip) in [
        (1, [0.9977824683, -0.0576521783]),
        (2, [0.9885413433, -0.1320283348]),
        (4, [0.9623330881, -0.2435466633]),
        (8, [0.9459106606, -0.2948004356]),
        (16, [0.9437508109, -0.3011599952]),
        (32, [0.9435752398, -0.3016848125]),
    ] {
        assert_tip(&loaded(elements, 1.0), tip);
    }
}

/// Limit (0.6123490435, −0.7139529967).
#[test]
fn tip_of_alpha_5_equals_independent_meshes() {
    for (elements, tip) in [
        (8, [0.6534271805, -0.6748765856]),
        (16, [0.6159224612, -0.7103431521]),
        (32, [0.6124989521, -0.7136809188]),
    ] {
        assert_tip(&loaded(elements, 5.0), tip);
    }
}

/// Limit (0.4449752850, −0.8109092306).
#[test]
fn tip_of_alpha_10_equals_independent_meshes() {
    for (elements, tip) in [
        (8, [0.5047681786, -0.7650597800]),
        (16, [0.4510901415, -0.8056979713]),
        (32, [0.4452280401, -0.8105159933]),
    ] {
        assert_tip(&loaded(elements, 10.0), tip);
    }
}

/// E/1000 under own weight, β = ρAgL³/EI = 16.33. Limit (0.503917404445, −0.800577428674).
#[test]
fn tip_under_own_weight_equals_independent_meshes() {
    for (elements, tip) in [
        (4, [0.7889261908, -0.5459268901]),
        (8, [0.5834281335, -0.7384569996]),
        (16, [0.5129802866, -0.7930660671]),
        (32, [0.5043118661, -0.8000340548]),
    ] {
        let mut model = rod::cantilever(elements);
        rod::material(&mut model).young /= 1000.0;
        assert_tip(&model, tip);
    }
}
