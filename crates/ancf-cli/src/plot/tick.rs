//! Ticks of an axis.

/// Ticks of an axis whose ends are those of the data.
#[derive(Debug)]
pub struct AxisTicks {
    range: [f64; 2],
    /// Positions.
    places: Vec<f64>,
    digits: usize,
    is_scientific: bool,
}

impl AxisTicks {
    /// Creates about `steps` steps of 1, 2 or 5 times a power of ten within a range.
    pub fn within([lo, hi]: [f64; 2], steps: usize) -> Self {
        let (lo, hi) = if lo <= hi { (lo, hi) } else { (0.0, 1.0) };
        // A constant, up to rounding, gets a range around it.
        let least = (1e-9 * lo.abs().max(hi.abs())).max(f64::MIN_POSITIVE * 1e30);
        let (lo, hi) = if hi - lo > least { (lo, hi) } else { wider(lo, hi) };
        let step = nice((hi - lo) / steps.max(1) as f64);
        let (first, last) = ((lo / step - 1e-6).ceil(), (hi / step + 1e-6).floor());
        let count = (last - first).clamp(0.0, 1000.0) as usize;
        let places: Vec<f64> = (0..=count).map(|k| ((first + k as f64) * step).clamp(lo, hi)).collect();
        let most = lo.abs().max(hi.abs());
        let is_scientific = !(1e-3..1e5).contains(&most);
        let scale = if is_scientific { most.log10().floor() } else { 0.0 };
        let digits = (scale - (step * 1.000_001).log10().floor()).clamp(0.0, 15.0) as usize;
        Self { range: [lo, hi], places, digits, is_scientific }
    }

    /// Returns both ends.
    pub const fn range(&self) -> [f64; 2] {
        self.range
    }

    /// Returns positions and texts.
    pub fn labels(&self) -> Vec<(f64, String)> {
        let text = |&place: &f64| {
            let digits = self.digits;
            let text = match place {
                0.0 => "0".to_owned(),
                _ if self.is_scientific => format!("{place:.digits$e}"),
                _ => format!("{place:.digits$}"),
            };
            (place, text)
        };
        self.places.iter().map(text).collect()
    }
}

/// Widens a range without extent.
fn wider(lo: f64, hi: f64) -> (f64, f64) {
    let more = if lo == 0.0 && hi == 0.0 { 1.0 } else { 0.1 * lo.abs().max(hi.abs()) };
    (lo - more, hi + more)
}

/// Returns 1, 2 or 5 times a power of ten that is not less than `step`.
fn nice(step: f64) -> f64 {
    let decade = 10f64.powf(step.log10().floor());
    let factor = [1.0, 2.0, 5.0].into_iter().find(|factor| factor * decade >= 0.999_999 * step);
    factor.unwrap_or(10.0) * decade
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_numbers_within_the_range() {
        let texts = |lo, hi, steps| {
            let ticks = AxisTicks::within([lo, hi], steps);
            assert_eq!(ticks.range(), [lo, hi]);
            assert!(ticks.places.iter().all(|place| (lo..=hi).contains(place)));
            ticks.labels().into_iter().map(|(_, text)| text).collect::<Vec<_>>()
        };
        assert_eq!(texts(0.0, 2.0, 4), ["0", "0.5", "1.0", "1.5", "2.0"]);
        assert_eq!(texts(0.0, 3.5, 4), ["0", "1", "2", "3"]);
        assert_eq!(texts(-0.0041, 0.0, 3), ["-0.004", "-0.002", "0"]);
        assert_eq!(texts(0.0, 1.9e-4, 2), ["0", "1e-4"]);
        for constant in [0.0, -3e-320, 1e308, 7.3, 5.0] {
            let ticks = AxisTicks::within([constant, constant], 4);
            let [lo, hi] = ticks.range();
            assert!(lo < hi && lo <= constant && constant <= hi, "{constant}: {lo} {hi}");
            assert!(ticks.places.len() > 1, "{constant}");
        }
    }
}
