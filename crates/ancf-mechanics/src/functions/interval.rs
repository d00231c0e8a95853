use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::ops::{Add, Mul, Neg, Sub};

/// Closed interval of numbers, possibly unbounded. Results of operations contain all results for the numbers of their
/// operands, in spite of rounding.
///
/// Source: Moore (1966).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    pub(crate) lower: f64,
    pub(crate) upper: f64,
}

/// Bound of the relative rounding error of elementary functions.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

impl Interval {
    /// All numbers.
    pub(crate) const ENTIRE: Self = Self { lower: f64::NEG_INFINITY, upper: f64::INFINITY };
    pub(crate) const ZERO: Self = Self::point(0.0);

    /// Creates an interval of one number.
    pub(crate) const fn point(x: f64) -> Self {
        Self { lower: x, upper: x }
    }

    /// Creates the interval between two numbers.
    pub(crate) fn between(a: f64, b: f64) -> Self {
        if a.is_nan() || b.is_nan() { Self::ENTIRE } else { Self { lower: a.min(b), upper: a.max(b) } }
    }

    /// Creates the interval between two rounded numbers.
    fn rounded(a: f64, b: f64) -> Self {
        let Self { lower, upper } = Self::between(a, b);
        let error = |x: f64| ROUNDING * x.abs() + f64::MIN_POSITIVE;
        let down = if lower.is_finite() { lower - error(lower) } else { lower.min(f64::MAX) };
        let up = if upper.is_finite() { upper + error(upper) } else { upper.max(f64::MIN) };
        Self { lower: down, upper: up }
    }

    pub(crate) fn is_point(self) -> bool {
        self.lower == self.upper
    }

    pub(crate) fn contains(self, x: f64) -> bool {
        self.lower <= x && x <= self.upper
    }

    /// Returns the largest magnitude.
    pub(crate) fn magnitude(self) -> f64 {
        self.lower.abs().max(self.upper.abs())
    }

    /// Returns the smallest magnitude.
    pub(crate) fn least_magnitude(self) -> f64 {
        self.abs().lower
    }

    /// Returns the smallest interval that contains both.
    pub(crate) fn hull(self, other: Self) -> Self {
        Self { lower: self.lower.min(other.lower), upper: self.upper.max(other.upper) }
    }

    pub(crate) fn minimum(self, other: Self) -> Self {
        Self { lower: self.lower.min(other.lower), upper: self.upper.min(other.upper) }
    }

    pub(crate) fn maximum(self, other: Self) -> Self {
        Self { lower: self.lower.max(other.lower), upper: self.upper.max(other.upper) }
    }

    /// Evaluates a monotonic function at both ends.
    fn monotonic(self, f: impl Fn(f64) -> f64) -> Self {
        Self::rounded(f(self.lower), f(self.upper))
    }

    /// Returns a part within bounds that all exact results have.
    fn within(self, lower: f64, upper: f64) -> Self {
        Self { lower: self.lower.clamp(lower, upper), upper: self.upper.clamp(lower, upper) }
    }

    pub(crate) fn recip(self) -> Self {
        if self.contains(0.0) { Self::ENTIRE } else { self.monotonic(f64::recip) }
    }

    pub(crate) fn abs(self) -> Self {
        let lower = if self.contains(0.0) { 0.0 } else { self.lower.abs().min(self.upper.abs()) };
        Self { lower, upper: self.magnitude() }
    }

    pub(crate) fn exp(self) -> Self {
        self.monotonic(f64::exp).within(0.0, f64::INFINITY)
    }

    /// Returns the logarithm, or all numbers if the interval has numbers below 0.
    pub(crate) fn ln(self) -> Self {
        if self.lower < 0.0 { Self::ENTIRE } else { self.monotonic(f64::ln) }
    }

    /// Returns the square root, or all numbers if the interval has numbers below 0.
    pub(crate) fn sqrt(self) -> Self {
        if self.lower < 0.0 { Self::ENTIRE } else { self.monotonic(f64::sqrt).within(0.0, f64::INFINITY) }
    }

