use std::sync::Arc;

use ancf_mechanics::bodies::{BeamMesh, RodGap};
use ancf_mechanics::rods::RodSection;
use ancf_solver::equations::{State, Term};
use nalgebra::Matrix3;

use super::finer::has_poisson_locking;
use super::rod_sections::RodSections;
use crate::assembly::{Assembly, RecordedQuantity};
use crate::model::{Body, Formulation, Model};

/// Mean of 16 ξ² (1 − ξ)².
const BUBBLE: f64 = 8.0 / 15.0;

/// Gaps of all elements of a model at an equilibrium or in a motion.
pub(crate) struct GapField<'a> {
    pub(super) assembly: &'a Assembly,
    pub(super) state: &'a State,
    pub(super) contacts: Vec<Arc<dyn Term>>,
    bodies: Vec<Option<BodyGaps<'a>>>,
    is_rough: bool,
    /// True if moments act between the nodes of elements, at places that are not known.
    has_unknown_moments: bool,
    /// True if strains of quadratic elements are damped in a motion: the elastic part of their section forces is not known.
    is_damped: bool,
}

/// Gaps of the elements of a flexible body.
pub(super) struct BodyGaps<'a> {
    pub(super) mesh: &'a BeamMesh,
    sections: RodSections<'a>,
    gaps: Vec<RodGap>,
    /// Gaps in the middle of the elements, in a motion.
    middles: Vec<RodGap>,
    /// Order of convergence; `None` for elements with Poisson locking, whose error does not vanish.
    pub(super) order: Option<f64>,
}

impl<'a> GapField<'a> {
    /// Computes the gaps. `model` is the model of the assembly, in the same units.
    pub(crate) fn new(model: &'a Model, assembly: &'a Assembly, state: &'a State) -> Self {
        Self::with(model, assembly, state, |field, body, element| {
            Some((field.gap_at(body, element, 1.0)?, None))
        })
    }

    /// Computes the gaps of a motion, also in the middle of the elements.
    pub(crate) fn in_motion(model: &'a Model, assembly: &'a Assembly, state: &'a State) -> Self {
        let field = Self::with(model, assembly, state, |field, body, element| {
            let [gap, middle] = field.gaps_at(body, element, [1.0, 0.5])?;
            Some((gap, Some(middle)))
        });
        let is_damped = |body: &Body| {
            let material = body.section_and_material().and_then(|(_, name)| model.materials.get(name));
            let has_middle = matches!(body, Body::Beam(beam) if beam.formulation == Formulation::Quadratic);
            has_middle && material.is_some_and(|material| material.damping.has_retardation())
        };
        Self { is_damped: model.bodies.iter().any(is_damped), ..field }
    }

    /// Computes the gaps of the elements of the probes only.
    pub(crate) fn at_probes(model: &'a Model, assembly: &'a Assembly, state: &'a State) -> Self {
        Self::with(model, assembly, state, |field, body, element| {
            let mesh = field.body(body)?.mesh;
            let is_here = |probe: &RecordedQuantity| probe.body == body && mesh.locate(probe.s).0 == element;
            let is_probed = assembly.recorded_quantities.iter().any(is_here);
            Some((if is_probed { field.gap_at(body, element, 1.0)? } else { RodGap::default() }, None))
        })
    }

    /// Prepares gaps of single elements ([`gaps_at`](Self::gaps_at)).
    pub(super) fn unevaluated(model: &'a Model, assembly: &'a Assembly, state: &'a State) -> Self {
        Self::with(model, assembly, state, |_, _, _| None)
    }

    /// `gaps` returns the gaps at the end and in the middle of an element.
    fn with(
        model: &'a Model,
        assembly: &'a Assembly,
        state: &'a State,
        gaps: impl Fn(&Self, usize, usize) -> Option<(RodGap, Option<RodGap>)>,
    ) -> Self {
        let contacts = assembly.contact_terms(state);
        let are_loads_known = model.loads.iter().all(|load| load.kind().is_known_within_elements());
        let is_rough = !contacts.is_empty() || !are_loads_known;
        let has_unknown_moments = !assembly.inner_loads.is_empty()
            && model.loads.iter().any(|load| load.kind().has_unknown_moments());
        let mut field = Self {
            assembly,
            state,
            contacts,
            bodies: Vec::new(),
            is_rough,
            has_unknown_moments,
            is_damped: false,
        };
        for (number, of_model) in model.bodies.iter().enumerate() {
            let mesh = assembly.body_of(number).mesh();
            let sections = mesh.zip(RodSections::new(model, of_model));
            let order = (!has_poisson_locking(model, of_model)).then(|| of_model.convergence_order());
            let (none, inner) = (Vec::new(), Vec::new());
            let body = sections.map(|(mesh, sections)| BodyGaps {
                mesh,
                sections,
                gaps: none,
                middles: inner,
                order,
            });
            field.bodies.push(body);
            let count = mesh.map_or(0, BeamMesh::count);
            let (ends, middles): (Vec<_>, Vec<_>) =
                (0..count).filter_map(|element| gaps(&field, number, element)).unzip();
            if let Some(body) = field.bodies.last_mut().and_then(Option::as_mut) {
                (body.gaps, body.middles) = (ends, middles.into_iter().flatten().collect());
            }
        }
        field
    }

