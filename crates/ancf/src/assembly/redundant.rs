//! Joint equations that follow from others: by name, and whether they contradict them.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::fmt;

use ancf_solver::equations::{
    Dependence, INDEPENDENT, Level, Local, State, Term, all_constraint_rows, dependences,
};
use ancf_solver::factor::Sparse;

use super::assemble::Assembly;
use super::joint_builder::JointEquations;
use crate::model::{Analysis, Clock, Model, ModelError};
use crate::schema::Finding;

/// Redundant equations agree if no more than this part of what they say is left over.
const AGREE: f64 = 1e-9;
/// They part if more than this is left over, which is also beyond as many rounding bounds as this is of 1.
const APART: f64 = 1e-3;
/// Rounding bounds within which they agree as well.
const ROUNDING: f64 = 8.0;
/// Instants of a motion at which they are compared.
const INSTANTS: u32 = 128;

/// A joint equation that follows from others, in words: its forces are shared with theirs.
#[derive(Clone, Debug, PartialEq, Eq, serde::Serialize)]
pub struct Redundant {
    /// Name of the joint or coupling, the last in the model of those that depend on each other, couplings after joints.
    pub joint: String,
    /// Whether it is a coupling.
    pub coupling: bool,
    /// The equation, such as "hinge axis, second equation".
    pub equation: String,
    /// Names of the joints, then of the couplings, from which it follows.
    pub with: Vec<String>,
}

impl fmt::Display for Redundant {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let kind = if self.coupling { "coupling" } else { "joint" };
        match self.coupling {
            true => write!(f, "{kind} `{}`", self.joint)?,
            false => write!(f, "{kind} `{}`: {}", self.joint, self.equation)?,
        }
        // What a coupling follows from may be a coupling too.
        match (self.with.as_slice(), self.coupling) {
            ([], _) => write!(f, ", ties nothing that could move"),
            ([one], false) => write!(f, ", follows from joint `{one}`"),
            ([one], true) => write!(f, ", follows from `{one}`"),
            ([first @ .., last], _) => {
                let joints = if self.coupling { "" } else { "joints " };
                let first: Vec<String> = first.iter().map(|name| format!("`{name}`")).collect();
                write!(f, ", follows from {joints}{} and `{last}`", first.join(", "))
            }
        }
    }
}

/// The constraints of a model: terms by their multipliers.
pub(crate) struct Constraints<'a> {
    terms: Vec<&'a dyn Term>,
    joints: &'a [JointEquations],
    /// Names of couplings; their multipliers are the last ones.
    couplings: Vec<&'a str>,
    multipliers: usize,
}

/// What a multiplier belongs to, by number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Owner {
    Joint(usize),
    Coupling(usize),
}

impl<'a> Constraints<'a> {
    pub(crate) fn new(
        terms: impl IntoIterator<Item = &'a dyn Term>,
        joints: &'a [JointEquations],
        couplings: impl IntoIterator<Item = &'a String>,
    ) -> Self {
        let terms: Vec<_> = terms.into_iter().filter(|term| !term.multipliers().is_empty()).collect();
        let multipliers = terms.iter().map(|term| term.multipliers().end).max().unwrap_or(0);
        Self { terms, joints, couplings: couplings.into_iter().map(String::as_str).collect(), multipliers }
    }

    /// The rows of Φ_q in a state, by multiplier.
    fn rows(&self, s: &State) -> Vec<Sparse> {
        all_constraint_rows(self.terms.iter().copied(), self.multipliers, s)
    }

    /// The rows that follow from earlier ones in a state.
    pub(crate) fn dependences(&self, s: &State, tolerance: f64) -> Vec<Dependence> {
        dependences(self.rows(s), tolerance)
    }

    /// The multipliers that dependences leave undetermined, here or as bodies move: all that share coordinates with them,
    /// be it by way of others.
    pub(crate) fn undetermined(&self, found: &[Dependence], s: &State) -> BTreeSet<usize> {
        let rows = if found.is_empty() { Vec::new() } else { self.rows(s) };
        let mut of: HashMap<usize, Vec<usize>> = HashMap::new();
        for (i, row) in rows.iter().enumerate() {
            row.keys().for_each(|&c| of.entry(c).or_default().push(i));
        }
        let mut open: Vec<usize> = found.iter().map(Dependence::row).collect();
        let mut reached: BTreeSet<usize> = open.iter().copied().collect();
        while let Some(i) = open.pop() {
            for c in rows[i].keys() {
                let neighbours = of.remove(c).unwrap_or_default();
                open.extend(neighbours.into_iter().filter(|&other| reached.insert(other)));
            }
        }
        reached
    }

    /// The joint or the coupling that a multiplier belongs to, if it is one of either.
    fn owner(&self, multiplier: usize) -> Option<Owner> {
        let coupling = multiplier.checked_sub(self.multipliers - self.couplings.len());
        let after = self.joints.partition_point(|joint| joint.range().start <= multiplier);
        let joint = || (0..after).rev().find(|&k| self.joints[k].range().contains(&multiplier));
        coupling.map(Owner::Coupling).or_else(|| joint().map(Owner::Joint))
    }

