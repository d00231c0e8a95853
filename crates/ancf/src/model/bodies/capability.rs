/// Capability that a joint, a load or a probe requires of a body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Capability {
    /// Directions to constrain: all bodies but point masses.
    Direction,
    /// A section or a frame that rotates about any axis: beams and rigid bodies.
    Section,
    /// A section whose rotation is prescribed by a clamp: beams.
    DrivenSection,
    /// Section forces, strain and stress: beams and cables.
    Strain,
    /// Resultants and stresses of a surface: shells.
    Surface,
}
