//! Kim et al. (2017), tables 3 and 6: units of the non-dimensional form.
//!
//! L = length of the beam, F = weight of one element, T = L √(ρA/F) (eq. 7), hence T = √(L n/g). The paper does not
//! define F; only this choice gives table 3.

use ancf::model::ScaleChoice;

use super::forms::non_dimensional_step;
use crate::common::models::rod;
use crate::common::solutions::Run;

/// Unit of time to all digits of table 3.
#[test]
fn time_of_table_3() {
    for (elements, printed) in
        [(1, "0.32"), (2, "0.45"), (5, "0.71"), (10, "1.01"), (15, "1.24"), (20, "1.43")]
    {
        let mut model = rod::cantilever(elements);
        model.scales = ScaleChoice::Paper;
        let scales = model.scales().scales;
        assert_eq!(format!("{:.2}", scales.time), printed, "{elements} elements");
        let closed = (rod::LENGTH * f64::from(elements) / rod::GRAVITY).sqrt();
        assert!((scales.time / closed - 1.0).abs() < 1e-15, "{elements} elements");
    }
}

/// Table 6: 2001 instants of the dimensional form, 6263 of the non-dimensional one, for 2 s in steps of 1 ms and 0.001 T.
///
/// 6263 follows from g = 9.806 m/s² (recovered from the table); 9.81 m/s² gives 6265.
#[test]
fn instants_of_table_6() {
    let instants = |gravity: f64| {
        let mut model = rod::revolute(1);
        model.gravity = [0.0, -gravity, 0.0];
        [model.clone(), non_dimensional_step(model)].map(|model| Run::of(&model).column("t").len())
    };
    assert_eq!(instants(9.806), [2001, 6263]);
    assert_eq!(instants(rod::GRAVITY), [2001, 6265]);
}