    /// True if the section forces or the gaps within an element are not accurate.
    pub(super) fn is_rough(&self) -> bool {
        self.is_rough || self.bodies().any(|(_, body)| body.gaps.iter().any(|gap| gap.is_rough))
    }

    /// True if gaps are not known, as with shells, or moments or joints act between the nodes of elements.
    pub(super) fn is_unknown(&self) -> bool {
        let is_unknown = |body: &BodyGaps<'_>| body.gaps.iter().any(|gap| gap.is_unknown);
        let has_shells = self.assembly.bodies().any(|(_, body)| body.is_shell());
        has_shells
            || self.has_unknown_moments
            || self.is_damped
            || self.assembly.inner_loads.has_joints
            || self.bodies().any(|(_, body)| is_unknown(body))
    }

    /// Bound of the relative difference between the laws of the rod and of the elements.
    pub(super) fn law(&self) -> f64 {
        self.bodies().map(|(_, body)| body.law()).fold(0.0, f64::max)
    }

    /// True if the gaps of all elements of at least one flexible body are known, without contacts.
    pub(super) fn has_estimate(&self) -> bool {
        self.contacts.is_empty() && !self.is_unknown() && self.bodies().next().is_some()
    }

    /// Flexible bodies with their numbers.
    pub(super) fn bodies(&self) -> impl Iterator<Item = (usize, &BodyGaps<'a>)> {
        self.bodies.iter().enumerate().filter_map(|(number, body)| Some((number, body.as_ref()?)))
    }

