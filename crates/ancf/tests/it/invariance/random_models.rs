//! Laws that hold for any model, on random chains of beams, cables and rigid bodies.

use std::io;
use std::ops::ControlFlow;

use super::chains::{Chain, Setting, chain};
use ancf::record::Series;
use ancf::system::{EquationsOfMotion, State, Weights};
use ancf::{Model, Observer, Outcome, Simulation, simulate};
use nalgebra::{Rotation3, Vector3};
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};

const STEP: f64 = 2e-3;
const DURATION: f64 = 0.1;

/// Always the same cases: what fails, fails for everybody.
fn on_chains(cases: u32, law: impl Fn(Chain) -> Result<(), TestCaseError>) {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[7; 32]);
    let config = Config { cases, failure_persistence: None, max_shrink_iters: 50, ..Config::default() };
    TestRunner::new_with_rng(config, rng).run(&chain(), law).unwrap_or_else(|error| panic!("{error}"));
}

/// The path of the tip, and the columns.
fn run(chain: &Chain, setting: &Setting) -> Result<(Vec<Vector3<f64>>, Series), TestCaseError> {
    let text = chain.text(setting);
    let model = Model::parse(&text).map_err(|errors| TestCaseError::fail(format!("{errors}\n{text}")))?;
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).map_err(|error| TestCaseError::fail(error.to_string()))?;
    prop_assert_eq!(&summary.outcome, &Outcome::Finished, "{}", text);
    let column = |name: &str| series.column(name).unwrap();
    let [x, y, z] = ["tip.x", "tip.y", "tip.z"].map(column);
    let path = x.iter().zip(y).zip(z).map(|((x, y), z)| Vector3::new(*x, *y, *z)).collect();
    Ok((path, series))
}

/// The largest distance of two paths.
fn apart(a: &[Vector3<f64>], b: impl Iterator<Item = Vector3<f64>>) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max)
}

/// What leads to the books not balancing is the step: a fourth of it remains in half the step, for a scheme of second order.
#[test]
fn energy_balances() {
    on_chains(48, |chain| {
        let lost = |step: f64| {
            let (_, series) = run(&chain, &Setting::plain(step, DURATION))?;
            let largest =
                |name: &str| series.column(name).unwrap().iter().fold(0.0_f64, |m, x| m.max(x.abs()));
            let size = largest("kinetic").max(largest("strain")).max(largest("potential"));
            Ok::<_, TestCaseError>(largest("balance") / size.max(1e-9))
        };
        let (coarse, fine) = (lost(STEP)?, lost(0.5 * STEP)?);
        prop_assert!(fine < 0.5 * coarse || fine < 1e-4, "{coarse:e}, {fine:e} of the energy\n{chain:?}");
        Ok(())
    });
}

/// Linear and angular momentum about the origin of each state, in the units of the solver.
struct Momenta<'a>(&'a Simulation, Vec<[Vector3<f64>; 2]>);

impl Observer for Momenta<'_> {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        Ok(())
    }

    fn record(&mut self, _: &[f64], s: &State) -> io::Result<ControlFlow<()>> {
        let assembly = self.0.assembly();
        let mut mass = assembly.system.matrix();
        assembly.system.tangent(s, Weights::MASS, &mut mass);
        let mut v = s.v.clone();
        v.resize(mass.pattern().size(), 0.0);
        let momentum = mass.times(&v);
        let (mut linear, mut angular) = (Vector3::zeros(), Vector3::zeros());
        for vector in assembly.bodies().flat_map(|(_, body)| body.vectors(s)) {
            let part = Vector3::from_column_slice(&momentum[vector.first..vector.first + 3]);
            // Translations move positions, rotations all vectors: x' = ω × x.
            linear += if vector.is_position() { part } else { Vector3::zeros() };
            angular += vector.value.cross(&part);
        }
        self.1.push([linear, angular]);
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Free chains keep their linear momentum to rounding, and the angular one to the order of the scheme.
#[test]
fn free_chains_keep_their_momenta() {
    on_chains(48, |chain| {
        let chain = chain.free();
        let drift = |step: f64| {
            let model = Model::parse(&chain.text(&Setting::plain(step, DURATION)));
            let model = model.map_err(|errors| TestCaseError::fail(errors.to_string()))?;
            let simulation = Simulation::new(&model).unwrap();
            let mut momenta = Momenta(&simulation, Vec::new());
            let summary = simulation.run(&mut momenta).unwrap();
            prop_assert!(summary.outcome.is_finished());
            let first = momenta.1[0];
            let largest =
                |k: usize| momenta.1.iter().map(|now| (now[k] - first[k]).norm()).fold(0.0, f64::max);
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

/// The world may be turned and shifted, written in other units, its bodies named in another order.
#[test]
fn motions_do_not_depend_on_how_they_are_written() {
    let turn = Rotation3::from_euler_angles(0.4, -1.1, 2.3);
    let shift = Vector3::new(3.0, -20.0, 7.0);
    on_chains(48, |chain| {
        let plain = Setting::plain(STEP, DURATION);
        let (path, _) = run(&chain, &plain)?;
        let moved = run(&chain, &Setting { turn, shift, ..plain.clone() })?.0;
        let back = moved.iter().map(|x| turn.inverse() * (x - shift));
        let off = apart(&path, back);
        prop_assert!(off < 1e-6, "turned and shifted: {off:e}\n{chain:?}");
        for scales in ["{ kind = \"auto\" }", "{ kind = \"given\", length = 0.01, force = 3, time = 0.5 }"] {
            let off = apart(&path, run(&chain, &Setting { scales, ..plain.clone() })?.0.into_iter());
            prop_assert!(off < 1e-6, "scales {scales}: {off:e}\n{chain:?}");
        }
        let off = apart(&path, run(&chain, &Setting { backwards: true, ..plain })?.0.into_iter());
        prop_assert!(off < 1e-6, "backwards: {off:e}\n{chain:?}");
        Ok(())
    });
}
