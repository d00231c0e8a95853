//! Tests of complete figures and of the decimation of polylines.

use resvg::tiny_skia::Pixmap;
use resvg::usvg::roxmltree::Document;

use super::polyline::decimate;
use super::*;

fn example(points: usize) -> Figure {
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let noise = |i: usize| (i * 7919 % 104_729) as f64 / 104_729.0;
    let y: Vec<f64> = x.iter().enumerate().map(|(i, t)| (-t).exp() * (40.0 * t).sin() + noise(i)).collect();
    Figure::new("time t* (s) & <so on>", "height (m)")
        .with(
            FigureSeries::new("a \"quoted\" name", x.clone(), y.clone()).style(CurveStyle::nth(0).wide(4.0)),
        )
        .with(FigureSeries::new("b", x, y).style(CurveStyle::nth(1).marked(MarkerShape::Cross, 50)))
        .with(FigureSeries::horizontal("mean", 0.5, (0.0, 1.0)).style(CurveStyle::nth(3)))
}

fn helix(azimuth: f64) -> SpaceFigure {
    let points = (0..500).map(|i| f64::from(i) / 50.0).map(|t| [t.cos(), t.sin(), 0.1 * t]).collect();
    let curves = vec![SpaceCurve::new("helix", points, CurveStyle::nth(1))];
    SpaceFigure { curves, azimuth, ..SpaceFigure::default() }
}

