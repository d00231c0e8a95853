use std::collections::BTreeMap;

use super::function::Clock;
use super::survey::Finding;
use super::{Model, ModelError};
use crate::system::{LOCAL, Local, LocalMatrix, Term, Weights};

/// A row is redundant if less than this part of it is independent of the others.
const INDEPENDENT: f64 = 1e-8;

/// Finds joints that repeat what others already tie, by orthogonalising the rows of Φ_q in the reference state.
///
/// Without this check a repeated equation leaves multipliers undetermined and reactions arbitrary. The model must obey all
/// other rules.
pub(super) fn repeated_joints(model: &Model) -> Vec<Finding> {
    let mut independent: Vec<BTreeMap<usize, f64>> = Vec::new();
    let mut findings = Vec::new();
    let bodies = model.meshes();
    for term in bodies.iter().flat_map(|(_, body)| body.terms()).filter(|term| !term.multipliers().is_empty())
    {
        for row in rows(term.as_ref()) {
            independent.extend(orthogonal(row, &independent));
        }
    }
    let joints = model.joint_equations(&bodies, Clock::Runs);
    let of_joints = joints.iter().map(|joint| joint.terms().collect()).enumerate();
    let of_joints = of_joints.map(|(k, terms)| (format!("joints[{k}]"), "joints", terms));
    let of_couplings = model.coupling_terms(&bodies, &joints).into_iter().enumerate();
    let of_couplings = of_couplings.map(|(k, term)| (format!("couplings[{k}]"), "couplings", vec![term]));
    for (path, noun, terms) in of_joints.chain(of_couplings) {
        let (rows, before) = (shared_rows(&terms), independent.len());
        let count = rows.len();
        for row in rows {
            independent.extend(orthogonal(row, &independent));
        }
        let repeated = count - (independent.len() - before);
        if repeated > 0 {
            let found = format!("{repeated} of {count} equations that repeat those of earlier joints");
            findings.push(ModelError::new(path, found, format!("{noun} that tie each motion once")).into());
        }
    }
    findings
}

/// The rows of terms that may share multipliers, as those of a slide do: the first that is not empty stands.
fn shared_rows(terms: &[Box<dyn Term>]) -> Vec<BTreeMap<usize, f64>> {
    let mut shared: BTreeMap<usize, BTreeMap<usize, f64>> = BTreeMap::new();
    for term in terms {
        for (multiplier, row) in term.multipliers().zip(rows(term.as_ref())) {
            let known = shared.entry(multiplier).or_default();
            if known.is_empty() {
                *known = row;
            }
        }
    }
    shared.into_values().collect()
}

/// The rows of Φ_q of one term in the reference state, each of length one.
fn rows(term: &dyn Term) -> Vec<BTreeMap<usize, f64>> {
    let (coordinates, multipliers) = (term.coordinates(), term.multipliers().len());
    let n = coordinates.len();
    let zero = vec![0.0; LOCAL];
    let at = Local {
        q: &zero[..n],
        v: &zero[..n],
        a: &zero[..n],
        lambda: &zero[..multipliers],
        t: 0.0,
        load: 1.0,
    };
    let mut storage = vec![0.0; LOCAL * LOCAL];
    let mut k = LocalMatrix::zero(n + multipliers, &mut storage);
    term.tangent(&at, Weights { q: 0.0, v: 0.0, a: 0.0 }, &mut k);
    let row = |m: usize| coordinates.iter().enumerate().map(|(i, &c)| (c, k.get(n + m, i))).collect();
    (0..multipliers).map(|m| unit(row(m)).0).collect()
}

/// The part of a unit row that is orthogonal to orthonormal ones, if there is any to speak of.
fn orthogonal(
    mut row: BTreeMap<usize, f64>,
    others: &[BTreeMap<usize, f64>],
) -> Option<BTreeMap<usize, f64>> {
    // Twice is enough for orthogonality to rounding (Parlett).
    for other in others.iter().chain(others) {
        let dot: f64 = row.iter().filter_map(|(c, x)| other.get(c).map(|y| x * y)).sum();
        if dot != 0.0 {
            for (&c, y) in other {
                *row.entry(c).or_default() -= dot * y;
            }
        }
    }
    let (row, length) = unit(row);
    (length > INDEPENDENT).then_some(row)
}

fn unit(mut row: BTreeMap<usize, f64>) -> (BTreeMap<usize, f64>, f64) {
    row.retain(|_, x| *x != 0.0);
    let length = row.values().map(|x| x * x).sum::<f64>().sqrt();
    row.values_mut().for_each(|x| *x /= length);
    (row, length)
}
