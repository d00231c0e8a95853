//! Linear models against closed forms, modes and the nonlinear motion.

use ancf::record::Series;
use ancf::{LinearModel, StepError, Stepper, simulate};
use nalgebra::{DMatrix, DVector};

use crate::common::models::parse;

const SCALES: [&str; 2] = ["", "scales = { kind = \"given\", length = 3, force = 0.7, time = 0.13 }\n"];

/// Rigid pendulum with a motor at its pin: m = 3, distance 0.8, J = 2.5 about the pin, damping 0.4. Hanging or inverted.
fn pendulum(scales: &str, sign: f64) -> String {
    format!(
        "{scales}gravity = [0, -9.81, 0]\n\
         bodies = [{{ kind = \"rigid\", name = \"rod\", center = [0, {}, 0], mass = 3, inertia = [0.58, 0.1, 0.58] }}]\n\
         inputs = [{{ name = \"torque\" }}, {{ name = \"push\", value = 0 }}]\n\
         probes = [{{ name = \"rod\", on = {{ body = \"rod\", at = \"center\" }} }}]\n\
         [[joints]]\nkind = \"revolute\"\nname = \"pin\"\na = {{ body = \"rod\", at = [0, 0, 0] }}\naxis = [0, 0, 1]\n\
         spring = {{ damping = 0.4 }}\n\
         [[loads]]\nkind = \"moment\"\non = {{ body = \"rod\", at = \"center\" }}\nmoment = [0, 0, 2]\nfollower = true\n\
         time = {{ kind = \"input\", name = \"torque\" }}\n\
         [[loads]]\nkind = \"force\"\non = {{ body = \"rod\", at = \"center\" }}\nforce = [1, 0, 0]\n\
         time = {{ kind = \"input\", name = \"push\" }}\n\
         [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = {{ spectral_radius = 0.9 }}\n",
        0.8 * sign
    )
}

/// θ̈ = ∓(m g d/J) θ − (c/J) θ̇ + (2 T ∓ d F)/J, with the angle, its rate, the centre, and the reaction as outputs.
#[test]
fn pendulum_has_the_closed_form() {
    for scales in SCALES {
        for sign in [1.0, -1.0] {
            let mut stepper = Stepper::new(&parse(&pendulum(scales, sign))).unwrap();
            let model = stepper.linearise(&["pin.angle", "pin.rate", "rod.x", "rod.ax", "pin.fx"]).unwrap();
            let (j, m, d) = (2.5, 3.0, 0.8);
            assert_eq!(model.a.shape(), (2, 2));
            let near = |found: f64, expected: f64| {
                assert!(
                    (found - expected).abs() < 1e-6 * (1.0 + expected.abs()),
                    "{scales}: {found}, not {expected}"
                );
            };
            near(model.a[(1, 0)], sign * m * 9.81 * d / j);
            near(model.a[(1, 1)], -0.4 / j);
            near(model.a[(0, 1)], 1.0);
            assert!(model.rate.amax() < 1e-12);
            // In terms of the angle θ = C x: gain of torque and push on the angular acceleration.
            let of_angle = model.c[(0, 0)];
            near(of_angle * model.b[(1, 0)], 2.0 / j);
            near(of_angle * model.b[(1, 1)], -sign * d / j);
            near(model.c[(1, 1)] / of_angle, 1.0);
            near(model.c[(2, 0)] / of_angle, -sign * d);
            // Feedthrough: acceleration and reaction of the pin (a on end `a`), m ẍ = F + f.
            near(model.d[(3, 1)], d * d / j);
            near(model.d[(4, 1)], m * d * d / j - 1.0);
            assert!(model.c[(2, 1)].abs() < 1e-9 && model.d[(2, 0)].abs() < 1e-9);
            let x = model.state_of(&stepper).unwrap();
            assert!(x.amax() < 1e-12);
            // The descriptor form has the same dynamics on its constraints.
            let z = &model.basis;
            let form = &model.descriptor;
            assert!((&form.constraints * z).amax() < 1e-9 * form.constraints.amax());
            near((z.tr_mul(&(&form.mass * z)))[(0, 0)], 1.0);
            near((z.tr_mul(&(&form.stiffness * z)))[(0, 0)], -model.a[(1, 0)]);
            near((z.tr_mul(&(&form.damping * z)))[(0, 0)], 0.4 / j);
            near((z.tr_mul(&form.inputs))[(0, 0)], model.b[(1, 0)]);
        }
    }
}

