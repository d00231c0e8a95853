//! Time integration by the types of the library, for initial velocities and momenta that model files do not state.

use ancf::Model;
use ancf::assembly::Assembly;
use ancf::solver::dynamics::{SchemeCoefficients, TimeStepper};
use ancf::solver::equations::{EquationsOfMotion, State, System, Weights};
use ancf::solver::newton::{Newton, SolveError, StopRule};
use ancf::solver::sparse::SparseMatrix;
use nalgebra::Vector3;

use crate::VerificationError;

/// Constant mass matrix of an assembly.
pub(super) struct Inertia<'a> {
    assembly: &'a Assembly,
    mass: SparseMatrix,
}

/// Momenta, which are constant in free flight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Momenta {
    /// Linear momentum.
    pub linear: Vector3<f64>,
    /// Angular momentum about the origin.
    pub angular: Vector3<f64>,
    /// Mass times the position of the centre of mass.
    pub first: Vector3<f64>,
}

impl<'a> Inertia<'a> {
    pub(super) fn new(assembly: &'a Assembly) -> Self {
        let mut mass = assembly.system.matrix();
        assembly.system.tangent(&assembly.rest(), Weights::MASS, &mut mass);
        Self { assembly, mass }
    }

    /// Returns M x.
    fn times(&self, mut x: Vec<f64>) -> Vec<f64> {
        x.resize(self.mass.pattern().size(), 0.0);
        self.mass.times(&x)
    }

    /// Returns the momenta of a state, from its nodal vectors and M v.
    pub(super) fn momenta(&self, s: &State) -> Momenta {
        let mut places = vec![0.0; s.q.len()];
        let vectors: Vec<_> = self.assembly.bodies().flat_map(|(_, mesh)| mesh.vectors(s)).collect();
        for vector in &vectors {
            places[vector.first..vector.first + 3].copy_from_slice(vector.value.as_slice());
        }
        let (momentum, moment) = (self.times(s.v.clone()), self.times(places));
        let at = |x: &[f64], first: usize| Vector3::new(x[first], x[first + 1], x[first + 2]);
        let zero = Momenta { linear: Vector3::zeros(), angular: Vector3::zeros(), first: Vector3::zeros() };
        vectors.iter().fold(zero, |sum, vector| {
            let (p, m) = (at(&momentum, vector.first), at(&moment, vector.first));
            let is_position = f64::from(u8::from(vector.is_position()));
            Momenta {
                linear: sum.linear + p * is_position,
                angular: sum.angular + vector.value.cross(&p),
                first: sum.first + m * is_position,
            }
        })
    }
}

/// Assembles a model.
pub(super) fn assemble(model: &str) -> Result<Assembly, VerificationError> {
    Ok(Model::parse(model)?.assemble()?)
}

/// Creates the time integration from a state, with consistent initial conditions and an energy tolerance of 1e-10.
pub(super) fn dynamics(
    assembly: &Assembly,
    spectral_radius: f64,
    start: State,
) -> Result<TimeStepper<'_, System>, VerificationError> {
    let newton = Newton::new(assembly.system.matrix(), StopRule::Energy(1e-10), 50)
        .map_err(|e| failed(assembly, &e))?;
    let scheme = SchemeCoefficients::generalized_alpha(spectral_radius);
    let mut dynamics = TimeStepper::new(&assembly.system, scheme, newton, 10, start);
    dynamics.restart(0.0).map_err(|e| failed(assembly, &e))?;
    Ok(dynamics)
}

/// Integrates to a time with equal steps and passes every state to `show`.
///
/// If the loads jump at `to`, the last step uses the loads before the jump, and the integration restarts.
pub(super) fn advance(
    assembly: &Assembly,
    dynamics: &mut TimeStepper<'_, System>,
    to: f64,
    steps: u32,
    show: &mut dyn FnMut(&State),
) -> Result<(), VerificationError> {
    let from = dynamics.state().t;
    for step in 1..=steps {
        let is_last = step == steps;
        let t =
            if is_last { to.next_down() } else { from + (to - from) * f64::from(step) / f64::from(steps) };
        dynamics.advance(t).map_err(|e| failed(assembly, &e))?;
        show(dynamics.state());
    }
    if assembly.breaks().contains(&to) {
        dynamics.restart(to).map_err(|e| failed(assembly, &e))?;
    }
    Ok(())
}

fn failed(assembly: &Assembly, error: &SolveError) -> VerificationError {
    VerificationError::Failed {
        reason: error.to_string(),
        at: error.worst.map_or_else(|| "the whole system".to_owned(), |worst| assembly.name_of(worst)),
    }
}
