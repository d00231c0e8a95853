//! Static equilibrium of a model.

use std::ops::ControlFlow;

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::solver::equations::State;
use ancf::solver::newton::{Newton, Stop};
use ancf::solver::statics::{Increments, Statics};

/// Returns the equilibrium under the full load; the first load increment is `1 / steps`.
pub(crate) fn equilibrium(model: &Model, steps: u32) -> (Assembly, State) {
    let assembly = model.assemble_static().unwrap();
    let newton = Newton::new(assembly.system.matrix(), Stop::Energy(1e-10), 100).unwrap();
    let increments = Increments { first: 1.0 / f64::from(steps), ..Increments::default() };
    let start = State { load: 0.0, ..assembly.rest() };
    let mut statics = Statics::new(&assembly.system, newton, increments, start);
    statics.advance(1.0, |_, _| ControlFlow::Continue(())).unwrap();
    let state = statics.state().clone();
    (assembly, state)
}
