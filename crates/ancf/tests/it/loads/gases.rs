//! Gases between shells against closed forms, conservation laws, and rejected surfaces.

use std::f64::consts::{PI, TAU};
use std::fmt::Write;

use ancf::Model;
use nalgebra::Vector3;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::{Run, recorded_momenta};

/// Eighth of a sphere of radius 1 and thickness 0.01 with three planes of symmetry, of 3 n² quadrilaterals.
fn eighth(n: usize, gas: &str, analysis: &str) -> String {
    let (axes, mut nodes, mut elements) =
        ([Vector3::x(), Vector3::y(), Vector3::z()], Vec::new(), Vec::new());
    for k in 0..3 {
        let [a, b, c] = [0, 1, 2].map(|i| axes[(k + i) % 3]);
        let corners = [a, a + b, a + b + c, a + c].map(|corner: Vector3<f64>| corner.normalize());
        let mut node = |i: usize, j: usize| {
            let [x, y] = [i, j].map(|k| k as f64 / n as f64);
            let shares = [(1.0 - x) * (1.0 - y), x * (1.0 - y), x * y, (1.0 - x) * y];
            let place: Vector3<f64> = corners.iter().zip(shares).map(|(corner, share)| corner * share).sum();
            let place = place.normalize().map(|x| if x.abs() < 1e-12 { 0.0 } else { x });
            let known = nodes.iter().position(|other: &Vector3<f64>| (other - place).norm() < 1e-9);
            known.unwrap_or_else(|| {
                nodes.push(place);
                nodes.len() - 1
            })
        };
        let cells =
            (0..n).flat_map(|j| (0..n).map(move |i| [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]));
        elements.extend(cells.map(|cell| cell.map(|(i, j)| node(i, j))));
    }
    let lists: Vec<[f64; 3]> = nodes.iter().map(|node| (*node).into()).collect();
    let mut text = format!(
        "[materials.m]\nyoung = 1e7\npoisson = 0.3\ndensity = 1000\n\
         [[bodies]]\nkind = \"shear_shell\"\nname = \"s\"\nthickness = 0.01\nmaterial = \"m\"\n\
         mesh.nodes = {lists:?}\nmesh.elements = {elements:?}\nmesh.directors = {lists:?}\n"
    );
    for k in 0..3 {
        let sides = elements.iter().flat_map(|cell| (0..4).map(|i| [cell[i], cell[(i + 1) % 4]]));
        let edge: Vec<_> = sides.filter(|side| side.iter().all(|i| nodes[*i][k] == 0.0)).collect();
        let _ = writeln!(text, "mesh.groups.e{k} = {{ edges = {edge:?} }}");
    }
    for k in 0..3 {
        let _ = writeln!(
            text,
            "[[joints]]\nkind = \"support\"\nname = \"s{k}\"\na = {{ body = \"s\", at = {{ edge = \"e{k}\" }} }}\ncondition = \"symmetry\""
        );
    }
    text + &format!(
        "[[loads]]\nkind = \"gas\"\nname = \"air\"\nsurfaces = [{{ body = \"s\" }}]\napex = [0, 0, 0]\n{gas}\n\
         [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = [1, 0, 0] }}\nrecord = [\"motion\", \"resultants\"]\n\
         [analysis]\n{analysis}\n"
    )
}

/// Radius and thickness 1 and 0.01, E = 10⁷, ν = 0.3: w = p R² (1 − ν)/(2 E t), n = p R/2. The gas obeys p V = const.
#[test]
fn sphere_under_gas_pressure() {
    let gas = "pressure = 1100\nambient = 1000";
    let run = Run::of(&parse(&eighth(8, gas, "kind = \"statics\"\n")));
    let [volume, pressure] = ["air.volume", "air.pressure"].map(|name| run.last(name));
    assert_relative("p V", pressure * volume, 1100.0 * run.column("air.volume")[0], 1e-3);
    let excess = pressure - 1000.0;
    assert_relative("displacement", run.last("p.x") - 1.0, excess * 0.7 / 2e5, 5e-3);
    assert_relative("membrane force", run.last("p.nuu"), 0.5 * excess, 5e-3);
    assert_relative("volume", volume, PI / 6.0 * (1.0 + 3.0 * (run.last("p.x") - 1.0)), 5e-3);
}

