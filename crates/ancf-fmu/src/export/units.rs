use ancf::Column;
use ancf::units::{UnitQuantity, Units};

/// Unit of variables.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Unit {
    /// Name, such as `N mm`.
    pub(super) name: String,
    /// Unit in terms of the base units, if the names of length, time and force are among the known ones.
    pub(super) base: Option<BaseUnit>,
}

/// Powers of kg, m, s and rad, and the factor to them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct BaseUnit {
    pub(super) powers: [(&'static str, i32); 4],
    pub(super) factor: f64,
}

const LENGTHS: [(&str, f64); 6] =
    [("m", 1.0), ("mm", 1e-3), ("cm", 1e-2), ("km", 1e3), ("µm", 1e-6), ("um", 1e-6)];
const TIMES: [(&str, f64); 5] = [("s", 1.0), ("ms", 1e-3), ("µs", 1e-6), ("us", 1e-6), ("min", 60.0)];
const FORCES: [(&str, f64); 6] =
    [("N", 1.0), ("kN", 1e3), ("MN", 1e6), ("mN", 1e-3), ("µN", 1e-6), ("uN", 1e-6)];

/// Unit of a column; `None` for numbers without dimension, and if the model names no units.
pub(super) fn unit_of(column: &Column, units: Option<&Units>) -> Option<Unit> {
    let (units, dimension) = (units?, column.dimension?);
    let name = column.unit(units).filter(|name| name != "1")?;
    let factor = |table: &[(&str, f64)], name: &str| {
        table.iter().find(|(own, _)| *own == name).map(|(_, factor)| *factor)
    };
    let base = || {
        let [length, time, force] =
            [factor(&LENGTHS, &units.length)?, factor(&TIMES, &units.time)?, factor(&FORCES, &units.force)?];
        let (l, t, f) = (dimension.length, dimension.time, dimension.force);
        // N = kg m/s²
        let rad = i32::from(column.quantity == UnitQuantity::Angle);
        let powers = [("kg", f), ("m", l + f), ("s", t - 2 * f), ("rad", rad)];
        Some(BaseUnit { powers, factor: length.powi(l) * time.powi(t) * force.powi(f) })
    };
    Some(Unit { base: base(), name })
}
