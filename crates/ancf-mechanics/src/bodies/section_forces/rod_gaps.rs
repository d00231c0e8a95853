//! Gap between the exact rod and an element, and the forces that this gap causes when it is imposed on the structure.

use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use super::element_forces::add_stiffness_product;
use crate::bodies::mesh::BeamMesh;
use crate::bodies::section_frames::normals_to;
use crate::kinematics::{FrameValues, VectorKind};
use crate::rods::{Placement, RodLoads, RodPart, RodSection, StringEnd, TautString};

/// Largest number of vectors of a node.
const NODE: usize = 4;
/// Product |n| l²/EI of a taut element above which its shape is that of a string with boundary layers. The solution of the rod from
/// its start grows as the exponential of the root.
const TAUT: f64 = 8.0;
/// Size of a gap, as an angle, to which it is scaled for the derivative of the forces of an element.
const STEP: f64 = 1e-3;
/// Turn of the reference shape within an element, in rad, above which the interpolation of the shape has a noticeable error.
const CURVED: f64 = 0.35;
/// Ratio of the tensions of both ends of an element above which the tension varies within a boundary layer.
const STEEP: f64 = 3.0;
/// Product above which the boundary layers of both ends do not overlap.
const STRING: f64 = 100.0;

/// Gap at the end of an element: the exact rod from the start of the element, under the section forces of the element, less the element.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RodGap {
    /// Difference of the moments at the start; zero except for taut elements.
    pub start: Vector3<f64>,
    /// Difference of the positions at the end.
    pub translation: Vector3<f64>,
    /// Rotation vector between the sections at the end.
    pub rotation: Vector3<f64>,
    /// Moment at the end of the loads between the nodes, due to the different shapes.
    pub moment: Vector3<f64>,
    /// Distributed load at the place of the gap, multiplied by the length of the element.
    pub load: Vector3<f64>,
    /// Distributed moment at the place of the gap, multiplied by the length of the element.
    pub couple: Vector3<f64>,
    /// Forces that balance the element and its loads at the vectors of its last node.
    pub at_end: [Vector3<f64>; NODE],
    /// Bound of the relative difference between the laws of the rod and of the element.
    pub law: f64,
    /// True if the gap is not accurate: the boundary layers of both ends of a taut element overlap, or the reference shape turns
    /// far within the element.
    pub is_rough: bool,
    /// True if there is no gap to state: the tension of a taut element nearly vanishes at an end.
    pub is_unknown: bool,
}

impl RodGap {
    /// Returns the size of the gap as an angle, for an element of a length.
    pub fn angle(&self, length: f64) -> f64 {
        self.rotation.norm().max(self.translation.norm() / length)
    }
}

impl BeamMesh {
    /// Returns the gaps between the exact rod and an element at places ξ in an equilibrium, or in a motion with its inertia forces.
    ///
    /// The rod starts at the first node with the placement and the section forces of the element, which are in equilibrium with
    /// `loads` and all other loads of the element ([`resultants`](Self::resultants)). Taut elements are compared with a string.
    /// `section` is that of the rod at ξ in [0, 1].
    pub fn rod_gaps<const N: usize>(
        &self,
        state: &State,
        element: usize,
        xi: [f64; N],
        loads: &[&dyn Term],
        section: &dyn Fn(f64) -> RodSection,
    ) -> [RodGap; N] {
        // The elastic forces on a middle node are not in equilibrium.
        let has_middle = self.coordinates_of(element) > 6 * self.node_kinds().len();
        let rows = if has_middle {
            self.element_rows(state, element, loads)
        } else {
            self.elastic_rows(state, element, loads)
        };
        let ends = self.ends(state, element, &rows);
        let loads = self.rod_loads(state, element, ends, &rows);
        let forces = loads.forces;
        let prestrained = |xi: f64| {
            let (strain, curvature) = self.prestrain(state, element, xi);
            section(xi).prestrained(strain, curvature)
        };
        let [first, end] = [0.0, 1.0].map(|xi| self.placement(state, element, xi));
        let middle = section(0.5);
        let law = {
            let seen = |x: &Vector3<f64>| first.frame.tr_mul(x);
            let stiffening = (prestrained(0.5).stiffening() - 1.0).abs();
            middle.law_difference(&seen(&forces[0]), &seen(&loads.moment)) + stiffening
        };
        let tension = 0.5 * (forces[0] + forces[1]).dot(&(end.position - first.position)) / self.length;
        let slenderness = self.length.powi(2) * middle.flexibility();
        let vectors = self.coordinates_of(element) / 3;
        let mut at_end = [Vector3::zeros(); NODE];
        for (force, vector) in at_end.iter_mut().zip(vectors - self.node_kinds().len()..vectors) {
            *force = rows.force(vector);
        }
        xi.map(|xi| {
            let last = if xi == 1.0 { end } else { self.placement(state, element, xi) };
            let gap = if tension * slenderness <= TAUT {
                self.bent_gap(state, (element, xi), &loads, [&first, &last], [section, &prestrained])
            } else if is_steep(&loads, slenderness) {
                RodGap { is_unknown: true, ..RodGap::default() }
            } else {
                let is_end = [element == 0, element + 1 == self.count()];
                let ends = std::array::from_fn(|k| StringEnd {
                    tangent: [&first, &end][k].frame.column(0).into_owned(),
                    moment: [loads.moment, ends[1].moment][k],
                    is_free: !is_end[k],
                });
                let string = TautString { length: self.length, section: &prestrained, loads: &loads, ends };
                let is_rough = tension * slenderness < STRING;
                RodGap { is_rough, ..string_gap(&string, last.position - first.position, xi) }
            };
            RodGap { law, at_end, ..gap }
        })
    }

