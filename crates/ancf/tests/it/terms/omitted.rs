//! Derivatives that the tangent lacks, of force laws with states and signals.

use std::sync::Arc;

use ancf::mechanics::constraints::{BilinearMeasure, MeasureFactor};
use ancf::mechanics::forces::{Signal, SignalSource, StateForce};
use ancf::mechanics::kinematics::{BodyVector, Marker};
use ancf::mechanics::laws::{LawStateVariable, LawUnits, LawVariables, StateLaw};
use ancf::solver::equations::{Term as _, Weights};
use nalgebra::{DMatrix, DVector, Vector3};

use crate::common::random::Random;
use crate::common::sample::{Sample, extrapolated_derivative, residual, tangent};

const UNITS: LawUnits = LawUnits { position: 1.5, time: 0.8, force: 2.0 };

/// Law with two states and signals of all kinds.
fn law() -> StateForce {
    let variables = LawVariables { position: "angle", rate: "rate" };
    let state = |name, rate| LawStateVariable { name, rate, start: 0.2 };
    let states =
        [state("a", "x*t - 0.5*a - a^3 + b*v + d"), state("b", "sin(a*x) - b*v - 0.3*speed*position")];
    let names = ["position", "speed", "d", "approach", "own", "turning"];
    let text = "-2*x*a - 3*x^3 + v*b*position + speed^2 - d*approach + own*turning";
    let law = StateLaw::parse(text, &states, &names, &variables, &[]).unwrap();
    // A point at coordinates 20 .. 23 at an offset, and its distance from a fixed point.
    let point = BodyVector::from(Marker::new([(20, 1.0)], Vector3::new(1.0, 0.5, 0.2)));
    let axis = BodyVector::fixed(Vector3::new(0.6, 0.0, 0.8));
    let along = || {
        let product = (1.0, MeasureFactor::Other(&axis), MeasureFactor::Point(&point));
        SignalSource::Measure(BilinearMeasure::new([product]))
    };
    let signals = [
        Signal::value(along(), 1.5, 0.7),
        Signal::rate(along(), 1.9, 0.0),
        Signal::value(SignalSource::Norm(point.clone()), 1.5, 0.0),
        Signal::rate(SignalSource::Norm(point.clone()), 1.9, 0.1),
        Signal::value(SignalSource::Coordinate(7), 1.0, 0.0),
        Signal::rate(SignalSource::Coordinate(7), 1.25, 0.0),
    ];
    StateForce::new(vec![30, 31, 32], Arc::new(law), UNITS, vec![0.7, 1.3], &signals)
}

/// The tangent and the omitted entries are the derivative of the residual by coordinates, rates and accelerations.
#[test]
fn omitted_entries_complete_the_tangent() {
    let term = law();
    let n = term.coordinates().len();
    assert_eq!(n, 7);
    let mut random = Random(5);
    for _ in 0..10 {
        let mut s = Sample::random(&term, &mut random);
        [&mut s.q, &mut s.v].into_iter().for_each(|x| *x *= 0.3);
        let z = random.vector(n);
        for (w, is_damping) in
            [(Weights::STIFFNESS, false), (Weights { q: 0.0, v: 1.0, a: 0.0 }, true), (Weights::MASS, false)]
        {
            let mut k: DMatrix<f64> = tangent(&term, &s, w);
            let mut add = |i: usize, j: usize, value: f64| k[(i, j)] += value;
            match (w.q != 0.0, is_damping) {
                (true, _) => term.omitted_stiffness(&s.local(), &mut add),
                (_, true) => term.omitted_damping(&s.local(), &mut add),
                _ => {}
            }
            let slope: DVector<f64> = extrapolated_derivative(|h| residual(&term, &s.moved(&z, h, w)));
            let error = (&k * &z - &slope).amax();
            assert!(error < 1e-9 * (1.0 + slope.amax()), "{error:e} of {slope}");
        }
    }
}
