use std::collections::{BTreeSet, HashMap, HashSet};
use std::ops::Range;

use ancf_solver::equations::{Level, Local, State, Term, all_constraint_rows};
use ancf_solver::factor::{Dependence, SparseRow, dependences};

use super::redundant::Redundant;
use crate::joints::JointEquations;

/// Redundant equations agree if their relative residual is at most this.
const AGREE: f64 = 1e-9;
/// Redundant equations separate if their relative residual exceeds this, and the residual exceeds the rounding bound by the
/// inverse of this.
pub(crate) const APART: f64 = 1e-3;
/// Multiple of the rounding bound within which redundant equations agree.
const ROUNDING: f64 = 8.0;

/// Constraints of a model as terms, by multiplier.
pub(crate) struct Constraints<'a> {
    terms: Vec<&'a dyn Term>,
    joints: &'a [JointEquations],
    /// Names of the couplings, whose multipliers are the last ones.
    couplings: Vec<&'a str>,
    pub(crate) multipliers: usize,
}

/// Owner of a multiplier, with its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Owner {
    Joint(usize),
    Coupling(usize),
}

impl<'a> Constraints<'a> {
    pub(crate) fn new(
        terms: impl IntoIterator<Item = &'a dyn Term>,
        joints: &'a [JointEquations],
        couplings: impl IntoIterator<Item = &'a String>,
    ) -> Self {
        // The coordinate of a gas appears in its equation only, which is therefore independent.
        let gases: Vec<Range<usize>> =
            joints.iter().filter(|own| !own.is_joint()).map(|own| own.multipliers.clone()).collect();
        let is_of_gas = |term: &&dyn Term| gases.contains(&term.multipliers());
        let terms = terms.into_iter().filter(|term| !term.multipliers().is_empty() && !is_of_gas(term));
        let terms: Vec<_> = terms.collect();
        let multipliers = terms.iter().map(|term| term.multipliers().end).max().unwrap_or(0);
        Self { terms, joints, couplings: couplings.into_iter().map(String::as_str).collect(), multipliers }
    }

    /// Rows of Φ_q in a state, by multiplier.
    fn rows(&self, s: &State) -> Vec<SparseRow> {
        all_constraint_rows(self.terms.iter().copied(), self.multipliers, s)
    }

    /// Rows that depend on earlier rows in a state.
    pub(crate) fn dependences(&self, s: &State, tolerance: f64) -> Vec<Dependence> {
        dependences(self.rows(s), tolerance)
    }

    /// Multipliers that are undetermined because of dependences, in this state or others: all that share coordinates with
    /// them, directly or through other constraints.
    pub(crate) fn undetermined(&self, found: &[Dependence], s: &State) -> BTreeSet<usize> {
        let rows = if found.is_empty() { Vec::new() } else { self.rows(s) };
        let mut of: HashMap<usize, Vec<usize>> = HashMap::new();
        for (i, row) in rows.iter().enumerate() {
            row.iter().for_each(|&(c, _)| of.entry(c).or_default().push(i));
        }
        let mut open: Vec<usize> = found.iter().map(Dependence::row).collect();
        let mut reached: BTreeSet<usize> = open.iter().copied().collect();
        while let Some(i) = open.pop() {
            for (c, _) in &rows[i] {
                let neighbours = of.remove(c).unwrap_or_default();
                open.extend(neighbours.into_iter().filter(|&other| reached.insert(other)));
            }
        }
        reached
    }

    /// Joint or coupling of a multiplier; `None` for other constraints.
    pub(crate) fn owner(&self, multiplier: usize) -> Option<Owner> {
        let coupling = multiplier.checked_sub(self.multipliers - self.couplings.len());
        let after = self.joints.partition_point(|joint| joint.multipliers.start <= multiplier);
        let joint = || (0..after).rev().find(|&k| self.joints[k].multipliers.contains(&multiplier));
        coupling.map(Owner::Coupling).or_else(|| joint().map(Owner::Joint))
    }

    fn name(&self, owner: Owner) -> String {
        match owner {
            Owner::Joint(k) => self.joints[k].name.clone(),
            Owner::Coupling(k) => self.couplings[k].to_owned(),
        }
    }

    /// Descriptions of dependences.
    pub(crate) fn words(&self, found: &[Dependence]) -> Vec<Redundant> {
        found.iter().filter_map(|dependence| self.describe(dependence)).collect()
    }

    pub(crate) fn describe(&self, dependence: &Dependence) -> Option<Redundant> {
        let (row, own) = (dependence.row(), self.owner(dependence.row())?);
        let others: BTreeSet<Owner> = dependence.others().filter_map(|row| self.owner(row)).collect();
        let with = others.into_iter().map(|other| self.name(other)).collect();
        let (coupling, equation) = match own {
            Owner::Joint(k) => {
                let joint = &self.joints[k];
                (false, joint.names()[row - joint.multipliers.start].clone())
            }
            Owner::Coupling(_) => (true, "coupling".to_owned()),
        };
        Some(Redundant { joint: self.name(own), coupling, equation, with })
    }

    /// Dependences with inconsistent values, in the reference state or in one of the `states` at rest.
    ///
    /// Dependences of nonlinear constraints are evaluated in the reference state only.
    pub(crate) fn contradictions<'d>(
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

    /// Residuals Φ in a state at rest, and bounds of their rounding errors.
    pub(crate) fn values(&self, s: &State) -> [Vec<f64>; 2] {
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

    /// Linear constraints: rows of Φ_q that do not depend on the state.
    fn linear(&self, s: &State) -> HashSet<usize> {
        let mut elsewhere = s.clone();
        // Any place without symmetry is suitable.
        (0..s.q.len()).for_each(|i| elsewhere.q[i] += (1.7 * (i + 1) as f64).sin());
        let (here, there) = (self.rows(s), self.rows(&elsewhere));
        (0..self.multipliers).filter(|&row| here[row] == there[row]).collect()
    }
}
