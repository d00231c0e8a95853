//! Static equilibrium of a model.

use std::ops::ControlFlow;

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::solver::equations::State;
use ancf::solver::newton::{Newton, StopRule};
use ancf::solver::statics::{LoadIncrements, LoadStepper};

/// Returns the equilibrium under the full load; the first load increment is `1 / steps`.
pub(crate) fn equilibrium(model: &Model, steps: u32) -> (Assembly, State) {
    let assembly = model.assemble_static().unwrap();
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 100).unwrap();
    let increments = LoadIncrements { first: 1.0 / f64::from(steps), ..LoadIncrements::default() };
    let start = State { load: 0.0, ..assembly.rest() };
    let mut statics = LoadStepper::new(&assembly.system, newton, increments, start);
    statics.advance(1.0, |_, _| ControlFlow::Continue(())).unwrap();
    let state = statics.state().clone();
    (assembly, state)
}
