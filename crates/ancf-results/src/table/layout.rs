use std::sync::Arc;

use parquet::basic::{ConvertedType, LogicalType, Repetition, Type as Physical};
use parquet::errors::Result;
use parquet::schema::types::{Type, TypePtr};

/// Columns of a table in double precision: numbers, then lists of fixed length. A row contains all columns in this order.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Layout {
    /// Names of the numbers.
    pub(crate) numbers: Vec<String>,
    /// Names and lengths of the lists, without empty lists.
    pub(crate) lists: Vec<(String, usize)>,
}

impl Layout {
    pub(crate) fn new(numbers: Vec<String>, lists: Vec<(String, usize)>) -> Self {
        Self { numbers, lists: lists.into_iter().filter(|(_, length)| *length > 0).collect() }
    }

    /// Number of values in a row.
    pub(crate) fn width(&self) -> usize {
        self.numbers.len() + self.lists.iter().map(|(_, length)| length).sum::<usize>()
    }

    /// Position of each column in a row, and its length if the column is a list.
    pub(crate) fn columns(&self) -> impl Iterator<Item = (usize, Option<usize>)> {
        let lists = self.lists.iter().scan(self.numbers.len(), |next, (_, length)| {
            *next += length;
            Some((*next - length, Some(*length)))
        });
        (0..self.numbers.len()).map(|place| (place, None)).chain(lists)
    }

    /// Schema of the Parquet file.
    pub(crate) fn schema(&self) -> Result<TypePtr> {
        let numbers = self.numbers.iter().map(|name| double(name));
        let lists = self.lists.iter().map(|(name, _)| list(name));
        let fields = numbers.chain(lists).collect::<Result<Vec<_>>>()?;
        Ok(Arc::new(Type::group_type_builder("run").with_fields(fields).build()?))
    }
}

fn double(name: &str) -> Result<TypePtr> {
    let field = Type::primitive_type_builder(name, Physical::DOUBLE).with_repetition(Repetition::REQUIRED);
    Ok(Arc::new(field.build()?))
}

fn list(name: &str) -> Result<TypePtr> {
    let element = Type::group_type_builder("list").with_repetition(Repetition::REPEATED);
    let element = element.with_fields(vec![double("element")?]).build()?;
    let list = Type::group_type_builder(name).with_repetition(Repetition::REQUIRED);
    let list = list.with_logical_type(Some(LogicalType::List)).with_converted_type(ConvertedType::LIST);
    Ok(Arc::new(list.with_fields(vec![Arc::new(element)]).build()?))
}
