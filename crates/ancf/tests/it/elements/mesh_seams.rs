//! Seams of shear-deformable shells: folded and branched structures.

use std::fmt::Write;

use ancf::Model;

use crate::common::assertions::assert_relative;
use crate::common::models::parse;
use crate::common::solutions::Run;

fn run(text: &str) -> (Run, Vec<String>) {
    let model = parse(text);
    (Run::of(&model), model.diagnose().unwrap().warnings)
}

/// Parallelogram with the edges `u0`, `u1`, `v0`, `v1`, the line `middle` along u, and the corner `tip` at u = 1, v = 0.
fn panel(name: &str, corner: [f64; 3], [a, b]: [[f64; 3]; 2], [n, m]: [usize; 2]) -> String {
    let node = |i: usize, j: usize| j * (n + 1) + i;
    let at = |i: usize, j: usize| {
        let [u, v] = [i as f64 / n as f64, j as f64 / m as f64];
        std::array::from_fn::<f64, 3, _>(|k| corner[k] + a[k] * u + b[k] * v)
    };
    let nodes: Vec<_> = (0..=m).flat_map(|j| (0..=n).map(move |i| (i, j))).map(|(i, j)| at(i, j)).collect();
    let elements: Vec<_> = (0..m)
        .flat_map(|j| (0..n).map(move |i| (i, j)))
        .map(|(i, j)| [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)])
        .collect();
    let row = |j: usize| (0..=n).map(|i| node(i, j)).collect::<Vec<_>>();
    let column = |i: usize| (0..=m).map(|j| node(i, j)).collect::<Vec<_>>();
    let mut text = format!(
        "[[bodies]]\nkind = \"shear_shell\"\nname = \"{name}\"\nthickness = 0.01\nmaterial = \"m\"\n\
         mesh.nodes = {nodes:?}\nmesh.elements = {elements:?}\nmesh.groups.tip = {{ nodes = [{}] }}\n",
        node(n, 0)
    );
    for (name, chain) in
        [("u0", column(0)), ("u1", column(n)), ("v0", row(0)), ("v1", row(m)), ("middle", row(m / 2))]
    {
        let _ = writeln!(text, "mesh.groups.{name} = {{ edges = [{chain:?}] }}");
    }
    text
}

fn seam([a, edge]: [&str; 2], [b, other]: [&str; 2], condition: &str) -> String {
    format!(
        "[[joints]]\nkind = \"seam\"\nname = \"{a} {edge} {b}\"\na = {{ body = \"{a}\", at = {{ edge = \"{edge}\" }} }}\n\
         b = {{ body = \"{b}\", at = {{ edge = \"{other}\" }} }}\ncondition = \"{condition}\"\n"
    )
}

fn clamped(body: &str, edge: &str) -> String {
    format!(
        "[[joints]]\nkind = \"support\"\nname = \"{body} {edge}\"\na = {{ body = \"{body}\", at = {{ edge = \"{edge}\" }} }}\n\
         condition = \"clamped\"\n"
    )
}

fn edge_force(body: &str, edge: &str, force: [f64; 3]) -> String {
    format!("[[loads]]\nkind = \"edge_force\"\nbody = \"{body}\"\nedge = \"{edge}\"\nforce = {force:?}\n")
}

fn probe(body: &str) -> String {
    format!("[[probes]]\nname = \"{body}\"\non = {{ body = \"{body}\", at = {{ point = \"tip\" }} }}\n")
}

fn material(poisson: f64) -> String {
    format!("materials.m = {{ density = 100, young = 1.2e7, poisson = {poisson} }}\n")
}

const STATICS: &str = "[analysis]\nkind = \"statics\"\n";

