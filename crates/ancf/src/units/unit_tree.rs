/// Units of the keys of a type, nested like the type.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum UnitTree {
    /// No unit.
    None,
    /// Unit of a number or of all numbers of an array, such as `force/length^2`.
    Unit(&'static str),
    /// Units of the components of an array.
    Components(&'static [&'static str]),
    /// Keys of a table and their units.
    Keys(Vec<(&'static str, Self)>),
    /// Alternative forms of a value by name, in the order of the type.
    Forms(Vec<(&'static str, Self)>),
}
