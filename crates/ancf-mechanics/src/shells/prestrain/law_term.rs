use ancf_solver::equations::{Energy, LOCAL, Local, LocalMatrix, LocalStep, Term, Weights};
use nalgebra::{Matrix3, Vector3};

use super::law_element::LawElement;
use super::prescription::{Prescribed, Prescription};
use super::source::SurfacePrestrain;
use crate::shells::laminates::MembranePoints;

/// Prescribed strains ε⁰ of a shell element with a law of the membrane forces.
///
/// The term is the difference between the element with prescribed strains and the element without: membrane forces n(ε, ε⁰) − n(ε),
/// moments −D κ⁰ and viscous stresses −τD ε̇⁰.
#[derive(Clone)]
pub(super) struct LawPrestrain<E: LawElement>(Prescription<E>);

/// Strains at the points of an element in a state, with the prescribed ones.
struct Strained<'a, E: LawElement> {
    element: &'a E,
    law: &'a MembranePoints,
    total: E::Strains,
    prescribed: Prescribed<E::Strains>,
}

impl<'a, E: LawElement> Strained<'a, E> {
    fn new(element: &'a E, total: E::Strains, prescribed: Prescribed<E::Strains>) -> Self {
        let law = element.law().expect("the term belongs to an element with a law");
        Self { element, law, total, prescribed }
    }

    /// Calls a function with the membrane strain at a point and the prescribed one.
    fn at<T>(&self, k: usize, of: impl FnOnce([&Vector3<f64>; 2]) -> T) -> T {
        let [total, prescribed] =
            [&self.total, &self.prescribed.strains].map(|strains| self.element.membrane_at(strains, k));
        of([&total, &prescribed])
    }

    /// Returns the linear stresses of a multiple of strains, with other forces at the points.
    fn stress(&self, factor: f64, strains: &E::Strains, force: impl Fn(usize) -> Vector3<f64>) -> E::Strains {
        let mut stress = self.element.stress_of(&E::scaled(factor, strains));
        self.element.set_forces(&mut stress, &force);
        stress
    }

    /// Returns the change of the elastic stresses.
    fn elastic(&self) -> E::Strains {
        self.stress(-1.0, &self.prescribed.strains, |k| {
            let [with, without] = self.at(k, |strains| self.law.forces(k, strains));
            with - without
        })
    }

    /// Adds the viscous stresses.
    fn with_damping(&self, mut stress: E::Strains) -> E::Strains {
        let time = self.element.retardation();
        if time != 0.0 {
            E::add(&mut stress, -time, &self.element.stress_of(&self.prescribed.rates));
        }
        stress
    }

    fn stiffness_change(&self, k: usize) -> Matrix3<f64> {
        self.at(k, |strains| self.law.stiffness_change(k, strains))
    }

    /// Returns the sum of a function over the points.
    fn sum(&self, of: impl Fn(usize) -> f64) -> f64 {
        (0..self.element.membrane_points()).map(of).sum()
    }
}

impl<E: LawElement> LawPrestrain<E> {
    /// Creates the term of an element with a law for the sources that cover it.
    pub(super) fn new(element: E, sources: Vec<SurfacePrestrain>) -> Self {
        Self(Prescription::new(element, sources))
    }

    const fn element(&self) -> &E {
        &self.0.element
    }

