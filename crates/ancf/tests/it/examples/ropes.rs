//! Ropes, cables, band brake and bow.

use std::f64::consts::PI;

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::model::{Analysis, Load};
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::State;
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::Vector3;

use crate::common::assertions::assert_relative;
use crate::common::models::files::model;
use crate::common::solutions::{Run, momenta};

const GRAVITY: f64 = 9.81;

/// Reads `models/{name}.toml` with another step and spectral radius.
fn refined(name: &str, step: f64, radius: f64) -> Model {
    let mut model = model(name);
    let Analysis::Dynamics(dynamics) = &mut model.analysis else { panic!("{name} is a dynamic analysis") };
    dynamics.step = ancf::model::Step::Fixed(step);
    dynamics.scheme = ancf::model::Scheme::GeneralizedAlpha { spectral_radius: radius };
    model
}

/// Horizontal tension, sag and end tension of the elastic catenary relative to w, by independent integration.
#[test]
fn catenary_has_its_tension_and_sag() {
    let run = Run::of(&model("catenary"));
    let w = 1100.0 * GRAVITY * PI * 0.002_f64.powi(2);
    for (end, outwards) in [("left.f", -1.0), ("right.f", 1.0)] {
        let force = run.last_vector(end);
        assert_relative("H", outwards * force.x, 4.597_764_795_843_918 * w, 5e-5);
        assert_relative("half of the weight", force.z, 6.0 * w, 1e-9);
        assert_relative("tension", force.norm(), 7.559_063_507_994_999 * w, 5e-5);
    }
    let middle = run.last_vector("middle.");
    assert_relative("sag", -middle.z, 2.979_298_712_151_081, 1e-5);
    assert!(middle.xy().norm() < 1e-9);
}

/// Integrates a string without bending stiffness from its start. Returns the position and the tension at its end.
///
/// T′ = −load(t), r′ = (1 + |T|/EA) t, by the Runge-Kutta method.
fn string_end(
    start: Vector3<f64>,
    force: Vector3<f64>,
    length: f64,
    rigidity: f64,
    load: impl Fn(Vector3<f64>) -> Vector3<f64>,
) -> (Vector3<f64>, Vector3<f64>) {
    let rates = |tension: Vector3<f64>| {
        let tangent = tension.normalize();
        [tangent * (1.0 + tension.norm() / rigidity), -load(tangent)]
    };
    let (mut r, mut tension, h) = (start, force, length / 2000.0);
    for _ in 0..2000 {
        let a = rates(tension);
        let b = rates(tension + a[1] * (0.5 * h));
        let c = rates(tension + b[1] * (0.5 * h));
        let d = rates(tension + c[1] * h);
        let mean = |i: usize| (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]) * (h / 6.0);
        (r, tension) = (r + mean(0), tension + mean(1));
    }
    (r, tension)
}

/// Bernoulli's hanging chain, from a vertical and from an inclined initial shape.
#[test]
fn hanging_rope_has_bernoullis_frequencies() {
    let zeros = [2.404_825_557_695_773, 5.520_078_110_286_311, 8.653_727_912_911_013];
    let straight = model("hanging_rope");
    let mut inclined = straight.clone();
    let ancf::model::Body::Cable(cable) = &mut inclined.bodies[0] else { panic!("the body is a cable") };
    cable.to = [1.8, 0.0, -2.4];
    for model in [straight, inclined] {
        let run = Run::of(&model);
        for (i, found) in run.column("frequency").iter().enumerate() {
            assert_relative("frequency", *found, zeros[i / 2] / (4.0 * PI) * (GRAVITY / 3.0).sqrt(), 3e-5);
        }
    }
}

