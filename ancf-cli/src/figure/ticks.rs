//! Ranges, the mapping of values to pixels, and sensible ticks.

use super::Scale;
use super::svg::text_width;

/// Font size of tick numbers in CSS pixels.
pub(super) const TICK_SIZE: f64 = 11.0;

/// The text at a tick.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum TickText {
    /// A number as it is.
    Plain(String),
    /// A power of ten by its exponent.
    Power(i32),
}

impl TickText {
    /// Width in CSS pixels.
    pub(super) fn width(&self) -> f64 {
        match self {
            Self::Plain(text) => text_width(text, TICK_SIZE),
            Self::Power(n) => text_width("10", TICK_SIZE) + text_width(&n.to_string(), 0.8 * TICK_SIZE),
        }
    }
}

/// The ticks of one axis.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Ticks {
    /// Values with a number.
    pub(super) major: Vec<(f64, TickText)>,
    /// Values with a short stroke only.
    pub(super) minor: Vec<f64>,
    /// Exponent of the power of ten to multiply the numbers by; zero for none.
    pub(super) factor: i32,
}

impl Ticks {
    /// Width of the widest number in CSS pixels.
    pub(super) fn width(&self) -> f64 {
        let widths = self.major.iter().map(|(_, text)| text.width());
        widths.fold(0.0, f64::max)
    }
}

/// Maps the values of one axis to pixels from its beginning.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Span {
    /// Lower end; its decimal logarithm on a logarithmic axis.
    pub(super) lo: f64,
    /// Upper end; its decimal logarithm on a logarithmic axis.
    pub(super) hi: f64,
    pub(super) scale: Scale,
}

impl Span {
    /// The place of a value, 0 at the lower and 1 at the upper end.
    pub(super) fn place(&self, value: f64) -> Option<f64> {
        let v = match self.scale {
            Scale::Linear => value,
            Scale::Log if value > 0.0 => value.log10(),
            Scale::Log => return None,
        };
        let place = (v - self.lo) / (self.hi - self.lo);
        place.is_finite().then(|| place.clamp(-1e4, 1e4))
    }

    /// A span of the fixed range, if that is usable, or else one that holds the values.
    pub(super) fn of(
        values: impl Iterator<Item = f64>,
        scale: Scale,
        range: Option<(f64, f64)>,
        room: f64,
    ) -> Self {
        let log = scale == Scale::Log;
        let usable = |v: f64| v.is_finite() && (!log || v > 0.0);
        if let Some((a, b)) = range.filter(|&(a, b)| usable(a) && usable(b) && a != b) {
            let (a, b) = if log { (a.log10(), b.log10()) } else { (a, b) };
            return Self { lo: a.min(b), hi: a.max(b), scale };
        }
        let none = (f64::INFINITY, f64::NEG_INFINITY);
        let (lo, hi) = values.filter(|&v| usable(v)).fold(none, |(lo, hi), v| (lo.min(v), hi.max(v)));
        match (lo <= hi, log) {
            (false, false) => Self::linear(0.0, 1.0, 0.0),
            (false, true) => Self::log(1.0, 10.0, 0.0),
            (true, false) => Self::linear(lo, hi, room),
            (true, true) => Self::log(lo, hi, room),
        }
    }

    /// A linear span with `room` (a share of it) at both ends, widened to a near round value.
    fn linear(lo: f64, hi: f64, room: f64) -> Self {
        let size = lo.abs().max(hi.abs());
        let (mut a, mut b) = (lo, hi);
        if hi - lo <= 1e-9 * size || hi == lo {
            let by = if size > 0.0 { 0.1 * size } else { 1.0 };
            (a, b) = (lo - by, hi + by);
        } else {
            a -= room * (hi - lo);
            b += room * (hi - lo);
        }
        if lo >= 0.0 && a < 0.0 {
            a = 0.0;
        }
        if hi <= 0.0 && b > 0.0 {
            b = 0.0;
        }
        let snap = step_for(b - a, 5.0).0 / 2.0;
        let (low, high) = ((a / snap).floor() * snap, (b / snap).ceil() * snap);
        let near = if room > 0.0 { 0.06 } else { 0.02 } * (b - a);
        Self {
            lo: if a - low <= near { low } else { a },
            hi: if high - b <= near { high } else { b },
            scale: Scale::Linear,
        }
    }

