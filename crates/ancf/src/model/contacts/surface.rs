use std::sync::Arc;

use ancf_mechanics::bodies::BeamMesh;
use ancf_mechanics::contact::{BeamContacts, ContactLaw, Form, Obstacle, ObstacleContacts, Skin};
use ancf_mechanics::kinematics::Attachment;
use ancf_solver::equations::{Encounters, State};
use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::model::Model;
use crate::model::bodies::{Beam, Body, Place};
use crate::model::sections::Section;

/// What bodies may touch, and how hard and rough they are there. Bodies are round tubes about their axes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Contact {
    /// What the bodies may touch.
    pub with: Against,
    /// Names of the beams and cables; all but the one that carries an obstacle, by default.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub bodies: Vec<String>,
    /// Radius of the bodies, length; that of circles and tubes by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub radius: Option<f64>,
    /// Contact points of each element; by default so many that their distance suits the obstacle and the radius.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(range(min = 1, max = 10000))]
    pub points: Option<u32>,
    /// Force per length of a body and per depth, force/length².
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub stiffness: f64,
    /// Depth over which the stiffness grows from zero, length; a fiftieth of the smallest radius by default.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub transition: Option<f64>,
    /// Part by which the force is less at each speed of parting, and more when meeting, time/length.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub damping: f64,
    /// Coefficient of friction; none in statics.
    #[serde(default)]
    #[schemars(extend("minimum" = 0))]
    pub friction: f64,
    /// Sliding speed below which friction is viscous, length/time; by default a thousandth of the length of the longest body
    /// over the duration.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(extend("exclusiveMinimum" = 0))]
    pub slip_speed: Option<f64>,
}

