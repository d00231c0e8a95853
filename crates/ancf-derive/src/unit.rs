//! Units as products of powers of base quantities.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{Parse, ParseStream};
use syn::{Ident, LitInt, Token};

/// Base quantities and their exponents of length, time and force.
const BASE: [(&str, [i32; 3]); 7] = [
    ("length", [1, 0, 0]),
    ("time", [0, 1, 0]),
    ("force", [0, 0, 1]),
    ("mass", [-1, 2, 1]),
    ("radian", [0, 0, 0]),
    ("cycle", [0, 0, 0]),
    ("number", [0, 0, 0]),
];

/// A unit such as `force / length^2`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Unit {
    /// Exponents of length, time and force.
    exponents: [i32; 3],
    /// The unit as stated, without blanks.
    pub(crate) text: String,
}

impl Unit {
    /// Expression of type `Dimension`.
    pub(crate) fn dimension(&self) -> TokenStream {
        let [length, time, force] = self.exponents;
        quote!(::ancf::units::Dimension::new(#length, #time, #force))
    }

    /// True if conversion does not change the number.
    pub(crate) fn is_number(&self) -> bool {
        self.exponents == [0; 3]
    }

    fn multiply(&mut self, exponents: [i32; 3], power: i32) {
        for (own, exponent) in self.exponents.iter_mut().zip(exponents) {
            *own += power * exponent;
        }
    }
}

impl Parse for Unit {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let mut unit = Self { exponents: [0; 3], text: String::new() };
        let mut sign = 1;
        loop {
            factor(input, sign, &mut unit)?;
            if input.parse::<Option<Token![*]>>()?.is_some() {
                sign = 1;
                unit.text.push('*');
            } else if input.parse::<Option<Token![/]>>()?.is_some() {
                sign = -1;
                unit.text.push('/');
            } else {
                return Ok(unit);
            }
        }
    }
}

/// Multiplies a unit by the next factor: `1`, `length` or `length^2`.
fn factor(input: ParseStream<'_>, sign: i32, unit: &mut Unit) -> syn::Result<()> {
    if input.peek(LitInt) {
        let one: LitInt = input.parse()?;
        if one.base10_digits() != "1" {
            return Err(syn::Error::new(one.span(), "expected 1 or a base quantity"));
        }
        unit.text.push('1');
        return Ok(());
    }
    let word: Ident = input.parse()?;
    let Some((name, exponents)) = BASE.iter().find(|(name, _)| word == name) else {
        let names = BASE.map(|(name, _)| name).join(", ");
        return Err(syn::Error::new(word.span(), format!("unknown quantity, expected one of: {names}")));
    };
    unit.text.push_str(name);
    let mut power = 1;
    if input.parse::<Option<Token![^]>>()?.is_some() {
        power = input.parse::<LitInt>()?.base10_parse()?;
        unit.text.push_str(&format!("^{power}"));
    }
    unit.multiply(*exponents, sign * power);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn unit(text: &str) -> Unit {
        syn::parse_str(text).unwrap()
    }

    #[test]
    fn products_of_powers() {
        for (text, exponents, short) in [
            ("length", [1, 0, 0], "length"),
            ("1 / time", [0, -1, 0], "1/time"),
            ("force / length ^ 2", [-2, 0, 1], "force/length^2"),
            ("mass", [-1, 2, 1], "mass"),
            ("mass / length^3", [-4, 2, 1], "mass/length^3"),
            ("mass * length^2", [1, 2, 1], "mass*length^2"),
            ("force * length * time", [1, 1, 1], "force*length*time"),
            ("length / time / time", [1, -2, 0], "length/time/time"),
            ("force * length / radian", [1, 0, 1], "force*length/radian"),
        ] {
            assert_eq!(unit(text), Unit { exponents, text: short.into() });
        }
        assert!(unit("cycle").is_number());
    }

    #[test]
    fn other_words_are_errors() {
        for text in ["metre", "2 * length", "length^", "length time", "length^x", "*", ""] {
            assert!(syn::parse_str::<Unit>(text).is_err(), "{text}");
        }
    }
}
