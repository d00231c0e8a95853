//! Runs that keep their states, and a reader of scenes that knows the container from its description alone.

use std::io;
use std::ops::ControlFlow;
use std::path::PathBuf;

use ancf::model::Units;
use ancf::record::{Series, Sink};
use ancf::system::State;
use ancf::{Model, Observer, Simulation, Summary};
use ancf_report::{BUDGET, Ending, Recording, Snapshot, scene};
use serde_json::Value;

/// A cantilever of length 2 along x under F = −3 N along y at its end, in statics, E = 2e9, 20 x 10 mm.
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

/// A file of the repository.
pub fn file(path: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// Keeps every row and every so many states.
#[derive(Default)]
struct Keeper {
    series: Series,
    frames: Vec<Snapshot>,
    every: usize,
    rows: usize,
}

impl Observer for Keeper {
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

/// A run and all that was kept of it.
pub struct Run {
    pub model: Model,
    pub text: String,
    pub simulation: Simulation,
    pub series: Series,
    pub frames: Vec<Snapshot>,
    pub summary: Summary,
}

impl Run {
    pub fn of(text: &str, every: usize) -> Self {
        let mut model = Model::parse(text).unwrap_or_else(|errors| panic!("{errors}"));
        model.units = Some(metres());
        Self::of_model(model, text, every)
    }

    pub fn of_model(model: Model, text: &str, every: usize) -> Self {
        let simulation = Simulation::new(&model).unwrap_or_else(|errors| panic!("{errors}"));
        let mut keeper = Keeper { every, ..Keeper::default() };
        let summary = simulation.run(&mut keeper).expect("nothing is written");
        let Keeper { series, frames, .. } = keeper;
        Self { model, text: text.to_owned(), simulation, series, frames, summary }
    }

    /// A model file, shortened to so much of its duration.
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

/// The cantilever with half the height at its end.
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

/// A container that was read back.
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

    /// Every array of the header is aligned and within the blob.
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

    /// The numbers of an array as they are stored.
    pub fn numbers(&self, array: &Value) -> Vec<f64> {
        let (at, count) = (array["at"].as_u64().unwrap() as usize, array["count"].as_u64().unwrap() as usize);
        let of = |width: usize| self.blob[at..at + count * width].chunks_exact(width);
        match array["type"].as_str().unwrap() {
            "f32" => of(4).map(|x| f64::from(f32::from_le_bytes(x.try_into().unwrap()))).collect(),
            "f64" => of(8).map(|x| f64::from_le_bytes(x.try_into().unwrap())).collect(),
            "i16" => of(2).map(|x| f64::from(i16::from_le_bytes(x.try_into().unwrap()))).collect(),
            "u16" => of(2).map(|x| f64::from(u16::from_le_bytes(x.try_into().unwrap()))).collect(),
            other => panic!("no type of arrays: {other}"),
        }
    }

    pub fn frames(&self) -> usize {
        self.header["frames"]["count"].as_u64().unwrap() as usize
    }

    pub fn stations(&self) -> usize {
        self.header["stations"].as_u64().unwrap() as usize
    }

    /// The entry of a list with a name.
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

    /// Directors of the stations of a body in a frame, of length 1.
    pub fn directors(&self, body: &str, frame: usize) -> Vec<[[f64; 3]; 3]> {
        let all: Vec<f64> =
            self.numbers(&self.header["directors"]).into_iter().map(|x| x / 32767.0).collect();
        let of = |x: &[f64]| [three(&x[..3]), three(&x[3..6]), three(&x[6..])];
        self.of_body(body, &all[frame * self.stations() * 9..], 9).map(of).collect()
    }

    /// Values of a field along a body in a frame; not a number where there is none.
    pub fn field(&self, name: &str, body: &str, frame: usize) -> Vec<f64> {
        let field = self.named("fields", name);
        let [least, most] = [0, 1].map(|k| field["range"][k].as_f64().unwrap());
        let value = |x: f64| if x > 65534.0 { f64::NAN } else { least + x / 65534.0 * (most - least) };
        let all: Vec<f64> = self.numbers(&field["values"]).into_iter().map(value).collect();
        self.of_body(body, &all[frame * self.stations()..], 1).map(|x| x[0]).collect()
    }

    /// The error by which a field is stored.
    pub fn resolution(&self, name: &str) -> f64 {
        let range = &self.named("fields", name)["range"];
        (range[1].as_f64().unwrap() - range[0].as_f64().unwrap()) / 65534.0
    }

    fn of_body<'a>(&self, body: &str, all: &'a [f64], width: usize) -> std::slice::ChunksExact<'a, f64> {
        let body = self.named("bodies", body);
        let [first, count] = ["first", "count"].map(|key| body[key].as_u64().unwrap() as usize);
        all[first * width..(first + count) * width].chunks_exact(width)
    }

    /// A column of a chart.
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
