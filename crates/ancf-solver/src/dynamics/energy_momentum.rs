use std::cell::{Cell, RefCell};

use nalgebra::DVector;

use super::damping_work::PowerIntegral;
use crate::equations::{
    Energy, EquationsOfMotion, Level, Power, State, StepStates, StiffnessProducts, Weights,
};
use crate::newton::{Newton, NewtonReport, SolveError};
use crate::sparse::{Pattern, SparseMatrix};

/// Working storage of steps of the energy-momentum scheme.
#[derive(Debug)]
pub(crate) struct StepMiddle {
    state: State,
    floor: Vec<f64>,
}

impl StepMiddle {
    pub(crate) fn new(start: &State) -> Self {
        Self { state: start.clone(), floor: vec![0.0; start.q.len() + start.lambda.len()] }
    }
}

/// Equations of one step of the energy-momentum scheme, as equations of motion of its end.
///
/// M (v₁ − v₀)/h + f̄(q₀, q₁) + Φ_q(q_m)ᵀ λ = 0,  Φ(q₁) = 0. The discrete forces f̄ do exactly the work of their potential.
struct StepEquations<'a, E: ?Sized> {
    eom: &'a E,
    from: &'a State,
    damping: f64,
    middle: RefCell<&'a mut StepMiddle>,
    /// True until the first tangent. The end is then a prediction, and its stresses are those of the error of rotations.
    predicted: Cell<bool>,
}

impl<E: EquationsOfMotion + ?Sized> StepEquations<'_, E> {
    /// Calls `work` with the step to a state.
    fn with_step(&self, to: &State, work: impl FnOnce(&StepStates<'_>)) {
        let middle = &mut self.middle.borrow_mut().state;
        middle.set_middle(self.from, to);
        work(&StepStates { from: self.from, middle, to, damping: self.damping });
    }
}

impl<E: EquationsOfMotion + ?Sized> EquationsOfMotion for StepEquations<'_, E> {
    fn coordinates(&self) -> usize {
        self.eom.coordinates()
    }

    fn multipliers(&self) -> usize {
        self.eom.multipliers()
    }

    fn energy_size(&self, s: &State) -> f64 {
        self.eom.energy_size(s)
    }

    fn residual(&self, s: &State, r: &mut [f64]) {
        self.with_step(s, |step| self.eom.average_residual(step, r));
    }

    fn constraints(&self, s: &State, level: Level, phi: &mut [f64]) {
        self.eom.constraints(s, level, phi);
    }

    /// Bounds the errors by those of the middle and of the end.
    fn rounding(&self, s: &State, floor: &mut [f64]) {
        self.eom.rounding(s, floor);
        let StepMiddle { state, floor: of_middle } = &mut **self.middle.borrow_mut();
        state.set_middle(self.from, s);
        self.eom.rounding(state, of_middle);
        floor.iter_mut().zip(of_middle).for_each(|(floor, of_middle)| *floor += *of_middle);
    }

    fn pattern(&self) -> &Pattern {
        self.eom.pattern()
    }

    /// Assembles the tangent, first with the stresses of the start.
    fn tangent(&self, s: &State, w: Weights, k: &mut SparseMatrix) {
        let predicted = self.predicted.replace(false);
        self.with_step(s, |step| {
            let to = if predicted { step.from } else { step.to };
            self.eom.average_tangent(&StepStates { to, ..*step }, w, k);
        });
    }

    fn stiffness_products(&self, s: &State, x: &[DVector<f64>]) -> StiffnessProducts {
        self.eom.stiffness_products(s, x)
    }

    fn stress_stiffness(&self, s: &State, by: &State, k: &mut SparseMatrix) {
        self.eom.stress_stiffness(s, by, k);
    }

    fn energy(&self, s: &State) -> Energy {
        self.eom.energy(s)
    }
}

impl StepMiddle {
    /// Iterates the end of a step of the energy-momentum scheme from its prediction.
    pub(crate) fn solve<E: EquationsOfMotion>(
        &mut self,
        eom: &E,
        newton: &mut Newton,
        (from, to): (&State, &mut State),
        damping: f64,
        w: Weights,
    ) -> Result<NewtonReport, SolveError> {
        let (middle, predicted) = (RefCell::new(self), Cell::new(true));
        newton.solve(&StepEquations { eom, from, damping, middle, predicted }, to, w)
    }

    /// Computes powers at the end of a step, and the work and dissipation of the forces in its middle, which are set.
    ///
    /// With the mean velocity v_m, the damping forces F do exactly the work h v_m·F.
    pub(crate) fn exchange<E: EquationsOfMotion>(
        &mut self,
        eom: &E,
        (from, to): (&State, &State),
        force: &mut [f64],
    ) -> (PowerIntegral, Power) {
        let (h, at_end) = (to.t - from.t, eom.exchange(to, force));
        self.state.set_middle(from, to);
        let Power { work, dissipation } = eom.exchange(&self.state, force);
        let damped: f64 = self.state.v.iter().zip(force).map(|(v, force)| v * *force).sum();
        (PowerIntegral::new(at_end), Power { work: h * work, dissipation: h * (dissipation + damped) })
    }
}
