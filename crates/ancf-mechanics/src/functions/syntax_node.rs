use num_dual::{Dual2_64, DualNum};

/// Number with its first two derivatives by t.
pub(crate) type Jet = Dual2_64;

/// Node of the syntax tree of a formula.
#[derive(Clone, Debug)]
pub(crate) enum SyntaxNode {
    Number(f64),
    Time,
    One(fn(Jet) -> Jet, Box<Self>),
    Two(fn(Jet, Jet) -> Jet, Box<[Self; 2]>),
    /// Conditional: the second expression if the first is nonzero, else the third.
    If(Box<[Self; 3]>),
}

impl SyntaxNode {
    pub(crate) fn at(&self, t: Jet) -> Jet {
        match self {
            Self::Number(x) => Jet::from_re(*x),
            Self::Time => t,
            Self::One(f, x) => f(x.at(t)),
            Self::Two(f, operands) => {
                let [x, y] = operands.as_ref();
                f(x.at(t), y.at(t))
            }
            Self::If(parts) => {
                let [condition, then, other] = parts.as_ref();
                if condition.at(t).re == 0.0 { other.at(t) } else { then.at(t) }
            }
        }
    }

    /// Creates the node f(x, y).
    pub(crate) fn two(f: fn(Jet, Jet) -> Jet, x: Self, y: Self) -> Self {
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
                Some(Self::two(if name == "min" { minimum } else { maximum }, x, y))
            }
            "if" => Some(Self::If(Box::new(<[Self; 3]>::try_from(arguments).ok()?))),
            _ => None,
        }
    }
}

/// Returns a function of one argument by name.
pub(crate) fn one(name: &str) -> Option<fn(Jet) -> Jet> {
    Some(match name {
        "sin" => |x| x.sin(),
        "cos" => |x| x.cos(),
        "tan" => |x| x.tan(),
        "asin" => |x| x.asin(),
        "acos" => |x| x.acos(),
        "atan" => |x| x.atan(),
        "sinh" => |x| x.sinh(),
        "cosh" => |x| x.cosh(),
        "tanh" => |x| x.tanh(),
        "exp" => |x| x.exp(),
        "ln" => |x| x.ln(),
        "sqrt" => |x| x.sqrt(),
        "abs" => |x| if x.re < 0.0 { -x } else { x },
        "sign" => |x| Jet::from_re(if x.re == 0.0 { 0.0 } else { x.re.signum() }),
        _ => return None,
    })
}

pub(crate) fn minimum(x: Jet, y: Jet) -> Jet {
    if y.re < x.re { y } else { x }
}

pub(crate) fn maximum(x: Jet, y: Jet) -> Jet {
    if y.re > x.re { y } else { x }
}

/// Computes xʸ, by multiplication for integer y, so that x may be negative or 0.
pub(crate) fn power(x: Jet, y: Jet) -> Jet {
    let constant = y.v1 == 0.0 && y.v2 == 0.0;
    if constant && y.re.fract() == 0.0 && y.re.abs() <= 64.0 {
        whole_power(x, y.re as i32)
    } else if constant {
        x.powf(y.re)
    } else {
        (x.ln() * y).exp()
    }
}

/// Computes xⁿ with the derivatives n xⁿ⁻¹ and n(n − 1) xⁿ⁻², without division for n ≥ 0.
pub(crate) fn whole_power(x: Jet, n: i32) -> Jet {
    let times = |factor: i32, exponent: i32| {
        if factor == 0 { 0.0 } else { f64::from(factor) * x.re.powi(exponent) }
    };
    let (f1, f2) = (times(n, n - 1), times(n * (n - 1), n - 2));
    Jet::new(x.re.powi(n), f1 * x.v1, f1 * x.v2 + f2 * x.v1 * x.v1)
}
