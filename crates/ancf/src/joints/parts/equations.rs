use std::cell::RefCell;
use std::collections::{BTreeSet, HashMap};
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

use ancf_mechanics::bodies::BodyTerms;
use ancf_mechanics::constraints::{BilinearMeasure, CoincidenceConstraint, ConstraintGroup, Wrench};
use ancf_mechanics::kinematics::{Attachment, BodyVector, ElementAxis};
use ancf_mechanics::laws::{LawUnits, StateLaw};
use ancf_mechanics::shells::ShearShellMesh;
use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::end::End;
use super::recorded_coordinate::RecordedCoordinate;
use super::term::JointTerm;
use crate::model::{Body, LawSignal, ShearShell, TimeMode};
use crate::units::Scales;

/// Ends of a joint as attachments to bodies.
pub(crate) struct JointEnds<'a> {
    pub(crate) a: &'a Attachment,
    pub(crate) b: &'a Attachment,
    /// Second end as given.
    pub(crate) stated: &'a End,
    /// Element axes of the second body and the arc length there, for points that slide along it.
    pub(crate) beam: Option<(Vec<ElementAxis>, f64)>,
    /// Body of the first end.
    pub(crate) body: JointBody<'a>,
    /// Body of the second end, if it is on a body.
    pub(crate) other: Option<JointBody<'a>>,
    /// Linear equations of the edges of shells so far.
    pub(crate) edge_rows: &'a RefCell<LinearRows>,
    /// Default of [`ClampedGradients`](super::ClampedGradients): true for a beam of the continuum formulation on the ground, on a rigid body, or on another
    /// one with parallel sections. Elsewhere equal gradients would couple strains of different directions or laws.
    pub(crate) all_gradients: bool,
}

/// Body of an end of a joint: its data, and its coordinates and terms.
#[derive(Clone, Copy, Debug)]
pub(crate) struct JointBody<'a> {
    pub(crate) data: &'a Body,
    pub(crate) terms: &'a BodyTerms,
}

impl<'a> JointBody<'a> {
    /// Mesh and data of a shear-deformable shell.
    pub(crate) fn shear_shell(&self) -> Option<(&'a ShearShellMesh, &'a ShearShell)> {
        self.terms.shear_shell().zip(self.data.shear_shell())
    }
}

/// First unused coordinate and multiplier, and what is common to all joints.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Numbering {
    pub(crate) coordinate: usize,
    pub(crate) multiplier: usize,
    pub(crate) time_mode: TimeMode,
    /// Typical energy of the model, for the states of force laws.
    pub(crate) energy: f64,
}

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
    /// Point on which the reaction of the term acts and that to which the moment of the joint refers, if they differ.
    pub(crate) arm: Option<[BodyVector; 2]>,
}

impl Part {
    /// Term whose reaction acts at the point of the joint.
    pub(crate) fn new(term: Box<dyn JointTerm>) -> Self {
        Self { term, reacts: true, arm: None }
    }

    /// Force and moment on the end `a`.
    fn reaction(&self, s: &State) -> Wrench {
        let Wrench { force, moment } = self.term.reaction(s);
        let arm =
            self.arm.as_ref().map_or_else(Vector3::zeros, |[point, about]| point.value(s) - about.value(s));
        Wrench { force, moment: moment + arm.cross(&force) }
    }
}

/// Owner of equations with coordinates and multipliers of their own.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum EquationOwner {
    /// Joint, with a reaction.
    Joint,
    /// Gas in an enclosed volume.
    Gas,
}

/// Smallest cosine between axes that a joint keeps parallel. Other solutions of the equations have cosines of at most zero.
const ALIGNED: f64 = 0.5;

/// Equations of one joint, or of a gas.
pub(crate) struct JointEquations {
    pub(crate) owner: EquationOwner,
    pub(crate) name: String,
    /// Range of the coordinates of the joint.
    pub(crate) coordinates: Range<usize>,
    /// Range of the multipliers.
    pub(crate) multipliers: Range<usize>,
    /// Constraint of the position, with its gap.
    pub(crate) position: Option<CoincidenceConstraint>,
    pub(crate) parts: Vec<Part>,
    /// Cosines between an axis of the first end and the same axis of the second end that the joint keeps at one.
    pub(crate) alignments: Vec<BilinearMeasure>,
    /// Recorded coordinates of the joint.
    pub(crate) recorded: Vec<RecordedCoordinate>,
    /// Coordinates of states of force laws.
    pub(crate) states: Vec<usize>,
    /// Multipliers of drives by a rate in statics, which keep a coordinate at its value in a given state.
    pub(crate) held: Vec<usize>,
    /// Force laws with states or signals, whose terms are added when all joints are built.
    pub(crate) laws: Vec<JointStateLaw>,
}

/// Force law with states or signals along a coordinate of a joint.
#[derive(Clone, Debug)]
pub(crate) struct JointStateLaw {
    /// Coordinate of the law, then those of its states.
    pub(crate) coordinates: Vec<usize>,
    pub(crate) law: Arc<StateLaw>,
    pub(crate) units: LawUnits,
    /// Typical energies of the states.
    pub(crate) energies: Vec<f64>,
    pub(crate) signals: Vec<LawSignal>,
    /// Units of the model, measured in those of the formulas.
    pub(crate) scales: Scales,
    /// Key of the law in the joint.
    pub(crate) key: &'static str,
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
    /// True if the ends of the joint have the orientation of the reference state in all axes that the joint keeps parallel.
    ///
    /// Products of directions have the same values half a turn away, and at 120° about a diagonal.
    pub(crate) fn is_aligned(&self, s: &State) -> bool {
        self.alignments.iter().all(|cosine| cosine.value(s) >= ALIGNED)
    }

