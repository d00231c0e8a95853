//! Pressure on shells whose edges are held: it has a potential, that of a gas of constant pressure.

use ancf::record::Series;
use ancf::simulate;

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
