use crate::model::{
    Against, Analysis, At, Beam, Body, Cable, Contact, Damping, Dynamics, Fluid, Load, Material, Model,
    Output, Place, PointMass, Probe, Rigid, Section, Shape, Step, TimeFunction, Varying,
};
use crate::units::{Dimension, ScaleChoice, Scales, number, vector};

impl Model {
    /// The same model in other units: what comes out is a model like any other, whose own scales are none.
    ///
    /// Tolerances of the absolute stopping rules stay as they are: they refer to the numbers of the solver.
    #[must_use]
    pub fn scaled(&self, scales: &Scales) -> Self {
        let Self {
            title,
            units: _,
            gravity,
            materials,
            sections,
            bodies,
            joints,
            couplings: _,
            loads,
            assemble,
            contacts,
            scales: _,
            analysis,
            probes,
            output,
        } = self.clone();
        Self {
            title,
            units: None,
            gravity: vector(gravity, Dimension::ACCELERATION, scales),
            materials: materials.into_iter().map(|(name, m)| (name, m.scaled(scales))).collect(),
            sections: sections.into_iter().map(|(name, s)| (name, s.scaled(scales))).collect(),
            bodies: bodies.into_iter().map(|body| body.scaled(scales)).collect(),
            joints: joints.into_iter().map(|joint| joint.scaled(scales)).collect(),
            couplings: self.scaled_couplings(scales),
            loads: loads.into_iter().map(|load| load.scaled(scales)).collect(),
            assemble,
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
                let Beam { from, to, shape, motion, .. } = beam;
                let (from, to, motion) = (point(from), point(to), motion.scaled(s));
                Self::Beam(Beam { from, to, shape: shape.scaled(s), motion, ..beam })
            }
            Self::Cable(cable) => {
                let (from, to, motion) = (point(cable.from), point(cable.to), cable.motion.scaled(s));
                Self::Cable(Cable { from, to, motion, ..cable })
            }
            Self::Rigid(Rigid { name, center, mass, inertia, products, motion }) => {
                let moments = |x| vector(x, Dimension::INERTIA, s);
                let mass = number(mass, Dimension::MASS, s);
                let (inertia, products) = (moments(inertia), moments(products));
                let (center, motion) = (point(center), motion.scaled(s));
                Self::Rigid(Rigid { name, center, mass, inertia, products, motion })
            }
            Self::Mass(PointMass { name, center, mass, motion }) => {
                let mass = number(mass, Dimension::MASS, s);
                Self::Mass(PointMass { name, center: point(center), mass, motion: motion.scaled(s) })
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
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        let Self { body, at, offset } = self;
        Self { body, at: at.scaled(s), offset: vector(offset, Dimension::LENGTH, s) }
    }
}

impl At {
    fn scaled(self, s: &Scales) -> Self {
        match self {
            Self::Named(name) => Self::Named(name),
            Self::Length(x) => Self::Length(number(x, Dimension::LENGTH, s)),
            Self::Point(x) => Self::Point(vector(x, Dimension::LENGTH, s)),
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
            Self::DistributedForce { body, from, to, force, force_end, follower, time } => {
                let per_length = |x| vector(x, Dimension::FORCE_PER_LENGTH, s);
                Self::DistributedForce {
                    body,
                    from: from.scaled(s),
                    to: to.scaled(s),
                    force: per_length(force),
                    force_end: force_end.map(per_length),
                    follower,
                    time: time.scaled(s),
                }
            }
            Self::DistributedMoment { body, from, to, moment, moment_end, follower, time } => {
                let per_length = |x| vector(x, Dimension::FORCE, s);
                Self::DistributedMoment {
                    body,
                    from: from.scaled(s),
                    to: to.scaled(s),
                    moment: per_length(moment),
                    moment_end: moment_end.map(per_length),
                    follower,
                    time: time.scaled(s),
                }
            }
            Self::BaseAcceleration { acceleration, time } => Self::BaseAcceleration {
                acceleration: vector(acceleration, Dimension::ACCELERATION, s),
                time: time.scaled(s),
            },
            Self::Fluid(fluid) => Self::Fluid(fluid.scaled(s)),
            Self::External { on, name, units, supplied } => {
                Self::External { on: on.scaled(s), name, units: units.then(s), supplied }
            }
        }
    }
}

impl Fluid {
    fn scaled(self, s: &Scales) -> Self {
        let Self { bodies, density, current, time, diameter, area, drag, added_mass } = self;
        Self {
            bodies,
            density: number(density, Dimension::DENSITY, s),
            current: vector(current, Dimension::VELOCITY, s),
            time: time.scaled(s),
            diameter: diameter.map(|x| number(x, Dimension::LENGTH, s)),
            area: area.map(|x| number(x, Dimension::AREA, s)),
            drag,
            added_mass,
        }
    }
}

impl TimeFunction {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
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
            // Text and function are the user's, in the user's time.
            Varying::Expression { text, unit } => {
                Varying::Expression { text, unit: number(unit, Dimension::RATE, s) }
            }
            Varying::External { name, unit, supplied } => {
                Varying::External { name, unit: number(unit, Dimension::RATE, s), supplied }
            }
        })
    }
}

impl Output {
    fn scaled(self, s: &Scales) -> Self {
        Self { interval: self.interval.map(|x| number(x, Dimension::TIME, s)), ..self }
    }
}

impl Analysis {
    fn scaled(self, s: &Scales) -> Self {
        // Load factors and counts have no units.
        let dynamics = match self {
            Self::Dynamics(dynamics) => dynamics,
            Self::Statics(_) | Self::Path(_) | Self::Modes(_) | Self::Buckling(_) => return self,
        };
        let Dynamics { duration, step, scheme, start, stop, newton, max_iterations, max_halvings } = dynamics;
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
            newton,
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
