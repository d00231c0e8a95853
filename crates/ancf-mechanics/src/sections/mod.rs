//! Elasticity of cross-sections: rod laws and continuum laws integrated over the section.

mod deformation_factors;
mod hyperelastic;
mod rod_law;
mod section_law;
mod section_strains;

pub use deformation_factors::DeformationFactors;
pub use hyperelastic::{NeoHookean, SectionPoint};
pub use rod_law::{CrossSection, Moments};
pub(crate) use rod_law::{linked_strain_terms, local_strain, straight};
pub(crate) use section_law::{
    DIRECTORS, NO_STIFFNESS, PAIRS, STRAINS, SectionMatrix, Strains, add, all_rates, all_strains, sum,
};
pub use section_law::{Directors, Lame, SectionLaw, Stiffness};
pub(crate) use section_strains::{
    AA, AB, AC, AD, AE, AH, BB, BC, BD, BE, BK, CC, CD, CE, CK, DD, DE, DH, EE, EH, HH, KK,
};