/// The stability of equilibria is determined in any units, such as micrometres: the volume of a gas has the third power of their ratio.
/// An exponent of zero is a constant pressure, for any amount.
#[test]
fn stability_is_determined_in_any_units() {
    let gas = "pressure = 1100\nambient = 1000\nexponent = 1.4";
    let mut expected = None;
    for length in [1.0, 1e3, 1e-3, 1e6] {
        let scales = format!(
            "kind = \"path\"\n[scales]\nkind = \"given\"\nlength = {length:e}\nforce = 1.0\ntime = 1.0\n"
        );
        let run = Run::of(&parse(&eighth(3, gas, &scales)));
        assert!(
            run.column("unstable")[1..].iter().all(|count| *count == 0.0),
            "{length:e}: {:?}",
            run.column("unstable")
        );
        let displacement = run.last("p.x") - 1.0;
        assert_relative("displacement", displacement, *expected.get_or_insert(displacement), 1e-9);
    }
    let inflated = "pressure = 1100\nambient = 1000\nexponent = 0\n\
                    time = { kind = \"table\", times = [0, 0.01], values = [0, 1] }";
    let analysis = "kind = \"dynamics\"\nduration = 0.01\nstep = 0.001\n";
    let run = Run::of(&parse(&eighth(3, inflated, analysis)));
    assert!(run.column("air.pressure").iter().all(|pressure| (pressure - 1100.0).abs() < 1e-9));
}

/// ρ t ẅ + (2 E t/((1 − ν) R²) + 3 κ p/R) w = p₀ − p_a: oscillation of a sphere about its equilibrium.
#[test]
fn sphere_breathes_with_its_gas() {
    let gas = "pressure = 30001\nambient = 30000\nexponent = 1.4";
    let omega = ((2e5 / 0.7 + 3.0 * 1.4 * 30000.0) / 10.0_f64).sqrt();
    let period = TAU / omega;
    let analysis =
        format!("kind = \"dynamics\"\nduration = {period}\nstep = {}\nscheme = \"energy\"\n", period / 200.0);
    let run = Run::of(&parse(&eighth(4, gas, &analysis)));
    let middle = 1.0 / (10.0 * omega * omega);
    for (t, x) in run.column("t").iter().zip(run.column("p.x")) {
        let exact = middle * (1.0 - (omega * t).cos());
        assert!((x - 1.0 - exact).abs() < 0.04 * middle, "t = {t}: {} for {exact}", x - 1.0);
    }
    assert!(run.energy_error() < 1e-9, "{:e}", run.energy_error());
}

/// Sphere of radius 1 without supports: 3 × 3 elements on each side of a cube, projected onto the sphere.
fn free_ball(gas: &str, motion: &str, analysis: &str) -> String {
    let (mut nodes, mut elements): (Vec<[f64; 3]>, Vec<[usize; 4]>) = (Vec::new(), Vec::new());
    for side in 0..6 {
        let (axis, at_end) = (side / 2, side % 2 == 1);
        let mut node = |i: usize, j: usize| {
            let mut place = Vector3::zeros();
            let [u, v] = if at_end { [i, j] } else { [j, i] };
            place[axis] = if at_end { 1.0 } else { -1.0 };
            place[(axis + 1) % 3] = 2.0 / 3.0 * u as f64 - 1.0;
            place[(axis + 2) % 3] = 2.0 / 3.0 * v as f64 - 1.0;
            let place: [f64; 3] = place.normalize().into();
            let known =
                nodes.iter().position(|other| (Vector3::from(*other) - Vector3::from(place)).norm() < 1e-9);
            known.unwrap_or_else(|| {
                nodes.push(place);
                nodes.len() - 1
            })
        };
        for (i, j) in (0..3).flat_map(|j| (0..3).map(move |i| (i, j))) {
            elements.push([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)].map(|(i, j)| node(i, j)));
        }
    }
    format!(
        "[materials.m]\nyoung = 1e4\npoisson = 0.3\ndensity = 10\n\
         [[bodies]]\nkind = \"shear_shell\"\nname = \"s\"\nthickness = 0.05\nmaterial = \"m\"\n{motion}\n\
         mesh.nodes = {nodes:?}\nmesh.elements = {elements:?}\n\
         [[loads]]\nkind = \"gas\"\nname = \"air\"\nsurfaces = [{{ body = \"s\" }}]\n{gas}\n\
         [analysis]\n{analysis}\n"
    )
}

/// Ball that inflates while it moves and spins, by the energy-momentum scheme.
fn inflating_ball(step: f64) -> Model {
    let gas = "pressure = 30\nambient = 10\nexponent = 1.4\n\
               time = { kind = \"table\", times = [0, 0.1, 0.5, 1], values = [1, 1, 2, 2] }";
    let motion = "motion = { velocity = [1, 2, 3], spin = [0.3, -1, 2] }";
    let analysis = format!("kind = \"dynamics\"\nduration = 1\nstep = {step}\nscheme = \"energy\"\n");
    parse(&free_ball(gas, motion, &analysis))
}

