use std::collections::BTreeMap;

use super::scales::Scales;
use super::unit_tree::UnitTree;

/// Types of the model that can be converted to other units; implemented by `#[derive(Scaled)]`.
///
/// Numbers do not implement it: they state their dimension by the attribute `#[unit(..)]`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no unit",
    note = "numbers state a unit: `#[unit(force / length)]`, `#[unit(number)]`; other types derive `Scaled`"
)]
pub trait Scaled: Sized {
    /// Converts all quantities into the units of `scales`.
    fn scaled(self, scales: &Scales) -> Self;

    /// Units of all keys.
    fn unit_tree() -> UnitTree {
        UnitTree::None
    }
}

impl<T: Scaled> Scaled for Option<T> {
    fn scaled(self, scales: &Scales) -> Self {
        self.map(|x| x.scaled(scales))
    }

    fn unit_tree() -> UnitTree {
        T::unit_tree()
    }
}

impl<T: Scaled> Scaled for Vec<T> {
    fn scaled(self, scales: &Scales) -> Self {
        self.into_iter().map(|x| x.scaled(scales)).collect()
    }

    fn unit_tree() -> UnitTree {
        T::unit_tree()
    }
}

impl<T: Scaled> Scaled for BTreeMap<String, T> {
    fn scaled(self, scales: &Scales) -> Self {
        self.into_iter().map(|(name, x)| (name, x.scaled(scales))).collect()
    }

    fn unit_tree() -> UnitTree {
        T::unit_tree()
    }
}

impl Scaled for String {
    fn scaled(self, _: &Scales) -> Self {
        self
    }
}

impl Scaled for bool {
    fn scaled(self, _: &Scales) -> Self {
        self
    }
}

impl Scaled for u32 {
    fn scaled(self, _: &Scales) -> Self {
        self
    }
}

/// Units of the model, expressed in the units of another program.
impl Scaled for Scales {
    fn scaled(self, scales: &Scales) -> Self {
        self.then(scales)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use ancf_derive::Scaled;

    use super::super::convert::Convert;
    use super::super::scales::Dimension;

    #[derive(Clone, Debug, PartialEq, Scaled)]
    struct Mount {
        name: String,
        #[unit([force / length; 3], [force * length; 3])]
        stiffness: [f64; 6],
        #[unit(time)]
        times: Vec<f64>,
        #[unit(radian)]
        angle: f64,
        part: Option<Part>,
    }

    #[derive(Clone, Debug, PartialEq, Scaled)]
    enum Part {
        Absent,
        Weight {
            #[unit(mass)]
            mass: f64,
            #[unit(none)]
            axis: [f64; 3],
        },
        RestLength(#[unit(length)] Option<f64>),
    }

    const SCALES: Scales = Scales { length: 2.0, time: 4.0, force: 8.0 };

    fn mount(part: Part) -> Mount {
        let (stiffness, times) = ([1.0, 2.0, 3.0, 4.0, 5.0, 6.0], vec![0.0, 1.0]);
        Mount { name: "mount".into(), stiffness, times, angle: 0.5, part: Some(part) }
    }

    #[test]
    fn fields_are_converted_by_their_units() {
        let scaled = mount(Part::Weight { mass: 64.0, axis: [1.0, 0.0, 0.0] }).scaled(&SCALES);
        assert_eq!(scaled.stiffness, [0.25, 0.5, 0.75, 0.25, 0.3125, 0.375]);
        assert_eq!((scaled.times, scaled.angle), (vec![0.0, 0.25], 0.5));
        assert_eq!(scaled.part, Some(Part::Weight { mass: 1.0, axis: [1.0, 0.0, 0.0] }));
        for part in [Part::Absent, Part::RestLength(None), Part::RestLength(Some(3.0))] {
            let own = mount(part);
            assert_eq!(own.clone().scaled(&SCALES).scaled(&SCALES.inverse()), own);
        }
        let rest = Part::RestLength(Some(3.0)).scaled(&SCALES);
        assert_eq!(rest, Part::RestLength(Some(1.5)));
        assert_eq!(Some(3.0).converted(Dimension::LENGTH, &SCALES), Some(1.5));
    }

    #[test]
    fn units_are_data() {
        let UnitTree::Keys(keys) = Mount::unit_tree() else { panic!("a struct has keys") };
        let (names, units): (Vec<_>, Vec<_>) = keys.into_iter().unzip();
        assert_eq!(names, ["name", "stiffness", "times", "angle", "part"]);
        const UNITS: [&str; 6] =
            ["force/length", "force/length", "force/length", "force*length", "force*length", "force*length"];
        assert_eq!(units[1], UnitTree::Components(&UNITS));
        assert_eq!((&units[2], &units[3]), (&UnitTree::Unit("time"), &UnitTree::Unit("radian")));
        let UnitTree::Forms(forms) = &units[4] else { panic!("an enum has forms") };
        assert_eq!(forms[0], ("absent", UnitTree::None));
        let weight = UnitTree::Keys(vec![("mass", UnitTree::Unit("mass")), ("axis", UnitTree::None)]);
        assert_eq!(forms[1], ("weight", weight));
        assert_eq!(forms[2], ("rest_length", UnitTree::Unit("length")));
    }
}
