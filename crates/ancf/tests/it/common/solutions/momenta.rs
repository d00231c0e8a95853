//! Linear and angular momentum.

use std::io;
use std::ops::ControlFlow;

use ancf::assembly::Assembly;
use ancf::solver::equations::{EquationsOfMotion, State, Weights};
use ancf::{Model, Observer, Simulation};
use nalgebra::Vector3;

/// Returns ∑ M x and ∑ r × M x over the nodal vectors: the momenta about the origin for x = v.
///
/// Translations move positions only, rotations all nodal vectors.
pub(crate) fn momenta(assembly: &Assembly, s: &State, x: &[f64]) -> [Vector3<f64>; 2] {
    let system = &assembly.system;
    let mut mass = system.matrix();
    system.tangent(s, Weights::MASS, &mut mass);
    let mut full = x.to_vec();
    full.resize(s.q.len() + s.lambda.len(), 0.0);
    let p = mass.times(&full);
    let vectors: Vec<_> = assembly.bodies().flat_map(|(_, body)| body.vectors(s)).collect();
    let of = |first: usize| Vector3::from_column_slice(&p[first..first + 3]);
    let linear = vectors.iter().filter(|vector| vector.is_position()).map(|vector| of(vector.first)).sum();
    [linear, vectors.iter().map(|vector| vector.value.cross(&of(vector.first))).sum()]
}

/// Observer of the linear and angular momentum about the origin, in units of the solver.
struct Momenta<'a>(&'a Simulation, Vec<[Vector3<f64>; 2]>);

impl Observer for Momenta<'_> {
    fn begin(&mut self, _: &[String]) -> io::Result<()> {
        Ok(())
    }

    fn record(&mut self, _: &[f64], s: &State) -> io::Result<ControlFlow<()>> {
        self.1.push(momenta(self.0.assembly(), s, &s.v));
        Ok(ControlFlow::Continue(()))
    }

    fn finish(&mut self) -> io::Result<()> {
        Ok(())
    }
}

/// Returns the momenta of all rows of a run that must finish.
pub(crate) fn recorded_momenta(model: &Model) -> Vec<[Vector3<f64>; 2]> {
    let simulation = Simulation::new(model).unwrap();
    let mut recorder = Momenta(&simulation, Vec::new());
    let summary = simulation.run(&mut recorder).unwrap();
    assert!(summary.outcome.is_finished(), "{:?}", summary.outcome);
    recorder.1
}
