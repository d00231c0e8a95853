//! Kim et al. (2017), sections 3.2 and 3.3: rod released from horizontal on a revolute or spherical joint.
//!
//! ```text
//!   o====================        revolute: gravity along −y; E = 193 GPa
//!   |  | | | | | | | | |         spherical: gravity along −y and −z; E = 193 MPa
//! ```
//!
//! Goal: figure 8 (near the rigid compound pendulum), figure 12 (y = z), equal results in both forms.

use ancf::model::{Step, Stop};
use ancf::record::Series;
use ancf::{Model, simulate};
use nalgebra::Vector3;

use super::forms::non_dimensional;
use crate::common::models::rod;
use crate::common::solutions::{Run, distance};

/// Asserts equal motion and iterations of both forms with the same physical step.
fn assert_forms_agree(model: Model) {
    let [a, b] = [model.clone(), non_dimensional(model)].map(|model| Run::of(&model));
    let error = distance(&a.vectors("tip."), &b.vectors("tip."));
    assert!(error < 1e-9 * rod::LENGTH, "distance of the trajectories {error:e}");
    let (a, b) = (a.summary.iterations as f64, b.summary.iterations as f64);
    assert!((a / b - 1.0).abs() < 0.01, "{a} and {b} iterations");
}

#[test]
fn forms_agree_for_the_revolute_joint() {
    assert_forms_agree(rod::revolute(1));
    assert_forms_agree(rod::revolute(5));
}

#[test]
fn forms_agree_for_the_spherical_joint() {
    assert_forms_agree(rod::spherical(1));
    assert_forms_agree(rod::spherical(5));
}

/// t, x, y of the tip of a rigid rod, J = m(L²/3 + d²/16), released from horizontal under 9.81 m/s².
///
/// Independent calculation: θ'' = W² cos θ, W² = 14.71389645776567 / s², by Jacobi's sn. An eighth-order Runge-Kutta
/// solution agrees to 1.2e-13.
const RIGID: [[f64; 3]; 8] = [
    [0.25, 0.897555597254, -0.440901292625],
    [0.5, -0.0901281176136, -0.995930179488],
    [0.75, -0.941372899724, -0.337367846224],
    [1.0, -0.999966738166, -0.00815613650197],
    [1.25, -0.834428777999, -0.551115790417],
    [1.5, 0.266044667463, -0.963960701956],
    [1.75, 0.96965730188, -0.244468232928],
    [2.0, 0.999467890296, -0.0326180359245],
];

/// Tips of the revolute pendulum at the instants of [`RIGID`].
fn tips(elements: u32, steps_per_second: u32) -> Vec<Vector3<f64>> {
    let mut model = rod::revolute(elements);
    rod::settings(&mut model).step = Step::Fixed(1.0 / f64::from(steps_per_second));
    let tips = Run::of(&model).vectors("tip.");
    let every = steps_per_second as usize / 4;
    tips.into_iter().skip(every).step_by(every).collect()
}

/// Distances from the rigid pendulum.
fn from_rigid(tips: &[Vector3<f64>]) -> impl Iterator<Item = f64> {
    tips.iter().zip(RIGID).map(|(tip, [_, x, y])| (tip - Vector3::new(x, y, 0.0)).norm())
}

/// Figure 8: with the step of the paper the difference from the rigid pendulum is the damping of the scheme, of first order.
#[test]
fn revolute_pendulum_of_figure_8() {
    for elements in [1, 5] {
        let largest = from_rigid(&tips(elements, 1000)).fold(0.0, f64::max);
        assert!(largest < 0.015 * rod::LENGTH, "{elements} elements: {largest}");
    }
}

/// Extrapolated to h = 0, the mean distance from the rigid rod is below 5e-4 L, due to flexibility.
#[test]
fn revolute_pendulum_is_nearly_rigid() {
    let (coarse, fine) = (tips(1, 4000), tips(1, 8000));
    let extrapolated: Vec<_> = coarse.iter().zip(&fine).map(|(coarse, fine)| fine * 2.0 - coarse).collect();
    let mean = from_rigid(&extrapolated).sum::<f64>() / RIGID.len() as f64;
    assert!(mean < 5e-4 * rod::LENGTH, "{mean:e}");
}

/// Figure 12: equal gravity along y and z causes a plane motion, that of a hinged rod under √2 g.
#[test]
fn spherical_pendulum_of_figure_12() {
    let root_2 = 2.0_f64.sqrt();
    for elements in [1, 5] {
        let ball = rod::spherical(elements);
        let mut hinge = rod::revolute(elements);
        hinge.gravity = [0.0, -root_2 * rod::GRAVITY, 0.0];
        hinge.materials = ball.materials.clone();
        let tip = Run::of(&ball).vectors("tip.");
        assert!(tip.iter().all(|tip| (tip.y - tip.z).abs() < 1e-9 * rod::LENGTH));
        let turned: Vec<_> = tip.iter().map(|tip| Vector3::new(tip.x, root_2 * tip.y, 0.0)).collect();
        assert!(distance(&turned, &Run::of(&hinge).vectors("tip.")) < 1e-9 * rod::LENGTH);
    }
}

/// The soft rod swings through with small stretch; the scheme dissipates energy monotonically.
#[test]
fn spherical_pendulum_dissipates_energy_monotonically() {
    let run = Run::of(&rod::spherical(5));
    let tip = run.vectors("tip.");
    assert!(tip.iter().all(|tip| tip.norm() < 1.001 * rod::LENGTH));
    assert!(tip.iter().any(|tip| tip.x < -0.9 * rod::LENGTH));
    assert!(run.column("balance").is_sorted());
    let (dissipated, exchanged) = (run.column("balance"), run.column("kinetic"));
    let exchanged = exchanged.iter().copied().fold(0.0, f64::max);
    assert!(dissipated[dissipated.len() - 1] < 0.03 * exchanged);
}

/// Figure 7 shows about 80 iterations of the dimensional form and one or two of the non-dimensional one.
///
/// The cause is a stopping rule |r| < tolerance in the numbers of each form, near the rounding error of the dimensional
/// residual. With 1e-7 both forms need at most three iterations; with 5e-9 the dimensional form stagnates at rounding.
#[test]
fn iterations_of_figure_7() {
    let summary = |mut model: Model, tolerance| {
        let settings = rod::settings(&mut model);
        (settings.stop, settings.max_iterations) = (Stop::Residual { tolerance }, 1000);
        simulate(&model, &mut Series::new()).unwrap()
    };
    for tolerance in [1e-7, 5e-9] {
        let scaled = summary(non_dimensional(rod::revolute(1)), tolerance);
        assert!(scaled.outcome.is_finished() && scaled.most_iterations <= 3, "{scaled:?}");
    }
    let coarse = summary(rod::revolute(1), 1e-7);
    assert!(coarse.outcome.is_finished() && coarse.most_iterations <= 3, "{coarse:?}");
    let fine = summary(rod::revolute(1), 5e-9);
    assert!(!fine.outcome.is_finished() || fine.most_iterations > 30, "{fine:?}");
}
