//! Selection of frames for ParaView.

use ancf_report::paraview::FrameSelection;

#[test]
fn selections_are_ranges_and_evenly_thinned() {
    let values: Vec<f64> = (0..=100).map(f64::from).collect();
    let all = FrameSelection::default();
    assert_eq!(all.pick(&values).len(), 101);
    assert_eq!(FrameSelection { most: 5, ..all }.pick(&values), [0, 25, 50, 75, 100]);
    assert_eq!(FrameSelection { from: 10.0, to: 12.0, ..all }.pick(&values), [10, 11, 12]);
    assert_eq!(FrameSelection { from: 10.0, to: 50.0, most: 2 }.pick(&values), [10, 50]);
    assert!(FrameSelection { from: 200.0, ..all }.pick(&values).is_empty());
}
