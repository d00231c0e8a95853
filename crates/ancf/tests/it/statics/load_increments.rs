//! Equilibria by load increments: iterations, independence of the increments, loss of equilibrium.

use std::f64::consts::PI;
use std::ops::ControlFlow;

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::model::{Beam, Body, Formulation, Load, ScaleChoice};
use ancf::solver::equations::{Energy, EquationsOfMotion, Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::factor::Factor;
use ancf::solver::newton::{EquilibriumError, Newton, SolveFailure, StopRule};
use ancf::solver::statics::{
    ArcLength, ArcLengthSteps, EndConditions, EndReason, Equilibrium, LoadIncrements, LoadStepper, PathPoint,
};
use nalgebra::{DMatrix, Vector3};

use crate::common::models::rod;

fn newton(system: &System) -> Newton {
    Newton::new(system.matrix(), StopRule::Energy(1e-10), 50).unwrap()
}

fn unloaded(assembly: &Assembly) -> State {
    State { load: 0.0, ..assembly.rest() }
}

/// Equilibrium under the full load, its report and the number of accepted increments.
fn solve(assembly: &Assembly, increments: LoadIncrements) -> (State, Equilibrium, usize) {
    let system = &assembly.system;
    let mut statics = LoadStepper::new(system, newton(system), increments, unloaded(assembly));
    let mut accepted = 0;
    let count = |_: &State, _: &Equilibrium| {
        accepted += 1;
        ControlFlow::Continue(())
    };
    let report = statics.advance(1.0, count).unwrap();
    (statics.state().clone(), report, accepted)
}

fn tip(assembly: &Assembly, state: &State) -> Vector3<f64> {
    assembly.probes[0].1.value(state)
}

/// Rod without gravity under a tip force in multiples of EI/L².
fn tip_loaded(elements: u32, force: [f64; 3]) -> Model {
    let mut model = rod::cantilever(elements);
    let unit = model.materials["steel"].young * model.sections["circle"].moments().yy / rod::LENGTH.powi(2);
    model.gravity = [0.0; 3];
    model.loads = vec![Load::force(rod::end(), force.map(|f| f * unit))];
    model
}

/// Rod with E/1000 under its own weight.
fn soft(elements: u32) -> Model {
    let mut model = rod::cantilever(elements);
    rod::material(&mut model).young /= 1000.0;
    model
}

/// Small deflections: the residual reaches its rounding error in at most five iterations on any mesh.
#[test]
fn own_weight_converges_in_five_iterations() {
    for elements in [1, 10, 100, 1000] {
        let assembly = rod::cantilever(elements).assemble().unwrap();
        let (state, report, accepted) = solve(&assembly, LoadIncrements::default());
        assert!(report.iterations <= 5, "{elements} elements: {report:?}");
        assert_eq!((accepted, report.attempts, report.unstable), (1, 1, Some(0)));
        if elements == 1000 {
            let exact = -2.041186330e-3; // Reissner's rod
            assert!((tip(&assembly, &state).y / exact - 1.0).abs() < 1e-6);
        }
    }
}

/// Full load in one increment.
#[test]
fn large_deflections_converge_in_one_increment() {
    let cases =
        [(tip_loaded(32, [0.0, -1.0, 0.0]), 10), (tip_loaded(32, [0.0, -10.0, 0.0]), 20), (soft(32), 20)];
    for (model, limit) in cases {
        let (_, report, accepted) = solve(&model.assemble().unwrap(), LoadIncrements::default());
        assert!(report.iterations <= limit, "{report:?}");
        assert_eq!((accepted, report.unstable), (1, Some(0)));
    }
}

/// The final state does not depend on the load increments.
#[test]
fn increments_do_not_change_the_equilibrium() {
    for model in [tip_loaded(16, [0.0, -10.0, 0.0]), tip_loaded(16, [-1.0, -1.0, 0.7]), soft(16)] {
        let assembly = model.assemble().unwrap();
        let ends = [1.0, 0.3, 0.1, 0.03].map(|first| {
            let (state, ..) = solve(&assembly, LoadIncrements { first, ..LoadIncrements::default() });
            assert_eq!(state.load, 1.0);
            tip(&assembly, &state)
        });
        for end in &ends[1..] {
            assert!((end - ends[0]).norm() <= 1e-9, "{end} and {}", ends[0]);
        }
    }
}

/// Metres and millimetres: equal iterations, increments, arc steps and tip positions.
#[test]
fn units_do_not_change_iterations_and_equilibria() {
    for model in [tip_loaded(8, [0.0, -10.0, 0.0]), soft(8), tip_loaded(8, [-4.0, -1e-3, 0.0])] {
        let run = |length: f64, force: f64| {
            let choice = ScaleChoice::Given { length, force, time: Some(1.0) };
            let model = Model { scales: choice, ..model.clone() };
            let assembly = model.scaled(&model.scales().scales).assemble().unwrap();
            let (state, report, accepted) = solve(&assembly, LoadIncrements::default());
            let mut counts = vec![(report.iterations, report.attempts), (accepted as u32, 0)];
            let cost = |_: &State, PathPoint { equilibrium: e, .. }: &PathPoint| (e.iterations, e.attempts);
            let (end, costs) = follow(&assembly, cost);
            counts.extend(costs);
            (counts, [state, end].map(|state| tip(&assembly, &state) * length))
        };
        let (metres, millimetres) = (run(1.0, 1.0), run(1e-3, 1.0));
        assert_eq!(metres.0, millimetres.0);
        for (a, b) in metres.1.iter().zip(&millimetres.1) {
            assert!((a - b).norm() <= 1e-9, "{a} and {b}");
        }
    }
}

/// Column under P = `part` π²EI/4L² and the lateral force `imperfection` P.
fn column(part: f64, imperfection: f64) -> Assembly {
    let force = part * PI.powi(2) / 4.0;
    let mut model = tip_loaded(32, [-force, imperfection * force, 0.0]);
    let Body::Beam(Beam { formulation, .. }) = &mut model.bodies[0] else { panic!("the column is a beam") };
    *formulation = Formulation::Quadratic;
    model.assemble().unwrap()
}

/// Follows the path of an assembly to its full load and evaluates `each` at its points.
fn follow<T>(assembly: &Assembly, mut each: impl FnMut(&State, &PathPoint) -> T) -> (State, Vec<T>) {
    let system = &assembly.system;
    let mut path =
        ArcLength::new(system, newton(system), ArcLengthSteps::from(0.1), unloaded(assembly)).unwrap();
    let (until, mut seen) =
        (EndConditions { load: Some(1.0), points: 1000, length: f64::INFINITY }, Vec::new());
    let see = |s: &State, point: &PathPoint| {
        seen.push(each(s, point));
        ControlFlow::Continue(())
    };
    assert_eq!(path.follow(&until, see).unwrap(), EndReason::Load);
    (path.state().clone(), seen)
}

/// Post-buckling of a column with an imperfection of 10⁻⁶, by load increments and by arc steps.
///
/// The straight state is an unstable equilibrium. Source: inextensible elastica by elliptic integrals, P over Euler's load and
/// tip at 20°, 60°, 90° and 120°. The tolerance covers the finite thickness, d/L = 1/50.
#[test]
fn buckled_column_is_the_elastica() {
    for (part, x, y) in [
        (1.0153968655397, 0.96973090736352, 0.2194130423956),
        (1.1517196204691, 0.74101960607633, 0.59320764616489),
        (1.3932039296857, 0.45694658104446, 0.76275976350181),
        (1.8848008689781, 0.12315997240512, 0.80317099000746),
    ] {
        let assembly = column(part, 1e-6);
        let (state, report, _) = solve(&assembly, LoadIncrements::default());
        assert_eq!(report.unstable, Some(0));
        let end = tip(&assembly, &state);
        assert!((end - Vector3::new(x, y, 0.0)).norm() <= 2.5e-3, "{end} instead of {x}, {y}");
        let (state, _) = follow(&assembly, |_, _| ());
        assert!((tip(&assembly, &state) - end).norm() <= 1e-9);
    }
}

/// Without imperfection the path is straight; two directions become unstable at Reissner's buckling load.
///
/// P (1 − P/EA + P/GA) = P_E.
#[test]
fn perfect_column_loses_stability_at_reissners_load() {
    let (state, points) = follow(&column(1.5, 0.0), |s, point| (s.load * 1.5, point.equilibrium.unstable));
    assert!(state.q.iter().all(|q| q.abs() < 1e-3));
    let at = points.iter().position(|(_, unstable)| *unstable != Some(0)).unwrap();
    assert!(points[at..].iter().all(|(_, unstable)| *unstable == Some(2)));
    let reissner = 3739.901442866519 / 3740.132124561166;
    assert!(
        points[at - 1].0 < reissner + 1e-3 && points[at].0 > reissner - 1e-3,
        "{:?}",
        &points[at - 1..=at]
    );
}

/// Softening spring r = sin q − s, without equilibrium for s > 1.
struct SofteningSpring;

impl Term for SofteningSpring {
    fn coordinates(&self) -> &[usize] {
        &[0]
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        r[0] += at.a[0] + at.q[0].sin() - at.load;
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        floor[0] += f64::EPSILON * (at.q[0].sin().abs() + at.load.abs());
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        k.add(0, 0, w.q * at.q[0].cos() + w.a);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        Energy { strain: 1.0 - at.q[0].cos(), potential: -at.load * at.q[0], ..Energy::default() }
    }
}

/// The last equilibrium is kept; the error states its load factor.
#[test]
fn error_beyond_the_limit_load_states_the_load_reached() {
    let system = System::new(1, 0, vec![Box::new(SofteningSpring)]);
    let start = State { load: 0.0, ..State::rest(1, 0) };
    let mut statics = LoadStepper::new(&system, newton(&system), LoadIncrements::default(), start);
    let error: EquilibriumError = statics.advance(2.0, |_, _| ControlFlow::Continue(())).unwrap_err();
    let state = statics.state();
    assert!(error.reached > 0.999 && error.reached <= 1.0, "{error}");
    assert!(error.load > 1.0 && error.load < 1.001, "{error}");
    assert_eq!(state.load, error.reached);
    assert!((state.q[0].sin() - state.load).abs() < 1e-10, "{state:?}");
    assert!(error.to_string().contains(&format!("{}", error.reached)));
    // The load can be decreased again.
    statics.advance(0.5, |_, _| ControlFlow::Continue(())).unwrap();
    assert!((statics.state().q[0] - 0.5_f64.asin()).abs() < 1e-10);
}

/// The receiver gets every equilibrium and can stop the analysis.
#[test]
fn receiver_stops_the_analysis() {
    let assembly = tip_loaded(4, [0.0, -1.0, 0.0]).assemble().unwrap();
    let increments = LoadIncrements { first: 0.1, ..LoadIncrements::default() };
    let system = &assembly.system;
    let mut statics = LoadStepper::new(system, newton(system), increments, unloaded(&assembly));
    let mut loads = Vec::new();
    let halfway = |s: &State, _: &Equilibrium| {
        loads.push(s.load);
        if s.load >= 0.5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    statics.advance(1.0, halfway).unwrap();
    assert_eq!(statics.state().load, loads[loads.len() - 1]);
    assert!(loads.windows(2).all(|pair| pair[1] > pair[0]) && loads[loads.len() - 1] < 1.0, "{loads:?}");
}

/// A limit of one iteration fails at the start.
#[test]
fn missing_convergence_fails_at_the_start() {
    let assembly = tip_loaded(4, [0.0, -1.0, 0.0]).assemble().unwrap();
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 1).unwrap();
    let mut statics =
        LoadStepper::new(&assembly.system, newton, LoadIncrements::default(), unloaded(&assembly));
    let error = statics.advance(1.0, |_, _| ControlFlow::Continue(())).unwrap_err();
    assert_eq!((error.reached, error.cause.failure), (0.0, SolveFailure::NotConverged));
    assert_eq!(statics.state(), &unloaded(&assembly));
}

/// Sylvester's law of inertia; negative pivots in excess of the multipliers are unstable directions.
#[test]
fn negative_pivots_count_negative_eigenvalues() {
    let mut unstable = Vec::new();
    for part in [0.5, 2.0, 10.0] {
        let assembly = column(part, 0.0);
        let increments = LoadIncrements { trusted: 1.0, ..LoadIncrements::default() };
        let (state, report, _) = solve(&assembly, increments);
        let system = &assembly.system;
        let mut matrix = system.matrix();
        system.tangent(&state, Weights::STIFFNESS, &mut matrix);
        let mut factor = Factor::new(matrix.pattern()).unwrap();
        factor.factorise(&matrix).unwrap();
        let dense = matrix.dense();
        let dense = DMatrix::from_fn(dense.len(), dense.len(), |i, j| dense[i][j]);
        let negative = dense.symmetric_eigenvalues().iter().filter(|&&value| value < 0.0).count();
        assert_eq!(factor.negative_pivots(), Some(negative));
        assert_eq!(report.unstable, Some(negative - system.multipliers()));
        unstable.push(negative - system.multipliers());
    }
    // Below the first, between the first and the second (9 times the first), above the second critical load. Two planes each.
    assert_eq!(unstable, [0, 2, 4]);
}
