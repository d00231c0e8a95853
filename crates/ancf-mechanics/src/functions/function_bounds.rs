use num_dual::Dual2_64;

use super::interval::Interval;
use super::syntax_node::{Binary, Operand, Unary};

/// Bounds of a function over an interval of time: of its values, of its difference quotients and of its second rate.
///
/// The rates are unbounded where the function may jump, the second rate also where it may have a kink.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FunctionBounds {
    pub(crate) value: Interval,
    pub(crate) rate: Interval,
    pub(crate) acceleration: Interval,
}

impl FunctionBounds {
    /// Creates the bounds of t over an interval.
    pub(crate) const fn time(t: Interval) -> Self {
        Self { value: t, rate: Interval::point(1.0), acceleration: Interval::ZERO }
    }

    const fn constant(value: Interval) -> Self {
        Self { value, rate: Interval::ZERO, acceleration: Interval::ZERO }
    }

    /// Creates bounds of a function that may jump.
    pub(crate) const fn jump(value: Interval) -> Self {
        Self { value, rate: Interval::ENTIRE, acceleration: Interval::ENTIRE }
    }

    fn is_constant(&self) -> bool {
        self.value.is_point() && self.rate == Interval::ZERO && self.acceleration == Interval::ZERO
    }

    /// Scales the rates for an argument that is `unit` times the time.
    pub(crate) fn with_scaled_rates(self, unit: f64) -> Self {
        let unit = Interval::point(unit);
        Self { rate: self.rate * unit, acceleration: self.acceleration * unit * unit, ..self }
    }

    /// Chain rule for the function, its derivative and its second derivative.
    fn chain(&self, value: Interval, first: Interval, second: Interval) -> Self {
        Self {
            value,
            rate: first * self.rate,
            acceleration: second * self.rate.whole_power(2) + first * self.acceleration,
        }
    }

    fn negative(self) -> Self {
        Self { value: -self.value, rate: -self.rate, acceleration: -self.acceleration }
    }

