//! Shapes of a model without a run: outlines, boxes and arms, and positions of symbols.

use ancf::model::{Body, Rectangle, Rigid, Section, Tube};
use ancf::{Model, Simulation};
use ancf_report::geometry::{InertiaBox, SymbolKind, arms, inertia_box, outline, outline_at, symbols};

use crate::common::{Run, apart, dot, tapered};

fn area(points: &[[f64; 4]]) -> f64 {
    let pairs = (0..points.len()).map(|k| (points[k], points[(k + 1) % points.len()]));
    pairs.map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0])).sum()
}

#[test]
fn a_round_outline_has_the_requested_sides() {
    let tube = outline(&Section::from(Tube { outer: 0.1, inner: 0.08 }), 100);
    let inner = tube.inner.as_ref().expect("a bore");
    assert_eq!((tube.outer.len(), inner.len(), tube.edges().len()), (100, 100, 100));
    let polygon = (std::f64::consts::TAU / 100.0).sin() / (std::f64::consts::TAU / 100.0);
    let expected = polygon * std::f64::consts::PI * (0.05_f64.powi(2) - 0.04_f64.powi(2));
    assert!(((area(&tube.outer) - area(inner)) / expected - 1.0).abs() < 1e-12);
    assert_eq!(tube.edges()[99], [99, 0]);
    let rectangle = outline(&Section::from(Rectangle { height: 0.02, width: 0.01 }), 100);
    assert_eq!(rectangle.edges(), [[0, 1], [2, 3], [4, 5], [6, 7]]);
    assert!(rectangle.edges().iter().all(|[i, j]| rectangle.outer[*i][2..] == rectangle.outer[*j][2..]));
    assert_eq!(outline(&Section::circle(1.0), 0).outer.len(), 3);
}

/// An ellipse with the second moments of a general section has its radii of gyration.
#[test]
fn a_general_section_is_drawn_with_its_radii_of_gyration() {
    let (iy, iz) = (1e-6, 4e-6);
    let text = format!("kind = \"general\"\narea = 1e-3\niy = {iy}\niz = {iz}");
    let section: Section = toml::from_str(&text).unwrap();
    let [a, b] = outline(&section, 24).half_extents;
    assert!((0.25 * a * a - iz / 1e-3).abs() < 1e-12 && (0.25 * b * b - iy / 1e-3).abs() < 1e-12);
}

#[test]
fn a_tapered_beam_has_an_outline_at_each_fraction() {
    let model = Model::parse(&tapered()).unwrap();
    let half = |fraction| outline_at(&model, &model.bodies[0], fraction, 24).expect("a section").half_extents;
    for (fraction, height) in [(0.0, 0.02), (0.5, 0.015), (1.0, 0.01)] {
        let [y, z] = half(fraction);
        assert!((y - 0.5 * height).abs() < 1e-15 && (z - 0.005).abs() < 1e-15);
    }
}

/// The box of a body with products of inertia has the same tensor of inertia.
#[test]
fn a_box_has_the_inertia_of_its_body() {
    let text = r#"
        bodies = [{ kind = "rigid", name = "brick", center = [0, 0, 0], mass = 2,
                    inertia = [0.3, 0.4, 0.5], products = [0.02, -0.01, 0.03] }]
        analysis = { kind = "dynamics", duration = 1, step = 0.1 }
    "#;
    let model = Model::parse(text).unwrap();
    let Body::Rigid(rigid) = &model.bodies[0] else { panic!("a rigid body") };
    let InertiaBox { edges: [a, b, c], axes } = inertia_box(rigid, f64::INFINITY);
    let moments = [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| 2.0 * x / 12.0);
    for i in 0..3 {
        for j in 0..3 {
            let entry: f64 = (0..3).map(|k| moments[k] * axes[k][i] * axes[k][j]).sum();
            assert!((entry - rigid.tensor()[(i, j)]).abs() < 1e-12, "{entry}");
            assert!((dot(axes[i], axes[j]) - f64::from(u8::from(i == j))).abs() < 1e-12);
        }
    }
    let longest = |drawn: InertiaBox| drawn.edges.into_iter().fold(0.0, f64::max);
    assert!((longest(inertia_box(rigid, 0.01)) - 0.01).abs() < 1e-15);
    let without = Rigid { inertia: [0.0; 3], products: [0.0; 3], ..rigid.clone() };
    assert_eq!(inertia_box(&without, 0.5).edges, [0.5; 3]);
}

/// Ends at points and with offsets have arms, ends at the centre and on other bodies have none.
#[test]
fn arms_go_to_the_joints_of_a_rigid_body() {
    let text = r#"
        bodies = [
            { kind = "rigid", name = "crank", center = [1, 0, 0], mass = 1, inertia = [1, 1, 1] },
            { kind = "rigid", name = "rod", center = [3, 0, 0], mass = 1, inertia = [1, 1, 1] },
        ]
        joints = [
            { kind = "revolute", name = "axle", a = { body = "crank", at = [0, 0, 0] }, axis = [0, 0, 1] },
            { kind = "spherical", name = "pin", a = { body = "rod", at = [2, 0, 0] }, b = { body = "crank", at = "center", offset = [1, 0, 0] } },
            { kind = "spring", name = "spring", a = { body = "rod", at = "center" }, b = { point = [5, 0, 0] }, stiffness = 1 },
        ]
        analysis = { kind = "dynamics", duration = 1, step = 0.1 }
    "#;
    let model = Model::parse(text).unwrap_or_else(|errors| panic!("{errors}"));
    let found = |body: &str| -> Vec<(String, [f64; 3])> {
        arms(&model, body).into_iter().map(|arm| (arm.joint, arm.offset)).collect()
    };
    assert_eq!(found("crank"), [("axle".into(), [-1.0, 0.0, 0.0]), ("pin".into(), [1.0, 0.0, 0.0])]);
    assert_eq!(found("rod"), [("pin".into(), [-1.0, 0.0, 0.0])]);
    assert!(found("nothing").is_empty());
    let scene = Run::of(text, 1).scene();
    let links = scene.header["links"].as_array().unwrap();
    let drawn = links.iter().filter(|link| link["kind"] == "arm").count();
    assert_eq!(drawn, 3, "the scene has the same arms");
}

#[test]
fn symbols_are_where_joints_and_probes_are() {
    let run = Run::of_file("models/cantilever.toml", 0.1, 5);
    let symbols = symbols(&run.model, &run.simulation);
    let of = |kind| symbols.all.iter().filter(move |symbol| symbol.kind == kind);
    assert_eq!(of(SymbolKind::Joint).map(|symbol| symbol.name.as_str()).collect::<Vec<_>>(), ["root"]);
    assert_eq!(symbols.of_joints, [Some(0)]);
    let tip = of(SymbolKind::Probe).next().expect("a probe");
    for (row, frame) in run.frames.iter().enumerate() {
        let probe = ["x", "y", "z"].map(|axis| run.column(&format!("tip.{axis}"))[5 * row]);
        assert!(apart(tip.position(&frame.state), probe) < 1e-12);
    }
    let rest = Simulation::new(&run.model).unwrap().assembly().rest();
    assert_eq!(tip.reference(), tip.position(&rest));
}
