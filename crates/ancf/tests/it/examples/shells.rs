//! Annular plate and banner.

use crate::common::assertions::assert_near;
use crate::common::models::files::model;
use crate::common::solutions::Run;

/// Deflections 17.528 and 13.891 at the full load (Sze, Liu & Lo 2004, table 4).
#[test]
fn slit_annulus_becomes_a_ramp() {
    let run = Run::of(&model("annulus"));
    for (name, reference) in [("outer.y", 17.528), ("inner.y", 13.891)] {
        assert_near(name, *run.column(name).last().unwrap(), reference, 0.1);
    }
}

/// The sheet hardly stretches: the corner remains at the distance of the height from the rail, or nearer.
#[test]
fn banner_swings_about_its_rail() {
    let run = Run::of(&model("banner"));
    let (y, z) = (run.column("corner.y"), run.column("corner.z"));
    let distances: Vec<f64> = y.iter().zip(z).map(|(y, z)| y.hypot(*z)).collect();
    assert!(distances.iter().all(|distance| *distance < 1.02), "{distances:?}");
    assert!(y.iter().any(|y| *y > 0.5) && y.iter().any(|y| *y < -0.3));
}