    fn strained(&self, at: &Local<'_>) -> Strained<'_, E> {
        Strained::new(self.element(), self.element().strains_of(at.q), self.0.at(at))
    }

    /// Adds a multiple of the stiffness of stresses and of the change of the material stiffness.
    fn add_tangent(
        &self,
        (q, strained): (&[f64], &Strained<'_, E>),
        stress: &E::Strains,
        w: f64,
        k: &mut LocalMatrix<'_>,
    ) {
        self.element().add_stiffness_of(q, &E::scaled(w, stress), k);
        self.element().add_membrane_stiffness(q, &|point| strained.stiffness_change(point) * w, k);
    }

    /// Computes the stresses of a step, whose work on the changes of the strains is the change of the energy at the prescribed strains
    /// of the middle.
    fn step_stress(&self, step: &LocalStep<'_>) -> E::Strains {
        let (ends, [of_before, of_after]) = (self.element().strains_of_ends(step), step.shares());
        let mut total = E::scaled(of_before, &ends[0]);
        E::add(&mut total, of_after, &ends[1]);
        let strained = Strained::new(self.element(), total, self.0.at(&step.middle));
        let mut stress = strained.elastic();
        let corrected = strained.stress(0.0, &ends[0], |k| {
            let [before, after] = [&ends[0], &ends[1]].map(|end| self.element().membrane_at(end, k));
            let prescribed = self.element().membrane_at(&strained.prescribed.strains, k);
            strained.law.correction_change(k, [before, after], &prescribed)
        });
        E::add(&mut stress, 1.0, &corrected);
        self.element().exact_work(strained.with_damping(stress), step)
    }
}

impl<E: LawElement> Term for LawPrestrain<E> {
    fn coordinates(&self) -> &[usize] {
        self.element().coordinates()
    }

    fn residual(&self, at: &Local<'_>, r: &mut [f64]) {
        let strained = self.strained(at);
        self.element().add_forces_of(at.q, &strained.with_damping(strained.elastic()), r);
    }

    /// Adds the bounds of the forces with the prescribed strains and without, and those of the strains, which the element has too.
    fn rounding(&self, at: &Local<'_>, floor: &mut [f64]) {
        let strained = self.strained(at);
        let sum = strained.stress(1.0, &strained.prescribed.strains, |k| {
            let [with, without] = strained.at(k, |strains| strained.law.forces(k, strains));
            with.abs() + without.abs()
        });
        self.element().add_rounding_of(at.q, &strained.with_damping(sum), floor);
        let still = &[0.0; LOCAL][..at.q.len()];
        self.element().rounding(&Local { v: still, a: still, load: 0.0, ..*at }, floor);
    }

    fn tangent(&self, at: &Local<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        if w.q != 0.0 {
            let strained = self.strained(at);
            self.add_tangent((at.q, &strained), &strained.with_damping(strained.elastic()), w.q, k);
        }
    }

    fn average_residual(&self, step: &LocalStep<'_>, r: &mut [f64]) {
        self.element().add_forces_of(step.middle.q, &self.step_stress(step), r);
    }

    fn average_tangent(&self, step: &LocalStep<'_>, w: Weights, k: &mut LocalMatrix<'_>) {
        let strained = self.strained(&step.middle);
        self.add_tangent((step.middle.q, &strained), &self.step_stress(step), w.q, k);
    }

    fn has_stress_prediction(&self) -> bool {
        true
    }

    /// Both states have the prescribed strains of the first.
    fn stress_prediction(&self, at: &Local<'_>, from: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let (element, now) = (self.element(), self.strained(at));
        let then = Strained::new(element, element.strains_of(from.q), self.0.at(at));
        let change: Vec<f64> = at.q.iter().zip(from.q).map(|(now, then)| now - then).collect();
        let change = element.rates_of(from.q, &change);
        let stress = now.stress(0.0, &change, |k| {
            let [[with, without], [with_now, without_now]] =
                [&then, &now].map(|strained| strained.at(k, |strains| strained.law.forces(k, strains)));
            let linear = then.stiffness_change(k) * element.membrane_at(&change, k);
            with - without + linear - (with_now - without_now)
        });
        element.add_stiffness_of(at.q, &stress, k);
    }

    /// First-order response of the prescribed strains to the increment of the load factor.
    fn stress_stiffness(&self, at: &Local<'_>, by: &Local<'_>, k: &mut LocalMatrix<'_>) {
        let element = self.element();
        let strained = Strained::new(element, element.strains_of(at.q), self.0.response(at, by));
        let (own, rates) = (element.rates_of(at.q, by.q), &strained.prescribed.rates);
        let stress = strained.stress(-1.0, rates, |k| {
            let [own, prescribed] = [&own, rates].map(|rates| element.membrane_at(rates, k));
            strained.at(k, |strains| strained.law.rate_change(k, strains, [&own, &prescribed]))
        });
        element.add_stiffness_of(at.q, &stress, k);
    }

    fn energy(&self, at: &Local<'_>) -> Energy {
        let strained = self.strained(at);
        let prescribed = &strained.prescribed.strains;
        let stress = strained.stress(1.0, prescribed, |_| Vector3::zeros());
        let bending = 0.5 * E::product(&stress, prescribed) - E::product(&stress, &strained.total);
        let of = |k: usize| strained.at(k, |strains| strained.law.energy_change(k, strains));
        Energy { strain: bending + strained.sum(of), ..Energy::default() }
    }

    /// Returns ε̇⁰ ∂W/∂ε⁰ + ε̇ τD ε̇⁰ of all points.
    fn supplied_power(&self, at: &Local<'_>) -> f64 {
        let strained = self.strained(at);
        let Prescribed { strains: prescribed, rates } = &strained.prescribed;
        let stress = strained.stress(1.0, rates, |_| Vector3::zeros());
        let bending = E::product(&stress, prescribed) - E::product(&stress, &strained.total);
        let of = |k: usize| {
            let force = strained.at(k, |strains| strained.law.prescribed_force(k, strains));
            -force.dot(&self.element().membrane_at(rates, k))
        };
        let viscous = self.0.viscous_power(rates, &self.element().rates_of(at.q, at.v));
        bending + strained.sum(of) + viscous
    }

    fn is_damped(&self) -> bool {
        false
    }

    fn flow_power(&self, at: &Local<'_>) -> f64 {
        self.0.flow_power(at)
    }
}