    fn name(&self, owner: Owner) -> String {
        match owner {
            Owner::Joint(k) => self.joints[k].name.clone(),
            Owner::Coupling(k) => self.couplings[k].to_owned(),
        }
    }

    /// Dependences in words.
    pub(crate) fn words(&self, found: &[Dependence]) -> Vec<Redundant> {
        found.iter().filter_map(|dependence| self.describe(dependence)).collect()
    }

    fn describe(&self, dependence: &Dependence) -> Option<Redundant> {
        let (row, own) = (dependence.row(), self.owner(dependence.row())?);
        let others: BTreeSet<Owner> = dependence.others().filter_map(|row| self.owner(row)).collect();
        let with = others.into_iter().map(|other| self.name(other)).collect();
        let (coupling, equation) = match own {
            Owner::Joint(k) => {
                let joint = &self.joints[k];
                (false, joint.ties()[row - joint.range().start].clone())
            }
            Owner::Coupling(_) => (true, "coupling".to_owned()),
        };
        Some(Redundant { joint: self.name(own), coupling, equation, with })
    }

    /// Those dependences that contradict what they depend on, in the reference state or in one of some states of rest.
    ///
    /// Of constraints that are not linear a dependence is one of the reference state, which alone has a say about them.
    fn contradictions<'d>(
        &self,
        found: &'d [Dependence],
        reference: Option<&State>,
        states: impl Iterator<Item = State>,
    ) -> Vec<&'d Dependence> {
        let mut wrong = HashSet::new();
        let mut judge = |s: &State, linear: &HashSet<usize>| {
            let [phi, floor] = self.values(s);
            for (k, Dependence { coefficients }) in found.iter().enumerate() {
                let sum = |of: &dyn Fn(usize, f64) -> f64| {
                    coefficients.iter().map(|(&i, &c)| of(i, c)).sum::<f64>()
                };
                let (left, size) = (sum(&|i, c| c * phi[i]), sum(&|i, c| (c * phi[i]).abs()));
                let rounding = sum(&|i, c| (c * floor[i]).abs());
                let is_judged = coefficients.keys().all(|row| linear.contains(row));
                if is_judged && left.abs() > AGREE * size + ROUNDING * rounding {
                    wrong.insert(k);
                }
            }
        };
        if let Some(reference) = reference {
            judge(reference, &(0..self.multipliers).collect());
        }
        let mut linear = None;
        for s in states {
            judge(&s, linear.get_or_insert_with(|| self.linear(&s)));
        }
        (0..found.len()).filter(|k| wrong.contains(k)).map(|k| &found[k]).collect()
    }

    /// Φ in a state of rest, and a bound of its rounding error.
    fn values(&self, s: &State) -> [Vec<f64>; 2] {
        let [mut phi, mut floor] = [vec![0.0; self.multipliers], vec![0.0; self.multipliers]];
        for term in &self.terms {
            let (n, m) = (term.coordinates().len(), term.multipliers());
            let q: Vec<f64> = term.coordinates().iter().map(|&c| s.q[c]).collect();
            let (zero, lambda) = (vec![0.0; n], vec![0.0; m.len()]);
            let at = Local { q: &q, v: &zero, a: &zero, lambda: &lambda, t: s.t, load: s.load };
            term.constraints(&at, Level::Position, &mut phi[m.clone()]);
            let mut rounding = vec![0.0; n + m.len()];
            term.rounding(&at, &mut rounding);
            // The terms of a slide share multipliers.
            floor[m].iter_mut().zip(&rounding[n..]).for_each(|(sum, part)| *sum += part);
        }
        [phi, floor]
    }

    /// The rows of Φ_q that are the same wherever bodies are.
    fn linear(&self, s: &State) -> HashSet<usize> {
        let mut elsewhere = s.clone();
        // Any place will do that has no symmetry.
        (0..s.q.len()).for_each(|i| elsewhere.q[i] += (1.7 * (i + 1) as f64).sin());
        let (here, there) = (self.rows(s), self.rows(&elsewhere));
        (0..self.multipliers).filter(|&row| here[row] == there[row]).collect()
    }
}

/// Finds joints that contradict others: they tie what those tie, to something else.
///
/// The model must obey all other rules.
pub(crate) fn contradictions(model: &Model) -> Vec<Finding> {
    let clock = model.clock();
    let meshes = model.meshes();
    let joints = model.joint_equations(&meshes, clock);
    let bodies = meshes.iter().flat_map(|(_, body)| body.terms());
    let of_joints = joints.iter().flat_map(JointEquations::terms);
    let couplings = model.coupling_terms(&meshes, &joints);
    let terms: Vec<Box<dyn Term>> = bodies.chain(of_joints).chain(couplings).collect();
    let constraints = Constraints::new(
        terms.iter().map(AsRef::as_ref),
        &joints,
        model.couplings.iter().map(|coupling| &coupling.name),
    );
    let [coordinates, _] = Model::numbers(&meshes, &joints);
    let rest = State::rest(coordinates, constraints.multipliers);
    let found = constraints.dependences(&rest, INDEPENDENT);
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
        ModelError::new(path, found, "joints that agree where they tie the same").into()
    };
    let owners: BTreeSet<Owner> = findings.iter().map(|(owner, _)| *owner).collect();
    owners.into_iter().map(of).collect()
}

