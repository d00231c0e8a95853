//! Shells of both kinds touch obstacles with their thickness.

use std::fmt::Write;

use ancf::record::Series;
use ancf::{Model, simulate};

use crate::common::assertions::{assert_near, assert_relative};

/// A flat shell over a rectangle at a height, of n × m elements.
fn plate(kind: &str, [corner, sides]: [[f64; 3]; 2], [n, m]: [usize; 2], keys: &str) -> String {
    let mut text = format!("[[bodies]]\nkind = \"{kind}\"\nname = \"s\"\nmaterial = \"m\"\n{keys}\n");
    let [[x, y, z], [a, b, _]] = [corner, sides];
    if kind == "shell" {
        let surface = format!("corner = {corner:?}, side_u = [{a}, 0, 0], side_v = [0, {b}, 0]");
        writeln!(text, "surface = {{ kind = \"flat\", {surface} }}\nelements = [{n}, {m}]").unwrap();
        return text;
    }
    let grid = |count: usize, i: usize| i as f64 / count as f64;
    let nodes = (0..=m).flat_map(|j| (0..=n).map(move |i| [x + a * grid(n, i), y + b * grid(m, j), z]));
    let node = |i: usize, j: usize| j * (n + 1) + i;
    let cells = (0..m).flat_map(|j| (0..n).map(move |i| (i, j)));
    let quad = |(i, j)| [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)];
    let elements: Vec<Vec<usize>> = cells.map(|cell| quad(cell).to_vec()).collect();
    // Every other quadrilateral as two triangles.
    let elements: Vec<Vec<usize>> = elements
        .into_iter()
        .enumerate()
        .flat_map(
            |(k, q)| if k % 2 == 0 { vec![q] } else { vec![vec![q[0], q[1], q[2]], vec![q[0], q[2], q[3]]] },
        )
        .collect();
    let edge = |i: usize| (0..=m).map(|j| node(i, j)).collect::<Vec<_>>();
    let nodes: Vec<[f64; 3]> = nodes.collect();
    writeln!(
        text,
        "[bodies.mesh]\nnodes = {nodes:?}\nelements = {elements:?}\n\
         groups = {{ u_start = {{ edges = [{:?}] }}, u_end = {{ edges = [{:?}] }} }}",
        edge(0),
        edge(n)
    )
    .unwrap();
    text
}

fn run(text: &str) -> Series {
    let mut series = Series::new();
    let model = Model::parse(text).unwrap_or_else(|error| panic!("{error}\n{text}"));
    let summary = simulate(&model, &mut series).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}\n{text}", summary.outcome);
    series
}

fn last(series: &Series, name: &str) -> f64 {
    *series.column(name).unwrap_or_else(|| panic!("no column {name}")).last().unwrap()
}

const KINDS: [&str; 2] = ["shell", "shear_shell"];

/// A plate that falls on a plane comes to rest with ρ h g = k d²/(2δ), or k (d − δ/2) beyond δ.
#[test]
fn plates_rest_on_a_plane() {
    for (kind, transition) in KINDS.into_iter().flat_map(|kind| [(kind, 0.002), (kind, 1e-4)]) {
        let text = format!(
            "gravity = [0, 0, -10]\nmaterials.m = {{ density = 1000, young = 1e7, damping = {{ strain = 1e-3 }} }}\n{}\
             [[contacts]]\nwith = {{ kind = \"plane\", point = [0, 0, 0], normal = [0, 0, 2] }}\nsurface_stiffness = 4e5\n\
             damping = 20\ntransition = {transition}\n\
             [[probes]]\nname = \"p\"\non = {{ body = \"s\", at = {} }}\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.6\nstep = 1e-3\nscheme = {{ spectral_radius = 0.6 }}\n",
            plate(kind, [[0.0, 0.0, 0.012], [0.4, 0.3, 0.0]], [3, 2], "thickness = 0.02"),
            if kind == "shell" { "[0.3, 0.8]" } else { "[0.1, 0.2, 0.012]" },
        );
        let pressure = 1000.0 * 0.02 * 10.0;
        let in_transition = f64::sqrt(2.0 * transition * pressure / 4e5);
        let depth =
            if in_transition < transition { in_transition } else { pressure / 4e5 + 0.5 * transition };
        assert_near(kind, last(&run(&text), "p.z"), 0.01 - depth, 1e-6);
    }
}

