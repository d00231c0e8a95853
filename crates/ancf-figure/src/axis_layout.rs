//! Limits, ticks and tick labels of an axis.

use std::sync::Arc;

use kuva::render::layout::TickFormat;
use kuva::render::render_utils::{compute_tick_step, generate_minor_ticks, generate_ticks_with_step};

use crate::polyline::Point;
use crate::types::{AxisScale, FigureAxis};

/// Axis in drawn numbers: the values times `unit`, a power of ten.
///
/// On a linear axis the unit keeps the tick labels short. On a logarithmic axis it keeps the numbers above one, because `kuva`
/// clamps at 1e-10.
pub(crate) struct AxisLayout {
    pub(crate) range: Point,
    pub(crate) log: bool,
    pub(crate) unit: f64,
    pub(crate) step: Option<f64>,
    pub(crate) format: TickFormat,
    /// Power of ten by which the tick labels must be multiplied, if any.
    pub(crate) note: String,
}

impl AxisLayout {
    /// Fits an axis of about `parts` steps to values, with the relative margin `margin` at both ends.
    pub(crate) fn new(axis: &FigureAxis, values: impl Iterator<Item = f64>, margin: f64, parts: f64) -> Self {
        let log = axis.scale == AxisScale::Log;
        let usable = |v: &f64| v.is_finite() && (*v > 1e-300 || !log);
        let ends = |(lo, hi): Point, v: f64| (lo.min(v), hi.max(v));
        let data = values.filter(usable).fold((f64::INFINITY, f64::NEG_INFINITY), ends);
        let data = if data.0 <= data.1 { data } else { if log { (1.0, 10.0) } else { (0.0, 1.0) } };
        let fixed = axis.range.filter(|r| r.0 < r.1 && usable(&r.0) && usable(&r.1));
        let parts = parts.max(2.0);
        if log { Self::log(data, fixed, parts) } else { Self::linear(data, fixed, margin, parts) }
    }

    fn linear((lo, hi): Point, fixed: Option<Point>, margin: f64, parts: f64) -> Self {
        let more = if hi > lo { margin * (hi - lo) } else { (0.1 * lo.abs()).max(f64::from(lo == 0.0)) };
        let start = if lo >= 0.0 { (lo - more).max(0.0) } else { lo - more };
        let (mut lo, mut hi) = fixed.unwrap_or((start, hi + more));
        let step = nice_step(lo, hi, parts);
        // A limit close to a labelled tick is moved to the tick.
        let to_tick = |end: f64| {
            if fixed.is_none() && (end - (end / step).round() * step).abs() < 0.01 * (hi - lo) {
                (end / step).round() * step
            } else {
                end
            }
        };
        (lo, hi) = (to_tick(lo), to_tick(hi));
        let most = (lo.abs().max(hi.abs()) * 1.000_001).log10().floor() as i32;
        let power = if (-2..=4).contains(&most) { 0 } else { most };
        let unit = 10f64.powi(-power);
        let (range, step) = ((lo * unit, hi * unit), step * unit);
        let places = (-(step * 1.000_001).log10().floor()).clamp(0.0, 12.0) as usize;
        let format = TickFormat::Custom(Arc::new(move |v| minus(format!("{v:.places$}"))));
        let note = if power == 0 { String::new() } else { format!("×{}", power_of_ten(power)) };
        Self { range, log: false, unit, step: Some(step), format, note }
    }

    fn log(data: Point, fixed: Option<Point>, parts: f64) -> Self {
        let one_two_five = |v: f64, up: bool| {
            let decade = 10f64.powf(v.log10().floor());
            let mut nice = [1.0, 2.0, 5.0, 10.0].map(|m| m * decade).into_iter();
            let best = if up { nice.find(|n| *n >= v * 0.999) } else { nice.rfind(|n| *n <= v * 1.001) };
            best.unwrap_or(v)
        };
        let (lo, hi) = fixed.unwrap_or((one_two_five(data.0 / 1.1, false), one_two_five(data.1 * 1.1, true)));
        let shift = -lo.log10().floor() as i32;
        let decades = (hi / lo).log10();
        let every = (0.6 * decades / parts).ceil().max(1.0) as i32;
        let plain = lo > 0.9e-3 && hi < 1.1e4;
        let format = move |v: f64| {
            let raised = (v.log10() + 1e-9).floor() as i32;
            let (digit, power) = ((v / 10f64.powi(raised)).round(), raised - shift);
            match digit as i32 {
                1 if power.rem_euclid(every) != 0 => String::new(),
                2.. if decades > 2.0 => String::new(),
                _ if plain => format!("{:.*}", (-power).max(0) as usize, digit * 10f64.powi(power)),
                1 => power_of_ten(power),
                _ => format!("{digit}·{}", power_of_ten(power)),
            }
        };
        let unit = 10f64.powi(shift);
        let format = TickFormat::Custom(Arc::new(format));
        Self { range: (lo * unit, hi * unit), log: true, unit, step: None, format, note: String::new() }
    }

    /// Converts a value into drawn numbers. `None` if it cannot be drawn.
    pub(crate) fn at(&self, value: f64) -> Option<f64> {
        let drawn = value * self.unit;
        (drawn.is_finite() && (drawn > 0.0 || !self.log)).then_some(drawn)
    }

    /// Returns both limits in the unit of the data.
    pub(crate) fn ends(&self) -> Point {
        (self.range.0 / self.unit, self.range.1 / self.unit)
    }

    /// Returns positions, in the unit of the data, and texts of the tick labels of a linear axis.
    pub(crate) fn tick_labels(&self) -> Vec<(f64, String)> {
        let step = self.step.unwrap_or(f64::NAN);
        let drawn = generate_ticks_with_step(self.range.0, self.range.1, step);
        drawn.into_iter().map(|v| (v / self.unit, self.format.format(v))).collect()
    }

    /// Returns the minor ticks from `lo` to `hi`, in drawn numbers.
    pub(crate) fn minor_ticks(&self, (lo, hi): Point) -> Vec<f64> {
        let (long, parts) = match self.step {
            Some(step) => {
                let two = (step.log10().rem_euclid(1.0) - 2f64.log10()).abs() < 1e-6;
                (generate_ticks_with_step(lo - step, hi + step, step), if two { 4 } else { 5 })
            }
            None => ((0..=hi.log10().ceil() as i32).map(|e| 10f64.powi(e)).collect(), 9),
        };
        generate_minor_ticks(&long, parts).into_iter().filter(|v| (lo..=hi).contains(v)).collect()
    }
}

/// Returns 1, 2 or 5 times a power of ten, for about `parts` steps.
fn nice_step(lo: f64, hi: f64, parts: f64) -> f64 {
    let step = compute_tick_step(lo, hi, parts as usize);
    let digit = step / 10f64.powf(step.log10().floor());
    if (digit - 2.5).abs() < 1e-6 { 0.8 * step } else { step }
}

/// Formats a power of ten with superscript digits.
fn power_of_ten(exponent: i32) -> String {
    let raised = |c: char| c.to_digit(10).and_then(|d| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(d as usize)).unwrap_or('⁻');
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

/// Replaces the hyphen by a minus sign. Zero has no sign.
fn minus(number: String) -> String {
    let is_zero = !number.contains(|c: char| ('1'..='9').contains(&c));
    number.replace('-', if is_zero { "" } else { "\u{2212}" })
}
