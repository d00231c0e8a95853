//! Conservation laws and invariance of random chains of beams, cables and rigid bodies.

use ancf::record::Series;
use ancf::{Model, Outcome, simulate};
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

use super::chains::{Chain, Notation, chain};
use crate::common::solutions::recorded_momenta;

const STEP: f64 = 2e-3;
const DURATION: f64 = 0.1;

/// Checks a property on random chains with a fixed seed.
fn assert_for_chains(cases: u32, property: impl Fn(Chain) -> Result<(), TestCaseError>) {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 50, ..Config::default() };
    TestRunner::new_with_rng(config, rng).run(&chain(), property).unwrap_or_else(|error| panic!("{error}"));
}

/// Runs a chain. Returns the path of the tip and the columns.
fn run(chain: &Chain, notation: &Notation) -> Result<(Vec<Vector3<f64>>, Series), TestCaseError> {
    let text = chain.text(notation);
    let model = Model::parse(&text).map_err(|errors| TestCaseError::fail(format!("{errors}\n{text}")))?;
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).map_err(|error| TestCaseError::fail(error.to_string()))?;
    prop_assert_eq!(&summary.outcome, &Outcome::Finished, "{}", text);
    let column = |name: &str| series.column(name).unwrap();
    let [x, y, z] = ["tip.x", "tip.y", "tip.z"].map(column);
    let path = x.iter().zip(y).zip(z).map(|((x, y), z)| Vector3::new(*x, *y, *z)).collect();
    Ok((path, series))
}

/// Largest distance of two paths.
fn path_distance(a: &[Vector3<f64>], b: impl Iterator<Item = Vector3<f64>>) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

/// The error of the energy balance decreases with the step.
#[test]
fn energy_balance_error_decreases_with_the_step() {
    assert_for_chains(48, |chain| {
        let error = |step: f64| {
            let (_, series) = run(&chain, &Notation::plain(step, DURATION))?;
            let largest =
                |name: &str| series.column(name).unwrap().iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            let size = largest("kinetic").max(largest("strain")).max(largest("potential"));
            Ok::<_, TestCaseError>(largest("balance") / size.max(1e-9))
        };
        let (coarse, fine) = (error(STEP)?, error(0.5 * STEP)?);
        prop_assert!(fine < 0.5 * coarse || fine < 1e-4, "{coarse:e}, {fine:e} of the energy\n{chain:?}");
        Ok(())
    });
}

/// Linear momentum is conserved to rounding, angular momentum to the order of the scheme.
#[test]
fn free_chains_conserve_their_momenta() {
    assert_for_chains(48, |chain| {
        let chain = chain.free();
        let drift = |step: f64| -> Result<[f64; 2], TestCaseError> {
            let model = Model::parse(&chain.text(&Notation::plain(step, DURATION)));
            let model = model.map_err(|errors| TestCaseError::fail(errors.to_string()))?;
            let all = recorded_momenta(&model);
            let first = all[0];
            let largest = |k: usize| all.iter().map(|now| (now[k] - first[k]).norm()).fold(0.0, f64::max);
            let size = first[0].norm().max(1e-6);
            Ok([largest(0) / size, largest(1) / size])
        };
        let [coarse, fine] = [drift(STEP)?, drift(0.5 * STEP)?];
        prop_assert!(coarse[0] < 1e-7, "linear momentum: {coarse:?}\n{chain:?}");
        prop_assert!(
            fine[1] < 0.5 * coarse[1] || fine[1] < 1e-7,
            "angular momentum: {coarse:?}, {fine:?}\n{chain:?}"
        );
        Ok(())
    });
}

/// Rotated and shifted frame, other scales, reversed order of bodies.
#[test]
fn motions_do_not_depend_on_frame_scales_and_order() {
    let turn = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    let shift = Vector3::new(3.0, -20.0, 7.0);
    assert_for_chains(48, |chain| {
        let plain = Notation::plain(STEP, DURATION);
        let (path, _) = run(&chain, &plain)?;
        let moved = run(&chain, &Notation { turn, shift, ..plain.clone() })?.0;
        let back = moved.iter().map(|x| turn.inverse() * (x - shift));
        let error = path_distance(&path, back);
        prop_assert!(error < 1e-6, "rotated and shifted: {error:e}\n{chain:?}");
        for scales in ["{ kind = \"auto\" }", "{ kind = \"given\", length = 0.01, force = 3, time = 0.5 }"] {
            let error =
                path_distance(&path, run(&chain, &Notation { scales, ..plain.clone() })?.0.into_iter());
            prop_assert!(error < 1e-6, "scales {scales}: {error:e}\n{chain:?}");
        }
        let error = path_distance(&path, run(&chain, &Notation { reversed: true, ..plain })?.0.into_iter());
        prop_assert!(error < 1e-6, "reversed: {error:e}\n{chain:?}");
        Ok(())
    });
}
