use ancf::Model;
use ancf::model::{Analysis, Joint};
use ancf::units::Dimension;

use crate::run::Run;

/// Forces below which models of rigid bodies without weight have none.
const NO_FORCE: f64 = 1e-3;

/// Angle during a motion below which rates are not of interest.
const SMALL_TURN: f64 = 0.01;

/// Rounding errors of displacements in accelerations, relative to the length, divided by the tolerances.
const ROUNDING: f64 = 1e-8;

/// Magnitudes of the quantities of a run, by dimension. Deviations are relative to them.
#[derive(Clone, Debug)]
pub struct Magnitudes {
    length: f64,
    duration: f64,
    /// Acceleration of no interest: of a small turn in the duration, or of the rounding errors of the shortest step.
    acceleration: f64,
    /// Axial stiffness of the stiffest body, force of the stiffest spring, or weight.
    stiffness: f64,
    /// Force that gives the smallest acceleration of interest to all bodies; zero without a motion.
    inertia: f64,
    /// Largest modulus of elasticity.
    young: f64,
    largest: Vec<(Dimension, f64)>,
}

impl Magnitudes {
    /// Magnitudes of a run of a model: the largest value of each dimension, with lower limits for quantities that are zero.
    pub fn new(model: &Model, run: &Run) -> Self {
        let axial = model.bodies.iter().filter_map(|body| {
            let (section, material) = body.section_and_material()?;
            let area = model.sections.get(section)?.moments().area;
            Some(model.materials.get(material)?.young * area)
        });
        let elastic = model.joints.iter().map(|joint| match joint {
            Joint::Spring(spring) => spring.stiffness * model.length(),
            Joint::Bushing(bushing) => bushing.stiffness.iter().copied().fold(0.0, f64::max) * model.length(),
            _ => 0.0,
        });
        let weight = model.mass() * model.gravity.iter().map(|g| g * g).sum::<f64>().sqrt();
        let stiffness = axial.chain(elastic).fold(weight, f64::max).max(NO_FORCE);
        let (duration, mass) = match &model.analysis {
            Analysis::Dynamics(dynamics) => (dynamics.duration, model.mass()),
            _ => (1.0, 0.0),
        };
        let of_steps = ROUNDING * model.length() / shortest_step(model).powi(2);
        let acceleration = (SMALL_TURN * model.length() / (duration * duration)).max(of_steps);
        let inertia = mass * acceleration;
        let mut largest: Vec<(Dimension, f64)> = Vec::new();
        for column in &run.columns {
            let Some(dimension) = column.dimension else { continue };
            let value = column.values.iter().filter(|x| x.is_finite()).fold(0.0_f64, |m, x| m.max(x.abs()));
            match largest.iter_mut().find(|(of, _)| *of == dimension) {
                Some((_, known)) => *known = known.max(value),
                None => largest.push((dimension, value)),
            }
        }
        let young = model.materials.values().map(|m| m.young).fold(f64::MIN_POSITIVE, f64::max);
        Self { length: model.length(), duration, acceleration, stiffness, inertia, young, largest }
    }

    /// Magnitude of quantities of a dimension.
    pub fn of(&self, dimension: Dimension) -> f64 {
        let largest =
            |of: Dimension| self.largest.iter().find(|(known, _)| *known == of).map_or(0.0, |(_, x)| *x);
        let rate = SMALL_TURN / self.duration;
        let force = largest(Dimension::FORCE).max(1e-7 * self.stiffness).max(self.inertia);
        match dimension {
            Dimension::NUMBER => 1.0,
            Dimension::LENGTH => self.length,
            Dimension::RATE => largest(dimension).max(rate),
            Dimension::VELOCITY => largest(dimension).max(rate * self.length),
            Dimension::ACCELERATION => largest(dimension).max(self.acceleration),
            Dimension::FORCE => force,
            Dimension::ENERGY => largest(dimension).max(0.02 * force * self.length),
            Dimension::STRESS => largest(dimension).max(1e-7 * self.young),
            _ => largest(dimension).max(f64::MIN_POSITIVE),
        }
    }
}

/// Shortest step of a run with fixed steps, which is the last one unless the duration is a multiple of the step.
fn shortest_step(model: &Model) -> f64 {
    let settings = model.analysis.dynamics().and_then(|own| Some((own.duration, own.step.fixed()?)));
    settings.map_or(f64::INFINITY, |(duration, step)| {
        let remainder = duration % step;
        if remainder > 0.01 * step { remainder } else { step }
    })
}
