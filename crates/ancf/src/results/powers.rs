//! Columns of the power of joints and loads.

use std::ops::Range;
use std::sync::Arc;

use ancf_solver::equations::{LOCAL, LocalState, State, Term};

use super::column::Column;
use crate::assembly::Assembly;
use crate::units::{Dimension, Scales, UnitQuantity};

/// Columns of each joint, then of each load with terms of its own; none unless the model requests them.
pub(super) fn columns(assembly: &Assembly) -> Vec<Column> {
    let names = owners(assembly).map(|(name, _)| format!("{name}.power"));
    names.map(|name| Column::new(name, Dimension::POWER).with_quantity(UnitQuantity::Power)).collect()
}

/// Appends the powers −v·f of the forces f in the equations of motion, in the user's units.
///
/// With the start of the step before they are those of its middle.
pub(super) fn fill(
    assembly: &Assembly,
    start: Option<&State>,
    s: &State,
    scales: &Scales,
    row: &mut Vec<f64>,
) {
    if !assembly.output.power {
        return;
    }
    let middle = start.map(|start| {
        let mut middle = s.clone();
        middle.set_middle(start, s);
        middle
    });
    let s = middle.as_ref().unwrap_or(s);
    let terms = assembly.system.terms();
    // The equations of states of force laws have no force on a body.
    let states: Vec<usize> = assembly.joints.iter().flat_map(|joint| joint.states.iter().copied()).collect();
    let power = |term: &Arc<dyn Term>| power(term.as_ref(), s, &states);
    let powers = owners(assembly).map(|(_, own)| terms[own].iter().map(power).sum());
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

fn power(term: &dyn Term, s: &State, excluded: &[usize]) -> f64 {
    let (mut gathered, mut r) = (LocalState::EMPTY, [0.0; LOCAL]);
    let at = gathered.gather(s, term);
    term.residual(&at, &mut r[..at.q.len() + at.lambda.len()]);
    let rows = at.v.iter().zip(r).zip(term.coordinates());
    -rows.filter(|(_, c)| !excluded.contains(c)).map(|((v, r), _)| v * r).sum::<f64>()
}
