//! Charts of characters in the terminal.
//!
//! Crates are not used: ratatui places the tick labels beside their positions, textplots has labels at the ends only, and both
//! distinguish curves by colours alone.

use anstyle::{AnsiColor, Style};

use super::canvas::{DotCanvas, DotCell, MARKERS};
use super::panel::{PanelCurve, PlotPanel};
use super::tick::AxisTicks;

/// Properties of the terminal.
#[derive(Clone, Copy, Debug)]
pub struct ChartStyle {
    /// Width in characters.
    pub width: usize,
    /// True if the terminal has Unicode characters.
    pub is_unicode: bool,
    /// True if the terminal has colours.
    pub is_coloured: bool,
}

/// Height of a single chart, and of one of several charts, in lines.
const HEIGHTS: [usize; 2] = [16, 10];

/// Columns per tick of the horizontal axis.
const TICK_COLUMNS: usize = 14;

const COLOURS: [AnsiColor; 6] = [
    AnsiColor::Cyan,
    AnsiColor::Yellow,
    AnsiColor::Magenta,
    AnsiColor::Green,
    AnsiColor::Blue,
    AnsiColor::Red,
];

/// Returns the panels as charts of characters, one below the other.
pub fn text(panels: &[PlotPanel], style: ChartStyle) -> String {
    let height = HEIGHTS[usize::from(panels.len() > 1)];
    let charts: Vec<String> = panels.iter().map(|panel| Chart::new(panel, style, height).text()).collect();
    charts.join("\n")
}

struct Chart<'a> {
    panel: &'a PlotPanel,
    style: ChartStyle,
    x: AxisTicks,
    y: AxisTicks,
    /// Width of the tick labels on the left.
    margin: usize,
    height: usize,
    canvas: DotCanvas,
}

impl<'a> Chart<'a> {
    fn new(panel: &'a PlotPanel, style: ChartStyle, height: usize) -> Self {
        let [x, y] = panel.ranges();
        let y = AxisTicks::within(y, height / 4);
        let margin = y.labels().iter().map(|(_, text)| text.len()).max().unwrap_or(0) + 1;
        let width = style.width.saturating_sub(margin + 1).max(10);
        let x = AxisTicks::within(x, width / TICK_COLUMNS);
        let mut chart =
            Self { panel, style, x, y, margin, height, canvas: DotCanvas::new(width, height, false) };
        chart.canvas = DotCanvas::new(width, height, chart.is_braille());
        panel.curves.iter().enumerate().for_each(|(number, curve)| chart.draw(number, curve));
        chart
    }

    /// True if curves are drawn in Braille: if they can be distinguished.
    fn is_braille(&self) -> bool {
        let are_distinguishable = self.style.is_coloured || self.panel.curves.len() == 1;
        self.style.is_unicode && are_distinguishable && !self.panel.is_discrete
    }

    fn draw(&mut self, number: usize, curve: &PanelCurve) {
        let part = |x: f64, [lo, hi]: [f64; 2]| (x / 2.0 - lo / 2.0) / (hi / 2.0 - lo / 2.0);
        let (across, up) = (self.x.range(), self.y.range());
        for piece in curve.pieces() {
            let places: Vec<[f64; 2]> = piece.iter().map(|&[x, y]| [part(x, across), part(y, up)]).collect();
            places.iter().for_each(|&place| self.canvas.line(place, place, number));
            let between = places.windows(2).filter(|_| !self.panel.is_discrete);
            between.for_each(|ends| self.canvas.line(ends[0], ends[1], number));
        }
    }

    fn text(&self) -> String {
        let mut text = self.legend() + "\n";
        let rows = self.y.labels().into_iter().map(|(place, label)| (self.row(place), label));
        let labels: Vec<(usize, String)> = rows.collect();
        for row in 0..self.height {
            let label = labels.iter().find(|(at, _)| *at == row).map_or("", |(_, label)| label);
            let axis = self.line(if label.is_empty() { '│' } else { '┤' });
            text += &format!("{label:>margin$}{axis}{}\n", self.cells(row), margin = self.margin);
        }
        text + &self.foot()
    }

    /// Returns the row of a position on the vertical axis.
    fn row(&self, place: f64) -> usize {
        let [lo, hi] = self.y.range();
        ((1.0 - (place - lo) / (hi - lo)) * (self.height - 1) as f64).round() as usize
    }

    fn cells(&self, row: usize) -> String {
        let mut text = String::new();
        let is_empty = |cell: &DotCell| self.canvas.character(*cell) == ' ';
        for cells in self.canvas.row(row).chunk_by(|a, b| a.curve == b.curve && is_empty(a) == is_empty(b)) {
            let characters: String = cells.iter().map(|&cell| self.canvas.character(cell)).collect();
            text +=
                &if is_empty(&cells[0]) { characters } else { self.coloured(&characters, cells[0].curve) };
        }
        text.trim_end().to_owned()
    }

    /// Returns a text in the colour of a curve.
    fn coloured(&self, text: &str, curve: usize) -> String {
        let colour = COLOURS[curve % COLOURS.len()].on_default();
        let style = if self.style.is_coloured { colour } else { Style::new() };
        format!("{style}{text}{style:#}")
    }

    /// Returns the names of the curves and their unit.
    fn legend(&self) -> String {
        let name = |(number, curve): (usize, &PanelCurve)| {
            let marker = MARKERS[number % MARKERS.len()];
            let text =
                if self.is_braille() { curve.name.clone() } else { format!("{marker} {}", curve.name) };
            self.coloured(&text, number)
        };
        let names: Vec<String> = self.panel.curves.iter().enumerate().map(name).collect();
        self.panel.with_unit(&names.join("  "))
    }

