//! Rules for the values of a parameter: ranges, and distributions by their quantiles.
//!
//! Logarithms and exponentials are those of `libm`: every machine computes the same digits.

use ancf::ModelError;
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Value;

use super::normal_quantile::normal_quantile;

/// Rule for the values of a parameter.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ValueRule {
    /// Values at equal distances.
    Range {
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// Number of values.
        #[schemars(range(min = 2, max = 10_000_000))]
        count: u32,
    },
    /// Values at equal ratios.
    Logarithmic {
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
        /// Number of values.
        #[schemars(range(min = 2, max = 10_000_000))]
        count: u32,
    },
    /// Uniform distribution.
    Uniform {
        /// Smallest value.
        low: f64,
        /// Largest value.
        high: f64,
    },
    /// Normal distribution.
    Normal {
        /// Mean of the values.
        mean: f64,
        /// Standard deviation of the values.
        #[schemars(extend("exclusiveMinimum" = 0))]
        deviation: f64,
    },
    /// Lognormal distribution: the logarithms are normally distributed.
    Lognormal {
        /// Mean of the values, not of their logarithms.
        #[schemars(extend("exclusiveMinimum" = 0))]
        mean: f64,
        /// Standard deviation of the values, not of their logarithms.
        #[schemars(extend("exclusiveMinimum" = 0))]
        deviation: f64,
    },
    /// Triangular distribution.
    Triangular {
        /// Smallest value.
        low: f64,
        /// Most likely value.
        mode: f64,
        /// Largest value.
        high: f64,
    },
}

impl ValueRule {
    /// Returns the invalid numbers: key, value found, value required.
    fn invalid_numbers(&self) -> Vec<(&'static str, f64, String)> {
        let mut invalid = Vec::new();
        let mut check = |holds: bool, key, x, expected: String| {
            if !holds {
                invalid.push((key, x, expected));
            }
        };
        match *self {
            Self::Logarithmic { from, to, .. } => {
                check(from > 0.0, "from", from, "a number > 0".into());
                check(to > 0.0, "to", to, "a number > 0".into());
            }
            Self::Uniform { low, high } => {
                check(low < high, "high", high, format!("a number > {low}, which is `low`"));
            }
            Self::Triangular { low, mode, high } => {
                check(low < high, "high", high, format!("a number > {low}, which is `low`"));
                let between = format!("a number from {low} to {high}, which are `low` and `high`");
                check(low >= high || (low..=high).contains(&mode), "mode", mode, between);
            }
            Self::Range { .. } | Self::Normal { .. } | Self::Lognormal { .. } => {}
        }
        invalid
    }

    /// Returns the invalid numbers as errors below `path`.
    pub fn errors(&self, path: &str) -> impl Iterator<Item = ModelError> {
        self.invalid_numbers()
            .into_iter()
            .map(move |(key, x, expected)| ModelError::new(format!("{path}.{key}"), x.to_string(), expected))
    }

    /// Returns the values of a range, `None` for a distribution.
    pub fn values(&self) -> Option<Vec<Value>> {
        let (from, to, count) = match *self {
            Self::Range { from, to, count } | Self::Logarithmic { from, to, count } => (from, to, count),
            _ => return None,
        };
        let is_linear = matches!(self, Self::Range { .. });
        let value = |k: u32| {
            let part = f64::from(k) / f64::from(count - 1);
            match k {
                0 => from,
                _ if k == count - 1 => to,
                _ if is_linear => from + (to - from) * part,
                _ => from * libm::exp(part * libm::log(to / from)),
            }
        };
        Some((0..count).map(|k| integer_if_exact(value(k))).collect())
    }

    /// Returns the number of values of a range, `None` for a distribution.
    pub const fn count(&self) -> Option<usize> {
        match *self {
            Self::Range { count, .. } | Self::Logarithmic { count, .. } => Some(count as usize),
            _ => None,
        }
    }

    /// Returns the first value of a range or the median of a distribution.
    pub fn first(&self) -> Value {
        match *self {
            Self::Range { from, .. } | Self::Logarithmic { from, .. } => integer_if_exact(from),
            _ => Value::Float(self.quantile(0.5)),
        }
    }

