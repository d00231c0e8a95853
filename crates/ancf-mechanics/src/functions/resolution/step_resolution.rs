use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::functions::function::Function;
use crate::functions::interval::Interval;
use crate::functions::variation::Variation;

/// Smallest distance of a value within a step from those at its ends that is reported, relative to the range of the
/// function.
const REPORTED: f64 = 0.25;
/// Number of values from which the range is estimated first.
const SAMPLES: usize = 64;
/// Number of values within a step.
const INNER: u32 = 7;
/// Largest number of groups of steps.
const GROUPS: usize = 20_000;

impl Function {
    /// Returns a variation that steps of a fixed size do not resolve, if there is one: a pulse within a step or at its end, or a
    /// vibration with less than about four steps per period. Steps end at the [switches](Self::switches) of formulas.
    ///
    /// Its deviation is that beyond the values at both ends of a step, or that of a peak at the end of a step from the values at the
    /// neighbouring ends. Groups of steps are enclosed by interval arithmetic, so no pulse is missed. User-defined functions are not
    /// examined.
    pub fn unresolved_variation(&self, [start, duration]: [f64; 2], step: f64) -> Option<Variation> {
        if !self.may_vary_unseen() || matches!(self, Self::External { .. }) {
            return None;
        }
        let count = (duration / step).ceil().min(1e15) as u64;
        let mut range = Interval::point(self.value(start));
        let include = |range: &mut Interval, value: f64| {
            if value.is_finite() {
                *range = range.hull(Interval::point(value));
            }
        };
        let sample = |i| start + duration * i as f64 / SAMPLES as f64;
        (1..=SAMPLES).for_each(|i| include(&mut range, self.value(sample(i))));
        let time = |i: u64| start + (i as f64 * step).min(duration);
        let switches = self.switches(start + duration);
        let group = |first: u64, end: u64| {
            let bounds = self.bounds(time(first), time(end));
            let bent = 0.125 * step * step * bounds.acceleration.magnitude();
            let bound = bent.min(bounds.value.upper - bounds.value.lower);
            // Numbers above 0 have the order of their bits.
            (bound.max(0.0).to_bits(), Reverse(end - first), Reverse(first))
        };
        let mut groups = BinaryHeap::from([group(0, count)]);
        for _ in 0..GROUPS {
            let (bound, Reverse(length), Reverse(first)) = groups.pop()?;
            let limit = |range: &Interval| REPORTED * (range.upper - range.lower);
            // Two steps contribute to the error of a peak between them.
            if f64::from_bits(bound) <= 0.5 * limit(&range) {
                return None;
            }
            let end = first + length;
            if length > 1 {
                let middle = first + length / 2;
                include(&mut range, self.value(time(middle)));
                groups.extend([group(first, middle), group(middle, end)]);
                continue;
            }
            for [from, to] in parts([time(first), time(end)], &switches) {
                let Some(variation) = self.variation_beyond_ends(from, to, step) else { continue };
                include(&mut range, self.value(variation.at));
                if variation.deviation > limit(&range) {
                    return Some(variation);
                }
            }
            let near = [first.saturating_sub(1), first, end, (end + 1).min(count)].map(time);
            let peak = self.unresolved_peak(&step_ends(near, &switches), start, limit(&range));
            if peak.is_some() {
                return peak;
            }
        }
        None
    }

    /// Returns the variation within a step with the deviation beyond the values at its ends, if there is one: an unseen one, or one
    /// that the rates at the ends show, such as the arc between two zeros of a sine.
    fn variation_beyond_ends(&self, from: f64, to: f64, step: f64) -> Option<Variation> {
        let ends = Interval::between(self.value(from), self.value(to));
        let beyond = |t: f64| {
            let value = self.value(t);
            (value - ends.upper).max(ends.lower - value).max(0.0)
        };
        if let Some(variation) = self.unseen_variation(from, to, step) {
            return Some(Variation { deviation: beyond(variation.at), ..variation });
        }
        let sample = |k: u32| from + (to - from) * f64::from(k) / f64::from(INNER + 1);
        let (mut at, mut deviation, mut sum) = (from, 0.0, 0.0);
        for t in (1..=INNER).map(sample) {
            let own = beyond(t);
            sum += own;
            if own > deviation {
                (at, deviation) = (t, own);
            }
        }
        let width = (to - from) / f64::from(INNER + 1) * sum / deviation;
        (deviation > 0.0).then_some(Variation { at, deviation, width })
    }
}

/// Parts of an interval between switches. A part ends just before a switch.
fn parts([from, to]: [f64; 2], switches: &[f64]) -> impl Iterator<Item = [f64; 2]> + '_ {
    let inner = &switches[switches.partition_point(|t| *t <= from)..switches.partition_point(|t| *t <= to)];
    let starts = std::iter::once(from).chain(inner.iter().copied());
    starts.zip(inner.iter().map(|t| t.next_down()).chain([to])).map(Into::into)
}

/// Ends of steps among given times and the switches between them, in ascending order.
fn step_ends(times: [f64; 4], switches: &[f64]) -> Vec<f64> {
    let [first, .., last] = times;
    let inner = switches.iter().copied().filter(|t| (first..last).contains(t));
    let mut ends: Vec<f64> = times.into_iter().chain(inner).collect();
    ends.sort_unstable_by(f64::total_cmp);
    ends.dedup();
    ends
}
