//! Cost of contacts.

use super::row::MeasuredValue;
use crate::Result;
use crate::measure::{SampleSize, median, samples};
use crate::models::{crossing, pile, plane};
use crate::subjects::ContactSteps;

/// Milliseconds per step of ten cables in a pile.
pub fn pile_of_ten() -> Result<MeasuredValue> {
    let mut steps = ContactSteps::new(&pile(10, 10), 100, 40)?;
    let value = 1e3 * median(samples(&mut steps, SampleSize::LARGE)?);
    let note = format!("steps 101 to 140, {:.2} iterations per step", steps.iterations());
    Ok(MeasuredValue::new(value, note))
}

/// Steps of crossing cables relative to those without contact.
pub fn crossing_cables() -> Result<MeasuredValue> {
    ratio(|contact| crossing(10, contact), 500)
}

/// Steps of a cable on a plane relative to those without contact.
pub fn cable_on_plane() -> Result<MeasuredValue> {
    ratio(|contact| plane(20, contact), 1000)
}

fn ratio(model: impl Fn(bool) -> String, count: u32) -> Result<MeasuredValue> {
    let cost = |contact| -> Result<f64> {
        let mut steps = ContactSteps::new(&model(contact), 0, count)?;
        Ok(1e3 * median(samples(&mut steps, SampleSize::LARGE)?))
    };
    let (with, without) = (cost(true)?, cost(false)?);
    let note = format!("{count} steps, {with:.3} ms each, without contact {without:.3} ms");
    Ok(MeasuredValue::new(with / without, note))
}
