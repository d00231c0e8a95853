use std::collections::BTreeSet;

use ancf_solver::equations::{REDUNDANCY_TOLERANCE, State, Term};

use super::redundancy::{Constraints, Owner, Redundant};
use crate::errors::{Finding, ModelError};
use crate::joints::JointEquations;
use crate::model::{Analysis, IndexedModel, Model, TimeMode};

/// Number of instants of a motion at which constraints are compared.
const INSTANTS: u32 = 128;

/// Finds joints that contradict others: redundant constraints with inconsistent values.
///
/// The model must satisfy all other checks.
pub(crate) fn contradictions(model: &Model) -> Vec<Finding> {
    let (time_mode, model) = (model.time_mode(), &IndexedModel::new(model));
    let meshes = model.meshes();
    let joints = model.joint_equations(&meshes, time_mode);
    let bodies = meshes.iter().flat_map(|(_, body)| body.terms());
    let of_joints = joints.iter().flat_map(JointEquations::terms);
    let couplings = model.coupling_terms(&meshes, &joints);
    let terms: Vec<Box<dyn Term>> = bodies.chain(of_joints).chain(couplings).collect();
    let constraints = Constraints::new(
        terms.iter().map(AsRef::as_ref),
        &joints,
        model.couplings.iter().map(|coupling| &coupling.name),
    );
    let [coordinates, _] = IndexedModel::numbers(&meshes, &joints);
    let rest = State::rest(coordinates, constraints.multipliers);
    let found = constraints.dependences(&rest, REDUNDANCY_TOLERANCE);
    if found.is_empty() {
        return Vec::new();
    }
    let states = instants(model).into_iter().map(|t| State { t, ..rest.clone() });
    let mut findings: Vec<(Owner, Redundant)> = Vec::new();
    for dependence in constraints.contradictions(&found, Some(&rest), states) {
        let owner = constraints.owner(dependence.row());
        findings.extend(owner.zip(constraints.describe(dependence)));
    }
    let of = |owner: Owner| {
        let own: Vec<&Redundant> = findings.iter().filter(|(k, _)| *k == owner).map(|(_, own)| own).collect();
        let equations: Vec<&str> = own.iter().map(|own| own.equation.as_str()).collect();
        let with: BTreeSet<&String> = own.iter().flat_map(|own| &own.with).collect();
        let with: Vec<String> = with.into_iter().map(|name| format!("`{name}`")).collect();
        let found = match with.as_slice() {
            [] => format!("equations that nothing can satisfy: {}", equations.join("; ")),
            _ => format!("equations that contradict {}: {}", with.join(", "), equations.join("; ")),
        };
        let path = match owner {
            Owner::Joint(k) => format!("joints[{k}]"),
            Owner::Coupling(k) => format!("couplings[{k}]"),
        };
        ModelError::new(path, found, "joints that agree where they constrain the same motion").into()
    };
    let owners: BTreeSet<Owner> = findings.iter().map(|(owner, _)| *owner).collect();
    owners.into_iter().map(of).collect()
}

/// Times at which functions of time are compared.
fn instants(model: &Model) -> Vec<f64> {
    let Analysis::Dynamics(dynamics) = &model.analysis else { return vec![0.0] };
    if model.has_external_functions(false) {
        return vec![0.0]; // What drives will do is not known yet, but that they start from 0.
    }
    let (start, duration) = (model.initial.start_time, dynamics.duration);
    let end = start + duration;
    let instant = |k| start + duration * f64::from(k) / f64::from(INSTANTS);
    let mut times: Vec<f64> = (0..=INSTANTS).map(instant).collect();
    let breaks = model.breaks(TimeMode::AsGiven);
    times.extend(breaks.iter().copied().filter(|t| (start..=end).contains(t)));
    times.extend(
        breaks.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).filter(|t| (start..=end).contains(t)),
    );
    times
}