/// Mass on three equal springs on a rotating ground: eigenvalues ± i (ω₀ ± Ω) and ± i ω₀. The Coriolis forces are in A.
#[test]
fn a_rotating_ground_splits_the_poles() {
    let spring = |name: &str, point: &str| {
        format!(
            "{{ kind = \"spring\", name = \"{name}\", a = {{ body = \"bob\", at = \"center\" }}, b = {{ point = {point} }}, stiffness = 200 }}"
        )
    };
    let springs =
        [("x", "[1, 0, 0]"), ("y", "[0, 1, 0]"), ("z", "[0, 0, 1]")].map(|(n, p)| spring(n, p)).join(", ");
    let text = format!(
        "bodies = [{{ kind = \"mass\", name = \"bob\", center = [0, 0, 0], mass = 2 }}]\n\
         loads = [{{ kind = \"base_rotation\", angular_velocity = [0, 0, 6] }}]\njoints = [{springs}]\n\
         analysis = {{ kind = \"dynamics\", duration = 1, step = 0.01 }}\n"
    );
    let linear = Stepper::new(&parse(&text)).unwrap().linearise(&[]).unwrap();
    let mut poles: Vec<f64> = linear.a.complex_eigenvalues().iter().map(|pole| pole.im).collect();
    poles.sort_by(f64::total_cmp);
    for (found, expected) in poles.into_iter().zip([-16.0, -10.0, -4.0, 4.0, 10.0, 16.0]) {
        assert!((found - expected).abs() < 1e-6, "{found} not {expected}");
    }
}

/// Cantilever with a transverse tip force.
fn cantilever(analysis: &str, formulation: &str) -> String {
    format!(
        "materials.m = {{ density = 2700, young = 7e10 }}\n\
         sections.s = {{ kind = \"rectangle\", height = 0.01, width = 0.02 }}\n\
         bodies = [{{ kind = \"beam\", name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 3, section = \"s\", \
         material = \"m\", formulation = \"{formulation}\" }}]\n\
         joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"b\", at = \"start\" }} }}]\n\
         probes = [{{ name = \"tip\", on = {{ body = \"b\", at = \"end\" }}, record = [\"motion\", \"section_forces\"] }}]\n\
         {analysis}\n"
    )
}

/// The eigenvalues −ω² of the stiffness block are those of the modes; the static tip displacement by C A⁻¹ B is that of statics.
#[test]
fn cantilever_has_the_frequencies_of_its_modes() {
    let force = "inputs = [{ name = \"f\" }]\n[[loads]]\nkind = \"force\"\non = { body = \"b\", at = \"end\" }\nforce = [0, 0, 2]\n\
                 time = { kind = \"input\", name = \"f\" }\n";
    for formulation in ["linked", "continuum"] {
        let dynamics = format!(
            "{force}[analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = {{ spectral_radius = 0.9 }}"
        );
        let mut stepper = Stepper::new(&parse(&cantilever(&dynamics, formulation))).unwrap();
        let model = stepper.linearise(&["tip.z", "root.fz"]).unwrap();
        let d = model.a.nrows() / 2;
        let stiffness = -model.a.view((d, 0), (d, d)).into_owned();
        let mut squares: Vec<f64> =
            ((&stiffness + stiffness.transpose()) * 0.5).symmetric_eigenvalues().iter().copied().collect();
        squares.sort_by(f64::total_cmp);
        let mut series = Series::new();
        let _ = simulate(
            &parse(&cantilever("[analysis]\nkind = \"modes\"\ncount = 6", formulation)),
            &mut series,
        )
        .unwrap();
        for (found, expected) in squares.iter().zip(series.column("squared").unwrap()) {
            assert!((found / expected - 1.0).abs() < 1e-6, "{formulation}: {found}, not {expected}");
        }
        // Static gains: −C A⁻¹ B + D.
        let gain = &model.d - &model.c * model.a.clone().lu().solve(&model.b).unwrap();
        let expected = 2.0 / (3.0 * 7e10 * 0.01 * 8e-6 / 12.0);
        // Three elements of the continuum formulation are stiffer by 3 %.
        assert!((gain[(0, 0)] / expected - 1.0).abs() < 0.04, "{formulation}: {} {expected}", gain[(0, 0)]);
        assert!((gain[(1, 0)] + 2.0).abs() < 1e-5, "{}", gain[(1, 0)]);
    }
}

