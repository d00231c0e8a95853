//! Models of bodies in contact, and the contact forces.

use ancf::assembly::Assembly;
use ancf::record::Series;
use ancf::solver::equations::{EquationsOfMotion, Local, State, Term};
use ancf::{Model, simulate};
use nalgebra::Vector3;

use crate::common::models::parse;

/// Model of the given bodies with one contact or none, without gravity.
pub(super) fn model(bodies: &str, contact: &str) -> Model {
    let contact = if contact.is_empty() { String::new() } else { format!("[[contacts]]\n{contact}\n\n") };
    let text = format!(
        "[materials]\nstiff = {{ density = 1000, young = 2e9 }}\nsoft = {{ density = 1000, young = 3e7, damping = {{ mass = \
         20, strain = 1e-3 }} }}\n\n[sections.round]\nkind = \"circle\"\ndiameter = 0.02\n\n{bodies}\n{contact}[analysis]\n\
         kind = \"dynamics\"\nduration = 1\nstep = 1e-3\n"
    );
    parse(&text)
}

/// Undeformed state in which bodies translate with given velocities.
pub(super) fn with_velocities(assembly: &Assembly, velocities: &[(&str, Vector3<f64>)]) -> State {
    let mut s = assembly.rest();
    for (body, velocity) in velocities {
        for vector in assembly.mesh(body).unwrap().vectors(&assembly.rest()).filter(|v| v.is_position()) {
            s.v[vector.first..vector.first + 3].copy_from_slice(velocity.as_slice());
        }
    }
    s
}

/// Residual of a term in the rows of all coordinates.
pub(super) fn rows(term: &dyn Term, s: &State) -> Vec<f64> {
    let of = |x: &[f64]| term.coordinates().iter().map(|&c| x[c]).collect::<Vec<_>>();
    let (q, v, a) = (of(&s.q), of(&s.v), of(&s.a));
    let mut local = vec![0.0; q.len()];
    term.residual(&Local { q: &q, v: &v, a: &a, lambda: &[], t: s.t, load: s.load }, &mut local);
    let mut rows = vec![0.0; s.q.len()];
    term.coordinates().iter().zip(local).for_each(|(&c, row)| rows[c] += row);
    rows
}

/// Sum of all contact forces on a body.
pub(super) fn force(assembly: &Assembly, s: &State, body: &str) -> Vector3<f64> {
    let Some((complete, _)) = assembly.system.with_active_terms(s) else { return Vector3::zeros() };
    let permanent = assembly.system.terms().len();
    let mut force = Vector3::zeros();
    for term in &complete.terms()[permanent..] {
        let rows = rows(term.as_ref(), s);
        for vector in assembly.mesh(body).unwrap().vectors(s).filter(|vector| vector.is_position()) {
            force -= Vector3::from_column_slice(&rows[vector.first..vector.first + 3]);
        }
    }
    force
}

/// Elements of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Elements {
    Thin,
    Quads,
    Triangles,
}
use Elements::{Thin, Triangles};

pub(super) fn run_model(model: &Model) -> Series {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

pub(super) fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap_or_else(|| panic!("no column {name}")).last().unwrap()
}

/// Mesh of n × m cells over a surface r(u, v), with its edges as groups.
pub(super) fn mesh(
    kind: Elements,
    name: &str,
    [n, m]: [usize; 2],
    keys: &str,
    r: impl Fn(f64, f64) -> [f64; 3],
) -> String {
    let node = |i: usize, j: usize| j * (n + 1) + i;
    let places = (0..=m).flat_map(|j| (0..=n).map(move |i| [i, j]));
    let nodes: Vec<_> = places.map(|[i, j]| r(i as f64 / n as f64, j as f64 / m as f64)).collect();
    let of_cell = |(i, j): (usize, usize)| {
        let [a, b, c, d] = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
        // Diagonals of both directions.
        match (kind, (i + j) % 2) {
            (Triangles, 0) => vec![vec![a, b, d], vec![b, c, d]],
            (Triangles, _) => vec![vec![a, b, c], vec![a, c, d]],
            _ => vec![vec![a, b, c, d]],
        }
    };
    let faces: Vec<_> = (0..m).flat_map(|j| (0..n).map(move |i| (i, j))).flat_map(of_cell).collect();
    let edge = |name: &str, nodes: Vec<usize>| format!("{name} = {{ edges = [{nodes:?}] }}");
    let groups = [
        edge("u_start", (0..=m).map(|j| node(0, j)).collect()),
        edge("u_end", (0..=m).map(|j| node(n, j)).collect()),
    ];
    format!(
        "[[bodies]]\nkind = \"shear_shell\"\nname = \"{name}\"\n{keys}\n\
         mesh = {{ nodes = {nodes:?}, elements = {faces:?}, groups = {{ {} }} }}\n",
        groups.join(", ")
    )
}

/// A flat shell over the rectangle from a corner with sides along x and y.
pub(super) fn sheet(
    kind: Elements,
    name: &str,
    ([x, y, z], [a, b]): ([f64; 3], [f64; 2]),
    [n, m]: [usize; 2],
    keys: &str,
) -> String {
    match kind {
        Thin => format!(
            "[[bodies]]\nkind = \"shell\"\nname = \"{name}\"\nelements = [{n}, {m}]\n{keys}\n\
             surface = {{ kind = \"flat\", corner = [{x}, {y}, {z}], side_u = [{a}, 0, 0], side_v = [0, {b}, 0] }}\n"
        ),
        _ => mesh(kind, name, [n, m], keys, |u, v| [x + a * u, y + b * v, z]),
    }
}

/// Supports of both edges u = 0 and u = 1 of a shell.
pub(super) fn clamps(body: &str) -> String {
    ["u_start", "u_end"]
        .map(|edge| {
            format!(
                "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"{body}\", at = {{ edge = \"{edge}\" }} }}\n\
                 condition = \"clamped\"\n"
            )
        })
        .concat()
}

/// A stiff plate from −0.3 to 0.3 in both directions at z = 0, 0.02 thick and held at two edges.
pub(super) fn table(kind: Elements) -> String {
    let keys = "thickness = 0.02\nmaterial = \"stiff\"";
    sheet(kind, "table", ([-0.3, -0.3, 0.0], [0.6, 0.6]), [4, 3], keys) + &clamps("table")
}

/// Probe of a sheet of 2 × 2 elements in its middle.
pub(super) fn middle(kind: Elements, name: &str) -> String {
    let at = if kind == Thin { "[0.5, 0.5]" } else { "{ node = 4 }" };
    format!("[[probes]]\nname = \"{name}\"\non = {{ body = \"{name}\", at = {at} }}\n")
}

pub(super) const MATERIALS: &str = "materials.stiff = { density = 1, young = 1e12 }\n\
                         materials.soft = { density = 1000, young = 1e6, damping = { strain = 2e-3 } }\n";
pub(super) const CONTACT: &str =
    "[[contacts]]\nwith = { kind = \"bodies\" }\nsurface_stiffness = 4e6\ntransition = 1e-5\n";
