//! Steps of varying sizes against closed forms and equal steps.

use ancf::Stepper;

use crate::common::models::parse;

/// Angle and vertical reaction of a pendulum with a torsion spring at the time 1, by Runge-Kutta steps of its closed equation.
fn exact_pendulum() -> [f64; 2] {
    let rate = |[angle, rate]: [f64; 2]| [rate, (9.81 * angle.cos() - 20.0 * angle - 0.1 * rate) / 0.7];
    let (mut x, n) = ([0.0, 0.0], 10_000);
    let h = 1.0 / f64::from(n);
    for _ in 0..n {
        let moved = |k: [f64; 2], h: f64| [x[0] + h * k[0], x[1] + h * k[1]];
        let k1 = rate(x);
        let k2 = rate(moved(k1, 0.5 * h));
        let k3 = rate(moved(k2, 0.5 * h));
        let k4 = rate(moved(k3, h));
        x = [0, 1].map(|i| x[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i]));
    }
    let [_, acceleration] = rate(x);
    let vertical = -0.5 * (x[0].cos() * acceleration - x[0].sin() * x[1] * x[1]);
    [x[0], 2.0 * (vertical + 9.81)]
}

/// Steps of varying sizes have errors of second order in positions and reactions, as steps of one size.
#[test]
fn steps_of_varying_sizes_are_stable() {
    let exact = exact_pendulum();
    for scheme in [
        "{ spectral_radius = 0.8 }",
        "{ spectral_radius = 0 }",
        "{ alpha = -0.2 }",
        "\"average_acceleration\"",
    ] {
        let text = format!(
            r#"gravity = [0, 0, -9.81]
            bodies = [{{ kind = "rigid", name = "b", center = [0.5, 0, 0], mass = 2, inertia = [0.1, 0.2, 0.2] }}]
            joints = [{{ kind = "revolute", name = "j", a = {{ body = "b", at = [0, 0, 0] }}, axis = [0, 1, 0],
                spring = {{ stiffness = 20, damping = 0.1 }} }}]
            analysis = {{ kind = "dynamics", duration = 1, step = 1e-2, scheme = {scheme} }}"#
        );
        let model = parse(&text);
        let moved = |pattern: &[f64], n: u32| {
            let mut stepper = Stepper::new(&model).unwrap();
            for k in 0.. {
                let left = 1.0 - stepper.time();
                if left <= 1e-9 {
                    break;
                }
                stepper.step((pattern[k % pattern.len()] / f64::from(n)).min(left)).unwrap();
            }
            let found = ["j.angle", "j.fz"].map(|column| stepper.read(column).unwrap());
            [(found[0] - exact[0]).abs(), (found[1] - exact[1]).abs()]
        };
        // The largest steps are twice as long as the equal ones, with four times their errors.
        let equal = [100, 400].map(|n| moved(&[1.0], n));
        assert!(equal[0][0] < 2.5e-3 && equal[1][0] < equal[0][0] / 12.0, "{scheme}: {equal:?}");
        // A long phase of short steps, and a first step that is longer than all others.
        let mut phases = vec![0.1; 60];
        phases.extend([1.0; 4]);
        let mut first = vec![1.0];
        first.extend([0.3, 0.03].repeat(2000));
        for pattern in [
            &[0.5, 1.5][..],
            &[0.1, 1.9],
            &[1.0, 0.01, 1.99],
            &[0.9, 1.1],
            &[1.0, 1e-3],
            &[0.3, 1.0, 1.7],
            &phases,
            &first,
        ] {
            let varied = [100, 400].map(|n| moved(pattern, n));
            let [[coarse, coarse_force], [fine, fine_force]] = varied;
            let what =
                format!("{scheme} {:?}: {varied:?}, equal steps {equal:?}", &pattern[..pattern.len().min(4)]);
            assert!(coarse < 5.0 * equal[0][0] && fine < coarse / 12.0, "{what}");
            assert!(coarse_force < 6.0 * equal[0][1] && fine_force < 0.02, "{what}");
        }
    }
}

