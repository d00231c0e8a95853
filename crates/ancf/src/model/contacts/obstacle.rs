use ancf_mechanics::contact::ObstacleShape;

use crate::model::bodies::Place;

/// A kind of obstacle that bodies touch.
///
/// The data of each kind implement this trait in a file of their own, and one line in `surface.rs` registers the kind.
pub trait ObstacleKind {
    /// Shape about the point and the axis.
    fn shape(&self) -> ObstacleShape;

    /// Point in the undeformed state: on a plane, centre of a sphere, on the axis of a cylinder.
    fn point(&self) -> [f64; 3];

    /// Axis or normal in the undeformed state, of any length, with its key; `None` if there is none.
    fn axis(&self) -> Option<(&'static str, [f64; 3])>;

    /// Place that carries the obstacle, if not the ground.
    fn on(&self) -> Option<&Place>;
}
