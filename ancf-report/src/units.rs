use ancf::scales::Dimension;

/// Names of the user's units, such as m, s, N. They are words on axes: no number depends on them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct UnitNames {
    /// Unit of length.
    pub length: String,
    /// Unit of time.
    pub time: String,
    /// Unit of force.
    pub force: String,
}

impl UnitNames {
    /// The unit of a quantity: "N m", "m/s²", "1/s", "N s²/m⁴"; nothing for a pure number.
    pub fn of(&self, dimension: Dimension) -> String {
        let powers =
            [(&self.force, dimension.force), (&self.length, dimension.length), (&self.time, dimension.time)];
        let part = |sign: i32| {
            let parts = powers.iter().filter(|(_, power)| power * sign > 0);
            parts.map(|(name, power)| format!("{name}{}", exponent(power.abs()))).collect::<Vec<_>>()
        };
        let (above, below) = (part(1), part(-1));
        let above = if above.is_empty() && !below.is_empty() { "1".to_owned() } else { above.join(" ") };
        match below.as_slice() {
            [] => above,
            [one] => format!("{above}/{one}"),
            several => format!("{above}/({})", several.join(" ")),
        }
    }
}

/// A power as it is written behind a unit; none for 1.
fn exponent(power: i32) -> String {
    let raised = |digit: char| digit.to_digit(10).map_or(digit, |d| RAISED[d as usize]);
    if power == 1 { String::new() } else { power.to_string().chars().map(raised).collect() }
}

const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
