//! Complex shapes of damped modes: circular whirls of a symmetric rotor.

use std::f64::consts::TAU;
use std::io;
use std::ops::ControlFlow;

use ancf::solver::equations::State;
use ancf::{Field, Fields, Observer, Simulation};
use nalgebra::Vector3;

use crate::common::models::parse;

/// Frequencies and states of modes.
#[derive(Default)]
struct Shapes {
    frequencies: Vec<f64>,
    states: Vec<State>,
}

impl Observer for Shapes {
    fn begin(&mut self, columns: &[String]) -> io::Result<()> {
        assert_eq!(columns[..2], ["mode", "frequency"]);
        Ok(())
    }

    fn record(&mut self, row: &[f64], state: &State) -> io::Result<ControlFlow<()>> {
        self.frequencies.push(row[1]);
        self.states.push(state.clone());
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Mode with the displacements of all stations.
struct Whirl {
    /// Angular frequency.
    omega: f64,
    real: Vec<Vector3<f64>>,
    imaginary: Vec<Vector3<f64>>,
}

const ROUND: &str = r#"{ kind = "circle", diameter = 0.02 }"#;
const FLAT: &str = r#"{ kind = "rectangle", width = 0.02, height = 0.015 }"#;

/// Modes of a round shaft along x that turns about its axis, clamped at its start.
fn shaft(speed: f64, tau: f64) -> Vec<Whirl> {
    let rotation = format!("{{ kind = \"base_rotation\", angular_velocity = [{speed}, 0, 0] }}");
    modes(ROUND, &rotation, tau, true)
}

/// Modes of a shaft with a section and loads.
fn modes(section: &str, loads: &str, tau: f64, damped: bool) -> Vec<Whirl> {
    let model = parse(&format!(
        r#"
units = {{ length = "m", time = "s", force = "N" }}
materials.steel = {{ density = 7850, young = 2e11, damping = {{ strain = {tau} }} }}
sections.own = {section}
bodies = [{{ kind = "beam", name = "shaft", from = [0, 0, 0], to = [1, 0, 0], elements = 6, section = "own", material = "steel" }}]
joints = [{{ kind = "clamp", name = "root", a = {{ body = "shaft", at = "start" }} }}]
loads = [{loads}]
[analysis]
kind = "modes"
about = "equilibrium"
count = 4
damped = {damped}
"#
    ));
    let simulation = Simulation::new(&model).unwrap();
    let mut shapes = Shapes::default();
    assert!(simulation.run(&mut shapes).unwrap().outcome.is_finished());
    let fields = Fields::new(simulation.assembly(), simulation.scales(), 1);
    let read = |field, s: &State| -> Vec<Vector3<f64>> {
        let mut numbers = Vec::new();
        fields.fill(field, s, &mut numbers);
        numbers.chunks_exact(3).map(Vector3::from_column_slice).collect()
    };
    let whirl = |(frequency, s): (&f64, &State)| Whirl {
        omega: frequency * TAU,
        real: read(Field::Velocity, s),
        imaginary: read(Field::Acceleration, s),
    };
    shapes.frequencies.iter().zip(&shapes.states).map(whirl).collect()
}

fn largest(vectors: &[Vector3<f64>]) -> f64 {
    vectors.iter().map(Vector3::norm).fold(0.0, f64::max)
}

/// The motion Re cos ωt − Im sin ωt is a circle about x at every station. It is forward with ω₀ − Ω and backward with ω₀ + Ω.
#[test]
fn whirls_are_circles_of_both_senses() {
    let bending = shaft(0.0, 0.0)[0].omega;
    for tau in [0.0, 1e-5] {
        let speed = 0.4 * bending;
        for (whirl, sense) in shaft(speed, tau).iter().zip([1.0, -1.0]) {
            let expected = bending - sense * speed;
            assert!((whirl.omega / expected - 1.0).abs() < 2e-3, "{} not {expected}", whirl.omega);
            let size = largest(&whirl.real);
            for (real, imaginary) in whirl.real.iter().zip(&whirl.imaginary) {
                // Forward: Im is Re turned by −90° about x.
                let turned = sense * real.cross(&Vector3::x());
                assert!(
                    (imaginary - turned).norm() < 1e-5 * size,
                    "{imaginary} not {turned} at {speed}, {tau}"
                );
                assert!(real.x.abs() < 1e-5 * size);
            }
        }
    }
}

/// All phases of a circle are equally large: the largest coordinate, the slope along y at the free end, is real and positive.
#[test]
fn phases_of_circular_whirls_are_determined() {
    for whirl in &shaft(30.0, 1e-5)[..2] {
        let tip = whirl.real.last().unwrap();
        assert!(tip.y > 0.0 && tip.z.abs() < 1e-5 * tip.y, "{tip}");
    }
}

/// Proportional damping without rotation has real shapes, and undamped modes have no imaginary part.
#[test]
fn shapes_without_gyroscopic_forces_are_real() {
    for whirl in modes(FLAT, "", 1e-5, true) {
        assert!(largest(&whirl.imaginary) < 1e-5 * largest(&whirl.real));
    }
    for whirl in modes(FLAT, "", 0.0, false) {
        assert_eq!(largest(&whirl.imaginary), 0.0);
    }
}