/// What bodies may touch.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Against {
    /// The half space behind a plane.
    Plane {
        /// A point of it in the undeformed state, length.
        point: [f64; 3],
        /// Its normal in the undeformed state, towards the bodies; its length does not matter.
        normal: [f64; 3],
        /// What carries it; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// A ball, or a round hollow.
    Sphere {
        /// Its centre in the undeformed state, length.
        center: [f64; 3],
        /// Its radius, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
        /// Whether the bodies are inside.
        #[serde(default)]
        inside: bool,
        /// What carries it; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// An endless cylinder, or a bore.
    Cylinder {
        /// A point of its axis in the undeformed state, length.
        point: [f64; 3],
        /// Direction of its axis in the undeformed state; its length does not matter.
        axis: [f64; 3],
        /// Its radius, length.
        #[schemars(extend("exclusiveMinimum" = 0))]
        radius: f64,
        /// Whether the bodies are inside.
        #[serde(default)]
        inside: bool,
        /// What carries it; the ground by default.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        on: Option<Place>,
    },
    /// The bodies each other, and each itself.
    Bodies,
}

/// Depth of the transition as a part of the smallest radius.
const TRANSITION: f64 = 0.02;
/// Slip speed as a part of length over duration.
const SLIP: f64 = 1e-3;
/// Fewest points of an element, and most by default.
const POINTS: [f64; 2] = [4.0, 1e4];

impl Against {
    /// What carries an obstacle, if not the ground.
    pub const fn on(&self) -> Option<&Place> {
        match self {
            Self::Plane { on, .. } | Self::Sphere { on, .. } | Self::Cylinder { on, .. } => on.as_ref(),
            Self::Bodies => None,
        }
    }

    /// The form, the point and the axis of an obstacle.
    fn obstacle(&self) -> Option<(Form, Vector3<f64>, Vector3<f64>)> {
        Some(match *self {
            Self::Plane { point, normal, .. } => (Form::Plane, point.into(), normal.into()),
            Self::Sphere { center, radius, inside, .. } => {
                (Form::Sphere { radius, inside }, center.into(), Vector3::x())
            }
            Self::Cylinder { point, axis, radius, inside, .. } => {
                (Form::Cylinder { radius, inside }, point.into(), axis.into())
            }
            Self::Bodies => return None,
        })
    }
}

impl Section {
    /// The radius of a section that is round outside.
    pub(crate) const fn radius(&self) -> Option<f64> {
        match *self {
            Self::Circle { diameter: d } | Self::Tube { outer: d, .. } => Some(0.5 * d),
            _ => None,
        }
    }
}

impl Contact {
    /// Numbers of the bodies of a model that are meant.
    pub(crate) fn bodies(&self, model: &Model) -> Vec<usize> {
        let carrier = self.with.on().map(|place| place.body.as_str());
        let meant = |name: &str| match self.bodies.is_empty() {
            true => Some(name) != carrier,
            false => self.bodies.iter().any(|body| body == name),
        };
        (0..model.bodies.len())
            .filter(|&i| model.bodies[i].is_flexible() && meant(model.bodies[i].name()))
            .collect()
    }

    /// The radius of a body, if there is one: that of a section which is round and everywhere the same.
    pub(crate) fn radius(&self, model: &Model, body: &Body) -> Option<f64> {
        let tapered = matches!(body, Body::Beam(Beam { section_end: Some(_), .. }));
        let own = || model.sections.get(body.stuff()?.0).filter(|_| !tapered)?.radius();
        self.radius.or_else(own)
    }

    /// Points of each element of a length of a body of a radius.
    fn points(&self, length: f64, radius: f64) -> usize {
        let spacing = match self.with {
            Against::Plane { .. } => f64::INFINITY,
            Against::Sphere { radius: r, .. } | Against::Cylinder { radius: r, .. } => 0.25 * (r + radius),
            Against::Bodies => 0.5 * radius,
        };
        self.points.map_or_else(
            || (length / spacing).ceil().clamp(POINTS[0], POINTS[1]) as usize,
            |points| points as usize,
        )
    }

    /// The law of bodies of which the thinnest has a radius.
    fn law(&self, model: &Model, radius: f64) -> ContactLaw {
        let creep = model.analysis.dynamics().map_or(1.0, |d| SLIP * model.length() / d.duration);
        ContactLaw {
            stiffness: self.stiffness,
            transition: self.transition.unwrap_or(TRANSITION * radius),
            damping: self.damping,
            friction: self.friction,
            slip_speed: self.slip_speed.unwrap_or(creep),
        }
    }
}

impl Model {
    /// The contacts of a valid model; what overlaps in the state in which analyses begin is joined.
    pub(crate) fn encounters(
        &self,
        built: &[(String, ancf_mechanics::bodies::Body)],
        begin: &State,
    ) -> Vec<Arc<dyn Encounters>> {
        let of = |contact: &Contact| -> Option<Arc<dyn Encounters>> {
            let bodies = contact.bodies(self).into_iter();
            let sized: Vec<_> = bodies
                .filter_map(|i| Some((built[i].1.mesh()?, contact.radius(self, &self.bodies[i])?)))
                .collect();
            let thinnest = sized.iter().map(|(_, radius)| *radius).fold(f64::INFINITY, f64::min);
            let skin = |&(mesh, radius): &(&BeamMesh, f64)| {
                let length = mesh.length() / mesh.count() as f64;
                Skin::new(mesh, radius, contact.points(length, radius))
            };
            let (skins, law) = (sized.iter().map(skin).collect::<Vec<_>>(), contact.law(self, thinnest));
            let Some((form, point, axis)) = contact.with.obstacle() else {
                return Some(Arc::new(BeamContacts::new(skins, law).joined_in(begin)));
            };
            let place = contact.with.on().map_or_else(
                || Attachment::ground(point),
                |place| {
                    let held = self.attachment(built, place);
                    let arm = point - held.point.reference();
                    held.offset(arm)
                },
            );
            Some(Arc::new(ObstacleContacts::new(&Obstacle::new(form, place, axis)?, &skins, law)))
        };
        self.contacts.iter().filter_map(of).collect()
    }
}
