/// Units of the keys of a type, nested as the type is.
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
    /// Forms of which a value has one, in the order of the type, by name.
    Forms(Vec<(&'static str, Self)>),
}
