use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::base_acceleration::BaseAcceleration;
use super::base_rotation::BaseRotation;
use super::distributed_force::DistributedForce;
use super::distributed_moment::DistributedMoment;
use super::external::ExternalLoad;
use super::fluid::Fluid;
use super::parts::{CustomLoad, LoadKind};
use super::point_force::PointForce;
use super::point_moment::PointMoment;
use super::prestrain::Prestrain;
use super::surface::{
    EdgeForce, EdgeMoment, Gas, SurfaceFluid, SurfaceForce, SurfacePressure, SurfacePrestrain,
};
use crate::model::{Place, TimeFunction};
use crate::units::{Scaled, Scales};

/// Declares the kinds of loads of model files: variant and data of each.
macro_rules! load_kinds {
    ($($kind:ident($data:ident),)*) => {
        /// Load on bodies. Gravity is a key of the model.
        #[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema, Scaled)]
        #[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
        #[expect(missing_docs, reason = "the data of each kind are documented")]
        pub enum Load {
            $($kind($data),)*
            /// A load of a kind that a program adds; model files have none.
            #[serde(skip)]
            #[schemars(skip)]
            Custom(CustomLoad),
        }

        impl Load {
            /// The load as an implementation of its kind.
            pub fn kind(&self) -> &dyn LoadKind {
                match self {
                    $(Self::$kind(load) => load,)*
                    Self::Custom(load) => load.kind(),
                }
            }

            /// The load as a mutable implementation of its kind.
            pub(crate) fn kind_mut(&mut self) -> &mut dyn LoadKind {
                match self {
                    $(Self::$kind(load) => load,)*
                    Self::Custom(load) => load.kind_mut(),
                }
            }
        }

        $(impl From<$data> for Load {
            fn from(load: $data) -> Self {
                Self::$kind(load)
            }
        })*
    };
}

load_kinds! {
    Force(PointForce),
    Moment(PointMoment),
    DistributedForce(DistributedForce),
    DistributedMoment(DistributedMoment),
    EdgeForce(EdgeForce),
    EdgeMoment(EdgeMoment),
    SurfaceForce(SurfaceForce),
    SurfacePressure(SurfacePressure),
    Gas(Gas),
    SurfaceFluid(SurfaceFluid),
    BaseAcceleration(BaseAcceleration),
    BaseRotation(BaseRotation),
    Fluid(Fluid),
    Prestrain(Prestrain),
    SurfacePrestrain(SurfacePrestrain),
    External(ExternalLoad),
}

impl Load {
    /// Force of constant magnitude and direction.
    pub fn force(on: Place, force: [f64; 3]) -> Self {
        Self::Force(PointForce { on, force, follower: false, time: TimeFunction::default() })
    }

    /// Moment of constant magnitude and direction.
    pub fn moment(on: Place, moment: [f64; 3]) -> Self {
        Self::Moment(PointMoment { on, moment, follower: false, time: TimeFunction::default() })
    }

    /// Force by a function that the calling program supplies under a name.
    pub fn external(on: Place, name: &str) -> Self {
        Self::External(ExternalLoad { on, name: name.into(), units: Scales::UNIT, supplied: None })
    }

    /// Point of application of a concentrated load.
    pub fn on(&self) -> Option<&Place> {
        self.kind().on()
    }

    /// True for a load that rotates with the section or the rigid body.
    pub fn is_follower(&self) -> bool {
        self.kind().is_follower()
    }

    /// Function of time, if the load has one.
    pub fn time(&self) -> Option<&TimeFunction> {
        self.kind().time()
    }
}
