//! Data of a part of a file of VTK, common to all formats.

/// Part of a file with points of its own.
#[derive(Debug, Default)]
pub(super) struct VtkPiece {
    pub(super) points: Vec<f64>,
    /// Types and points of the cells.
    pub(super) cells: Vec<(u8, Vec<u64>)>,
    pub(super) of_points: Vec<Labels>,
    pub(super) of_cells: Vec<Labels>,
}

/// Returns the cells of polygons in the order of their data: points, lines, polygons, strips.
pub(super) fn polygon_cells([verts, lines, polys, strips]: [Vec<Vec<u64>>; 4]) -> Vec<(u8, Vec<u64>)> {
    let of = |(kind, lists): (u8, Vec<Vec<u64>>)| lists.into_iter().map(move |list| (kind, list));
    [(kinds::VERTICES, verts), (kinds::LINES, lines), (kinds::POLYGON, polys), (kinds::STRIP, strips)]
        .into_iter()
        .flat_map(of)
        .collect()
}

/// Returns the cells of a grid from their types and their points.
pub(super) fn grid_cells(
    types: impl ExactSizeIterator<Item = u8>,
    lists: Vec<Vec<u64>>,
) -> Result<Vec<(u8, Vec<u64>)>, String> {
    if lists.len() == types.len() {
        Ok(types.zip(lists).collect())
    } else {
        Err(format!("{} cells with {} types", lists.len(), types.len()))
    }
}

impl VtkPiece {
    /// Checks that the numbers of points, cells and labels fit together.
    pub(super) fn check(&self) -> Result<(), String> {
        let count = self.points.len() / 3;
        if self.points.len() != 3 * count {
            return Err(format!("{} coordinates of points", self.points.len()));
        }
        for (k, (_, points)) in self.cells.iter().enumerate() {
            if let Some(point) = points.iter().find(|point| **point >= count as u64) {
                return Err(format!("cell {k} with the point {point} of {count}"));
            }
        }
        for (labels, expected) in [(&self.of_points, count), (&self.of_cells, self.cells.len())] {
            if let Some((name, values)) = labels.iter().find(|(_, values)| values.len() != expected) {
                return Err(format!("the array \"{name}\" with {} numbers for {expected}", values.len()));
            }
        }
        Ok(())
    }
}

/// Array of integers with its name, one number for each point or cell.
pub(super) type Labels = (String, Vec<i64>);

/// Types of cells.
pub(super) mod kinds {
    pub(crate) const VERTEX: u8 = 1;
    pub(crate) const VERTICES: u8 = 2;
    pub(crate) const LINE: u8 = 3;
    pub(crate) const LINES: u8 = 4;
    pub(crate) const TRIANGLE: u8 = 5;
    pub(crate) const STRIP: u8 = 6;
    pub(crate) const POLYGON: u8 = 7;
    pub(crate) const PIXEL: u8 = 8;
    pub(crate) const QUADRILATERAL: u8 = 9;
}

/// Returns lists of points of cells from their ends. A first end of zero is that of no cell.
pub(super) fn lists(points: &[u64], ends: &[u64]) -> Result<Vec<Vec<u64>>, String> {
    let ends = if ends.first() == Some(&0) { &ends[1..] } else { ends };
    let (mut lists, mut start) = (Vec::with_capacity(ends.len()), 0);
    for end in ends.iter().map(|end| *end as usize) {
        lists.push(points.get(start..end).ok_or("offsets of cells that do not fit their points")?.to_vec());
        start = end;
    }
    if start != points.len() {
        return Err("offsets of cells that do not fit their points".into());
    }
    Ok(lists)
}
