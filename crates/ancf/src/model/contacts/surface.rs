use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cylinder::Cylinder;
use super::obstacle::ObstacleKind;
use super::plane::Plane;
use super::sphere::Sphere;
use crate::model::bodies::Place;
use crate::units::Scaled;

/// Declares the kinds of obstacles of model files: variant and data of each.
macro_rules! obstacles {
    ($($kind:ident,)*) => {
        /// Contact partner: an obstacle, or the bodies themselves.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
        #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
        #[expect(missing_docs, reason = "the data of each kind are documented")]
        pub enum ContactSurface {
            $($kind($kind),)*
            /// Contact of the bodies with each other and of each body with itself.
            Bodies,
        }

        impl ContactSurface {
            /// Obstacle as an implementation of its kind; `None` for the bodies themselves.
            pub fn obstacle(&self) -> Option<&dyn ObstacleKind> {
                match self {
                    $(Self::$kind(obstacle) => Some(obstacle),)*
                    Self::Bodies => None,
                }
            }
        }

        $(impl From<$kind> for ContactSurface {
            fn from(obstacle: $kind) -> Self {
                Self::$kind(obstacle)
            }
        })*
    };
}

obstacles! {
    Plane,
    Sphere,
    Cylinder,
}

impl ContactSurface {
    /// Place that carries an obstacle, if not the ground.
    pub fn on(&self) -> Option<&Place> {
        self.obstacle()?.on()
    }
}
