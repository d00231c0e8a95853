//! Elasticity of cross-sections: rod laws and continuum laws integrated over the section.

mod hyperelastic;
mod rod_law;
mod section_law;
mod section_strains;

pub use hyperelastic::{NeoHookean, SectionPoint};
pub use rod_law::{CrossSection, Moments};
pub(crate) use rod_law::{linking, local_strains, straight};
pub(crate) use section_law::{DIRECTORS, Form, NO_STIFFNESS, PAIRS, STRAINS, add, all_strains, sum};
pub use section_law::{Directors, Lame, SectionLaw, Stiffness};
pub(crate) use section_strains::{
    AA, AB, AC, AD, AE, BB, BC, BD, BE, BK, CC, CD, CE, CK, DD, DE, DH, EE, EH, HH,
};
