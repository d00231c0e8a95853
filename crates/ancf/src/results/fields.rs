use std::sync::Arc;

use ancf_mechanics::bodies::{BodyTerms, CarriedFrame, ShellPlace, SurfaceField};
use ancf_mechanics::constraints::Wrench;
use ancf_mechanics::kinematics::Attachment;
use ancf_mechanics::shells::{SurfacePlace, SurfaceStress};
use ancf_solver::equations::{State, Term};
use nalgebra::Vector3;

use crate::assembly::Assembly;
use crate::units::{Dimension, Scales};

/// Field along the bodies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// Position x, y, z.
    Position,
    /// Displacement from the reference configuration, x, y, z.
    Displacement,
    /// Velocity x, y, z.
    Velocity,
    /// Acceleration x, y, z.
    Acceleration,
    /// Orthonormal frame, three axes with three global components each. Beams: normal, y and z of the section. Cables: tangent
    /// and two transverse directions, carried along the cable without twist. Shells: normal n, e₁ along r_,u, and n × e₁. Rigid
    /// bodies: body axes. Point masses: global axes.
    Directors,
    /// N, Qy, Qz, T, My, Mz in the section frame: forces of the part at larger arc lengths on the part at smaller ones. NaN for
    /// rigid bodies and shells.
    SectionForces,
    /// Membrane forces and moments per length of shells, n_uu, n_vv, n_uv, m_uu, m_vv, m_uv; NaN for other bodies. Components are
    /// those in the orthonormal frame of the reference surface: u along r_,u, v along n × r_,u.
    Resultants,
    /// Stresses of shells at the top, in the middle and at the bottom: uu, vv, uv of each. NaN for other bodies.
    SurfaceStress,
    /// Principal stresses of shells at the top, in the middle and at the bottom: σ₁ ≥ σ₂ and the angle from u to the direction of
    /// σ₁ of each. NaN for other bodies.
    PrincipalStress,
}

impl Field {
    /// All fields with their names.
    pub const ALL: [(&'static str, Self); 9] = [
        ("position", Self::Position),
        ("displacement", Self::Displacement),
        ("velocity", Self::Velocity),
        ("acceleration", Self::Acceleration),
        ("directors", Self::Directors),
        ("section_forces", Self::SectionForces),
        ("resultants", Self::Resultants),
        ("surface_stress", Self::SurfaceStress),
        ("principal_stress", Self::PrincipalStress),
    ];

    /// Number of components.
    pub const fn width(self) -> usize {
        match self {
            Self::Position | Self::Displacement | Self::Velocity | Self::Acceleration => 3,
            Self::Directors | Self::SurfaceStress | Self::PrincipalStress => 9,
            Self::SectionForces | Self::Resultants => 6,
        }
    }
}

/// Point on a body at which fields are evaluated.
#[derive(Clone, Debug)]
pub struct Station {
    /// Index of the body.
    pub body: usize,
    /// Arc length of the undeformed axis, in the user's units; 0 for shells and rigid bodies.
    pub s: f64,
    /// Place on a shell.
    pub surface: Option<ShellPlace>,
    arc_length: f64,
    place: Attachment,
}

/// Evaluates fields of states at stations, in the order of the bodies.
///
/// Stations are the nodes of beams, cables and shells, points between them on request, and the centres of rigid bodies. Those of
/// a thin shell are a grid, along u first. Those of a shear-deformable shell are a grid in each element, along ξ first: nodes have a
/// station in each of their elements, with equal values.
#[derive(Debug)]
pub struct Fields<'a> {
    assembly: &'a Assembly,
    scales: Scales,
    stations: Vec<Station>,
}

