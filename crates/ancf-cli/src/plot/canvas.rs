//! Raster of dots in the cells of a terminal.

/// Raster of dots in the cells of a terminal.
#[derive(Debug)]
pub struct DotCanvas {
    width: usize,
    height: usize,
    is_braille: bool,
    cells: Vec<DotCell>,
}

/// Dots of a cell, and the last curve in it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct DotCell {
    dots: u8,
    /// Index of the curve.
    pub curve: usize,
}

/// Markers of curves without colours.
pub const MARKERS: [char; 8] = ['*', '+', 'o', 'x', '#', '@', '%', '='];

/// Bits of the dots of a Braille character by row and column (Unicode, block "Braille Patterns").
const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

impl DotCanvas {
    /// Creates a raster of cells: eight dots each in Braille, otherwise one marker.
    pub fn new(width: usize, height: usize, is_braille: bool) -> Self {
        Self { width, height, is_braille, cells: vec![DotCell::default(); width * height] }
    }

    /// Returns the number of dots per cell, across and down.
    const fn density(&self) -> [usize; 2] {
        if self.is_braille { [2, 4] } else { [1, 1] }
    }

    /// Draws a straight line between two points of the unit square. The origin is at the lower left.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], curve: usize) {
        let ([x0, y0], [x1, y1]) = (self.dot(from), self.dot(to));
        let steps = (x1 - x0).abs().max((y1 - y0).abs()).max(1.0);
        for k in 0..=steps as usize {
            let part = k as f64 / steps;
            self.set(x0 + part * (x1 - x0), y0 + part * (y1 - y0), curve);
        }
    }

    /// Returns the dot of a point of the unit square.
    fn dot(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [across, down] = self.density();
        let most = [self.width * across - 1, self.height * down - 1].map(|most| most as f64);
        [x.clamp(0.0, 1.0) * most[0], (1.0 - y.clamp(0.0, 1.0)) * most[1]].map(f64::round)
    }

    fn set(&mut self, x: f64, y: f64, curve: usize) {
        let [across, down] = self.density();
        let (x, y) = (x.round() as usize, y.round() as usize);
        if let Some(cell) = self.cells.get_mut(y / down * self.width + x / across) {
            *cell = DotCell { dots: cell.dots | BITS[y % down][x % across], curve };
        }
    }

    /// Returns the cells of a row.
    pub fn row(&self, row: usize) -> &[DotCell] {
        &self.cells[row * self.width..(row + 1) * self.width]
    }

    /// Returns the character of a cell.
    pub fn character(&self, cell: DotCell) -> char {
        match cell.dots {
            0 => ' ',
            dots if self.is_braille => char::from_u32(0x2800 + u32::from(dots)).unwrap_or(' '),
            _ => MARKERS[cell.curve % MARKERS.len()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(canvas: &DotCanvas) -> Vec<String> {
        (0..canvas.height)
            .map(|row| canvas.row(row).iter().map(|&cell| canvas.character(cell)).collect())
            .collect()
    }

    #[test]
    fn lines_are_dots() {
        let mut braille = DotCanvas::new(2, 1, true);
        braille.line([0.0, 0.0], [1.0, 1.0], 0);
        assert_eq!(text(&braille), ["\u{2860}\u{280a}"], "three dots down, two across, and so on");
        let mut signs = DotCanvas::new(3, 3, false);
        signs.line([0.0, 0.0], [1.0, 1.0], 0);
        signs.line([0.5, 1.0], [0.5, 1.0], 1);
        assert_eq!(text(&signs), [" +*", " * ", "*  "]);
    }
}