    /// Returns the gap at ξ of an element that is not taut, between the placements of its start and at ξ.
    fn bent_gap(
        &self,
        state: &State,
        (element, xi): (usize, f64),
        loads: &RodLoads,
        [first, last]: [&Placement; 2],
        [section, prestrained]: [&dyn Fn(f64) -> RodSection; 2],
    ) -> RodGap {
        let part = RodPart { length: self.length, section: prestrained, loads };
        let (reached, reached_moment) = part.end(first, xi);
        let translation = reached.position - last.position;
        let moments: Vector3<f64> = loads.until(xi).map(|point| point.moment).sum();
        let lever = self.lever(state, element, loads, xi);
        let of_element = loads.moment - lever - moments + loads.couple_until(xi) * self.length;
        let curvature =
            [0.0, 0.5, 1.0].map(|xi| section(xi).curvature.norm()).into_iter().fold(0.0, f64::max);
        // The sections of cables have no orientation about the axis.
        let turn = if self.has_sections() { Placement::rotation_from } else { Placement::axis_rotation_from };
        let mut gap = RodGap {
            translation,
            rotation: turn(&reached, last),
            moment: reached_moment + translation.cross(&loads.force(xi)) - of_element,
            load: loads.distributed(xi),
            couple: loads.couple(xi) * -self.length,
            is_rough: curvature * self.length > CURVED,
            ..RodGap::default()
        };
        if curvature > 0.0 {
            // The error of the integration of the reference shape.
            let [first, end] = [0.0, xi].map(|xi| self.reference_placement(element, xi));
            let rest = RodPart { length: self.length, section, loads: &RodLoads::default() };
            let (reached, _) = rest.end(&first, xi);
            let turned = |x: Vector3<f64>| last.frame * end.frame.tr_mul(&x);
            gap.translation -= turned(reached.position - end.position);
            gap.rotation -= turned(turn(&reached, &end));
        }
        gap
    }

    /// Returns the placement of a section of an element, relative to the origin of the mesh.
    fn placement(&self, state: &State, element: usize, xi: f64) -> Placement {
        let s = (element as f64 + xi) * self.length;
        if xi == 0.0 || xi == 1.0 {
            return self
                .node_placement(element + usize::from(xi == 1.0), |vector| self.vector(state, vector));
        }
        let axes = match self.frame(s) {
            Some(frame) => frame.at(&state.q).axes,
            None => along(self.axes(s)[0].value(state)),
        };
        Placement::new(self.point(s).value(state) - self.origin, axes)
    }

    /// Returns the placement of the section of a node at the end of an element, relative to the origin of the mesh.
    fn node_placement(&self, node: usize, vector: impl Fn(usize) -> Vector3<f64>) -> Placement {
        let first = node * self.stride();
        let of_kind =
            |kind: VectorKind| self.node_kinds().iter().position(|k| *k == kind).map(|k| vector(first + k));
        let axes = match (of_kind(VectorKind::Y), of_kind(VectorKind::Z)) {
            (Some(d), Some(e)) => {
                let weight = self.node_weight(node);
                FrameValues::axes(d, e, [weight, 1.0 - weight])
            }
            _ => along(vector(first + 1)),
        };
        Placement::new(vector(first), axes)
    }

    fn reference_placement(&self, element: usize, xi: f64) -> Placement {
        if xi == 0.0 || xi == 1.0 {
            return self.node_placement(element + usize::from(xi == 1.0), |vector| self.reference[vector]);
        }
        let s = (element as f64 + xi) * self.length;
        let axes = match self.frame(s) {
            Some(frame) => *frame.reference(),
            None => along(self.axes(s)[0].reference()),
        };
        Placement::new(self.point(s).reference() - self.origin, axes)
    }

    /// Returns the displacement w of the coordinates of an element in which its last node moves by the gap.
    pub fn gap_displacement(&self, state: &State, element: usize, gap: &RodGap) -> Vec<f64> {
        let mut w = vec![0.0; self.term(element).coordinates().len()];
        self.visit_end(element, |place, vector, kind| {
            let moved = match kind {
                VectorKind::Position => gap.translation,
                _ => gap.rotation.cross(&self.vector(state, vector)),
            };
            w[place..place + 3].copy_from_slice(moved.as_slice());
        });
        w
    }

