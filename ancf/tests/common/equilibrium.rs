//! Static equilibrium: Newton's method on the stiffness.

use ancf::Model;
use ancf::analysis::{Newton, Stop};
use ancf::model::Assembly;
use ancf::system::{State, Weights};

/// The equilibrium of a model under its gravity and its loads, which grow in so many equal steps.
pub(crate) fn equilibrium(model: &Model, steps: u32) -> (Assembly, State) {
    let assembly = model.assemble_static().unwrap();
    let mut state = assembly.rest();
    for step in 1..=steps {
        state.load = f64::from(step) / f64::from(steps);
        let mut newton = Newton::new(assembly.system.matrix(), Stop::Energy(1e-10), 100).unwrap();
        newton.solve(&assembly.system, &mut state, Weights::STIFFNESS).unwrap();
    }
    (assembly, state)
}
