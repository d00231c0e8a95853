//! Elongations of curved shells without supports: they take the new shape without stress.

use std::f64::consts::FRAC_PI_2;

use crate::common::models::parse;
use crate::common::solutions::Run;

/// Quarter of a tube of a radius of 1 and a length of 2 as shear-deformable elements with radial directors.
fn mesh(around: usize, along: usize) -> String {
    let node = |i: usize, j: usize| j * (around + 1) + i;
    let places: Vec<_> = (0..=along).flat_map(|j| (0..=around).map(move |i| (i, j))).collect();
    let radial = |i: usize| (FRAC_PI_2 * i as f64 / around as f64).sin_cos();
    let nodes: Vec<_> =
        places.iter().map(|&(i, j)| [radial(i).1, radial(i).0, 2.0 * j as f64 / along as f64]).collect();
    let directors: Vec<_> = places.iter().map(|&(i, _)| [radial(i).1, radial(i).0, 0.0]).collect();
    let elements: Vec<_> = (0..along)
        .flat_map(|j| (0..around).map(move |i| (i, j)))
        .map(|(i, j)| [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)])
        .collect();
    let column = |i: usize| (0..=along).map(|j| node(i, j)).collect::<Vec<_>>();
    let row: Vec<_> = (0..=around).map(|i| node(i, 0)).collect();
    format!(
        "mesh = {{ nodes = {nodes:?}, directors = {directors:?}, elements = {elements:?}, groups = {{ u_start = {{ edges = [{:?}] }}, \
         u_end = {{ edges = [{:?}] }}, v_start = {{ edges = [{row:?}] }} }} }}",
        column(0),
        column(around)
    )
}

fn supports() -> String {
    let of = |edge: &str| {
        format!(
            "{{ kind = \"support\", name = \"{edge}\", a = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}, condition = \"symmetry\" }}"
        )
    };
    format!("joints = [{}]", ["u_start", "u_end", "v_start"].map(of).join(", "))
}

/// A thick tube without restraint becomes larger, uniformly or about its axis only. Without the curvature of the larger surface its
/// faces have the stress E ε h/(2R(1 − ν²)), 5.5 % of E ε.
#[test]
fn free_tubes_are_without_stress() {
    let young = 1e9;
    let revolved = "surface = { kind = \"revolved\", from = [1, 0, 0], to = [1, 0, 2], center = [0, 0, 0], axis = [0, 0, 1], angle = 1.5707963267948966 }, elements = [4, 4]";
    for (kind, shape, at) in [
        ("shell", revolved.to_owned(), "[0.5, 0.5]"),
        ("shear_shell", mesh(6, 3), "[0.5, 0.8660254037844386, 1]"),
    ] {
        // The first direction of the section is the circumference.
        let axis = "axis = [-1, 1, 0]";
        for strain in [[1e-3, 1e-3], [1e-3, 0.0], [0.0, 1e-3]] {
            let [u, v] = strain;
            let run = Run::of(&parse(&format!(
                "materials.m = {{ density = 1000, young = {young:e}, poisson = 0.3 }}\n{}\n\
                 bodies = [{{ kind = \"{kind}\", name = \"s\", {shape}, thickness = 0.1, material = \"m\" }}]\n\
                 loads = [{{ kind = \"surface_prestrain\", body = \"s\", strain = [{u}, {v}, 0], {axis} }}]\n\
                 probes = [{{ name = \"p\", on = {{ body = \"s\", at = {at} }}, record = [\"motion\", \"surface_stress\"] }}]\n\
                 analysis = {{ kind = \"statics\" }}\n",
                supports()
            )));
            for column in ["suu_top", "svv_top", "suv_top", "suu_bottom", "svv_bottom", "suv_bottom"] {
                let stress = run.last(&format!("p.{column}"));
                assert!(stress.abs() < 1e-6 * young * 1e-3, "{kind}, {strain:?}: {column} = {stress:e}");
            }
            let radius = run.last("p.x").hypot(run.last("p.y"));
            assert!((radius / (1.0 + u) - 1.0).abs() < 2e-2, "{kind}, {strain:?}: {radius}");
        }
    }
}
