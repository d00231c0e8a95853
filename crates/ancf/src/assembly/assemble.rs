use ancf_mechanics::batches::term_batches;
use ancf_mechanics::bodies::BodyTerms;
use ancf_solver::equations::{System, Term};
use nalgebra::Vector3;

use super::assembled::{Assembly, OwnedTerms, RecordedQuantity};
use super::loads::InnerLoads;
use super::redundancy::Redundancy;
use crate::checking::factor_storage;
use crate::errors::ModelErrors;
use crate::model::{IndexedModel, TimeMode};

impl IndexedModel<'_> {
    /// Assembles a valid model whose functions are supplied.
    ///
    /// # Errors
    /// If gaps cannot be closed, or a force law has an unknown signal.
    pub(crate) fn assembled(&self, time_mode: TimeMode) -> Result<Assembly, ModelErrors> {
        let bodies = self.prestrained(self.meshes(), time_mode);
        let joints = self.checked_joint_equations(&bodies, time_mode)?;
        let mut terms: Vec<Box<dyn Term>> = bodies.iter().flat_map(|(_, body)| body.terms()).collect();
        let first_joint = terms.len();
        let mut nodal = Vec::new();
        let mut owned = OwnedTerms::default();
        for (joint, equations) in self.joints.iter().zip(&joints) {
            let first = terms.len();
            terms.extend(equations.terms());
            owned.joints.push(first..terms.len());
            nodal.resize(terms.len() - first_joint, self.connects_nodes(&bodies, joint));
        }
        terms.extend(self.coupling_terms(&bodies, &joints));
        let first_load = terms.len();
        for of_load in self.load_terms(&bodies, &joints, time_mode) {
            let first = terms.len();
            terms.extend(of_load);
            owned.loads.push(first..terms.len());
        }
        let is_nodal = |index: usize| nodal.get(index - first_joint).copied().unwrap_or(false);
        let inner_loads = InnerLoads::new(&bodies, &terms, [first_joint, first_load], is_nodal);
        let probes = self
            .probes
            .iter()
            .map(|probe| (probe.name.clone(), self.probed(&bodies, probe).2.point))
            .collect();
        let recorded_quantities = self.recorded(&bodies);
        let [coordinates, multipliers] = Self::numbers(&bodies, &joints);
        let multipliers = multipliers + self.couplings.len();
        let batches = term_batches(&terms);
        let system = System::new(coordinates, multipliers, terms).with_batches(batches);
        let storage = factor_storage(self, system.pattern());
        let system = system.with_factor_storage(storage);
        let (breaks, inputs) = (self.breaks(time_mode), self.inputs(&bodies, time_mode));
        let couplings = self.couplings.iter().map(|coupling| coupling.name.clone()).collect();
        let assembly = Assembly {
            system,
            probes,
            recorded_quantities,
            output: self.output,
            bodies,
            joints,
            couplings,
            redundancy: Redundancy::default(),
            closed: None,
            breaks,
            inputs,
            inner_loads,
            owned,
            gravity: Vector3::from(self.gravity),
            averaged: self.averaged(),
        };
        let assembly = assembly.sharing();
        let closed = if self.assemble { Some(self.close(&assembly)?) } else { None };
        let mut assembly = Assembly { closed, ..assembly };
        let contact_searches = self.contact_searches(&assembly.bodies, &assembly.initial());
        assembly.system = assembly.system.with_searches(contact_searches);
        Ok(assembly)
    }

    /// Start and step of a motion by an energy-momentum scheme.
    fn averaged(&self) -> Option<[f64; 2]> {
        let own = self.analysis.dynamics().filter(|own| own.scheme.numbers().averaging.is_some())?;
        Some([self.initial.start_time, own.nominal_step(self.output.interval)?])
    }

    /// Quantities that the probes record.
    fn recorded(&self, bodies: &[(String, BodyTerms)]) -> Vec<RecordedQuantity> {
        let recorded = self.probes.iter().flat_map(|probe| {
            let (body, s, place) = self.probed(bodies, probe);
            let surface = self.bodies[body].shell_place(&probe.on.at);
            let warping = match bodies[body].1.mesh() {
                Some(_) => self.warping_gradient(&self.bodies[body], s, probe.offset),
                None => [0.0; 2],
            };
            probe.record.iter().map(move |&quantity| {
                let (name, place, offset) = (probe.name.clone(), place.clone(), probe.offset);
                RecordedQuantity { name, quantity, place, body, s, offset, warping, surface }
            })
        });
        recorded.collect()
    }
}
