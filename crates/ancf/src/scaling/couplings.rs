//! Conversion of the factors of couplings to other units.

use crate::joints::{Coupled, Coupling, JointCoordinate};
use crate::model::{IndexedModel, Model};
use crate::units::{Dimension, Scales, number};

impl Model {
    /// Converts the couplings to other units. The unit of a factor depends on the coordinate of the joint.
    pub(crate) fn scaled_couplings(&self, s: &Scales) -> Vec<Coupling> {
        let index = IndexedModel::new(self);
        let part = |part: &Coupled| {
            let of = match index.coupled_coordinate(part) {
                Some((_, JointCoordinate::Displacement)) => Dimension::new(-1, 0, 0),
                _ => Dimension::NUMBER,
            };
            Coupled { factor: number(part.factor, of, s), ..part.clone() }
        };
        let joints = |coupling: &Coupling| coupling.joints.iter().map(part).collect();
        self.couplings.iter().map(|c| Coupling { name: c.name.clone(), joints: joints(c) }).collect()
    }
}
