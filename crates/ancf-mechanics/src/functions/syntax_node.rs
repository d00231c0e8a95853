use num_dual::{Dual2_64, DualNum};

/// Number with its first two derivatives by t.
pub(crate) type Jet = Dual2_64;

/// Functions of one argument.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Unary {
    Negative,
    Sin,
    Cos,
    Tan,
    Asin,
    Acos,
    Atan,
    Sinh,
    Cosh,
    Tanh,
    Exp,
    Ln,
    Sqrt,
    Abs,
    Sign,
}

/// Operators and functions of two arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Binary {
    Sum,
    Difference,
    Product,
    Quotient,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
    Power,
    Minimum,
    Maximum,
}

/// Kind of numbers with which a formula is evaluated.
pub(crate) trait Operand: Copy {
    /// Creates a constant.
    fn number(x: f64) -> Self;

    /// Applies a function of one argument.
    fn one(self, f: Unary) -> Self;

    /// Applies an operator or a function of two arguments.
    fn two(self, f: Binary, other: Self) -> Self;

    /// Returns the first expression if this condition is nonzero, else the second.
    fn choose(self, then: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self;
}

/// Node of the syntax tree of a formula.
#[derive(Clone, Debug)]
pub(crate) enum SyntaxNode {
    Number(f64),
    /// Variable by its number in the list of names with which the formula was parsed.
    Variable(usize),
    One(Unary, Box<Self>),
    Two(Binary, Box<[Self; 2]>),
    /// Conditional: the second expression if the first is nonzero, else the third.
    If(Box<[Self; 3]>),
}

impl SyntaxNode {
    /// Evaluates the formula for the values of its variables.
    pub(crate) fn at<T: Operand>(&self, variables: &impl Fn(usize) -> T) -> T {
        match self {
            Self::Number(x) => T::number(*x),
            Self::Variable(number) => variables(*number),
            Self::One(f, x) => x.at(variables).one(*f),
            Self::Two(f, operands) => {
                let [x, y] = operands.as_ref();
                x.at(variables).two(*f, y.at(variables))
            }
            Self::If(parts) => {
                let [condition, then, other] = parts.as_ref();
                condition.at(variables).choose(|| then.at(variables), || other.at(variables))
            }
        }
    }

    /// Returns the formula of one variable that remains if the others have fixed values; `None` stands for that variable.
    pub(crate) fn with_values(&self, value: &impl Fn(usize) -> Option<f64>) -> Self {
        let with = |node: &Self| node.with_values(value);
        match self {
            Self::Number(x) => Self::Number(*x),
            Self::Variable(number) => value(*number).map_or(Self::Variable(0), Self::Number),
            Self::One(f, x) => Self::One(*f, Box::new(with(x))),
            Self::Two(f, parts) => Self::Two(*f, Box::new(parts.each_ref().map(with))),
            Self::If(parts) => Self::If(Box::new(parts.each_ref().map(with))),
        }
    }

    /// True if the formula contains a variable.
    pub(crate) fn contains(&self, variable: usize) -> bool {
        match self {
            Self::Number(_) => false,
            Self::Variable(number) => *number == variable,
            Self::One(_, x) => x.contains(variable),
            Self::Two(_, parts) => parts.iter().any(|part| part.contains(variable)),
            Self::If(parts) => parts.iter().any(|part| part.contains(variable)),
        }
    }

    /// Creates the node f(x, y).
    pub(crate) fn two(f: Binary, x: Self, y: Self) -> Self {
        Self::Two(f, Box::new([x, y]))
    }

    /// Creates a function call by name and arguments, if the function exists.
    pub(crate) fn call(name: &str, arguments: Vec<Self>) -> Option<Self> {
        if let Some(f) = one(name) {
            let [x] = <[Self; 1]>::try_from(arguments).ok()?;
            return Some(Self::One(f, Box::new(x)));
        }
        match name {
            "min" | "max" => {
                let [x, y] = <[Self; 2]>::try_from(arguments).ok()?;
                Some(Self::two(if name == "min" { Binary::Minimum } else { Binary::Maximum }, x, y))
            }
            "if" => Some(Self::If(Box::new(<[Self; 3]>::try_from(arguments).ok()?))),
            _ => None,
        }
    }
}

/// Returns a function of one argument by name.
fn one(name: &str) -> Option<Unary> {
    Some(match name {
        "sin" => Unary::Sin,
        "cos" => Unary::Cos,
        "tan" => Unary::Tan,
        "asin" => Unary::Asin,
        "acos" => Unary::Acos,
        "atan" => Unary::Atan,
        "sinh" => Unary::Sinh,
        "cosh" => Unary::Cosh,
        "tanh" => Unary::Tanh,
        "exp" => Unary::Exp,
        "ln" => Unary::Ln,
        "sqrt" => Unary::Sqrt,
        "abs" => Unary::Abs,
        "sign" => Unary::Sign,
        _ => return None,
    })
}

impl Operand for Jet {
    fn number(x: f64) -> Self {
        Self::from_re(x)
    }

