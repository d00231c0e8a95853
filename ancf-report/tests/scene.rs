//! What is drawn is what was computed.

mod common;

use std::f64::consts::PI;

use ancf::Simulation;
use ancf::record::Series;
use ancf::scales::Dimension;
use ancf_report::{BUDGET, Ending, Recording, scene};
use common::{Run, Scene, apart, dot, metres, three};

/// A cantilever of length 2 along x under F = −3 N along y at its end, in statics, E = 2e9, 20 x 10 mm.
const CANTILEVER: &str = r#"
materials.steel = { density = 1000, young = 2e9 }
sections.bar = { kind = "rectangle", height = 0.02, width = 0.01 }
scales = { kind = "auto" }
[[bodies]]
kind = "beam"
name = "beam"
from = [0, 0, 0]
to = [2, 0, 0]
elements = 8
formulation = "linked"
section = "bar"
material = "steel"
[[joints]]
kind = "clamp"
name = "root"
a = { body = "beam", at = "start" }
[[loads]]
kind = "force"
on = { body = "beam", at = "end" }
force = [5, -0.003, 0]
[[probes]]
name = "tip"
on = { body = "beam", at = "end" }
[analysis]
kind = "statics"
"#;

#[test]
fn fields_of_a_cantilever_are_those_of_statics() {
    let run = Run::of(CANTILEVER, 1);
    let scene = run.scene();
    let last = scene.frames() - 1;
    let centres = scene.centres("beam", last);
    let tip = centres[centres.len() - 1];
    let (fx, fy) = (5.0, -0.003);
    // Between nodes they are interpolated: at nodes they are those of equilibrium.
    for k in scene.named("bodies", "beam")["nodes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|k| k.as_u64().unwrap() as usize)
    {
        let x = &centres[k];
        // Equilibrium of the part beyond, in the deformed state.
        let moment = (tip[0] - x[0]) * fy - (tip[1] - x[1]) * fx;
        let close = |name: &str, wanted: f64, scale: f64| {
            let found = scene.field(name, "beam", last)[k];
            let allowed = 1e-4 * scale + scene.resolution(name);
            assert!((found - wanted).abs() < allowed, "{name} at {k}: {found}, not {wanted}");
        };
        close("axial force", fx, fx);
        close("bending moment", moment.abs(), 0.006);
        close("bending moment z", moment, 0.006);
        close("bending moment y", 0.0, 0.006);
        close("torque", 0.0, 0.006);
        // N/A + 6 |M| / (b h²)
        let stress = fx / 2e-4 + 6.0 * moment.abs() / (0.01 * 0.02 * 0.02);
        close("axial stress", stress, stress);
        close("strain", fx / 2e-4 / 2e9, 2.0 * fx / 2e-4 / 2e9);
        close("displacement", apart(*x, scene.reference("beam")[k]), 1e-3);
    }
    assert_eq!(scene.named("fields", "axial stress")["unit"], "N/m²");
    let titles: Vec<_> =
        scene.header["charts"].as_array().unwrap().iter().map(|c| c["title"].as_str().unwrap()).collect();
    assert!(titles.contains(&"tip: position") && !titles.contains(&"tip: velocity"), "{titles:?}");
}

#[test]
fn the_end_of_a_beam_is_where_its_probe_is() {
    let run = Run::of_file("models/cantilever.toml", 0.2, 7);
    let scene = run.scene();
    assert_eq!(scene.frames(), run.frames.len());
    assert_eq!(scene.header["analysis"], "dynamics");
    assert_eq!(scene.header["up"], serde_json::json!([0.0, 1.0, 0.0]), "against gravity");
    let rows = run.column("t");
    for (frame, time) in scene.numbers(&scene.header["frames"]["values"]).into_iter().enumerate() {
        let row = rows.iter().position(|t| *t == time).expect("a frame is a row");
        let end = *scene.centres("beam", frame).last().unwrap();
        let marker = scene.numbers(&scene.named("markers", "tip")["at"]);
        for (k, axis) in ["x", "y", "z"].into_iter().enumerate() {
            let probe = run.column(&format!("tip.{axis}"))[row];
            assert!((end[k] - probe).abs() < 1e-6, "{end:?}");
            assert!((marker[3 * frame + k] - probe).abs() < 1e-6);
            let reaction = &scene.header["reactions"][0];
            for (of, letter) in [("force", "f"), ("moment", "m")] {
                let column = run.column(&format!("root.{letter}{axis}"))[row];
                let arrow = scene.numbers(&reaction[of])[3 * frame + k];
                assert!((arrow - column).abs() <= 1e-6 * column.abs() + 1e-30, "{of}: {arrow}, not {column}");
            }
        }
        let speed = *scene.field("speed", "beam", frame).last().unwrap();
        let v = ["vx", "vy", "vz"].map(|axis| run.column(&format!("tip.{axis}"))[row]);
        assert!((speed - dot(v, v).sqrt()).abs() < 1e-5 + scene.resolution("speed"));
    }
    let marker = scene.header["reactions"][0]["marker"].as_u64().unwrap() as usize;
    assert_eq!(scene.header["markers"][marker]["name"], "root");
    assert_eq!(scene.header["markers"][marker]["detail"], "clamp");
}

/// A chain of nodes of a stiff cable keeps its length however it swings, and so do pieces of it.
#[test]
fn a_stiff_cable_is_drawn_with_its_length() {
    let run = Run::of_file("models/rope.toml", 0.5, 20);
    let scene = run.scene();
    for body in run.model.bodies.iter().filter(|body| body.is_flexible()) {
        let length = |points: &[[f64; 3]]| points.windows(2).map(|pair| apart(pair[0], pair[1])).sum::<f64>();
        let rest = length(&scene.reference(body.name()));
        for frame in 0..scene.frames() {
            let strain = scene.field("strain", body.name(), frame);
            let most = strain.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
            let drawn = length(&scene.centres(body.name(), frame));
            // A polygon is a little shorter than its curve.
            assert!((drawn / rest - 1.0).abs() < 2.0 * most + 5e-3, "{drawn} of {rest}, strain {most}");
        }
    }
}

#[test]
fn modes_are_displaced_by_a_tenth_of_the_size() {
    let run = Run::of_file("models/tuning_fork.toml", 1.0, 1);
    let scene = run.scene();
    assert!(scene.frames() >= 2);
    assert_eq!(scene.frames(), run.column("mode").len());
    let size = scene.header["size"].as_f64().unwrap();
    for frame in 0..scene.frames() {
        let moved = run.model.bodies.iter().flat_map(|body| {
            let at = scene.centres(body.name(), frame);
            at.into_iter().zip(scene.reference(body.name())).map(|(x, y)| apart(x, y)).collect::<Vec<_>>()
        });
        let most = moved.fold(0.0, f64::max);
        assert!((most / size - 0.1).abs() < 2e-3, "mode {frame}: {most} of {size}");
    }
    let labels = scene.header["frames"]["labels"].as_array().unwrap();
    assert!(labels[0].as_str().unwrap().starts_with("mode 1: "));
    assert!(labels[0].as_str().unwrap().ends_with(" Hz"));
    assert!(scene.header["reactions"].as_array().unwrap().is_empty());
}

/// The first forms of a beam on two equal supports are symmetric and antisymmetric about its middle.
#[test]
fn shapes_of_a_symmetric_beam_are_symmetric() {
    let text = CANTILEVER
        .replace("kind = \"statics\"", "kind = \"modes\"\ncount = 4\nabout = \"reference\"")
        .replace(
            "[[loads]]\nkind = \"force\"\non = { body = \"beam\", at = \"end\" }\nforce = [5, -0.003, 0]",
            "",
        )
        + "[[joints]]\nkind = \"clamp\"\nname = \"other\"\na = { body = \"beam\", at = \"end\" }\n";
    // Keys of the analysis come before other tables.
    let scene = Run::of(&text, 1).scene();
    let size = scene.header["size"].as_f64().unwrap();
    for frame in 0..4 {
        let (at, rest) = (scene.centres("beam", frame), scene.reference("beam"));
        let moved: Vec<[f64; 3]> =
            at.iter().zip(&rest).map(|(x, y)| std::array::from_fn(|k| x[k] - y[k])).collect();
        let count = moved.len();
        for axis in [1, 2] {
            let mirrored = |sign: f64| {
                (0..count).all(|k| (moved[k][axis] - sign * moved[count - 1 - k][axis]).abs() < 1e-4 * size)
            };
            assert!(mirrored(1.0) || mirrored(-1.0), "mode {frame}: {moved:?}");
        }
    }
}

/// A shaft that only twists: its sections are seen to turn, by less than a radian, and its axis stays.
#[test]
fn a_mode_of_torsion_turns_sections() {
    let text = CANTILEVER
        .replace("kind = \"statics\"", "kind = \"modes\"\ncount = 12\nabout = \"reference\"")
        .replace(
            "sections.bar = { kind = \"rectangle\", height = 0.02, width = 0.01 }",
            "sections.bar = { kind = \"circle\", diameter = 0.1 }",
        )
        .replace("elements = 8", "elements = 16");
    let scene = Run::of(&text, 1).scene();
    let twists = (0..scene.frames()).filter(|&frame| {
        let still = scene
            .centres("beam", frame)
            .iter()
            .zip(scene.reference("beam"))
            .all(|(x, y)| apart(*x, y) < 1e-3);
        let [_, y, _] = *scene.directors("beam", frame).last().unwrap();
        let turned = y[1].clamp(-1.0, 1.0).acos();
        still && turned > 0.1 && turned < 1.0
    });
    assert!(twists.count() >= 1);
}

#[test]
fn forms_of_buckling_are_drawn_about_the_straight_column() {
    let run = Run::of_file("models/column.toml", 1.0, 1);
    let scene = run.scene();
    assert_eq!(scene.header["analysis"], "buckling");
    let factor = run.column("factor")[0];
    let label = scene.header["frames"]["labels"][0].as_str().unwrap();
    let shown: f64 = label.rsplit(' ').next().unwrap().parse().unwrap();
    assert!((shown / factor - 1.0).abs() < 1e-3, "{label}");
}

#[test]
fn charts_of_a_path_go_along_it() {
    let run = Run::of_file("models/lees_frame.toml", 1.0, 1);
    let scene = run.scene();
    assert_eq!(scene.header["abscissa"]["name"], "length");
    let (places, frames) = (
        scene.numbers(&scene.header["abscissa"]["values"]),
        scene.numbers(&scene.header["frames"]["values"]),
    );
    assert_eq!(places, frames, "every row is a frame");
    assert!(!run.column("load").is_sorted(), "the load falls beyond the limit point");
    let loads = scene.column("load");
    assert!(loads.iter().zip(run.column("load")).all(|(x, y)| (x - y).abs() < 1e-6 * y.abs().max(1.0)));
}

#[test]
fn long_charts_keep_their_extremes() {
    let run = Run::of_file("models/cantilever.toml", 6.0, 100);
    let model = {
        let mut model = run.model.clone();
        model.analysis.dynamics_mut().unwrap().step = ancf::model::Step::Fixed(2e-4);
        model
    };
    let run = Run::of_model(model, &run.text, 500);
    let rows = run.column("t").len();
    assert!(rows > 9000);
    let scene = run.scene();
    let shown = scene.numbers(&scene.header["abscissa"]["values"]);
    assert!(shown.len() < 4200 && shown.len() > 1000, "{}", shown.len());
    assert_eq!((shown[0], *shown.last().unwrap()), (0.0, run.column("t")[rows - 1]));
    for name in ["tip.y", "tip.vy", "tip.ay", "root.fy", "root.mz", "kinetic", "balance"] {
        let ends = |x: &[f64]| {
            [x.iter().copied().fold(f64::MAX, f64::min), x.iter().copied().fold(f64::MIN, f64::max)]
        };
        let (all, kept) = (ends(run.column(name)), ends(&scene.column(name)));
        for k in 0..2 {
            assert!((all[k] - kept[k]).abs() <= 1e-6 * all[k].abs(), "{name}: {kept:?}, not {all:?}");
        }
    }
}

#[test]
fn a_budget_is_kept_and_what_is_left_out_is_said() {
    let run = Run::of_file("models/cantilever.toml", 0.5, 1);
    let whole = scene(&run.recording(), BUDGET);
    let size = |bytes: &[u8]| bytes.len();
    let mut last = size(&whole);
    for budget in [1_000_000, 300_000, 100_000] {
        let bytes = scene(&run.recording(), budget);
        assert!(size(&bytes) < budget + 20_000, "{} of {budget}", size(&bytes));
        assert!(size(&bytes) < last);
        last = size(&bytes);
        let found = Scene::read(&bytes);
        assert!(found.has_message("to keep the file small"));
        let times = found.numbers(&found.header["frames"]["values"]);
        let all = run.column("t");
        assert_eq!((times[0], *times.last().unwrap()), (all[0], all[all.len() - 1]));
        let nodes = found.named("bodies", "beam")["nodes"].as_array().unwrap().len();
        assert_eq!(nodes, 21, "nodes stay");
    }
}

#[test]
fn units_have_names_if_they_are_known() {
    let units = metres();
    let cases = [
        (Dimension::NUMBER, ""),
        (Dimension::LENGTH, "m"),
        (Dimension::ENERGY, "N m"),
        (Dimension::ACCELERATION, "m/s²"),
        (Dimension::RATE, "1/s"),
        (Dimension::STRESS, "N/m²"),
        (Dimension::DENSITY, "N s²/m⁴"),
        (Dimension::new(-1, -1, 1), "N/(m s)"),
        (Dimension::new(12, 0, 0), "m¹²"),
    ];
    for (dimension, wanted) in cases {
        assert_eq!(units.of(dimension), wanted);
    }
    let run = Run::of(CANTILEVER, 1);
    let unnamed = Recording { units: None, ..run.recording() };
    let found = Scene::read(&scene(&unnamed, BUDGET));
    assert!(found.header["units"].is_null());
    assert_eq!(found.named("fields", "torque")["unit"], "");
}

/// The same beam in millimetres gives the same picture in other numbers.
#[test]
fn scenes_are_in_the_units_of_the_user() {
    let metre = Run::of(CANTILEVER, 1);
    let text =
        toml::to_string(&metre.model.scaled(&ancf::Scales { length: 1e-3, time: 1.0, force: 1.0 })).unwrap();
    let millimetre = Run::of(&text, 1);
    let (a, b) = (metre.scene(), millimetre.scene());
    let end = |scene: &Scene| *scene.centres("beam", scene.frames() - 1).last().unwrap();
    let (a_end, b_end) = (end(&a), end(&b));
    for k in 0..3 {
        assert!((1e3 * a_end[k] - b_end[k]).abs() < 1e-3, "{a_end:?} {b_end:?}");
    }
    let root = |scene: &Scene| scene.field("bending moment", "beam", scene.frames() - 1)[0];
    assert!((1e3 * root(&a) / root(&b) - 1.0).abs() < 1e-3);
}

#[test]
fn outlines_go_about_the_axis_and_their_normals_point_outwards() {
    let kinds = [
        r#"kind = "circle", diameter = 0.1"#,
        r#"kind = "tube", outer = 0.1, inner = 0.08"#,
        r#"kind = "rectangle", height = 0.1, width = 0.05"#,
        r#"kind = "ellipse", height = 0.1, width = 0.05"#,
        r#"kind = "general", area = 0.01, iy = 1e-6, iz = 4e-6"#,
    ];
    for kind in kinds {
        let text = CANTILEVER.replace("kind = \"rectangle\", height = 0.02, width = 0.01", kind);
        let scene = Run::of(&text, 1).scene();
        let body = scene.named("bodies", "beam");
        let points =
            |key: &str| -> Vec<Vec<f64>> { serde_json::from_value(body[key].clone()).unwrap_or_default() };
        let (outer, inner) = (points("outline"), points("inner"));
        let area = |points: &[Vec<f64>]| -> f64 {
            (0..points.len())
                .map(|k| (&points[k], &points[(k + 1) % points.len()]))
                .map(|(p, q)| 0.5 * (p[0] * q[1] - p[1] * q[0]))
                .sum()
        };
        assert!(area(&outer) > 0.0, "counter-clockwise");
        for p in &outer {
            assert!(p[0] * p[2] + p[1] * p[3] > 0.0, "outwards");
            assert!((p[2].hypot(p[3]) - 1.0).abs() < 1e-12);
        }
        assert!(inner.iter().all(|p| p[0] * p[2] + p[1] * p[3] > 0.0), "away from the axis");
        assert_eq!(inner.is_empty(), !kind.contains("tube"));
        // A polygon of 24 sides has 0.9886 of the area of its circle.
        let wanted = match kind {
            _ if kind.contains("circle") || kind.contains("tube") => PI * 0.0025,
            _ if kind.contains("rectangle") => 0.005,
            _ if kind.contains("ellipse") => PI * 0.05 * 0.025,
            _ => 4.0 * PI * (1e-4_f64 * 4e-4).sqrt(),
        };
        assert!((area(&outer) / wanted - 1.0).abs() < 0.012, "{kind}");
    }
}

#[test]
fn tapers_have_scales() {
    let text = CANTILEVER
        .replace(
            "[[bodies]]",
            "[sections.thin]\nkind = \"rectangle\"\nheight = 0.01\nwidth = 0.01\n[[bodies]]",
        )
        .replace("section = \"bar\"", "section = \"bar\"\nsection_end = \"thin\"")
        .replace("scales = { kind = \"auto\" }\n", "");
    let scene = Run::of(&text, 1).scene();
    let scale = scene.numbers(&scene.named("bodies", "beam")["scale"]);
    let count = scale.len() / 2;
    for k in 0..count {
        let part = k as f64 / (count - 1) as f64;
        assert!((scale[2 * k] - (1.0 - 0.5 * part)).abs() < 1e-6);
        assert!((scale[2 * k + 1] - 1.0).abs() < 1e-6);
    }
}

/// The box of a rigid brick that is no larger than what is shown is the brick.
#[test]
fn rigid_bodies_are_boxes_of_their_inertia() {
    let (m, a, b, c) = (2.0, 0.3_f64, 0.2_f64, 0.1_f64);
    let inertia = [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| m * x / 12.0);
    let text = format!(
        "[[bodies]]\nkind = \"rigid\"\nname = \"brick\"\ncenter = [0, 0, 0]\nmass = {m}\ninertia = {inertia:?}\n\
         motion = {{ spin = [0, 0, 1] }}\n\
         [[bodies]]\nkind = \"mass\"\nname = \"far\"\ncenter = [10, 0, 0]\nmass = 1\n\
         [analysis]\nkind = \"dynamics\"\nduration = 0.5\nstep = 1e-2\n"
    );
    let run = Run::of(&text, 1);
    let scene = run.scene();
    let half: [f64; 3] = serde_json::from_value(scene.named("bodies", "brick")["box"].clone()).unwrap();
    for (half, edge) in half.iter().zip([a, b, c]) {
        assert!((2.0 * half / edge - 1.0).abs() < 1e-9, "{half:?}");
    }
    // It turns by half a radian.
    let [x, ..] = scene.directors("brick", scene.frames() - 1)[0];
    assert!((x[1].atan2(x[0]) - 0.5).abs() < 2e-3, "{x:?}");
    assert_eq!(scene.named("bodies", "far")["kind"], "point");
}

#[test]
fn rods_end_where_their_lengths_say() {
    let run = Run::of_file("ancf/tests/models/good/joints.toml", 0.2, 2);
    let scene = run.scene();
    let wanted = [("distance", "rod"), ("bushing", "bushing"), ("spring", "spring")];
    let mut checked = 0;
    for joint in &run.model.joints {
        let marker = scene.named("markers", joint.name());
        let kinds = wanted.iter().filter(|(detail, _)| marker["detail"] == *detail);
        for (_, kind) in kinds {
            let links = scene.header["links"].as_array().unwrap();
            let link = links.iter().find(|link| link["name"] == joint.name()).expect("a link");
            let rope = kind == &"spring" && ["rope", "damper"].iter().any(|other| link["kind"] == *other);
            assert!(link["kind"] == *kind || rope);
            let ends = scene.numbers(&link["ends"]);
            let at = scene.numbers(&marker["at"]);
            for frame in 0..scene.frames() {
                let end = three(&ends[6 * frame..]);
                assert!(apart(end, three(&at[3 * frame..])) < 1e-6, "the mark is at end a");
                let Some(lengths) = run.series.column(&format!("{}.length", joint.name())) else { continue };
                let drawn = apart(end, three(&ends[6 * frame + 3..]));
                assert!((drawn - lengths[2 * frame]).abs() < 1e-5, "{drawn}");
                checked += 1;
            }
        }
    }
    assert!(checked >= 2, "{checked}");
}

/// An obstacle on a body goes where the body goes.
#[test]
fn obstacles_follow_what_carries_them() {
    let run = Run::of_file("models/belt.toml", 0.2, 20);
    let scene = run.scene();
    let wheel = &scene.header["obstacles"][0];
    assert_eq!(wheel["kind"], "cylinder");
    let poses = scene.numbers(&wheel["pose"]);
    assert_eq!(poses.len(), 12 * scene.frames());
    let carrier = scene.centres("pulley", 0);
    for pose in poses.chunks_exact(12) {
        assert!((dot(three(&pose[3..6]), three(&pose[3..6])) - 1.0).abs() < 1e-6);
        assert!(apart(three(&pose[..3]), carrier[0]) < 0.05);
    }
    // It turns with the pulley.
    assert!(apart(three(&poses[6..9]), three(&poses[poses.len() - 6..poses.len() - 3])) > 1e-2);
}

#[test]
fn numbers_that_are_none_are_left_out() {
    let mut run = Run::of_file("models/cantilever.toml", 0.02, 1);
    let count = run.frames.len();
    run.frames[3].state.q.fill(f64::NAN);
    run.frames[5].state.v.fill(f64::INFINITY);
    run.frames[6].state.lambda.fill(f64::NAN);
    let found = run.scene();
    assert_eq!(found.frames(), count - 1);
    assert!(found.has_message("not all positions are numbers"));
    run.frames[0].state.q.pop();
    assert!(run.scene().has_message("1 frame left out: of another model"));
    let recording = Recording { ending: Ending::Failed("at t = 0.02".into()), ..run.recording() };
    let empty = Series::new();
    let found = Scene::read(&scene(&Recording { series: &empty, ..recording }, BUDGET));
    assert_eq!(found.header["outcome"]["message"], "at t = 0.02");
    assert!(found.header["charts"].as_array().unwrap().is_empty());
    assert!(Simulation::new(&run.model).is_ok());
}