    /// Returns true if x₀ + k p is in the interval for a whole number k.
    fn contains_periodic(self, first: f64, period: f64) -> bool {
        let slack = ROUNDING * self.magnitude();
        let k = ((self.lower - slack - first) / period).ceil();
        // Not a number counts as contained.
        let next = first + k * period;
        next.is_nan() || next <= self.upper + slack
    }

    pub(crate) fn cos(self) -> Self {
        let ends = self.monotonic(f64::cos);
        let lower = if self.contains_periodic(PI, TAU) { -1.0 } else { ends.lower };
        let upper = if self.contains_periodic(0.0, TAU) { 1.0 } else { ends.upper };
        Self { lower, upper }.within(-1.0, 1.0)
    }

    pub(crate) fn sin(self) -> Self {
        let ends = self.monotonic(f64::sin);
        let lower = if self.contains_periodic(-FRAC_PI_2, TAU) { -1.0 } else { ends.lower };
        let upper = if self.contains_periodic(FRAC_PI_2, TAU) { 1.0 } else { ends.upper };
        Self { lower, upper }.within(-1.0, 1.0)
    }

    pub(crate) fn tan(self) -> Self {
        if self.contains_periodic(FRAC_PI_2, PI) { Self::ENTIRE } else { self.monotonic(f64::tan) }
    }

    /// Returns the inverse sine, or all numbers if the interval exceeds the domain.
    pub(crate) fn asin(self) -> Self {
        if self.magnitude() > 1.0 { Self::ENTIRE } else { self.monotonic(f64::asin) }
    }

    /// Returns the inverse cosine, or all numbers if the interval exceeds the domain.
    pub(crate) fn acos(self) -> Self {
        if self.magnitude() > 1.0 { Self::ENTIRE } else { self.monotonic(f64::acos) }
    }

    pub(crate) fn atan(self) -> Self {
        self.monotonic(f64::atan)
    }

    pub(crate) fn sinh(self) -> Self {
        self.monotonic(f64::sinh)
    }

    pub(crate) fn cosh(self) -> Self {
        self.abs().monotonic(f64::cosh)
    }

    pub(crate) fn tanh(self) -> Self {
        self.monotonic(f64::tanh).within(-1.0, 1.0)
    }

    /// Returns xⁿ.
    pub(crate) fn whole_power(self, n: i32) -> Self {
        if n < 0 {
            return self.whole_power(-n).recip();
        }
        let base = if n % 2 == 0 { self.abs() } else { self };
        // Powers by repeated multiplication have up to n rounding errors.
        let Self { lower, upper } = base.monotonic(|x| x.powi(n));
        let error = |x: f64| if x.is_finite() { f64::from(n) * f64::EPSILON * x.abs() } else { 0.0 };
        let widened = Self { lower: lower - error(lower), upper: upper + error(upper) };
        if n % 2 == 0 { widened.within(0.0, f64::INFINITY) } else { widened }
    }

    /// Returns xʸ, or all numbers if the interval has numbers below 0.
    pub(crate) fn power(self, y: f64) -> Self {
        if self.lower < 0.0 { Self::ENTIRE } else { self.monotonic(|x| x.powf(y)) }
    }
}

impl Add for Interval {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self::rounded(self.lower + other.lower, self.upper + other.upper)
    }
}

impl Sub for Interval {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Neg for Interval {
    type Output = Self;

    fn neg(self) -> Self {
        Self { lower: -self.upper, upper: -self.lower }
    }
}

impl Mul for Interval {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        if self == Self::ZERO || other == Self::ZERO {
            return Self::ZERO;
        }
        // Unbounded ends are limits of numbers: 0 · ∞ = 0.
        let product = |x: f64, y: f64| if x == 0.0 || y == 0.0 { 0.0 } else { x * y };
        let (a, b) = (product(self.lower, other.lower), product(self.lower, other.upper));
        let (c, d) = (product(self.upper, other.lower), product(self.upper, other.upper));
        Self::rounded(a.min(b).min(c.min(d)), a.max(b).max(c.max(d)))
    }
}
