use std::f64::consts::TAU;

use nalgebra::Vector3;

use super::tridiagonal::{TridiagonalRow, solve_tridiagonal};
use crate::kinematics::quadrature::gauss;

/// Point of a reference axis with the orthonormal directions of x (the tangent), y and z.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ReferenceNode {
    /// Position.
    pub position: Vector3<f64>,
    /// Directions of the axis and of the y and z axes of the section.
    pub frame: [Vector3<f64>; 3],
}

/// Reference axis of a beam, parameterised by arc length.
#[derive(Clone, Debug, PartialEq)]
pub enum ReferenceCurve {
    /// Straight line.
    Line {
        /// Start.
        from: Vector3<f64>,
        /// End.
        to: Vector3<f64>,
    },
    /// Helix, or circular arc for zero rise.
    Helix {
        /// Point of the helix axis at the height of the start.
        center: Vector3<f64>,
        /// Vector from the centre to the start.
        radius: Vector3<f64>,
        /// Unit vector of the axis. The helix rotates about it by the right-hand rule.
        axis: Vector3<f64>,
        /// Total angle in radians.
        angle: f64,
        /// Total rise along the axis.
        rise: f64,
    },
    /// Natural cubic spline through points, parameterised by chord length.
    Spline(Spline),
}

impl ReferenceCurve {
    /// Creates the circular arc through three points. Returns `None` for collinear points.
    pub fn arc(from: Vector3<f64>, through: Vector3<f64>, to: Vector3<f64>) -> Option<Self> {
        let (u, v) = (through - from, to - from);
        let normal = u.cross(&v);
        let axis = normal.try_normalize(1e-12 * u.norm() * v.norm())?;
        let to_center =
            (v * u.norm_squared() - u * v.norm_squared()).cross(&normal) / (2.0 * normal.norm_squared());
        let radius = -to_center;
        let end = radius + v;
        let angle = axis.dot(&radius.cross(&end)).atan2(radius.dot(&end)).rem_euclid(TAU);
        Some(Self::Helix { center: from + to_center, radius, axis, angle, rise: 0.0 })
    }

    /// Returns the length.
    pub fn length(&self) -> f64 {
        match self {
            Self::Line { from, to } => (to - from).norm(),
            Self::Helix { radius, angle, rise, .. } => (angle * radius.norm()).hypot(*rise),
            Self::Spline(spline) => spline.length(),
        }
    }

    /// Returns point and unit tangent at an arc length.
    pub fn at(&self, s: f64) -> (Vector3<f64>, Vector3<f64>) {
        match self {
            Self::Line { from, to } => {
                let along = (to - from).normalize();
                (from + along * s, along)
            }
            Self::Helix { center, radius, axis, angle, rise } => {
                let part = s / self.length();
                let (sin, cos) = (angle * part).sin_cos();
                let normal = axis.cross(radius);
                let point = center + radius * cos + normal * sin + axis * (rise * part);
                (point, ((normal * cos - radius * sin) * *angle + axis * *rise).normalize())
            }
            Self::Spline(spline) => spline.at(s),
        }
    }

    /// Transports a normal vector between two near arc lengths without rotation about the tangent.
    pub fn carried(&self, y: Vector3<f64>, from: f64, to: f64) -> Vector3<f64> {
        if from == to { y } else { transported(y, self.at(from), self.at(to)) }
    }

    /// Creates nodes at ascending arc lengths.
    ///
    /// The y axis of the first section is as close as possible to `up`. It is transported without rotation about the
    /// tangent, plus a uniform twist of `twist` radians in total.
    ///
    /// Source: Wang, Jüttler, Zheng & Liu (2008), double reflection, for the frames without twist.
    pub fn nodes(&self, up: Vector3<f64>, twist: f64, at: &[f64]) -> Vec<ReferenceNode> {
        let mut here = 0.0;
        let (mut point, mut tangent) = self.at(0.0);
        let mut y = (up - tangent * tangent.dot(&up)).normalize();
        let straight = matches!(self, Self::Line { .. });
        let nodes = at.iter().map(|&s| {
            let steps = if straight || s <= here { 1 } else { SUBSTEPS };
            for step in 1..=steps {
                let (next, next_tangent) = self.at(here + (s - here) * f64::from(step) / f64::from(steps));
                if !straight {
                    y = transported(y, (point, tangent), (next, next_tangent));
                }
                (point, tangent) = (next, next_tangent);
            }
            here = s;
            let (sin, cos) = (twist * s / self.length()).sin_cos();
            let z = tangent.cross(&y);
            let frame =
                if twist == 0.0 { [tangent, y, z] } else { [tangent, y * cos + z * sin, z * cos - y * sin] };
            ReferenceNode { position: point, frame }
        });
        nodes.collect()
    }
}

