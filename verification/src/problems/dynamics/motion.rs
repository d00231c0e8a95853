//! Motions by the library's own types, for what model files do not state: velocities at the start, momenta.

use ancf::Model;
use ancf::analysis::{Dynamics, Newton, Scheme, SolveError, Stop};
use ancf::model::Assembly;
use ancf::system::{EquationsOfMotion, SparseMatrix, State, System, Weights};
use nalgebra::Vector3;

use crate::Error;

/// A body's vectors, and the mass matrix, which is constant.
pub(super) struct Inertia<'a> {
    assembly: &'a Assembly,
    mass: SparseMatrix,
}

/// What is kept in free flight.
#[derive(Clone, Copy, Debug)]
pub(super) struct Momenta {
    /// Momentum.
    pub linear: Vector3<f64>,
    /// Moment of momentum about the origin.
    pub angular: Vector3<f64>,
    /// Mass times the place of the centre.
    pub first: Vector3<f64>,
}

impl<'a> Inertia<'a> {
    pub(super) fn new(assembly: &'a Assembly) -> Self {
        let mut mass = assembly.system.matrix();
        assembly.system.tangent(&assembly.rest(), Weights::MASS, &mut mass);
        Self { assembly, mass }
    }

    /// M x, forces on the coordinates.
    fn times(&self, mut x: Vec<f64>) -> Vec<f64> {
        x.resize(self.mass.pattern().size(), 0.0);
        self.mass.times(&x)
    }

    /// Momenta of a state: those of its nodal vectors e, as they move with M v.
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

/// A model that will be moved by hand.
pub(super) fn assemble(model: &str) -> Result<Assembly, Error> {
    Ok(Model::parse(model)?.assemble()?)
}

/// The dynamics from a state, made consistent, by steps that are solved to 1e-10 in energy's root.
pub(super) fn dynamics(
    assembly: &Assembly,
    spectral_radius: f64,
    start: State,
) -> Result<Dynamics<'_, System>, Error> {
    let newton =
        Newton::new(assembly.system.matrix(), Stop::Energy(1e-10), 50).map_err(|e| failed(assembly, &e))?;
    let scheme = Scheme::generalized_alpha(spectral_radius);
    let mut dynamics = Dynamics::new(&assembly.system, scheme, newton, 10, start);
    dynamics.restart(0.0).map_err(|e| failed(assembly, &e))?;
    Ok(dynamics)
}

/// Moves on to a time by equal steps and shows every state. A jump of the loads may be there: they end with those before it, and
/// the motion begins anew.
pub(super) fn advance(
    assembly: &Assembly,
    dynamics: &mut Dynamics<'_, System>,
    to: f64,
    steps: u32,
    show: &mut dyn FnMut(&State),
) -> Result<(), Error> {
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

fn failed(assembly: &Assembly, error: &SolveError) -> Error {
    Error::Failed {
        reason: error.to_string(),
        at: error.worst.map_or_else(|| "the whole system".to_owned(), |worst| assembly.name_of(worst)),
    }
}
