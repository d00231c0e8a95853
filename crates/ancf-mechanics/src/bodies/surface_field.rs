use ancf_solver::equations::State;

use super::body_terms::BodyTerms;
use super::shell_place::ShellPlace;
use crate::shells::{ShearStressField, StressField, SurfaceStress};

/// Stresses of a shell of either kind in a state, for evaluation at many points.
#[derive(Clone, Debug)]
pub enum SurfaceField<'a> {
    /// Thin shell.
    Thin(StressField<'a>),
    /// Shear-deformable shell.
    Shear(ShearStressField<'a>),
}

impl<'a> SurfaceField<'a> {
    /// Evaluates the strains of a shell in a state; `None` for other bodies.
    pub fn new(body: &'a BodyTerms, s: &State) -> Option<Self> {
        match body {
            BodyTerms::Shell(mesh) => Some(Self::Thin(StressField::new(mesh, s))),
            BodyTerms::ShearShell(mesh) => Some(Self::Shear(ShearStressField::new(mesh, s))),
            BodyTerms::Flexible(_) | BodyTerms::Rigid(_) => None,
        }
    }

    /// Returns the stresses at a place; `None` for a place on the other kind of shell.
    pub fn at(&self, place: ShellPlace) -> Option<SurfaceStress> {
        match (self, place) {
            (Self::Thin(field), ShellPlace::Patch(at)) => Some(field.at(at)),
            (Self::Shear(field), ShellPlace::Element(place)) => Some(field.at(place)),
            _ => None,
        }
    }
}

impl BodyTerms {
    /// Returns the stresses of a shell at a place in a state; `None` for other bodies and places.
    pub fn surface_stress(&self, s: &State, place: ShellPlace) -> Option<SurfaceStress> {
        match (self, place) {
            (Self::Shell(mesh), ShellPlace::Patch(at)) => Some(mesh.stress(s, at)),
            (Self::ShearShell(mesh), ShellPlace::Element(place)) => Some(mesh.stress(s, place)),
            _ => None,
        }
    }
}