/// Without current: elastic catenary. With current: a string integrated from the anchor force ends at the fairlead with its
/// force.
#[test]
fn mooring_line_balances_weight_and_drag() {
    const AREA: f64 = 4.056e-3;
    const FAIRLEAD: Vector3<f64> = Vector3::new(100.0, 0.0, 58.46876);
    let (wet, rigidity) = ((7850.0 - 1025.0) * GRAVITY * AREA, 3.38e10 * AREA);
    let with = |current: [f64; 3]| {
        let mut model = model("mooring");
        let Load::Fluid(fluid) = &mut model.loads[0] else { panic!("the load is a fluid") };
        fluid.current = current;
        let Analysis::Statics(statics) = &mut model.analysis else { panic!("the analysis is static") };
        statics.stop = ancf::model::Stop::Energy { tolerance: 1e-12 };
        let run = Run::of(&model);
        let [anchor, fairlead] = ["anchor.f", "fairlead.f"].map(|name| run.last_vector(name));
        let drag = |t: Vector3<f64>| {
            let current = Vector3::from(current);
            let along = t * t.dot(&current);
            let across = current - along;
            let half = 0.5 * 1025.0 * 0.04;
            let drag = across * (2.4 * half * across.norm()) + along * (1.15 * PI * half * along.norm());
            drag - Vector3::z() * wet
        };
        let (end, force) = string_end(Vector3::zeros(), -anchor, 120.0, rigidity, drag);
        assert!((end - FAIRLEAD).norm() < 1e-5 * 120.0, "{end} {anchor} {fairlead}");
        assert!((force - fairlead).norm() < 1e-4 * fairlead.norm(), "{force} and {fairlead}");
        [anchor, fairlead]
    };
    let [anchor, fairlead] = with([0.0; 3]);
    assert_relative("weight", anchor.z + fairlead.z, 120.0 * wet, 1e-7);
    // Equations of the elastic catenary, solved for the anchor force.
    assert_relative("H", fairlead.x, 25_414.715_355, 1e-5);
    assert_relative("tension", fairlead.norm(), 41_288.813_439, 1e-5);
    let [anchor, fairlead] = with([0.5, 1.2, 0.0]);
    assert!((anchor + fairlead).y < -0.5 * 1025.0 * 0.04 * 2.4 * 1.2 * 1.2 * 100.0, "lateral drag");
}

/// Centre of mass, linear momentum and angular momentum about the centre of mass.
fn motion(assembly: &Assembly, s: &State, mass: f64) -> [Vector3<f64>; 3] {
    let mut places = vec![0.0; s.q.len()];
    for vector in assembly.bodies().flat_map(|(_, body)| body.vectors(s)) {
        places[vector.first..vector.first + 3].copy_from_slice(vector.value.as_slice());
    }
    let center = momenta(assembly, s, &places)[0] / mass;
    let [p, angular] = momenta(assembly, s, &s.v);
    [center, p, angular - center.cross(&p)]
}

/// The centre of mass moves as a point mass under the weight and the pulse; afterwards the angular momentum is constant.
#[test]
fn thrown_rope_conserves_its_momenta() {
    let mut model = model("rope");
    model.scales = ancf::model::ScaleChoice::None;
    let assembly = model.assemble().unwrap();
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
    let start = assembly.start(&model);
    let mut dynamics =
        TimeStepper::new(&assembly.system, SchemeCoefficients::AVERAGE_ACCELERATION, newton, 0, start);
    dynamics.restart(0.0).unwrap();
    let mass = 1000.0 * PI * 0.015_f64.powi(2) * 3.0;
    let (thrown, weight) = (Vector3::new(3.0, 0.0, 7.0) * mass, Vector3::z() * (-GRAVITY * mass));
    // Steps of 0.1 ms, one of which ends with the pulse.
    let step = 1e-4;
    let mut after = None;
    for i in 1..=6000 {
        let t = step * f64::from(i);
        dynamics.advance(t).unwrap();
        if i == 1000 {
            dynamics.restart(t).unwrap();
        }
        if i % 500 != 0 || i <= 1000 {
            continue;
        }
        let [center, p, own] = motion(&assembly, dynamics.state(), mass);
        let impulse = p - thrown - weight * t;
        assert!(
            (impulse - Vector3::new(0.0, -2.0, 2.0)).norm() < 2e-3,
            "impulse of the pulse load: {impulse}"
        );
        let (t0, c0, p0, own0) = *after.get_or_insert((t, center, p, own));
        let s = t - t0;
        let parabola = c0 + (p0 * s + weight * (0.5 * s * s)) / mass;
        assert!((center - parabola).norm() < 1e-9, "{t}: {}", (center - parabola).norm());
        assert!((own - own0).norm() < 2e-5 * own0.norm(), "{t}: {:e}", (own - own0).norm() / own0.norm());
    }
}

#[test]
fn thrown_rope_energy_balance_is_of_second_order() {
    let [coarse, fine] = [1e-4, 5e-5].map(|step| Run::of(&refined("rope", step, 1.0)).energy_error());
    assert!(fine < 1e-6, "{fine:e}");
    assert!((3.0..5.5).contains(&(coarse / fine)), "{coarse:e} {fine:e}");
}

