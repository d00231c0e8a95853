//! Shear-deformable shells touch each other, themselves, thin shells and beams, also at kinks of their meshes.

use ancf::record::Series;
use ancf::{Model, Scales, simulate};

use crate::common::assertions::{assert_near, assert_relative};
use crate::common::models::parse;

/// Elements of a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Elements {
    Thin,
    Quads,
    Triangles,
}
use Elements::{Quads, Thin, Triangles};

fn run_model(model: &Model) -> Series {
    let mut series = Series::new();
    let summary = simulate(model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    series
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap_or_else(|| panic!("no column {name}")).last().unwrap()
}

/// Mesh of n × m cells over a surface r(u, v), with its edges as groups.
fn mesh(
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
fn sheet(
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
fn clamps(body: &str) -> String {
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
fn table(kind: Elements) -> String {
    let keys = "thickness = 0.02\nmaterial = \"stiff\"";
    sheet(kind, "table", ([-0.3, -0.3, 0.0], [0.6, 0.6]), [4, 3], keys) + &clamps("table")
}

/// Probe of a sheet of 2 × 2 elements in its middle.
fn middle(kind: Elements, name: &str) -> String {
    let at = if kind == Thin { "[0.5, 0.5]" } else { "{ node = 4 }" };
    format!("[[probes]]\nname = \"{name}\"\non = {{ body = \"{name}\", at = {at} }}\n")
}

const MATERIALS: &str = "materials.stiff = { density = 1, young = 1e12 }\n\
                         materials.soft = { density = 1000, young = 1e6, damping = { strain = 2e-3 } }\n";
const CONTACT: &str =
    "[[contacts]]\nwith = { kind = \"bodies\" }\nsurface_stiffness = 4e6\ntransition = 1e-5\n";

/// A sheet slides over the edges and nodes of the elements of a plate without resistance, at the depth d with ρ h g = k (d − δ/2),
/// and with friction it is decelerated by μ g.
#[test]
fn sheets_slide_on_a_plate() {
    let depth = 1000.0 * 0.01 * 10.0 / 4e6 + 0.5e-5;
    let motion = "thickness = 0.01\nmaterial = \"soft\"\nmotion = { velocity = [0.6, 0.05, 0] }";
    let cases = [(Quads, Thin, 0.0), (Thin, Quads, 0.0), (Triangles, Quads, 0.0), (Quads, Triangles, 0.2)];
    for (below, above, friction) in cases {
        let upper = sheet(above, "p", ([-0.25, -0.13, 0.015 - depth], [0.2, 0.2]), [2, 2], motion);
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}{}{upper}{CONTACT}friction = {friction}\nslip_speed = 1e-4\n{}\
             [analysis]\nkind = \"dynamics\"\nduration = 0.2\nstep = 1e-3\n",
            table(below),
            middle(above, "p")
        );
        let series = run_model(&parse(&text));
        let speed = f64::hypot(0.6, 0.05);
        let (way, factor) = (speed * 0.2 - 0.5 * friction * 10.0 * 0.04, 0.6 / speed);
        assert_near("x", last(&series, "p.x") + 0.15, way * factor, 1e-4 + 2e-3 * friction);
        let expected = (speed - friction * 2.0) * factor;
        assert_near("v", last(&series, "p.vx"), expected, 2e-3 + 1e-2 * friction);
        assert_near("z", last(&series, "p.z"), 0.015 - depth, 2e-5);
    }
}

/// Two free sheets collide, frictionless: momentum, angular momentum and, in the energy scheme, energy are kept.
#[test]
fn collisions_keep_momentum_and_energy() {
    let keys = |velocity: &str| {
        format!("thickness = 0.01\nmaterial = \"elastic\"\nmotion = {{ velocity = {velocity} }}")
    };
    for (below, above) in [(Quads, Quads), (Triangles, Thin)] {
        let text = format!(
            "materials.elastic = {{ density = 1000, young = 1e6 }}\n{}{}{CONTACT}\
             [output]\nmomentum = true\n[analysis]\nkind = \"dynamics\"\nduration = 0.03\nstep = 5e-4\nscheme = \"energy\"\n",
            sheet(below, "a", ([0.0, 0.0, 0.0], [0.4, 0.3]), [4, 3], &keys("[0, 0, 0.5]")),
            sheet(above, "b", ([0.25, 0.11, 0.013], [0.35, 0.4]), [3, 4], &keys("[0.3, -0.2, -1]")),
        );
        let series = run_model(&parse(&text));
        for column in ["px", "py", "pz", "lx", "ly", "lz"] {
            let values = series.column(column).unwrap();
            assert_near(column, values.last().unwrap() - values[0], 0.0, 1e-9);
        }
        let pz = series.column("a.pz").unwrap();
        assert!((pz.last().unwrap() - pz[0]).abs() > 0.2, "{:?}", pz.last());
        let change = series.column("balance").unwrap().iter().map(|x| x.abs()).fold(0.0, f64::max);
        assert!(change < 1e-6, "{below:?} {above:?}: {change:e}");
    }
}

/// A cable on a plate of elements with shear lies as on a plane.
#[test]
fn cables_lie_on_plates_as_on_planes() {
    let cable = "[[bodies]]\nkind = \"cable\"\nname = \"c\"\nfrom = [-0.25, -0.2, 0.03]\nto = [0.25, 0.21, 0.03]\nelements = 12\n\
                 section = \"r\"\nmaterial = \"soft\"\n\
                 [[joints]]\nkind = \"spherical\"\nname = \"a\"\na = { body = \"c\", at = \"start\" }\n\
                 [[joints]]\nkind = \"spherical\"\nname = \"b\"\na = { body = \"c\", at = \"end\" }\n\
                 [[probes]]\nname = \"p\"\non = { body = \"c\", at = 0.3 }\n";
    let on = |partner: &str, bodies: &str| {
        let text = format!(
            "gravity = [0, 0, -10]\n{MATERIALS}sections.r = {{ kind = \"circle\", diameter = 0.01 }}\n{bodies}{cable}\
             [[contacts]]\nwith = {{ {partner} }}\nstiffness = 1e4\npoints = 6\ntransition = 1e-4\n{}\
             [analysis]\nkind = \"statics\"\n",
            if bodies.is_empty() { "" } else { "surface_stiffness = 1e6\n" }
        );
        run_model(&parse(&text))
    };
    let on_plane = on("kind = \"plane\", point = [0, 0, 0.01], normal = [0, 0, 1]", "");
    assert!(last(&on_plane, "p.z") < 0.0151, "{}", last(&on_plane, "p.z"));
    for kind in [Quads, Triangles] {
        let on_plate = on("kind = \"bodies\"", &table(kind));
        for column in ["p.x", "p.y", "p.z"] {
            assert_near(column, last(&on_plate, column), last(&on_plane, column), 1e-7);
        }
    }
}

/// A beam comes to rest in a valley between two inclined plates, one mesh with a kink: each side carries W/(2 cos α).
#[test]
fn beams_rest_in_a_valley() {
    for (kind, angle) in [(Quads, 20.0_f64), (Quads, 15.0), (Triangles, 20.0)] {
        let (sine, cosine) = angle.to_radians().sin_cos();
        let surface = |u: f64, v: f64| {
            let y = 0.4 * (v - 0.5);
            [0.4 * u, y * cosine, y.abs() * sine]
        };
        let height = 0.015 / cosine + 5e-4;
        let text = format!(
            "gravity = [0, 0, -10]\nmaterials.stiff = {{ density = 1, young = 1e12 }}\n\
             materials.soft = {{ density = 1000, young = 1e8, damping = {{ strain = 2e-3, mass = 20 }} }}\n\
             sections.r = {{ kind = \"circle\", diameter = 0.02 }}\n{}{}\
             [[bodies]]\nkind = \"beam\"\nname = \"b\"\nfrom = [0.1, 0.001, {height}]\nto = [0.3, 0.001, {height}]\nup = [0, 0, 1]\n\
             elements = 2\nsection = \"r\"\nmaterial = \"soft\"\n\
             [[contacts]]\nwith = {{ kind = \"bodies\" }}\nsurface_stiffness = 4e7\nstiffness = 1e5\ndamping = 5\ntransition = 1e-6\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"b\", at = 0.1 }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = 1\nstep = 2e-3\nscheme = {{ spectral_radius = 0.3 }}\n",
            mesh(kind, "v", [2, 4], "thickness = 0.01\nmaterial = \"stiff\"", surface),
            clamps("v")
        );
        let series = run_model(&parse(&text));
        let weight = 1000.0 * std::f64::consts::PI * 1e-4 * 10.0;
        let depth = 0.5 * weight / cosine / 1e5 + 0.5e-6;
        assert_near("z", last(&series, "p.z"), (0.015 - depth) / cosine, 2e-7);
        assert_near("y", last(&series, "p.y"), 0.0, 2e-5);
    }
}

/// A strip compressed by an eighth, with elements as long as its thickness, does not touch its own elements.
#[test]
fn compressed_strips_do_not_touch_themselves() {
    for kind in [Quads, Triangles] {
        let [with, without] = [true, false].map(|has_contact| {
            let keys = "thickness = 0.01\nmaterial = \"m\"";
            let contact = if has_contact { CONTACT } else { "" };
            let text = format!(
                "materials.m = {{ density = 1000, young = 1e6, poisson = 0 }}\n{}\
                 [[joints]]\nkind = \"support\"\nname = \"a\"\na = {{ body = \"s\", at = {{ edge = \"u_start\" }} }}\ncondition = \"clamped\"\n\
                 [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_end\"\nforce = [-1200, 0, 0]\n{contact}\
                 [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {{ node = 6 }} }}\n\
                 [analysis]\nkind = \"statics\"\n",
                sheet(kind, "s", ([0.0; 3], [0.063, 0.021]), [6, 2], keys)
            );
            last(&run_model(&parse(&text)), "p.x")
        });
        assert!(with < 0.875 * 0.063, "{with}");
        assert_relative("x", with, without, 1e-10);
    }
}

/// A strip of the shape of a C is pressed together until its free edge lies on itself.
fn closing_strip(kind: Elements) -> Model {
    let r = |u: f64, v: f64| {
        let (sine, cosine) = (2.9 * u).sin_cos();
        [0.1 * sine, 0.05 * v, 0.1 - 0.1 * cosine]
    };
    let probes = (0..=20)
        .map(|k| format!("[[probes]]\nname = \"p{k}\"\non = {{ body = \"c\", at = {{ node = {k} }} }}\n"));
    parse(&format!(
        "materials.m = {{ density = 1000, young = 2e6, damping = {{ strain = 2e-2 }} }}\n{}\
         [[joints]]\nkind = \"support\"\nname = \"held\"\na = {{ body = \"c\", at = {{ edge = \"u_start\" }} }}\ncondition = \"clamped\"\n\
         [[loads]]\nkind = \"edge_force\"\nbody = \"c\"\nedge = \"u_end\"\nforce = [1, 0, -2]\ntime = {{ kind = \"ramp\", end = 0.2 }}\n\
         [[contacts]]\nwith = {{ kind = \"bodies\" }}\nsurface_stiffness = 4e7\ndamping = 2\n{}\
         [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 2e-3\nscheme = {{ spectral_radius = 0.6 }}\n",
        mesh(kind, "c", [20, 2], "thickness = 0.004\nmaterial = \"m\"", r),
        probes.collect::<String>()
    ))
}

/// The end of the strip never comes nearer to its first part than its thickness, up to the depth of the impact, in any units.
#[test]
fn strips_touch_themselves() {
    let of = |series: &Series, name: &str| {
        ["x", "z"].map(|axis| series.column(&format!("{name}.{axis}")).unwrap().to_vec())
    };
    let model = closing_strip(Quads);
    let series = run_model(&model);
    let end = of(&series, "p20");
    // Distance of the end from the chords of the first half.
    let mut least = f64::INFINITY;
    for k in 0..10 {
        let [a, b] = [k, k + 1].map(|k| of(&series, &format!("p{k}")));
        for t in 0..end[0].len() {
            let at = |x: &[Vec<f64>; 2]| nalgebra::Vector2::new(x[0][t], x[1][t]);
            let (edge, gap) = (at(&b) - at(&a), at(&end) - at(&a));
            let along = (gap.dot(&edge) / edge.norm_squared()).clamp(0.0, 1.0);
            least = least.min((gap - edge * along).norm());
        }
    }
    assert!(least > 0.003 && least < 0.0044, "{least}");
    let mut free = model.clone();
    free.contacts.clear();
    assert!(last(&run_model(&free), "p20.z") < last(&series, "p20.z") - 0.01);
    let units = Scales { length: 0.037, time: 13.0, force: 2.9e5 };
    let other = run_model(&model.scaled(&units));
    for column in ["p20.x", "p20.z"] {
        assert_near(column, last(&other, column) * units.length, last(&series, column), 1e-8);
    }
}

/// A sheet that flies towards another one by several thicknesses in a step does not pass through it.
#[test]
fn fast_sheets_do_not_pass_through() {
    let keys = |velocity: &str| {
        format!("thickness = 0.002\nmaterial = \"soft\"\nmotion = {{ velocity = {velocity} }}")
    };
    for (below, above) in [(Quads, Triangles), (Thin, Quads)] {
        let text = format!(
            "{MATERIALS}{}{}{}{}{}[analysis]\nkind = \"dynamics\"\nduration = 0.012\nstep = 5e-4\n",
            sheet(below, "a", ([0.0, 0.0, 0.0], [0.2, 0.2]), [2, 2], &keys("[0, 0, 10]")),
            sheet(above, "b", ([0.01, 0.02, 0.0323], [0.2, 0.2]), [2, 2], &keys("[0, 0, -10]")),
            CONTACT.replace("4e6", "1e9"),
            middle(below, "a"),
            middle(above, "b")
        );
        let series = run_model(&parse(&text));
        let [a, b] = ["a.z", "b.z"].map(|name| last(&series, name));
        assert!(b > a, "{a} {b}");
    }
}
