//! Frame of the section forces of a cable: the stated y-axis, and independence of the global frame.

use ancf::Model;
use nalgebra::{Rotation3, Vector3};

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

const NAMES: [&str; 6] = ["N", "Qy", "Qz", "T", "My", "Mz"];
const LENGTH: f64 = 0.7;

fn list(x: Vector3<f64>) -> String {
    format!("[{:?}, {:?}, {:?}]", x.x, x.y, x.z)
}

/// Cable of EI = 0.0491 N m² along an axis, clamped at its start, with forces at 0.31 m and at its end. Probes at both places
/// inside the cable.
fn cable(axis: Vector3<f64>, up: Option<Vector3<f64>>, forces: [Vector3<f64>; 2]) -> Model {
    let up = up.map_or_else(String::new, |up| format!("up = {},", list(up)));
    let [middle, end] = forces.map(list);
    let to = list(axis.normalize() * LENGTH);
    parse(&format!(
        "materials.rubber = {{ density = 1100, young = 1e8 }}
        sections.cord = {{ kind = \"circle\", diameter = 0.01 }}
        bodies = [{{ kind = \"cable\", name = \"cord\", from = [0, 0, 0], to = {to}, {up} elements = 7, section = \"cord\", material = \"rubber\" }}]
        joints = [{{ kind = \"clamp\", name = \"root\", a = {{ body = \"cord\", at = \"start\" }} }}]
        loads = [
          {{ kind = \"force\", on = {{ body = \"cord\", at = 0.31 }}, force = {middle} }},
          {{ kind = \"force\", on = {{ body = \"cord\", at = \"end\" }}, force = {end} }},
        ]
        probes = [
          {{ name = \"foot\", on = {{ body = \"cord\", at = \"start\" }}, record = [\"motion\", \"section_forces\"] }},
          {{ name = \"far\", on = {{ body = \"cord\", at = 0.55 }}, record = [\"motion\", \"section_forces\"] }},
        ]
        [analysis]
        kind = \"statics\"
        first = 0.2
        stop = {{ rule = \"energy\", tolerance = 1e-12 }}"
    ))
}

fn components(run: &Run) -> Vec<f64> {
    let of = |probe: &str| NAMES.map(|name| run.last(&format!("{probe}.{name}")));
    [of("foot"), of("far")].concat()
}

/// Q = F and M = L t × F of a small force at the end, in axes (t, y, z) with the stated and the default y-axis.
#[test]
fn components_are_along_the_stated_axis() {
    let defaults = [
        (Vector3::new(1.0, 2.0, -0.4), Vector3::y()),
        (Vector3::x(), Vector3::y()),
        (Vector3::y(), Vector3::z()),
        (-Vector3::z(), Vector3::y()),
    ];
    for (axis, default) in defaults {
        for up in [None, Some(Vector3::new(0.3, -0.8, 0.9))] {
            let t = axis.normalize();
            let y = up.unwrap_or(default);
            let y = (y - t * t.dot(&y)).normalize();
            let z = t.cross(&y);
            let load = y * 3e-7 + z * 5e-7;
            let run = Run::of(&cable(axis, up, [Vector3::zeros(), load]));
            let name = format!("{axis:?}, {up:?}");
            assert_relative(&name, run.last("foot.Qy"), 3e-7, 1e-5);
            assert_relative(&name, run.last("foot.Qz"), 5e-7, 1e-5);
            assert_relative(&name, run.last("foot.My"), -5e-7 * LENGTH, 1e-5);
            assert_relative(&name, run.last("foot.Mz"), 3e-7 * LENGTH, 1e-5);
        }
    }
}

/// A rotated cable in three-dimensional bending has the same components. The motion does not depend on `up`.
#[test]
fn components_do_not_depend_on_the_global_frame() {
    let axis = Vector3::new(0.9, -0.2, 0.4);
    let forces = [Vector3::new(0.06, 0.18, -0.1), Vector3::new(-0.03, 0.05, 0.14)];
    for up in [Vector3::new(0.1, 0.7, 0.2), axis + Vector3::new(0.0, 0.0, 1e-3)] {
        let base = Run::of(&cable(axis, Some(up), forces));
        let expected = components(&base);
        let size = |k: usize| if k % 6 < 3 { 0.2 } else { 0.2 * LENGTH };
        assert!(expected[1].abs() > 0.01 && expected[10].abs() > 1e-3, "{expected:?}");
        for turn in [[0.4, -0.9, 1.3], [3.0, 0.2, 0.1], [0.0, 0.0, std::f64::consts::FRAC_PI_2]] {
            let turn = Rotation3::new(Vector3::from(turn));
            let run = Run::of(&cable(turn * axis, Some(turn * up), forces.map(|force| turn * force)));
            for (k, (found, expected)) in components(&run).iter().zip(&expected).enumerate() {
                assert!((found - expected).abs() < 1e-8 * size(k), "{turn}, {k}: {found} {expected}");
            }
        }
        let other = Run::of(&cable(axis, None, forces));
        for name in ["x", "y", "z"].map(|axis| format!("far.{axis}")) {
            assert_eq!(base.last(&name), other.last(&name), "{name}");
        }
    }
}
