//! Beams of one element in every formulation, as a model makes them.

use std::ops::AddAssign;

use ancf::Model;
use ancf::mechanics::NodalVector;
use ancf::model::{Beam, Damping, Formulation, MaterialLaw, Section, Shape, Slopes};
use ancf::system::Term;
use nalgebra::{DVector, Rotation3, Vector3};

use super::rod;

/// Distance of the two ends.
pub(crate) const LENGTH: f64 = 0.7;

pub(crate) const FORMULATIONS: [Formulation; 4] =
    [Formulation::Continuum, Formulation::Enhanced, Formulation::Linked, Formulation::Quadratic];

/// What a beam of one element is to be.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Make {
    pub(crate) formulation: Formulation,
    pub(crate) section: Section,
    pub(crate) section_end: Option<Section>,
    pub(crate) poisson: f64,
    pub(crate) law: MaterialLaw,
    pub(crate) damping: Damping,
    /// An arc with a radius of 0.41, twisted by 0.8 rad; else straight.
    pub(crate) bent: bool,
    pub(crate) slopes: Slopes,
    /// Turned in space and away from the origin.
    pub(crate) tilted: bool,
}

impl Make {
    /// A straight beam along x.
    pub(crate) fn straight(formulation: Formulation, section: Section, poisson: f64) -> Self {
        Self {
            formulation,
            section,
            section_end: None,
            poisson,
            law: MaterialLaw::StVenantKirchhoff,
            damping: Damping::default(),
            bent: false,
            slopes: Slopes::Gradient,
            tilted: false,
        }
    }

    /// E = 30, ρ = 2, under gravity.
    pub(crate) fn model(&self, gravity: Vector3<f64>) -> Model {
        let turn =
            if self.tilted { Rotation3::from_euler_angles(0.4, -1.1, 2.3) } else { Rotation3::identity() };
        let shift = if self.tilted { Vector3::new(0.1, -0.2, 0.3) } else { Vector3::zeros() };
        let place = |x: f64, y: f64| <[f64; 3]>::from(turn * Vector3::new(x, y, 0.0) + shift);
        let mut model = rod::free(1);
        model.gravity = gravity.into();
        let material = rod::material(&mut model);
        (material.density, material.young, material.poisson) = (2.0, 30.0, self.poisson);
        (material.law, material.damping) = (self.law, self.damping);
        model.sections.insert("circle".into(), self.section);
        if let Some(end) = self.section_end {
            model.sections.insert("end".into(), end);
        }
        *rod::beam(&mut model) = Beam {
            shape: if self.bent { Shape::Arc { through: place(0.5 * LENGTH, 0.2) } } else { Shape::Straight },
            up: Some((turn * Vector3::y()).into()),
            twist: if self.bent { 0.8 } else { 0.0 },
            formulation: self.formulation,
            section_end: self.section_end.map(|_| "end".into()),
            slopes: self.slopes,
            ..Beam::straight("rod", [place(0.0, 0.0), place(LENGTH, 0.0)], 1, "circle", "steel")
        };
        model
    }

    pub(crate) fn specimen(&self, gravity: Vector3<f64>) -> Specimen {
        let model = self.model(gravity);
        let (slope, length) = (model.bodies[0].slope_length(), model.bodies[0].length());
        let assembly = model.assemble().unwrap();
        let mesh = assembly.mesh("rod").unwrap();
        let term = mesh.terms().remove(0);
        let vectors = mesh.vectors(&assembly.rest()).collect();
        Specimen { name: self.to_string(), make: *self, term, vectors, slope, length }
    }
}

impl std::fmt::Display for Make {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { formulation, section, section_end, poisson, law, damping, bent, slopes, tilted } = self;
        write!(f, "{formulation:?}, {section:?} to {section_end:?}, nu = {poisson}, {law:?}, {damping:?}, ")?;
        write!(f, "bent: {bent}, slopes: {slopes:?}, tilted: {tilted}")
    }
}

/// An element with its reference vectors.
pub(crate) struct Specimen {
    pub(crate) name: String,
    pub(crate) make: Make,
    pub(crate) term: Box<dyn Term>,
    pub(crate) vectors: Vec<NodalVector>,
    /// Slope length.
    pub(crate) slope: f64,
    /// Length of its axis.
    pub(crate) length: f64,
}

impl Specimen {
    /// E A.
    pub(crate) fn stiffness(&self) -> f64 {
        30.0 * self.make.section.moments().area
    }

    /// Coordinates of a rigid motion.
    pub(crate) fn moved(&self, turn: Rotation3<f64>, shift: Vector3<f64>) -> DVector<f64> {
        self.field(|e| turn * e - e, shift)
    }

    /// Velocities of a rigid motion with the angular velocity `spin`, from the position `q`.
    pub(crate) fn spinning(&self, q: &DVector<f64>, spin: Vector3<f64>, drift: Vector3<f64>) -> DVector<f64> {
        let mut v = self.field(|e| spin.cross(&e), drift);
        for k in 0..self.vectors.len() {
            let turned = spin.cross(&Vector3::from(q.fixed_rows::<3>(3 * k)));
            v.fixed_rows_mut::<3>(3 * k).add_assign(&turned);
        }
        v
    }

    fn field(&self, of: impl Fn(Vector3<f64>) -> Vector3<f64>, shift: Vector3<f64>) -> DVector<f64> {
        let vectors = self
            .vectors
            .iter()
            .map(|vector| of(vector.value) + if vector.is_position() { shift } else { Vector3::zeros() });
        DVector::from_vec(vectors.flat_map(<[f64; 3]>::from).collect())
    }
}

const SECTIONS: [Section; 5] = [
    Section::Circle { diameter: 0.3 },
    Section::Tube { outer: 0.3, inner: 0.2 },
    Section::Rectangle { height: 0.3, width: 0.2 },
    Section::Ellipse { height: 0.2, width: 0.3 },
    Section::General {
        area: 0.05,
        iy: 2e-4,
        iz: 4e-4,
        j: Some(3e-4),
        ky: 0.8,
        kz: 0.6,
        mass_iy: Some(3e-4),
        mass_iz: Some(5e-4),
    },
];

/// Every formulation with every section, Poisson's ratio, slope length and frame, straight, bent and tapered; those
/// with a neo-Hookean law, too.
pub(crate) fn makes() -> Vec<Make> {
    let mut makes = Vec::new();
    for formulation in FORMULATIONS {
        for section in SECTIONS {
            for poisson in [0.0, 0.3] {
                let plain = Make::straight(formulation, section, poisson);
                let tilted = Make { tilted: true, slopes: Slopes::Length, ..plain };
                makes.extend([plain, tilted, Make { bent: true, ..plain }, Make { bent: true, ..tilted }]);
                if let Section::Rectangle { height, width } = section {
                    let end = Section::Rectangle { height: 0.5 * height, width: 1.2 * width };
                    let tapered = Make { section_end: Some(end), ..plain };
                    makes.extend([tapered, Make { bent: true, ..tapered }]);
                }
            }
        }
    }
    let soft = |make: &Make| Make { law: MaterialLaw::NeoHookean, ..*make };
    makes.extend(
        makes.iter().filter(|m| m.formulation == Formulation::Continuum).map(soft).collect::<Vec<_>>(),
    );
    makes
}
