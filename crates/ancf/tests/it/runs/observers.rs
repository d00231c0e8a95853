//! Observers of runs: states and rows, fields along bodies, interrupts.

use std::io;
use std::ops::ControlFlow;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use ancf::mechanics::bodies::ShellPlace;
use ancf::model::ScaleChoice;
use ancf::record::Series;
use ancf::solver::equations::State;
use ancf::solver::newton::Interrupt;
use ancf::{Field, Fields, Model, Observer, Outcome, Simulation};

use crate::common::models::parse;

/// Observer that records rows and states.
#[derive(Default)]
struct StateRecorder {
    columns: Vec<String>,
    rows: Vec<Vec<f64>>,
    states: Vec<State>,
}

impl Observer for StateRecorder {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        self.columns = columns.to_vec();
        Ok(())
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        self.rows.push(row.to_vec());
        self.states.push(state.clone());
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl StateRecorder {
    fn numbers(&self, row: usize, first: &str, count: usize) -> &[f64] {
        let at = self.columns.iter().position(|column| column == first).unwrap();
        &self.rows[row][at..at + count]
    }
}

const PENDULUM: &str = r#"
gravity = [0, -9.81, 0]
materials.rubber = { density = 2000, young = 5e6 }
sections.strip = { kind = "rectangle", width = 0.05, height = 0.02 }

[[bodies]]
kind = "rigid"
name = "weight"
mass = 0.5
inertia = [1e-3, 1e-3, 1e-3]
center = [0, 1.1, 0]

[[bodies]]
kind = "beam"
name = "arm"
from = [0, 0, 0]
to = [0, 1, 0]
elements = 3
section = "strip"
material = "rubber"

[[joints]]
kind = "spherical"
name = "pivot"
a = { body = "arm", at = "start" }

[[joints]]
kind = "clamp"
name = "grip"
a = { body = "arm", at = "end" }
b = { body = "weight", at = [0, 1, 0] }

[[probes]]
name = "tip"
on = { body = "arm", at = "end" }
record = ["motion", "section_forces"]

[[probes]]
name = "weight"
on = { body = "weight", at = "center" }

[analysis]
kind = "dynamics"
duration = 0.2
step = 2e-3
"#;

fn pendulum(scales: ScaleChoice) -> Model {
    let model = parse(PENDULUM);
    let tilted = Model { gravity: [3.0, -9.0, 1.0], scales, ..model };
    tilted.check().unwrap();
    tilted
}

#[test]
fn fields_equal_probes_for_all_scales() {
    for scales in [ScaleChoice::default(), ScaleChoice::Auto] {
        let simulation = Simulation::new(&pendulum(scales)).unwrap();
        let mut recorder = StateRecorder::default();
        assert!(simulation.run(&mut recorder).unwrap().outcome.is_finished());
        let fields = Fields::new(simulation.assembly(), simulation.scales(), 2);
        let last = recorder.states.len() - 1;
        let read = |field| {
            let mut numbers = Vec::new();
            fields.fill(field, &recorder.states[last], &mut numbers);
            numbers
        };
        // Centre of the weight, then nodes of the arm and midpoints between them.
        let lengths: Vec<f64> = fields.stations().iter().map(|station| station.s).collect();
        let expected: Vec<f64> = [0.0].into_iter().chain((0..=6).map(|i| f64::from(i) / 6.0)).collect();
        assert!(
            lengths.iter().zip(&expected).all(|(s, expected)| (s - expected).abs() < 1e-12),
            "{lengths:?}"
        );
        for (field, suffix) in [(Field::Position, ""), (Field::Velocity, "v"), (Field::Acceleration, "a")] {
            let numbers = read(field);
            let probe = |name: &str| recorder.numbers(last, &format!("{name}.{suffix}x"), 3);
            assert_close(&numbers[..3], probe("weight"));
            assert_close(&numbers[7 * 3..], probe("tip"));
        }
        assert_close(&read(Field::SectionForces)[7 * 6..], recorder.numbers(last, "tip.N", 6));
        let (moved, position) = (read(Field::Displacement), read(Field::Position));
        assert_close(&[moved[21], moved[22] + 1.0, moved[23]], &position[21..]);
    }
}

#[test]
fn directors_are_orthonormal() {
    let simulation = Simulation::new(&pendulum(ScaleChoice::default())).unwrap();
    let mut recorder = StateRecorder::default();
    assert!(simulation.run(&mut recorder).unwrap().outcome.is_finished());
    let fields = Fields::new(simulation.assembly(), simulation.scales(), 1);
    let mut numbers = Vec::new();
    fields.fill(Field::Directors, &recorder.states[40], &mut numbers);
    for frame in numbers.chunks_exact(9) {
        for (i, j) in (0..3).flat_map(|i| (0..3).map(move |j| (i, j))) {
            let product: f64 = (0..3).map(|k| frame[3 * i + k] * frame[3 * j + k]).sum();
            let expected = f64::from(u8::from(i == j));
            assert!((product - expected).abs() < 1e-6, "axes {i}, {j}: {product}");
        }
    }
}

#[test]
fn mode_shape_is_the_velocity_of_its_state() {
    let text = PENDULUM.split("[analysis]").next().unwrap().replace("spherical", "clamp");
    for scales in ["", "scales.kind = \"auto\"\n"] {
        let text = format!("{scales}{text}\n[analysis]\nkind = \"modes\"\ncount = 3\n");
        let model = parse(&text);
        let simulation = Simulation::new(&model).unwrap();
        let mut recorder = StateRecorder::default();
        assert!(simulation.run(&mut recorder).unwrap().outcome.is_finished());
        let fields = Fields::new(simulation.assembly(), simulation.scales(), 1);
        for (row, state) in recorder.states.iter().enumerate() {
            let mut shape = Vec::new();
            fields.fill(Field::Velocity, state, &mut shape);
            assert_close(&shape[shape.len() - 3..], recorder.numbers(row, "tip.x", 3));
        }
    }
}

#[test]
fn interrupt_ends_a_run_within_a_step() {
    let statics = PENDULUM.split("[analysis]").next().unwrap().replace("spherical", "clamp");
    let statics = format!("{statics}\n[analysis]\nkind = \"statics\"\nfirst = 0.01\n");
    let modes = statics.replace("statics\"\nfirst = 0.01", "modes\"\ncount = 4");
    for text in [PENDULUM, &statics, &modes] {
        let model = parse(text);
        let simulation = Simulation::new(&model).unwrap();
        let whole = rows(&simulation).0;
        let mut recorder = StateRecorder::default();
        assert!(simulation.run(&mut recorder).unwrap().outcome.is_finished());
        let columns: Vec<_> = simulation.columns().into_iter().map(|column| column.name).collect();
        assert_eq!(columns, recorder.columns);
        let queries = Arc::new(AtomicUsize::new(0));
        let count = Arc::clone(&queries);
        let interrupt = Interrupt::new(move || count.fetch_add(1, Ordering::Relaxed) >= 7);
        let (part, outcome) = rows(&Simulation::new(&model).unwrap().with_interrupt(interrupt));
        assert_eq!(outcome, Outcome::Stopped);
        assert!(queries.load(Ordering::Relaxed) <= 9, "no halved and no repeated steps: {queries:?}");
        assert!((text == modes || part.len() > 1) && part.len() < whole.len());
        assert_eq!(part[..], whole[..part.len()]);
    }
}

/// Returns the first column of a run and its outcome.
fn rows(simulation: &Simulation) -> (Vec<f64>, Outcome) {
    let mut series = Series::new();
    let summary = simulation.run(&mut series).unwrap();
    let first = series.columns().next().unwrap().1.to_vec();
    (first, summary.outcome)
}

fn assert_close(found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() <= 1e-12 * size, "{found:?} instead of {expected:?}");
    }
}

