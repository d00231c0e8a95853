use ancf_mechanics::constraints::BilinearMeasure;
use ancf_mechanics::kinematics::Marker;
use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::coupling::Freed;
use crate::units::Dimension;

/// Recorded coordinate of a joint: an angle, a displacement, an arc length or a distance.
#[derive(Clone, Debug)]
pub struct JointCoordinate {
    pub(crate) source: Source,
    /// Index of the coordinate in the state, if a drive, coupling, spring or friction acts on it.
    pub(crate) coordinate: Option<usize>,
}

/// Source of the value.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// p of the first end, and u, v of the other.
    Angle([Marker; 3]),
    Displacement(BilinearMeasure),
    /// Arc length on a beam at the start of the motion.
    Position(f64),
    Length(Marker),
}

impl JointCoordinate {
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

    /// True if the value is an angle modulo 2π.
    pub const fn wraps(&self) -> bool {
        matches!(self.source, Source::Angle(_)) && self.coordinate.is_none()
    }

    /// Value and rate in a state.
    pub fn at(&self, s: &State) -> [f64; 2] {
        let own = self.coordinate.map_or([0.0; 2], |c| [s.q[c], s.v[c]]);
        match &self.source {
            Source::Position(start) => [start + own[0], own[1]],
            Source::Angle(_) | Source::Displacement(_) if self.coordinate.is_some() => own,
            Source::Angle(markers) => {
                let [p, u, v] = markers.each_ref().map(|marker| marker.value(s));
                let [dp, du, dv] = markers.each_ref().map(|marker| marker.sum(&s.v));
                let (x, y) = (p.dot(&u), p.dot(&v));
                let (dx, dy) = (dp.dot(&u) + p.dot(&du), dp.dot(&v) + p.dot(&dv));
                [y.atan2(x), (x * dy - y * dx) / (x * x + y * y)]
            }
            Source::Displacement(measure) => [measure.value(s) - measure.reference(), measure.rate(s)],
            Source::Length(apart) => {
                let (d, rate): (Vector3<f64>, _) = (apart.value(s), apart.sum(&s.v));
                let length = d.norm();
                [length, d.dot(&rate) / length]
            }
        }
    }

    /// The coordinate of this joint coordinate, for couplings.
    pub(crate) fn coupled(&self, freed: Freed) -> Option<usize> {
        let fits = match self.source {
            Source::Angle(_) => freed == Freed::Angle,
            Source::Displacement(_) | Source::Position(_) => freed == Freed::Displacement,
            Source::Length(_) => false,
        };
        self.coordinate.filter(|_| fits)
    }
}
