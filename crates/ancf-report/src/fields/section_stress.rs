use ancf::Model;
use ancf::model::Body;

use crate::geometry::{Geometry, Outline, SIDES, outline};

/// Axial stress in a section by section forces.
#[derive(Clone, Debug)]
pub(crate) struct SectionStress {
    area: f64,
    /// I_y = ∫z² dA, I_z = ∫y² dA.
    second: [f64; 2],
    outline: Outline,
    /// True for a beam. The transverse axes of a cable are arbitrary.
    pub has_axes: bool,
}

impl SectionStress {
    /// Sections at all stations of a model in the user's units; `None` for rigid bodies.
    pub fn at_stations(model: &Model, geometry: &Geometry<'_>) -> Vec<Option<Self>> {
        let stations = geometry.fields.stations().iter();
        let of = |station: &ancf::Station| {
            let body = &model.bodies[station.body];
            let section = model.section_at(body, (station.s / body.length()).clamp(0.0, 1.0))?;
            let moments = section.moments();
            let has_axes = matches!(body, Body::Beam(_));
            let (second, outline) = ([moments.zz, moments.yy], outline(&section, SIDES));
            Some(Self { area: moments.area, second, outline, has_axes })
        };
        stations.map(of).collect()
    }

    /// Computes N/A + My z/I_y − Mz y/I_z at a point of the section; N/A of a cable, whose bending has no axes.
    pub fn stress(&self, forces: [f64; 6], [y, z]: [f64; 2]) -> f64 {
        let [n, .., my, mz] = forces;
        let bend = if self.has_axes { my * z / self.second[0] - mz * y / self.second[1] } else { 0.0 };
        n / self.area + bend
    }

    /// Computes the maximum of |N/A + My z/I_y − Mz y/I_z| over the outline.
    pub fn largest_stress(&self, forces: [f64; 6]) -> f64 {
        let [n, .., my, mz] = forces;
        let bend = self.outline.reach([mz / self.second[1], my / self.second[0]], [1.0; 2]);
        (n / self.area).abs() + bend
    }
}