    /// Returns the quantile of the probability `p`, 0 < p < 1. NaN for a range.
    pub fn quantile(&self, p: f64) -> f64 {
        match *self {
            Self::Range { .. } | Self::Logarithmic { .. } => f64::NAN,
            Self::Uniform { low, high } => low + p * (high - low),
            Self::Normal { mean, deviation } => mean + deviation * normal_quantile(p),
            Self::Lognormal { mean, deviation } => {
                // ln x ~ N(ln m - σ²/2, σ²), σ² = ln(1 + (d/m)²).
                let variance = libm::log1p((deviation / mean).powi(2));
                libm::exp(libm::log(mean) - 0.5 * variance + variance.sqrt() * normal_quantile(p))
            }
            Self::Triangular { low, mode, high } => {
                let (width, rise) = (high - low, mode - low);
                if p * width < rise {
                    low + (p * width * rise).sqrt()
                } else {
                    high - ((1.0 - p) * width * (high - mode)).sqrt()
                }
            }
        }
    }
}

/// Returns an integer if `x` differs from it by rounding only. Models accept integers as numbers.
fn integer_if_exact(x: f64) -> Value {
    let near = x.round();
    let is_integer = near.abs() < 1e15 && (x - near).abs() <= 1e-13 * near.abs();
    if is_integer { Value::Integer(near as i64) } else { Value::Float(x) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Quantiles by Python's `statistics.NormalDist`; tails by tables of the normal distribution.
    #[test]
    fn quantiles_are_those_of_the_distributions() {
        let normal = ValueRule::Normal { mean: 0.0, deviation: 1.0 };
        for (p, x) in [
            (0.5, 0.0),
            (0.975, 1.959963984540054),
            (0.025, -1.959963984540054),
            (1e-3, -3.090232306167813),
            (1e-15, -7.941345326170997),
        ] {
            assert!(
                (normal.quantile(p) - x).abs() <= 1e-14 * f64::max(1.0, x.abs()),
                "{p}: {}",
                normal.quantile(p)
            );
        }
        let triangular = ValueRule::Triangular { low: 0.0, mode: 1.0, high: 4.0 };
        assert_eq!(triangular.quantile(0.25), 1.0, "a quarter of the area is before the mode");
        assert!((triangular.quantile(0.0625) - 0.5).abs() < 1e-15, "the area grows with the square");
        assert_eq!(ValueRule::Uniform { low: -1.0, high: 3.0 }.quantile(0.25), 0.0);
    }

    /// Mean and standard deviation by integration of the quantile over p.
    #[test]
    fn mean_and_deviation_are_those_of_the_values() {
        let n = 200_000;
        for (rule, mean, deviation) in [
            (ValueRule::Normal { mean: 5.0, deviation: 2.0 }, 5.0, 2.0),
            (ValueRule::Lognormal { mean: 5.0, deviation: 2.0 }, 5.0, 2.0),
            (ValueRule::Uniform { low: 0.0, high: 1.0 }, 0.5, 12.0_f64.recip().sqrt()),
            (ValueRule::Triangular { low: 0.0, mode: 0.0, high: 1.0 }, 1.0 / 3.0, 18.0_f64.recip().sqrt()),
        ] {
            let values: Vec<f64> =
                (0..n).map(|k| rule.quantile((f64::from(k) + 0.5) / f64::from(n))).collect();
            let average = values.iter().sum::<f64>() / f64::from(n);
            let variance = values.iter().map(|x| (x - average).powi(2)).sum::<f64>() / f64::from(n);
            assert!((average - mean).abs() < 1e-4 * mean, "{rule:?}: mean {average}");
            assert!(
                (variance.sqrt() - deviation).abs() < 1e-3 * deviation,
                "{rule:?}: deviation {}",
                variance.sqrt()
            );
        }
    }

    #[test]
    fn ranges_are_even_and_their_ends_exact() {
        let values = |rule: ValueRule| rule.values().unwrap();
        let integers = |list: &[i64]| list.iter().map(|&x| Value::Integer(x)).collect::<Vec<_>>();
        assert_eq!(values(ValueRule::Range { from: 1.0, to: 9.0, count: 3 }), integers(&[1, 5, 9]));
        assert_eq!(
            values(ValueRule::Logarithmic { from: 1.0, to: 1000.0, count: 4 }),
            integers(&[1, 10, 100, 1000])
        );
        let fine = values(ValueRule::Range { from: 0.1, to: 0.3, count: 3 });
        assert_eq!(fine, [0.1, 0.2, 0.3].map(Value::Float), "no rounding of 0.1 + 0.1");
    }
}
