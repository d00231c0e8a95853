use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::f64::consts::TAU;

use super::function::Function;
use super::function_bounds::FunctionBounds;
use super::function_value::FunctionValue;
use super::interval::Interval;
use super::syntax_node::{Binary, Operand as _, Unary};

/// Variation of a function within an interval: its deviation D from the straight line between the ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Variation {
    /// Time of the largest deviation found.
    pub at: f64,
    /// Magnitude |D| at this time.
    pub deviation: f64,
    /// Width: ∫|D| dt divided by |D| at this time.
    pub width: f64,
}

/// Largest deviation from the cubic polynomial through the values and rates at both ends for which these show the
/// variation, relative to the variation.
const SEEN: f64 = 0.1;
/// Deviations below this part of the largest value are rounding errors.
const NEGLIGIBLE: f64 = 1e-12;
/// Largest number of parts of an interval.
const PARTS: usize = 4096;
/// Largest ratio of the bounds of ∫|D| dt.
const SHARPNESS: f64 = 2.0;
/// Smallest part of an interval.
const SMALLEST: f64 = 1e-12;
/// Numbers of samples of a user-defined function: least per interval.
const SAMPLES: usize = 8;

impl Function {
    /// Returns the variation within an interval that values and rates at its ends do not show, if there is one.
    ///
    /// Formulas are enclosed by interval arithmetic with their first two rates: the interval is divided until the bounds
    /// of all parts are small or a deviation is found. No variation is missed, however narrow. User-defined functions are
    /// evaluated at the given spacing and at eight times at least. Between two breaks, the other functions have no
    /// variation of this kind.
    ///
    /// Source: Moore (1966); Taylor forms of second order.
    pub fn unseen_variation(&self, from: f64, to: f64, spacing: f64) -> Option<Variation> {
        if !self.may_vary_unseen() || from >= to {
            return None;
        }
        // Rates may overflow where the value does not. They count as 0, which shows less of the variation.
        let end = |t: f64| {
            let f = self.at(t);
            FunctionValue { rate: if f.rate.is_finite() { f.rate } else { 0.0 }, ..f }
        };
        let (a, b) = (end(from), end(to));
        if !a.value.is_finite() || !b.value.is_finite() {
            return None;
        }
        let cubic = Polynomial::cubic(from, to, &a, &b);
        let h = to - from;
        let shown = (b.value - a.value).abs() + 0.25 * h * a.rate.abs().max(b.rate.abs());
        let rounding = NEGLIGIBLE * a.value.abs().max(b.value.abs()) + f64::MIN_POSITIVE.sqrt();
        let limit = (SEEN * shown).max(rounding);
        let line = Polynomial::line(from, to, &a, &b);
        if matches!(self, Self::External { .. }) {
            let count = ((h / spacing).ceil() as usize).clamp(SAMPLES, PARTS);
            return self.sampled(&cubic, &line, (from, h), count, limit);
        }
        self.exceeds(&cubic, from, to, limit).then(|| self.deviation(&line, from, to)).flatten()
    }

    /// Returns true if the function may vary between its breaks.
    pub(crate) fn may_vary_unseen(&self) -> bool {
        match self {
            Self::Sine { .. } | Self::Expression { .. } | Self::External { .. } => true,
            Self::Integral(integral) => integral.integrand().may_vary_unseen(),
            Self::Constant(_) | Self::Table(_) | Self::Ramp { .. } | Self::Step { .. } | Self::Input(_) => {
                false
            }
        }
    }

    /// Returns true unless the deviation from a polynomial is below a limit everywhere in an interval.
    fn exceeds(&self, from: &Polynomial, a: f64, b: f64, limit: f64) -> bool {
        let mut parts = BinaryHeap::from([self.part(from, a, b, false)]);
        let (mut count, mut limit) = (1, limit);
        while let Some(part) = parts.pop() {
            limit = limit.max(NEGLIGIBLE * part.largest);
            if part.sample > limit || count > PARTS {
                return true;
            }
            if part.bound <= 1.5 * limit {
                return false;
            }
            for (a, b) in part.halves(SMALLEST * (b - a)) {
                parts.push(self.part(from, a, b, false));
                count += 1;
            }
        }
        false
    }

