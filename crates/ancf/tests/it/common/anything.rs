//! Checks of the parsers on arbitrary bytes, shared by the fuzz targets (`fuzz/`) and the test that replays their corpora.
//!
//! This file depends on no other file of the tests, because the fuzz targets include it.
#![allow(dead_code, reason = "each fuzz target uses one of these functions")]

use std::io;
use std::ops::ControlFlow;

use ancf::mechanics::functions::Expression;
use ancf::model::{Analysis, Body, Step};
use ancf::record::Sink;
use ancf::{Model, Simulation};

/// Parses the bytes as a model file. Asserts that errors lie within the text and that a valid model starts to run.
pub fn model(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Model::parse(text) {
        Ok(model) if is_small(&model) => {
            let mut model = model;
            limit(&mut model.analysis);
            let simulation = Simulation::new(&model).expect("the model was validated by the parser");
            let _ = simulation.run(&mut RowLimit(5)).expect("the sink returns no error");
        }
        Ok(_) => {}
        Err(errors) => {
            for error in errors {
                let at = error.at.clone().expect("errors of a text have a position");
                assert!(text.get(at.bytes).is_some(), "{error}");
            }
        }
    }
}

/// Parses the bytes as a formula. Evaluates it, or asserts that the position of the error lies within the text.
pub fn expression(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    match Expression::parse(text) {
        Ok(formula) => [-1.0, 0.0, 1e-300, 0.5, 2.0, 1e300].into_iter().for_each(|t| _ = formula.at(t)),
        Err(error) => assert!(error.at <= text.chars().count(), "{error}"),
    }
}

/// True if a run takes a fraction of a second.
fn is_small(model: &Model) -> bool {
    let elements: u64 = model.bodies.iter().map(|body| u64::from(elements(body))).sum();
    let lists = [model.bodies.len(), model.joints.len(), model.loads.len(), model.contacts.len()];
    elements <= 30 && lists.iter().all(|length| *length <= 10) && !needs_supplies(model)
}

fn elements(body: &Body) -> u32 {
    match body {
        Body::Beam(beam) => beam.elements,
        Body::Cable(cable) => cable.elements,
        Body::Shell(shell) => shell.elements[0].saturating_mul(shell.elements[1]),
        Body::ShearShell(shell) => shell.mesh.elements.len() as u32,
        Body::Rigid(_) | Body::Mass(_) => 1,
    }
}

/// True if the model needs functions that a program supplies.
fn needs_supplies(model: &Model) -> bool {
    model.check_supplies().is_err()
}

/// Limits the iterations and the number of results of an analysis.
fn limit(analysis: &mut Analysis) {
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

/// Sink that stops a run after a number of rows.
struct RowLimit(u32);

impl Sink for RowLimit {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        Ok(())
    }

    fn record(&mut self, _: &[f64]) -> io::Result<ControlFlow<()>> {
        self.0 = self.0.saturating_sub(1);
        Ok(if self.0 == 0 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) })
    }
}
