use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{
    Against, Analysis, At, Beam, Body, Cable, Contact, Damping, Dynamics, End, Ground, Joint, Load, Material,
    Model, Output, Place, Probe, Section, Shape, Step, TimeFunction, Varying,
};
use crate::scales::{Dimension, Scales};

/// How the units of the equations are chosen.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum ScaleChoice {
    /// The user's own: the dimensional form.
    #[default]
    None,
    /// Of Kim et al. (2017): length of the beam, weight of one element, time by eq. (7). For one beam under gravity.
    Paper,
    /// The longest body's length L; the weight of that body, or E I/L² without gravity; time by eq. (7); each rounded to a
    /// power of two, so that nothing is lost on the way to these units and back.
    Auto,
    /// Given by number.
    Given {
        /// Unit of length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        length: f64,
        /// Unit of force.
        #[schemars(extend("exclusiveMinimum" = 0))]
        force: f64,
        /// Unit of time; by eq. (7) with the ρA of the longest body if left out.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[schemars(extend("exclusiveMinimum" = 0))]
        time: Option<f64>,
    },
}

/// The units chosen for a model, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Chosen {
    /// The units.
    pub scales: Scales,
    /// How they were chosen, in words.
    pub reason: String,
}

impl Model {
    /// The units in which the equations of this model are to be solved.
    ///
    /// The model must be a valid one (see [`Model::check`]).
    pub fn scales(&self) -> Chosen {
        let longest = self.bodies.iter().max_by(|a, b| a.length().total_cmp(&b.length()));
        let (Some(body), false) = (longest, self.scales == ScaleChoice::None) else {
            return Chosen { scales: Scales::UNIT, reason: "the user's own units".into() };
        };
        let (length, name) = (body.length(), body.name());
        let (line_mass, bending) = self.line(body);
        let weight = line_mass * length * Vector3::from(self.gravity).norm();
        let (scales, reason) = match self.scales {
            ScaleChoice::Given { length, force, time } => {
                let by_eq_7 = Scales::from_force(length, force, line_mass);
                (Scales { time: time.unwrap_or(by_eq_7.time), ..by_eq_7 }, "given".into())
            }
            ScaleChoice::Paper => (
                Scales::from_force(length, weight / f64::from(body.elements()), line_mass),
                format!("length of `{name}`, weight of one element, time by eq. (7)"),
            ),
            ScaleChoice::Auto | ScaleChoice::None if weight > 0.0 => (
                Scales::from_force(length, weight, line_mass).rounded(),
                format!("length and weight of the longest body, `{name}`, time by eq. (7), as powers of two"),
            ),
            ScaleChoice::Auto | ScaleChoice::None => (
                Scales::from_force(length, bending / length.powi(2), line_mass).rounded(),
                format!(
                    "length L and E I/L2 of the longest body, `{name}`, time by eq. (7), as powers of two"
                ),
            ),
        };
        Chosen { scales, reason }
    }

    /// The mass of all bodies.
    pub fn mass(&self) -> f64 {
        self.bodies.iter().map(|body| self.line(body).0 * body.length()).sum()
    }

    /// The length of the longest body.
    pub fn length(&self) -> f64 {
        self.bodies.iter().map(|body| body.length()).fold(0.0, f64::max)
    }

    /// ρA and the smaller E I of a body.
    fn line(&self, body: &Body) -> (f64, f64) {
        let (material, section) = (&self.materials[body.material()], self.sections[body.section()].moments());
        (material.density * section.area, material.young * section.yy.min(section.zz))
    }

    /// The same model in other units: what comes out is a model like any other, whose own scales are none.
    ///
    /// Tolerances of the absolute stopping rules stay as they are: they refer to the numbers of the solver.
    #[must_use]
    pub fn scaled(&self, scales: &Scales) -> Self {
        let Self {
            title,
            gravity,
            materials,
            sections,
            bodies,
            joints,
            loads,
            contacts,
            scales: _,
            analysis,
            probes,
            output,
        } = self.clone();
        Self {
            title,
            gravity: vector(gravity, Dimension::ACCELERATION, scales),
            materials: materials.into_iter().map(|(name, m)| (name, m.scaled(scales))).collect(),
            sections: sections.into_iter().map(|(name, s)| (name, s.scaled(scales))).collect(),
            bodies: bodies.into_iter().map(|body| body.scaled(scales)).collect(),
            joints: joints.into_iter().map(|joint| joint.scaled(scales)).collect(),
            loads: loads.into_iter().map(|load| load.scaled(scales)).collect(),
            contacts: contacts.into_iter().map(|contact| contact.scaled(scales)).collect(),
            scales: ScaleChoice::None,
            analysis: analysis.scaled(scales),
            probes: probes
                .into_iter()
                .map(|probe| Probe {
                    on: probe.on.scaled(scales),
                    offset: probe.offset.map(|x| number(x, Dimension::LENGTH, scales)),
                    ..probe
                })
                .collect(),
            output: output.scaled(scales),
        }
    }
}

