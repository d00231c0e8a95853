use super::graph::IndexLists;

/// Row of Φ_q in the reference configuration with columns scaled by M_cc^(−1/2), as pairs of coordinate and entry.
///
/// It contains all coordinates of its term, also with zero entries. It is empty if the reference configuration does not
/// determine the row.
pub(crate) type ConstraintRow = Vec<(u32, f64)>;

/// Smallest part of a row that is independent of the other rows carried by a group, relative to the part in the group.
const INDEPENDENT: f64 = 0.1;
/// Smallest part of a row in its group, relative to its part in later groups. The backward error grows by the inverse.
const DOMINANT: f64 = 1e-3;
/// Part below which a row is redundant in its last group.
const REDUNDANT: f64 = 1e-8;

/// Finds for each multiplier the first group of coordinates that can carry it. Returns the place of its last coordinate in
/// this group, or `None` if the row is empty.
///
/// The Schur complement of a multiplier is negative definite if the rows eliminated so far have full rank on the eliminated
/// coordinates. The rank is that of a Gaussian elimination of Φ_q along the order. At each group, rows are made orthogonal
/// to those that the group carries. A row is carried if the remainder dominates its part in later groups. Coordinates of the
/// group then become functions of later coordinates, with coefficients of limited size. Other rows lose their part in
/// the group and continue in the next one. Rows without later coordinates come first, since they have no other place.
///
/// Groups of multipliers with empty rows carry only rows without later coordinates.
///
/// Source: Benzi, Golub & Liesen (2005), section 3, for the rank conditions of block factorisations.
pub(super) fn carried_places(
    groups: &IndexLists,
    place: &[Option<u32>],
    blocks: &IndexLists,
    rows: &[ConstraintRow],
) -> Vec<Option<u32>> {
    let mut group_of = Vec::with_capacity(place.len());
    groups.iter().zip(0..).for_each(|(group, g)| group_of.extend(group.iter().map(|_| g)));
    let group_at = |place: u32| group_of[place as usize] as usize;
    let mut waiting: Vec<Vec<OpenRow>> = (0..groups.len()).map(|_| Vec::new()).collect();
    let mut places = vec![None; rows.len()];
    if rows.iter().all(Vec::is_empty) {
        return places;
    }
    for (multiplier, row) in rows.iter().enumerate() {
        let entries = row.iter().filter_map(|&(c, entry)| Some((place[c as usize]?, entry)));
        let mut entries: Vec<_> = entries.collect();
        entries.sort_unstable_by_key(|&(place, _)| place);
        if let Some(&(first, _)) = entries.first() {
            waiting[group_at(first)].push(OpenRow { multiplier, entries });
        }
    }
    let is_reserved = reserved(place, blocks, rows, &group_of, groups.len());
    let mut end = 0;
    for g in 0..groups.len() {
        let start = end;
        end += groups[g].len() as u32;
        let mut here = std::mem::take(&mut waiting[g]);
        here.sort_by_key(|row| (row.last() >= end, row.multiplier));
        let mut carrier = Carrier { start, end, is_reserved: is_reserved[g], pivots: Vec::new() };
        for row in carrier.carry(here, &mut places) {
            waiting[group_at(row.entries[0].0)].push(row);
        }
    }
    places
}

/// Finds the groups with coordinates of multipliers whose rows are empty.
fn reserved(
    place: &[Option<u32>],
    blocks: &IndexLists,
    rows: &[ConstraintRow],
    group_of: &[u32],
    groups: usize,
) -> Vec<bool> {
    let mut reserved = vec![false; groups];
    let multiplier = |u: u32| (u as usize).checked_sub(place.len());
    let is_open = |block: &&[u32]| block.iter().filter_map(|&u| multiplier(u)).any(|m| rows[m].is_empty());
    let coordinates = blocks.iter().filter(is_open).flatten().filter_map(|&u| *place.get(u as usize)?);
    coordinates.for_each(|place| reserved[group_of[place as usize] as usize] = true);
    reserved
}

/// Row without a place so far: entries by place in ascending order, from the current group on.
struct OpenRow {
    multiplier: usize,
    entries: Vec<(u32, f64)>,
}

impl OpenRow {
    fn last(&self) -> u32 {
        self.entries.last().map_or(0, |&(place, _)| place)
    }
}

/// Row at a group: its part in the group, dense, and the part in later groups.
struct SplitRow {
    own: Vec<f64>,
    later: Vec<(u32, f64)>,
}

impl SplitRow {
    /// Makes the part in the group orthogonal to pivots.
    fn subtract(&mut self, pivots: &[Self]) {
        for pivot in pivots {
            let factor: f64 = self.own.iter().zip(&pivot.own).map(|(x, y)| x * y).sum();
            if factor != 0.0 {
                self.own.iter_mut().zip(&pivot.own).for_each(|(x, y)| *x -= factor * y);
                self.later = difference(&self.later, factor, &pivot.later);
            }
        }
    }

    /// Scales the part in the group to length one.
    fn scaled(mut self, length: f64) -> Self {
        self.own.iter_mut().for_each(|x| *x /= length);
        self.later.iter_mut().for_each(|(_, x)| *x /= length);
        self
    }
}

