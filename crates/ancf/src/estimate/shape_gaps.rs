use ancf_mechanics::bodies::{BeamMesh, RodGap};
use ancf_mechanics::kinematics::{VectorKind, gauss};
use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::gap_field::GapField;
use super::movement::{moved, sizes_of};
use crate::assembly::Assembly;
use crate::model::Model;

/// Largest relative movement of the states between which forces are differentiated. It is small since the displacements of a shape
/// are those of first order, which stretch the axis in second order.
const DIFFERENCE: f64 = 1e-7;
/// Number of Gauss points within an element.
const GAUSS: usize = 5;
/// Number of sections of a body with a work each.
const SECTIONS: usize = 64;
/// Relative difference between the sums over every second section up to which they agree.
const SAMPLING: f64 = 0.1;
/// Difference of the sums, relative to ω², that has no effect on the estimate: the size of its rounding errors on fine meshes.
const INSIGNIFICANT: f64 = 1e-8;
/// Golden ratio.
const GOLDEN: f64 = 0.618_033_988_75;
/// Share of the distortion of the sections in a movement above which the rod does not describe it.
const DISTORTION: f64 = 0.5;

/// Gaps of the elements in the movement of a shape about a state.
#[derive(Clone, Copy)]
pub(super) struct ShapeGaps<'a> {
    pub(super) model: &'a Model,
    pub(super) assembly: &'a Assembly,
    pub(super) about: &'a State,
}

impl ShapeGaps<'_> {
    /// Returns the work xᵀ ∂g/∂q x of the forces g of the gaps on a shape x, for a vibration with the squared circular frequency ω².
    ///
    /// `None` if gaps are not known.
    pub(super) fn work(&self, shape: &[f64], squared: f64) -> Option<f64> {
        let work = self.works(shape, squared)?.iter().flatten().sum::<f64>();
        work.is_finite().then_some(work)
    }

    /// Returns the parts of the elements of each body in [`work`](Self::work).
    ///
    /// Bodies of many elements are divided into sections of equal length. The unloaded elements of a section have the work of one of
    /// them, since works vary slowly along a body. The sections are halved until the sums over every second one agree.
    pub(super) fn works(&self, shape: &[f64], squared: f64) -> Option<Vec<Vec<f64>>> {
        let Self { model, assembly, about } = *self;
        let h = DIFFERENCE / sizes_of(assembly, about, shape).into_iter().fold(0.0, f64::max);
        let states = [-h, h].map(|h| {
            let mut state = moved(about, shape, h);
            state.a.iter_mut().zip(shape).for_each(|(a, x)| *a = -squared * h * x);
            state
        });
        let fields = states.each_ref().map(|state| GapField::unevaluated(model, assembly, state));
        if fields.iter().any(GapField::is_unknown) {
            return None;
        }
        let mut works = ElementWorks {
            fields: &fields,
            shape,
            squared,
            h,
            own: vec![0.0; about.q.len() + about.lambda.len()],
        };
        let counts =
            (0..assembly.bodies().count()).map(|number| fields[0].body(number).map(|body| body.mesh.count()));
        counts.enumerate().map(|(number, count)| works.of_body(number, count.unwrap_or(0))).collect()
    }

    /// True if a shape consists mainly of the distortion of sections, which a rod does not have.
    pub(super) fn is_distortion(&self, field: &GapField<'_>, shape: &[f64]) -> bool {
        let (mut distortion, mut total) = (0.0, 0.0);
        for (number, (_, body)) in self.assembly.bodies().enumerate() {
            let gyration = field.body(number).map_or(0.0, |body| body.gyration_squared());
            let mut y = [Vector3::zeros(); 2];
            for vector in body.vectors(self.about) {
                let first = vector.first;
                let change = Vector3::from_column_slice(&shape[first..first + 3]);
                match vector.kind {
                    VectorKind::Position => total += change.norm_squared(),
                    VectorKind::Slope | VectorKind::Twist => {}
                    VectorKind::Y => y = [vector.value, change],
                    VectorKind::Z => {
                        let [y, of_y] = y;
                        let [yy, zz] = [y.dot(&of_y), vector.value.dot(&change)];
                        let yz = y.dot(&change) + vector.value.dot(&of_y);
                        distortion += gyration * (yy * yy + zz * zz + 0.5 * yz * yz);
                        total += gyration * (of_y.norm_squared() + change.norm_squared());
                    }
                }
            }
        }
        distortion > DISTORTION * total
    }
}

/// Works of the elements in the movement of a shape, from the differences between two states.
struct ElementWorks<'a> {
    fields: &'a [GapField<'a>; 2],
    shape: &'a [f64],
    squared: f64,
    /// Movement of the states from their mean, as a factor of the shape.
    h: f64,
    own: Vec<f64>,
}

