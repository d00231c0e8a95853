use std::collections::HashSet;

use ancf::Simulation;
use ancf::solver::equations::{EquationsOfMotion, State};

use super::layout::Layout;

/// Name of the list of angles with their full turns. Tables of earlier versions do not have it.
pub(crate) const ANGLES: &str = "angles";

/// Returns the columns of the table of states, with a number of counted angles.
pub(crate) fn state_layout(simulation: &Simulation, angles: usize) -> Layout {
    let system = &simulation.assembly().system;
    let coordinates = |name: &str| (name.to_owned(), system.coordinates());
    let lists = ["q", "v", "a"].map(coordinates).into_iter();
    let more = [("lambda", system.multipliers()), (ANGLES, angles)];
    let numbers = ["row", "value", "load"].map(str::to_owned).to_vec();
    Layout::new(numbers, lists.chain(more.map(|(name, length)| (name.to_owned(), length))).collect())
}

/// Returns the lists of a state in the order of the columns, without the angles.
pub(crate) fn numbers_of_state(s: &State) -> [&[f64]; 4] {
    [&s.q, &s.v, &s.a, &s.lambda]
}

/// Returns the columns of the run that are angles whose turns a state does not contain: names and places in a row.
pub(crate) fn angles(simulation: &Simulation) -> Vec<(String, usize)> {
    let counted: HashSet<String> = simulation.counted_angles().into_iter().collect();
    let names = simulation.columns().into_iter().map(|column| column.name).enumerate();
    names.filter(|(_, name)| counted.contains(name)).map(|(place, name)| (name, place)).collect()
}
