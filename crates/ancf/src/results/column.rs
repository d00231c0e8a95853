use crate::units::{Dimension, UnitQuantity, Units};

/// Column of a run.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Column {
    /// Name.
    pub name: String,
    /// Dimension of the values; `None` if they are not in the user's units, such as a residual.
    pub dimension: Option<Dimension>,
    /// Quantity with a unit name of its own.
    pub quantity: UnitQuantity,
}

impl Column {
    pub(crate) fn new(name: impl Into<String>, dimension: impl Into<Option<Dimension>>) -> Self {
        Self { name: name.into(), dimension: dimension.into(), quantity: UnitQuantity::Other }
    }

    pub(crate) fn with_quantity(self, quantity: UnitQuantity) -> Self {
        Self { quantity, ..self }
    }

    /// Unit of the values, `1` for numbers without dimension; `None` if they are not in the user's units.
    pub fn unit(&self, units: &Units) -> Option<String> {
        let unit = units.of_quantity(self.dimension?, self.quantity);
        Some(if unit.is_empty() { "1".to_owned() } else { unit })
    }

    /// Columns with the prefix `owner`.
    pub(super) fn of<'a>(
        owner: &str,
        names: impl IntoIterator<Item = &'a str>,
        dimension: Dimension,
    ) -> Vec<Self> {
        names.into_iter().map(|name| Self::new(format!("{owner}.{name}"), dimension)).collect()
    }
}