    /// Returns the mass of an element.
    pub fn element_mass(&self, element: usize) -> f64 {
        let (kinds, first) = (self.node_kinds(), self.elements.first_moments(element));
        let is_position = |i: usize| kinds[i % kinds.len()] == VectorKind::Position;
        first.iter().enumerate().filter(|(i, _)| is_position(*i)).map(|(_, moment)| moment).sum()
    }

    /// Returns the displacement of the axis at ξ for a displacement w of the coordinates of an element, and the factor of a
    /// rotation of its last node in that of the section.
    pub fn movement_within(&self, w: &[f64], xi: f64) -> (Vector3<f64>, f64) {
        let (mut shift, mut share) = (Vector3::zeros(), 0.0);
        for (i, (kind, value, _)) in self.weights(xi).into_iter().enumerate() {
            match kind {
                VectorKind::Position | VectorKind::Slope => {
                    shift += Vector3::from_column_slice(&w[3 * i..3 * i + 3]) * value;
                }
                VectorKind::Y => share = value,
                VectorKind::Z | VectorKind::Twist => {}
            }
        }
        (shift, share)
    }

    /// Adds the forces of a gap that is imposed between an element and its last node, and turns with this node:
    ///
    /// K_e w + Σ f_a × γ_φ + Tᵀ (γ_φ × m + γ_r × n − γ_m),
    ///
    /// with the stiffness K_e of the element and its loads, the forces f_a of the element on the directions of the node, its end
    /// forces n and m, and the variation T of the section frame.
    pub fn add_gap_forces(
        &self,
        state: &State,
        element: usize,
        gap: &RodGap,
        loads: &[&dyn Term],
        forces: &mut [f64],
    ) {
        let first = self.first_coordinate_of(element);
        let w = self.gap_displacement(state, element, gap);
        let size = gap.angle(self.length);
        if size > 0.0 {
            let step = STEP / size;
            add_stiffness_product(self.term(element), state, (first, &w), step, forces);
            if let Some(term) = self.prestrains.term(element) {
                add_stiffness_product(term, state, (first, &w), step, forces);
            }
            loads.iter().for_each(|load| add_stiffness_product(*load, state, (first, &w), step, forces));
        }
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        let mut rows = gap.at_end.iter();
        self.visit_end(element, |place, vector, kind| {
            let Some(row) = rows.next() else { return };
            if kind == VectorKind::Position {
                force += row;
                return;
            }
            moment += self.vector(state, vector).cross(row);
            let turned = row.cross(&gap.rotation);
            forces[first + place..].iter_mut().zip(&turned).for_each(|(force, turned)| *force += turned);
        });
        let couple = gap.rotation.cross(&moment) + gap.translation.cross(&force) - gap.moment;
        self.add_couple(state, element + 1, &couple, forces);
        if gap.start != Vector3::zeros() {
            self.add_couple(state, element, &gap.start, forces);
        }
    }

    /// Adds the forces of a moment on the section of a node at the end of an element.
    fn add_couple(&self, state: &State, node: usize, couple: &Vector3<f64>, forces: &mut [f64]) {
        let s = node as f64 * self.length;
        if let Some(frame) = self.frame(s) {
            frame.add(frame.at(&state.q).forces(couple), forces);
        } else {
            let tangent = &self.axes(s)[0];
            let slope = tangent.value(state);
            tangent.add(couple.cross(&slope) / slope.norm_squared(), forces);
        }
    }

    /// Calls `visit` with the place, the number and the kind of each vector of the last node of an element.
    fn visit_end(&self, element: usize, mut visit: impl FnMut(usize, usize, VectorKind)) {
        let (kinds, size) = (self.node_kinds(), self.term(element).coordinates().len() / 3);
        let offset = element * self.stride();
        for (k, kind) in kinds.iter().enumerate() {
            let vector = size - kinds.len() + k;
            visit(3 * vector, offset + vector, *kind);
        }
    }
}

/// Returns the gap between a string and an element with the given vector from its start to ξ.
fn string_gap(string: &TautString<'_>, chord: Vector3<f64>, xi: f64) -> RodGap {
    let translation = string.chord(xi) - chord;
    let [start, after] = [0, 1].map(|end| string.moment(end) - string.ends[end].moment);
    let moment = after + translation.cross(&string.loads.force(xi));
    RodGap { translation, start, moment, load: string.loads.distributed(xi), ..RodGap::default() }
}

/// Returns orthonormal axes, the first one along a tangent.
fn along(tangent: Vector3<f64>) -> [Vector3<f64>; 3] {
    let x = tangent.normalize();
    let [y, z] = normals_to(x);
    [x, y, z]
}

/// True if the tension varies within the boundary layer of an end, whose shape assumes a constant tension. `slenderness` is l²/EI.
fn is_steep(loads: &RodLoads, slenderness: f64) -> bool {
    let [a, b] = [0.0, 1.0].map(|xi| loads.force(xi).norm());
    let (low, high) = (a.min(b), a.max(b));
    low * slenderness <= STRING && high > STEEP * low
}