    /// Creates equations without terms, with the first coordinate and multiplier.
    pub(crate) fn new(owner: EquationOwner, name: &str, coordinate: usize, multiplier: usize) -> Self {
        Self {
            owner,
            name: name.to_owned(),
            coordinates: coordinate..coordinate,
            multipliers: multiplier..multiplier,
            position: None,
            parts: Vec::new(),
            alignments: Vec::new(),
            recorded: Vec::new(),
            states: Vec::new(),
            held: Vec::new(),
            laws: Vec::new(),
        }
    }

    /// True for a joint, false for a gas.
    pub(crate) fn is_joint(&self) -> bool {
        self.owner == EquationOwner::Joint
    }

    /// Owner of a coordinate in messages.
    pub(crate) fn owner_of_coordinate(&self) -> String {
        match self.owner {
            EquationOwner::Joint => format!("joint `{}`, its coordinate", self.name),
            EquationOwner::Gas => format!("gas `{}`, its volume", self.name),
        }
    }

    /// Owner of a multiplier in messages.
    pub(crate) fn owner_of_multiplier(&self, number: usize) -> String {
        match self.owner {
            EquationOwner::Joint => format!("joint `{}`, {}", self.name, self.names()[number]),
            EquationOwner::Gas => format!("gas `{}`, its pressure", self.name),
        }
    }

    /// Coordinates other than those of states of force laws.
    pub(crate) fn free_coordinates(&self) -> impl Iterator<Item = usize> + '_ {
        self.coordinates.clone().filter(|c| !self.states.contains(c))
    }

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
        let parts = self.parts.iter().filter(|part| part.reacts).map(|part| part.reaction(s));
        position.chain(parts).sum()
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

/// Size of the remainder of a row, relative to it, below which earlier rows imply it.
const IMPLIED: f64 = 1e-9;
/// Size of a pivot, relative to the largest entry of its row, that is accepted in a preferred coordinate.
const PIVOT: f64 = 1e-3;

/// Linear equations of the edges of shells after elimination. Edges that meet at a corner state some equations twice.
///
/// Pivots are coordinates of shells where possible: rows of nodes on the same rigid body have no pivot in common, so that the work is
/// proportional to their number.
#[derive(Debug, Default)]
pub(crate) struct LinearRows {
    /// Pivot of each row, and the factors of the other coordinates for the factor 1 of the pivot.
    rows: Vec<(usize, Vec<(usize, f64)>)>,
    /// Row of each pivot.
    of_pivot: HashMap<usize, usize>,
}

impl LinearRows {
    /// Adds the equation with the given factors of coordinates, with a pivot in `preferred`. Returns false if earlier equations
    /// imply it.
    ///
    /// The equations are homogeneous, so that those which depend on others do not contradict them.
    pub(crate) fn add(
        &mut self,
        factors: impl IntoIterator<Item = (usize, f64)>,
        preferred: &Range<usize>,
    ) -> bool {
        let mut row: HashMap<usize, f64> = factors.into_iter().collect();
        let size = row.values().map(|x| x.abs()).fold(0.0, f64::max);
        // A row contains pivots of later rows only.
        let mut left: BTreeSet<usize> = row.keys().filter_map(|c| self.of_pivot.get(c)).copied().collect();
        while let Some(next) = left.pop_first() {
            let (pivot, others) = &self.rows[next];
            let Some(factor) = row.remove(pivot) else { continue };
            for (c, x) in others {
                let entry = row.entry(*c).or_insert(0.0);
                *entry -= factor * x;
                if entry.abs() < f64::EPSILON * size {
                    row.remove(c);
                } else {
                    left.extend(self.of_pivot.get(c));
                }
            }
        }
        let largest = |row: &HashMap<usize, f64>, all: bool| {
            let own = row.iter().filter(|(c, _)| all || preferred.contains(c));
            own.map(|(c, x)| (*c, x.abs())).max_by(|a, b| a.1.total_cmp(&b.1).then(b.0.cmp(&a.0)))
        };
        let Some((any, rest)) = largest(&row, true) else { return false };
        if rest.is_nan() || rest < IMPLIED * size {
            return false;
        }
        let own = largest(&row, false).filter(|(_, x)| *x > PIVOT * rest);
        let pivot = own.map_or(any, |(c, _)| c);
        let factor = row.remove(&pivot).unwrap_or(1.0);
        let others = row.into_iter().filter(|(_, x)| x.abs() > f64::EPSILON * rest);
        self.of_pivot.insert(pivot, self.rows.len());
        self.rows.push((pivot, others.map(|(c, x)| (c, x / factor)).collect()));
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn implied_rows_are_found() {
        for preferred in [0..0, 0..2, 1..9] {
            let mut rows = LinearRows::default();
            let mut add = |row: &[(usize, f64)]| rows.add(row.iter().copied(), &preferred);
            assert!(add(&[(0, 3.0), (1, 4.0)]));
            assert!(add(&[(1, 1.0), (2, -1.0)]));
            assert!(!add(&[(0, 6.0), (1, 9.0), (2, -1.0)]));
            assert!(add(&[(0, 1.0)]));
            assert!(!add(&[(2, 1e-6)]));
            assert!(!add(&[(1, 1e6)]));
            assert!(add(&[(7, 1.0)]));
        }
    }
}