/// Number of reflections between two nodes.
const SUBSTEPS: u32 = 16;

/// Transports a normal vector between two points of a curve by two reflections.
fn transported(
    y: Vector3<f64>,
    (point, tangent): (Vector3<f64>, Vector3<f64>),
    (next, next_tangent): (Vector3<f64>, Vector3<f64>),
) -> Vector3<f64> {
    let reflected = |x: Vector3<f64>, normal: Vector3<f64>| match normal.norm_squared() {
        0.0 => x,
        squared => x - normal * (2.0 * normal.dot(&x) / squared),
    };
    let chord = next - point;
    let (y, turned) = (reflected(y, chord), reflected(tangent, chord));
    let y = reflected(y, next_tangent - turned);
    // Removes accumulated rounding errors of direction and length.
    (y - next_tangent * next_tangent.dot(&y)).normalize()
}

/// Natural cubic spline.
#[derive(Clone, Debug, PartialEq)]
pub struct Spline {
    points: Vec<Vector3<f64>>,
    /// Second derivatives at the points.
    second_derivatives: Vec<Vector3<f64>>,
    /// Chord lengths between the points.
    chords: Vec<f64>,
    /// Arc length at the ends of equal parts of the chords, [`PARTS`] per chord.
    arcs: Vec<f64>,
}

/// Number of parts per chord in the table of arc lengths.
const PARTS: usize = 32;

impl Spline {
    /// Creates the spline through at least two points, with distinct neighbours.
    ///
    /// Returns `None` for fewer points or equal neighbours.
    pub fn new(points: Vec<Vector3<f64>>) -> Option<Self> {
        let chords: Vec<f64> = points.windows(2).map(|pair| (pair[1] - pair[0]).norm()).collect();
        if chords.is_empty() || chords.iter().any(|chord| !chord.is_normal()) {
            return None;
        }
        // No curvature at the ends.
        let end = TridiagonalRow { lower: 0.0, diagonal: 1.0, upper: 0.0, right: Vector3::zeros() };
        let inner = (1..points.len() - 1).map(|i| {
            let (before, after) = (chords[i - 1], chords[i]);
            let bend = (points[i + 1] - points[i]) / after - (points[i] - points[i - 1]) / before;
            TridiagonalRow {
                lower: before,
                diagonal: 2.0 * (before + after),
                upper: after,
                right: bend * 6.0,
            }
        });
        let second_derivatives = solve_tridiagonal([end].into_iter().chain(inner).chain([end]).collect());
        let mut spline = Self { points, second_derivatives, chords, arcs: vec![0.0] };
        for i in 0..spline.chords.len() {
            for part in 0..PARTS {
                let width = spline.chords[i] / PARTS as f64;
                let speed = |x: f64| spline.derivative(i, (part as f64 + x) * width).norm();
                let arc: f64 = gauss().iter().map(|&(x, w)| w * width * speed(x)).sum();
                spline.arcs.push(spline.arcs[spline.arcs.len() - 1] + arc);
            }
        }
        Some(spline)
    }

    /// Returns the length.
    pub fn length(&self) -> f64 {
        self.arcs[self.arcs.len() - 1]
    }

    /// Returns point and unit tangent at an arc length.
    fn at(&self, s: f64) -> (Vector3<f64>, Vector3<f64>) {
        let part = self.arcs.partition_point(|&arc| arc <= s).clamp(1, self.arcs.len() - 1) - 1;
        let (i, width) = (part / PARTS, self.chords[part / PARTS] / PARTS as f64);
        let start = (part % PARTS) as f64 * width;
        // Newton's method for the arc length, started on the chord of the table.
        let mut t = start + width * (s - self.arcs[part]) / (self.arcs[part + 1] - self.arcs[part]);
        for _ in 0..3 {
            let speed = |x: f64| self.derivative(i, start + (t - start) * x).norm();
            let arc: f64 = gauss().iter().map(|&(x, w)| w * (t - start) * speed(x)).sum();
            t -= (self.arcs[part] + arc - s) / self.derivative(i, t).norm();
        }
        (self.point(i, t), self.derivative(i, t).normalize())
    }

