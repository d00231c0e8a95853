//! Rows of large models: costs of the program outside the time steps.

use super::process::{ProgramCost, program_run, run, with_model};
use super::row::{MeasuredValue, RowSpec, RowUnit};
use crate::Result;
use crate::models::{chain, frames, hook, modes, probes, slack_cable};

type Measure = fn() -> Result<MeasuredValue>;

/// Row of modes, with the time of SciPy 1.17 (`eigsh`, shift and invert at zero) for the same matrices without reading and writing.
const fn scipy(name: &'static str, goal: f64, theirs: f64) -> RowSpec {
    RowSpec::new(name, RowUnit::Seconds, goal).large().against("SciPy", theirs)
}

/// Number of rigid bodies of the chain.
const BODIES: u32 = 10_000;
/// Number of rigid bodies and of time steps of a chain in motion.
const MOVING: (u32, u32) = (1000, 201);
/// Number of time steps with probes.
const STEPS: u32 = 1000;
/// Number of probes.
const PROBES: u32 = 1000;
/// Number of elements and of stored states of the beam for ParaView.
const FRAMES: (u32, u32) = (10_000, 6);

/// All rows.
pub(super) const ROWS: [(RowSpec, Measure); 13] = [
    (RowSpec::new("step of a chain, per rigid body", RowUnit::Microseconds, 2.2).large(), chain_step),
    (RowSpec::new("run of one step, per rigid body", RowUnit::Microseconds, 250.0).large(), chain_run),
    (RowSpec::new("check, per rigid body", RowUnit::Microseconds, 250.0).large(), chain_check),
    (RowSpec::new("1000 probes against 1, 1000 steps", RowUnit::Factor, 5.0).large(), probe_factor),
    (RowSpec::new("memory, 1000 probes", RowUnit::Megabytes, 100.0).large(), probe_memory),
    (RowSpec::new("ParaView, a frame of 1e4 elements", RowUnit::Seconds, 0.2).large(), paraview_frame),
    (RowSpec::new("memory, ParaView, 1e4 elements", RowUnit::Megabytes, 100.0).large(), paraview_memory),
    (scipy("10 modes, 1000 cable elements", 0.0375, 0.025), || whole_run(&modes(1000))),
    (scipy("10 modes, 5000 cable elements", 0.165, 0.11), || whole_run(&modes(5000))),
    (scipy("10 modes, 20 000 cable elements", 0.93, 0.62), || whole_run(&modes(20_000))),
    (RowSpec::new("10 modes, 100 000 cable elements", RowUnit::Seconds, 10.0).large(), || {
        whole_run(&modes(100_000))
    }),
    (RowSpec::new("statics, hook of 10 000 elements, L/d = 5000", RowUnit::Seconds, 1.5).large(), || {
        whole_run(&hook(10_000, 5000.0))
    }),
    (RowSpec::new("statics, slack cable of 100 000 elements", RowUnit::Seconds, 5.0).large(), || {
        whole_run(&slack_cable(100_000))
    }),
];

fn per_body(cost: ProgramCost) -> Result<MeasuredValue> {
    Ok(MeasuredValue::new(1e6 * cost.processor / f64::from(BODIES), format!("{BODIES} bodies")))
}

/// Difference of the costs of many steps and of one step, with a row of results per step.
fn chain_step() -> Result<MeasuredValue> {
    let (bodies, steps) = MOVING;
    let (many, one) = (with_model(&chain(bodies, steps), run)?, with_model(&chain(bodies, 1), run)?);
    let per_step = (many.processor - one.processor) / f64::from(steps - 1);
    Ok(MeasuredValue::new(
        1e6 * per_step / f64::from(bodies),
        format!("{bodies} bodies, {} steps", steps - 1),
    ))
}

fn chain_run() -> Result<MeasuredValue> {
    per_body(with_model(&chain(BODIES, 1), run)?)
}

fn chain_check() -> Result<MeasuredValue> {
    per_body(with_model(&chain(BODIES, 1), |folder| program_run(folder, &["check", "model.toml"]))?)
}

fn probe_factor() -> Result<MeasuredValue> {
    let (many, one) = (with_model(&probes(PROBES, STEPS), run)?, with_model(&probes(1, STEPS), run)?);
    let per_number = 1e9 * (many.processor - one.processor) / (9.0 * f64::from(PROBES) * f64::from(STEPS));
    Ok(MeasuredValue::new(
        many.processor / one.processor,
        format!("with text and table; {per_number:.0} ns per number"),
    ))
}

fn probe_memory() -> Result<MeasuredValue> {
    Ok(MeasuredValue::new(1e-6 * with_model(&probes(PROBES, STEPS), run)?.memory, "maximum resident memory"))
}

/// Writes a number of the stored states for ParaView.
fn paraview(count: u32) -> Result<ProgramCost> {
    let (elements, states) = FRAMES;
    with_model(&frames(elements, states), |folder| {
        run(folder)?;
        program_run(folder, &["paraview", "out", "--frames", &count.to_string()])
    })
}

fn paraview_frame() -> Result<MeasuredValue> {
    let (all, one) = (paraview(FRAMES.1)?, paraview(1)?);
    Ok(MeasuredValue::new((all.processor - one.processor) / f64::from(FRAMES.1 - 1), "one thread"))
}

fn paraview_memory() -> Result<MeasuredValue> {
    Ok(MeasuredValue::new(1e-6 * paraview(FRAMES.1)?.memory, "maximum resident memory"))
}

fn whole_run(text: &str) -> Result<MeasuredValue> {
    Ok(MeasuredValue::new(with_model(text, run)?.processor, "with error estimates and output files"))
}
