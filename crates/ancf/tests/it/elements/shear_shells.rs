//! Shear-deformable shells in whole models: patch tests, joints, refusals.

use ancf::record::Series;
use ancf::{Model, simulate};

use crate::common::assertions::assert_near;

/// Two square elements of a strip along x, clamped at x = 0.
const STRIP: &str = r#"
materials.m = { young = 1.2e6, poisson = 0.3, density = 1000 }

[[bodies]]
kind = "shear_shell"
name = "s"
thickness = 0.1
material = "m"

[bodies.mesh]
nodes = [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]
elements = [[0, 1, 4, 3], [1, 2, 5, 4]]
groups.root = { edges = [[0, 3]] }
groups.tip = { edges = [[2, 5]] }
groups.corner = { nodes = [2] }
groups.outer = { elements = [1] }

[[joints]]
kind = "support"
name = "root"
a = { body = "s", at = { edge = "root" } }
condition = "clamped"

[[probes]]
name = "corner"
on = { body = "s", at = { point = "corner" } }

[analysis]
kind = "statics"
"#;

fn last(model: &str, column: &str) -> f64 {
    let model = Model::parse(model).unwrap_or_else(|errors| panic!("{errors}\n{model}"));
    let mut series = Series::new();
    let summary = simulate(&model, &mut series).expect("a model");
    assert!(summary.outcome.is_finished());
    *series.column(column).unwrap_or_else(|| panic!("column {column}")).last().expect("a row")
}

/// Paths of the errors of a model with a replaced part.
fn paths(from: &str, to: &str) -> Vec<String> {
    assert!(STRIP.contains(from), "{from}");
    let errors = Model::parse(&STRIP.replace(from, to)).expect_err("a wrong model");
    errors.0.iter().map(|error| error.path.clone()).collect()
}

#[test]
fn wrong_meshes_are_rejected_with_their_element() {
    let elements = "elements = [[0, 1, 4, 3], [1, 2, 5, 4]]";
    let cases = [
        (elements, "elements = [[0, 1, 4, 3], [1, 2, 5, 9]]", "bodies[0].mesh.elements[1]"),
        (elements, "elements = [[0, 1, 4, 3], [1, 2, 5, 5]]", "bodies[0].mesh.elements[1]"),
        (elements, "elements = [[0, 1, 4, 3], [1, 4, 5, 2]]", "bodies[0].mesh.elements[1]"),
        (elements, "elements = [[0, 1, 4, 3], [1, 2, 5], [1, 4, 5]]", "bodies[0].mesh.elements[2]"),
        (elements, "elements = [[0, 1, 4, 3], [1, 2, 5, 4, 3]]", "bodies[0].mesh.elements[1]"),
        (elements, "elements = [[0, 1, 4, 3], [1, 2]]", "bodies[0].mesh.elements[1]"),
        (elements, "elements = [[0, 1, 4, 3], [1, 2, 4, 5]]", "bodies[0].mesh.elements[1]"),
        (elements, "elements = [[0, 1, 4, 3], [1, 2, 5, 4], [1, 2, 5, 4]]", "bodies[0].mesh.elements[2]"),
        (elements, "elements = [[0, 1, 4, 3]]", "bodies[0].mesh.nodes[2]"),
        ("[2, 0, 0], [0, 1, 0]", "[1, 0, 0.8], [0, 1, 0]", "bodies[0].mesh.elements[1]"),
        ("thickness = 0.1", "thickness = 0", "bodies[0].thickness"),
        (
            "groups.tip = { edges = [[2, 5]] }",
            "groups.tip = { edges = [[2, 3]] }",
            "bodies[0].mesh.groups.tip.edges",
        ),
        (
            "groups.tip = { edges = [[2, 5]] }",
            "groups.tip = { edges = [[2, 7]] }",
            "bodies[0].mesh.groups.tip",
        ),
        ("groups.corner = { nodes = [2] }", "groups.corner = {}", "bodies[0].mesh.groups.corner"),
        ("edge = \"root\"", "edge = \"roots\"", "joints[0].a.at.edge"),
        ("edge = \"root\"", "edge = \"u_start\"", "joints[0].a.at.edge"),
        ("point = \"corner\"", "point = \"corners\"", "probes[0].on.at.point"),
        ("at = { point = \"corner\" }", "at = { node = 6 }", "probes[0].on.at.node"),
        ("at = { point = \"corner\" }", "at = [2, 0, 0.1]", "probes[0].on.at"),
        ("at = { point = \"corner\" }", "at = \"center\"", "probes[0].on.at"),
        ("at = { point = \"corner\" }", "at = [0.5, 0.5]", "probes[0].on.at"),
        ("groups.outer", "directors = [[0, 0, 1]]\ngroups.outer", "bodies[0].mesh.directors"),
        ("material = \"m\"", "material = \"m\"\nfibre_axis = [0, 0, 1]", "bodies[0].fibre_axis"),
    ];
    for (from, to, path) in cases {
        let found = paths(from, to);
        assert!(found.iter().any(|found| found == path), "{to}: {found:?}, expected {path}");
    }
}