    /// Gaps of a flexible body.
    pub(super) fn body(&self, number: usize) -> Option<&BodyGaps<'a>> {
        self.bodies.get(number)?.as_ref()
    }

    /// True if loads or contacts act between the nodes of an element.
    pub(super) fn has_loads(&self, body: usize, element: usize) -> bool {
        !self.assembly.loads_within(body, element, &self.contacts).is_empty()
    }

    /// Gap between the rod and an element at ξ.
    pub(super) fn gap_at(&self, body: usize, element: usize, xi: f64) -> Option<RodGap> {
        self.gaps_at(body, element, [xi]).map(|[gap]| gap)
    }

    /// Gaps between the rod and an element at places ξ.
    pub(super) fn gaps_at<const N: usize>(
        &self,
        body: usize,
        element: usize,
        xi: [f64; N],
    ) -> Option<[RodGap; N]> {
        let BodyGaps { mesh, sections, .. } = self.body(body)?;
        let loads = self.assembly.loads_within(body, element, &self.contacts);
        let l = mesh.element_length();
        let s = element as f64 * l;
        let frame = mesh.frame(s).filter(|_| sections.is_curved());
        let frame = frame.map_or_else(Matrix3::identity, |frame| Matrix3::from_columns(frame.reference()));
        let section = |xi: f64| -> RodSection { sections.at(s, l, &frame, xi) };
        Some(mesh.rod_gaps(self.state, element, xi, &loads, &section))
    }

    /// Mass times displacement of the rod relative to the element between its nodes, as virtual works on the coordinates.
    ///
    /// The second derivative by time are inertia forces that the element does not have. The displacement is
    /// 16 ξ² (1 − ξ)² times that in the middle, the deflection under a uniform load.
    pub(super) fn inner_moments(&self) -> Vec<f64> {
        let mut moments = vec![0.0; self.state.q.len()];
        for (_, body) in self.bodies() {
            let mesh = body.mesh;
            for (element, (gap, middle)) in body.gaps.iter().zip(&body.middles).enumerate() {
                let w = mesh.gap_displacement(self.state, element, gap);
                let (shift, _) = mesh.movement_within(&w, 0.5);
                let moment = (middle.translation - shift) * (BUBBLE * mesh.element_mass(element));
                mesh.point((element as f64 + 0.5) * mesh.element_length()).add(moment, &mut moments);
            }
        }
        moments
    }

    /// Forces that impose the gaps.
    pub(crate) fn forces(&self) -> GapForces {
        let size = self.state.q.len() + self.state.lambda.len();
        let (mut total, mut own) = (vec![0.0; size], vec![0.0; size]);
        let mut parts = vec![ElementForces::default(); self.bodies.len()];
        for (number, body) in self.bodies() {
            let length = body.mesh.coordinates_of(0);
            parts[number] = ElementForces {
                first: body.mesh.first_coordinate(),
                step: body.mesh.coordinates_between(),
                length,
                rows: Vec::with_capacity(length * body.mesh.count()),
            };
            for (element, gap) in body.gaps.iter().enumerate() {
                let rows = &mut parts[number].rows;
                let end = rows.len() + length;
                self.visit_forces((number, element), gap, &mut own, |place, force| {
                    total[place] += force;
                    if rows.len() < end {
                        rows.push(force);
                    }
                });
            }
        }
        GapForces { total, parts }
    }

    /// Work of the forces that impose a gap on a movement of an element. `own` has zeros for all unknowns.
    pub(super) fn work(
        &self,
        (number, element): (usize, usize),
        gap: &RodGap,
        movement: &[f64],
        own: &mut [f64],
    ) -> f64 {
        let (mut work, mut rows) =
            (0.0, self.assembly.body_of(number).mesh().map_or(0, |mesh| mesh.coordinates_of(element)));
        self.visit_forces((number, element), gap, own, |place, force| {
            if rows > 0 {
                work += force * movement[place];
                rows -= 1;
            }
        });
        work
    }

    /// Visits the forces that impose a gap: those on the coordinates of the element in ascending order, then those on other unknowns of
    /// its loads. `own` has zeros for all unknowns before and after.
    fn visit_forces(
        &self,
        (number, element): (usize, usize),
        gap: &RodGap,
        own: &mut [f64],
        mut visit: impl FnMut(usize, f64),
    ) {
        let Some(BodyGaps { mesh, .. }) = self.body(number) else { return };
        let loads = self.assembly.loads_within(number, element, &self.contacts);
        mesh.add_gap_forces(self.state, element, gap, &loads, own);
        let first = mesh.first_coordinate_of(element);
        let of_loads = loads.iter().flat_map(|load| load.coordinates().iter().copied());
        for place in (first..first + mesh.coordinates_of(element)).chain(of_loads) {
            visit(place, std::mem::take(&mut own[place]));
        }
    }
}

/// Forces on all coordinates, with zeros for the multipliers, that impose the gaps, and the parts of the elements.
pub(crate) struct GapForces {
    pub(super) total: Vec<f64>,
    parts: Vec<ElementForces>,
}

/// Forces of the gaps of a body on the coordinates of its elements.
#[derive(Clone, Default)]
struct ElementForces {
    /// First coordinate of the first element, and the number of coordinates between the starts of elements.
    first: usize,
    step: usize,
    /// Number of coordinates of an element.
    length: usize,
    rows: Vec<f64>,
}

impl GapForces {
    /// Works of the forces of each element of each body on a movement.
    pub(super) fn works(&self, movement: &[f64]) -> Vec<Vec<f64>> {
        let of_body = |part: &ElementForces| {
            let rows = part.rows.chunks_exact(part.length.max(1)).enumerate();
            let work = |(element, row): (usize, &[f64])| {
                let from = part.first + part.step * element;
                row.iter().zip(&movement[from..]).map(|(force, x)| force * x).sum()
            };
            rows.map(work).collect()
        };
        self.parts.iter().map(of_body).collect()
    }
}

impl BodyGaps<'_> {
    /// Gap at the end of an element.
    pub(super) fn gap(&self, element: usize) -> &RodGap {
        &self.gaps[element]
    }

    /// Sum of the sizes of the gaps as angles.
    pub(super) fn sum(&self) -> f64 {
        let length = self.mesh.element_length();
        self.gaps.iter().map(|gap| gap.angle(length)).sum()
    }

    /// Square of the radius of gyration for bending, the mean of both axes, in the middle of the body.
    pub(super) fn gyration_squared(&self) -> f64 {
        let length = self.mesh.length();
        0.5 * self.sections.at(0.0, length, &Matrix3::identity(), 0.5).gyration.x
    }

    /// Largest relative difference between the laws of the rod and of the elements.
    pub(super) fn law(&self) -> f64 {
        self.gaps.iter().map(|gap| gap.law).fold(0.0, f64::max)
    }
}
