//! Thin shells: patch tests, conservation laws, units and refused combinations.

use ancf::Model;
use ancf::mechanics::shells::{ShellMedium, ShellMesh, ShellSection};
use ancf::record::Series;
use ancf::simulate;
use ancf::solver::equations::{LOCAL, Local, LocalMatrix, Term, Weights};
use nalgebra::Vector3;

use crate::common::assertions::assert_near;

const SIDES: [f64; 2] = [0.24, 0.12];
const SECTION: [f64; 4] = [1e6, 0.25, 1.0, 1e-3];

/// Rectangle of 3 × 2 elements.
fn plate() -> ShellMesh {
    let [young, poisson, density, thickness] = SECTION;
    let section = ShellSection::isotropic(young, poisson, density, thickness);
    let medium =
        ShellMedium { section, axis: None, retardation: 0.0, mass_damping: 0.0, gravity: Vector3::zeros() };
    let map = |[u, v]: [f64; 2]| {
        let [a, b] = [Vector3::x() * SIDES[0], Vector3::y() * SIDES[1]];
        [a * u + b * v, a, b, Vector3::zeros()]
    };
    ShellMesh::new(0, [3, 2], Vector3::zeros(), map, &medium)
}

/// Coordinates of a displacement with its derivatives by x, y and xy.
fn coordinates(mesh: &ShellMesh, field: impl Fn(f64, f64) -> [Vector3<f64>; 4]) -> Vec<f64> {
    let [n, m] = mesh.divisions();
    let scale = [1.0, SIDES[0] / n as f64, SIDES[1] / m as f64, SIDES[0] * SIDES[1] / (n * m) as f64];
    let nodes = (0..(n + 1) * (m + 1)).map(|node| mesh.node_place(node));
    nodes
        .flat_map(|[u, v]| {
            let values = field(u * SIDES[0], v * SIDES[1]);
            [0, 1, 2, 3].map(|k| values[k] * scale[k])
        })
        .flat_map(<[f64; 3]>::from)
        .collect()
}

/// Energy, and forces on all coordinates or, if stated, the linear ones at the reference state.
fn forces(mesh: &ShellMesh, q: &[f64], is_linear: bool) -> (f64, Vec<f64>) {
    let (mut energy, mut rows, zeros) = (0.0, vec![0.0; q.len()], [0.0; 48]);
    for term in mesh.elements() {
        let own: Vec<f64> = term.coordinates().iter().map(|&c| q[c]).collect();
        let at = |q| Local { q, v: &zeros, a: &zeros, lambda: &[], t: 0.0, load: 0.0 };
        let mut r = [0.0; 48];
        if is_linear {
            let mut storage = [0.0; LOCAL * LOCAL];
            let mut k = LocalMatrix::zero(48, &mut storage);
            term.tangent(&at(&zeros), Weights::STIFFNESS, &mut k);
            for (i, row) in r.iter_mut().enumerate() {
                *row = (0..48).map(|j| k.get(i.max(j), i.min(j)) * own[j]).sum();
            }
            energy += 0.5 * r.iter().zip(&own).map(|(r, q)| r * q).sum::<f64>();
        } else {
            term.residual(&at(&own), &mut r);
            energy += term.energy(&at(&own)).strain;
        }
        term.coordinates().iter().zip(r).for_each(|(&c, r)| rows[c] += r);
    }
    (energy, rows)
}

/// Largest force on the vectors of inner nodes, relative to the largest one.
fn inner(mesh: &ShellMesh, rows: &[f64]) -> f64 {
    let is_inner = |node: usize| mesh.node_place(node).iter().all(|x| *x > 0.0 && *x < 1.0);
    let of = |inner: bool| {
        let nodes = (0..rows.len() / 12).filter(|&node| !inner || is_inner(node));
        nodes.flat_map(|node| &rows[12 * node..12 * node + 12]).fold(0.0, |most: f64, x| most.max(x.abs()))
    };
    of(true) / of(false)
}

/// Membrane patch test of MacNeal and Harder (1985) with finite strains: ε = (2 1 1; 1 2 1)/2 · 1e-3 and its square.
#[test]
fn constant_membrane_strains_are_exact() {
    let mesh = plate();
    let q = coordinates(&mesh, |x, y| {
        let [a, b] = [Vector3::new(1e-3, 0.5e-3, 0.0), Vector3::new(0.5e-3, 1e-3, 0.0)];
        [a * x + b * y, a, b, Vector3::zeros()]
    });
    let (energy, rows) = forces(&mesh, &q, false);
    let normal = 1e-3 + 0.5 * (1e-6 + 0.25e-6);
    let shear = 1e-3 + 1e-6;
    let [young, poisson, _, thickness] = SECTION;
    let plane = young * thickness / (1.0 - poisson * poisson);
    let density =
        0.5 * plane * (2.0 * (1.0 + poisson) * normal * normal + 0.5 * (1.0 - poisson) * shear * shear);
    assert_near("energy", energy, density * SIDES[0] * SIDES[1], 1e-12);
    assert!(inner(&mesh, &rows) < 1e-12, "{:e}", inner(&mesh, &rows));
}

