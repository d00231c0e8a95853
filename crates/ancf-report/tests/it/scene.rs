//! Scenes contain the computed values.

use ancf::record::Series;
use ancf::{Model, Simulation};
use ancf_report::{BUDGET, Ending, Recording, scene};

use crate::common::{CANTILEVER, Run, Scene, apart, dot};

#[test]
fn fields_of_a_cantilever_are_those_of_statics() {
    let run = Run::of(CANTILEVER, 1);
    let scene = run.scene();
    let last = scene.frames() - 1;
    let centres = scene.centres("beam", last);
    let tip = centres[centres.len() - 1];
    let (fx, fy) = (5.0, -0.003);
    // Section forces satisfy equilibrium at nodes; between nodes they are interpolated.
    for k in scene.named("bodies", "beam")["nodes"]
        .as_array()
        .unwrap()
        .iter()
        .map(|k| k.as_u64().unwrap() as usize)
    {
        let x = &centres[k];
        // Equilibrium of the remaining part in the deformed state.
        let moment = (tip[0] - x[0]) * fy - (tip[1] - x[1]) * fx;
        let close = |name: &str, expected: f64, scale: f64| {
            let found = scene.field(name, "beam", last)[k];
            let allowed = 1e-4 * scale + scene.resolution(name);
            assert!((found - expected).abs() < allowed, "{name} at {k}: {found}, not {expected}");
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

/// Columns with estimated errors have bands.
#[test]
fn charts_have_the_estimated_errors_of_their_columns() {
    let text = "joints = [{ kind = \"clamp\", name = \"c\", a = { body = \"b\", at = \"start\" } }]\n\
        gravity = [0, -9.81, 0]\noutput.errors = true\nmaterials.m = { density = 1000, young = 1e9 }\n\
        sections.s = { kind = \"circle\", diameter = 0.02 }\n\
        bodies = [{ kind = \"cable\", name = \"b\", from = [0, 0, 0], to = [1, 0, 0], elements = 2, section = \"s\", \
        material = \"m\" }]\nprobes = [{ name = \"tip\", on = { body = \"b\", at = \"end\" } }]\n\
        analysis = { kind = \"dynamics\", duration = 0.1, step = 5e-3, scheme = { spectral_radius = 0.8 } }";
    let run = Run::of(text, 7);
    let scene = run.scene();
    let charts = scene.header["charts"].as_array().unwrap();
    let columns = charts.iter().flat_map(|chart| chart["columns"].as_array().unwrap());
    let column = columns.into_iter().find(|column| column["name"] == "tip.y").unwrap();
    let errors = scene.numbers(&column["errors"]);
    for (shown, error) in errors.iter().zip(run.column("tip.y_error")) {
        assert!((shown - error).abs() <= 1e-6 * error.abs(), "{shown} {error}");
    }
    assert!(errors.iter().any(|error| *error != 0.0));
}

#[test]
fn the_end_of_a_beam_is_where_its_probe_is() {
    let run = Run::of_file("models/cantilever.toml", 0.2, 7);
    let scene = run.scene();
    assert_eq!(scene.frames(), run.frames.len());
    assert_eq!(scene.header["analysis"], "dynamics");
    assert_eq!(scene.header["up"], serde_json::json!([0.0, 1.0, 0.0]), "opposite to gravity");
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

/// Bodies are coloured by their contributions to the error of the mesh.
#[test]
fn bodies_have_their_error_of_the_mesh() {
    let run = Run::of_file("models/tuning_fork.toml", 1.0, 1);
    let scene = run.scene();
    let bodies = &run.summary.errors.as_ref().unwrap().bodies;
    assert_eq!(bodies.len(), 4);
    for body in bodies {
        let field = scene.field("error of the mesh", &body.body, 0);
        let allowed = scene.resolution("error of the mesh");
        assert!(field.iter().all(|x| (x - body.error).abs() <= allowed), "{body:?}: {field:?}");
    }
    assert!(bodies.iter().any(|body| body.share > 0.5) && bodies.iter().any(|body| body.share < 0.1));
}

/// The drawn polygon of a stiff cable keeps its length.
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
            // A polygon is slightly shorter than its curve.
            assert!((drawn / rest - 1.0).abs() < 2.0 * most + 5e-3, "{drawn} of {rest}, strain {most}");
        }
    }
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
        assert!(found.has_message("to limit the file size"));
        let times = found.numbers(&found.header["frames"]["values"]);
        let all = run.column("t");
        assert_eq!((times[0], *times.last().unwrap()), (all[0], all[all.len() - 1]));
        let nodes = found.named("bodies", "beam")["nodes"].as_array().unwrap().len();
        assert_eq!(nodes, 21, "nodes stay");
    }
}

#[test]
fn units_have_names_if_they_are_known() {
    let run = Run::of(CANTILEVER, 1);
    assert_eq!(run.scene().named("fields", "torque")["unit"], "N m");
    let unnamed = Model { units: None, ..run.model.clone() };
    let unnamed = Recording { model: &unnamed, ..run.recording() };
    let found = Scene::read(&scene(&unnamed, BUDGET));
    assert!(found.header["units"].is_null());
    assert_eq!(found.named("fields", "torque")["unit"], "");
}

/// The scene of a beam in millimetres is that in metres times 1000.
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
fn numbers_that_are_none_are_left_out() {
    let mut run = Run::of_file("models/cantilever.toml", 0.02, 1);
    let count = run.frames.len();
    run.frames[3].state.q.fill(f64::NAN);
    run.frames[5].state.v.fill(f64::INFINITY);
    run.frames[6].state.lambda.fill(f64::NAN);
    let found = run.scene();
    assert_eq!(found.frames(), count - 1);
    assert!(found.has_message("not all positions are finite"));
    run.frames[0].state.q.pop();
    assert!(run.scene().has_message("1 frame omitted: states of another model"));
    let recording = Recording { ending: Ending::Failed("at t = 0.02".into()), ..run.recording() };
    let empty = Series::new();
    let found = Scene::read(&scene(&Recording { series: &empty, ..recording }, BUDGET));
    assert_eq!(found.header["outcome"]["message"], "at t = 0.02");
    assert!(found.header["charts"].as_array().unwrap().is_empty());
    assert!(Simulation::new(&run.model).is_ok());
}

/// The table of colour maps has all fields, with their signs.
#[test]
fn the_table_of_colour_maps_has_all_fields() {
    let text =
        std::fs::read_to_string(crate::common::file("crates/ancf-report/assets/colour_maps.json")).unwrap();
    let table: serde_json::Value = serde_json::from_str(&text).unwrap();
    let mut seen = 0;
    for (model, duration) in [("bow", 0.01), ("tuning_fork", 1.0), ("arc", 1.0)] {
        let scene = Run::of_file(&format!("models/{model}.toml"), duration, 1).scene();
        for field in scene.header["fields"].as_array().unwrap() {
            let sign = if field["diverging"].as_bool().unwrap() { "signed" } else { "one-signed" };
            assert_eq!(table["quantities"][field["name"].as_str().unwrap()], sign, "{}", field["name"]);
            seen += 1;
        }
    }
    assert!(seen >= 20, "{seen} fields");
    for map in [&table["sequential"], &table["diverging"]] {
        assert!(table["maps"][map.as_str().unwrap()].is_string());
    }
}
