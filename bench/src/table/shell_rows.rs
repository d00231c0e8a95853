//! Rows of plates of thin shell elements.

use super::process::{ProgramCost, run, with_model};
use super::row::{MeasuredValue, RowSpec, RowUnit};
use crate::Result;
use crate::models::plate;

type Measure = fn() -> Result<MeasuredValue>;

/// Number of elements along an edge and of time steps.
const MEDIUM: (u32, u32) = (32, 51);
const LARGE: (u32, u32) = (100, 9);

/// All rows.
pub(super) const ROWS: [(RowSpec, Measure); 3] = [
    (RowSpec::new("step of a plate of 32 × 32 thin elements", RowUnit::Microseconds, 8.0), || step(MEDIUM)),
    (
        RowSpec::new("step of a plate of 100 × 100 thin elements", RowUnit::Microseconds, 12.0).large(),
        || step(LARGE),
    ),
    (RowSpec::new("memory per thin element", RowUnit::Kilobytes, 20.0).large(), memory),
];

fn cost(elements: u32, steps: u32) -> Result<ProgramCost> {
    with_model(&plate(elements, steps), run)
}

/// Difference of the costs of many steps and of one step, per element and step.
fn step((elements, steps): (u32, u32)) -> Result<MeasuredValue> {
    let difference = cost(elements, steps)?.processor - cost(elements, 1)?.processor;
    let value = 1e6 * difference / f64::from((steps - 1) * elements * elements);
    Ok(MeasuredValue::new(value, format!("{} steps, one thread", steps - 1)))
}

/// Difference of the memory of a large and a medium plate, per element.
fn memory() -> Result<MeasuredValue> {
    let [large, medium] = [LARGE.0, MEDIUM.0].map(|elements| (elements, cost(elements, 1)));
    let value = 1e-3 * (large.1?.memory - medium.1?.memory) / f64::from(large.0.pow(2) - medium.0.pow(2));
    Ok(MeasuredValue::new(value, "maximum resident memory"))
}