/// exp(A t) x₀ by the scaled Taylor series.
fn propagated(a: &DMatrix<f64>, t: f64) -> DMatrix<f64> {
    let n = a.nrows();
    let part = a * (t / 1024.0);
    let (mut sum, mut term) = (DMatrix::identity(n, n), DMatrix::identity(n, n));
    for k in 1..12 {
        term = &term * &part / f64::from(k);
        sum += &term;
    }
    (0..10).for_each(|_| sum = &sum * &sum);
    sum
}

/// Two arms in motion, with a torque that is not zero: after a short time, the difference of two nonlinear motions is exp(A t) x₀.
#[test]
fn disturbances_of_a_motion_follow_the_linear_model() {
    for scales in SCALES {
        let text = format!(
            "{scales}gravity = [0, -9.81, 0]\n\
             bodies = [{{ kind = \"rigid\", name = \"a\", center = [0.5, 0, 0], mass = 3, inertia = [0.1, 0.4, 0.3] }},\n\
             {{ kind = \"rigid\", name = \"b\", center = [1.4, 0, 0], mass = 2, inertia = [0.1, 0.2, 0.2] }}]\n\
             inputs = [{{ name = \"torque\", value = 3 }}]\n\
             probes = [{{ name = \"b\", on = {{ body = \"b\", at = \"center\" }} }}]\n\
             [[joints]]\nkind = \"revolute\"\nname = \"pin\"\na = {{ body = \"a\", at = [0, 0, 0] }}\naxis = [0, 0, 1]\n\
             [[joints]]\nkind = \"revolute\"\nname = \"elbow\"\na = {{ body = \"b\", at = [1, 0, 0] }}\n\
             b = {{ body = \"a\", at = [1, 0, 0] }}\naxis = [0, 0, 1]\nspring = {{ stiffness = 30, damping = 2 }}\n\
             [[loads]]\nkind = \"moment\"\non = {{ body = \"a\", at = \"center\" }}\nmoment = [0, 0, 1]\nfollower = true\n\
             time = {{ kind = \"input\", name = \"torque\" }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 2e-4\nscheme = {{ spectral_radius = 0.95 }}\n"
        );
        let mut stepper = Stepper::new(&parse(&text)).unwrap();
        stepper.advance(0.4).unwrap();
        let model = stepper.linearise(&["b.x", "b.y", "elbow.angle"]).unwrap();
        assert_eq!(model.a.nrows(), 4);
        // A short time: A varies along the motion.
        let t = 4e-3;
        let saved = stepper.save().unwrap();
        let moved = |stepper: &mut Stepper, model: &LinearModel, x: &DVector<f64>, torque: f64| {
            stepper.restore(&saved).unwrap();
            let mut state = stepper.state();
            let q = &model.basis * x.rows(0, 2);
            let v = &model.basis * x.rows(2, 2);
            state.coordinates.iter_mut().zip(q.iter()).for_each(|(own, by)| *own += by);
            state.velocities.iter_mut().zip(v.iter()).for_each(|(own, by)| *own += by);
            stepper.set_state(&state).unwrap();
            let names = model.outputs.iter();
            let outputs = DVector::from_iterator(3, names.map(|name| stepper.read(name).unwrap()));
            stepper.set("torque", 3.0 + torque).unwrap();
            stepper.advance(0.4 + t).unwrap();
            (model.state_of(stepper).unwrap(), outputs)
        };
        let exponential = propagated(&model.a, t);
        for (i, torque) in [(0, 0.0), (1, 0.0), (2, 0.0), (3, 0.0), (4, 1.0)] {
            let h = 1e-4;
            let x = DVector::from_fn(4, |row, _| if row == i { h } else { 0.0 });
            let [(after, y_after), (before, y_before)] =
                [1.0, -1.0].map(|sign| moved(&mut stepper, &model, &(&x * sign), sign * torque));
            let found = (after - before) * 0.5;
            let expected =
                &exponential * &x + &model.b * (torque * t) + &model.a * &model.b * (torque * t * t / 2.0);
            assert!((&found - &expected).norm() < 4e-3 * expected.norm(), "{scales}{i}: {found} {expected}");
            let outputs = (y_after - y_before) * 0.5;
            let expected = &model.c * &x;
            assert!(
                (&outputs - &expected).norm() < 1e-6 * expected.norm() + 1e-10,
                "{scales}{i}: {outputs} {expected}"
            );
        }
    }
}