    fn sum(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            rate: self.rate + other.rate,
            acceleration: self.acceleration + other.acceleration,
        }
    }

    fn product(self, other: Self) -> Self {
        let two = Interval::point(2.0);
        Self {
            value: self.value * other.value,
            rate: self.rate * other.value + self.value * other.rate,
            acceleration: self.acceleration * other.value
                + two * (self.rate * other.rate)
                + self.value * other.acceleration,
        }
    }

    fn recip(self) -> Self {
        let x = self.value.recip();
        self.chain(x, -x.whole_power(2), Interval::point(2.0) * x.whole_power(3))
    }

    fn exp(self) -> Self {
        let value = self.value.exp();
        self.chain(value, value, value)
    }

    fn ln(self) -> Self {
        let x = self.value.recip();
        self.chain(self.value.ln(), x, -x.whole_power(2))
    }

    fn power(self, y: Self) -> Self {
        if !y.is_constant() {
            return self.ln().product(y).exp();
        }
        let (x, y) = (self.value, y.value.lower);
        let factors = [Interval::point(y), Interval::point(y) * Interval::point(y - 1.0)];
        if y.fract() == 0.0 && y.abs() <= 64.0 {
            let n = y as i32;
            let second = if n == 0 || n == 1 { Interval::ZERO } else { factors[1] * x.whole_power(n - 2) };
            let first = if n == 0 { Interval::ZERO } else { factors[0] * x.whole_power(n - 1) };
            self.chain(x.whole_power(n), first, second)
        } else {
            self.chain(x.power(y), factors[0] * x.power(y - 1.0), factors[1] * x.power(y - 2.0))
        }
    }

    /// Selects one of two functions, whose first is the smaller one if `is_smaller`.
    fn extremum(self, other: Self, value: Interval) -> Self {
        if self.value.upper < other.value.lower || other.value.upper < self.value.lower {
            let is_own = value == self.value;
            return if is_own { self } else { other };
        }
        Self { value, rate: self.rate.hull(other.rate), acceleration: Interval::ENTIRE }
    }

    /// Bounds of a comparison: 1 if it holds for all numbers, 0 if for none.
    fn comparison(always: bool, never: bool) -> Self {
        match (always, never) {
            (true, _) => Self::constant(Interval::point(1.0)),
            (_, true) => Self::constant(Interval::ZERO),
            _ => Self::jump(Interval::between(0.0, 1.0)),
        }
    }

    fn apply(self, f: Unary) -> Self {
        let (x, one, two) = (self.value, Interval::point(1.0), Interval::point(2.0));
        let square = x.whole_power(2);
        match f {
            Unary::Negative => self.negative(),
            Unary::Sin => self.chain(x.sin(), x.cos(), -x.sin()),
            Unary::Cos => self.chain(x.cos(), -x.sin(), -x.cos()),
            Unary::Tan => {
                let (tan, slope) = (x.tan(), one + x.tan().whole_power(2));
                self.chain(tan, slope, two * tan * slope)
            }
            Unary::Asin | Unary::Acos => {
                let slope = (one - square).sqrt().recip();
                let second = x * slope.whole_power(3);
                match f {
                    Unary::Asin => self.chain(x.asin(), slope, second),
                    _ => self.chain(x.acos(), -slope, -second),
                }
            }
            Unary::Atan => {
                let slope = (one + square).recip();
                self.chain(x.atan(), slope, -(two * x * slope.whole_power(2)))
            }
            Unary::Sinh => self.chain(x.sinh(), x.cosh(), x.sinh()),
            Unary::Cosh => self.chain(x.cosh(), x.sinh(), x.cosh()),
            Unary::Tanh => {
                let (tanh, slope) = (x.tanh(), one - x.tanh().whole_power(2));
                self.chain(tanh, slope, -(two * tanh * slope))
            }
            Unary::Exp => self.exp(),
            Unary::Ln => self.ln(),
            Unary::Sqrt => {
                let root = x.sqrt();
                let slope = (two * root).recip();
                self.chain(root, slope, -(two * slope.whole_power(3)))
            }
            Unary::Abs if x.lower >= 0.0 => self,
            Unary::Abs if x.upper <= 0.0 => self.negative(),
            Unary::Abs => self.chain(x.abs(), Interval::between(-1.0, 1.0), Interval::ENTIRE),
            Unary::Sign if x.lower > 0.0 => Self::constant(one),
            Unary::Sign if x.upper < 0.0 => Self::constant(-one),
            Unary::Sign => self.chain(Interval::between(-1.0, 1.0), Interval::ENTIRE, Interval::ENTIRE),
        }
    }
}

impl Operand for FunctionBounds {
    fn number(x: f64) -> Self {
        Self::constant(Interval::point(x))
    }

    fn one(self, f: Unary) -> Self {
        if self.is_constant() {
            return Self::number(Dual2_64::from_re(self.value.lower).one(f).re);
        }
        self.apply(f)
    }

    fn two(self, f: Binary, other: Self) -> Self {
        let (x, y) = (self.value, other.value);
        if self.is_constant() && other.is_constant() {
            let [x, y] = [x, y].map(|x| Dual2_64::from_re(x.lower));
            return Self::number(x.two(f, y).re);
        }
        match f {
            Binary::Sum => self.sum(other),
            Binary::Difference => self.sum(other.negative()),
            Binary::Product => self.product(other),
            Binary::Quotient => self.product(other.recip()),
            Binary::Less => Self::comparison(x.upper < y.lower, x.lower >= y.upper),
            Binary::Greater => Self::comparison(x.lower > y.upper, x.upper <= y.lower),
            Binary::LessEqual => Self::comparison(x.upper <= y.lower, x.lower > y.upper),
            Binary::GreaterEqual => Self::comparison(x.lower >= y.upper, x.upper < y.lower),
            Binary::Power => self.power(other),
            Binary::Minimum => self.extremum(other, x.minimum(y)),
            Binary::Maximum => self.extremum(other, x.maximum(y)),
        }
    }

    fn choose(self, then: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self {
        match (self.value.contains(0.0), self.value.is_point()) {
            (false, _) => then(),
            (true, true) => other(),
            _ => Self::jump(then().value.hull(other().value)),
        }
    }
}