/// Text of the strip with more nodes and other elements.
fn strip_with(more_nodes: &str, elements: &str) -> String {
    let corners = "[0, 1, 0], [1, 1, 0], [2, 1, 0]";
    STRIP
        .replace(corners, &format!("{corners}, {more_nodes}"))
        .replace("[[0, 1, 4, 3], [1, 2, 5, 4]]", elements)
}

/// A part without connection is free: statics stretched it without limit, and the other part had wrong stresses.
#[test]
fn parts_of_a_mesh_are_connected() {
    // The second square is shifted along x.
    let apart = |gap: f64| {
        let nodes = format!("[{0:?}, 1, 0], [{0:?}, 0, 0]", 1.0 + gap);
        Model::parse(&strip_with(&nodes, "[[0, 1, 4, 3], [7, 2, 5, 6]]")).unwrap_err()
    };
    for (gap, hint) in [(1e-5, "is near node"), (0.3, "that no sequence of neighbouring elements connects")] {
        let errors = apart(gap);
        assert_eq!(errors.0.len(), 1, "{errors}");
        assert_eq!(errors.0[0].path, "bodies[0].mesh.elements[1]");
        assert!(errors.to_string().contains(hint), "{errors}");
    }
    // The same point within a rounding error.
    let errors = apart(1e-9);
    assert!(errors.to_string().contains("the point of node"), "{errors}");
}

/// A crack between elements that are connected elsewhere is a warning.
#[test]
fn cracks_are_warnings() {
    let cracks = |gap: f64| {
        // Both squares share the node 1 and their edge to a third square below.
        let nodes = format!("[{:?}, 1, 0], [0, -1, 0], [1, -1, 0], [2, -1, 0]", 1.0 + gap);
        let text = strip_with(&nodes, "[[0, 1, 4, 3], [1, 2, 5, 6], [7, 8, 1, 0], [8, 9, 2, 1]]");
        let warnings = Model::parse(&text).unwrap().diagnose().unwrap().warnings;
        warnings.iter().filter(|warning| warning.contains("crack")).count()
    };
    assert_eq!([cracks(1e-4), cracks(0.1)], [1, 0]);
}

/// Groups may have the names of the edges of thin shells.
#[test]
fn groups_have_any_names() {
    let load = "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"tip\"\nforce = [0, 0, 0.01]\n";
    let own = STRIP.to_owned() + load;
    let other = own.replace("root =", "u_start =").replace("edge = \"root\"", "edge = \"u_start\"");
    let other = other.replace("tip =", "v_end =").replace("edge = \"tip\"", "edge = \"v_end\"");
    assert_eq!(last(&own, "corner.z").to_bits(), last(&other, "corner.z").to_bits());
}

/// A mesh of triangles is a warning with their number; a few among quadrilaterals are not.
#[test]
fn many_triangles_are_a_warning() {
    let warnings = |text: &str| Model::parse(text).unwrap().diagnose().unwrap().warnings.join(" ");
    assert!(!warnings(STRIP).contains("triangles"));
    let divided = STRIP.replace("[1, 2, 5, 4]]", "[1, 2, 5], [1, 5, 4]]");
    assert!(warnings(&divided).contains("2 of 3 elements are triangles"), "{}", warnings(&divided));
}

