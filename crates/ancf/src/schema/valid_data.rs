//! Fast check whether data satisfy a schema, without messages.

use std::collections::{BTreeMap, HashMap};
use std::rc::Rc;

use serde_json::Value as Json;
use toml::{Table, Value};

use super::generate::{allows, forms, is_free, kind, required, tag};

/// Form of a value with the parts of its schema that restrict data.
#[derive(Debug)]
enum Form {
    Free,
    Table(TableForm),
    /// Tables with any keys and values of this schema.
    Map(&'static Json),
    /// Items, and their least and largest number.
    Array(&'static Json, usize, usize),
    /// A number within the limits of the schema. The flag is true for integers.
    Number(&'static Json, bool),
    Boolean,
    /// Text with this value, or with at least this length.
    Word(&'static str),
    Text(usize),
}

#[derive(Debug)]
struct TableForm {
    properties: BTreeMap<&'static str, &'static Json>,
    required: Vec<&'static str>,
    /// Key that distinguishes the forms, and its value.
    tag: Option<(&'static str, &'static str)>,
}

/// Forms of the schemas so far, by the address of the schema.
#[derive(Debug, Default)]
pub(super) struct ValidData {
    forms: HashMap<*const Json, Rc<[Form]>>,
}

impl ValidData {
    /// True if data satisfy a schema: the check with messages has no findings and does not change the data.
    pub(super) fn holds(&mut self, schema: &'static Json, value: &Value) -> bool {
        let of_schema = || forms(schema).into_iter().map(Form::new).collect();
        let forms = Rc::clone(self.forms.entry(schema).or_insert_with(of_schema));
        if forms.iter().any(|form| matches!(form, Form::Free)) {
            return true;
        }
        match value {
            Value::Table(table) => self.table(&forms, table),
            Value::Array(items) => self.array(&forms, items),
            Value::Integer(n) => number(&forms, *n as f64, true),
            Value::Float(x) => number(&forms, *x, false),
            Value::Boolean(_) => forms.iter().any(|form| matches!(form, Form::Boolean)),
            Value::String(text) => forms.iter().any(|form| match form {
                Form::Word(word) => word == text,
                Form::Text(least) => text.len() >= *least,
                _ => false,
            }),
            Value::Datetime(_) => false,
        }
    }

    fn table(&mut self, forms: &[Form], table: &Table) -> bool {
        let of_table = |form: &&Form| matches!(form, Form::Table(_) | Form::Map(_));
        if let Some(Form::Map(schema)) = forms.iter().find(of_table) {
            return table.values().all(|value| self.holds(schema, value));
        }
        let is_meant = |form: &&TableForm| match form.tag {
            Some((key, word)) => table.get(key).and_then(Value::as_str) == Some(word),
            None => table.keys().all(|key| form.properties.contains_key(&**key)),
        };
        let mut tables =
            forms.iter().filter_map(|form| if let Form::Table(own) = form { Some(own) } else { None });
        let Some(form) = tables.find(is_meant) else { return false };
        let has_required = form.required.iter().all(|key| table.contains_key(*key));
        has_required
            && table.iter().all(|(key, value)| match form.properties.get(&**key) {
                Some(_) if form.tag.is_some_and(|(tag, _)| tag == key) => true,
                Some(schema) => self.holds(schema, value),
                None => false,
            })
    }

    fn array(&mut self, forms: &[Form], items: &[Value]) -> bool {
        let fits = |form: &Form| match form {
            Form::Array(items_of, min, max) if (*min..=*max).contains(&items.len()) => Some(*items_of),
            _ => None,
        };
        let Some(schema) = forms.iter().find_map(fits) else { return false };
        items.iter().all(|item| self.holds(schema, item))
    }
}

impl Form {
    fn new(form: &'static Json) -> Self {
        let count = |key: &str| form[key].as_u64().and_then(|count| usize::try_from(count).ok());
        match kind(form) {
            _ if is_free(form) => Self::Free,
            "object" if form["additionalProperties"].is_object() => Self::Map(&form["additionalProperties"]),
            "object" => {
                let properties = form["properties"].as_object().into_iter().flatten();
                Self::Table(TableForm {
                    properties: properties.map(|(key, schema)| (&**key, schema)).collect(),
                    required: required(form).collect(),
                    tag: tag(form),
                })
            }
            "array" => Self::Array(
                &form["items"],
                count("minItems").unwrap_or(0),
                count("maxItems").unwrap_or(usize::MAX),
            ),
            "boolean" => Self::Boolean,
            "number" => Self::Number(form, false),
            "integer" => Self::Number(form, true),
            _ => match form["const"].as_str() {
                Some(word) => Self::Word(word),
                None => Self::Text(count("minLength").unwrap_or(0)),
            },
        }
    }
}

/// True if the first form of a number allows it.
fn number(forms: &[Form], x: f64, is_integer: bool) -> bool {
    let of_number = |form: &Form| match *form {
        Form::Number(schema, for_integers) => Some((is_integer || !for_integers) && allows(schema, x)),
        _ => None,
    };
    forms.iter().find_map(of_number).unwrap_or(false)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;
    use crate::schema::{Document, SCHEMA, SchemaCheck};

    /// True if data satisfy the schema. The checks with and without messages must agree.
    fn is_valid(data: &Table) -> bool {
        let data = Value::Table(data.clone());
        let (check, corrected) = SchemaCheck::with_messages(&SCHEMA, &data);
        let is_valid = ValidData::default().holds(&SCHEMA, &data);
        assert_eq!(is_valid, check.findings.is_empty(), "{:?}\n{data}", check.findings);
        assert!(!is_valid || corrected == data, "{data}");
        is_valid
    }

    /// Changes the leaf or table number `n` of a value; false if there are less.
    fn change(value: &mut Value, n: &mut usize, to: Option<&Value>) -> bool {
        match value {
            Value::Table(table) => {
                let keys: Vec<String> = table.keys().cloned().collect();
                for key in keys {
                    if *n == 0 {
                        match to {
                            Some(to) => _ = table.insert(key, to.clone()),
                            None => _ = table.remove(&key),
                        }
                        return true;
                    }
                    *n -= 1;
                    if change(&mut table[&key], n, to) {
                        return true;
                    }
                }
                false
            }
            Value::Array(items) => items.iter_mut().any(|item| change(item, n, to)),
            _ => false,
        }
    }

    #[test]
    fn both_checks_agree_for_valid_and_changed_models() {
        let root = env!("CARGO_MANIFEST_DIR");
        let (mut valid, mut invalid) = (0, 0);
        for folder in ["../../models", "tests/models/good", "tests/models/bad"] {
            let files = fs::read_dir(format!("{root}/{folder}")).unwrap().map(|file| file.unwrap().path());
            for path in files.filter(|path| path.extension().is_some_and(|end| end == "toml")) {
                let Ok(text) = fs::read_to_string(&path) else { continue };
                let data = Document::parse(&text).data;
                let mut count = |data: &Table| *if is_valid(data) { &mut valid } else { &mut invalid } += 1;
                count(&data);
                let changes =
                    [None, Some((-1).into()), Some(0.5.into()), Some("x".into()), Some(Table::new().into())];
                for to in changes {
                    for n in 0.. {
                        let mut changed = Value::Table(data.clone());
                        if !change(&mut changed, &mut n.clone(), to.as_ref()) {
                            break;
                        }
                        count(changed.as_table().unwrap());
                    }
                }
            }
        }
        assert!(valid > 1000 && invalid > 1000, "{valid} and {invalid}");
    }
}