    /// Returns the point of chord i at the parameter t, which is 0 at its start.
    fn point(&self, i: usize, t: f64) -> Vector3<f64> {
        let (h, left) = (self.chords[i], self.chords[i] - t);
        let (m, n) = (self.second_derivatives[i], self.second_derivatives[i + 1]);
        (m * left.powi(3) + n * t.powi(3)) / (6.0 * h)
            + (self.points[i] / h - m * (h / 6.0)) * left
            + (self.points[i + 1] / h - n * (h / 6.0)) * t
    }

    fn derivative(&self, i: usize, t: f64) -> Vector3<f64> {
        let (h, left) = (self.chords[i], self.chords[i] - t);
        let (m, n) = (self.second_derivatives[i], self.second_derivatives[i + 1]);
        (n * t.powi(2) - m * left.powi(2)) / (2.0 * h) + (self.points[i + 1] - self.points[i]) / h
            - (n - m) * (h / 6.0)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn arc_through_three_points() {
        let (from, to) = (Vector3::zeros(), Vector3::new(70.71067811865476, 29.28932188134524, 0.0));
        let half = PI / 8.0;
        let through = Vector3::new(half.sin(), 1.0 - half.cos(), 0.0) * 100.0;
        let arc = ReferenceCurve::arc(from, through, to).unwrap();
        assert!((arc.length() - 25.0 * PI).abs() < 1e-12);
        assert!((arc.at(0.0).1 - Vector3::x()).norm() < 1e-14);
        assert!((arc.at(arc.length()).0 - to).norm() < 1e-13);
        assert!((arc.at(12.5 * PI).0 - through).norm() < 1e-13);
        assert_eq!(ReferenceCurve::arc(from, to * 0.5, to), None);
    }

    /// An arc longer than a semicircle follows the longer side.
    #[test]
    fn long_arc() {
        let arc = ReferenceCurve::arc(Vector3::x(), -Vector3::x(), -Vector3::y()).unwrap();
        assert!((arc.length() - 1.5 * PI).abs() < 1e-14);
    }

    /// On a helix, the frame without twist rotates relative to the Frenet frame by the torsion: τ s in total.
    #[test]
    fn frames_of_a_helix_do_not_spin() {
        let (radius, rise) = (2.0, 1.5);
        let helix = ReferenceCurve::Helix {
            center: Vector3::zeros(),
            radius: Vector3::x() * radius,
            axis: Vector3::z(),
            angle: TAU,
            rise,
        };
        let (length, pitch) = (helix.length(), rise / TAU);
        let torsion = pitch / (radius * radius + pitch * pitch);
        let at: Vec<f64> = (0..=8).map(|k| length * f64::from(k) / 8.0).collect();
        let nodes = helix.nodes(-Vector3::x(), 0.0, &at);
        let last = nodes[8].frame;
        // After one turn the principal normal is −x again.
        let angle = (-Vector3::x()).dot(&last[2]).atan2((-Vector3::x()).dot(&last[1]));
        assert!((angle - (torsion * length).rem_euclid(TAU)).abs() < 1e-5, "{angle}");
        for ReferenceNode { frame: [x, y, z], .. } in nodes {
            assert!((x.cross(&y) - z).norm() < 1e-14 && x.dot(&y).abs() < 1e-14);
        }
    }

    #[test]
    fn spline_goes_through_its_points_at_unit_speed() {
        let points = [[0.0, 0.0, 0.0], [1.0, 0.5, 0.0], [2.0, 0.0, 1.0], [3.5, 0.2, 0.3]].map(Vector3::from);
        let spline = Spline::new(points.to_vec()).unwrap();
        for (i, point) in points.iter().enumerate() {
            assert!((spline.at(spline.arcs[PARTS * i]).0 - point).norm() < 1e-12);
        }
        let curve = ReferenceCurve::Spline(spline);
        for k in 1..20 {
            let (s, h) = (curve.length() * f64::from(k) / 20.0, 1e-4);
            let slope = (curve.at(s + h).0 - curve.at(s - h).0) / (2.0 * h);
            assert!((slope - curve.at(s).1).norm() < 1e-7);
        }
    }

    #[test]
    fn twist_is_in_proportion_to_the_length() {
        let line = ReferenceCurve::Line { from: Vector3::zeros(), to: Vector3::x() * 2.0 };
        let nodes = line.nodes(Vector3::y(), PI, &[0.0, 1.0, 2.0]);
        assert!((nodes[1].frame[1] - Vector3::z()).norm() < 1e-15);
        assert!((nodes[2].frame[1] + Vector3::y()).norm() < 1e-15);
    }
}
