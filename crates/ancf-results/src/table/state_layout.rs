use ancf::Simulation;
use ancf::solver::equations::{EquationsOfMotion, State};

use super::layout::Layout;

/// Returns the columns of the table of states.
pub(crate) fn state_layout(simulation: &Simulation) -> Layout {
    let system = &simulation.assembly().system;
    let coordinates = |name: &str| (name.to_owned(), system.coordinates());
    let lists = ["q", "v", "a"].map(coordinates).into_iter();
    let numbers = ["row", "value", "load"].map(str::to_owned).to_vec();
    Layout::new(numbers, lists.chain([("lambda".to_owned(), system.multipliers())]).collect())
}

/// Returns the lists of a state in the order of the columns.
pub(crate) fn numbers_of_state(s: &State) -> [&[f64]; 4] {
    [&s.q, &s.v, &s.a, &s.lambda]
}