/// Times at which functions of time are compared.
fn instants(model: &Model) -> Vec<f64> {
    let Analysis::Dynamics(dynamics) = &model.analysis else { return vec![0.0] };
    if model.has_functions(false) {
        return vec![0.0]; // What drives will do is not known yet, but that they start from 0.
    }
    let end = dynamics.duration;
    let mut times: Vec<f64> = (0..=INSTANTS).map(|k| end * f64::from(k) / f64::from(INSTANTS)).collect();
    let breaks = model.breaks(Clock::Runs);
    times.extend(breaks.iter().copied().filter(|t| (0.0..=end).contains(t)));
    times.extend(breaks.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).filter(|t| (0.0..=end).contains(t)));
    times
}

impl Assembly {
    /// The joint equations that follow from others in the reference state, by name: forces are shared between them in least
    /// squares, and none of the motion depends on how.
    pub fn redundant(&self) -> &[Redundant] {
        &self.redundant
    }

    /// The joint equations that follow from others in a state, or nearly do, and by how much they miss it: less than
    /// `tolerance`, relative to what they tie.
    pub fn redundant_in(&self, s: &State, tolerance: f64) -> Vec<Redundant> {
        let constraints = self.constraints();
        constraints.words(&constraints.dependences(s, tolerance))
    }

    /// The joint equations that contradict others in a state, by name.
    pub fn contradicting(&self, s: &State) -> Vec<Redundant> {
        let constraints = self.constraints();
        let found = constraints.dependences(s, INDEPENDENT);
        let wrong = constraints.contradictions(&found, None, std::iter::once(s.clone()));
        wrong.into_iter().filter_map(|dependence| constraints.describe(dependence)).collect()
    }

    /// The joint equations that part from those they depend on when time goes on from a state, by name: of equations that are
    /// not linear, where [`contradicting`](Self::contradicting) does not judge. The state is that of a solution but for its time.
    pub(crate) fn parting(&self, s: &State) -> Vec<Redundant> {
        let constraints = self.constraints();
        let found = constraints.dependences(s, INDEPENDENT);
        let [phi, floor] = constraints.values(s);
        let parts = |dependence: &&Dependence| {
            let sum = |of: &dyn Fn(usize) -> f64| {
                dependence.coefficients.iter().map(|(&i, &c)| of(i) * c).sum::<f64>()
            };
            let size = dependence.coefficients.iter().map(|(&i, &c)| (c * phi[i]).abs()).sum::<f64>();
            let left = sum(&|i| phi[i]).abs();
            let rounding: f64 = dependence.coefficients.iter().map(|(&i, &c)| (c * floor[i]).abs()).sum();
            left > APART * size && left > 1.0 / APART * rounding
        };
        found.iter().filter(parts).filter_map(|dependence| constraints.describe(dependence)).collect()
    }

    /// By how much the constraint equations exceed their rank in the reference state.
    pub(crate) fn rank_deficiency(&self) -> usize {
        self.constraints().dependences(&self.rest(), INDEPENDENT).len()
    }

    /// Multipliers that redundant equations leave undetermined.
    pub(crate) fn undetermined(&self) -> impl Iterator<Item = usize> {
        self.undetermined.iter().copied()
    }

    pub(crate) fn constraints(&self) -> Constraints<'_> {
        Constraints::new(self.system.terms().iter().map(AsRef::as_ref), &self.joints, &self.couplings)
    }

    /// Finds out what is redundant, and has its multipliers shared.
    pub(crate) fn sharing(mut self) -> Self {
        let (rest, constraints) = (self.rest(), self.constraints());
        let found = constraints.dependences(&rest, INDEPENDENT);
        let undetermined = constraints.undetermined(&found, &rest);
        self.redundant = constraints.words(&found);
        self.system = self.system.sharing(undetermined.iter().copied());
        self.undetermined = undetermined;
        self
    }
}

impl JointEquations {
    /// What each of its equations ties, in words; those that tie the same are counted.
    pub(crate) fn ties(&self) -> Vec<String> {
        let mut terms: Vec<Box<dyn Term>> = self.terms().collect();
        terms.retain(|term| !term.multipliers().is_empty());
        terms.sort_by_key(|term| term.multipliers().start);
        // The terms of a slide share multipliers.
        terms.dedup_by_key(|term| term.multipliers().start);
        let names = terms.iter().flat_map(|term| (0..term.multipliers().len()).map(|k| term.tie(k)));
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