/// Two halves of a cantilever plate deflect as one mesh, also by large displacements.
#[test]
fn a_rigid_seam_of_equal_directors_joins_meshes() {
    let load = |body: &str| edge_force(body, "u1", [0.0, 0.3, 1.0]) + &probe(body) + STATICS;
    let whole = panel("a", [0.0; 3], [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [8, 4]);
    let (one, _) = run(&(material(0.3) + &whole + &clamped("a", "u0") + &load("a")));
    let halves = panel("b", [0.0; 3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [4, 4])
        + &panel("a", [1.0, 0.0, 0.0], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [4, 4]);
    let joined = material(0.3) + &halves + &clamped("b", "u0") + &seam(["b", "u1"], ["a", "u0"], "rigid");
    let (two, warnings) = run(&(joined + &load("a")));
    assert!(warnings.is_empty(), "{warnings:?}");
    assert!(one.last("a.z") > 0.5, "{}", one.last("a.z"));
    for axis in ["x", "y", "z"] {
        let [own, other] = [&one, &two].map(|series| series.last(&format!("a.{axis}")));
        assert!((own - other).abs() < 1e-9, "{axis}: {own} and {other}");
    }
}

/// An angle of two strips keeps its right angle: the end moves by F b² l/EI + F b³/3EI. A hinged seam does not carry the load.
#[test]
fn a_rigid_seam_keeps_the_angle_of_a_kink() {
    let (length, height, width) = (1.0, 0.8, 0.2);
    let force = 1e-3;
    let text = material(0.0)
        + &panel("a", [0.0; 3], [[length, 0.0, 0.0], [0.0, width, 0.0]], [8, 1])
        + &panel("b", [length, 0.0, 0.0], [[0.0, 0.0, height], [0.0, width, 0.0]], [8, 1])
        + &clamped("a", "u0")
        + &seam(["a", "u1"], ["b", "u0"], "rigid")
        + &edge_force("b", "u1", [force / width, 0.0, 0.0])
        + &probe("b")
        + STATICS;
    let (series, warnings) = run(&text);
    assert!(warnings.is_empty(), "{warnings:?}");
    let rigidity = 1.2e7 * width * 1e-6 / 12.0;
    let exact = force * height * height * (length + height / 3.0) / rigidity;
    assert!(exact < 0.005);
    assert_relative("end", series.last("b.x") - length, exact, 1e-2);
    let hinged = Model::parse(&text.replace("\"rigid\"", "\"hinged\"")).unwrap();
    let free = hinged.diagnose().unwrap();
    assert!(format!("{free:?}").contains("free"), "{free:?}");
}

/// A square tube of four panels twists by Bredt's formula, θ = T l/(G a³ t).
#[test]
fn a_tube_of_four_panels_twists_as_a_closed_section() {
    let (length, side, torque) = (1.0, 0.2, 1.0);
    let along = [length, 0.0, 0.0];
    let h = 0.5 * side;
    let panels = [
        ("a", [0.0, -h, -h], [0.0, side, 0.0]),
        ("b", [0.0, h, -h], [0.0, 0.0, side]),
        ("c", [0.0, h, h], [0.0, -side, 0.0]),
        ("d", [0.0, -h, h], [0.0, 0.0, -side]),
    ];
    let mut text = material(0.3);
    for (name, corner, across) in panels {
        text += &panel(name, corner, [along, across], [8, 4]);
        text += &clamped(name, "u0");
        // Shear flow T/2A.
        let flow = torque / (2.0 * side * side);
        text += &edge_force(name, "u1", across.map(|x| flow * x / side));
    }
    for (k, name) in ["a", "b", "c", "d"].into_iter().enumerate() {
        let next = ["b", "c", "d", "a"][k];
        text += &seam([name, "v1"], [next, "v0"], "rigid");
    }
    let (series, _) = run(&(text + &probe("a") + STATICS));
    let (y, z) = (series.last("a.y"), series.last("a.z"));
    let twist = z.atan2(y) - (-h).atan2(-h);
    let shear = 1.2e7 / 2.6;
    assert_relative("twist", twist, torque * length / (shear * side.powi(3) * 0.01), 2e-2);
}

/// A plate with a rib in its middle bends as a beam of the T-section.
#[test]
fn a_rib_stiffens_a_plate() {
    let (length, width, height, thickness, force) = (2.0, 0.2, 0.1, 0.01, 0.5);
    let text = material(0.0)
        + &panel("plate", [0.0; 3], [[length, 0.0, 0.0], [0.0, width, 0.0]], [16, 2])
        + &panel("rib", [0.0, 0.5 * width, -height], [[length, 0.0, 0.0], [0.0, 0.0, height]], [16, 2])
        + &clamped("plate", "u0")
        + &clamped("rib", "u0")
        + &seam(["plate", "middle"], ["rib", "v1"], "rigid")
        + &edge_force("plate", "u1", [0.0, 0.0, force / width])
        + &probe("plate")
        + STATICS;
    let (series, _) = run(&text);
    // Middle surfaces: the rib ends in the middle of the plate.
    let areas = [width * thickness, height * thickness];
    let centre = -areas[1] * 0.5 * height / (areas[0] + areas[1]);
    let inertia = areas[0] * (centre * centre + thickness.powi(2) / 12.0)
        + areas[1] * ((0.5 * height + centre).powi(2) + height.powi(2) / 12.0);
    let exact = force * length.powi(3) / (3.0 * 1.2e7 * inertia);
    assert_relative("end", series.last("plate.z"), exact, 2e-2);
}

/// Edges without common nodes, slight kinks and shells of both kinds are errors with their place.
#[test]
fn unlike_edges_are_rejected() {
    let flat = panel("a", [0.0; 3], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [2, 2]);
    let beside = |elements: [usize; 2], slope: f64| {
        panel("b", [1.0, 0.0, 0.0], [[1.0, 0.0, slope], [0.0, 1.0, 0.0]], elements)
    };
    let thin = "[[bodies]]\nkind = \"shell\"\nname = \"b\"\nthickness = 0.01\nmaterial = \"m\"\nelements = [2, 2]\n\
                surface = { kind = \"flat\", corner = [1, 0, 0], side_u = [1, 0, 0], side_v = [0, 1, 0] }\n";
    let shifted = panel("b", [1.0, 0.1, 0.0], [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [2, 2]);
    for (other, edge, part) in [
        (beside([2, 3], 0.0), "u0", "edges of 3 and 4 nodes"),
        (shifted, "u0", "from the other edge"),
        (beside([2, 2], 0.1), "u0", "directors at 0.09"),
        (thin.to_owned(), "u_start", "both kinds"),
    ] {
        let text = material(0.3)
            + &flat
            + &other
            + &clamped("a", "u0")
            + &seam(["a", "u1"], ["b", edge], "rigid")
            + STATICS;
        let error = Model::parse(&text).unwrap_err().to_string();
        assert!(error.contains("joints[1]") && error.contains(part), "{part}: {error}");
    }
}

/// The moment of the reaction of an edge refers to its middle, also between two nodes and with elements of unequal width: that of a
/// uniform force across the edge is zero about the axis along the plate, whatever the order of the nodes.
#[test]
fn moments_of_edges_refer_to_their_middle() {
    for widths in [vec![0.1, 0.1, 0.1], vec![0.05, 0.25], vec![0.3], vec![0.1; 4], vec![0.2, 0.1, 0.3, 0.05]]
    {
        let mut y = vec![0.0];
        for width in &widths {
            y.push(y.last().unwrap() + width);
        }
        let nodes: Vec<_> = y.iter().flat_map(|y| [[0.0, *y, 0.0], [1.0, *y, 0.0]]).collect();
        let elements: Vec<_> = (0..widths.len()).map(|k| [0, 1, 3, 2].map(|node| node + 2 * k)).collect();
        let mut root: Vec<_> = (0..y.len()).map(|k| 2 * k).collect();
        let tip: Vec<_> = root.iter().map(|k| k + 1).collect();
        for _ in 0..2 {
            let text = format!(
                "{}{STATICS}[[bodies]]\nkind = \"shear_shell\"\nname = \"p\"\nthickness = 0.01\nmaterial = \"m\"\n\
                 mesh.nodes = {nodes:?}\nmesh.elements = {elements:?}\nmesh.groups.root = {{ edges = [{root:?}] }}\n\
                 mesh.groups.tip = {{ edges = [{tip:?}] }}\n{}{}",
                material(0.3),
                clamped("p", "root"),
                edge_force("p", "tip", [0.0, 0.0, 1e-3])
            );
            let (solved, _) = run(&text);
            let width: f64 = widths.iter().sum();
            assert_relative("force", solved.last("p root.fz"), -1e-3 * width, 1e-9);
            let moment = solved.last("p root.mx");
            assert!(moment.abs() < 1e-8 * width * width, "{widths:?}: {moment:e}");
            root.reverse();
        }
    }
}
