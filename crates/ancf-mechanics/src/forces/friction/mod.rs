//! Dry friction of joints: of given magnitude along a measure, and by the reaction along the slip of a bearing.

mod bearing;
mod constant;
mod reaction_friction;
mod slip;

pub use bearing::Bearing;
pub use constant::Friction;
pub use reaction_friction::{FrictionLaw, ReactionFriction};
pub use slip::{Slip, TurnAxis};