    /// Returns the horizontal axis, its tick labels and its label.
    fn foot(&self) -> String {
        let width = self.canvas.row(0).len();
        let mut axis: Vec<char> = vec![self.line('─'); width];
        let mut numbers = vec![' '; self.margin + 1 + width];
        let [lo, hi] = self.x.range();
        let mut free = 0;
        for (place, label) in self.x.labels() {
            let column = ((place - lo) / (hi - lo) * (width - 1) as f64).round() as usize;
            axis[column] = self.line('┬');
            let start = self.margin + 1 + column;
            let start = start.saturating_sub(label.len() / 2).min(numbers.len() - label.len());
            if start >= free {
                label.chars().enumerate().for_each(|(k, character)| numbers[start + k] = character);
                free = start + label.len() + 1;
            }
        }
        let axis: String = axis.into_iter().collect();
        let numbers: String = numbers.into_iter().collect();
        let (corner, margin, whole) = (self.line('└'), self.margin, self.margin + 1 + width);
        format!("{:margin$}{corner}{axis}\n{}\n{:>whole$}\n", "", numbers.trim_end(), self.panel.x)
    }

    /// Returns a line character, or its ASCII replacement.
    fn line(&self, character: char) -> char {
        match character {
            _ if self.style.is_unicode => character,
            '│' => '|',
            '─' => '-',
            _ => '+',
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: ChartStyle = ChartStyle { width: 60, is_unicode: false, is_coloured: false };

    fn panel(curves: Vec<PanelCurve>) -> PlotPanel {
        PlotPanel { x: "t (s)".into(), is_discrete: false, unit: "m".into(), curves }
    }

    fn curve(name: &str, f: impl Fn(f64) -> f64) -> PanelCurve {
        let x: Vec<f64> = (0..=200).map(|k| 0.01 * f64::from(k)).collect();
        PanelCurve { name: name.into(), y: x.iter().map(|&t| f(t)).collect(), x }
    }

    /// Returns the columns of a marker in a line, after the axis.
    fn columns(line: &str, sign: char) -> Vec<usize> {
        line.char_indices()
            .skip_while(|(_, c)| !"|+".contains(*c))
            .skip(1)
            .filter(|(_, c)| *c == sign)
            .map(|(k, _)| k)
            .collect()
    }

    #[test]
    fn a_straight_line_goes_from_corner_to_corner_in_ascii() {
        let text = text(&[panel(vec![curve("tip.y", |t| 2.0 * t)])], PLAIN);
        let lines: Vec<&str> = text.lines().collect();
        assert!(text.is_ascii() && lines.iter().all(|line| line.len() <= 60), "{text}");
        assert_eq!((lines[0], lines.len()), ("* tip.y (m)", 1 + 16 + 3));
        assert!(
            columns(lines[1], '*').last() == Some(&59) && columns(lines[16], '*').first() == Some(&3),
            "{text}"
        );
        assert!(lines[1].starts_with(" 4+") && lines[16].starts_with(" 0+"), "{text}");
        assert!(
            lines[18].starts_with("   0") && lines[18].ends_with("2.0") && lines[19].ends_with("t (s)"),
            "{text}"
        );
    }

    #[test]
    fn curves_are_told_apart_without_colours() {
        let text = text(
            &[panel(vec![curve("a", |t| t), curve("b", |t| 2.0 - t)])],
            ChartStyle { is_unicode: true, ..PLAIN },
        );
        assert!(
            text.starts_with("* a  + b (m)\n") && text.contains('┤') && !text.contains('\u{1b}'),
            "{text}"
        );
        assert!(
            text.lines().nth(2).unwrap().contains('*') && text.lines().nth(2).unwrap().contains('+'),
            "{text}"
        );
    }

    #[test]
    fn one_curve_is_braille_and_colours_tell_several() {
        let is_braille = |c: char| ('\u{2801}'..='\u{28ff}').contains(&c);
        let unicode = ChartStyle { is_unicode: true, ..PLAIN };
        let one = text(&[panel(vec![curve("a", |t| t)])], unicode);
        assert!(one.contains(is_braille) && one.starts_with("a (m)\n") && !one.contains('*'), "{one}");
        let two = vec![curve("a", |t| t), curve("b", |t| 2.0 - t)];
        let two = text(&[panel(two)], ChartStyle { is_coloured: true, ..unicode });
        assert!(
            two.contains(is_braille) && two.contains("\u{1b}[36ma") && two.contains("\u{1b}[33mb"),
            "{two}"
        );
    }

    #[test]
    fn there_is_nothing_between_modes() {
        let modes = PanelCurve { name: "frequency".into(), x: vec![1.0, 2.0, 3.0], y: vec![1.0, 2.0, 10.0] };
        let modes = PlotPanel { is_discrete: true, ..panel(vec![modes]) };
        let text = text(&[modes], ChartStyle { is_unicode: true, ..PLAIN });
        assert_eq!(text.matches('*').count(), 1 + 3, "the name and the points: {text}");
    }

    #[test]
    fn what_is_no_number_is_a_gap() {
        let gap = curve("a", |t| if (0.5..1.5).contains(&t) { f64::NAN } else { 1.0 });
        let text = text(&[panel(vec![gap])], PLAIN);
        let line = text.lines().find(|line| line.contains("***")).unwrap();
        let signs = columns(line, '*');
        let gap = signs.windows(2).map(|pair| pair[1] - pair[0]).max().unwrap();
        assert!((25..=32).contains(&gap), "half of the width is empty: {text}");
    }
}