/// Stations of fields are a grid with the values of probes, and frames whose first tangent is that of the stresses.
#[test]
fn fields_have_the_values_of_probes() {
    let text = "materials.m = { young = 12e6, poisson = 0.3, density = 1 }\n\
         bodies = [{ kind = \"shell\", name = \"s\", surface = { kind = \"twisted\", from = [0, 0, 0], to = [1, 0, 0], width = [0, 0.4, 0.1], twist = 0.5 }, elements = [3, 2], thickness = 0.01, material = \"m\" },\n\
         { kind = \"mass\", name = \"stone\", center = [0, 0, 3], mass = 1 }]\n\
         loads = [{ kind = \"surface_pressure\", body = \"s\", pressure = 1 }]\n\
         joints = [{ kind = \"support\", name = \"root\", a = { body = \"s\", at = { edge = \"u_start\" } }, condition = \"clamped\" }]\n\
         probes = [{ name = \"p\", on = { body = \"s\", at = [0.5, 0.75] }, record = [\"motion\", \"resultants\", \"surface_stress\"] }]\n\
         scales.kind = \"auto\"\n\
         analysis = { kind = \"dynamics\", duration = 0.01, step = 0.001, scheme = \"average_acceleration\" }\n";
    let simulation = Simulation::new(&Model::parse(text).unwrap()).unwrap();
    let mut recorder = StateRecorder::default();
    assert!(simulation.run(&mut recorder).unwrap().outcome.is_finished());
    let row = recorder.states.len() - 1;
    let fields = Fields::new(simulation.assembly(), simulation.scales(), 2);
    assert_eq!(fields.stations().len(), 7 * 5 + 1);
    let station =
        fields.stations().iter().position(|s| s.surface == Some(ShellPlace::Patch([0.5, 0.75]))).unwrap();
    assert_eq!(station, 3 * 7 + 3);
    for (field, column) in [
        (Field::Position, "p.x"),
        (Field::Velocity, "p.vx"),
        (Field::Resultants, "p.nuu"),
        (Field::SurfaceStress, "p.suu_top"),
    ] {
        let mut numbers = Vec::new();
        fields.fill(field, &recorder.states[row], &mut numbers);
        let width = field.width();
        let own = &numbers[station * width..(station + 1) * width];
        let expected = recorder.numbers(row, column, width);
        let size = expected.iter().fold(0.0, |size: f64, x| size.max(x.abs()));
        assert!(size > 0.0);
        own.iter()
            .zip(expected)
            .for_each(|(x, expected)| assert!((x - expected).abs() < 1e-10 * size, "{column}"));
        let of_stone = &numbers[35 * width..];
        assert!(of_stone.len() == width && (width == 3 || of_stone.iter().all(|x| x.is_nan())));
    }
}
