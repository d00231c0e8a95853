//! Beams of one element in every formulation, assembled from models.

use std::ops::AddAssign;

use ancf::Model;
use ancf::mechanics::kinematics::NodalVector;
use ancf::model::{
    Beam, Damping, Formulation, GeneralSection, MaterialLaw, Rectangle, Section, Shape, Slopes,
};
use ancf::solver::equations::Term;
use nalgebra::{DVector, Rotation3, Vector3};

use super::rod;

/// Distance of the ends.
pub(crate) const LENGTH: f64 = 0.7;

pub(crate) const FORMULATIONS: [Formulation; 4] =
    [Formulation::Continuum, Formulation::Enhanced, Formulation::Linked, Formulation::Quadratic];

/// Definition of a beam of one element.
#[derive(Clone, Debug)]
pub(crate) struct BeamCase {
    pub(crate) formulation: Formulation,
    pub(crate) section: Section,
    pub(crate) section_end: Option<Section>,
    pub(crate) poisson: f64,
    pub(crate) law: MaterialLaw,
    pub(crate) damping: Damping,
    /// Arc of radius 0.41, twisted by 0.8 rad; otherwise straight.
    pub(crate) curved: bool,
    pub(crate) slopes: Slopes,
    /// Rotated in space and shifted from the origin.
    pub(crate) tilted: bool,
}

impl BeamCase {
    /// Straight beam along x.
    pub(crate) fn straight(formulation: Formulation, section: Section, poisson: f64) -> Self {
        Self {
            formulation,
            section,
            section_end: None,
            poisson,
            law: MaterialLaw::StVenantKirchhoff,
            damping: Damping::default(),
            curved: false,
            slopes: Slopes::Gradient,
            tilted: false,
        }
    }

    /// Returns true if the formulation supports a damping.
    pub(crate) fn supports(&self, damping: &Damping) -> bool {
        self.formulation != Formulation::Continuum || damping.bending.is_none()
    }

    /// Model with E = 30, ρ = 2, under gravity.
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
        model.sections.insert("circle".into(), self.section.clone());
        if let Some(end) = &self.section_end {
            model.sections.insert("end".into(), end.clone());
        }
        *rod::beam(&mut model) = Beam {
            shape: if self.curved {
                Shape::Arc { through: place(0.5 * LENGTH, 0.2) }
            } else {
                Shape::Straight
            },
            up: Some((turn * Vector3::y()).into()),
            twist: if self.curved { 0.8 } else { 0.0 },
            formulation: self.formulation,
            section_end: self.section_end.as_ref().map(|_| "end".into()),
            slopes: self.slopes,
            ..Beam::straight("rod", [place(0.0, 0.0), place(LENGTH, 0.0)], 1, "circle", "steel")
        };
        model
    }

    /// Assembles the element.
    pub(crate) fn element(&self, gravity: Vector3<f64>) -> BeamElement {
        let model = self.model(gravity);
        let (slope, length) = (model.bodies[0].slope_length(), model.bodies[0].length());
        let assembly = model.assemble().unwrap();
        let mesh = assembly.mesh("rod").unwrap();
        let term = mesh.terms().remove(0);
        let vectors = mesh.vectors(&assembly.rest()).collect();
        BeamElement { name: self.to_string(), case: self.clone(), term, vectors, slope, length }
    }
}

impl std::fmt::Display for BeamCase {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { formulation, section, section_end, poisson, law, damping, curved, slopes, tilted } = self;
        // Random samples depend on the name: it is that of the data of the section, without the variant around them.
        let section = data(format!("{section:?}"));
        let section_end = section_end
            .clone()
            .map(|end| data(format!("{end:?}")))
            .map_or("None".into(), |end| format!("Some({end})"));
        write!(f, "{formulation:?}, {section} to {section_end}, nu = {poisson}, {law:?}, {damping:?}, ")?;
        write!(f, "curved: {curved}, slopes: {slopes:?}, tilted: {tilted}")
    }
}

/// Text of the data of an enum variant: `Circle { .. }` of `Circle(Circle { .. })`.
fn data(text: String) -> String {
    match text.split_once('(') {
        Some((_, inner)) => inner.trim_end_matches(')').replace("GeneralSection", "General"),
        None => text,
    }
}

/// Beam element with its reference nodal vectors.
pub(crate) struct BeamElement {
    pub(crate) name: String,
    pub(crate) case: BeamCase,
    pub(crate) term: Box<dyn Term>,
    pub(crate) vectors: Vec<NodalVector>,
    /// Slope length.
    pub(crate) slope: f64,
    /// Length of the axis.
    pub(crate) length: f64,
}

impl BeamElement {
    /// Axial rigidity E A.
    pub(crate) fn stiffness(&self) -> f64 {
        30.0 * self.case.section.moments().area
    }

    /// Coordinates of a rigid displacement.
    pub(crate) fn rigid_displacement(&self, turn: Rotation3<f64>, shift: Vector3<f64>) -> DVector<f64> {
        self.field(|e| turn * e - e, shift)
    }

    /// Velocities of a rigid motion at the coordinates `q`.
    pub(crate) fn rigid_velocity(
        &self,
        q: &DVector<f64>,
        angular: Vector3<f64>,
        linear: Vector3<f64>,
    ) -> DVector<f64> {
        let mut v = self.field(|e| angular.cross(&e), linear);
        for k in 0..self.vectors.len() {
            let turned = angular.cross(&Vector3::from(q.fixed_rows::<3>(3 * k)));
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
    Section::circle(0.3),
    Section::tube(0.3, 0.2),
    Section::rectangle(0.3, 0.2),
    Section::ellipse(0.2, 0.3),
    Section::General(GeneralSection {
        area: 0.05,
        iy: 2e-4,
        iz: 4e-4,
        j: Some(3e-4),
        ky: 0.8,
        kz: 0.6,
        mass_iy: Some(3e-4),
        mass_iz: Some(5e-4),
    }),
];

/// Strong damping with a retardation time for each kind of deformation.
pub(crate) const BY_KIND: Damping = Damping {
    strain: 0.2,
    stretch: Some(0.1),
    bending: Some(0.3),
    shear: Some(0.05),
    torsion: Some(0.4),
    mass: 0.0,
};

/// Returns all combinations of formulation, section, Poisson's ratio, slope length and frame: straight, curved, tapered.
///
/// The continuum formulation is added with the neo-Hookean law.
pub(crate) fn beam_cases() -> Vec<BeamCase> {
    let mut cases = Vec::new();
    for formulation in FORMULATIONS {
        for section in SECTIONS {
            for poisson in [0.0, 0.3] {
                let plain = BeamCase::straight(formulation, section.clone(), poisson);
                let tilted = BeamCase { tilted: true, slopes: Slopes::Length, ..plain.clone() };
                cases.extend([
                    plain.clone(),
                    tilted.clone(),
                    BeamCase { curved: true, ..plain.clone() },
                    BeamCase { curved: true, ..tilted },
                ]);
                if let Section::Rectangle(Rectangle { height, width }) = section {
                    let end = Section::rectangle(0.5 * height, 1.2 * width);
                    let tapered = BeamCase { section_end: Some(end), ..plain };
                    cases.extend([tapered.clone(), BeamCase { curved: true, ..tapered }]);
                }
            }
        }
    }
    let neo_hookean = |case: &BeamCase| BeamCase { law: MaterialLaw::NeoHookean, ..case.clone() };
    let continuum = cases.iter().filter(|case| case.formulation == Formulation::Continuum);
    cases.extend(continuum.map(neo_hookean).collect::<Vec<_>>());
    cases
}