    fn one(self, f: Unary) -> Self {
        match f {
            Unary::Negative => -self,
            Unary::Sin => self.sin(),
            Unary::Cos => self.cos(),
            Unary::Tan => self.tan(),
            Unary::Asin => self.asin(),
            Unary::Acos => self.acos(),
            Unary::Atan => self.atan(),
            Unary::Sinh => self.sinh(),
            Unary::Cosh => self.cosh(),
            Unary::Tanh => tanh(self),
            Unary::Exp => self.exp(),
            Unary::Ln => self.ln(),
            Unary::Sqrt => real_power(self, 0.5),
            Unary::Abs if self.re < 0.0 => -self,
            Unary::Abs => self,
            Unary::Sign => Self::from_re(if self.re == 0.0 { 0.0 } else { self.re.signum() }),
        }
    }

    fn two(self, f: Binary, other: Self) -> Self {
        match f {
            Binary::Sum => self + other,
            Binary::Difference => self - other,
            Binary::Product => self * other,
            Binary::Quotient => self / other,
            Binary::Less => number_from(self.re < other.re),
            Binary::Greater => number_from(self.re > other.re),
            Binary::LessEqual => number_from(self.re <= other.re),
            Binary::GreaterEqual => number_from(self.re >= other.re),
            Binary::Power => power(self, other),
            Binary::Minimum if other.re < self.re => other,
            Binary::Maximum if other.re > self.re => other,
            Binary::Minimum | Binary::Maximum => self,
        }
    }

    fn choose(self, then: impl FnOnce() -> Self, other: impl FnOnce() -> Self) -> Self {
        if self.re == 0.0 { other() } else { then() }
    }
}

fn number_from(holds: bool) -> Jet {
    Jet::from_re(f64::from(u8::from(holds)))
}

/// Computes xʸ, by multiplication for integer y, so that x may be negative or 0.
fn power(x: Jet, y: Jet) -> Jet {
    let constant = y.v1 == 0.0 && y.v2 == 0.0;
    if constant && y.re.fract() == 0.0 && y.re.abs() <= 64.0 {
        whole_power(x, y.re as i32)
    } else if constant {
        real_power(x, y.re)
    } else if (x.re, x.v1, x.v2) == (0.0, 0.0, 0.0) && y.re > 0.0 {
        x
    } else {
        (x.ln() * y).exp()
    }
}

/// Computes f(x) with its first and second derivatives. A constant argument has none, also where those of f are infinite.
fn chained(x: Jet, [f, f1, f2]: [f64; 3]) -> Jet {
    let times = |derivative: f64, by: f64| if by == 0.0 { 0.0 } else { derivative * by };
    Jet::new(f, times(f1, x.v1), times(f1, x.v2) + times(f2, x.v1 * x.v1))
}

/// Computes xʸ with the derivatives y xʸ⁻¹ and y(y − 1) xʸ⁻².
fn real_power(x: Jet, y: f64) -> Jet {
    let root = |y: f64| if y == 0.5 { x.re.sqrt() } else { x.re.powf(y) };
    chained(x, [root(y), y * x.re.powf(y - 1.0), y * (y - 1.0) * x.re.powf(y - 2.0)])
}

/// Computes tanh x, also where cosh x overflows.
fn tanh(x: Jet) -> Jet {
    let f = x.re.tanh();
    let f1 = (1.0 - f) * (1.0 + f);
    chained(x, [f, f1, -2.0 * f * f1])
}

/// Computes xⁿ with the derivatives n xⁿ⁻¹ and n(n − 1) xⁿ⁻², without division for n ≥ 0.
fn whole_power(x: Jet, n: i32) -> Jet {
    let times = |factor: i32, exponent: i32| {
        if factor == 0 { 0.0 } else { f64::from(factor) * x.re.powi(exponent) }
    };
    let (f1, f2) = (times(n, n - 1), times(n * (n - 1), n - 2));
    Jet::new(x.re.powi(n), f1 * x.v1, f1 * x.v2 + f2 * x.v1 * x.v1)
}