/// Bending patch test of MacNeal and Harder (1985): w = 1e-3 (x² + x y + y²)/2.
#[test]
fn constant_curvatures_are_exact() {
    let mesh = plate();
    let q = coordinates(&mesh, |x, y| {
        let w = [x * x + x * y + y * y, 2.0 * x + y, x + 2.0 * y, 1.0];
        w.map(|w| Vector3::z() * (0.5e-3 * w))
    });
    let (energy, rows) = forces(&mesh, &q, true);
    // m_x = m_y = 1.1111111e-7, m_xy = 3.3333333e-8; curvatures 1e-3, twice the twist 1e-3.
    let [moment, twisting] = [1e-6 / 9.0, 1e-7 / 3.0];
    let density = 0.5 * (2.0 * moment * 1e-3 + twisting * 1e-3);
    assert_near("energy", energy, density * SIDES[0] * SIDES[1], 1e-10);
    // Edges of constant moment load the corner nodes by forces of the twisting moment.
    assert!(inner(&mesh, &rows) < 1e-9, "{:e}", inner(&mesh, &rows));
}

/// Free plate in the energy-momentum scheme: momenta and energy are constant.
#[test]
fn free_plates_preserve_energy_and_momenta() {
    let model = Model::parse(
        r#"
        materials.m = { density = 500, young = 2e7, poisson = 0.3 }
        [[bodies]]
        kind = "shell"
        name = "s"
        surface = { kind = "twisted", from = [0, 0, 0], to = [1, 0, 0], width = [0, 0.5, 0.1], twist = 0.6 }
        elements = [3, 2]
        thickness = 0.01
        material = "m"
        motion = { velocity = [0.3, -0.2, 0.5], spin = [3, 4, -5] }
        [analysis]
        kind = "dynamics"
        duration = 0.2
        step = 0.004
        scheme = "energy"
        [output]
        momentum = true
        "#,
    )
    .unwrap();
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    let column = |name: &str| series.column(name).unwrap();
    let [first, last] = [0, column("t").len() - 1].map(|row| column("kinetic")[row] + column("strain")[row]);
    let strain = column("strain").last().unwrap();
    assert!(*strain > 1e-4 * first, "the plate deforms: {strain} of {first}");
    assert!((last - first).abs() < 1e-8 * first, "energy {last} of {first}");
    for name in ["px", "py", "pz", "lx", "ly", "lz"] {
        let values = column(name);
        let size = ["x", "y", "z"].map(|axis| column(&format!("{}{axis}", &name[..1]))[0]);
        let size = Vector3::from(size).norm();
        let off = values.iter().map(|x| (x - values[0]).abs()).fold(0.0, f64::max);
        assert!(off < 1e-9 * size, "{name}: {off:e} of {size:e}");
    }
}

