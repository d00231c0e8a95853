use ancf_mechanics::constraints::BilinearMeasure;
use ancf_mechanics::kinematics::{Attachment, BodyVector};
use ancf_mechanics::shells::GasPressure;
use ancf_solver::equations::State;
use nalgebra::Vector3;

use super::coupling::JointCoordinate;
use crate::units::{Dimension, UnitQuantity};

/// Angle, displacement, arc length or distance that a joint records, or volume and pressure of a gas.
#[derive(Clone, Debug)]
pub struct RecordedCoordinate {
    pub(crate) source: Source,
    /// Its coordinate in the equations, if it is driven, coupled or has a spring or friction.
    pub(crate) coordinate: Option<usize>,
}

/// Computation of the value from a state.
#[derive(Clone, Debug)]
pub(crate) enum Source {
    /// Angle of the vector p of the first end in the plane of u and v of the second end, and the attachments of both ends.
    Angle { vectors: [BodyVector; 3], ends: Box<[Attachment; 2]> },
    /// Angle of the projection of the vector p of the first end into the plane of u and v of the second end.
    Projection([BodyVector; 3]),
    /// Displacement along an axis.
    Displacement(BilinearMeasure),
    /// Arc length along a beam, with its initial value.
    Position(f64),
    /// Distance of the two points.
    Length(BodyVector),
    /// State of a force law, whose change is the rate of the coordinate: names of value and rate, the value at the start, and the unit
    /// of time measured in that of the law.
    State { columns: [String; 2], start: f64, time: f64 },
    /// Volume of a gas, and its pressure in place of a rate.
    Gas(GasPressure),
}

impl RecordedCoordinate {
    /// Names of value and rate.
    pub fn columns(&self) -> [&str; 2] {
        match &self.source {
            Source::Angle { .. } | Source::Projection(_) => ["angle", "rate"],
            Source::Displacement(_) => ["displacement", "speed"],
            Source::Position(_) => ["position", "speed"],
            Source::Length(_) => ["length", "speed"],
            Source::Gas(_) => ["volume", "pressure"],
            Source::State { columns: [value, rate], .. } => [value, rate],
        }
    }

    /// Dimensions of value and rate.
    pub const fn dimensions(&self) -> [Dimension; 2] {
        match self.source {
            Source::Angle { .. } | Source::Projection(_) | Source::State { .. } => {
                [Dimension::NUMBER, Dimension::RATE]
            }
            Source::Gas(_) => [Dimension::VOLUME, Dimension::STRESS],
            _ => [Dimension::LENGTH, Dimension::VELOCITY],
        }
    }

    /// Quantity of value and rate.
    pub const fn quantity(&self) -> UnitQuantity {
        match self.source {
            Source::Angle { .. } | Source::Projection(_) => UnitQuantity::Angle,
            _ => UnitQuantity::Other,
        }
    }

    /// Column of the value, for the name of its joint.
    pub(crate) fn column(&self, joint: &str) -> String {
        format!("{joint}.{}", self.columns()[0])
    }

    /// True if the value is an angle.
    pub(crate) const fn is_angle(&self) -> bool {
        matches!(self.source, Source::Angle { .. } | Source::Projection(_))
    }

    /// True if the value is an angle in the range from −π to π.
    pub const fn wraps(&self) -> bool {
        self.is_angle() && self.coordinate.is_none()
    }

    /// Value and rate in a state.
    pub fn at(&self, s: &State) -> [f64; 2] {
        let own = self.coordinate.map_or([0.0; 2], |c| [s.q[c], s.v[c]]);
        match &self.source {
            Source::Position(start) => [start + own[0], own[1]],
            Source::State { start, time, .. } => {
                [start + own[1] / time, self.coordinate.map_or(0.0, |c| s.a[c] / time)]
            }
            Source::Angle { .. } | Source::Projection(_) | Source::Displacement(_)
                if self.coordinate.is_some() =>
            {
                own
            }
            Source::Angle { vectors, ends } => {
                let [p, u, v] = vectors.each_ref().map(|vector| vector.value(s));
                // The rates of p, u and v violate the constraints of rigid bodies by the error of a step.
                let [of_a, of_b] = ends.each_ref().map(|end| end.spin(s).unwrap_or_default());
                [p.dot(&v).atan2(p.dot(&u)), u.cross(&v).dot(&(of_a - of_b))]
            }
            Source::Projection(vectors) => {
                let [p, u, v] = vectors.each_ref().map(|vector| vector.value(s));
                let [dp, du, dv] = vectors.each_ref().map(|vector| vector.velocity(s));
                let (cos, sin) = (p.dot(&u), p.dot(&v));
                let (dcos, dsin) = (dp.dot(&u) + p.dot(&du), dp.dot(&v) + p.dot(&dv));
                [sin.atan2(cos), (cos * dsin - sin * dcos) / (cos * cos + sin * sin)]
            }
            Source::Displacement(measure) => [measure.value(s) - measure.reference(), measure.rate(s)],
            Source::Length(apart) => {
                let (d, rate): (Vector3<f64>, _) = (apart.value(s), apart.velocity(s));
                let length = d.norm();
                [length, d.dot(&rate) / length]
            }
            Source::Gas(gas) => gas.volume_and_pressure(s),
        }
    }

    /// Number of the coordinate in the equations, if it is the stated free coordinate of the joint.
    pub(crate) fn coupled(&self, free: JointCoordinate) -> Option<usize> {
        let fits = match self.source {
            Source::Angle { .. } | Source::Projection(_) => free == JointCoordinate::Angle,
            Source::Displacement(_) | Source::Position(_) => free == JointCoordinate::Displacement,
            Source::Length(_) | Source::State { .. } | Source::Gas(_) => false,
        };
        self.coordinate.filter(|_| fits)
    }
}
