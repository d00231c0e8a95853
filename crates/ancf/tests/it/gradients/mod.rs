//! Derivatives of results with respect to numbers of the model.

mod eigenvalues;
mod equilibria;
mod invariance;
mod refusals;

use ancf::{Gradients, Parameter, gradients};

use crate::common::models::parse;

/// Computes the gradients of a model file with respect to numbers at paths.
fn gradients_of(text: &str, paths: &[&str]) -> Gradients {
    let parameters: Vec<Parameter> = paths.iter().map(|path| Parameter::new(*path)).collect();
    gradients(&parse(text), &parameters, &Default::default()).unwrap()
}

/// Derivative of a quantity with respect to a parameter.
fn derivative(of: &Gradients, quantity: &str, parameter: &str) -> f64 {
    let row = of.quantities.iter().position(|name| name == quantity).unwrap();
    let column = of.parameters.iter().position(|name| name == parameter).unwrap();
    of.derivatives[(row, column)]
}

/// Value of a quantity.
fn value(of: &Gradients, quantity: &str) -> f64 {
    of.values[of.quantities.iter().position(|name| name == quantity).unwrap()]
}

/// Relative derivative d ln y/d ln p.
fn relative(of: &Gradients, quantity: &str, parameter: &str) -> f64 {
    let column = of.parameters.iter().position(|name| name == parameter).unwrap();
    derivative(of, quantity, parameter) * of.parameter_values[column] / value(of, quantity)
}

/// Model file of a straight column along x of equal parts with a material each, `m1` ..., clamped to each other. The first one is
/// clamped at its start.
fn column(parts: usize, elements: usize, (kind, section): (&str, &str), rest: &str) -> String {
    let mut text = format!("sections.rod = {section}\n");
    for k in 1..=parts {
        text += &format!("materials.m{k} = {{ density = 7800.0, young = 2.1e11 }}\n");
    }
    let length = 1.0 / parts as f64;
    for k in 1..=parts {
        let [from, to] = [(k - 1) as f64 * length, k as f64 * length];
        text += &format!(
            "[[bodies]]\nkind = \"{kind}\"\nname = \"b{k}\"\nfrom = [{from:?}, 0, 0]\nto = [{to:?}, 0, 0]\nelements = {elements}\n\
             section = \"rod\"\nmaterial = \"m{k}\"\n"
        );
        let b = match k {
            1 => String::new(),
            _ => format!("b = {{ body = \"b{}\", at = \"end\" }}\n", k - 1),
        };
        text += &format!(
            "[[joints]]\nkind = \"clamp\"\nname = \"c{k}\"\na = {{ body = \"b{k}\", at = \"start\" }}\n{b}"
        );
    }
    text + rest
}
