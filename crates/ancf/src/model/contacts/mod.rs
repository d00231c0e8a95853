//! Contact pairs of a model.
//!
//! One file a kind of obstacle, and one line each in `surface.rs`. A kind implements [`ObstacleKind`].

mod contact;
mod cylinder;
mod obstacle;
mod plane;
mod sphere;
mod surface;

pub use contact::Contact;
pub use cylinder::Cylinder;
pub use obstacle::ObstacleKind;
pub use plane::Plane;
pub use sphere::Sphere;
pub use surface::ContactSurface;
