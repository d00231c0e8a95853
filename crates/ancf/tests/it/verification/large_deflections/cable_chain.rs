//! Straight cantilevers of cable elements along x, assembled from terms.

use std::sync::Arc;

use ancf::mechanics::constraints::{CoincidenceConstraint, ConstantAngle};
use ancf::mechanics::elements::{Cable12, CableProfile};
use ancf::mechanics::forces::Force;
use ancf::mechanics::kinematics::{BeamShape, Marker};
use ancf::solver::equations::{State, System, Term, Weights};
use ancf::solver::newton::{Newton, StopRule};
use nalgebra::Vector3;

/// Constrained coordinates at x = 0.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Root {
    /// r and r_x.
    Gradient,
    /// r and the direction of r_x; the stretch is free.
    Direction,
}

/// Cantilever with a marker at its end.
pub(super) struct CableCantilever {
    pub(super) system: System,
    cables: Vec<Cable12>,
    pub(super) tip: Marker,
    multipliers: usize,
}

impl CableCantilever {
    /// Cantilever of equal elements under a tip force and the gravity of the profile.
    pub(super) fn new(elements: usize, profile: CableProfile, force: Vector3<f64>, root: Root) -> Self {
        let (BeamShape { length, slope }, profile) = (profile.shape(), Arc::new(profile));
        let cable = |k| Cable12::new(std::array::from_fn(|i| 6 * k + i), Vector3::x(), Arc::clone(&profile));
        let cables: Vec<_> = (0..elements).map(cable).collect();
        let mut terms: Vec<Box<dyn Term>> = Vec::new();
        terms.extend(cables.iter().map(|cable| Box::new(cable.clone()) as Box<dyn Term>));
        let tip = Marker::new([(6 * elements, 1.0)], Vector3::x() * (length * elements as f64));
        terms.push(Box::new(Force::new(&tip, force)));
        let along = Marker::new([(3, 1.0 / slope)], Vector3::x());
        let ground = Marker::fixed(Vector3::zeros());
        terms.push(Box::new(CoincidenceConstraint::points(
            Marker::new([(0, 1.0)], Vector3::zeros()),
            &ground,
            0,
        )));
        let multipliers = if root == Root::Gradient {
            terms.push(Box::new(CoincidenceConstraint::directions(&along, Marker::fixed(Vector3::x()), 3)));
            6
        } else {
            for (axis, multiplier) in [(Vector3::y(), 3), (Vector3::z(), 4)] {
                terms.push(Box::new(ConstantAngle::new(&along, &Marker::fixed(axis), multiplier)));
            }
            5
        };
        Self { system: System::new(6 * (elements + 1), multipliers, terms), cables, tip, multipliers }
    }

    /// Reference state.
    pub(super) fn rest(&self) -> State {
        State::rest(6 * (self.cables.len() + 1), self.multipliers)
    }

    /// Returns the equilibrium by equal load steps, and the number of Newton iterations.
    pub(super) fn equilibrium(&self, steps: u32) -> (State, u32) {
        let mut state = self.rest();
        let mut newton = Newton::new(self.system.matrix(), StopRule::Energy(1e-10), 50).unwrap();
        let mut iterations = 0;
        for step in 1..=steps {
            state.load = f64::from(step) / f64::from(steps);
            iterations += newton.solve(&self.system, &mut state, Weights::STIFFNESS).unwrap().iterations;
        }
        (state, iterations)
    }

    /// The displacement of the tip.
    pub(super) fn moved(&self, state: &State) -> Vector3<f64> {
        self.tip.sum(&state.q)
    }

    /// Axial force and bending moment of an element at ξ.
    pub(super) fn resultants(&self, state: &State, element: usize, xi: f64) -> (f64, Vector3<f64>) {
        let own = 6 * element..6 * element + 12;
        self.cables[element].resultants(&state.q[own.clone()], &state.v[own], xi)
    }
}
