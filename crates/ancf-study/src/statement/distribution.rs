//! Values by a rule: distributed ones by their quantiles, and those of a range.
//!
//! Logarithms and exponentials are those of `libm`, so that every machine finds the same digits.

use ancf::ModelError;
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Value;

/// A rule for the values of a parameter.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Rule {
    /// So many values at equal distances.
    Range {
        /// The first value.
        from: f64,
        /// The last value.
        to: f64,
        /// How many values.
        #[schemars(range(min = 2, max = 10_000_000))]
        count: u32,
    },
    /// So many values at equal ratios.
    Logarithmic {
        /// The first value.
        from: f64,
        /// The last value.
        to: f64,
        /// How many values.
        #[schemars(range(min = 2, max = 10_000_000))]
        count: u32,
    },
    /// All values between two are equally likely.
    Uniform {
        /// The least value.
        low: f64,
        /// The largest value.
        high: f64,
    },
    /// The normal distribution.
    Normal {
        /// Mean of the values.
        mean: f64,
        /// Standard deviation of the values.
        #[schemars(extend("exclusiveMinimum" = 0))]
        deviation: f64,
    },
    /// The distribution of positive values whose logarithms are normally distributed.
    Lognormal {
        /// Mean of the values, not of their logarithms.
        #[schemars(extend("exclusiveMinimum" = 0))]
        mean: f64,
        /// Standard deviation of the values, not of their logarithms.
        #[schemars(extend("exclusiveMinimum" = 0))]
        deviation: f64,
    },
    /// Values between two, with a density that rises to the mode and falls behind it.
    Triangular {
        /// The least value.
        low: f64,
        /// The likeliest value.
        mode: f64,
        /// The largest value.
        high: f64,
    },
}

