//! Curves in space, seen in parallel projection inside a box with numbered edges.

use super::legend::{self, Entry};
use super::scene::Scene;
use super::style::Style;
use super::svg::{Anchor, Canvas, Rect, fitting};
use super::{FigureError, Legend, png};

/// One curve in space.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct SpaceSeries {
    /// Name in the legend; a series without one is drawn but not listed.
    pub(crate) name: String,
    /// Its points x, y, z in the units of the axes; one that is not finite breaks the line.
    pub(crate) points: Vec<[f64; 3]>,
    /// How it is drawn.
    pub(crate) style: Style,
}

impl SpaceSeries {
    /// A curve through these points, in the units of the axes.
    #[must_use]
    pub(crate) fn new(name: impl Into<String>, points: Vec<[f64; 3]>, style: Style) -> Self {
        let name = name.into();
        Self { name, points, style }
    }
}

/// A figure of curves in space, z upwards.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SpaceFigure {
    /// Heading above the box.
    pub(crate) title: Option<String>,
    /// Words for readers who cannot see it; without them title and labels serve.
    pub(crate) alt: Option<String>,
    /// Width in CSS pixels (the PNG has twice as many).
    pub(crate) width: f64,
    /// Height in CSS pixels, legend included; less is taken where the box needs less.
    pub(crate) height: f64,
    /// What x, y and z show, with their units.
    pub(crate) labels: [String; 3],
    /// The curves; a later one is drawn over an earlier one.
    pub(crate) series: Vec<SpaceSeries>,
    /// Direction of the viewer in the x-y plane, in degrees from x towards y.
    pub(crate) azimuth: f64,
    /// Height of the viewer above that plane in degrees, kept within 5 and 85.
    pub(crate) elevation: f64,
    /// Whether one unit is equally long on all axes.
    pub(crate) equal_aspect: bool,
    /// Whether a pale projection of each curve lies on the floor.
    pub(crate) floor_shadow: bool,
    /// Where the legend stands; a corner or a free place counts from the whole picture.
    pub(crate) legend: Legend,
}

impl Default for SpaceFigure {
    fn default() -> Self {
        Self {
            title: None,
            alt: None,
            width: 640.0,
            height: 480.0,
            labels: ["x", "y", "z"].map(str::to_owned),
            series: Vec::new(),
            azimuth: -55.0,
            elevation: 24.0,
            equal_aspect: true,
            floor_shadow: true,
            legend: Legend::Auto,
        }
    }
}

impl SpaceFigure {
    /// The figure as one SVG element.
    #[must_use]
    pub(crate) fn svg(&self) -> String {
        let entries = self.entries();
        let head = if self.title.is_some() { 32.0 } else { 8.0 };
        let width = self.width - 16.0;
        let area = |below: &[Entry], right: &[Entry]| Rect {
            x: 8.0,
            y: head,
            w: width - legend::width_right(right),
            h: self.height - head - 8.0 - legend::height_below(below, width),
        };
        let (below, right): (&[Entry], &[Entry]) = match self.legend {
            Legend::Below => (&entries, &[]),
            Legend::Right => (&[], &entries),
            _ => (&[], &[]),
        };
        let scene = Scene::new(self, area(below, right));
        let inside = legend::place_inside(&entries, self.legend, scene.area, &scene.ink());
        let homeless = inside.is_none() && self.legend == Legend::Auto;
        let (scene, below) = if homeless {
            (Scene::new(self, area(&entries, &[])), entries.as_slice())
        } else {
            (scene, below)
        };
        let mut canvas = Canvas::default();
        scene.draw(&mut canvas);
        if let Some(place) = inside {
            legend::draw_inside(&mut canvas, &entries, place);
        }
        let band = Rect { y: scene.area.bottom() + 4.0, w: width, ..scene.area };
        legend::draw_below(&mut canvas, below, band, self.width / 2.0);
        let beside = (scene.area.right() + 14.0, scene.area.y + 20.0);
        legend::draw_column(&mut canvas, right, beside);
        if let Some(title) = &self.title {
            let size = fitting(title, 13.5, width);
            canvas.text((self.width / 2.0, 20.0), title, size, Anchor::Middle);
        }
        let below = legend::height_below(below, width);
        let height = scene.area.bottom() + below + 8.0;
        canvas.finish(self.width, height, &self.words(&entries))
    }

    /// The figure as a PNG file on white, two pixels for each CSS pixel.
    ///
    /// # Errors
    /// If the size of the figure is zero, not finite or too large for memory.
    pub(crate) fn png(&self) -> Result<Vec<u8>, FigureError> {
        png::render(&self.svg())
    }

    fn entries(&self) -> Vec<Entry> {
        if self.legend == Legend::Hidden {
            return Vec::new();
        }
        let named = self.series.iter().filter(|s| !s.name.is_empty());
        named.map(|s| Entry::new(&s.name, s.style)).collect()
    }

    fn words(&self, entries: &[Entry]) -> String {
        if let Some(alt) = &self.alt {
            return alt.clone();
        }
        let names: Vec<&str> = entries.iter().map(|e| e.name.as_str()).collect();
        let title = self.title.as_deref().unwrap_or("Curves in space");
        format!("{title}: {} {}", self.labels.join(", "), names.join(", "))
    }
}