#[test]
fn what_is_not_linear_is_rejected() {
    let mut stepper = Stepper::new(&parse(&pendulum("", 1.0))).unwrap();
    for name in ["work", "balance", "t", "iterations", "pin.angel"] {
        let error = stepper.linearise(&[name]).unwrap_err();
        assert!(matches!(error, StepError::Argument(_)), "{name}");
    }
    let driven = "bodies = [{ kind = \"rigid\", name = \"r\", center = [0, 0, 0], mass = 2, inertia = [0.3, 0.3, 0.5] }]\n\
                  inputs = [{ name = \"motor\" }]\n[[joints]]\nkind = \"revolute\"\nname = \"shaft\"\n\
                  a = { body = \"r\", at = \"center\" }\naxis = [0, 0, 1]\n\
                  drive = { rate = 2, time = { kind = \"input\", name = \"motor\" } }\n\
                  [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 0.01\n";
    let error = Stepper::new(&parse(driven)).unwrap().linearise(&[]).unwrap_err().to_string();
    assert!(error.contains("drive input \"motor\""), "{error}");
    // A ball that touches the floor at its switching point: one-sided derivatives differ.
    let ball = |z: f64| {
        format!(
            "bodies = [{{ kind = \"rigid\", name = \"ball\", center = [0, 0, {z}], mass = 1, inertia = [1, 1, 1], \
             surface = {{ radius = 0.1 }} }}]\n\
             [[contacts]]\nwith = {{ kind = \"plane\", point = [0, 0, 0], normal = [0, 0, 1] }}\nstiffness = 1e4\n\
             [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = {{ spectral_radius = 0.8 }}\n"
        )
    };
    let mut apart = Stepper::new(&parse(&ball(0.11))).unwrap();
    let model = apart.linearise(&[]).unwrap();
    assert!(model.warnings.is_empty() && model.a.nrows() == 12);
    let mut closed = Stepper::new(&parse(&ball(0.099))).unwrap();
    assert_eq!(closed.linearise(&[]).unwrap().warnings.len(), 1);
    let mut touching = Stepper::new(&parse(&ball(0.1))).unwrap();
    assert!(touching.linearise(&[]).unwrap_err().to_string().contains("not differentiable"));
}

/// A damped arm in a fast motion: accelerations and section forces have the derivatives by the positions, including those of viscous
/// forces, whose directions and strain rates depend on the positions.
#[test]
fn viscous_forces_of_moving_bodies_have_all_derivatives() {
    for formulation in ["linked", "continuum", "cable"] {
        let body = match formulation {
            "cable" => "kind = \"cable\"".to_owned(),
            _ => format!("kind = \"beam\", formulation = \"{formulation}\""),
        };
        let text = format!(
            "materials.m = {{ density = 1100, young = 5e6, damping = {{ strain = 2e-3 }} }}\n\
             sections.s = {{ kind = \"circle\", diameter = 0.02 }}\n\
             gravity = [0, 0, -9.81]\n\
             bodies = [{{ {body}, name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = \"s\", material = \"m\" }}]\n\
             joints = [{{ kind = \"spherical\", name = \"pin\", a = {{ body = \"b\", at = \"start\" }} }}]\n\
             probes = [{{ name = \"tip\", on = {{ body = \"b\", at = \"end\" }} }}]\n\
             [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 1e-3\nscheme = {{ spectral_radius = 0.8 }}\n"
        );
        let mut stepper = Stepper::new(&parse(&text)).unwrap();
        stepper.advance(0.3).unwrap();
        let outputs = ["tip.ax", "tip.az", "pin.fx", "pin.fz"];
        let model = stepper.linearise(&outputs).unwrap();
        assert!(model.warnings.iter().any(|warning| warning.contains("the state moves")));
        let state = stepper.state();
        let h = 1e-6;
        for j in 0..model.basis.ncols() {
            let mut at = |sign: f64| {
                let mut moved = state.clone();
                let by = model.basis.column(j) * (sign * h);
                moved.coordinates.iter_mut().zip(by.iter()).for_each(|(own, by)| *own += by);
                stepper.set_state(&moved).unwrap();
                outputs.map(|name| stepper.read(name).unwrap())
            };
            let ([after, before], scale) = ([at(1.0), at(-1.0)], model.c.amax());
            for (i, name) in outputs.iter().enumerate() {
                let (found, expected) = (model.c[(i, j)], (after[i] - before[i]) / (2.0 * h));
                assert!(
                    (found - expected).abs() < 1e-6 * scale,
                    "{formulation} {name} {j}: {found} {expected}"
                );
            }
        }
    }
}