    /// Computes ∫|D| dt for the deviation D from a polynomial, to a factor of two.
    fn deviation(&self, from: &Polynomial, a: f64, b: f64) -> Option<Variation> {
        let first = self.part(from, a, b, true);
        let (mut at, mut peak, mut sums) = (first.middle(), first.sample, Sums::default());
        sums.add(&first, 1.0);
        let mut parts = BinaryHeap::from([first]);
        for _ in 0..PARTS {
            if sums.are_sharp() {
                break;
            }
            let Some(part) = parts.pop() else { break };
            sums.add(&part, -1.0);
            for (a, b) in part.halves(SMALLEST * (b - a)) {
                let half = self.part(from, a, b, true);
                if half.sample > peak {
                    (at, peak) = (half.middle(), half.sample);
                }
                sums.add(&half, 1.0);
                parts.push(half);
            }
        }
        (peak > 0.0).then(|| Variation { at, deviation: peak, width: sums.integral() / peak })
    }

    /// Bounds the deviation from a polynomial in a part of an interval.
    ///
    /// The bounds are those of the values, of the mean value theorem and of Taylor's theorem about the middle.
    fn part(&self, from: &Polynomial, a: f64, b: f64, weighted: bool) -> Part {
        let (c, r) = (0.5 * (a + b), 0.5 * (b - a));
        let (f, p, bounds) = (self.at(c), from.at(c), self.bounds(a, b));
        let bend = from.at(a).acceleration.abs().max(from.at(b).acceleration.abs());
        let sample = Some((f.value - p.value).abs()).filter(|x| x.is_finite()).unwrap_or(0.0);
        let reach = r * (p.rate.abs() + r * bend);
        let of_value = bounds.value - Interval::between(p.value - reach, p.value + reach);
        let of_rate = bounds.rate - Interval::between(p.rate - r * bend, p.rate + r * bend);
        let of_acceleration =
            bounds.acceleration - Interval::between(from.at(a).acceleration, from.at(b).acceleration);
        // Largest differences of the deviation in the part from that in the middle.
        let of_rate = r * of_rate.magnitude();
        let of_acceleration = r * (f.rate - p.rate).abs() + 0.5 * r * r * of_acceleration.magnitude();
        let spread = of_rate.min(of_acceleration);
        let bound = of_value.magnitude().min(sample + spread);
        let least = (sample - spread).max(of_value.least_magnitude()).max(0.0);
        let weight = if weighted { b - a } else { 1.0 };
        Part { a, b, sample, bound, least, largest: f.value.abs(), weight }
    }

    /// Samples the deviation of a user-defined function.
    fn sampled(
        &self,
        cubic: &Polynomial,
        line: &Polynomial,
        (from, h): (f64, f64),
        count: usize,
        limit: f64,
    ) -> Option<Variation> {
        let (mut is_unseen, mut sum) = (false, 0.0);
        let mut largest = Variation { at: from, deviation: 0.0, width: 0.0 };
        for i in 0..count {
            let t = from + h * (i as f64 + 0.5) / count as f64;
            let value = self.value(t);
            is_unseen |= (value - cubic.at(t).value).abs() > limit.max(NEGLIGIBLE * value.abs());
            let deviation = (value - line.at(t).value).abs();
            sum += deviation;
            if deviation > largest.deviation {
                (largest.at, largest.deviation) = (t, deviation);
            }
        }
        largest.width = h * sum / count as f64 / largest.deviation;
        (is_unseen && largest.width.is_finite()).then_some(largest)
    }

