//! Step size control: errors are below the tolerance and of its order of magnitude.

use ancf::Model;
use ancf::model::{self, ScaleChoice, Start, Step};
use ancf::solver::dynamics::{AdaptiveStepper, ErrorControl, SchemeCoefficients, TimeStepper};
use ancf::solver::equations::{EquationsOfMotion, Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::newton::{Newton, SolveError, SolveFailure, StopRule};
use ancf::solver::sparse::SparseMatrix;

use super::pendulum;
use crate::common::assertions::assert_relative;
use crate::common::models::rod;
use crate::common::solutions::{self, Run};

/// Mass of the rod.
const MASS: f64 = 8030.0 * std::f64::consts::PI * 1e-4;

fn control(tolerance: f64, length: f64, mass: f64, duration: f64) -> ErrorControl {
    let (largest, smallest) = (duration, ErrorControl::SMALLEST * duration);
    ErrorControl { tolerance, length, mass, duration, initial: None, largest, smallest }
}

/// Root mean square distance of two states.
fn distance(mass: &SparseMatrix, total: f64, a: &State, b: &State) -> f64 {
    let mut d: Vec<f64> = a.q.iter().zip(&b.q).map(|(a, b)| a - b).collect();
    d.resize(mass.pattern().size(), 0.0);
    let mut force = d.clone();
    mass.multiply(&d, &mut force);
    (d.iter().zip(&force).map(|(d, f)| d * f).sum::<f64>() / total).sqrt()
}

fn mass(system: &System, s: &State) -> SparseMatrix {
    let mut mass = system.matrix();
    system.tangent(s, Weights::MASS, &mut mass);
    mass
}

fn dynamics(system: &System, scheme: SchemeCoefficients, start: State) -> TimeStepper<'_, System> {
    let newton = Newton::new(system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
    let mut dynamics = TimeStepper::new(system, scheme, newton, 0, start);
    dynamics.restart(0.0).unwrap();
    dynamics
}

/// Steps and rejected steps.
type Count = [u32; 2];

/// Integrates adaptively. Returns states at equally spaced instants.
fn integrate(
    dynamics: &mut TimeStepper<'_, System>,
    control: ErrorControl,
    count: usize,
) -> Result<(Vec<State>, Count), SolveError> {
    let mut adaptive = AdaptiveStepper::new(dynamics, control);
    let (mut states, mut steps) = (Vec::new(), [0, 0]);
    for i in 1..=count {
        let to = control.duration * i as f64 / count as f64;
        while dynamics.state().t < to {
            let report = adaptive.step(dynamics, to)?;
            steps = [steps[0] + 1, steps[1] + report.rejected];
        }
        assert_eq!(dynamics.state().t, to, "the instant is reached exactly");
        states.push(dynamics.state().clone());
    }
    Ok((states, steps))
}

/// Largest error over the instants, relative to the length and to the tolerance.
fn error(mass: &SparseMatrix, control: ErrorControl, states: &[State], exact: &[State]) -> f64 {
    assert_eq!(states.len(), exact.len());
    let errors = states.iter().zip(exact).map(|(a, b)| distance(mass, control.mass, a, b));
    errors.fold(0.0, f64::max) / control.length / control.tolerance
}

/// Errors of a rod under its weight for three tolerances, against steps of 50 μs.
fn errors_of_the_rod(model: &Model, duration: f64) -> [f64; 3] {
    let assembly = model.assemble().unwrap();
    let (system, mass) = (&assembly.system, mass(&assembly.system, &assembly.rest()));
    let scheme = SchemeCoefficients::generalized_alpha(0.8);
    let mut reference = dynamics(system, scheme, assembly.rest());
    let steps = (duration / 5e-5).round() as usize;
    let exact = (1..=steps).map(|i| {
        reference.advance(duration * i as f64 / steps as f64).unwrap();
        reference.state().clone()
    });
    let exact: Vec<State> = exact.skip(steps / 20 - 1).step_by(steps / 20).collect();
    [1e-3, 1e-4, 1e-5].map(|tolerance| {
        let control = control(tolerance, rod::LENGTH, MASS, duration);
        let (states, _) = integrate(&mut dynamics(system, scheme, assembly.rest()), control, 20).unwrap();
        error(&mass, control, &states, &exact)
    })
}

/// Asserts that errors are below the tolerance by at most a factor of ten.
fn assert_efficient(name: &str, errors: &[f64]) {
    for error in errors {
        assert!((0.1..=1.0).contains(error), "{name}: {errors:?} of the tolerances");
    }
}

#[test]
fn pendulum_errors_are_below_the_tolerance() {
    for stretch in [0.0, 0.3] {
        let (system, exact) = (pendulum::system(stretch), pendulum::exact(stretch, 5.0, 20));
        let mass = mass(&system, &exact[0]);
        let errors = [1e-3, 1e-4, 1e-5].map(|tolerance| {
            let control = control(tolerance, pendulum::ROD, pendulum::MASS, 5.0);
            let mut dynamics =
                pendulum::dynamics(&system, SchemeCoefficients::generalized_alpha(0.8), stretch);
            let (states, steps) = integrate(&mut dynamics, control, 20).unwrap();
            assert!(steps[1] < 5, "{steps:?}");
            error(&mass, control, &states, &exact[1..])
        });
        assert_efficient(&format!("stretch {stretch}"), &errors);
    }
}

/// Bending of the stiff rod is about 1e-3 of its length. At that tolerance the error filter may or may not resolve it.
#[test]
fn rod_errors_are_below_the_tolerance() {
    let stiff = errors_of_the_rod(&rod::revolute(2), 1.0);
    assert!(stiff[0] > 0.01 && stiff[0] < 1.0, "{stiff:?}");
    assert_efficient("stiff pendulum", &stiff[1..]);
    let mut soft = rod::revolute(2);
    rod::material(&mut soft).young /= 1e3;
    assert_efficient("soft pendulum", &errors_of_the_rod(&soft, 1.0));
    assert_efficient("cantilever", &errors_of_the_rod(&rod::cantilever(2), 0.5));
}

/// Force that starts at t = 0.7.
struct StepForce;

impl Term for StepForce {
    fn coordinates(&self) -> &[usize] {
        &[0]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] -= if at.t < 0.7 { 0.0 } else { 30.0 };
    }

    fn rounding(&self, _: &Local<'_>, floor: &mut [f64]) {
        floor[0] += f64::EPSILON * 30.0;
    }

    fn tangent(&self, _: &Local<'_>, _: Weights, _: &mut LocalMatrix<'_>) {}
}

