use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use crate::bodies::mesh::BeamMesh;
use crate::constraints::Wrench;
use crate::kinematics::VectorKind;

impl BeamMesh {
    /// Returns the force and the moment about the section centre at an arc length, in the global frame.
    ///
    /// They are exerted by the part at greater arc length on the other part. Resolved in
    /// [`section_frame`](Self::section_frame), a positive first component of the force is tension.
    ///
    /// `loads` are the terms of other loads and reactions within the element of the arc length
    /// ([`acts_within`](Self::acts_within)). At the nodes, the resultants balance these loads, inertia, body force and damping of the
    /// element. They are exact on any mesh. Within an element, the force is linear but for point loads, and the moment m
    /// satisfies dm/ds = −r′ × f − c with a couple c per length that is constant but for rotary inertia. This is exact for loads
    /// that are uniform in the element, and for point loads.
    pub fn resultants(&self, state: &State, s: f64, loads: &[&dyn Term]) -> Wrench {
        let (element, xi) = self.locate(s);
        let rows = self.element_rows(state, element, loads);
        let [start, end] = self.ends(state, element, &rows);
        if xi == 0.0 || xi == 1.0 {
            return if xi == 0.0 { Wrench { force: -start.force, moment: -start.moment } } else { end };
        }
        let loads = self.rod_loads(state, element, [start, end], &rows);
        let moments: Vector3<f64> = loads.until(xi).map(|point| point.moment).sum();
        let lever = self.lever(state, element, &loads, xi);
        let moment = loads.moment - lever - moments + loads.couple_until(xi) * self.length;
        Wrench { force: loads.force(xi), moment }
    }

    /// Returns N, Qy, Qz and T, My, Mz: the [`resultants`](Self::resultants) in the
    /// [`section_frame`](Self::section_frame).
    pub fn section_forces(&self, state: &State, s: f64, loads: &[&dyn Term]) -> Wrench {
        self.resultants(state, s, loads).seen_from(&self.section_frame(state, s))
    }

    /// Returns the element of an arc length. At a node it is the element that starts there.
    pub fn element_of(&self, s: f64) -> usize {
        self.locate(s).0
    }

    /// True if an arc length is that of an end node of an element.
    pub fn is_node(&self, s: f64) -> bool {
        let (_, xi) = self.locate(s);
        xi == 0.0 || xi == 1.0
    }

    /// Returns the elements with a node among the coordinates.
    pub fn elements_near<'a>(&'a self, coordinates: &'a [usize]) -> impl Iterator<Item = usize> + 'a {
        let own = self.first..self.first + self.coordinates();
        let inside = coordinates.iter().filter(move |c| own.contains(c));
        let stride = 3 * self.stride();
        let near = inside.flat_map(move |c| {
            let element = (c - self.first) / stride;
            element.saturating_sub(1)..=element
        });
        near.filter(|&element| element < self.count())
    }

    /// True if a term with these coordinates acts between the end nodes of an element.
    ///
    /// It then has a vector of the middle node, or directions of both end nodes. Forces between the end nodes themselves
    /// have only their positions.
    pub fn acts_within(&self, coordinates: &[usize], element: usize) -> bool {
        let (stride, kinds) = (self.stride(), self.node_kinds());
        let first = self.first + 3 * stride * element;
        let has = |vector: usize| coordinates.contains(&(first + 3 * vector));
        let directions = (0..kinds.len()).filter(|&k| kinds[k] != VectorKind::Position);
        (kinds.len()..stride).any(has) || directions.into_iter().any(|k| has(k) && has(k + stride))
    }
}
