//! Columns of the power of joints and loads.

use std::ops::Range;

use ancf_solver::equations::{LOCAL, Local, State, Term};

use super::column::Column;
use crate::assembly::Assembly;
use crate::units::{Dimension, Scales, UnitQuantity};

/// Columns of each joint, then of each load with terms of its own; none unless the model requests them.
pub(super) fn columns(assembly: &Assembly) -> Vec<Column> {
    let names = owners(assembly).map(|(name, _)| format!("{name}.power"));
    names.map(|name| Column::new(name, Dimension::POWER).with_quantity(UnitQuantity::Power)).collect()
}

/// Appends the powers −v·f of the forces f in the equations of motion, in the user's units.
pub(super) fn fill(assembly: &Assembly, s: &State, scales: &Scales, row: &mut Vec<f64>) {
    let terms = assembly.system.terms();
    let powers = owners(assembly).map(|(_, own)| terms[own].iter().map(|term| power(term.as_ref(), s)).sum());
    row.extend(powers.map(|power: f64| power * scales.unit(Dimension::POWER)));
}

/// Joints and loads by name with their terms.
fn owners(assembly: &Assembly) -> impl Iterator<Item = (String, Range<usize>)> + '_ {
    let owned = assembly.output.power.then_some(&assembly.owned).into_iter();
    owned.flat_map(|owned| {
        let joints = assembly.joints().map(str::to_owned).zip(owned.joints.iter().cloned());
        let loads = owned.loads.iter().enumerate().filter(|(_, terms)| !terms.is_empty());
        joints.chain(loads.map(|(number, terms)| (format!("loads[{number}]"), terms.clone())))
    })
}

fn power(term: &dyn Term, s: &State) -> f64 {
    let (coordinates, lambda) = (term.coordinates(), &s.lambda[term.multipliers()]);
    let [mut q, mut v, mut a, mut r] = [[0.0; LOCAL]; 4];
    for (i, &c) in coordinates.iter().enumerate() {
        (q[i], v[i], a[i]) = (s.q[c], s.v[c], s.a[c]);
    }
    let n = coordinates.len();
    let at = Local { q: &q[..n], v: &v[..n], a: &a[..n], lambda, t: s.t, load: s.load };
    term.residual(&at, &mut r[..n + lambda.len()]);
    -v[..n].iter().zip(r).map(|(v, r)| v * r).sum::<f64>()
}
