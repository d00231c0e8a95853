//! Runs with their states, and a reader of scenes that implements the specification of the container independently.

use std::io;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};

use ancf::model::Units;
use ancf::record::{Series, Sink};
use ancf::solver::equations::State;
use ancf::{Model, Observer, Simulation, Summary};
use ancf_report::{BUDGET, Ending, Recording, Snapshot, scene};
use ancf_surface::BodySurfaces;
use serde_json::Value;

/// Cantilever of length 2 along x with an end force, in statics, E = 2e9, section 20 x 10 mm.
pub const CANTILEVER: &str = r#"
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

/// Path of a file of the repository.
pub fn file(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Stores all rows and every n-th state.
#[derive(Default)]
struct StateObserver {
    series: Series,
    frames: Vec<Snapshot>,
    every: usize,
    rows: usize,
}

impl Observer for StateObserver {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        Sink::begin(&mut self.series, columns)
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        if self.rows.is_multiple_of(self.every) {
            self.frames.push(Snapshot { value: row[0], state: state.clone() });
        }
        self.rows += 1;
        Sink::record(&mut self.series, row)
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Run with its rows and stored states.
pub struct Run {
    pub model: Model,
    pub text: String,
    pub simulation: Simulation,
    pub series: Series,
    pub frames: Vec<Snapshot>,
    pub summary: Summary,
    pub surfaces: BodySurfaces,
}

impl Run {
    pub fn of(text: &str, every: usize) -> Self {
        let mut model = Model::parse(text).unwrap_or_else(|errors| panic!("{errors}"));
        model.units = Some(metres());
        Self::of_model(model, text, every)
    }

    pub fn of_model(model: Model, text: &str, every: usize) -> Self {
        let simulation = Simulation::new(&model).unwrap_or_else(|errors| panic!("{errors}"));
        let mut keeper = StateObserver { every, ..StateObserver::default() };
        let summary = simulation.run(&mut keeper).expect("nothing is written");
        let StateObserver { series, frames, .. } = keeper;
        let surfaces = BodySurfaces::read(&model, Path::new("")).unwrap_or_else(|errors| panic!("{errors}"));
        Self { model, text: text.to_owned(), simulation, series, frames, summary, surfaces }
    }

    /// Runs a model file up to a maximum duration.
    pub fn of_file(path: &str, duration: f64, every: usize) -> Self {
        let text = std::fs::read_to_string(file(path)).unwrap();
        let mut model = Model::parse(&text).unwrap_or_else(|errors| panic!("{errors}"));
        model.units = Some(metres());
        if let Some(dynamics) = model.analysis.dynamics_mut() {
            dynamics.duration = dynamics.duration.min(duration);
        }
        Self::of_model(model, &text, every)
    }

    pub fn recording(&self) -> Recording<'_> {
        Recording {
            simulation: &self.simulation,
            model: &self.model,
            text: &self.text,
            title: self.model.title.as_deref().unwrap_or("a model"),
            frames: self.frames.clone(),
            series: &self.series,
            summary: vec![("steps".into(), self.summary.steps.to_string())],
            ending: Ending::new(&self.summary.outcome, &self.model.analysis),
            messages: Vec::new(),
            surfaces: &self.surfaces,
            body_errors: self.summary.body_errors().to_vec(),
            live: false,
        }
    }

    pub fn scene(&self) -> Scene {
        Scene::read(&scene(&self.recording(), BUDGET))
    }

    pub fn column(&self, name: &str) -> &[f64] {
        self.series.column(name).unwrap_or_else(|| panic!("no column {name}"))
    }
}

/// Cantilever with half of the height at its end.
pub fn tapered() -> String {
    CANTILEVER
        .replace(
            "[[bodies]]",
            "[sections.thin]\nkind = \"rectangle\"\nheight = 0.01\nwidth = 0.01\n[[bodies]]",
        )
        .replace("section = \"bar\"", "section = \"bar\"\nsection_end = \"thin\"")
        .replace("scales = { kind = \"auto\" }\n", "")
}

pub fn metres() -> Units {
    Units { length: "m".into(), time: "s".into(), force: "N".into() }
}

/// Scene read from a container.
pub struct Scene {
    pub header: Value,
    blob: Vec<u8>,
}

impl Scene {
    pub fn read(bytes: &[u8]) -> Self {
        let word = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!(&bytes[..4], b"ANCF");
        assert_eq!((word(4), word(12)), (1, 0));
        let end = 16 + word(8);
        assert_eq!(end % 8, 0, "the blob is aligned");
        let header = serde_json::from_slice(&bytes[16..end]).expect("a header in JSON");
        let scene = Self { header, blob: bytes[end..].to_vec() };
        scene.check(&scene.header);
        scene
    }

    /// Asserts that all arrays of the header are aligned and within the blob.
    fn check(&self, value: &Value) {
        match value {
            Value::Object(map) if map.contains_key("at") && map.contains_key("type") => {
                assert_eq!(map["at"].as_u64().unwrap() % 8, 0);
                assert_eq!(self.numbers(value).len(), map["count"].as_u64().unwrap() as usize);
            }
            Value::Object(map) => map.values().for_each(|value| self.check(value)),
            Value::Array(list) => list.iter().for_each(|value| self.check(value)),
            _ => {}
        }
    }

    /// Numbers of an array as stored.
    pub fn numbers(&self, array: &Value) -> Vec<f64> {
        let (at, count) = (array["at"].as_u64().unwrap() as usize, array["count"].as_u64().unwrap() as usize);
        let of = |width: usize| self.blob[at..at + count * width].chunks_exact(width);
        match array["type"].as_str().unwrap() {
            "f32" => of(4).map(|x| f64::from(f32::from_le_bytes(x.try_into().unwrap()))).collect(),
            "f64" => of(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect(),
            "i16" => of(2).map(|x| f64::from(i16::from_le_bytes(x.try_into().unwrap()))).collect(),
            "u32" => of(4).map(|x| f64::from(u32::from_le_bytes(x.try_into().unwrap()))).collect(),
            "u16" => of(2).map(|x| f64::from(u16::from_le_bytes(x.try_into().unwrap()))).collect(),
            other => panic!("unknown type of array: {other}"),
        }
    }

    pub fn frames(&self) -> usize {
        self.header["frames"]["count"].as_u64().unwrap() as usize
    }

    pub fn stations(&self) -> usize {
        self.header["stations"].as_u64().unwrap() as usize
    }

    /// Entry of a list by its name.
    pub fn named(&self, list: &str, name: &str) -> &Value {
        let entries = self.header[list].as_array().unwrap();
        entries.iter().find(|entry| entry["name"] == name).unwrap_or_else(|| panic!("no {name} in {list}"))
    }

    /// Centres of the stations of a body in a frame.
    pub fn centres(&self, body: &str, frame: usize) -> Vec<[f64; 3]> {
        let all = self.numbers(&self.header["centres"]);
        self.of_body(body, &all[frame * self.stations() * 3..], 3).map(three).collect()
    }

    pub fn reference(&self, body: &str) -> Vec<[f64; 3]> {
        let all = self.numbers(&self.header["reference"]["centres"]);
        self.of_body(body, &all, 3).map(three).collect()
    }

    /// Unit directors of the stations of a body in a frame.
    pub fn directors(&self, body: &str, frame: usize) -> Vec<[[f64; 3]; 3]> {
        let all: Vec<f64> =
            self.numbers(&self.header["directors"]).into_iter().map(|x| x / 32767.0).collect();
        let of = |x: &[f64]| [three(&x[..3]), three(&x[3..6]), three(&x[6..])];
        self.of_body(body, &all[frame * self.stations() * 9..], 9).map(of).collect()
    }

    /// Values of a field along a body in a frame; NaN where the field is not defined.
    pub fn field(&self, name: &str, body: &str, frame: usize) -> Vec<f64> {
        let field = self.named("fields", name);
        let [least, most] = [0, 1].map(|k| field["range"][k].as_f64().unwrap());
        let value = |x: f64| if x > 65534.0 { f64::NAN } else { least + x / 65534.0 * (most - least) };
        let all: Vec<f64> = self.numbers(&field["values"]).into_iter().map(value).collect();
        self.of_body(body, &all[frame * self.stations()..], 1).map(|x| x[0]).collect()
    }

    /// Resolution with which a field is stored.
    pub fn resolution(&self, name: &str) -> f64 {
        let range = &self.named("fields", name)["range"];
        (range[1].as_f64().unwrap() - range[0].as_f64().unwrap()) / 65534.0
    }

    fn of_body<'a>(&self, body: &str, all: &'a [f64], width: usize) -> std::slice::ChunksExact<'a, f64> {
        let body = self.named("bodies", body);
        let [first, count] = ["first", "count"].map(|key| body[key].as_u64().unwrap() as usize);
        all[first * width..(first + count) * width].chunks_exact(width)
    }

    /// Values of a column of a chart.
    pub fn column(&self, name: &str) -> Vec<f64> {
        let charts = self.header["charts"].as_array().unwrap();
        let columns = charts.iter().flat_map(|chart| chart["columns"].as_array().unwrap());
        let found = columns.into_iter().find(|column| column["name"] == name);
        self.numbers(&found.unwrap_or_else(|| panic!("no column {name}"))["values"])
    }

    pub fn has_message(&self, part: &str) -> bool {
        let messages = self.header["messages"].as_array().unwrap();
        messages.iter().any(|message| message.as_str().unwrap().contains(part))
    }
}

pub fn three(x: &[f64]) -> [f64; 3] {
    [x[0], x[1], x[2]]
}

pub fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

pub fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    let d: [f64; 3] = std::array::from_fn(|k| a[k] - b[k]);
    dot(d, d).sqrt()
}