fn number(x: f64, of: Dimension, scales: &Scales) -> f64 {
    x / scales.unit(of)
}

fn vector(x: [f64; 3], of: Dimension, scales: &Scales) -> [f64; 3] {
    x.map(|x| number(x, of, scales))
}

// Each part is taken apart field by field, so that a new field cannot be forgotten here.

impl Material {
    fn scaled(self, s: &Scales) -> Self {
        let Self { density, young, poisson, law, damping: Damping { strain, mass } } = self;
        Self {
            density: number(density, Dimension::DENSITY, s),
            young: number(young, Dimension::STRESS, s),
            poisson,
            law,
            damping: Damping {
                strain: number(strain, Dimension::TIME, s),
                mass: number(mass, Dimension::RATE, s),
            },
        }
    }
}

impl Section {
    fn scaled(self, s: &Scales) -> Self {
        let length = |x| number(x, Dimension::LENGTH, s);
        let second = |x| number(x, Dimension::SECOND_MOMENT, s);
        match self {
            Self::Circle { diameter } => Self::Circle { diameter: length(diameter) },
            Self::Tube { outer, inner } => Self::Tube { outer: length(outer), inner: length(inner) },
            Self::Rectangle { height, width } => {
                Self::Rectangle { height: length(height), width: length(width) }
            }
            Self::Ellipse { height, width } => Self::Ellipse { height: length(height), width: length(width) },
            Self::General { area, iy, iz, j, ky, kz, mass_iy, mass_iz } => Self::General {
                area: number(area, Dimension::AREA, s),
                iy: second(iy),
                iz: second(iz),
                j: j.map(second),
                ky,
                kz,
                mass_iy: mass_iy.map(second),
                mass_iz: mass_iz.map(second),
            },
        }
    }
}

impl Body {
    fn scaled(self, s: &Scales) -> Self {
        let point = |x| vector(x, Dimension::LENGTH, s);
        match self {
            Self::Beam(beam) => {
                let Beam { from, to, shape, .. } = beam;
                Self::Beam(Beam { from: point(from), to: point(to), shape: shape.scaled(s), ..beam })
            }
            Self::Cable(cable) => {
                Self::Cable(Cable { from: point(cable.from), to: point(cable.to), ..cable })
            }
        }
    }
}

impl Shape {
    fn scaled(self, s: &Scales) -> Self {
        let point = |x| vector(x, Dimension::LENGTH, s);
        match self {
            Self::Straight => Self::Straight,
            Self::Arc { through } => Self::Arc { through: point(through) },
            Self::Helix { center, axis, turns } => Self::Helix { center: point(center), axis, turns },
            Self::Spline { through } => Self::Spline { through: through.into_iter().map(point).collect() },
        }
    }
}

impl Place {
    fn scaled(self, s: &Scales) -> Self {
        let Self { body, at } = self;
        let at = match at {
            At::End(end) => At::End(end),
            At::Length(x) => At::Length(number(x, Dimension::LENGTH, s)),
        };
        Self { body, at }
    }
}

impl Joint {
    fn scaled(self, s: &Scales) -> Self {
        let end = |b| match b {
            End::Ground => End::Ground,
            End::Place(place) => End::Place(place.scaled(s)),
            End::Point(Ground { point }) => End::Point(Ground { point: vector(point, Dimension::LENGTH, s) }),
        };
        match self {
            Self::Clamp { name, a, b, fix } => Self::Clamp { name, a: a.scaled(s), b: end(b), fix },
            Self::Revolute { name, a, b, axis } => Self::Revolute { name, a: a.scaled(s), b: end(b), axis },
            Self::Spherical { name, a, b } => Self::Spherical { name, a: a.scaled(s), b: end(b) },
            Self::Drive { name, a, axis, angle, time, fix } => {
                Self::Drive { name, a: a.scaled(s), axis, angle, time: time.scaled(s), fix }
            }
        }
    }
}

