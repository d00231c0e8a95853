use std::cmp::Reverse;
use std::collections::BinaryHeap;

use super::function::Function;
use super::function_value::FunctionValue;
use super::interval::Interval;
use super::variation::Variation;

/// Smallest distance of a value within a step from those at its ends that is reported, relative to the range of the
/// function.
const REPORTED: f64 = 0.25;
/// Number of values from which the range is estimated first.
const SAMPLES: usize = 64;
/// Number of values within a step.
const INNER: u32 = 7;
/// Largest number of groups of steps.
const GROUPS: usize = 20_000;
/// Largest numbers of parts in the search for switches, and of switches.
const PARTS: usize = 1_000_000;
const SWITCHES: usize = 10_000;
/// Largest interval of a switch, a multiple of the smallest part: beyond it rates are not bounded over an interval.
const WIDEST: f64 = 1000.0;
/// Largest jump that counts as rounding, relative to the value and the rates times the duration.
const CONTINUOUS: f64 = 1e-9;
/// Smallest jump of a value between adjacent times, relative to the value and its rate times the duration.
const JUMP: f64 = 1e-12;
/// Smallest part in the search for switches, relative to the duration.
const SMALLEST: f64 = 1e-13;

impl Function {
    /// Returns a variation that steps of a fixed size do not resolve, if there is one: a pulse within a step, or a
    /// vibration with less than about four steps per period. Steps end at the [switches](Self::switches) of formulas.
    ///
    /// Its deviation is that beyond the values at both ends of a step. Groups of steps are
    /// enclosed by interval arithmetic, so no pulse is missed. User-defined functions are not examined.
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
            if f64::from_bits(bound) <= limit(&range) {
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

    /// True if a formula jumps within a duration.
    pub fn jumps(&self, duration: f64) -> bool {
        self.switches(duration).into_iter().any(|t| {
            let [left, right] = [t.next_down(), t].map(|t| self.at(t));
            let size = |f: &FunctionValue| f.value.abs() + duration * f.rate.abs();
            (right.value - left.value).abs() > JUMP * size(&left).max(size(&right))
        })
    }

    /// Returns the times up to a duration at which a formula may jump or have a kink, in ascending order: those of
    /// conditions, comparisons and functions such as `abs`.
    ///
    /// They are the times near which interval arithmetic does not bound the second rate, and at which the value, the rate or
    /// the second rate jumps. A formula with more than ten
    /// thousand of them, or with unbounded rates over a whole interval, has none.
    pub fn switches(&self, duration: f64) -> Vec<f64> {
        let mut zones: Vec<(f64, f64)> = Vec::new();
        let is_searched = matches!(self, Self::Expression { .. }) && duration.is_finite() && duration > 0.0;
        let mut parts = if is_searched { vec![(0.0, duration)] } else { Vec::new() };
        let smallest = SMALLEST * duration;
        let mut count = 0;
        while let Some((a, b)) = parts.pop() {
            let middle = 0.5 * (a + b);
            count += 1;
            if self.bounds(a, b).acceleration.magnitude().is_finite() {
                continue;
            }
            if count > PARTS || zones.len() > SWITCHES {
                return Vec::new();
            }
            if b - a > smallest {
                parts.extend([(middle, b), (a, middle)]);
                continue;
            }
            match zones.last_mut().filter(|zone| a - zone.1 <= smallest) {
                Some(zone) if b - zone.0 > WIDEST * smallest => return Vec::new(),
                Some(zone) => zone.1 = b,
                None => zones.push((a, b)),
            }
        }
        zones.into_iter().filter_map(|zone| self.switch_in(zone, duration)).collect()
    }

    /// Returns the first time after a switch, to the last digit, or `None` if value and rates are continuous there, or if the
    /// value ceases to be finite.
    fn switch_in(&self, (mut a, mut b): (f64, f64), duration: f64) -> Option<f64> {
        if !self.value(b).is_finite() {
            return None;
        }
        let scaled = |f: FunctionValue| [f.value, f.rate * duration, f.acceleration * duration.powi(2)];
        let (left, right) = (scaled(self.at(a)), scaled(self.at(b)));
        let sizes = left.iter().chain(&right).map(|x| x.abs()).filter(|x| x.is_finite());
        let limit = CONTINUOUS * sizes.fold(0.0, f64::max);
        // Numbers that are not finite count as jumps.
        let jumps = |i: usize| {
            let change = (right[i] - left[i]).abs();
            change.is_nan() || change > limit
        };
        let which = (0..3).find(|&i| jumps(i))?;
        loop {
            let middle = 0.5 * (a + b);
            if middle <= a || middle >= b {
                return Some(b);
            }
            let here = scaled(self.at(middle))[which];
            let is_right = (here - right[which]).abs() < (here - left[which]).abs();
            if is_right { b = middle } else { a = middle }
        }
    }
}

/// Parts of an interval between switches. A part ends just before a switch.
fn parts([from, to]: [f64; 2], switches: &[f64]) -> impl Iterator<Item = [f64; 2]> + '_ {
    let inner = &switches[switches.partition_point(|t| *t <= from)..switches.partition_point(|t| *t <= to)];
    let starts = std::iter::once(from).chain(inner.iter().copied());
    starts.zip(inner.iter().map(|t| t.next_down()).chain([to])).map(Into::into)
}