/// Jump of a load at the end of a step: the next step starts with the right-hand limit.
#[test]
fn load_jumps_keep_second_order() {
    let system = pendulum::system_with(0.0, vec![Box::new(StepForce)]);
    let end = |steps: u32| {
        let mut dynamics = pendulum::dynamics(&system, SchemeCoefficients::generalized_alpha(0.8), 0.0);
        for i in 1..steps {
            dynamics.advance(0.7 * f64::from(i) / f64::from(steps)).unwrap();
        }
        dynamics.advance(0.7_f64.next_down()).unwrap();
        dynamics.restart(0.7).unwrap();
        for i in 1..=steps {
            dynamics.advance(0.7 + 0.3 * f64::from(i) / f64::from(steps)).unwrap();
        }
        dynamics.state().clone()
    };
    let runs = [100, 200, 400].map(end);
    let difference = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    for (what, of) in [("q", (|s| &s.q) as fn(&State) -> &Vec<f64>), ("v", |s| &s.v), ("λ", |s| &s.lambda)] {
        let [a, b, c] = runs.each_ref().map(of);
        let order = (difference(a, b) / difference(b, c)).log2();
        assert!((order - 2.0).abs() < 0.1, "order {order} in {what}");
    }
}

/// The failure is reported if the tolerance needs steps below the smallest one.
#[test]
fn too_small_steps_are_a_failure() {
    let system = pendulum::system(0.0);
    let mut dynamics = pendulum::dynamics(&system, SchemeCoefficients::generalized_alpha(0.8), 0.0);
    let control = ErrorControl { smallest: 1e-3, ..control(1e-9, pendulum::ROD, pendulum::MASS, 1.0) };
    let error = integrate(&mut dynamics, control, 1).expect_err("steps of 1e-3 are too large");
    assert_eq!(error.failure, SolveFailure::StepTooSmall);
}

