//! Makes long polylines short without a visible change.

use std::fmt::Write as _;

use super::svg::{Point, Rect};

/// Deviation that no one sees, in CSS pixels.
const TOLERANCE: f64 = 0.04;
/// Width of the columns of which only the extremes are kept, in CSS pixels.
const COLUMN: f64 = 0.5;
/// Points above which a line is thinned ever more coarsely.
const ENOUGH: usize = 4000;

/// A polyline with fewer points that looks the same.
pub(super) fn thin(points: &[Point]) -> Vec<Point> {
    let rising = points.windows(2).all(|w| w[0].0 <= w[1].0);
    let mut points = if rising { column_extremes(points, COLUMN) } else { points.to_vec() };
    let mut tolerance = TOLERANCE;
    loop {
        points = simplify(&points, tolerance);
        if points.len() <= ENOUGH || tolerance > 2.0 {
            return points;
        }
        tolerance *= 2.0;
    }
}

/// Keeps the first, lowest, highest and last point of each pixel column, in order.
pub(super) fn column_extremes(points: &[Point], column: f64) -> Vec<Point> {
    let key = |p: &Point| (p.0 / column).floor() as i64;
    let mut kept = Vec::new();
    for group in points.chunk_by(|a, b| key(a) == key(b)) {
        let mut chosen = [0, 0, 0, group.len() - 1];
        for (i, p) in group.iter().enumerate() {
            if p.1 < group[chosen[1]].1 {
                chosen[1] = i;
            }
            if p.1 > group[chosen[2]].1 {
                chosen[2] = i;
            }
        }
        chosen.sort_unstable();
        let mut last = usize::MAX;
        for i in chosen {
            if i != last {
                kept.push(group[i]);
            }
            last = i;
        }
    }
    kept
}

/// Drops points that lie within `tolerance` of the line without them (Douglas and Peucker).
fn simplify(points: &[Point], tolerance: f64) -> Vec<Point> {
    if points.len() < 3 {
        return points.to_vec();
    }
    let mut keep = vec![false; points.len()];
    keep[0] = true;
    keep[points.len() - 1] = true;
    let mut open = vec![(0, points.len() - 1)];
    while let Some((from, to)) = open.pop() {
        let farthest = (from + 1..to)
            .map(|i| (i, distance(points[i], points[from], points[to])))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        if let Some((at, off)) = farthest
            && off > tolerance
        {
            keep[at] = true;
            open.push((from, at));
            open.push((at, to));
        }
    }
    let kept = points.iter().zip(&keep).filter(|(_, k)| **k);
    kept.map(|(p, _)| *p).collect()
}

/// Distance of a point from the segment between two others.
fn distance(p: Point, a: Point, b: Point) -> f64 {
    let (dx, dy) = (b.0 - a.0, b.1 - a.1);
    let square = dx * dx + dy * dy;
    let along =
        if square > 0.0 { (((p.0 - a.0) * dx + (p.1 - a.1) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    (p.0 - a.0 - along * dx).hypot(p.1 - a.1 - along * dy)
}

/// The parts of a polyline that lie within a rectangle.
pub(super) fn clip(points: &[Point], within: &Rect) -> Vec<Vec<Point>> {
    if let [only] = points {
        return if within.contains(*only) { vec![vec![*only, *only]] } else { Vec::new() };
    }
    let mut parts: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some((a, b)) = within.clip(pair[0], pair[1]) else {
            continue;
        };
        match parts.last_mut().filter(|part| part.last() == Some(&a)) {
            Some(part) => part.push(b),
            None => parts.push(vec![a, b]),
        }
    }
    parts
}

/// Path data of polylines, in steps of a hundredth of a pixel.
pub(super) fn path_data(parts: &[Vec<Point>]) -> String {
    let mut d = String::new();
    let hundredths = |v: f64| (v * 100.0).round() as i64;
    for part in parts {
        let mut at: Option<(i64, i64)> = None;
        for &(x, y) in part {
            let (x, y) = (hundredths(x), hundredths(y));
            match at {
                None => {
                    let _ = write!(d, "M{} {}", short(x), short(y));
                }
                Some((ax, ay)) => {
                    let (dx, dy) = (short(x - ax), short(y - ay));
                    let gap = if dy.starts_with('-') { "" } else { " " };
                    let _ = write!(d, "l{dx}{gap}{dy}");
                }
            }
            at = Some((x, y));
        }
    }
    d
}

/// A count of hundredths as the shortest decimal number.
fn short(hundredths: i64) -> String {
    let sign = if hundredths < 0 { "-" } else { "" };
    let (whole, part) = (hundredths.unsigned_abs() / 100, hundredths.unsigned_abs() % 100);
    let whole_text = if whole == 0 && part != 0 { String::new() } else { whole.to_string() };
    match (part, part % 10) {
        (0, _) => format!("{sign}{whole_text}"),
        (_, 0) => format!("{sign}{whole_text}.{}", part / 10),
        _ => format!("{sign}{whole_text}.{part:02}"),
    }
}