impl ElementWorks<'_> {
    /// Returns the works of the elements of a body; `None` if gaps are not known.
    fn of_body(&mut self, number: usize, count: usize) -> Option<Vec<f64>> {
        let mut sections = SECTIONS;
        loop {
            let sections_now = sections.min(count);
            let works = self.sampled(number, count, sections_now)?;
            let mut halves = [0.0; 2];
            for (section, works) in works.iter().enumerate() {
                halves[section % 2] += works.iter().sum::<f64>();
            }
            let [sum, difference] = [halves[0] + halves[1], halves[0] - halves[1]].map(f64::abs);
            if sections_now == count || difference <= (SAMPLING * sum).max(INSIGNIFICANT * self.squared) {
                return Some(works.concat());
            }
            sections *= 2;
        }
    }

    /// Returns the works of the elements of each section of a body.
    fn sampled(&mut self, number: usize, count: usize, sections: usize) -> Option<Vec<Vec<f64>>> {
        let start = |section: usize| section * count / sections;
        let of_section = |section: usize| {
            let (first, length) = (start(section), start(section + 1) - start(section));
            // Equally distributed places within the sections.
            let sample = ((section as f64 * GOLDEN).fract() * length as f64) as usize;
            let (mut works, mut shared) = (vec![0.0; length], None);
            for place in (0..length).map(|k| (sample + k) % length) {
                let element = first + place;
                works[place] = match shared {
                    Some(work) if !self.fields[0].has_loads(number, element) => work,
                    _ => {
                        let work = self.of_element(number, element)?;
                        if !self.fields[0].has_loads(number, element) {
                            shared = Some(work);
                        }
                        work
                    }
                };
            }
            Some(works)
        };
        (0..sections).map(of_section).collect()
    }

    /// Returns the work of an element. The inertia forces also act on the gaps within it.
    fn of_element(&mut self, number: usize, element: usize) -> Option<f64> {
        let at = (number, element);
        if self.squared == 0.0 {
            let gaps = self.gaps_at(at, [1.0])?;
            return Some(self.work_of_forces(at, gaps.each_ref().map(|gaps| &gaps[0])));
        }
        let rule = gauss();
        let gaps = self.gaps_at::<{ 1 + GAUSS }>(
            at,
            std::array::from_fn(|k| if k == 0 { 1.0 } else { rule[k - 1].0 }),
        )?;
        let of_forces = self.work_of_forces(at, gaps.each_ref().map(|gaps| &gaps[0]));
        let mesh = self.fields[0].body(number)?.mesh;
        let [from, to] = [0, 1].map(|k| mesh.gap_displacement(self.fields[k].state, element, &gaps[k][0]));
        let moved: Vec<f64> = from.iter().zip(to).map(|(from, to)| to - from).collect();
        Some(of_forces + interior_work(&gaps, mesh, &moved) / (4.0 * self.h * self.h))
    }

    /// Returns the gaps of both states at places ξ, the first of which is the end; `None` if they are not known.
    fn gaps_at<const N: usize>(
        &self,
        (number, element): (usize, usize),
        xi: [f64; N],
    ) -> Option<[[RodGap; N]; 2]> {
        let [from, to] = self.fields.each_ref().map(|field| field.gaps_at(number, element, xi));
        let gaps = [from?, to?];
        (!gaps.iter().any(|gaps| gaps[0].is_unknown)).then_some(gaps)
    }

    /// Returns the work of the forces of the gaps at the end.
    fn work_of_forces(&mut self, at: (usize, usize), gaps: [&RodGap; 2]) -> f64 {
        let [from, to] = [0, 1].map(|k| self.fields[k].work(at, gaps[k], self.shape, &mut self.own));
        (to - from) / (2.0 * self.h)
    }
}

/// Work of the loads between the nodes of an element on the gaps there, for the differences between two states: the gaps at the end and
/// at the Gauss points, and the movement of the nodes.
fn interior_work([from, to]: &[[RodGap; 1 + GAUSS]; 2], mesh: &BeamMesh, moved: &[f64]) -> f64 {
    let turned = to[0].rotation - from[0].rotation;
    let mut work = 0.0;
    for ((xi, weight), (from, to)) in gauss().into_iter().zip(from[1..].iter().zip(&to[1..])) {
        let (shift, share) = mesh.movement_within(moved, xi);
        let translation = to.translation - from.translation - shift;
        let rotation = to.rotation - from.rotation - turned * share;
        let of_force = (to.load - from.load).dot(&translation);
        work += weight * (of_force + (to.couple - from.couple).dot(&rotation));
    }
    work
}