impl<'a> Fields<'a> {
    /// Creates stations at the nodes and at `parts` − 1 points within each element, evenly spaced by arc length. In shells, they are
    /// evenly spaced by u and by v.
    pub fn new(assembly: &'a Assembly, scales: Scales, parts: u32) -> Self {
        let along = |(number, (_, body)): (usize, (&str, &'a BodyTerms))| {
            stations_of(body, parts.max(1)).into_iter().map(move |(arc_length, surface, place)| {
                let s = arc_length * scales.unit(Dimension::LENGTH);
                Station { body: number, s, surface, arc_length, place }
            })
        };
        let stations = assembly.bodies().enumerate().flat_map(along).collect();
        Self { assembly, scales, stations }
    }

    /// Stations, in order.
    pub fn stations(&self) -> &[Station] {
        &self.stations
    }

    /// Units of the states.
    pub const fn scales(&self) -> Scales {
        self.scales
    }

    /// Appends the values of a field in a state, station by station, in the user's units. Section forces of an energy-momentum scheme are
    /// those in the middle of the step before.
    pub fn fill(&self, field: Field, s: &State, to: &mut Vec<f64>) {
        let first = to.len();
        self.fill_from(field, s, to);
        let start = if field == Field::SectionForces { self.assembly.step_start(s) } else { None };
        if let Some(start) = start {
            let mut before = Vec::with_capacity(to.len() - first);
            self.fill_from(field, &start, &mut before);
            to[first..].iter_mut().zip(before).for_each(|(x, before)| *x = 0.5 * (*x + before));
        }
    }

    /// Appends the values of a field in a state, with its accelerations.
    fn fill_from(&self, field: Field, s: &State, to: &mut Vec<f64>) {
        let contacts = match field {
            Field::SectionForces => self.assembly.contact_terms(s),
            Field::Resultants | Field::SurfaceStress | Field::PrincipalStress => {
                return self.fill_surface(field, s, to);
            }
            _ => Vec::new(),
        };
        let (mut body, mut carried) = (None, CarriedFrame::default());
        for station in &self.stations {
            if body.replace(station.body) != Some(station.body) {
                carried = CarriedFrame::default();
            }
            self.read(field, station, s, (&contacts, &mut carried), to);
        }
    }

    fn read(
        &self,
        field: Field,
        station: &Station,
        s: &State,
        (contacts, carried): (&[Arc<dyn Term>], &mut CarriedFrame),
        to: &mut Vec<f64>,
    ) {
        let point = &station.place.point;
        let mut push = |x: Vector3<f64>, of| to.extend((x * self.scales.unit(of)).iter());
        match field {
            Field::Position => push(point.value(s), Dimension::LENGTH),
            Field::Displacement => push(point.displacement(s), Dimension::LENGTH),
            Field::Velocity => push(point.velocity(s), Dimension::VELOCITY),
            Field::Acceleration => push(point.acceleration(s), Dimension::ACCELERATION),
            Field::Directors => {
                for axis in self.frame(station, s, carried) {
                    push(axis, Dimension::NUMBER);
                }
            }
            Field::SectionForces => {
                let (body, at) = (station.body, station.arc_length);
                match self.assembly.section_forces(body, at, s, contacts, carried) {
                    Some(Wrench { force, moment }) => {
                        push(force, Dimension::FORCE);
                        push(moment, Dimension::ENERGY);
                    }
                    None => to.extend([f64::NAN; 6]),
                }
            }
            Field::Resultants | Field::SurfaceStress | Field::PrincipalStress => {}
        }
    }

    /// Calls `visit` with the stresses of each station, which only shells have, in the units of the solver.
    pub fn each_surface_stress(&self, s: &State, mut visit: impl FnMut(Option<SurfaceStress>)) {
        let mut field: Option<(usize, Option<SurfaceField<'_>>)> = None;
        for station in &self.stations {
            let (_, own) = match &field {
                Some(known) if known.0 == station.body => known,
                _ => {
                    let body = self.assembly.body_of(station.body);
                    &*field.insert((station.body, SurfaceField::new(body, s)))
                }
            };
            visit(own.as_ref().zip(station.surface).and_then(|(own, at)| own.at(at)));
        }
    }

    fn fill_surface(&self, field: Field, s: &State, to: &mut Vec<f64>) {
        let unit = |of| self.scales.unit(of);
        let [force, moment] = [Dimension::FORCE_PER_LENGTH, Dimension::FORCE].map(unit);
        let stress = unit(Dimension::STRESS);
        self.each_surface_stress(s, |found| {
            let Some(found) = found else {
                to.extend(std::iter::repeat_n(f64::NAN, field.width()));
                return;
            };
            match field {
                Field::Resultants => {
                    to.extend(found.force.iter().map(|n| n * force));
                    to.extend(found.moment.iter().map(|m| m * moment));
                }
                Field::PrincipalStress => {
                    to.extend(
                        found.principal().iter().flat_map(|[a, b, angle]| [a * stress, b * stress, *angle]),
                    );
                }
                _ => to.extend(found.layers.iter().flatten().map(|x| x * stress)),
            }
        });
    }

    fn frame(&self, station: &Station, s: &State, carried: &mut CarriedFrame) -> [Vector3<f64>; 3] {
        match (self.assembly.body_of(station.body).mesh(), station.place.axes()) {
            (Some(mesh), _) => mesh.carried_frame(s, station.arc_length, carried),
            (None, Some(axes)) => axes.each_ref().map(|axis| axis.value(s)),
            (None, None) => match station.place.frame() {
                Some(frame) => frame.at(&s.q).axes,
                None => [Vector3::x(), Vector3::y(), Vector3::z()],
            },
        }
    }
}

/// Arc length, parameters on a surface, and attachment of a station.
type StationPlace = (f64, Option<ShellPlace>, Attachment);

/// Stations of a body.
fn stations_of(body: &BodyTerms, parts: u32) -> Vec<StationPlace> {
    match body {
        BodyTerms::Flexible(mesh) => {
            let count = mesh.count() * parts as usize;
            let at = |i: usize| mesh.length() * (i as f64 / count as f64);
            (0..=count).map(|i| (at(i), None, mesh.attachment(at(i)))).collect()
        }
        BodyTerms::Shell(mesh) => {
            let station = |at| (0.0, Some(ShellPlace::Patch(at)), mesh.station(at));
            mesh.grid(parts as usize).map(station).collect()
        }
        BodyTerms::ShearShell(mesh) => {
            let at = |k: u32| f64::from(k) / f64::from(parts);
            let places = mesh.faces().iter().enumerate().flat_map(|(element, face)| {
                let place = move |i, j| SurfacePlace { element, at: face.grid_point([at(i), at(j)]) };
                (0..=parts).flat_map(move |j| (0..=parts).map(move |i| place(i, j)))
            });
            places.map(|place| (0.0, Some(ShellPlace::Element(place)), mesh.station(place))).collect()
        }
        BodyTerms::Rigid(body) => vec![(0.0, None, body.attachment(body.centre()))],
    }
}
