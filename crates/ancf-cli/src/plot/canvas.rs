/// Dots in the cells of a terminal.
#[derive(Debug)]
pub struct Canvas {
    width: usize,
    height: usize,
    is_braille: bool,
    cells: Vec<Cell>,
}

/// The dots of a cell, and which curve was there last.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Cell {
    dots: u8,
    pub curve: usize,
}

/// What curves look like whose colours are not seen.
pub const SIGNS: [char; 8] = ['*', '+', 'o', 'x', '#', '@', '%', '='];

/// Bits of the dots of a braille character by row and column (Unicode, block "Braille Patterns").
const BITS: [[u8; 2]; 4] = [[0x01, 0x08], [0x02, 0x10], [0x04, 0x20], [0x40, 0x80]];

impl Canvas {
    /// Of so many cells, each of eight dots in braille or of one sign.
    pub fn new(width: usize, height: usize, is_braille: bool) -> Self {
        Self { width, height, is_braille, cells: vec![Cell::default(); width * height] }
    }

    /// Dots in a cell, across and down.
    const fn density(&self) -> [usize; 2] {
        if self.is_braille { [2, 4] } else { [1, 1] }
    }

    /// Draws the straight line between two points of the unit square, whose origin is at the lower left.
    pub fn line(&mut self, from: [f64; 2], to: [f64; 2], curve: usize) {
        let ([x0, y0], [x1, y1]) = (self.dot(from), self.dot(to));
        let steps = (x1 - x0).abs().max((y1 - y0).abs()).max(1.0);
        for k in 0..=steps as usize {
            let part = k as f64 / steps;
            self.set(x0 + part * (x1 - x0), y0 + part * (y1 - y0), curve);
        }
    }

    /// The dot of a point of the unit square.
    fn dot(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [across, down] = self.density();
        let most = [self.width * across - 1, self.height * down - 1].map(|most| most as f64);
        [x.clamp(0.0, 1.0) * most[0], (1.0 - y.clamp(0.0, 1.0)) * most[1]].map(f64::round)
    }

    fn set(&mut self, x: f64, y: f64, curve: usize) {
        let [across, down] = self.density();
        let (x, y) = (x.round() as usize, y.round() as usize);
        if let Some(cell) = self.cells.get_mut(y / down * self.width + x / across) {
            *cell = Cell { dots: cell.dots | BITS[y % down][x % across], curve };
        }
    }

    /// The cells of a line of the terminal.
    pub fn row(&self, row: usize) -> &[Cell] {
        &self.cells[row * self.width..(row + 1) * self.width]
    }

    /// The character of a cell.
    pub fn sign(&self, cell: Cell) -> char {
        match cell.dots {
            0 => ' ',
            dots if self.is_braille => char::from_u32(0x2800 + u32::from(dots)).unwrap_or(' '),
            _ => SIGNS[cell.curve % SIGNS.len()],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(canvas: &Canvas) -> Vec<String> {
        (0..canvas.height)
            .map(|row| canvas.row(row).iter().map(|&cell| canvas.sign(cell)).collect())
            .collect()
    }

    #[test]
    fn lines_are_dots() {
        let mut braille = Canvas::new(2, 1, true);
        braille.line([0.0, 0.0], [1.0, 1.0], 0);
        assert_eq!(text(&braille), ["\u{2860}\u{280a}"], "three dots down, two across, and so on");
        let mut signs = Canvas::new(3, 3, false);
        signs.line([0.0, 0.0], [1.0, 1.0], 0);
        signs.line([0.5, 1.0], [0.5, 1.0], 1);
        assert_eq!(text(&signs), [" +*", " * ", "*  "]);
    }
}