const PLATE: &str = r#"
    gravity = [0, 0, -9.81]
    materials.m = { density = 500, young = 2.1e8, poisson = 0.3 }
    [[bodies]]
    kind = "shell"
    name = "s"
    surface = { kind = "flat", corner = [0, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }
    elements = [3, 3]
    thickness = 0.01
    material = "m"
    [[joints]]
    kind = "support"
    name = "root"
    a = { body = "s", at = { edge = "u_start" } }
    condition = "clamped"
    [[loads]]
    kind = "surface_pressure"
    body = "s"
    pressure = 20
    [[probes]]
    name = "tip"
    on = { body = "s", at = [1, 1] }
    [analysis]
    kind = "statics"
"#;

fn solve(text: &str) -> Series {
    let mut series = Series::new();
    let summary = simulate(&Model::parse(text).unwrap(), &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

/// The reaction of the clamped edge carries weight and pressure, and does not depend on the units.
#[test]
fn reactions_and_units() {
    let series = solve(PLATE);
    let last = |series: &Series, name: &str| *series.column(name).unwrap().last().unwrap();
    let weight = 500.0 * 0.01 * 9.81;
    let force = [last(&series, "root.fx"), last(&series, "root.fz")];
    // The pressure follows the normal: its resultant is that of the surface, with the magnitude of a flat plate at most.
    let [x, z] = [-force[0], weight - force[1]];
    assert!(x.hypot(z) < 20.0 && x.hypot(z) > 18.0, "{force:?}");
    let millimetres = PLATE
        .replace("[0, 0, -9.81]", "[0, 0, -9810]")
        .replace("density = 500, young = 2.1e8", "density = 500e-12, young = 210")
        .replace("[1, 0, 0]", "[1000, 0, 0]")
        .replace("[0, 1, 0]", "[0, 1000, 0]")
        .replace("0.01", "10")
        .replace("pressure = 20", "pressure = 20e-6");
    let other = solve(&millimetres);
    for axis in ["tip.x", "tip.y", "tip.z"] {
        assert!((last(&other, axis) / 1000.0 - last(&series, axis)).abs() < 1e-8, "{axis}");
    }
}

/// Paths of the keys that a model with a change is rejected for.
fn paths(from: &str, to: &str) -> Vec<String> {
    let text = PLATE.replace(from, to);
    assert_ne!(text, PLATE, "{from}");
    Model::parse(&text).expect_err(to).0.iter().map(|error| error.path.clone()).collect()
}

#[test]
fn unsupported_combinations_are_rejected() {
    let analysis = "[analysis]";
    for (from, to, path) in [
        ("side_v = [0, 1, 0]", "side_v = [2, 0, 0]", "bodies[0].surface"),
        ("side_v = [0, 1, 0]", "side_v = [0, 0, 0]", "bodies[0].surface"),
        ("thickness = 0.01", "thickness = 0", "bodies[0].thickness"),
        ("elements = [3, 3]", "elements = [3, 0]", "bodies[0].elements[1]"),
        ("poisson = 0.3", "poisson = 0.3, law = \"neo_hookean\"", "bodies[0].material"),
        ("poisson = 0.3", "poisson = 0.3, damping = { bending = 1e-3 }", "bodies[0].material"),
        ("material = \"m\"", "material = \"n\"", "bodies[0].material"),
        ("condition = \"clamped\"", "condition = \"guided\"", "joints[0].axes"),
        ("at = { edge = \"u_start\" }", "at = [0, 0]", "joints[0].a.at"),
        ("at = [1, 1]", "at = [1, 1.5]", "probes[0].on.at[1]"),
        ("at = [1, 1]", "at = { edge = \"u_end\" }", "probes[0].on.at"),
        ("at = [1, 1]", "at = \"end\"", "probes[0].on.at"),
        ("at = [1, 1] }", "at = [1, 1] }\noffset = [0.1, 0]", "probes[0].offset"),
        ("at = [1, 1] }", "at = [1, 1] }\nrecord = [\"stress\"]", "probes[0].on.body"),
        ("kind = \"statics\"", "kind = \"modes\"\ndamped = true\n[output]\nerrors = true", "output.errors"),
        (
            analysis,
            "[[contacts]]\nwith = { kind = \"plane\", point = [0, 0, -1], normal = [0, 0, 1] }\nstiffness = 1\n[analysis]",
            "contacts[0].surface_stiffness",
        ),
        (
            analysis,
            "[[loads]]\nkind = \"fluid\"\nbodies = [\"s\"]\ndensity = 1\n[analysis]",
            "loads[1].bodies[0]",
        ),
        (
            analysis,
            "[[loads]]\nkind = \"distributed_force\"\nbody = \"s\"\nforce = [0, 0, 1]\n[analysis]",
            "loads[1].body",
        ),
        (
            analysis,
            "[[joints]]\nkind = \"spherical\"\nname = \"b\"\na = { body = \"s\", at = [0.5, 0.5] }\nb = { body = \"s\", at = [0.5, 0.4] }\n[analysis]",
            "joints[1].b.at",
        ),
        (
            analysis,
            "[[joints]]\nkind = \"clamp\"\nname = \"b\"\na = { body = \"s\", at = [1, 1] }\nfix = \"all\"\n[analysis]",
            "joints[1].fix",
        ),
        (
            analysis,
            "[[joints]]\nkind = \"clamp\"\nname = \"b\"\na = { body = \"s\", at = { edge = \"u_end\" } }\n[analysis]",
            "joints[1].a.at",
        ),
    ] {
        let found = paths(from, to);
        assert!(found.iter().any(|found| found == path), "{to}: {found:?}, expected {path}");
    }
}

/// A hinged plate of a tenth of its side deflects by 5 % more with transverse shear: 0.0042728 instead of 0.0040624 q a⁴/D (Navier).
#[test]
fn thick_shells_are_warnings() {
    let count = |thickness: &str| {
        let text = PLATE.replace("thickness = 0.01", thickness);
        let warnings = Model::parse(&text).unwrap().diagnose().unwrap().warnings;
        warnings.iter().filter(|warning| warning.contains("transverse shear")).count()
    };
    assert_eq!([count("thickness = 0.01"), count("thickness = 0.049"), count("thickness = 0.1")], [0, 0, 1]);
}
