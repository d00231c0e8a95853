use std::fmt::Write;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::scales::Dimension;
use crate::units::Scaled;

/// Names of the units of a model, for axes, legends and result files. Nothing is converted.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema, Scaled)]
#[serde(deny_unknown_fields)]
pub struct Units {
    /// Name of the unit of length, such as `"m"`.
    #[schemars(length(min = 1))]
    pub length: String,
    /// Name of the unit of time, such as `"s"`.
    #[schemars(length(min = 1))]
    pub time: String,
    /// Name of the unit of force, such as `"N"`.
    #[schemars(length(min = 1))]
    pub force: String,
}

/// Quantity whose unit has a name of its own.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum UnitQuantity {
    /// Any other quantity.
    #[default]
    Other,
    /// Energy or work: J for N m.
    Energy,
    /// Power: W for N m/s.
    Power,
    /// Angle or angular velocity: rad for a number.
    Angle,
    /// Frequency: Hz for 1/s.
    Frequency,
}

impl Units {
    /// Name of the unit of a quantity with a dimension, such as `J` or `rad/s`; empty for a number.
    pub fn of_quantity(&self, dimension: Dimension, quantity: UnitQuantity) -> String {
        let unit = self.of(dimension);
        match (quantity, unit.as_str()) {
            (UnitQuantity::Energy, "N m") => "J".to_owned(),
            (UnitQuantity::Power, "N m/s") => "W".to_owned(),
            (UnitQuantity::Frequency, "1/s") => "Hz".to_owned(),
            (UnitQuantity::Angle, rate) => format!("rad{}", rate.trim_start_matches('1')),
            _ => unit,
        }
    }

    /// Names of the quantities: `length`, `time`, `force`.
    pub fn in_words() -> Self {
        let [length, time, force] = ["length", "time", "force"].map(str::to_owned);
        Self { length, time, force }
    }

    /// Name of the unit of a dimension, such as `N/m²`; empty for a number.
    pub fn of(&self, dimension: Dimension) -> String {
        let Dimension { length, time, force } = dimension;
        let powers = [(&self.force, force), (&self.length, length), (&self.time, time)];
        let product = |sign: i32| {
            let factors = powers.iter().filter(|(_, power)| power * sign > 0);
            factors.map(|(unit, power)| power_of(unit, power.unsigned_abs())).collect::<Vec<_>>()
        };
        let (above, below) = (product(1), product(-1));
        let mut text = if above.is_empty() && !below.is_empty() { "1".to_owned() } else { above.join(" ") };
        let (open, close) = if below.len() > 1 { ("(", ")") } else { ("", "") };
        if !below.is_empty() {
            write!(text, "/{open}{}{close}", below.join(" ")).expect("a String takes any text");
        }
        text
    }
}

fn power_of(unit: &str, power: u32) -> String {
    match power {
        1 => unit.to_owned(),
        2 => format!("{unit}²"),
        3 => format!("{unit}³"),
        4 => format!("{unit}⁴"),
        _ => format!("{unit}^{power}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_read_as_engineers_write_them() {
        let [length, time, force] = ["mm", "s", "N"].map(str::to_owned);
        let units = Units { length, time, force };
        for (dimension, text) in [
            (Dimension::NUMBER, ""),
            (Dimension::LENGTH, "mm"),
            (Dimension::ACCELERATION, "mm/s²"),
            (Dimension::RATE, "1/s"),
            (Dimension::ENERGY, "N mm"),
            (Dimension::STRESS, "N/mm²"),
            (Dimension::DENSITY, "N s²/mm⁴"),
            (Dimension::new(-1, -1, 1), "N/(mm s)"),
            (Dimension::new(12, 0, 0), "mm^12"),
        ] {
            assert_eq!(units.of(dimension), text);
        }
        assert_eq!(Units::in_words().of(Dimension::VELOCITY), "length/time");
        let length = "m".to_owned();
        let si = Units { length, ..units.clone() };
        for (units, dimension, quantity, text) in [
            (&si, Dimension::ENERGY, UnitQuantity::Energy, "J"),
            (&si, Dimension::ENERGY, UnitQuantity::Other, "N m"),
            (&units, Dimension::ENERGY, UnitQuantity::Energy, "N mm"),
            (&si, Dimension::NUMBER, UnitQuantity::Angle, "rad"),
            (&si, Dimension::RATE, UnitQuantity::Angle, "rad/s"),
            (&si, Dimension::RATE, UnitQuantity::Frequency, "Hz"),
            (&Units::in_words(), Dimension::RATE, UnitQuantity::Frequency, "1/time"),
        ] {
            assert_eq!(units.of_quantity(dimension, quantity), text);
        }
    }
}
