//! Loads of a model as terms, and loads and reactions between the nodes of elements, for section forces.

use std::collections::HashMap;

use ancf_mechanics::bodies::{BeamMesh, BodyTerms};
use ancf_solver::equations::Term;

use crate::joints::{End, Joint, JointEquations};
use crate::loads::{Load, LoadBuilder};
use crate::model::{IndexedModel, Place, TimeMode};

/// Indices of the terms that act between the nodes of an element, by body and element.
#[derive(Debug, Default)]
pub(crate) struct InnerLoads {
    terms: HashMap<(usize, usize), Vec<usize>>,
    /// True if a term of a joint is among them.
    pub(crate) has_joints: bool,
}

impl InnerLoads {
    /// Creates the index of the terms of joints and of loads, which begin at `first_joint` and `first_load`. `is_nodal` are
    /// terms that connect the nodes of an element with each other.
    pub(super) fn new(
        bodies: &[(String, BodyTerms)],
        terms: &[Box<dyn Term>],
        [first_joint, first_load]: [usize; 2],
        is_nodal: impl Fn(usize) -> bool,
    ) -> Self {
        let mut inner: HashMap<(usize, usize), Vec<usize>> = HashMap::new();
        let meshes: Vec<(usize, &BeamMesh)> =
            bodies.iter().enumerate().filter_map(|(k, (_, body))| Some((k, body.mesh()?))).collect();
        for (index, term) in terms.iter().enumerate().skip(first_joint).filter(|(index, _)| !is_nodal(*index))
        {
            let coordinates = term.coordinates();
            for &c in coordinates {
                // The meshes are in the order of their coordinates.
                let after = meshes.partition_point(|(_, mesh)| mesh.first_coordinate() <= c);
                let Some(&(body, mesh)) = after.checked_sub(1).map(|at| &meshes[at]) else { continue };
                for element in mesh.elements_near(&[c]) {
                    let known = inner.get(&(body, element)).and_then(|list| list.last());
                    if known != Some(&index) && mesh.acts_within(coordinates, element) {
                        inner.entry((body, element)).or_default().push(index);
                    }
                }
            }
        }
        let has_joints = inner.values().flatten().any(|&index| index < first_load);
        Self { terms: inner, has_joints }
    }

    /// True if no terms act between the nodes of an element.
    pub(crate) fn is_empty(&self) -> bool {
        self.terms.is_empty()
    }

    /// Indices of the terms within an element.
    pub(crate) fn of(&self, body: usize, element: usize) -> &[usize] {
        self.terms.get(&(body, element)).map_or(&[], Vec::as_slice)
    }
}

impl IndexedModel<'_> {
    /// Terms of each load, in the order of the model. The equations of gases follow those of the joints.
    pub(crate) fn load_terms(
        &self,
        bodies: &[(String, BodyTerms)],
        joints: &[JointEquations],
        time_mode: TimeMode,
    ) -> Vec<Vec<Box<dyn Term>>> {
        let attach = |place: &Place| self.attachment(bodies, place);
        let mut gases = joints.iter().filter(|equations| !equations.is_joint());
        let terms = |load: &Load| {
            let mut builder = LoadBuilder::new(self, bodies, &attach, time_mode);
            load.kind().build(&mut builder);
            let mut terms = builder.finish();
            if let Load::Gas(_) = load {
                terms.extend(gases.next().into_iter().flat_map(JointEquations::terms));
            }
            terms
        };
        self.loads.iter().map(terms).collect()
    }

    /// True if a joint connects two nodes of one body. It does not act between the nodes of an element.
    pub(super) fn connects_nodes(&self, bodies: &[(String, BodyTerms)], joint: &Joint) -> bool {
        let (a, End::Place(b)) = joint.ends() else { return false };
        let body = self.body_of(a);
        let is_node = |place: &Place| {
            let mesh = bodies[body].1.mesh();
            mesh.is_some_and(|mesh| mesh.is_node(self.bodies[body].arc_length(&place.at)))
        };
        body == self.body_of(b) && is_node(a) && is_node(b)
    }
}
