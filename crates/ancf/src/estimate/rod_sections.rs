use ancf_mechanics::kinematics::ReferenceCurve;
use ancf_mechanics::rods::{AxialLaw, RodSection};
use ancf_mechanics::sections::Lame;
use nalgebra::{Matrix3, Vector3};

use crate::model::{Beam, Body, MaterialLaw, Model};

/// Elasticity and reference curvature of a flexible body as a rod.
pub(super) struct RodSections<'a> {
    model: &'a Model,
    body: &'a Body,
    material: Lame,
    is_neo_hookean: bool,
    poisson: f64,
    length: f64,
    /// Section of a prismatic body.
    constant: Option<RodSection>,
    /// Axis of a curved body, and its twist per length.
    curve: Option<ReferenceCurve>,
    twist: f64,
}

/// Arc length for differences of the tangent, relative to an element.
const DIFFERENCE: f64 = 1e-4;

impl<'a> RodSections<'a> {
    /// Creates the sections of a flexible body of a valid model; `None` for other bodies.
    pub(super) fn new(model: &'a Model, body: &'a Body) -> Option<Self> {
        let (_, material) = body.section_and_material()?;
        let (material, curve) = (&model.materials[material], body.curve()?);
        let length = curve.length();
        let twist = if let Body::Beam(beam) = body { beam.twist / length } else { 0.0 };
        let is_straight = matches!(curve, ReferenceCurve::Line { .. });
        let mut sections = Self {
            model,
            body,
            material: material.lame(),
            is_neo_hookean: material.law == MaterialLaw::NeoHookean,
            poisson: material.poisson,
            length,
            constant: None,
            curve: (!is_straight).then_some(curve),
            twist,
        };
        if !matches!(body, Body::Beam(Beam { section_end: Some(_), .. })) {
            sections.constant = Some(sections.section(0.0));
        }
        Some(sections)
    }

    /// True if the sections depend on a reference frame.
    pub(super) fn is_curved(&self) -> bool {
        self.curve.is_some()
    }

    /// Section at a fraction of the length, straight.
    fn section(&self, part: f64) -> RodSection {
        let section = self.model.section_at(self.body, part).expect("a flexible body has a section");
        let section = section.cross_section(self.poisson);
        match self.body {
            Body::Cable(_) => RodSection::cable(&section, self.material),
            // The neo-Hookean law differs from Green's strain and from the linear law by the order of the strain.
            _ if self.is_neo_hookean => {
                RodSection { law: AxialLaw::Linear, ..RodSection::beam(&section, self.material) }
            }
            _ => RodSection::beam(&section, self.material),
        }
    }

    /// Section at ξ of an element with length `l` that starts at `s`, where its reference frame is `frame`.
    pub(super) fn at(&self, s: f64, l: f64, frame: &Matrix3<f64>, xi: f64) -> RodSection {
        let here = s + xi * l;
        let section = self.constant.unwrap_or_else(|| self.section((here / self.length).min(1.0)));
        let Some(curve) = &self.curve else { return section.curved(Vector3::x() * self.twist) };
        let step = DIFFERENCE * l;
        let (before, after) = ((here - step).max(0.0), (here + step).min(self.length));
        let [t0, t1] = [before, after].map(|s| curve.at(s).1);
        let (_, tangent) = curve.at(here);
        let bend = tangent.cross(&(t1 - t0)) / (after - before);
        // The frame at ξ: that of the start carried along the axis, and twisted.
        let y = curve.carried(frame.column(1).into_owned(), s, here);
        let (sin, cos) = (self.twist * (here - s)).sin_cos();
        let z = tangent.cross(&y);
        let (y, z) = (y * cos + z * sin, z * cos - y * sin);
        section.curved(Vector3::new(self.twist, bend.dot(&y), bend.dot(&z)))
    }
}