/// Half of a long strip on a plane under a pressure q and a line load P at its middle, as a beam on an elastic foundation.
///
/// Source: Hetényi (1946): w = q/k + P β/(2 k) exp(−βx)(cos βx + sin βx), β⁴ = k/(4D).
#[test]
fn strips_on_a_foundation_have_the_deflection_of_hetenyi() {
    let (young, thickness, stiffness) = (1.2e9_f64, 0.01_f64, 1e6);
    let beta = (stiffness / (4.0 * young * thickness.powi(3) / 12.0)).powf(0.25);
    let (length, transition, pressure, load) = (9.0 / beta, 1e-6, 200.0, 2.0);
    let rest = pressure / stiffness + 0.5 * transition;
    let at =
        |x: f64| load * beta / (2.0 * stiffness) * (-beta * x).exp() * ((beta * x).cos() + (beta * x).sin());
    for kind in KINDS {
        let (elements, tolerance) = if kind == "shell" { ([24, 1], 2e-3) } else { ([96, 2], 1e-2) };
        let quarter = 0.25 * length / 9.0;
        let place = |x: f64| {
            if kind == "shell" { format!("[{}, 0.5]", x / length) } else { format!("[{x}, 0.05, 0]") }
        };
        let probe = |name: &str, x: f64| {
            format!("[[probes]]\nname = \"{name}\"\non = {{ body = \"s\", at = {} }}\n", place(x))
        };
        let support = |edge: &str, condition: &str| {
            format!(
                "[[joints]]\nkind = \"support\"\nname = \"{edge}\"\na = {{ body = \"s\", at = {{ edge = \"{edge}\" }} }}\n\
                 condition = \"{condition}\"\n"
            )
        };
        let text = format!(
            "materials.m = {{ density = 1000, young = {young} }}\n{}{}{}{}{}\
             [[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\npressure = {}\n\
             [[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"u_start\"\nforce = [0, 0, {}]\n\
             [[contacts]]\nwith = {{ kind = \"plane\", point = [0, 0, {}], normal = [0, 0, 1] }}\n\
             surface_stiffness = {stiffness}\ntransition = {transition}\n[analysis]\nkind = \"statics\"\n",
            plate(kind, [[0.0, 0.0, 0.0], [length, 0.1, 0.0]], elements, "thickness = 0.01"),
            support("u_start", "symmetry"),
            support("u_end", "clamped"),
            probe("a", 0.0),
            probe("b", 4.0 * quarter),
            -pressure,
            -0.5 * load,
            rest - 0.5 * thickness,
        );
        let series = run(&text);
        assert_relative(kind, last(&series, "a.z"), -at(0.0), tolerance);
        assert_near(kind, last(&series, "b.z"), -at(4.0 * quarter), tolerance * at(0.0));
    }
}

/// A strip that bends over a cylinder takes the shape of a beam with the same stiffness and k times its width.
#[test]
fn strips_over_a_cylinder_bend_as_beams() {
    let common = "gravity = [0, 0, -10]\nmaterials.m = { density = 1000, young = 2e7 }\n\
                  sections.bar = { kind = \"rectangle\", height = 0.01, width = 0.1 }\n";
    let rest = |stiffness: &str, at: &str, joint: &str| {
        format!(
            "{joint}[[probes]]\nname = \"end\"\non = {{ body = \"s\", at = {at} }}\n\
             [[contacts]]\nwith = {{ kind = \"cylinder\", point = [0.35, 0, -0.125], axis = [0, 1, 0], radius = 0.1 }}\n\
             transition = 1e-3\npoints = 8\n{stiffness}\n[analysis]\nkind = \"statics\"\n"
        )
    };
    let clamp = "[[joints]]\nkind = \"clamp\"\nname = \"c\"\na = { body = \"s\", at = \"start\" }\n";
    let beam = "[[bodies]]\nkind = \"beam\"\nname = \"s\"\nfrom = [0, 0, 0]\nto = [0.8, 0, 0]\nup = [0, 0, 1]\nelements = 32\n\
                section = \"bar\"\nmaterial = \"m\"\n";
    let line = run(&format!("{common}{beam}{}", rest("stiffness = 1e5\nradius = 0.005", "\"end\"", clamp)));
    for kind in KINDS {
        let (elements, at) =
            if kind == "shell" { ([32, 1], "[1, 0.5]") } else { ([64, 1], "[0.8, 0.05, 0]") };
        let body = plate(kind, [[0.0, 0.0, 0.0], [0.8, 0.1, 0.0]], elements, "thickness = 0.01");
        let support = "[[joints]]\nkind = \"support\"\nname = \"c\"\na = { body = \"s\", at = { edge = \"u_start\" } }\n\
                       condition = \"clamped\"\n";
        let surface = run(&format!("{common}{body}{}", rest("surface_stiffness = 1e6", at, support)));
        for column in ["end.x", "end.z"] {
            let [found, expected] = [&surface, &line].map(|series| last(series, column));
            assert_near(&format!("{kind} {column}"), found, expected, 2e-3);
        }
        assert!(last(&surface, "end.z") < -0.2);
    }
}

