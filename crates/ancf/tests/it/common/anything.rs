//! What is done with bytes of any origin, by the fuzz targets (`fuzz/`) and by the test that replays their corpora.
#![allow(dead_code, reason = "each target has one of these")]

use std::io;
use std::ops::ControlFlow;

use ancf::function::Expression;
use ancf::model::{Analysis, Body, Step};
use ancf::record::Sink;
use ancf::{Model, Simulation};

/// A text as a model file: nothing may panic, errors lie within the text, and a model that is accepted is accepted again,
/// assembles and begins to run.
pub fn model(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Model::parse(text) {
        Ok(model) if is_small(&model) => {
            let mut model = model;
            curb(&mut model.analysis);
            let simulation = Simulation::new(&model).expect("a model that was accepted, of the same bodies");
            simulation.run(&mut Few(5)).expect("a sink that does not fail");
        }
        Ok(_) => {}
        Err(errors) => {
            for error in errors {
                let at = error.at.clone().expect("a place in the text");
                assert!(text.get(at.bytes).is_some(), "{error}");
            }
        }
    }
}

/// A text as a formula: it is read or refused at one of its characters, and has values.
pub fn expression(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Expression::parse(text) {
        Ok(formula) => [-1.0, 0.0, 1e-300, 0.5, 2.0, 1e300].into_iter().for_each(|t| _ = formula.at(t)),
        Err(error) => assert!(error.at <= text.chars().count(), "{error}"),
    }
}

/// Whether a run takes no more than an instant.
fn is_small(model: &Model) -> bool {
    let elements: u64 = model.bodies.iter().map(|body| u64::from(elements(body))).sum();
    let lists = [model.bodies.len(), model.joints.len(), model.loads.len(), model.contacts.len()];
    elements <= 30 && lists.iter().all(|length| *length <= 10) && !wants_program(model)
}

const fn elements(body: &Body) -> u32 {
    match body {
        Body::Beam(beam) => beam.elements,
        Body::Cable(cable) => cable.elements,
        Body::Rigid(_) | Body::Mass(_) => 1,
    }
}

/// Whether functions are to be supplied.
fn wants_program(model: &Model) -> bool {
    model.check_supplies().is_err()
}

/// Few iterations, few steps.
fn curb(analysis: &mut Analysis) {
    match analysis {
        Analysis::Dynamics(dynamics) => {
            dynamics.max_iterations = dynamics.max_iterations.min(10);
            dynamics.max_halvings = dynamics.max_halvings.min(2);
            if let Step::Adaptive { tolerance, .. } = &mut dynamics.step {
                *tolerance = tolerance.max(1e-3);
            }
        }
        Analysis::Statics(statics) => statics.max_iterations = statics.max_iterations.min(10),
        Analysis::Path(path) => {
            path.max_iterations = path.max_iterations.min(10);
            path.points = path.points.min(5);
        }
        Analysis::Modes(modes) => modes.count = modes.count.min(5),
        Analysis::Buckling(buckling) => buckling.count = buckling.count.min(5),
    }
}

/// Stops a run after so many rows.
struct Few(u32);

impl Sink for Few {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        Ok(())
    }

    fn record(&mut self, _: &[f64]) -> io::Result<ControlFlow<()>> {
        self.0 = self.0.saturating_sub(1);
        Ok(if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
    }
}
