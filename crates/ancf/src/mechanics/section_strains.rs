//! Indices of the section strains: a, b, c, d, e, h are the vectors of the gradient, see `SectionLaw`.

pub(super) const AA: usize = 0;
pub(super) const BB: usize = 1;
pub(super) const CC: usize = 2;
pub(super) const DD: usize = 3;
pub(super) const EE: usize = 4;
pub(super) const HH: usize = 5;
pub(super) const AB: usize = 6;
pub(super) const AC: usize = 7;
pub(super) const BC: usize = 8;
pub(super) const AD: usize = 9;
pub(super) const BD: usize = 10;
pub(super) const CD: usize = 11;
pub(super) const AE: usize = 12;
pub(super) const BE: usize = 13;
pub(super) const CE: usize = 14;
pub(super) const DE: usize = 15;
pub(super) const DH: usize = 16;
pub(super) const EH: usize = 17;
pub(super) const BK: usize = 18;
pub(super) const CK: usize = 19;
