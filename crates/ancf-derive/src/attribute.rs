//! The attribute `#[unit(..)]` of a field.

use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Field, Ident, LitInt, Token, bracketed, token};

use crate::unit::Unit;

/// Unit that a field states.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum FieldUnit {
    /// No attribute: the field has its own conversion.
    Nested,
    /// Nothing to convert.
    Unchanged,
    /// Unit that depends on other keys.
    Depends,
    /// One unit for the field.
    One(Unit),
    /// One unit for each component.
    Components(Vec<Unit>),
}

impl FieldUnit {
    /// Reads the attribute of a field.
    pub(crate) fn of(field: &Field) -> syn::Result<Self> {
        let mut attributes = field.attrs.iter().filter(|attribute| attribute.path().is_ident("unit"));
        let Some(attribute) = attributes.next() else { return Ok(Self::Nested) };
        if let Some(second) = attributes.next() {
            return Err(syn::Error::new_spanned(second, "a field has one unit"));
        }
        attribute.parse_args()
    }
}

impl Parse for FieldUnit {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        if input.peek(token::Bracket) {
            let groups = Punctuated::<Group, Token![,]>::parse_terminated(input)?;
            return Ok(Self::Components(groups.into_iter().flat_map(|group| group.0).collect()));
        }
        let word: Option<Ident> = input.fork().parse().ok();
        for (name, unit) in [("none", Self::Unchanged), ("depends", Self::Depends)] {
            if word.as_ref().is_some_and(|word| word == name) {
                input.parse::<Ident>()?;
                return Ok(unit);
            }
        }
        let unit: Unit = input.parse()?;
        Ok(if unit.text == "number" { Self::Unchanged } else { Self::One(unit) })
    }
}

/// `[unit; count]` or `[unit]`.
struct Group(Vec<Unit>);

impl Parse for Group {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let content;
        bracketed!(content in input);
        let unit: Unit = content.parse()?;
        let count = match content.parse::<Option<Token![;]>>()? {
            Some(_) => content.parse::<LitInt>()?.base10_parse()?,
            None => 1,
        };
        if content.is_empty() { Ok(Self(vec![unit; count])) } else { Err(content.error("expected `]`")) }
    }
}

#[cfg(test)]
mod tests {
    use syn::parse_quote;

    use super::*;

    fn texts(unit: FieldUnit) -> Vec<String> {
        match unit {
            FieldUnit::Nested | FieldUnit::Unchanged | FieldUnit::Depends => Vec::new(),
            FieldUnit::One(unit) => vec![unit.text],
            FieldUnit::Components(units) => units.into_iter().map(|unit| unit.text).collect(),
        }
    }

    #[test]
    fn forms_of_the_attribute() {
        for word in ["number", "none"] {
            assert_eq!(syn::parse_str::<FieldUnit>(word).unwrap(), FieldUnit::Unchanged);
        }
        assert_eq!(syn::parse_str::<FieldUnit>("depends").unwrap(), FieldUnit::Depends);
        assert_eq!(texts(parse_quote!(force / length)), ["force/length"]);
        let six: FieldUnit = parse_quote!([force / length; 2], [number], [force * length; 3]);
        let moment = "force*length";
        assert_eq!(texts(six), ["force/length", "force/length", "number", moment, moment, moment]);
        for text in ["none length", "[length; x]", "[length, time]", "length, time", "[]", ""] {
            assert!(syn::parse_str::<FieldUnit>(text).is_err(), "{text}");
        }
    }

    #[test]
    fn attributes_of_fields() {
        assert_eq!(FieldUnit::of(&parse_quote!(pub on: Place)).unwrap(), FieldUnit::Nested);
        assert_eq!(
            texts(FieldUnit::of(&parse_quote!(#[serde(default)] #[unit(time)] t: f64)).unwrap()),
            ["time"]
        );
        assert!(FieldUnit::of(&parse_quote!(#[unit(time)] #[unit(length)] t: f64)).is_err());
        assert!(FieldUnit::of(&parse_quote!(#[unit] t: f64)).is_err());
    }
}
