//! Static equilibrium: Newton's method on the stiffness.

use ancf::Model;
use ancf::analysis::{Newton, Stop};
use ancf::model::{Assembly, Load};
use ancf::system::{State, Weights};

/// The equilibrium of a model under its gravity and its forces, which grow in so many equal steps.
pub(crate) fn equilibrium(model: &Model, steps: u32) -> (Assembly, State) {
    let mut assembly = model.assemble().unwrap();
    let mut state = assembly.rest();
    for step in 1..=steps {
        assembly = loaded(model, f64::from(step) / f64::from(steps)).assemble().unwrap();
        let mut newton = Newton::new(assembly.system.matrix(), Stop::Energy(1e-10), 100).unwrap();
        newton.solve(&assembly.system, &mut state, Weights::STIFFNESS).unwrap();
    }
    (assembly, state)
}

/// The same model under a part of its loads.
fn loaded(model: &Model, part: f64) -> Model {
    let mut model = model.clone();
    model.gravity = model.gravity.map(|g| part * g);
    for Load::Force { force, .. } in &mut model.loads {
        *force = force.map(|f| part * f);
    }
    model
}
