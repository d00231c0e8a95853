use std::f64::consts::PI;
use std::sync::Arc;

use ancf::Model;
use ancf::model::{Beam, Body};

use crate::geometry::{Geometry, Outline, SIDES, outline};

/// Stresses in a section by section forces.
#[derive(Clone, Debug)]
pub(crate) struct SectionStress {
    area: f64,
    /// Torsion constant.
    torsion: f64,
    /// I_y = ∫z² dA, I_z = ∫y² dA.
    second: [f64; 2],
    outline: Outline,
    /// True for a beam. The transverse axes of a cable are arbitrary.
    pub has_axes: bool,
}

impl SectionStress {
    /// Sections at all stations of a model in the user's units; `None` for rigid bodies.
    pub fn at_stations(model: &Model, geometry: &Geometry<'_>) -> Vec<Option<Arc<Self>>> {
        let stations = geometry.fields.stations().iter();
        // Stations of a body with a constant section share it.
        let mut last: Option<(usize, Arc<Self>)> = None;
        let mut of = |station: &ancf::Station| {
            let body = &model.bodies[station.body];
            let is_tapered = matches!(body, Body::Beam(Beam { section_end: Some(_), .. }));
            if let Some((number, own)) = &last
                && *number == station.body
                && !is_tapered
            {
                return Some(Arc::clone(own));
            }
            let section = model.section_at(body, (station.s / body.length()).clamp(0.0, 1.0))?;
            let moments = section.moments();
            let has_axes = matches!(body, Body::Beam(_));
            let (second, outline) = ([moments.zz, moments.yy], outline(&section, SIDES));
            let torsion = section.torsion_constant();
            let own = Arc::new(Self { area: moments.area, torsion, second, outline, has_axes });
            last = Some((station.body, Arc::clone(&own)));
            Some(own)
        };
        stations.map(&mut of).collect()
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

    /// Computes the sum of the maxima of the shear stresses by torsion and by the shear force.
    pub fn largest_shear(&self, [_, qy, qz, t, ..]: [f64; 6]) -> f64 {
        self.torsional_shear(t) + self.transverse_factor() * qy.hypot(qz) / self.area
    }

    /// Computes the equivalent stress of von Mises, √(σ² + 3τ²).
    ///
    /// It is the larger of the values at two points: at the extreme fibre of bending, where the shear stress by the shear force
    /// vanishes, and at the neutral axis of bending.
    pub fn von_mises(&self, forces: [f64; 6]) -> f64 {
        let [n, .., t, _, _] = forces;
        let equivalent = |axial: f64, shear: f64| (axial * axial + 3.0 * shear * shear).sqrt();
        let fibre = equivalent(self.largest_stress(forces), self.torsional_shear(t));
        fibre.max(equivalent(n / self.area, self.largest_shear(forces)))
    }

    /// Maximum shear stress by a torque T. The rate of twist times G is T/J.
    ///
    /// Ellipse with semi-axes a ≥ b: 2a²b/(a² + b²) T/J. Rectangle with sides a ≥ b:
    /// b (1 − 8/π² Σ 1/(n² cosh(nπa/2b))) T/J over odd n.
    ///
    /// Source: Timoshenko & Goodier (1970), eqs. (144), (161).
    fn torsional_shear(&self, torque: f64) -> f64 {
        let [y, z] = self.outline.half_extents;
        let (a, b) = (y.max(z), y.min(z));
        let arm = if self.outline.is_round {
            2.0 * a * a * b / (a * a + b * b)
        } else {
            let term = |n: f64| 1.0 / (n * n * (0.5 * n * PI * a / b).cosh());
            2.0 * b * (1.0 - 8.0 / (PI * PI) * [1.0, 3.0, 5.0, 7.0].map(term).iter().sum::<f64>())
        };
        (torque / self.torsion).abs() * arm
    }

    /// Ratio of the maximum shear stress by a shear force to its mean: 3/2 of a rectangle, 4/3 of an ellipse,
    /// 4/3 (1 + m + m²)/(1 + m²) of a tube with the ratio m of its radii.
    fn transverse_factor(&self) -> f64 {
        if !self.outline.is_round {
            return 1.5;
        }
        let m = self.outline.bore() / self.outline.half_extents[0];
        4.0 / 3.0 * (1.0 + m + m * m) / (1.0 + m * m)
    }
}
