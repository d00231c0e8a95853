//! Verification: the element, the joints and the schemes against published and independently computed numbers.
//!
//! Files are named after their source. Where a number comes from is said beside it.
#![cfg(test)]

#[path = "../common/chain.rs"]
mod chain;
#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "../common/continuum.rs"]
mod continuum;
#[path = "../common/equilibrium.rs"]
mod equilibrium;
#[path = "../common/linear.rs"]
mod linear;
#[path = "../common/rod.rs"]
mod rod;
#[expect(dead_code, reason = "other test binaries use the rest")]
#[path = "../common/run.rs"]
mod run;

mod balance;
mod buckling;
mod cable_statics;
mod chrono_3243;
mod elastica;
mod gerstmayr_irschik;
mod kim_cantilever;
mod kim_misprints;
mod kim_pendulum;
mod kim_scales;
mod kim_static_tips;
mod linear_beam;
mod princeton_beam;
mod roll_up;
mod timoshenko_modes;
mod vibration;

use ancf::Model;
use ancf::model::{ScaleChoice, Slopes, Step};

/// The non-dimensional form of Kim et al. (2017): units of table 3, length-valued slopes.
fn non_dimensional(mut model: Model) -> Model {
    model.scales = ScaleChoice::Paper;
    rod::beam(&mut model).slopes = Slopes::Length;
    model
}

/// The non-dimensional form with the step that the paper gives it: 0.001 of its own unit of time, and as many as fit into the
/// duration.
fn non_dimensional_step(model: Model) -> Model {
    let mut model = non_dimensional(model);
    let step = 1e-3 * model.scales().scales.time;
    let settings = rod::settings(&mut model);
    (settings.step, settings.duration) = (Step::Fixed(step), (settings.duration / step).floor() * step);
    model
}

/// Asserts that a number is a reference within an absolute tolerance.
fn assert_near(what: &str, value: f64, reference: f64, tolerance: f64) {
    let error = (value - reference).abs();
    assert!(error <= tolerance, "{what}: {value} instead of {reference}, {error:e} off");
}
