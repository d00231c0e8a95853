//! Indices of the section strains. The letters a, b, c, d, e, h, k denote directors, see `SectionLaw`.

pub(crate) const AA: usize = 0;
pub(crate) const BB: usize = 1;
pub(crate) const CC: usize = 2;
pub(crate) const DD: usize = 3;
pub(crate) const EE: usize = 4;
pub(crate) const HH: usize = 5;
pub(crate) const KK: usize = 6;
pub(crate) const AB: usize = 7;
pub(crate) const AC: usize = 8;
pub(crate) const BC: usize = 9;
pub(crate) const AD: usize = 10;
pub(crate) const BD: usize = 11;
pub(crate) const CD: usize = 12;
pub(crate) const AE: usize = 13;
pub(crate) const BE: usize = 14;
pub(crate) const CE: usize = 15;
pub(crate) const DE: usize = 16;
pub(crate) const DH: usize = 17;
pub(crate) const EH: usize = 18;
pub(crate) const BK: usize = 19;
pub(crate) const CK: usize = 20;
pub(crate) const AH: usize = 21;
