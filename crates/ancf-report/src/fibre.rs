use ancf::Model;
use ancf::model::Body;

use crate::{Geometry, Outline};

/// What makes stress of section forces.
#[derive(Clone, Debug)]
pub(crate) struct Fibre {
    area: f64,
    /// I_y = ∫z² dA, I_z = ∫y² dA.
    second: [f64; 2],
    outline: Outline,
    /// Whether its axes across are its own.
    pub beam: bool,
}

impl Fibre {
    /// Of each station of a model in the user's units; rigid bodies have none.
    pub fn all(model: &Model, geometry: &Geometry<'_>) -> Vec<Option<Self>> {
        let stations = geometry.fields.stations().iter();
        let of = |station: &ancf::Station| {
            let body = &model.bodies[station.body];
            let section = model.section_at(body, (station.s / body.length()).clamp(0.0, 1.0))?;
            let moments = section.moments();
            let outline = Outline::of(&section);
            let beam = matches!(body, Body::Beam(_));
            Some(Self { area: moments.area, second: [moments.zz, moments.yy], outline, beam })
        };
        stations.map(of).collect()
    }

    /// N/A + My z/I_y − Mz y/I_z at a point of the section; of a cable, whose sections do not bend about axes of theirs, N/A.
    pub fn stress(&self, forces: [f64; 6], [y, z]: [f64; 2]) -> f64 {
        let [n, .., my, mz] = forces;
        let bend = if self.beam { my * z / self.second[0] - mz * y / self.second[1] } else { 0.0 };
        n / self.area + bend
    }

    /// The largest abs(N/A + My z/I_y − Mz y/I_z) over the outline.
    pub fn largest_stress(&self, forces: [f64; 6]) -> f64 {
        let [n, .., my, mz] = forces;
        let bend = self.outline.reach([mz / self.second[1], my / self.second[0]], [1.0; 2]);
        (n / self.area).abs() + bend
    }
}