/// A sheet falls on a sphere on a free body or on a free beam: momentum and angular momentum are kept.
#[test]
fn sheets_that_fall_on_a_ball_keep_the_momentum() {
    let rigid = "kind = \"rigid\"\ncenter = [0.04, 0.02, -0.13]\nmass = 0.5\ninertia = [1e-3, 1e-3, 1e-3]";
    let beam = "kind = \"beam\"\nfrom = [-0.26, 0.02, -0.13]\nto = [0.34, 0.02, -0.13]\nelements = 3\n\
                formulation = \"quadratic\"\nsection = \"r\"\nmaterial = \"m\"";
    for (kind, carrier) in KINDS.into_iter().flat_map(|kind| [(kind, rigid), (kind, beam)]) {
        let keys = "thickness = 0.01\nmotion = { velocity = [0.2, 0, -1] }";
        let text = format!(
            "materials.m = {{ density = 1000, young = 1e6 }}\nsections.r = {{ kind = \"circle\", diameter = 0.04 }}\n{}\
             [[bodies]]\nname = \"ball\"\n{carrier}\n\
             [[contacts]]\nwith = {{ kind = \"sphere\", center = [0.04, 0.02, -0.13], radius = 0.12, \
             on = {{ body = \"ball\", at = \"center\" }} }}\nsurface_stiffness = 4e6\nfriction = 0.3\n\
             [output]\nmomentum = true\n\
             [analysis]\nkind = \"dynamics\"\nduration = 0.1\nstep = 1e-3\nscheme = \"energy\"\n",
            plate(kind, [[-0.2, -0.2, 0.0], [0.4, 0.4, 0.0]], [4, 4], keys),
        );
        let series = run(&text);
        for column in ["px", "py", "pz", "lx", "ly", "lz"] {
            let [s, ball] = ["s", "ball"].map(|body| series.column(&format!("{body}.{column}")).unwrap());
            let change = s.last().unwrap() - s[0] + ball.last().unwrap() - ball[0];
            assert_near(&format!("{kind} {column}"), change, 0.0, 1e-9);
        }
    }
}

/// Errors of keys that no body uses, that bodies lack, and of partners that shells cannot have.
#[test]
fn contacts_of_shells_state_a_surface_stiffness() {
    let model = |keys: &str, bodies: &str| {
        let text = format!(
            "materials.m = {{ density = 1000, young = 1e6 }}\nsections.r = {{ kind = \"circle\", diameter = 0.01 }}\n{}{bodies}\
             [[contacts]]\n{keys}\n[analysis]\nkind = \"dynamics\"\nduration = 0.1\nstep = 1e-3\n",
            plate("shell", [[0.0; 3], [1.0, 1.0, 0.0]], [1, 1], "thickness = 0.01"),
        );
        Model::parse(&text).unwrap_err().to_string()
    };
    let plane = "with = { kind = \"plane\", point = [0, 0, -1], normal = [0, 0, 1] }";
    let cable = "[[bodies]]\nkind = \"cable\"\nname = \"c\"\nfrom = [0, 0, 1]\nto = [1, 0, 1]\nelements = 2\nsection = \"r\"\n\
                 material = \"m\"\n";
    let sphere =
        "with = { kind = \"sphere\", center = [0, 0, 2], radius = 0.1, on = { body = \"s\", at = [0, 0] } }";
    for (found, expected) in [
        (model(&format!("{plane}\nstiffness = 1"), ""), "no key `surface_stiffness` for \"s\""),
        (
            model(&format!("{plane}\nstiffness = 1\nsurface_stiffness = 1"), ""),
            "no such key: no body other than a shell is in contact",
        ),
        (model(&format!("{plane}\nsurface_stiffness = 1"), cable), "no key `stiffness` for \"c\""),
        (
            model(&format!("{plane}\nbodies = [\"c\"]\nstiffness = 1\nsurface_stiffness = 1"), cable),
            "no such key: no shell is in contact",
        ),
        (model(&format!("{plane}\nsurface_stiffness = 1\nradius = 1"), ""), "no beam or cable is in contact"),
        (model(&format!("{sphere}\nbodies = [\"c\"]\nstiffness = 1"), cable), "a shell carries no obstacle"),
    ] {
        assert!(found.contains(expected), "{found}\n{expected}");
    }
}