impl Rule {
    /// What is wrong with its numbers: the key, what was found, what is wanted.
    pub fn faults(&self) -> Vec<(&'static str, f64, String)> {
        let mut faults = Vec::new();
        let mut check = |holds: bool, key, x, wanted: String| {
            if !holds {
                faults.push((key, x, wanted));
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
        faults
    }

    /// The same as errors of the model's kind, at a path.
    pub fn errors(&self, path: &str) -> impl Iterator<Item = ModelError> {
        self.faults()
            .into_iter()
            .map(move |(key, x, wanted)| ModelError::new(format!("{path}.{key}"), x.to_string(), wanted))
    }

    /// The values of a range; `None` of a distribution.
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
        Some((0..count).map(|k| whole(value(k))).collect())
    }

    /// How many values a range has; `None` of a distribution.
    pub const fn count(&self) -> Option<usize> {
        match *self {
            Self::Range { count, .. } | Self::Logarithmic { count, .. } => Some(count as usize),
            _ => None,
        }
    }

    /// The first value of a range; the median of a distribution.
    pub fn first(&self) -> Value {
        match *self {
            Self::Range { from, .. } | Self::Logarithmic { from, .. } => whole(from),
            _ => Value::Float(self.quantile(0.5)),
        }
    }

    /// The value that a part p of all values lies below, 0 < p < 1; not a number of a range.
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

/// A number; an integer where only the rounding of the range tells it from one, which models take for numbers too.
fn whole(x: f64) -> Value {
    let near = x.round();
    let is_whole = near.abs() < 1e15 && (x - near).abs() <= 1e-13 * near.abs();
    if is_whole { Value::Integer(near as i64) } else { Value::Float(x) }
}

/// A polynomial, its coefficients from that of the highest power on.
fn polynomial<const N: usize>(coefficients: [f64; N], x: f64) -> f64 {
    coefficients.into_iter().fold(0.0, |sum, coefficient| sum * x + coefficient)
}

/// Quantile of the standard normal distribution to about 1e-16. Source: Wichura (1988), algorithm AS 241, PPND16.
fn normal_quantile(p: f64) -> f64 {
    let q = p - 0.5;
    if q.abs() <= 0.425 {
        let r = 0.180625 - q * q;
        return q * polynomial(CENTRE[0], r) / polynomial(CENTRE[1], r);
    }
    let r = (-libm::log(if q < 0.0 { p } else { 1.0 - p })).sqrt();
    let ([above, below], x) = if r <= 5.0 { (NEAR, r - 1.6) } else { (FAR, r - 5.0) };
    (polynomial(above, x) / polynomial(below, x)).copysign(q)
}

/// Numerator and denominator for |p - 1/2| <= 0.425.
const CENTRE: [[f64; 8]; 2] = [
    [
        2.509_080_928_730_122_7e3,
        3.343_057_558_358_813e4,
        6.726_577_092_700_87e4,
        4.592_195_393_154_987e4,
        1.373_169_376_550_946e4,
        1.971_590_950_306_551_3e3,
        1.331_416_678_917_843_8e2,
        3.387_132_872_796_366_5,
    ],
    [
        5.226_495_278_852_854e3,
        2.872_908_573_572_194_3e4,
        3.930_789_580_009_271e4,
        2.121_379_430_158_659_7e4,
        5.394_196_021_424_751e3,
        6.871_870_074_920_579e2,
        4.231_333_070_160_091e1,
        1.0,
    ],
];

/// The same for sqrt(-ln p) <= 5.
const NEAR: [[f64; 8]; 2] = [
    [
        7.745_450_142_783_414e-4,
        2.272_384_498_926_918_4e-2,
        2.417_807_251_774_506e-1,
        1.270_458_252_452_368_4,
        3.647_848_324_763_204_5,
        5.769_497_221_460_691,
        4.630_337_846_156_546,
        1.423_437_110_749_683_5,
    ],
    [
        1.050_750_071_644_416_9e-9,
        5.475_938_084_995_345e-4,
        1.519_866_656_361_645_7e-2,
        1.481_039_764_274_800_8e-1,
        6.897_673_349_851e-1,
        1.676_384_830_183_803_8,
        2.053_191_626_637_759,
        1.0,
    ],
];

/// The same beyond.
const FAR: [[f64; 8]; 2] = [
    [
        2.010_334_399_292_288_1e-7,
        2.711_555_568_743_487_6e-5,
        1.242_660_947_388_078_4e-3,
        2.653_218_952_657_612_4e-2,
        2.965_605_718_285_048_7e-1,
        1.784_826_539_917_291_3,
        5.463_784_911_164_114,
        6.657_904_643_501_103,
    ],
    [
        2.044_263_103_389_939_7e-15,
        1.421_511_758_316_446e-7,
        1.846_318_317_510_054_8e-5,
        7.868_691_311_456_133e-4,
        1.487_536_129_085_061_5e-2,
        1.369_298_809_227_358e-1,
        5.998_322_065_558_88e-1,
        1.0,
    ],
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Quantiles by Python's `statistics.NormalDist` and, of the tails, tables of the normal distribution.
    #[test]
    fn quantiles_are_those_of_the_distributions() {
        let normal = Rule::Normal { mean: 0.0, deviation: 1.0 };
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
        let triangular = Rule::Triangular { low: 0.0, mode: 1.0, high: 4.0 };
        assert_eq!(triangular.quantile(0.25), 1.0, "a quarter of the area is before the mode");
        assert!((triangular.quantile(0.0625) - 0.5).abs() < 1e-15, "the area grows with the square");
        assert_eq!(Rule::Uniform { low: -1.0, high: 3.0 }.quantile(0.25), 0.0);
    }

    /// Mean and deviation by integration of the quantile over p.
    #[test]
    fn mean_and_deviation_are_those_of_the_values() {
        let n = 200_000;
        for (rule, mean, deviation) in [
            (Rule::Normal { mean: 5.0, deviation: 2.0 }, 5.0, 2.0),
            (Rule::Lognormal { mean: 5.0, deviation: 2.0 }, 5.0, 2.0),
            (Rule::Uniform { low: 0.0, high: 1.0 }, 0.5, 12.0_f64.recip().sqrt()),
            (Rule::Triangular { low: 0.0, mode: 0.0, high: 1.0 }, 1.0 / 3.0, 18.0_f64.recip().sqrt()),
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
        let values = |rule: Rule| rule.values().unwrap();
        let integers = |list: &[i64]| list.iter().map(|&x| Value::Integer(x)).collect::<Vec<_>>();
        assert_eq!(values(Rule::Range { from: 1.0, to: 9.0, count: 3 }), integers(&[1, 5, 9]));
        assert_eq!(
            values(Rule::Logarithmic { from: 1.0, to: 1000.0, count: 4 }),
            integers(&[1, 10, 100, 1000])
        );
        let fine = values(Rule::Range { from: 0.1, to: 0.3, count: 3 });
        assert_eq!(fine, [0.1, 0.2, 0.3].map(Value::Float), "no rounding of 0.1 + 0.1");
    }
}
