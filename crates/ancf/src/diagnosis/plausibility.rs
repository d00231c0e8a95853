//! Numbers that indicate mixed units. They are possible, so they are warnings.

use nalgebra::Vector3;

use super::free_motion::number;
use crate::model::{Body, Model};
use crate::units::{Dimension, Units};

/// Smallest speed of axial waves in a solid, m/s: gels.
const SLOWEST: f64 = 1.0;
/// Smallest speed in a solid that is denser than [`DENSE`], m/s: lead has 1200 m/s.
const SLOWEST_DENSE: f64 = 100.0;
/// Density of metals and of minerals, kg/m³. Filled silicones remain below.
const DENSE: f64 = 2500.0;
/// Largest speed of axial waves in a solid, m/s: diamond has 18 000 m/s.
const FASTEST: f64 = 20_000.0;
/// Gravity of the earth, m/s².
const EARTH: f64 = 9.81;
/// Relative variation of gravity on the earth, and of its rounded values.
const EARTH_VARIES: f64 = 0.006;
/// Ratio of the deflection of a body under its own weight to its length that is reported.
const SAG: f64 = 10.0;

/// Describes numbers of a model that are likely to be in mixed units, one sentence each.
pub(crate) fn unit_warnings(model: &Model) -> Vec<String> {
    let si = SiUnits::of(model);
    let mut warnings: Vec<String> = gravity(model, &si).into_iter().collect();
    warnings.extend(materials(model, &si));
    warnings.extend(model.bodies.iter().filter_map(|body| thickness(model, body)));
    warnings.extend(model.bodies.iter().filter_map(|body| sag(model, body)));
    warnings
}

/// Units of the numbers of a model in SI units, as far as they are known.
struct SiUnits {
    /// m.
    length: Option<f64>,
    /// s.
    time: Option<f64>,
    /// N.
    force: Option<f64>,
}

impl SiUnits {
    /// Units by the names that the model states, or else by the size of its gravity.
    fn of(model: &Model) -> Self {
        let Some(Units { length, time, force }) = &model.units else {
            return Self::by_gravity(model);
        };
        Self { length: unit_of_length(length), time: unit_of_time(time), force: unit_of_force(force) }
    }

    /// Metre and second, or millimetre and second, if the gravity of the earth has the stated size in them.
    fn by_gravity(model: &Model) -> Self {
        let stated = magnitude(model.gravity);
        let is_earth = |metre: &f64| (stated * metre / EARTH - 1.0).abs() < EARTH_VARIES;
        let metre = [1.0, 1e-3].into_iter().find(is_earth);
        Self { length: metre, time: metre.map(|_| 1.0), force: None }
    }

    /// Unit of a dimension in SI units.
    fn unit(&self, of: Dimension) -> Option<f64> {
        let power =
            |unit: Option<f64>, power: i32| if power == 0 { Some(1.0) } else { Some(unit?.powi(power)) };
        Some(power(self.length, of.length)? * power(self.time, of.time)? * power(self.force, of.force)?)
    }
}

/// Length of a unit in m.
fn unit_of_length(name: &str) -> Option<f64> {
    let known = [
        ("m", 1.0),
        ("dm", 0.1),
        ("cm", 1e-2),
        ("mm", 1e-3),
        ("um", 1e-6),
        ("µm", 1e-6),
        ("km", 1e3),
        ("in", 0.0254),
        ("ft", 0.3048),
    ];
    find(&known, name)
}

/// Duration of a unit in s.
fn unit_of_time(name: &str) -> Option<f64> {
    find(&[("s", 1.0), ("ms", 1e-3), ("us", 1e-6), ("µs", 1e-6), ("min", 60.0)], name)
}

/// Size of a unit in N.
fn unit_of_force(name: &str) -> Option<f64> {
    find(&[("N", 1.0), ("mN", 1e-3), ("kN", 1e3), ("MN", 1e6), ("lbf", 4.448_221_615_260_5)], name)
}

fn find(known: &[(&str, f64)], name: &str) -> Option<f64> {
    known.iter().find(|(known, _)| *known == name).map(|(_, size)| *size)
}

fn magnitude(vector: [f64; 3]) -> f64 {
    Vector3::from(vector).norm()
}

/// Gravity of the earth, off by a power of ten.
fn gravity(model: &Model, si: &SiUnits) -> Option<String> {
    let (names, unit) = (model.units.as_ref()?, si.unit(Dimension::ACCELERATION)?);
    let ratio = magnitude(model.gravity) * unit / EARTH;
    let power = ratio.log10().round();
    let is_off = power.abs() >= 2.0 && (ratio / 10_f64.powf(power) - 1.0).abs() < EARTH_VARIES;
    is_off.then(|| {
        format!(
            "`gravity` is {} {}, which is {} m/s²: that of the earth is {} in these units",
            number(magnitude(model.gravity)),
            names.of(Dimension::ACCELERATION),
            number(ratio * EARTH),
            number(EARTH / unit)
        )
    })
}

/// Materials with a speed of axial waves √(E/ρ) that no solid has.
fn materials<'a>(model: &'a Model, si: &'a SiUnits) -> impl Iterator<Item = String> + 'a {
    let speed_unit = si.unit(Dimension::VELOCITY);
    let density_unit = si.unit(Dimension::DENSITY);
    model.materials.iter().filter_map(move |(name, material)| {
        let speed = (material.young / material.density).sqrt() * speed_unit?;
        let is_dense = density_unit.map_or(material.density > DENSE, |unit| material.density * unit > DENSE);
        let slowest = if is_dense { SLOWEST_DENSE } else { SLOWEST };
        (!(slowest..=FASTEST).contains(&speed)).then(|| {
            format!(
                "`materials.{name}`: axial waves have the speed sqrt(young/density) = {} m/s, and {slowest} to {FASTEST} m/s in \
                 solids{}: check the units of `young` and `density`",
                number(speed),
                if is_dense { " of this density" } else { "" }
            )
        })
    })
}

/// A body that is thicker than long.
fn thickness(model: &Model, body: &Body) -> Option<String> {
    let (section, _) = body.section_and_material()?;
    let moments = model.sections.get(section)?.moments();
    // Diameter of a round section.
    let thick = 4.0 * (moments.yy.max(moments.zz) / moments.area).sqrt();
    (thick > body.length()).then(|| {
        let [thick, long] = [thick, body.length()].map(number);
        format!(
            "body `{}` is {long} long, and its section is {thick} thick: check the units of `sections.{section}`",
            body.name()
        )
    })
}

/// A beam of an equilibrium, modes or buckling that its own weight deflects by many lengths, by the linear theory of the cantilever.
fn sag(model: &Model, body: &Body) -> Option<String> {
    let Body::Beam(beam) = body else { return None };
    if model.analysis.dynamics().is_some() {
        return None;
    }
    let [from, to] = body.span().map(Vector3::from);
    let axis = (to - from).try_normalize(0.0)?;
    let transverse = Vector3::from(model.gravity).cross(&axis).norm();
    let (line_mass, stiffness) = model.line_properties(body);
    let sag = line_mass * transverse * body.length().powi(3) / (8.0 * stiffness);
    (sag > SAG).then(|| {
        format!(
            "beam `{}`: its weight deflects a cantilever of its length by {} lengths in linear theory: check the units of \
             `materials.{}` and `sections.{}`, if it is not a rope",
            beam.name,
            number(sag),
            beam.material,
            beam.section
        )
    })
}
