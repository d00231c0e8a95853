//! Types of the columns of parameters.

use toml::Value;

/// Type of the column of a parameter: the common type of all its values, or text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ParameterType {
    /// 64-bit integers.
    Integer,
    /// Double-precision numbers.
    Number,
    /// Truth values.
    Boolean,
    /// Text.
    Text,
}

impl ParameterType {
    /// Returns the type of the column of values.
    pub fn of(values: &[Value]) -> Self {
        let all = |test: fn(&Value) -> bool| values.iter().all(test);
        if all(Value::is_integer) {
            Self::Integer
        } else if all(|value| value.is_integer() || value.is_float()) {
            Self::Number
        } else if all(Value::is_bool) {
            Self::Boolean
        } else {
            Self::Text
        }
    }

    /// Returns the name of the type in Arrow.
    pub const fn arrow_name(self) -> &'static str {
        match self {
            Self::Integer => "int64",
            Self::Number => "double",
            Self::Boolean => "bool",
            Self::Text => "string",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_common_type_of_values() {
        let (one, half, yes) = (Value::Integer(1), Value::Float(0.5), Value::Boolean(true));
        for (values, expected) in [
            (vec![one.clone()], ParameterType::Integer),
            (vec![one.clone(), half.clone()], ParameterType::Number),
            (vec![yes.clone()], ParameterType::Boolean),
            (vec![yes, half], ParameterType::Text),
            (vec![Value::Array(vec![one])], ParameterType::Text),
        ] {
            assert_eq!(ParameterType::of(&values), expected, "{values:?}");
        }
    }
}