/// Computes x − s y of sparse vectors in ascending order.
fn difference(x: &[(u32, f64)], s: f64, y: &[(u32, f64)]) -> Vec<(u32, f64)> {
    let mut sum = Vec::with_capacity(x.len() + y.len());
    let (mut x, mut y) = (x.iter().copied().peekable(), y.iter().map(|&(at, y)| (at, -s * y)).peekable());
    loop {
        match (x.peek().copied(), y.peek().copied()) {
            (Some((i, a)), Some((j, b))) => {
                if i <= j {
                    x.next();
                }
                if j <= i {
                    y.next();
                }
                sum.push((i.min(j), if i <= j { a } else { 0.0 } + if j <= i { b } else { 0.0 }));
            }
            (None, None) => return sum,
            _ => sum.extend(x.by_ref().chain(y.by_ref())),
        }
    }
}

fn length(x: impl Iterator<Item = f64>) -> f64 {
    x.map(|x| x * x).sum::<f64>().sqrt()
}

/// Group of coordinates with the rows that it carries.
struct Carrier {
    /// First place, and the place after the last one.
    start: u32,
    end: u32,
    is_reserved: bool,
    /// Rows that the group carries: orthonormal in the group.
    pivots: Vec<SplitRow>,
}

impl Carrier {
    /// Carries rows as far as possible. Returns the other rows without their part in the group.
    fn carry(&mut self, rows: Vec<OpenRow>, places: &mut [Option<u32>]) -> Vec<OpenRow> {
        let mut open = Vec::new();
        for OpenRow { multiplier, entries } in rows {
            let (inside, later) = entries.split_at(entries.partition_point(|&(place, _)| place < self.end));
            let mut own = vec![0.0; (self.end - self.start) as usize];
            inside.iter().for_each(|&(place, entry)| own[(place - self.start) as usize] = entry);
            let mut row = SplitRow { own, later: later.to_vec() };
            let whole = length(row.own.iter().copied());
            row.subtract(&self.pivots);
            let (rest, is_last) = (length(row.own.iter().copied()), later.is_empty());
            let dominates = rest >= DOMINANT * length(row.later.iter().map(|&(_, x)| x));
            let is_carried = !self.is_reserved && dominates && rest > INDEPENDENT * whole;
            if is_last || is_carried {
                places[multiplier] = inside.last().map(|&(place, _)| place);
                if rest > REDUNDANT * whole {
                    self.pivots.push(row.scaled(rest));
                }
            } else {
                open.push((multiplier, row));
            }
        }
        let remainder = |(multiplier, mut row): (usize, SplitRow)| {
            row.subtract(&self.pivots);
            OpenRow { multiplier, entries: row.later }
        };
        open.into_iter().map(remainder).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Places of rows over coordinates in natural order.
    fn places(groups: &[&[u32]], rows: &[&[(u32, f64)]]) -> Vec<Option<u32>> {
        let groups: IndexLists = groups.iter().map(|group| group.to_vec()).collect();
        let coordinates = groups.iter().flatten().count() as u32;
        let place: Vec<_> = (0..coordinates).map(Some).collect();
        let blocks = rows.iter().zip(coordinates..);
        let blocks: IndexLists =
            blocks.map(|(row, m)| row.iter().map(|&(c, _)| c).chain([m]).collect::<Vec<_>>()).collect();
        let rows: Vec<ConstraintRow> = rows.iter().map(|row| row.to_vec()).collect();
        carried_places(&groups, &place, &blocks, &rows)
    }

    /// The first coordinate with enough weight carries a row; a support of this coordinate takes precedence.
    #[test]
    fn first_coordinate_that_dominates() {
        let [a, b, c]: [&[u32]; 3] = [&[0], &[1], &[2]];
        let link: &[(u32, f64)] = &[(0, 1.0), (1, -1.0)];
        assert_eq!(places(&[a, b], &[link]), [Some(0)]);
        assert_eq!(places(&[a, b], &[&[(0, 1e-4), (1, 1.0)]]), [Some(1)]);
        assert_eq!(places(&[a, b], &[&[(0, 0.0), (1, 1.0)]]), [Some(1)]);
        assert_eq!(places(&[a, b], &[link, &[(0, 1.0)]]), [Some(1), Some(0)]);
        assert_eq!(places(&[a, b, c], &[link, &[(0, 1.0), (2, 1.0)]]), [Some(0), Some(1)]);
    }

    /// After x₀ = −x₁, the row of x₀ + x₁ + x₂ vanishes in the group of x₁.
    #[test]
    fn rows_are_reduced_by_earlier_rows() {
        let rows: [&[(u32, f64)]; 2] = [&[(0, 1.0), (1, 1.0)], &[(0, 1.0), (1, 1.0), (2, 1.0)]];
        assert_eq!(places(&[&[0], &[1], &[2]], &rows), [Some(0), Some(2)]);
        assert_eq!(places(&[&[0, 1], &[2]], &rows), [Some(1), Some(2)]);
    }

    /// Redundant rows have the place of their last coordinate. Groups of undetermined rows carry no row with later
    /// coordinates.
    #[test]
    fn redundant_and_undetermined_rows() {
        let link: &[(u32, f64)] = &[(0, 1.0), (1, -1.0)];
        assert_eq!(places(&[&[0], &[1]], &[link, link]), [Some(0), Some(1)]);
        let groups: IndexLists = [vec![0], vec![1]].into_iter().collect();
        let blocks: IndexLists = [vec![0, 1, 2], vec![0, 3]].into_iter().collect();
        let rows = [link.to_vec(), Vec::new()];
        assert_eq!(carried_places(&groups, &[Some(0), Some(1)], &blocks, &rows), [Some(1), None]);
    }
}
