//! Joined shells in motions, modes and buckling, against single patches and conservation laws.

use std::f64::consts::{FRAC_PI_2, TAU};

use ancf::record::Series;
use ancf::{Model, simulate};

use crate::common::assertions::{assert_near, assert_relative};

const MATERIAL: &str = "materials.m = { density = 100, young = 1.092e7, poisson = 0.3 }\n";

fn run(text: &str) -> Series {
    let mut series = Series::new();
    let summary = simulate(&Model::parse(text).unwrap(), &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

fn shell(name: &str, [corner, side_u, side_v]: [[f64; 3]; 3], elements: [u32; 2], keys: &str) -> String {
    format!(
        "[[bodies]]\nkind = \"shell\"\nname = \"{name}\"\nthickness = 0.01\nmaterial = \"m\"\nelements = {elements:?}\n\
         surface = {{ kind = \"flat\", corner = {corner:?}, side_u = {side_u:?}, side_v = {side_v:?} }}\n{keys}"
    )
}

fn seam([a, edge]: [&str; 2], [b, other]: [&str; 2]) -> String {
    format!(
        "[[joints]]\nkind = \"seam\"\nname = \"{a} {b}\"\na = {{ body = \"{a}\", at = {{ edge = \"{edge}\" }} }}\n\
         b = {{ body = \"{b}\", at = {{ edge = \"{other}\" }} }}\n"
    )
}

fn support(body: &str, edge: &str, condition: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{body} {edge}\"\na = {{ body = \"{body}\", at = {{ edge = \"{edge}\" }} }}\n\
         condition = \"{condition}\"\n"
    )
}

/// Plate of 2 × 1 in two halves. The second one has the given directions: exchanged parameters and reversed normals.
fn halves(way: usize, elements: u32) -> (String, [&'static str; 2]) {
    let first = shell("s", [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [elements; 2], "");
    let ([corner, u, v], edges) = [
        ([[1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], ["u_start", "u_end"]),
        ([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0]], ["v_start", "v_end"]),
        ([[2.0, 1.0, 0.0], [0.0, -1.0, 0.0], [-1.0, 0.0, 0.0]], ["v_end", "v_start"]),
        ([[1.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, -1.0, 0.0]], ["u_start", "u_end"]),
    ][way];
    (first + &shell("t", [corner, u, v], [elements; 2], ""), edges)
}

/// Frequencies of a cantilever plate of two halves in any directions are those of one patch.
#[test]
fn modes_of_joined_plates_do_not_depend_on_the_directions() {
    let analysis = "[analysis]\nkind = \"modes\"\ncount = 5\n";
    let frequencies = |text: &str| run(text).column("frequency").unwrap().to_vec();
    let whole = shell("s", [[0.0; 3], [2.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [8, 4], "");
    let whole = frequencies(&format!("{MATERIAL}{whole}{}{analysis}", support("s", "u_start", "clamped")));
    for way in 0..4 {
        let (shells, [edge, _]) = halves(way, 4);
        let text = format!(
            "{MATERIAL}{shells}{}{}{analysis}",
            support("s", "u_start", "clamped"),
            seam(["s", "u_end"], ["t", edge])
        );
        for (k, (found, exact)) in frequencies(&text).iter().zip(&whole).enumerate() {
            assert_relative(&format!("way {way}, mode {k}"), *found, *exact, 1e-3);
        }
    }
}

/// Buckling load of a compressed strip of two halves: π² D b/(4 L²) with ν = 0, and that of one patch.
#[test]
fn buckling_of_joined_strips_is_that_of_one_patch() {
    let material = "materials.m = { density = 100, young = 1.2e7 }\n";
    let end = |body: &str, edge: &str| {
        format!(
            "[[loads]]\nkind = \"edge_force\"\nbody = \"{body}\"\nedge = \"{edge}\"\nforce = [-1e-3, 0, 0]\n[analysis]\nkind = \"buckling\"\ncount = 1\n"
        )
    };
    let (shells, [edge, free]) = halves(2, 4);
    let text = format!(
        "{material}{shells}{}{}{}",
        support("s", "u_start", "clamped"),
        seam(["t", edge], ["s", "u_end"]),
        end("t", free)
    );
    let series = run(&text);
    let factor = series.column("factor").unwrap()[0];
    assert_relative("buckling", factor * 1e-3, FRAC_PI_2.powi(2) / 4.0, 2e-3);
}

/// An angle section of two plates, free in space, with velocities that bend it: momenta and the energy are constant, and the kink
/// keeps its angle.
#[test]
fn joined_plates_in_flight_conserve_momenta_and_energy() {
    for (scheme, tolerance) in [("\"energy\"", 1e-8), ("{ spectral_radius = 1.0 }", 2e-3)] {
        let motion = "motion = { velocity = [0.3, 0.1, 0.2], spin = [4.0, 2.0, -6.0], about = [0, 0, 0] }\n";
        let first = shell("s", [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.5, 0.0]], [3, 2], motion);
        let second = shell("t", [[1.0, 0.5, 0.0], [0.0, -0.5, 0.0], [0.0, 0.0, 1.0]], [2, 3], motion);
        let text = format!(
            "{MATERIAL}{first}{second}{}[[probes]]\nname = \"P\"\non = {{ body = \"s\", at = [1, 0.5] }}\nrecord = [\"motion\", \"rotation\"]\n\
             [[probes]]\nname = \"Q\"\non = {{ body = \"t\", at = [0.5, 0] }}\nrecord = [\"motion\", \"rotation\"]\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 2.5e-3\nscheme = {scheme}\n[output]\nmomentum = true\n",
            seam(["s", "u_end"], ["t", "v_start"])
        );
        let series = run(&text);
        let column = |name: &str| series.column(name).unwrap_or_else(|| panic!("no column {name}"));
        let (kinetic, strain) = (column("kinetic"), column("strain"));
        let total = |row: usize| kinetic[row] + strain[row];
        let drift = (0..kinetic.len()).map(|row| (total(row) - total(0)).abs()).fold(0.0, f64::max);
        assert!(drift < tolerance * kinetic[0], "{scheme}: {drift} of {}", kinetic[0]);
        assert!(strain.iter().any(|e| *e > 1e-4 * kinetic[0]), "{scheme}: no strain");
        for name in ["px", "py", "pz", "lx", "ly", "lz"] {
            let values = column(name);
            let size = ["x", "y", "z"].map(|axis| column(&format!("{}{axis}", &name[..1]))[0].abs());
            let size = size.into_iter().fold(0.0, f64::max);
            let off = values.iter().map(|x| (x - values[0]).abs()).fold(0.0, f64::max);
            assert!(off < tolerance * size, "{scheme}, {name}: {off:e} of {size:e}");
        }
        for axis in ["x", "y", "z"] {
            let (p, q) = (column(&format!("P.{axis}")), column(&format!("Q.{axis}")));
            for (p, q) in p.iter().zip(q) {
                assert_near(axis, *p, *q, 1e-9);
            }
        }
        for k in 0..4 {
            // Both ends of the seam rotate alike; e and −e are the same rotation.
            let (p, q) = (column(&format!("P.e{k}")), column(&format!("Q.e{k}")));
            let last = [p[p.len() - 1].abs(), q[q.len() - 1].abs()];
            assert_near("rotation", last[0], last[1], 2e-3);
        }
    }
}

/// The same model in millimetres and turned in space has the same deflections.
#[test]
fn units_and_directions_of_the_world_do_not_matter() {
    let model = |unit: f64, turned: bool| {
        let vector = |[x, y, z]: [f64; 3]| if turned { [-y, z, -x] } else { [x, y, z] };
        let at = |v: [f64; 3]| vector(v).map(|x| x * unit);
        let of = |name: &str, vectors: [[f64; 3]; 3]| {
            shell(name, vectors.map(at), [4, 4], "").replace("0.01", &format!("{:e}", 0.01 * unit))
        };
        let force = vector([0.0, 0.1, 0.6]).map(|f| f / unit);
        format!(
            "materials.m = {{ density = {:e}, young = {:e}, poisson = 0.3 }}\n{}{}{}{}\
             [[loads]]\nkind = \"edge_force\"\nbody = \"t\"\nedge = \"u_end\"\nforce = {force:?}\n\
             [[probes]]\nname = \"A\"\non = {{ body = \"t\", at = [1, 0] }}\n[analysis]\nkind = \"statics\"\n",
            100.0 / unit.powi(3),
            1.092e7 / unit.powi(2),
            of("s", [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]),
            of("t", [[1.0, 0.0, 0.0], [0.6, 0.0, 0.8], [0.0, 1.0, 0.0]]),
            support("s", "u_start", "clamped"),
            seam(["s", "u_end"], ["t", "u_start"])
        )
    };
    let tip = |unit: f64, turned: bool| {
        let series = run(&model(unit, turned));
        let value = |name: &str| *series.column(name).unwrap().last().unwrap() / unit;
        let [x, y, z] = ["A.x", "A.y", "A.z"].map(value);
        let reactions = ["s t.fx", "s t.fy", "s t.fz"].map(value);
        if turned {
            ([-z, -x, y], [-reactions[2], -reactions[0], reactions[1]])
        } else {
            ([x, y, z], reactions)
        }
    };
    let (plain, force) = tip(1.0, false);
    assert!(plain[2] - 0.8 > 0.3, "{plain:?}");
    for (unit, turned) in [(1000.0, false), (1.0, true), (1000.0, true)] {
        let (found, reaction) = tip(unit, turned);
        for k in 0..3 {
            assert_near("tip", found[k], plain[k], 1e-8);
            assert_near("reaction", reaction[k] * unit, force[k], 1e-7);
        }
    }
}

/// Moment of the reaction of a seam: that of the load about the middle of the edge. The load is small, so that arms are those of the
/// reference state.
#[test]
fn reactions_of_seams_have_the_moment_of_the_load() {
    let (shells, [edge, free]) = halves(2, 4);
    let text = format!(
        "{MATERIAL}{shells}{}{}[[loads]]\nkind = \"edge_force\"\nbody = \"t\"\nedge = \"{free}\"\nforce = [0, 1e-6, 3e-6]\n\
         [[loads]]\nkind = \"force\"\non = {{ body = \"t\", at = [0, 0] }}\nforce = [0, 0, 2e-6]\n[analysis]\nkind = \"statics\"\n",
        support("s", "u_start", "clamped"),
        seam(["s", "u_end"], ["t", edge])
    );
    let series = run(&text);
    let value = |name: &str| *series.column(&format!("s t.{name}")).unwrap().last().unwrap();
    // The edge has the middle [1, ½, 0], the edge force acts at [2, ½, 0], and the force at the corner u = v = 0, [2, 1, 0].
    let exact = [0.0, 1e-6, 5e-6, 0.5 * 2e-6, -(3e-6 + 2e-6), 1e-6];
    for (name, exact) in ["fx", "fy", "fz", "mx", "my", "mz"].into_iter().zip(exact) {
        assert_near(name, value(name), exact, 1e-9);
    }
}

/// Nearly 200 elements along a closed cylinder: the assembly of the seam takes a time proportional to its length.
#[test]
fn long_seams_are_assembled_in_little_time() {
    let text = format!(
        "materials.m = {{ density = 100, young = 1.2e7 }}\n[[bodies]]\nkind = \"shell\"\nname = \"s\"\nthickness = 0.01\nmaterial = \"m\"\n\
         elements = [8, 200]\nsurface = {{ kind = \"revolved\", from = [1, 0, 0], to = [1, 0, 50], center = [0, 0, 0], axis = [0, 0, 1], angle = {TAU} }}\n\
         {}[analysis]\nkind = \"statics\"\n",
        seam(["s", "u_end"], ["s", "u_start"])
    );
    let model = Model::parse(&text).unwrap();
    let start = std::time::Instant::now();
    let warnings = model.diagnose().unwrap().warnings;
    assert!(warnings.iter().all(|warning| !warning.contains("redundant")), "{warnings:?}");
    assert!(start.elapsed().as_secs_f64() < 20.0, "{:?}", start.elapsed());
}
