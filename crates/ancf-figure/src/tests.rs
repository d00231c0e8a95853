//! Tests of the figures as a whole and of the thinning of lines.

use resvg::tiny_skia::Pixmap;
use resvg::usvg::roxmltree::Document;

use super::draw::thin;
use super::*;

fn example(points: usize) -> Figure {
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let noise = |i: usize| (i * 7919 % 104_729) as f64 / 104_729.0;
    let y: Vec<f64> = x.iter().enumerate().map(|(i, t)| (-t).exp() * (40.0 * t).sin() + noise(i)).collect();
    Figure::new("time t* (s) & <so on>", "height (m)")
        .with(Series::new("a \"quoted\" name", x.clone(), y.clone()).style(Style::nth(0).wide(4.0)))
        .with(Series::new("b", x, y).style(Style::nth(1).marked(Marker::Cross, 50)))
        .with(Series::horizontal("mean", 0.5, (0.0, 1.0)).style(Style::nth(3)))
}

fn helix(azimuth: f64) -> SpaceFigure {
    let points = (0..500).map(|i| f64::from(i) / 50.0).map(|t| [t.cos(), t.sin(), 0.1 * t]).collect();
    let series = vec![SpaceSeries::new("helix", points, Style::nth(1))];
    SpaceFigure { series, azimuth, ..SpaceFigure::default() }
}

/// Well-formed, spoken, and without anything that could collide with another figure of a page.
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
    check(&Panels::new(vec![example(50), example(60)]).svg());
    check(&Panels::default().svg());
    for azimuth in [-135.0, -90.0, -55.0, 0.0, 45.0, 180.0] {
        check(&helix(azimuth).svg());
    }
    check(&SpaceFigure::default().svg());
}

#[test]
fn strange_data_are_drawn_without_them() {
    let x = vec![f64::NAN, 1.0, 2.0, f64::INFINITY, 3.0];
    let y = vec![1.0, -1.0, 0.0, 5.0, f64::NEG_INFINITY];
    let mut figure = Figure::new("x", "y").with(Series::new("odd", x, y));
    check(&figure.svg());
    figure.equal_aspect = true;
    figure.x.scale = Scale::Log;
    figure.y = Axis { scale: Scale::Log, range: Some((f64::NAN, 0.0)), ..Axis::default() };
    check(&figure.svg());
}

#[test]
fn png_is_not_blank_and_twice_as_large() {
    for png in [example(300).png(), helix(-55.0).png(), Panels::new(vec![example(50)]).png()] {
        let picture = Pixmap::decode_png(&png.expect("drawn")).expect("a PNG");
        let dark = picture.pixels().iter().filter(|p| p.red() < 128).count();
        assert_eq!(picture.width(), 1280);
        assert!(dark > picture.pixels().len() / 500);
    }
    assert!(Figure { width: 0.0, ..example(10) }.png().is_err());
}

#[test]
fn tiny_values_keep_their_places_on_a_logarithmic_axis() {
    let y = |last: f64| {
        let mut figure =
            Figure::new("x", "y").with(Series::new("", vec![0.0, 1.0, 2.0], vec![1.0, 1e-12, last]));
        figure.y = Axis { scale: Scale::Log, range: Some((1e-16, 1.0)), ..Axis::default() };
        figure.svg()
    };
    assert!(y(1e-15).contains("10\u{207b}\u{b9}\u{b2}"));
    assert_ne!(y(1e-15), y(1e-14));
}

#[test]
fn legend_goes_below_when_no_corner_is_free() {
    let x: Vec<f64> = (0..400).map(f64::from).collect();
    let y = (0..400).map(|i| f64::from(i % 2)).collect();
    let full = Figure::new("x", "y").with(Series::new("name", x, y));
    let with = |legend| Figure { legend, ..full.clone() }.svg();
    assert!(!with(Legend::Hidden).contains(">name<"));
    assert_eq!(with(Legend::Auto), with(Legend::Below));
    let panels = Panels::new(vec![example(50), example(50)]).svg();
    assert_eq!(panels.matches(">mean<").count(), 1);
}

#[test]
fn thinning_keeps_extremes_and_shapes() {
    let noise: Vec<_> = (0..5000).map(|i| (f64::from(i) * 0.01, f64::from(i * 7919 % 5003))).collect();
    let kept = thin(&noise);
    assert!(kept.len() <= 4 * 100);
    let extremes = |points: &[(f64, f64)], column: i32| {
        let inside = points.iter().filter(|p| (2.0 * p.0).floor() == f64::from(column));
        inside.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), p| (lo.min(p.1), hi.max(p.1)))
    };
    (0..100).for_each(|column| assert_eq!(extremes(&noise, column), extremes(&kept, column)));
    let turn = |i: i32| (f64::from(i) * std::f64::consts::TAU / 6000.0).sin_cos();
    let circle: Vec<_> = (0..=6000).map(turn).map(|(s, c)| (200.0 + 150.0 * c, 200.0 + 150.0 * s)).collect();
    let kept = thin(&circle);
    let middle = |w: &[(f64, f64)]| ((w[0].0 + w[1].0) / 2.0 - 200.0).hypot((w[0].1 + w[1].1) / 2.0 - 200.0);
    assert!(kept.len() < 600);
    let off = kept.windows(2).map(|w| (middle(w) - 150.0).abs()).fold(0.0, f64::max);
    assert!(off < 0.05, "{off}");
}
