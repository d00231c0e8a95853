//! Polylines in pixels: clipping to a rectangle, decimation.

/// Point in pixels.
pub(crate) type Point = (f64, f64);
/// Left, top, right and bottom of a rectangle.
pub(crate) type Rect = [f64; 4];

/// Returns the parts of a polyline inside a rectangle (Liang and Barsky 1984). A single point counts as a line.
pub(crate) fn clip(points: &[Point], [left, top, right, bottom]: Rect) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    let lone = if let [p] = points { vec![*p, *p] } else { Vec::new() };
    for pair in points.windows(2).chain(lone.windows(2)) {
        let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for (a, d, low, high) in [(ax, bx - ax, left, right), (ay, by - ay, top, bottom)] {
            let (t0, t1) = ((low - a) / d, (high - a) / d);
            if d == 0.0 {
                to = if (low..=high).contains(&a) { to } else { -1.0 };
            } else {
                (from, to) = (from.max(t0.min(t1)), to.min(t0.max(t1)));
            }
        }
        if from > to {
            continue;
        }
        let at = |t: f64| (ax + t * (bx - ax), ay + t * (by - ay));
        match parts.last_mut() {
            Some(part) if from == 0.0 && part.last() == Some(&(ax, ay)) => part.push(at(to)),
            _ => parts.push(vec![at(from), at(to)]),
        }
    }
    parts
}

/// Returns a polyline with fewer points and the same appearance.
///
/// If the abscissas ascend, the first, lowest, highest and last point of every half pixel remain. Otherwise points remain that
/// are a third of a pixel apart. Of these, points on a straight line are dropped.
pub(crate) fn decimate(points: &[Point]) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    let mut keep = |p: Point| {
        if let [.., a, b] = kept[..] {
            let (dx, dy, bx, by) = (p.0 - a.0, p.1 - a.1, b.0 - a.0, b.1 - a.1);
            let (length, between) = (dx.hypot(dy), (0.0..=dx * dx + dy * dy).contains(&(dx * bx + dy * by)));
            if between && (dx * by - dy * bx).abs() <= 0.004 * length {
                kept.pop();
            }
        }
        kept.push(p);
    };
    let rising = points.is_sorted_by(|a, b| a.0 <= b.0);
    let cell = |p: &Point| {
        if rising { ((p.0 * 2.0).floor(), 0.0) } else { ((p.0 * 3.0).floor(), (p.1 * 3.0).floor()) }
    };
    for group in points.chunk_by(|a, b| cell(a) == cell(b)) {
        let by_height = |i: &usize, j: &usize| group[*i].1.total_cmp(&group[*j].1);
        let (low, high) = ((0..group.len()).min_by(by_height), (0..group.len()).max_by(by_height));
        let mut chosen = vec![0, low.unwrap_or(0), high.unwrap_or(0), group.len() - 1];
        chosen.sort_unstable();
        chosen.dedup();
        chosen.into_iter().for_each(|i| keep(group[i]));
    }
    kept
}