    /// Bounds value and rates over an interval without breaks.
    pub(crate) fn bounds(&self, a: f64, b: f64) -> FunctionBounds {
        let time = FunctionBounds::time(Interval::between(a, b));
        match self {
            Self::Constant(value) => FunctionBounds::number(*value),
            Self::Sine { frequency, phase } => {
                let angle = time.two(Binary::Product, FunctionBounds::number(TAU * frequency));
                angle.two(Binary::Sum, FunctionBounds::number(*phase)).one(Unary::Sin)
            }
            Self::Expression { formula, unit } => {
                let t = time.value * Interval::point(*unit);
                formula.bounds(FunctionBounds::time(t)).with_scaled_rates(*unit)
            }
            Self::Integral(integral) => {
                let FunctionBounds { value, rate, .. } = integral.integrand().bounds(a, b);
                FunctionBounds { value: Interval::ENTIRE, rate: value, acceleration: rate }
            }
            Self::Table(_)
            | Self::Ramp { .. }
            | Self::Step { .. }
            | Self::External { .. }
            | Self::Input(_) => FunctionBounds::jump(Interval::ENTIRE),
        }
    }
}

/// Sums over the parts of an interval.
#[derive(Debug, Default)]
struct Sums {
    /// Integrals of the bound, of the samples in the middles, and of a lower bound.
    bound: f64,
    sample: f64,
    least: f64,
    /// Number of parts without a bound.
    unbounded: u32,
}

impl Sums {
    /// Adds a part, or removes it with the sign −1.
    fn add(&mut self, part: &Part, sign: f64) {
        let width = sign * (part.b - part.a);
        match (part.bound.is_finite(), sign > 0.0) {
            (true, _) => self.bound += width * part.bound,
            (false, true) => self.unbounded += 1,
            (false, false) => self.unbounded -= 1,
        }
        self.sample += width * part.sample;
        self.least += width * part.least;
    }

    fn are_sharp(&self) -> bool {
        self.unbounded == 0 && self.bound <= SHARPNESS * self.least
    }

    fn integral(&self) -> f64 {
        if self.unbounded == 0 { self.bound } else { self.sample }
    }
}

/// Part of an interval.
#[derive(Clone, Copy, Debug)]
struct Part {
    a: f64,
    b: f64,
    /// Deviation in the middle, and its bounds in the part.
    sample: f64,
    bound: f64,
    least: f64,
    /// Magnitude of the function in the middle.
    largest: f64,
    weight: f64,
}

impl Part {
    fn middle(&self) -> f64 {
        0.5 * (self.a + self.b)
    }

    /// Returns both halves, or none below a size.
    fn halves(&self, smallest: f64) -> impl Iterator<Item = (f64, f64)> + use<> {
        let (a, b, c) = (self.a, self.b, self.middle());
        let is_divisible = b - a > smallest && a < c && c < b;
        [(a, c), (c, b)].into_iter().filter(move |_| is_divisible)
    }
}

impl PartialEq for Part {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Part {}

impl PartialOrd for Part {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Part {
    fn cmp(&self, other: &Self) -> Ordering {
        (self.weight * self.bound).total_cmp(&(other.weight * other.bound)).then(other.a.total_cmp(&self.a))
    }
}

/// Cubic polynomial on an interval.
struct Polynomial {
    from: f64,
    /// Coefficients of powers of t − from.
    c: [f64; 4],
}

impl Polynomial {
    fn cubic(from: f64, to: f64, a: &FunctionValue, b: &FunctionValue) -> Self {
        let h = to - from;
        let slope = (b.value - a.value) / h;
        let square = (3.0 * slope - 2.0 * a.rate - b.rate) / h;
        let cube = (a.rate + b.rate - 2.0 * slope) / (h * h);
        Self { from, c: [a.value, a.rate, square, cube] }
    }

    fn line(from: f64, to: f64, a: &FunctionValue, b: &FunctionValue) -> Self {
        Self { from, c: [a.value, (b.value - a.value) / (to - from), 0.0, 0.0] }
    }

    fn at(&self, t: f64) -> FunctionValue {
        let ([c0, c1, c2, c3], x) = (self.c, t - self.from);
        FunctionValue {
            value: c0 + x * (c1 + x * (c2 + x * c3)),
            rate: c1 + x * (2.0 * c2 + x * 3.0 * c3),
            acceleration: 2.0 * c2 + 6.0 * x * c3,
        }
    }
}
