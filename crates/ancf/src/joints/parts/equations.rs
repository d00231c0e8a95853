use std::fmt;
use std::ops::Range;

use ancf_mechanics::constraints::{CoincidenceConstraint, ConstraintGroup, Wrench};
use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::recorded_coordinate::RecordedCoordinate;
use super::term::JointTerm;

/// Result of closing the gaps of a model, in the units of the assembly.
#[derive(Clone, Debug)]
pub struct GapClosure {
    /// Closed state, at rest and without loads.
    pub state: State,
    /// Name and distance of the ends of each joint that was open.
    pub gaps: Vec<(String, f64)>,
    /// Name of each body that moved, and the largest displacement of its nodes.
    pub moved: Vec<(String, f64)>,
}

/// Treatment of the gap between the ends of a joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Gap {
    /// Constant gap.
    Kept,
    /// Gap that closes with the load factor.
    ClosedByLoad,
    /// Closed gap.
    Closed,
}

/// Term of a joint.
pub(crate) struct Part {
    pub(crate) term: Box<dyn JointTerm>,
    /// True if the reaction of the joint contains the reaction of the term.
    pub(crate) reacts: bool,
}

/// Equations of one joint.
pub(crate) struct JointEquations {
    pub(crate) name: String,
    /// Range of the coordinates of the joint.
    pub(crate) coordinates: Range<usize>,
    /// Range of the multipliers.
    pub(crate) multipliers: Range<usize>,
    /// Constraint of the position, with its gap.
    pub(crate) position: Option<CoincidenceConstraint>,
    pub(crate) parts: Vec<Part>,
    /// Recorded coordinates of the joint.
    pub(crate) recorded: Vec<RecordedCoordinate>,
}

impl fmt::Debug for JointEquations {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { name, coordinates, multipliers, recorded, .. } = self;
        let mut debug = f.debug_struct("JointEquations");
        debug.field("name", name).field("coordinates", coordinates).field("multipliers", multipliers);
        debug.field("recorded", recorded).finish_non_exhaustive()
    }
}

impl JointEquations {
    /// Sets the treatment of the gap.
    pub(crate) fn with_gap(mut self, gap: Gap) -> Self {
        self.position = self.position.map(|position| match gap {
            Gap::Kept => position.kept(),
            Gap::ClosedByLoad => position.closed_by_load(),
            Gap::Closed => position.closed(),
        });
        self
    }

    /// Vector between the ends in the reference configuration; zero for joints that cannot close a gap.
    pub(crate) fn gap(&self) -> Vector3<f64> {
        self.position.as_ref().map_or_else(Vector3::zeros, CoincidenceConstraint::gap)
    }

    /// Terms of the joint. Quadratic constraints with consecutive multipliers are one term.
    pub(crate) fn terms(&self) -> impl Iterator<Item = Box<dyn Term>> {
        let position = self.position.iter().map(|position| position as &dyn JointTerm);
        let (mut grouped, mut others) = (Vec::new(), Vec::new());
        for term in position.chain(self.parts.iter().map(|part| &*part.term)) {
            match term.grouped() {
                Some(constraint) => grouped.push(constraint),
                None => others.push(term.boxed()),
            }
        }
        let groups = ConstraintGroup::groups(grouped).into_iter();
        groups.map(|group| Box::new(group) as Box<dyn Term>).chain(others)
    }

    /// Force and moment that the joint exerts on its end `a`.
    pub(crate) fn reaction(&self, s: &State) -> Wrench {
        let position = self.position.iter().map(|position| position.reaction(s));
        let parts = self.parts.iter().filter(|part| part.reacts).map(|part| part.term.reaction(s));
        position.chain(parts).fold(Wrench::default(), |sum, part| Wrench {
            force: sum.force + part.force,
            moment: sum.moment + part.moment,
        })
    }

    /// Names of the constraint equations; equal names are numbered.
    pub(crate) fn names(&self) -> Vec<String> {
        let mut terms: Vec<Box<dyn Term>> = self.terms().collect();
        terms.retain(|term| !term.multipliers().is_empty());
        terms.sort_by_key(|term| term.multipliers().start);
        // The terms of a slide share multipliers.
        terms.dedup_by_key(|term| term.multipliers().start);
        let names =
            terms.iter().flat_map(|term| (0..term.multipliers().len()).map(|k| term.constraint_name(k)));
        let names: Vec<String> = names.collect();
        let number = |i: usize| {
            let same = |range: &[String]| range.iter().filter(|name| **name == names[i]).count();
            let ordinals = ["first", "second", "third", "fourth", "fifth", "sixth"];
            match (same(&names), ordinals.get(same(&names[..i]))) {
                (2.., Some(ordinal)) => format!("{}, {ordinal} equation", names[i]),
                _ => names[i].clone(),
            }
        };
        (0..names.len()).map(number).collect()
    }
}
