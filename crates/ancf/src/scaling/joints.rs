//! Joints in other units.

use crate::joints::{End, Ground};
use crate::units::{Dimension, Scales, vector};

impl End {
    pub(crate) fn scaled(self, s: &Scales) -> Self {
        match self {
            Self::Ground => Self::Ground,
            Self::Place(place) => Self::Place(place.scaled(s)),
            Self::Point(Ground { point }) => {
                Self::Point(Ground { point: vector(point, Dimension::LENGTH, s) })
            }
        }
    }
}
