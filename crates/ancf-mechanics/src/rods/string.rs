use std::fmt;

use nalgebra::Vector3;

use super::part::RodLoads;
use super::section::RodSection;
use crate::kinematics::gauss;

/// Taut part of a rod: a string, with boundary layers of bending at the ends of the body.
///
/// The tangent is u + d, with the direction u = n/|n| of the force and EI d″ = |n| d: d = d₀ exp(−x/b) at a distance x from the end,
/// with the thickness b = √(EI/|n|). Terms of the order exp(−l/b) are neglected.
pub struct TautString<'a> {
    /// Length.
    pub length: f64,
    /// Section at ξ in [0, 1].
    pub section: &'a dyn Fn(f64) -> RodSection,
    /// Loads.
    pub loads: &'a RodLoads,
    /// Both ends.
    pub ends: [StringEnd; 2],
}

/// End of a taut part.
#[derive(Clone, Copy, Debug)]
pub struct StringEnd {
    /// Unit tangent of the element.
    pub tangent: Vector3<f64>,
    /// Section moment.
    pub moment: Vector3<f64>,
    /// True if the body continues there: it has no layer.
    pub is_free: bool,
}

/// Moment, relative to that of the layer of the tangent, below which an end is hinged.
const HINGED: f64 = 1e-3;

impl fmt::Debug for TautString<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TautString")
            .field("length", &self.length)
            .field("loads", &self.loads)
            .finish_non_exhaustive()
    }
}

/// Layer at an end of a taut part: its deviation d₀ from the direction u₀ of the force, the derivative u′ of this direction by the
/// distance from the end, and its thickness b.
struct Layer {
    deviation: Vector3<f64>,
    direction: Vector3<f64>,
    turning: Vector3<f64>,
    thickness: f64,
}

impl TautString<'_> {
    /// Returns the vector from the start to ξ: ∫ u λ(|n|) + EI/|n| u″ ds by five Gauss points, and the integrals of the
    /// layers.
    pub fn chord(&self, xi: f64) -> Vector3<f64> {
        let slope = (self.loads.forces[1] - self.loads.forces[0]) / self.length;
        let tangent = |at: f64| {
            let (force, section) = (self.loads.force(at), (self.section)(at));
            let size = force.norm();
            let (direction, stiffness) = (force / size, 1.0 / section.flexibility_under(size));
            let along = direction.dot(&slope);
            // u″ normal to u, for a linear force.
            let second = (slope - direction * along) * (-2.0 * along / (size * size));
            direction * (1.0 + section.strain + section.extension(size)) + second * (stiffness / size)
        };
        let part = |[from, to]: [f64; 2]| -> Vector3<f64> {
            let share = |(x, weight): (f64, f64)| tangent(from + (to - from) * x) * (weight * (to - from));
            gauss().map(share).iter().sum::<Vector3<f64>>() * self.length
        };
        let string: Vector3<f64> = self.loads.parts(xi).map(part).sum();
        let s = xi * self.length;
        let layers = [(0, [0.0, s]), (1, [self.length - s, self.length])];
        let of_layer = |(end, [from, to]): (usize, [f64; 2])| Some(self.layer(end)?.between(from, to));
        string + layers.into_iter().filter_map(of_layer).sum::<Vector3<f64>>()
    }

    /// Returns the section moment of the string at an end, EI u × (u′ ± d₀/b).
    pub fn moment(&self, end: usize) -> Vector3<f64> {
        let xi = end as f64;
        let force = self.loads.force(xi);
        let size = force.norm();
        let stiffness = 1.0 / (self.section)(xi).flexibility_under(size);
        let slope = (self.loads.forces[1] - self.loads.forces[0]) / (self.length * size);
        let layer = self.layer(end).map_or_else(Vector3::zeros, |layer| layer.deviation / layer.thickness);
        let sign = if end == 0 { -1.0 } else { 1.0 };
        force.cross(&(slope + layer * sign)) * (stiffness / size)
    }

    /// Returns the layer of an end: that of the tangent, or of a hinge without moment. A body that continues has none.
    fn layer(&self, end: usize) -> Option<Layer> {
        let (xi, StringEnd { tangent, moment, is_free }) = (end as f64, &self.ends[end]);
        let force = self.loads.force(xi);
        let size = force.norm();
        let stiffness = 1.0 / (self.section)(xi).flexibility_under(size);
        if *is_free || size == 0.0 {
            return None;
        }
        let (direction, sign) = (force / size, if end == 0 { 1.0 } else { -1.0 });
        let slope = (self.loads.forces[1] - self.loads.forces[0]) / self.length;
        let turning = (slope - direction * direction.dot(&slope)) * (sign / size);
        let thickness = (stiffness / size).sqrt().min(0.5 * self.length);
        let bent = tangent - direction * direction.dot(tangent);
        let is_hinged = moment.norm() < HINGED * stiffness / thickness * bent.norm();
        let deviation = if is_hinged { turning * thickness } else { bent };
        Some(Layer { deviation, direction, turning, thickness })
    }
}

impl Layer {
    /// Returns the integral of the deviation between two distances from the end of the part.
    ///
    /// With d = d₀ exp(−x/b) and u = u₀ + u′ x, the tangent has the length one and d is normal to u: the deviation from u is
    /// d − u₀ (d·u′ x + ½ d²).
    fn between(&self, from: f64, to: f64) -> Vector3<f64> {
        let Self { deviation, direction, turning, thickness: b } = self;
        let integral = |x: f64| {
            let decay = (-x / b).exp();
            let along = deviation.dot(turning) * -b * (x + b) * decay;
            let square = 0.5 * deviation.norm_squared() * -0.5 * b * decay * decay;
            deviation * (-b * decay) - direction * (along + square)
        };
        integral(to) - integral(from)
    }
}