/// Tensions on both sides of the pulley with the weight of the band: T′ = −μ (T + w R sin φ) + w R cos φ from the tight side.
#[test]
fn band_brake_obeys_the_belt_equation() {
    let run = Run::of(&model("belt"));
    let (friction, radius) = (0.3, 0.1005);
    let cord = 1200.0 * GRAVITY * PI * 0.0025_f64.powi(2) * 0.3;
    let hang = 1200.0 * GRAVITY * 0.02 * 0.001 * radius;
    // Integration from the slack side: dT/dψ = μ (T + w R sin ψ) + w R cos ψ, ψ = π − φ.
    let slack = 2.0 * GRAVITY + cord;
    let (mut tight, h) = (slack, PI / 1000.0);
    for i in 0..1000 {
        let rate = |psi: f64, t: f64| friction * (t + hang * psi.sin()) + hang * psi.cos();
        let psi = h * f64::from(i);
        let half = tight + 0.5 * h * rate(psi, tight);
        tight += h * rate(psi + 0.5 * h, half);
    }
    assert_relative("tension", -run.last("anchor.fz"), tight - cord, 1e-3);
    assert_relative("Euler", (-run.last("anchor.fz") + cord) / slack, (friction * PI).exp(), 3e-3);
    let moment = (tight - slack) * radius;
    assert_relative("moment", run.last("motor.my"), moment, 2e-3);
    let weight = (5.0 + 2.0 + 1200.0 * 0.02 * 0.001 * PI * radius) * GRAVITY + 2.0 * cord;
    assert_relative("weight", run.last("motor.fz") + run.last("anchor.fz"), weight, 1e-6);
    assert!((run.last("motor.fx") + run.last("anchor.fx")).abs() < 1e-4 * weight, "no horizontal force");
    // Steady state after t = 0.5: the power of the motor is dissipated.
    let of = |name: &str| {
        let (t, x) = (run.column("t"), run.column(name));
        let first = t.iter().position(|&t| t > 0.5 - 1e-9).unwrap();
        (x.last().unwrap() - x[first]) / (t.last().unwrap() - t[first])
    };
    assert_relative("power of the motor", of("work"), moment * 10.0, 2e-3);
    assert_relative("dissipated power", of("dissipated"), of("work"), 2e-5);
    // Numerical damping of the start, of second order: a quarter with half the step.
    assert!(run.largest("balance") < 3e-5 * run.last("work"), "{:e}", run.largest("balance"));
}

/// Efficiency: kinetic energy of the arrow relative to the work of the draw. Energy balance and forces on the arrow.
#[test]
fn bow_converts_draw_work_to_kinetic_energy() {
    let run = Run::of(&refined("bow", 3.2e-5, 1.0));
    let (t, x, v) = (run.column("t"), run.column("arrow.x"), run.column("arrow.vx"));
    let draw: f64 = (1..t.len())
        .filter(|&i| t[i] < 0.4 + 1e-9)
        .map(|i| -80.0 / 0.4 * 0.5 * (t[i] + t[i - 1]) * (x[i] - x[i - 1]))
        .sum();
    assert_relative("work of the draw", run.last("work"), draw, 1e-4);
    let arrow = v.iter().map(|v| 0.5 * 0.02 * v * v).fold(0.0, f64::max);
    let efficiency = arrow / draw;
    assert!((0.7..0.95).contains(&efficiency), "{efficiency}");
    assert!(run.energy_error() < 1e-6, "{:e}", run.energy_error());
    for (tip, end) in run.vectors("tip.").iter().zip(run.vectors("string end.")) {
        assert!((tip - end).norm() < 1e-10, "{:e}", (tip - end).norm());
    }
    // Newton's law of the arrow after the release.
    let (force, a) = (run.column("nock.fx"), run.column("arrow.ax"));
    for i in (0..t.len()).filter(|&i| t[i] > 0.401) {
        assert!((0.02 * a[i] + force[i]).abs() < 1e-4 * run.largest("nock.fx"), "{}", t[i]);
    }
    let [across, along] = ["arrow.y", "arrow.z"].map(|name| run.largest(name));
    assert!(across.max(along) < 1e-10, "lateral displacement of the arrow");
}
