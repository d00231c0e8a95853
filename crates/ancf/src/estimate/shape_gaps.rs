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
    /// The inertia forces also act on the gaps within the elements.
    pub(super) fn works(&self, shape: &[f64], squared: f64) -> Option<Vec<Vec<f64>>> {
        let Self { model, assembly, about } = *self;
        let h = DIFFERENCE / sizes_of(assembly, about, shape).into_iter().fold(0.0, f64::max);
        let states = [-h, h].map(|h| {
            let mut state = moved(about, shape, h);
            state.a.iter_mut().zip(shape).for_each(|(a, x)| *a = -squared * h * x);
            state
        });
        let fields = states.each_ref().map(|state| GapField::new(model, assembly, state));
        if fields.iter().any(GapField::is_unknown) {
            return None;
        }
        let [before, mut works] = fields.each_ref().map(|field| field.forces().works(shape));
        for (number, (before, works)) in before.iter().zip(&mut works).enumerate() {
            for (element, (before, work)) in before.iter().zip(works).enumerate() {
                *work = (*work - before) / (2.0 * h);
                if squared != 0.0 {
                    *work += interior_work(&fields, number, element)? / (4.0 * h * h);
                }
            }
        }
        Some(works)
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

/// Work of the loads between the nodes of an element on the gaps there, for the differences between two states.
fn interior_work([before, after]: &[GapField<'_>; 2], number: usize, element: usize) -> Option<f64> {
    let [from, to] = [before.body(number)?.gap(element), after.body(number)?.gap(element)];
    let (mesh, turned) = (before.body(number)?.mesh, to.rotation - from.rotation);
    let [from, to] =
        [(before, from), (after, to)].map(|(field, gap)| mesh.gap_displacement(field.state, element, gap));
    let moved: Vec<f64> = from.iter().zip(to).map(|(from, to)| to - from).collect();
    let mut work = 0.0;
    for (xi, weight) in gauss() {
        let [from, to] = [before, after].map(|field| field.gap_at(number, element, xi));
        let (from, to) = (from?, to?);
        let (shift, share) = mesh.movement_within(&moved, xi);
        let translation = to.translation - from.translation - shift;
        let rotation = to.rotation - from.rotation - turned * share;
        let of_force = (to.load - from.load).dot(&translation);
        work += weight * (of_force + (to.couple - from.couple).dot(&rotation));
    }
    Some(work)
}