/// Asserts well-formed SVG with an alternative text and without ids, classes, scripts or style sheets.
fn check(svg: &str) {
    let document = Document::parse(svg).expect("well-formed");
    let root = document.root_element();
    assert_eq!(root.attribute("role"), Some("img"));
    assert!(root.attribute("aria-label").is_some_and(|l| !l.is_empty()));
    for node in document.descendants() {
        assert!(node.attribute("id").is_none() && node.attribute("class").is_none());
        assert!(!node.has_tag_name("script") && !node.has_tag_name("style"));
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
}

#[test]
fn svg_is_well_formed_without_ids() {
    check(&example(300).svg());
    check(&Figure::new("", "").svg());
    check(&FigurePanels::new(vec![example(50), example(60)]).svg());
    check(&FigurePanels::default().svg());
    for azimuth in [-135.0, -90.0, -55.0, 0.0, 45.0, 180.0] {
        check(&helix(azimuth).svg());
    }
    check(&SpaceFigure::default().svg());
}

#[test]
fn data_that_are_not_finite_are_omitted() {
    let x = vec![f64::NAN, 1.0, 2.0, f64::INFINITY, 3.0];
    let y = vec![1.0, -1.0, 0.0, 5.0, f64::NEG_INFINITY];
    let mut figure = Figure::new("x", "y").with(FigureSeries::new("odd", x, y));
    check(&figure.svg());
    figure.equal_aspect = true;
    figure.x.scale = AxisScale::Log;
    figure.y = FigureAxis { scale: AxisScale::Log, range: Some((f64::NAN, 0.0)), ..FigureAxis::default() };
    check(&figure.svg());
}

#[test]
fn png_is_not_blank_and_twice_as_large() {
    for png in [example(300).png(), helix(-55.0).png(), FigurePanels::new(vec![example(50)]).png()] {
        let picture = Pixmap::decode_png(&png.expect("drawn")).expect("a PNG");
        let dark = picture.pixels().iter().filter(|p| p.red() < 128).count();
        assert_eq!(picture.width(), 1280);
        assert!(dark > picture.pixels().len() / 500);
    }
    assert!(Figure { width: 0.0, ..example(10) }.png().is_err());
}

/// Numbers before each operator of the content of a PDF file.
fn operands(pdf: &[u8], operator: &str) -> Vec<Vec<f32>> {
    let text = String::from_utf8_lossy(pdf);
    let content = text.split("stream\n").nth(1).expect("content");
    let lines = content.lines().filter_map(|line| line.strip_suffix(operator));
    lines.map(|line| line.split_whitespace().filter_map(|word| word.parse().ok()).collect()).collect()
}

#[test]
fn pdf_has_the_page_of_the_figure_and_its_curves() {
    let line = FigureSeries::new("", vec![0.0, 1.0], vec![0.0, 1.0]);
    let style = CurveStyle::nth(1).wide(3.25);
    let figure = Figure::new("x", "y").with(line.style(style));
    let pdf = figure.pdf().expect("drawn");
    assert!(pdf.starts_with(b"%PDF-"));
    // A CSS pixel has 0.75 points.
    let page = format!("/MediaBox [0 0 {} {}]", 0.75 * figure.width, 0.75 * figure.height);
    assert!(String::from_utf8_lossy(&pdf).contains(&page), "{page}");
    assert_eq!(operands(&pdf, " w").iter().filter(|width| width[..] == [3.25]).count(), 1);
    // A scale and a reflection place the origin of SVG at the upper left corner.
    assert_eq!(operands(&pdf, " cm")[0][..4], [0.75, 0.0, 0.0, -0.75]);
    let panels = FigurePanels::new(vec![example(50), example(60)]);
    assert!(!operands(&panels.pdf().expect("drawn"), " w").is_empty());
    assert!(Figure { width: 0.0, ..example(10) }.pdf().is_err());
}

#[test]
fn tiny_values_are_drawn_at_their_place_on_a_logarithmic_axis() {
    let y = |last: f64| {
        let mut figure =
            Figure::new("x", "y").with(FigureSeries::new("", vec![0.0, 1.0, 2.0], vec![1.0, 1e-12, last]));
        figure.y = FigureAxis { scale: AxisScale::Log, range: Some((1e-16, 1.0)), ..FigureAxis::default() };
        figure.svg()
    };
    assert!(y(1e-15).contains("10\u{207b}\u{b9}\u{b2}"));
    assert_ne!(y(1e-15), y(1e-14));
}

#[test]
fn legend_goes_below_when_no_corner_is_free() {
    let x: Vec<f64> = (0..400).map(f64::from).collect();
    let y = (0..400).map(|i| f64::from(i % 2)).collect();
    let full = Figure::new("x", "y").with(FigureSeries::new("name", x, y));
    let with = |legend| Figure { legend, ..full.clone() }.svg();
    assert!(!with(LegendPlacement::Hidden).contains(">name<"));
    assert_eq!(with(LegendPlacement::Auto), with(LegendPlacement::Below));
    let panels = FigurePanels::new(vec![example(50), example(50)]).svg();
    assert_eq!(panels.matches(">mean<").count(), 1);
}

#[test]
fn decimation_preserves_extremes_and_shapes() {
    let noise: Vec<_> = (0..5000).map(|i| (f64::from(i) * 0.01, f64::from(i * 7919 % 5003))).collect();
    let kept = decimate(&noise);
    assert!(kept.len() <= 4 * 100);
    let extremes = |points: &[(f64, f64)], column: i32| {
        let inside = points.iter().filter(|p| (2.0 * p.0).floor() == f64::from(column));
        inside.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), p| (lo.min(p.1), hi.max(p.1)))
    };
    (0..100).for_each(|column| assert_eq!(extremes(&noise, column), extremes(&kept, column)));
    let turn = |i: i32| (f64::from(i) * std::f64::consts::TAU / 6000.0).sin_cos();
    let circle: Vec<_> = (0..=6000).map(turn).map(|(s, c)| (200.0 + 150.0 * c, 200.0 + 150.0 * s)).collect();
    let kept = decimate(&circle);
    let middle = |w: &[(f64, f64)]| ((w[0].0 + w[1].0) / 2.0 - 200.0).hypot((w[0].1 + w[1].1) / 2.0 - 200.0);
    assert!(kept.len() < 600);
    let off = kept.windows(2).map(|w| (middle(w) - 150.0).abs()).fold(0.0, f64::max);
    assert!(off < 0.05, "{off}");
}