/// The energy balance contains the work of added gas. The state of the gas obeys p (V/m)^κ = const.
#[test]
fn added_gas_does_work() {
    let run = Run::of(&inflating_ball(0.005));
    let undeformed = run.column("air.volume")[0];
    assert_relative("volume", undeformed, 4.0 / 3.0 * PI, 0.15);
    let inside = run.column("air.volume").iter().zip(run.column("air.pressure")).zip(run.column("t"));
    for ((volume, pressure), t) in inside {
        let amount = 1.0 + ((t - 0.1) / 0.4).clamp(0.0, 1.0);
        let state = pressure * (volume / undeformed / amount).powf(1.4);
        assert_relative("state of the gas", state, 30.0, 1e-12);
    }
    assert!(run.last("air.volume") > 1.05 * undeformed, "the ball does not inflate");
    let work = run.last("work").abs();
    assert!(work > 1.0, "work {work}");
    assert!(run.energy_error() < 1e-5 * work, "balance {:e} of {work}", run.energy_error());
}

/// The pressure has no resultant. Its moment is an error of second order in the step.
#[test]
fn free_ball_conserves_momenta() {
    let errors = [0.01, 0.005].map(|step| {
        let all = recorded_momenta(&inflating_ball(step));
        [0, 1].map(|k| {
            let largest = all.iter().map(|m| (m[k] - all[0][k]).norm()).fold(0.0, f64::max);
            largest / all[0][k].norm()
        })
    });
    assert!(errors[1][0] < 1e-12, "momentum: {:e}", errors[1][0]);
    assert!(errors[1][1] < 2e-5, "angular momentum: {:e}", errors[1][1]);
    assert!(errors[0][1] > 3.0 * errors[1][1], "angular momentum: {errors:?}");
}

/// Change of the text of a model.
type Change = fn(String) -> String;

/// Message of a rejected ball whose gas has these keys.
fn message(gas: &str, change: Change) -> String {
    let text = change(free_ball(gas, "", "kind = \"statics\"\n"));
    Model::parse(&text).err().map_or_else(String::new, |errors| errors.to_string())
}

#[test]
fn surfaces_that_do_not_enclose_a_gas_are_rejected() {
    let part = |text: String| {
        text.replace("mesh.elements = ", "mesh.groups.a = { elements = [0, 1, 2, 3, 4] }\nmesh.elements = ")
            .replace("{ body = \"s\" }", "{ body = \"s\", region = \"a\" }")
    };
    let same = |text: String| text;
    let reversed = |text: String| text.replace("{ body = \"s\" }", "{ body = \"s\", reversed = true }");
    let twice = |text: String| text.replace("{ body = \"s\" }", "{ body = \"s\" }, { body = \"s\" }");
    let assembled = |text: String| format!("assemble = true\n{text}");
    let cases: [(&str, &str, Change, &str); 6] = [
        ("pressure = 1", "opening", part, "an opening with"),
        ("pressure = 1", "reversed", reversed, "the volume -"),
        ("pressure = 1", "twice", twice, "a second time"),
        ("pressure = 1", "assembled", assembled, "whose volume would change"),
        ("pressure = -1", "negative pressure", same, "loads[0].pressure"),
        ("pressure = 1\nexponent = -1", "negative exponent", same, "loads[0].exponent"),
    ];
    for (gas, case, change, expected) in cases {
        let found = message(gas, change);
        assert!(found.contains(expected), "{case}: {found}");
    }
    assert_eq!(message("pressure = 1", same), "");
}

/// The motion does not depend on the origin of the volume.
#[test]
fn closed_volumes_do_not_depend_on_the_origin() {
    let gas = |apex: &str| format!("pressure = 20\nambient = 10\nexponent = 1.4\n{apex}");
    let analysis = "kind = \"dynamics\"\nduration = 0.2\nstep = 0.01\n";
    let [own, other] =
        ["", "apex = [3, -5, 8]"].map(|apex| Run::of(&parse(&free_ball(&gas(apex), "", analysis))));
    for name in ["air.volume", "air.pressure", "strain", "kinetic"] {
        for (a, b) in own.column(name).iter().zip(other.column(name)) {
            assert!((a - b).abs() < 1e-9 * own.largest(name), "{name}: {a} and {b}");
        }
    }
}
