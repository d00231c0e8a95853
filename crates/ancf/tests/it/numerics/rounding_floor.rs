//! Rounding floor of Newton's method: tolerances and steps at the limit of the arithmetic.

use std::ops::Range;

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::model::{At, Body, End, Joint, NamedPosition, Place};
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::{Energy, Local, LocalMatrix, State, System, Term, Weights};
use ancf::solver::newton::{Newton, StopRule};

use crate::common::models::rod;

/// Two rods with joints to the ground and to each other.
fn two_rods() -> Model {
    let mut model = rod::revolute(2);
    let mut second = rod::beam(&mut model).clone();
    (second.name, second.from, second.to) = ("second".into(), [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]);
    let a = Place::new("second", At::Named(NamedPosition::Start));
    model.joints.push(Joint::spherical("elbow", a, End::Place(rod::end())));
    model.bodies.push(Body::Beam(second));
    model
}

fn models() -> [(&'static str, Model); 4] {
    [
        ("clamp", rod::cantilever(5)),
        ("revolute", rod::revolute(5)),
        ("spherical", rod::spherical(5)),
        ("two rods", two_rods()),
    ]
}

/// Advances 100 steps by the scheme ADAMS. Returns the number of steps that ended at the rounding floor.
fn floors(name: &str, assembly: &Assembly, start: State, tolerance: f64, step: f64) -> u32 {
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(tolerance), 50).unwrap();
    let from = start.t;
    let mut dynamics = TimeStepper::new(&assembly.system, SchemeCoefficients::ADAMS, newton, 0, start);
    let floors = (1..=100).map(|i| match dynamics.advance(from + step * f64::from(i)) {
        Ok(report) => u32::from(report.floor),
        Err(error) => {
            panic!(
                "{name}, {tolerance:e}, step {step:e}: {error} ({})",
                assembly.name_of(error.worst.unwrap_or(0))
            )
        }
    });
    floors.sum()
}

/// Tolerances below rounding end at the floor; usual tolerances do not reach it.
#[test]
fn tolerances_below_rounding_end_at_the_floor() {
    for (name, model) in models() {
        let assembly = model.assemble().unwrap();
        let floors = |tolerance| floors(name, &assembly, assembly.rest(), tolerance, 1e-3);
        assert_eq!(floors(1e-8), 0, "{name}");
        floors(1e-12);
        floors(1e-14);
        assert!(floors(1e-16) > 90, "{name}");
    }
}

/// Steps down to 10⁻¹³, from rest and from a state in motion.
#[test]
fn small_steps_converge() {
    for (name, model) in models() {
        let assembly = model.assemble().unwrap();
        let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-8), 50).unwrap();
        let mut dynamics =
            TimeStepper::new(&assembly.system, SchemeCoefficients::ADAMS, newton, 0, assembly.rest());
        (1..=300).for_each(|i| _ = dynamics.advance(1e-3 * f64::from(i)).unwrap());
        for start in [assembly.rest(), State { t: 0.0, ..dynamics.state().clone() }] {
            for step in [1e-6, 1e-9, 1e-10, 1e-11, 1e-13] {
                for tolerance in [1e-8, 1e-14] {
                    floors(name, &assembly, start.clone(), tolerance, step);
                }
            }
        }
    }
}

/// Mass with a constraint without root: q − 1 = 0 with a jump across zero, or q² + 1 = 0.
struct Unsolvable {
    jump: Option<f64>,
}

impl Unsolvable {
    /// Φ and its derivative.
    fn phi(&self, q: f64) -> [f64; 2] {
        match self.jump {
            Some(jump) => [q - 1.0 + jump * (q - 1.0).signum(), 1.0],
            None => [q * q + 1.0, 2.0 * q],
        }
    }
}

impl Term for Unsolvable {
    fn coordinates(&self) -> &[usize] {
        &[0]
    }

    fn multipliers(&self) -> Range<usize> {
        0..1
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let [phi, slope] = self.phi(at.q[0]);
        r[0] += at.a[0] - 1.0 + slope * at.lambda[0];
        r[1] += phi;
    }

    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        floor[0] += f64::EPSILON * (at.a[0].abs() + 1.0 + at.lambda[0].abs());
        floor[1] += f64::EPSILON * (1.0 + at.q[0].abs());
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        k.add(0, 0, w.a);
        k.add(1, 0, self.phi(at.q[0])[1]);
    }

    fn energy(&self, _: &Local<'_>) -> Energy {
        Energy { kinetic: 1.0, ..Energy::default() }
    }
}

/// Constraints without a root, or with a gap of 10⁻⁹ or 10⁻¹³, are no rounding errors.
#[test]
fn unsolvable_constraints_fail() {
    for jump in [None, Some(1e-9), Some(1e-13)] {
        let system = System::new(1, 1, vec![Box::new(Unsolvable { jump })]);
        let newton = Newton::new(system.matrix(), StopRule::Energy(1e-14), 50).unwrap();
        let mut dynamics = TimeStepper::new(&system, SchemeCoefficients::ADAMS, newton, 0, State::rest(1, 1));
        let ended = dynamics.advance(1e-3);
        assert!(ended.is_err(), "{jump:?}: {ended:?}");
    }
}