/// Steps of very different sizes do not excite the vibrations of a fine mesh: reactions and positions are those of equal steps.
#[test]
fn steps_of_varying_sizes_excite_no_vibrations() {
    for (scheme, damping) in [
        ("{ spectral_radius = 0.8 }", "{ strain = 1e-3 }"),
        ("{ spectral_radius = 0.5 }", "{ strain = 1e-3 }"),
        ("{ spectral_radius = 0 }", "{}"),
        ("{ alpha = -0.2 }", "{ strain = 1e-3 }"),
        ("{ tolerance = 1e-5 }", "{ strain = 1e-3 }"),
    ] {
        let key = if scheme.contains("tolerance") { "step" } else { "step = 4e-3\nscheme" };
        let model = parse(&format!(
            r#"gravity = [0, 0, -9.81]
            materials.m = {{ density = 1000, young = 1e8, poisson = 0.3, damping = {damping} }}
            sections.s = {{ kind = "circle", diameter = 0.05 }}
            bodies = [{{ kind = "beam", name = "b", from = [0, 0, 0], to = [1, 0, 0], elements = 40, section = "s", material = "m" }}]
            joints = [{{ kind = "revolute", name = "j", a = {{ body = "b", at = "start" }}, axis = [0, 1, 0] }}]
            probes = [{{ name = "p", on = {{ body = "b", at = "end" }} }}]
            [analysis]
            kind = "dynamics"
            duration = 1
            {key} = {scheme}"#
        ));
        let moved = |pattern: &[f64]| {
            let mut stepper = Stepper::new(&model).unwrap();
            for k in 0.. {
                let left = 0.2 - stepper.time();
                if left <= 1e-9 {
                    break;
                }
                stepper.step((4e-3 * pattern[k % pattern.len()]).min(left)).unwrap();
            }
            assert_eq!(stepper.summary().warnings, [""; 0], "{scheme} {pattern:?}");
            ["j.fx", "j.fz", "p.x", "p.z"].map(|column| stepper.read(column).unwrap())
        };
        let equal = moved(&[1.0]);
        for pattern in [
            &[0.5, 1.5][..],
            &[0.1, 1.9],
            &[1.0, 0.01],
            &[1.0, 0.01, 1.99],
            &[1.0, 1e-4, 1.9999],
            &[1.0, 1.0, 0.01, 0.02, 0.05, 0.1, 0.3],
        ] {
            for ((found, equal), size) in moved(pattern).into_iter().zip(equal).zip([20.0, 20.0, 1.0, 1.0]) {
                assert!((found - equal).abs() < 0.06 * size, "{scheme} {pattern:?}: {found} {equal}");
            }
        }
    }
}

/// Steps of varying sizes with redundant joints: a parallelogram of three bars on four parallel hinges.
#[test]
fn steps_of_varying_sizes_with_redundant_joints() {
    let model = parse(
        r#"gravity = [0, 0, -9.81]
        bodies = [
            { kind = "rigid", name = "a", center = [0.4, 0, -0.3], mass = 1, inertia = [0.01, 0.1, 0.1] },
            { kind = "rigid", name = "b", center = [2.4, 0, -0.3], mass = 1, inertia = [0.01, 0.1, 0.1] },
            { kind = "rigid", name = "c", center = [1.8, 0, -0.6], mass = 2, inertia = [0.01, 0.5, 0.5] }]
        joints = [
            { kind = "revolute", name = "1", a = { body = "a", at = [0, 0, 0] }, axis = [0, 1, 0] },
            { kind = "revolute", name = "2", a = { body = "b", at = [2, 0, 0] }, axis = [0, 1, 0] },
            { kind = "revolute", name = "3", a = { body = "c", at = [0.8, 0, -0.6] }, b = { body = "a", at = [0.8, 0, -0.6] }, axis = [0, 1, 0] },
            { kind = "revolute", name = "4", a = { body = "c", at = [2.8, 0, -0.6] }, b = { body = "b", at = [2.8, 0, -0.6] }, axis = [0, 1, 0] }]
        probes = [{ name = "c", on = { body = "c", at = "center" } }]
        analysis = { kind = "dynamics", duration = 1, step = 2.5e-3, scheme = { spectral_radius = 0.8 } }"#,
    );
    let moved = |pattern: &[f64]| {
        let mut stepper = Stepper::new(&model).unwrap();
        for k in 0.. {
            let left = 1.0 - stepper.time();
            if left <= 1e-9 {
                break;
            }
            stepper.step((2.5e-3 * pattern[k % pattern.len()]).min(left)).unwrap();
        }
        ["c.x", "c.z", "1.fz"].map(|column| stepper.read(column).unwrap())
    };
    let equal = moved(&[1.0]);
    for pattern in
        [&[0.5, 1.5][..], &[0.1, 1.9], &[1.0, 0.01, 1.99], &[1.0, 1e-4, 2.0], &[0.03, 0.1, 0.3, 1.0]]
    {
        for (found, equal) in moved(pattern).into_iter().zip(equal) {
            assert!((found - equal).abs() < 5e-3 * (1.0 + equal.abs()), "{pattern:?}: {found} {equal}");
        }
    }
}