    /// A logarithmic span with `room` at both ends, out to 1, 2 or 5 times a power of ten.
    fn log(lo: f64, hi: f64, room: f64) -> Self {
        let snap = |v: f64, up: bool| {
            let marks = [0.0, 2.0_f64.log10(), 5.0_f64.log10(), 1.0].map(|m| v.floor() + m);
            let below = marks.iter().rev().find(|&&m| m <= v + 1e-9);
            let above = marks.iter().find(|&&m| m >= v - 1e-9);
            *if up { above } else { below }.unwrap_or(&v)
        };
        let (lo, hi) = (lo.log10(), hi.log10());
        let more = room * (hi - lo);
        let (mut a, mut b) = (snap(lo - more, false), snap(hi + more, true));
        if b - a < 0.3 {
            (a, b) = (a - 0.3, b + 0.3);
        }
        Self { lo: a, hi: b, scale: Scale::Log }
    }

    /// The ticks for an axis of `length` CSS pixels with about `apart` pixels between them.
    pub(super) fn ticks(&self, length: f64, apart: f64, horizontal: bool) -> Ticks {
        if !length.is_finite() {
            return Ticks::default();
        }
        let mut wanted = (length / apart).clamp(2.0, 12.0);
        loop {
            let ticks = match self.scale {
                Scale::Linear => self.linear_ticks(wanted),
                Scale::Log => self.log_ticks(wanted),
            };
            let room = length / (ticks.major.len().max(2) - 1) as f64;
            if wanted <= 2.0 || !horizontal || ticks.width() + 14.0 <= room {
                return ticks;
            }
            wanted -= 1.0;
        }
    }

    fn linear_ticks(&self, wanted: f64) -> Ticks {
        let (step, parts) = step_for(self.hi - self.lo, wanted);
        let size = self.lo.abs().max(self.hi.abs());
        let decade = size.log10().floor();
        let factor = if (-2.0..5.0).contains(&decade) || !decade.is_finite() { 0 } else { decade as i32 };
        let unit = 10f64.powi(factor);
        let decimals = (-(step / unit).log10() - 1e-9).ceil().clamp(0.0, 12.0) as usize;
        let mut ticks = Ticks { factor, ..Ticks::default() };
        let minor = step / parts;
        let edge = 1e-6 * step;
        let first = ((self.lo - edge) / minor).ceil() as i64;
        let last = ((self.hi + edge) / minor).floor() as i64;
        for i in first..=last.min(first.saturating_add(400)) {
            let value = i as f64 * minor;
            if i % parts as i64 == 0 {
                let text = TickText::Plain(decimal(value / unit, decimals));
                ticks.major.push((value, text));
            } else {
                ticks.minor.push(value);
            }
        }
        ticks
    }

    fn log_ticks(&self, wanted: f64) -> Ticks {
        let decades = self.hi - self.lo;
        let (low, high) = (self.lo.floor() as i32, self.hi.ceil() as i32);
        let every = (decades / wanted).ceil().max(1.0) as i32;
        let plain = low >= -3 && high <= 4 && every == 1;
        let numbered: &[u32] = match decades {
            d if d < 1.6 && plain => &[1, 2, 5],
            _ => &[1],
        };
        let mut ticks = Ticks::default();
        for n in low..=high {
            for m in 1..10 {
                let value = f64::from(m) * 10f64.powi(n);
                let place = value.log10();
                if place < self.lo - 1e-9 || place > self.hi + 1e-9 {
                    continue;
                }
                if numbered.contains(&m) && n % every == 0 {
                    let text = if plain {
                        TickText::Plain(decimal(value, (-n).max(0) as usize))
                    } else {
                        TickText::Power(n)
                    };
                    ticks.major.push((value, text));
                } else if m == 1 || every == 1 && decades < 9.0 {
                    ticks.minor.push(value);
                }
            }
        }
        ticks
    }
}

/// A round step that cuts `size` into about `wanted` parts, and its number of minor parts.
fn step_for(size: f64, wanted: f64) -> (f64, f64) {
    let raw = size / wanted;
    let decade = 10f64.powf(raw.log10().floor());
    let rounds = [(1.0, 5.0), (2.0, 4.0), (5.0, 5.0), (10.0, 5.0)];
    let fit = rounds.iter().find(|r| r.0 * decade >= raw * 0.999);
    let (round, parts) = fit.copied().unwrap_or((10.0, 5.0));
    (round * decade, parts)
}

/// A number with a true minus sign.
fn decimal(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| matches!(c, '0' | '.')) => rest.to_owned(),
        Some(rest) => format!("\u{2212}{rest}"),
        None => text,
    }
}