/// A pull of σ h per length stretches the strip by σ/E, independent of how the load is stated.
#[test]
fn loads_of_edges_points_and_regions() {
    let free = STRIP
        .replace("condition = \"clamped\"", "condition = \"guided\"\naxes = [\"x\", \"z\"]")
        .replace("poisson = 0.3", "poisson = 0");
    let held = |load: &str| {
        free.clone()
            + "[[joints]]\nkind = \"support\"\nname = \"y\"\na = { body = \"s\", at = { node = 0 } }\n\
               condition = \"guided\"\naxes = [\"y\"]\n"
            + "[[joints]]\nkind = \"support\"\nname = \"tip\"\na = { body = \"s\", at = { edge = \"tip\" } }\n\
               condition = \"guided\"\naxes = [\"z\"]\n"
            + load
    };
    let edge = "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"tip\"\nforce = [0.12, 0, 0]\n";
    let point =
        "[[loads]]\nkind = \"force\"\non = { body = \"s\", at = [2, 0.5, 0] }\nforce = [0.12, 0, 0]\n";
    let region =
        "[[loads]]\nkind = \"surface_force\"\nbody = \"s\"\nregion = \"outer\"\nforce = [0.12, 0, 0]\n";
    for (load, stretch) in [(edge, 2e-6), (point, 2e-6), (region, 1.5e-6)] {
        assert_near("displacement", last(&held(load), "corner.x") - 2.0, stretch, 1e-5);
    }
}

/// The frame of a section follows the director at nodes and at inner points: a rigid body clamped there rotates with the strip.
#[test]
fn rigid_bodies_clamped_to_nodes_and_inner_points() {
    for at in ["{ node = 5 }", "[1.5, 0.5, 0]"] {
        let model = STRIP.replace("poisson = 0.3", "poisson = 0")
            + "[[bodies]]\nkind = \"rigid\"\nname = \"hub\"\ncenter = [1.5, 0.5, 0]\nmass = 1\ninertia = [1, 1, 1]\n"
            + &format!(
                "[[joints]]\nkind = \"clamp\"\nname = \"weld\"\na = {{ body = \"s\", at = {at} }}\n\
                 b = {{ body = \"hub\", at = \"center\" }}\n"
            )
            + "[[loads]]\nkind = \"moment\"\non = { body = \"hub\", at = \"center\" }\nmoment = [0, -1e-3, 0]\n"
            + "[[probes]]\nname = \"p\"\non = { body = \"hub\", at = \"center\" }\nrecord = [\"rotation\"]\n";
        let model = model.replace(
            "center = [1.5, 0.5, 0]",
            if at.contains("node") { "center = [2, 1, 0]" } else { "center = [1.5, 0.5, 0]" },
        );
        let angle = -2.0 * last(&model, "p.e2");
        let curvature = 1e-3 / (1.2e6 * 1e-3 / 12.0);
        if at.contains("node") {
            // Cylindrical bending M L/(E I) of the mean, and more near a single node.
            assert!(angle > 2.0 * curvature && angle < 4.0 * curvature, "{at}: {angle} of {curvature}");
        } else {
            // Half of the moment acts on the nodes at x = 1, the other half on those at x = 2.
            assert_near("rotation", angle, 1.25 * curvature, 1e-6);
        }
    }
}

