//! Tests of the figures as a whole and of their parts.

use resvg::tiny_skia::Pixmap;
use resvg::usvg::roxmltree::Document;

use super::decimate::{clip, column_extremes, path_data, thin};
use super::svg::{Rect, text_width};
use super::ticks::{Span, TickText};
use super::*;

/// A decaying oscillation with noise from a fixed sequence.
fn wave(points: usize) -> (Vec<f64>, Vec<f64>) {
    let x: Vec<f64> = (0..points).map(|i| i as f64 / points as f64).collect();
    let noise = |i: usize| (i * 7919 % 104_729) as f64 / 104_729.0;
    let y = x.iter().enumerate();
    let y = y.map(|(i, t)| (-t).exp() * (40.0 * t).sin() + noise(i));
    let y = y.collect();
    (x, y)
}

fn example(points: usize) -> Figure {
    let (x, y) = wave(points);
    Figure::new("time t* (s) & <so on>", "height (m)")
        .with(Series::new("a \"quoted\" name", x.clone(), y.clone()))
        .with(Series::new("b", x.clone(), y).style(Style::nth(1).marked(Marker::Cross, 50)))
        .with(Series::horizontal("mean", 0.5, (0.0, 1.0)).style(Style::nth(3)))
}

/// The numbers at the major ticks as plain text.
fn numbers(span: &Span) -> Vec<String> {
    let ticks = span.ticks(500.0, 76.0, true);
    let texts = ticks.major.into_iter().map(|(_, text)| match text {
        TickText::Plain(text) => text,
        TickText::Power(n) => format!("1e{n}"),
    });
    texts.collect()
}

fn check(svg: &str) {
    let document = Document::parse(svg).expect("well-formed");
    let root = document.root_element();
    assert_eq!(root.attribute("role"), Some("img"));
    assert!(root.attribute("aria-label").is_some_and(|l| !l.is_empty()));
    for node in document.descendants() {
        assert!(node.attribute("id").is_none() && node.attribute("class").is_none());
        assert!(!node.has_tag_name("script"));
    }
    assert!(!svg.contains("NaN") && !svg.contains("inf"));
}

fn dark_share(png: &[u8]) -> f64 {
    let picture = Pixmap::decode_png(png).expect("a PNG");
    let dark = picture.pixels().iter().filter(|p| p.red() < 128).count();
    dark as f64 / picture.pixels().len() as f64
}

#[test]
fn svg_is_well_formed_without_ids() {
    check(&example(300).svg());
    check(&Figure::default().svg());
    check(&Panels::new(vec![example(50), example(60)]).svg());
    check(&Panels::default().svg());
}

#[test]
fn png_is_not_blank_and_twice_as_large() {
    let png = example(300).png().expect("drawn");
    let picture = Pixmap::decode_png(&png).expect("a PNG");
    assert_eq!(picture.width(), 1280);
    assert!(dark_share(&png) > 0.005);
}

#[test]
fn png_has_text_from_the_bundled_font() {
    let labelled = |text: &str| {
        let mut figure = example(10);
        figure.x.label = text.to_owned();
        figure.png().expect("drawn")
    };
    assert_ne!(labelled("aaaa"), labelled("bbbb"));
    assert_ne!(labelled("\u{394}\u{394}"), labelled("\u{3a9}\u{3a9}"));
}

#[test]
fn impossible_sizes_are_errors() {
    let mut figure = example(10);
    figure.width = 0.0;
    assert!(figure.png().is_err());
    figure.width = f64::NAN;
    assert!(figure.png().is_err());
}

#[test]
fn strange_data_are_drawn_without_them() {
    let x = vec![f64::NAN, 1.0, 2.0, f64::INFINITY, 3.0];
    let y = vec![1.0, -1.0, 0.0, 5.0, f64::NEG_INFINITY];
    let mut figure = Figure::new("x", "y").with(Series::new("odd", x, y));
    check(&figure.svg());
    figure.x.scale = Scale::Log;
    figure.y.scale = Scale::Log;
    check(&figure.svg());
    figure.y.range = Some((f64::NAN, 0.0));
    check(&figure.svg());
}

#[test]
fn long_series_stay_small() {
    let svg = example(60_000).svg();
    assert!(svg.len() < 200_000, "{} bytes", svg.len());
}

