//! Pseudo-random samples that are the same on every machine.
//!
//! Each number is a hash of the seed, the path of the parameter and the index. It is independent of the other parameters.

use std::hash::Hasher;

use schemars::JsonSchema;
use serde::Deserialize;
use siphasher::sip::SipHasher24;

use super::sobol::sobol_points;

/// Sampling method of the distributions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sampling {
    /// Latin hypercube: one sample in each of `n` equally likely intervals (McKay, Beckman & Conover 1979).
    #[default]
    LatinHypercube,
    /// Independent samples.
    Random,
    /// Scrambled Sobol sequence of all parameters together (Sobol 1967, Owen 1998).
    Sobol,
}

impl Sampling {
    /// Returns `count` probabilities of each parameter, 0 < p < 1. Their quantiles are the samples.
    ///
    /// The probabilities of a parameter depend on the seed and on its path. Those of a Sobol sequence depend on the seed and on the
    /// position of the parameter.
    pub fn probabilities(self, count: u32, seed: u32, parameters: &[&str]) -> Vec<Vec<f64>> {
        match self {
            Self::Sobol => sobol_points(parameters.len(), count, seed),
            Self::LatinHypercube => {
                parameters.iter().map(|parameter| latin_hypercube(count, seed, parameter)).collect()
            }
            Self::Random => parameters.iter().map(|parameter| random(count, seed, parameter)).collect(),
        }
    }
}

/// Returns a number between 0 and 1 from 52 bits and one half: neither 0 nor 1.
fn unit(seed: u32, parameter: &str, k: u32) -> f64 {
    ((hash(seed, parameter, "place", k) >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
}

fn random(count: u32, seed: u32, parameter: &str) -> Vec<f64> {
    (0..count).map(|k| unit(seed, parameter, k)).collect()
}

/// Returns one random number of each of `count` equal intervals, in random order.
fn latin_hypercube(count: u32, seed: u32, parameter: &str) -> Vec<f64> {
    let mut order: Vec<u32> = (0..count).collect();
    order.sort_by_key(|&k| (hash(seed, parameter, "interval", k), k));
    let probability =
        |(k, interval): (u32, u32)| (f64::from(interval) + unit(seed, parameter, k)) / f64::from(count);
    let below_one = 1.0 - 0.5 * f64::EPSILON;
    (0..count).zip(order).map(|place| probability(place).min(below_one)).collect()
}

fn hash(seed: u32, parameter: &str, purpose: &str, k: u32) -> u64 {
    let mut hasher = SipHasher24::new_with_keys(u64::from(seed), 0);
    for text in [parameter, purpose] {
        hasher.write(text.as_bytes());
        hasher.write(&[0xFF]);
    }
    hasher.write(&k.to_le_bytes());
    hasher.finish()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every interval has one sample. The order differs between parameters.
    #[test]
    fn a_latin_hypercube_has_a_sample_in_each_interval() {
        for count in [1, 2, 7, 1000] {
            let intervals = |parameter| -> Vec<u32> {
                let samples = latin_hypercube(count, 1, parameter);
                samples.iter().map(|p| (p * f64::from(count)) as u32).collect()
            };
            let mut sorted = intervals("a");
            sorted.sort_unstable();
            assert_eq!(sorted, (0..count).collect::<Vec<_>>());
            assert!(count < 7 || intervals("a") != intervals("b"));
        }
    }

    /// Samples of different parameters are uncorrelated, and so are a sample and its index.
    #[test]
    fn parameters_are_not_correlated() {
        let n = 10_000;
        for sampling in [Sampling::LatinHypercube, Sampling::Random, Sampling::Sobol] {
            let [a, b]: [Vec<f64>; 2] = sampling.probabilities(n, 1, &["a", "b"]).try_into().unwrap();
            let mean = |x: &mut dyn Iterator<Item = f64>| x.sum::<f64>() / f64::from(n);
            let correlation = 12.0 * mean(&mut a.iter().zip(&b).map(|(a, b)| (a - 0.5) * (b - 0.5)));
            let trend = 12.0
                * mean(&mut a.iter().zip(0..n).map(|(a, k)| (a - 0.5) * (f64::from(k) / f64::from(n) - 0.5)));
            // Four standard deviations.
            assert!(correlation.abs() < 0.04 && trend.abs() < 0.04, "{sampling:?}: {correlation}, {trend}");
            assert!((mean(&mut a.iter().copied()) - 0.5).abs() < 4.0 / (12.0 * f64::from(n)).sqrt());
        }
    }

    /// A larger number of random samples extends the smaller one. Another seed gives other samples.
    #[test]
    fn random_samples_are_extended() {
        let few = random(10, 1, "a");
        assert_eq!(few, random(20, 1, "a")[..10]);
        assert!(few.iter().zip(random(10, 2, "a")).all(|(a, b)| *a != b));
    }

    /// The samples of a parameter do not depend on the other parameters, except in a Sobol sequence.
    #[test]
    fn other_parameters_have_no_effect() {
        for sampling in [Sampling::LatinHypercube, Sampling::Random] {
            let alone = sampling.probabilities(10, 1, &["b"]);
            assert_eq!(sampling.probabilities(10, 1, &["a", "b", "c"])[1], alone[0], "{sampling:?}");
        }
        assert_eq!(Sampling::Sobol.probabilities(10, 1, &["a", "b"]), sobol_points(2, 10, 1));
    }

    /// SipHash-2-4 of `a`, `place`, 0 with the key 1, 0 by an independent program that gives the test vector of
    /// Aumasson & Bernstein (2012).
    #[test]
    fn samples_are_the_same_on_every_machine() {
        assert_eq!(hash(1, "a", "place", 0), 0xf2fc_4fcd_b802_ce45);
    }
}