/// Steps divided for Newton's method keep their size in the following steps and grow by a factor of two.
#[test]
fn divided_steps_grow_by_a_factor_of_two() {
    let system = pendulum::system(0.0);
    let newton = Newton::new(system.matrix(), StopRule::Energy(1e-8), 3).unwrap();
    let start = pendulum::exact(0.0, 1.0, 1).swap_remove(0);
    let mut dynamics =
        TimeStepper::new(&system, SchemeCoefficients::generalized_alpha(0.8), newton, 12, start);
    dynamics.restart(0.0).unwrap();
    let substeps: Vec<u32> =
        (1..=40).map(|i| dynamics.advance(0.2 * f64::from(i)).unwrap().substeps).collect();
    assert!(substeps.iter().any(|n| *n > 1), "{substeps:?}");
    assert!(substeps.windows(2).all(|n| n[1] >= n[0] / 2), "by a factor of two at most: {substeps:?}");
}

/// Motion of a model as with small steps, recorded at intervals or at every step, independent of the scales.
#[test]
fn adaptive_runs_agree_with_small_steps() {
    let model = |step: Step, interval: Option<f64>| {
        let mut model = rod::revolute(2);
        model.output.interval = interval;
        let settings = rod::settings(&mut model);
        (settings.duration, settings.step, settings.start) = (0.5, step, Start::Consistent);
        settings.scheme = model::Scheme::GeneralizedAlpha { spectral_radius: 0.8 };
        model
    };
    let adaptive = Step::Adaptive { tolerance: 1e-4, initial: None, largest: None };
    let fine = Run::of(&model(Step::Fixed(1e-4), Some(0.04)));
    let runs = [
        Run::of(&model(adaptive, Some(0.04))),
        Run::of(&Model { scales: ScaleChoice::Auto, ..model(adaptive, Some(0.04)) }),
    ];
    let times: Vec<f64> = (0..13).map(|i| f64::from(i) * 0.04).chain([0.5]).collect();
    for run in &runs {
        let difference = run.column("t").iter().zip(&times).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(run.column("t").len() == times.len() && difference < 1e-15, "{:?}", run.column("t"));
        assert!(solutions::distance(&run.vectors("tip."), &fine.vectors("tip.")) < 2e-4);
    }
    assert_eq!(runs[0].summary.steps, runs[1].summary.steps);
    let all = Run::of(&model(adaptive, None));
    assert_eq!(all.column("t").len() as u64, all.summary.steps + 1);
    assert_eq!(all.column("t").last(), Some(&0.5));
}

/// Duration that is no multiple of the step.
#[test]
fn last_step_ends_at_the_duration() {
    let mut model = rod::cantilever(1);
    let settings = rod::settings(&mut model);
    (settings.duration, settings.step) = (0.01, Step::Fixed(3e-3));
    let run = Run::of(&model);
    assert_eq!(run.column("t"), [0.0, 3e-3, 2.0 * 3e-3, 3.0 * 3e-3, 0.01]);
}

/// A remainder far below the step makes the last step longer: accelerations of a step h have rounding errors of ε x/h².
#[test]
fn small_remainder_of_the_duration_is_no_step() {
    let with = |duration: f64| {
        let mut model = rod::cantilever(2);
        let settings = rod::settings(&mut model);
        (settings.duration, settings.step) = (duration, Step::Fixed(1e-3));
        Run::of(&model)
    };
    let whole = with(0.05);
    let acceleration = |run: &Run| *run.column("tip.ay").last().unwrap();
    for (remainder, steps) in [(1e-15, 50), (1e-12, 50), (1e-9, 50), (0.9e-5, 50), (1.1e-5, 51), (5e-4, 51)] {
        let run = with(0.05 + remainder);
        let times = run.column("t");
        assert_eq!(
            (times.len(), times.last()),
            (steps + 1, Some(&(0.05 + remainder))),
            "remainder {remainder}"
        );
        if remainder < 1e-8 {
            assert_relative("acceleration", acceleration(&run), acceleration(&whole), 1e-4);
        }
    }
}
