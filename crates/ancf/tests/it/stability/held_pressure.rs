//! Pressure on shells whose edges are held: it has a potential, that of a gas of constant pressure.

use std::f64::consts::FRAC_PI_2;

use ancf::record::Series;
use ancf::simulate;
use nalgebra::{Rotation3, Vector3};

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

/// Cylinder with held ends under outer pressure, or under a gas of lower pressure.
fn cylinder(load: &str, high: &str, analysis: &str) -> String {
    format!(
        r#"
materials.m = {{ density = 7800, young = 2e11, poisson = 0.3 }}
analysis = {{ {analysis} }}
loads = [{{ {load} }}]

[[bodies]]
kind = "shell"
name = "b"
surface = {{ kind = "revolved", from = [1, 0, 0], to = [1, 0, 1], center = [0, 0, 0], axis = [0, 0, 1], angle = 6.283185307179586 }}
elements = [24, 4]
thickness = 0.01
material = "m"

[[joints]]
kind = "seam"
name = "s"
a = {{ body = "b", at = {{ edge = "u_start" }} }}
b = {{ body = "b", at = {{ edge = "u_end" }} }}

[[joints]]
kind = "support"
name = "low"
a = {{ body = "b", at = {{ edge = "v_start" }} }}
condition = "hinged"
{high}
"#
    )
}

const PRESSURE: &str = r#"kind = "surface_pressure", body = "b", pressure = -1e3"#;
const GAS: &str = r#"kind = "gas", name = "air", surfaces = [{ body = "b" }], pressure = 1e3, ambient = 2e3, exponent = 0, apex = [0, 0, 0.5]"#;
const HINGED: &str = r#"
[[joints]]
kind = "support"
name = "high"
a = { body = "b", at = { edge = "v_end" } }
condition = "hinged"
"#;
const BUCKLING: &str = r#"kind = "buckling", count = 2"#;

/// Critical factors of the pressure are those of the gas, between von Mises's critical pressure of ends that move along the axis, 1.96 MPa,
/// and 1.5 times it.
///
/// Source of the formula: von Mises (1914), with the lowest value for eight waves.
#[test]
fn critical_pressures_of_held_cylinders_are_those_of_a_gas() {
    let factors = |load: &str| Run::of(&parse(&cylinder(load, HINGED, BUCKLING))).column("factor").to_vec();
    let [pressure, gas] = [PRESSURE, GAS].map(factors);
    assert_eq!(pressure.len(), 2);
    for (own, gas) in pressure.iter().zip(&gas) {
        assert_relative("factor", *own, *gas, 1e-6);
        assert!((1957.0..1.5 * 1957.0).contains(own), "{own}");
    }
}

/// A free end is bent by the pressure in any direction: there is no potential, and no critical load of equilibria.
#[test]
fn critical_pressures_of_free_ends_are_rejected() {
    let summary = simulate(&parse(&cylinder(PRESSURE, "", BUCKLING)), &mut Series::new()).unwrap();
    assert!(format!("{:?}", summary.outcome).contains("no potential"), "{:?}", summary.outcome);
}

/// Below the critical pressure all equilibria are stable, and nothing is said of loads without a potential.
#[test]
fn equilibria_below_the_critical_pressure_are_stable() {
    let high = PRESSURE.replace("-1e3", "-2e6");
    let mut series = Series::new();
    let summary = simulate(&parse(&cylinder(&high, HINGED, r#"kind = "statics""#)), &mut series).unwrap();
    assert!(summary.outcome.is_finished() && summary.warnings.is_empty(), "{summary:?}");
    let unstable = series.column("unstable").unwrap();
    assert!(unstable[1..].iter().all(|count| *count == 0.0), "{unstable:?}");
}

/// Quarter of a ring of radius 0.5 and length 0.1 about a direction, with all edges in planes of symmetry, under outer pressure.
fn quarter_ring(kind: &str, directions: [Vector3<f64>; 3]) -> String {
    let [along, start, end] = directions;
    let text = |x: Vector3<f64>| format!("[{:?}, {:?}, {:?}]", x.x, x.y, x.z);
    let body = match kind {
        "shell" => format!(
            "surface = {{ kind = \"revolved\", from = {}, to = {}, center = [0, 0, 0], axis = {}, angle = {:?} }}, elements = [6, 1]",
            text(0.5 * start),
            text(0.1 * along + 0.5 * start),
            text(along),
            FRAC_PI_2
        ),
        _ => {
            let count = 48;
            let angle = |i: usize| FRAC_PI_2 * i as f64 / count as f64;
            let normal = |i: usize| angle(i).cos() * start + angle(i).sin() * end;
            let both = |of: &dyn Fn(f64, usize) -> String| -> String {
                let ends = [0.0, 0.1].into_iter().flat_map(|x| (0..=count).map(move |i| (x, i)));
                ends.map(|(x, i)| of(x, i)).collect::<Vec<_>>().join(", ")
            };
            let next = count + 1;
            let element = |i: usize| format!("[{i}, {}, {}, {}]", i + 1, next + i + 1, next + i);
            let elements: Vec<String> = (0..count).map(element).collect();
            let arc = |first: usize| (first..first + next).collect::<Vec<_>>();
            format!(
                "mesh = {{ nodes = [{}], directors = [{}], elements = [{}], groups = {{ u_start = {{ edges = [[0, {next}]] }}, \
                 u_end = {{ edges = [[{count}, {}]] }}, v_start = {{ edges = [{:?}] }}, v_end = {{ edges = [{:?}] }} }} }}",
                both(&|x, i| text(x * along + 0.5 * normal(i))),
                both(&|_, i| text(normal(i))),
                elements.join(", "),
                next + count,
                arc(0),
                arc(next)
            )
        }
    };
    let support = |edge| {
        format!(
            "{{ kind = \"support\", name = \"{edge}\", a = {{ body = \"b\", at = {{ edge = \"{edge}\" }} }}, condition = \"symmetry\" }}"
        )
    };
    let supports = ["u_start", "u_end", "v_start", "v_end"].map(support).join(", ");
    format!(
        "materials.m = {{ density = 2700, young = 7e10, poisson = 0.3 }}\n\
         bodies = [{{ kind = \"{kind}\", name = \"b\", {body}, thickness = 0.005, material = \"m\" }}]\n\
         joints = [{supports}]\nloads = [{{ kind = \"surface_pressure\", body = \"b\", pressure = -1.0 }}]\n\
         analysis = {{ {BUCKLING} }}\n"
    )
}

/// The critical pressures of a long ring are (n² − 1) D/R³ for n = 2, 4 waves that are symmetric to both planes, in any direction of the
/// ring. Coordinates that the supports hold are zero in exact arithmetic only, and are no motion against the pressure.
///
/// Source: Bresse (1866); Timoshenko & Gere (1961), section 7.3, for plane strain.
#[test]
fn critical_pressures_between_planes_of_symmetry() {
    let turned = Rotation3::from_euler_angles(0.4, -0.7, 1.1);
    let plate = 7e10 * 0.005_f64.powi(3) / (12.0 * (1.0 - 0.3 * 0.3));
    for kind in ["shell", "shear_shell"] {
        for rotation in [Rotation3::identity(), turned] {
            let directions = [Vector3::x(), Vector3::y(), Vector3::z()].map(|x| rotation * x);
            let run = Run::of(&parse(&quarter_ring(kind, directions)));
            for (factor, waves) in run.column("factor").iter().zip([2.0_f64, 4.0]) {
                assert_relative(kind, *factor, (waves * waves - 1.0) * plate / 0.125, 5e-3);
            }
        }
    }
}