/// A model with a mesh file is that with its lists; the text that is stored contains the mesh.
#[test]
fn mesh_files_are_read_with_the_model() {
    let folder = std::env::temp_dir().join(format!("ancf-mesh-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let mesh = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$PhysicalNames\n4\n0 1 \"corner\"\n1 2 \"root\"\n1 4 \"tip\"\n2 3 \"outer\"\n\
                $EndPhysicalNames\n$Nodes\n6\n1 0 0 0\n2 1000 0 0\n3 2000 0 0\n4 0 1000 0\n5 1000 1000 0\n6 2000 1000 0\n$EndNodes\n\
                $Elements\n5\n1 15 2 1 1 3\n2 1 2 2 1 1 4\n3 1 2 4 1 3 6\n4 3 2 0 1 1 2 5 4\n5 3 2 3 1 2 3 6 5\n$EndElements\n";
    std::fs::write(folder.join("strip.msh"), mesh).unwrap();
    let [start, end] = ["[bodies.mesh]\n", "\n[[joints]]"].map(|part| STRIP.find(part).unwrap());
    let load = "[[loads]]\nkind = \"surface_pressure\"\nbody = \"s\"\nregion = \"outer\"\npressure = 0.1\n";
    let with = |mesh: &str| format!("{}[bodies.mesh]\n{mesh}{}{load}", &STRIP[..start], &STRIP[end..]);
    let path = folder.join("strip.toml");
    std::fs::write(&path, with("file = \"strip.msh\"\nscale = 1e-3\n")).unwrap();
    let text = Model::read_text(&path).unwrap();
    assert_eq!(text.lines().count(), with("file = \"strip.msh\"\nscale = 1e-3\n").lines().count());
    let lists = STRIP.to_owned() + load;
    for column in ["corner.x", "corner.y", "corner.z"] {
        assert_near(column, last(&text, column), last(&lists, column), 1e-9);
    }
    let errors = |mesh: &str, file: &str| {
        std::fs::write(folder.join("strip.msh"), mesh).unwrap();
        std::fs::write(&path, with(&format!("file = \"{file}\"\n"))).unwrap();
        Model::read(&path).expect_err("a wrong mesh").to_string()
    };
    assert!(errors(mesh, "other.msh").contains("bodies[0].mesh.file"));
    assert!(errors("no mesh", "strip.msh").contains("$MeshFormat"));
    assert!(errors(&mesh.replace("4 3 2 0 1 1 2 5 4", "4 2 2 0 1 1 2 5"), "strip.msh").contains("triangle"));
    let unread = Model::parse(&with("file = \"strip.msh\"\n")).expect_err("no folder").to_string();
    assert!(unread.contains("bodies[0].mesh.file"), "{unread}");
    std::fs::remove_dir_all(&folder).unwrap();
}

/// Every kind of analysis runs, and the frequencies of a cantilever strip are near those of a beam.
#[test]
fn all_analyses_run() {
    let with = |analysis: &str| {
        STRIP.replace("poisson = 0.3", "poisson = 0").replace("[analysis]\nkind = \"statics\"\n", analysis)
            + "[[loads]]\nkind = \"edge_force\"\nbody = \"s\"\nedge = \"tip\"\nforce = [-0.1, 0, 0]\n"
    };
    let frequency = last(&with("[analysis]\nkind = \"modes\"\ncount = 1\n"), "frequency");
    let beam = 1.8751_f64.powi(2) / 4.0 * (1.2e6 * 0.01 / 12.0 / 1000.0_f64).sqrt() / std::f64::consts::TAU;
    assert!((frequency / beam - 1.0).abs() < 0.1, "{frequency} of {beam}");
    let factor = last(&with("[analysis]\nkind = \"buckling\"\ncount = 1\n"), "factor");
    // Euler's load (k/h)² E I with k = π/(2 n), of n = 2 elements with a linear rotation: (2 tan(k/2))² E I/h², h = 1.
    let discrete = (2.0 * (std::f64::consts::PI / 8.0).tan()).powi(2) * 1.2e6 * 1e-3 / 12.0 / 0.1;
    assert!((factor / discrete - 1.0).abs() < 0.01, "{factor} of {discrete}");
    for scheme in ["\"energy\"", "{ spectral_radius = 0.8 }", "\"average_acceleration\""] {
        let analysis =
            format!("[analysis]\nkind = \"dynamics\"\nduration = 0.1\nstep = 0.01\nscheme = {scheme}\n");
        assert!(last(&with(&analysis), "corner.x").is_finite(), "{scheme}");
    }
}