impl Load {
    fn scaled(self, s: &Scales) -> Self {
        match self {
            Self::Force { on, force, follower, time } => Self::Force {
                on: on.scaled(s),
                force: vector(force, Dimension::FORCE, s),
                follower,
                time: time.scaled(s),
            },
            Self::Moment { on, moment, follower, time } => Self::Moment {
                on: on.scaled(s),
                moment: vector(moment, Dimension::ENERGY, s),
                follower,
                time: time.scaled(s),
            },
        }
    }
}

impl TimeFunction {
    fn scaled(self, s: &Scales) -> Self {
        let time = |x| number(x, Dimension::TIME, s);
        let Self::Varying(varying) = self else { return self };
        Self::Varying(match varying {
            Varying::Table { times, values } => {
                Varying::Table { times: times.into_iter().map(time).collect(), values }
            }
            Varying::Ramp { start, end } => Varying::Ramp { start: time(start), end: time(end) },
            Varying::Step { at, until } => Varying::Step { at: time(at), until: until.map(time) },
            Varying::Sine { frequency, phase } => {
                Varying::Sine { frequency: number(frequency, Dimension::RATE, s), phase }
            }
            // The text is the user's, in the user's time.
            Varying::Expression { text, unit } => {
                Varying::Expression { text, unit: number(unit, Dimension::RATE, s) }
            }
        })
    }
}

impl Output {
    fn scaled(self, s: &Scales) -> Self {
        let Self { interval, every, energy_parts, csv, npz } = self;
        Self { interval: interval.map(|x| number(x, Dimension::TIME, s)), every, energy_parts, csv, npz }
    }
}

impl Analysis {
    fn scaled(self, s: &Scales) -> Self {
        // Load factors and counts have no units.
        let dynamics = match self {
            Self::Dynamics(dynamics) => dynamics,
            Self::Statics(_) | Self::Path(_) | Self::Modes(_) | Self::Buckling(_) => return self,
        };
        let Dynamics { duration, step, scheme, start, stop, max_iterations, max_halvings } = dynamics;
        let time = |x| number(x, Dimension::TIME, s);
        Self::Dynamics(Dynamics {
            duration: time(duration),
            step: match step {
                Step::Fixed(step) => Step::Fixed(time(step)),
                Step::Adaptive { tolerance, initial, largest } => {
                    Step::Adaptive { tolerance, initial: initial.map(time), largest: largest.map(time) }
                }
            },
            scheme,
            start,
            stop,
            max_iterations,
            max_halvings,
        })
    }
}

impl Contact {
    fn scaled(self, s: &Scales) -> Self {
        let Self { with, bodies, radius, points, stiffness, transition, damping, friction, slip_speed } =
            self;
        let length = |x| number(x, Dimension::LENGTH, s);
        Self {
            with: with.scaled(s),
            bodies,
            radius: radius.map(length),
            points,
            stiffness: number(stiffness, Dimension::STRESS, s),
            transition: transition.map(length),
            damping: number(damping, Dimension::new(-1, 1, 0), s),
            friction,
            slip_speed: slip_speed.map(|x| number(x, Dimension::VELOCITY, s)),
        }
    }
}

impl Against {
    fn scaled(self, s: &Scales) -> Self {
        let length = |x| number(x, Dimension::LENGTH, s);
        let vector = |x| vector(x, Dimension::LENGTH, s);
        let place = |on: Option<Place>| on.map(|place| place.scaled(s));
        match self {
            Self::Plane { point, normal, on } => Self::Plane { point: vector(point), normal, on: place(on) },
            Self::Sphere { center, radius, inside, on } => {
                Self::Sphere { center: vector(center), radius: length(radius), inside, on: place(on) }
            }
            Self::Cylinder { point, axis, radius, inside, on } => {
                Self::Cylinder { point: vector(point), axis, radius: length(radius), inside, on: place(on) }
            }
            Self::Bodies => Self::Bodies,
        }
    }
}
