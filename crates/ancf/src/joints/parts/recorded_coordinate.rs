use ancf_mechanics::constraints::BilinearMeasure;
use ancf_mechanics::kinematics::BodyVector;
use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::coupling::JointCoordinate;
use crate::units::Dimension;

/// Angle, displacement, arc length or distance that a joint records.
#[derive(Clone, Debug)]
pub struct RecordedCoordinate {
    pub(crate) source: Source,
    /// Its coordinate in the equations, if it is driven, coupled or has a spring or friction.
    pub(crate) coordinate: Option<usize>,
}

/// Computation of the value from a state.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// Angle of the vector p of the first end in the plane of u and v of the second end.
    Angle([BodyVector; 3]),
    /// Displacement along an axis.
    Displacement(BilinearMeasure),
    /// Arc length along a beam, with its initial value.
    Position(f64),
    /// Distance of the two points.
    Length(BodyVector),
}

impl RecordedCoordinate {
    /// Names of value and rate.
    pub const fn columns(&self) -> [&'static str; 2] {
        match self.source {
            Source::Angle(_) => ["angle", "rate"],
            Source::Displacement(_) => ["displacement", "speed"],
            Source::Position(_) => ["position", "speed"],
            Source::Length(_) => ["length", "speed"],
        }
    }

    /// Dimensions of value and rate.
    pub const fn dimensions(&self) -> [Dimension; 2] {
        match self.source {
            Source::Angle(_) => [Dimension::NUMBER, Dimension::RATE],
            _ => [Dimension::LENGTH, Dimension::VELOCITY],
        }
    }

    /// True if the value is an angle in the range from −π to π.
    pub const fn wraps(&self) -> bool {
        matches!(self.source, Source::Angle(_)) && self.coordinate.is_none()
    }

    /// Value and rate in a state.
    pub fn at(&self, s: &State) -> [f64; 2] {
        let own = self.coordinate.map_or([0.0; 2], |c| [s.q[c], s.v[c]]);
        match &self.source {
            Source::Position(start) => [start + own[0], own[1]],
            Source::Angle(_) | Source::Displacement(_) if self.coordinate.is_some() => own,
            Source::Angle(vectors) => {
                let [p, u, v] = vectors.each_ref().map(|vector| vector.value(s));
                let [dp, du, dv] = vectors.each_ref().map(|vector| vector.velocity(s));
                let (x, y) = (p.dot(&u), p.dot(&v));
                let (dx, dy) = (dp.dot(&u) + p.dot(&du), dp.dot(&v) + p.dot(&dv));
                [y.atan2(x), (x * dy - y * dx) / (x * x + y * y)]
            }
            Source::Displacement(measure) => [measure.value(s) - measure.reference(), measure.rate(s)],
            Source::Length(apart) => {
                let (d, rate): (Vector3<f64>, _) = (apart.value(s), apart.velocity(s));
                let length = d.norm();
                [length, d.dot(&rate) / length]
            }
        }
    }

    /// Number of the coordinate in the equations, if it is the stated free coordinate of the joint.
    pub(crate) fn coupled(&self, free: JointCoordinate) -> Option<usize> {
        let fits = match self.source {
            Source::Angle(_) => free == JointCoordinate::Angle,
            Source::Displacement(_) | Source::Position(_) => free == JointCoordinate::Displacement,
            Source::Length(_) => false,
        };
        self.coordinate.filter(|_| fits)
    }
}
