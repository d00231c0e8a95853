//! Volumes that surfaces enclose, and the gas in them.

use ancf::mechanics::functions::Function;
use ancf::mechanics::shells::{ElementPatch, EnclosedVolume, GasPressure, ShellMesh};
use ancf::solver::equations::Term;
use nalgebra::Vector3;

use super::cases::TermCase;
use super::kind::TermKind;
use super::{shear_shells, shells};

fn volume(patch: ElementPatch, reversed: bool) -> Box<dyn Term> {
    match patch {
        ElementPatch::Thin(patch) => Box::new(EnclosedVolume::new(patch, reversed, 0)),
        ElementPatch::Triangle(patch) => Box::new(EnclosedVolume::new(patch, reversed, 0)),
        ElementPatch::Quad(patch) => Box::new(EnclosedVolume::new(patch, reversed, 0)),
    }
}

/// Parts of volumes with both directions of the normal, and gases with all kinds of exponents.
pub(super) fn gas_terms() -> impl Iterator<Item = TermCase> {
    let origin = Vector3::new(0.3, -0.4, -1.2);
    let thin = ShellMesh::new(0, [1, 1], Vector3::x(), shells::map, &shells::medium(false, [0.0; 2]));
    let faces = shear_shells::SHAPES.into_iter().map(move |(corners, shape)| {
        let mesh = shear_shells::mesh_of(corners, false, [0.0; 2]);
        (format!("volume at a {shape}"), ElementPatch::face(&mesh, 0, origin))
    });
    let patches = faces.chain([("volume at a thin shell".into(), ElementPatch::thin(&thin, 0, origin))]);
    let volumes = patches.flat_map(|(name, patch)| {
        [false, true].map(|reversed| TermCase {
            name: format!("{name}, reversed {reversed}"),
            term: volume(patch.clone(), reversed),
            // A cubic constraint has a third derivative of its own except without pressure.
            kind: TermKind::Smooth,
        })
    });
    let gases = [0.0, 1.0, 1.4].map(|exponent| {
        let amount = Function::Sine { frequency: 0.3, phase: 0.9 };
        TermCase {
            name: format!("gas of exponent {exponent}"),
            term: Box::new(GasPressure::new((0, 0), 1.3, [2.0, 0.7], exponent, amount)),
            kind: TermKind::Smooth,
        }
    });
    volumes.chain(gases)
}
