//! PDF of SVG text. Texts become outlines, so that no font is required.

use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::writers::ExtGraphicsState;
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref};
use resvg::usvg::tiny_skia_path::{self as skia, PathSegment, Point, Transform};
use resvg::usvg::{Color, Fill, FillRule, Group, LineCap, LineJoin, Node, Paint, Path, Stroke};

use super::svg::{FigureError, tree};

/// Points of a page per CSS pixel.
const POINTS: f32 = 0.75;

/// Renders SVG text as a file with one page of its size.
pub(crate) fn page(svg: &str) -> Result<Vec<u8>, FigureError> {
    let tree = tree(svg)?;
    let (width, height) = (POINTS * tree.size().width(), POINTS * tree.size().height());
    let mut drawing = Drawing { content: Content::new(), opacities: Vec::new() };
    drawing.content.transform([POINTS, 0.0, 0.0, -POINTS, 0.0, height]);
    drawing.group(tree.root(), 1.0);
    let [catalog, pages, page, content] = [1, 2, 3, 4].map(Ref::new);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([page]).count(1);
    let mut entry = pdf.page(page);
    entry.media_box(Rect::new(0.0, 0.0, width, height)).parent(pages).contents(content);
    let mut resources = entry.resources();
    let mut states = resources.ext_g_states();
    for (number, opacity) in drawing.opacities.iter().enumerate() {
        let mut state = states.insert(Name(&state_name(number))).start::<ExtGraphicsState>();
        state.non_stroking_alpha(*opacity).stroking_alpha(*opacity);
    }
    states.finish();
    resources.finish();
    entry.finish();
    pdf.stream(content, &drawing.content.finish());
    Ok(pdf.finish())
}

/// Name of a graphics state in the resources of the page.
fn state_name(number: usize) -> Vec<u8> {
    format!("opacity{number}").into_bytes()
}

/// Content of a page.
struct Drawing {
    content: Content,
    /// Opacities of the graphics states of the page.
    opacities: Vec<f32>,
}

impl Drawing {
    /// Adds a group. Its opacity applies to each of its parts.
    fn group(&mut self, group: &Group, opacity: f32) {
        let opacity = opacity * group.opacity().get();
        self.content.save_state();
        if let Some(clip) = group.clip_path() {
            self.clip(clip.root(), group.abs_transform().pre_concat(clip.transform()));
        }
        for node in group.children() {
            match node {
                Node::Group(inner) => self.group(inner, opacity),
                Node::Path(path) if path.is_visible() => self.path(path, opacity),
                Node::Text(text) => self.group(text.flattened(), opacity),
                Node::Path(_) | Node::Image(_) => {}
            }
        }
        self.content.restore_state();
    }

    /// Clips at the outlines of a group in a coordinate system.
    fn clip(&mut self, outlines: &Group, system: Transform) {
        for node in outlines.children() {
            let Node::Path(path) = node else { continue };
            if let Some(placed) = path.data().clone().transform(system.pre_concat(path.abs_transform())) {
                self.segments(&placed);
            }
        }
        self.content.clip_nonzero().end_path();
    }

    /// Adds a path: its area, then its line.
    fn path(&mut self, path: &Path, opacity: f32) {
        let t = path.abs_transform();
        self.content.save_state();
        self.content.transform([t.sx, t.ky, t.kx, t.sy, t.tx, t.ty]);
        if let Some(fill) = path.fill() {
            self.fill(path.data(), fill, opacity);
        }
        if let Some(stroke) = path.stroke() {
            self.stroke(path.data(), stroke, opacity);
        }
        self.content.restore_state();
    }

    /// Adds an area.
    fn fill(&mut self, data: &skia::Path, fill: &Fill, opacity: f32) {
        let Some([r, g, b]) = rgb(fill.paint()) else { return };
        self.opacity(opacity * fill.opacity().get());
        self.content.set_fill_rgb(r, g, b);
        self.segments(data);
        match fill.rule() {
            FillRule::NonZero => self.content.fill_nonzero(),
            FillRule::EvenOdd => self.content.fill_even_odd(),
        };
    }

    /// Adds a line.
    fn stroke(&mut self, data: &skia::Path, stroke: &Stroke, opacity: f32) {
        let Some([r, g, b]) = rgb(stroke.paint()) else { return };
        self.opacity(opacity * stroke.opacity().get());
        self.content.set_stroke_rgb(r, g, b).set_line_width(stroke.width().get());
        self.content.set_line_cap(match stroke.linecap() {
            LineCap::Butt => LineCapStyle::ButtCap,
            LineCap::Round => LineCapStyle::RoundCap,
            LineCap::Square => LineCapStyle::ProjectingSquareCap,
        });
        self.content.set_line_join(match stroke.linejoin() {
            LineJoin::Round => LineJoinStyle::RoundJoin,
            LineJoin::Bevel => LineJoinStyle::BevelJoin,
            LineJoin::Miter | LineJoin::MiterClip => LineJoinStyle::MiterJoin,
        });
        if let Some(dashes) = stroke.dasharray() {
            self.content.set_dash_pattern(dashes.iter().copied(), stroke.dashoffset());
        }
        self.segments(data);
        self.content.stroke();
    }

    /// Sets the opacity of the following areas and lines.
    fn opacity(&mut self, opacity: f32) {
        if opacity == 1.0 && self.opacities.is_empty() {
            return;
        }
        let known = self.opacities.iter().position(|one| *one == opacity);
        let number = known.unwrap_or(self.opacities.len());
        if known.is_none() {
            self.opacities.push(opacity);
        }
        self.content.set_parameters(Name(&state_name(number)));
    }

    /// Adds the segments of a path.
    fn segments(&mut self, path: &skia::Path) {
        let mut last = Point::zero();
        for segment in path.segments() {
            last = match segment {
                PathSegment::MoveTo(p) => {
                    self.content.move_to(p.x, p.y);
                    p
                }
                PathSegment::LineTo(p) => {
                    self.content.line_to(p.x, p.y);
                    p
                }
                PathSegment::QuadTo(control, p) => {
                    let [a, b] = [last, p].map(|end| two_thirds(end, control));
                    self.content.cubic_to(a.x, a.y, b.x, b.y, p.x, p.y);
                    p
                }
                PathSegment::CubicTo(a, b, p) => {
                    self.content.cubic_to(a.x, a.y, b.x, b.y, p.x, p.y);
                    p
                }
                PathSegment::Close => {
                    self.content.close_path();
                    last
                }
            };
        }
    }
}

/// Control point of the cubic curve that equals a quadratic one, beside its end.
fn two_thirds(end: Point, control: Point) -> Point {
    Point::from_xy(end.x + (control.x - end.x) * 2.0 / 3.0, end.y + (control.y - end.y) * 2.0 / 3.0)
}

/// Components from 0 to 1. Figures have plain colours only.
fn rgb(paint: &Paint) -> Option<[f32; 3]> {
    let Paint::Color(Color { red, green, blue }) = paint else { return None };
    Some([red, green, blue].map(|component| f32::from(*component) / 255.0))
}