#[test]
fn column_extremes_keeps_lowest_and_highest() {
    let points: Vec<_> = (0..5000).map(|i| (f64::from(i) * 0.01, f64::from(i * 7919 % 5003))).collect();
    let kept = column_extremes(&points, 1.0);
    assert!(kept.len() <= 4 * 50);
    for column in 0..50 {
        let of = |points: &[(f64, f64)]| {
            let inside = points.iter().filter(|p| p.0.floor() == f64::from(column));
            let none = (f64::INFINITY, f64::NEG_INFINITY);
            inside.fold(none, |(lo, hi), p| (lo.min(p.1), hi.max(p.1)))
        };
        assert_eq!(of(&points), of(&kept));
    }
    assert_eq!((kept.first(), kept.last()), (points.first(), points.last()));
}

#[test]
fn thinning_a_circle_keeps_its_shape() {
    let circle = |i: i32| {
        let angle = f64::from(i) * std::f64::consts::TAU / 6000.0;
        (200.0 + 150.0 * angle.cos(), 200.0 + 150.0 * angle.sin())
    };
    let points: Vec<_> = (0..=6000).map(circle).collect();
    let thinned = thin(&points);
    assert!(thinned.len() < 300);
    for p in &thinned {
        let radius = (p.0 - 200.0).hypot(p.1 - 200.0);
        assert!((radius - 150.0).abs() < 1e-9);
    }
}

#[test]
fn clipping_cuts_at_the_frame() {
    let frame = Rect { x: 0.0, y: 0.0, w: 10.0, h: 10.0 };
    let parts = clip(&[(-5.0, 5.0), (5.0, 5.0), (5.0, 15.0), (7.0, 5.0)], &frame);
    assert_eq!(parts.len(), 2);
    assert_eq!(parts[0], vec![(0.0, 5.0), (5.0, 5.0), (5.0, 10.0)]);
    let data = path_data(&[vec![(0.0, 5.0), (5.25, 4.5)]]);
    assert_eq!(data, "M0 5l5.25-.5");
}

#[test]
fn ticks_are_round() {
    let linear = Span::of([0.0, 0.397].into_iter(), Scale::Linear, None, 0.0);
    assert_eq!(numbers(&linear), ["0.0", "0.1", "0.2", "0.3", "0.4"]);
    let log = Span::of([1.0, 1000.0].into_iter(), Scale::Log, None, 0.0);
    assert_eq!(numbers(&log), ["1", "10", "100", "1000"]);
    let tiny = Span::of([0.0, 2e-7].into_iter(), Scale::Linear, None, 0.0);
    assert_eq!(tiny.ticks(500.0, 76.0, true).factor, -7);
    assert_eq!(numbers(&tiny), ["0.0", "0.5", "1.0", "1.5", "2.0"]);
    let below = Span::of([-2.0, 1.0].into_iter(), Scale::Linear, None, 0.0);
    assert!(numbers(&below).contains(&"\u{2212}2.0".to_owned()));
}

#[test]
fn legend_goes_below_when_no_corner_is_free() {
    let x: Vec<f64> = (0..400).map(f64::from).collect();
    let y = (0..400).map(|i| f64::from(i % 2)).collect();
    let full = Figure::new("x", "y").with(Series::new("name", x, y));
    let mut hidden = full.clone();
    hidden.legend = Legend::Hidden;
    let mut below = full.clone();
    below.legend = Legend::Below;
    assert!(!hidden.svg().contains(">name<"));
    assert_eq!(full.svg(), below.svg());
}

#[test]
fn panels_with_the_same_series_have_one_legend() {
    let svg = Panels::new(vec![example(50), example(50)]).svg();
    assert_eq!(svg.matches(">mean<").count(), 1);
}

#[test]
fn space_figure_is_drawn_from_all_sides() {
    let turn = |i: i32| {
        let t = f64::from(i) / 50.0;
        [t.cos(), t.sin(), 0.1 * t]
    };
    let points: Vec<_> = (0..500).map(turn).collect();
    let mut figure = SpaceFigure {
        series: vec![SpaceSeries::new("helix", points, Style::nth(1))],
        ..SpaceFigure::default()
    };
    for azimuth in [-135.0, -90.0, -55.0, 0.0, 45.0, 180.0] {
        figure.azimuth = azimuth;
        check(&figure.svg());
    }
    assert!(dark_share(&figure.png().expect("drawn")) > 0.002);
}

#[test]
fn widths_of_text_are_those_of_the_font() {
    assert!((text_width("0.50", 10.0) - 19.46).abs() < 0.01);
}
