//! Code of the implementation.

use proc_macro2::{Span, TokenStream};
use quote::{ToTokens, format_ident, quote, quote_spanned};
use syn::ext::IdentExt;
use syn::spanned::Spanned;
use syn::{Attribute, Data, DeriveInput, Fields, Ident, Variant};

use crate::attribute::FieldUnit;

/// The implementation of `Scaled` for a type.
pub(crate) fn scaled(input: &DeriveInput) -> syn::Result<TokenStream> {
    if !input.generics.params.is_empty() {
        return Err(syn::Error::new_spanned(&input.generics, "generic types are not supported"));
    }
    let name = &input.ident;
    let partial = is_partial(&input.attrs)?;
    let (conversion, units) = match &input.data {
        Data::Struct(data) => {
            let Form { pattern, value, units } = Form::new(&quote!(Self), &data.fields, partial)?;
            (quote!({ let #pattern = self; #value }), units)
        }
        Data::Enum(data) => of_enum(data.variants.iter(), partial)?,
        Data::Union(_) => return Err(syn::Error::new_spanned(name, "unions have no units")),
    };
    let scales = quote!(scales: &::ancf::units::Scales);
    Ok(if partial {
        quote! {
            #[automatically_derived]
            impl #name {
                /// Converts the keys whose units do not depend on other keys.
                pub(crate) fn scaled_keys(self, #scales) -> Self {
                    #conversion
                }

                /// Units of all keys.
                pub(crate) fn unit_tree() -> ::ancf::units::UnitTree {
                    #units
                }
            }
        }
    } else {
        quote! {
            #[automatically_derived]
            impl ::ancf::units::Scaled for #name {
                fn scaled(self, #scales) -> Self {
                    let _ = scales;
                    #conversion
                }

                fn unit_tree() -> ::ancf::units::UnitTree {
                    #units
                }
            }
        }
    })
}

/// True for a type with the attribute `#[unit(partial)]`.
fn is_partial(attributes: &[Attribute]) -> syn::Result<bool> {
    let mut partial = false;
    for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("unit")) {
        let word: Ident = attribute.parse_args()?;
        if word != "partial" {
            return Err(syn::Error::new_spanned(word, "a type has no unit, expected `partial`"));
        }
        partial = true;
    }
    Ok(partial)
}

/// Conversion and units of an enumeration.
fn of_enum<'a>(
    variants: impl Iterator<Item = &'a Variant>,
    partial: bool,
) -> syn::Result<(TokenStream, TokenStream)> {
    let (mut arms, mut forms) = (Vec::new(), Vec::new());
    for variant in variants {
        let (ident, word) = (&variant.ident, snake_case(&variant.ident));
        let Form { pattern, value, units } = Form::new(&quote!(Self::#ident), &variant.fields, partial)?;
        arms.push(quote!(#pattern => #value));
        forms.push(quote!((#word, #units)));
    }
    Ok((quote!(match self { #(#arms,)* }), quote!(::ancf::units::UnitTree::Forms(vec![#(#forms),*]))))
}

/// A struct or a variant.
struct Form {
    /// Pattern that binds all fields.
    pattern: TokenStream,
    /// The same form with converted fields.
    value: TokenStream,
    /// Units of the fields.
    units: TokenStream,
}

impl Form {
    fn new(path: &TokenStream, fields: &Fields, partial: bool) -> syn::Result<Self> {
        let (mut bindings, mut values, mut units) = (Vec::new(), Vec::new(), Vec::new());
        for (at, field) in fields.iter().enumerate() {
            let binding = format_ident!("field_{at}");
            let unit = FieldUnit::of(field)?;
            if unit == FieldUnit::Depends && !partial {
                return Err(syn::Error::new_spanned(
                    field,
                    "`depends` requires `#[unit(partial)]` of the type",
                ));
            }
            let (value, unit) = converted(&binding, &field.ty, &unit);
            bindings.push(binding);
            values.push(value);
            units.push(unit);
        }
        Ok(match fields {
            Fields::Named(fields) => {
                let names: Vec<_> = fields.named.iter().flat_map(|field| &field.ident).collect();
                let keys = names.iter().map(|name| name.unraw().to_string());
                Self {
                    pattern: quote!(#path { #(#names: #bindings),* }),
                    value: quote!(#path { #(#names: #values),* }),
                    units: quote!(::ancf::units::UnitTree::Keys(vec![#((#keys, #units)),*])),
                }
            }
            Fields::Unnamed(fields) if fields.unnamed.len() == 1 => Self {
                pattern: quote!(#path(#(#bindings),*)),
                value: quote!(#path(#(#values),*)),
                units: quote!(#(#units)*),
            },
            Fields::Unnamed(fields) => {
                return Err(syn::Error::new_spanned(fields, "tuples of several fields have no keys"));
            }
            Fields::Unit => Self {
                pattern: path.clone(),
                value: path.clone(),
                units: quote!(::ancf::units::UnitTree::None),
            },
        })
    }
}

/// Expressions of the converted value of a field and of its unit.
fn converted(name: &Ident, ty: &syn::Type, unit: &FieldUnit) -> (TokenStream, TokenStream) {
    // Errors point to the type, the code belongs to the macro.
    let span = ty.span().resolved_at(Span::call_site());
    match unit {
        FieldUnit::Nested => (
            quote_spanned!(span=> <#ty as ::ancf::units::Scaled>::scaled(#name, scales)),
            quote_spanned!(span=> <#ty as ::ancf::units::Scaled>::unit_tree()),
        ),
        FieldUnit::Unchanged | FieldUnit::Depends => {
            (name.to_token_stream(), quote!(::ancf::units::UnitTree::None))
        }
        FieldUnit::One(unit) => {
            let (text, dimension) = (&unit.text, unit.dimension());
            let value = if unit.is_number() {
                name.to_token_stream()
            } else {
                quote_spanned!(span=> <#ty as ::ancf::units::Convert>::converted(#name, #dimension, scales))
            };
            (value, quote!(::ancf::units::UnitTree::Unit(#text)))
        }
        FieldUnit::Components(units) => {
            let texts = units.iter().map(|unit| &unit.text);
            let dimensions = units.iter().map(crate::unit::Unit::dimension);
            let names: Vec<_> = (0..units.len()).map(|at| format_ident!("component_{at}")).collect();
            let value = quote_spanned!(span=> {
                let [#(#names),*] = #name;
                [#(::ancf::units::Convert::converted(#names, #dimensions, scales)),*]
            });
            (value, quote!(::ancf::units::UnitTree::Components(&[#(#texts),*])))
        }
    }
}

/// The word by which a variant is called in files.
fn snake_case(ident: &Ident) -> String {
    let mut word = String::new();
    for letter in ident.unraw().to_string().chars() {
        if letter.is_uppercase() && !word.is_empty() {
            word.push('_');
        }
        word.extend(letter.to_lowercase());
    }
    word
}

#[cfg(test)]
mod tests {
    use syn::parse_quote;

    use super::*;

    #[test]
    fn words_of_variants() {
        for (ident, word) in [("Clamp", "clamp"), ("PointOnLine", "point_on_line"), ("Hht", "hht")] {
            assert_eq!(snake_case(&format_ident!("{ident}")), word);
        }
    }

    #[test]
    fn unsupported_types_are_errors() {
        let inputs: [DeriveInput; 6] = [
            parse_quote!(
                struct Coupled {
                    #[unit(depends)]
                    factor: f64,
                }
            ),
            parse_quote!(
                #[unit(length)]
                struct Point {
                    #[unit(length)]
                    x: f64,
                }
            ),
            parse_quote!(
                struct Pair(#[unit(length)] f64, #[unit(time)] f64);
            ),
            parse_quote!(
                struct Any<T> {
                    x: T,
                }
            ),
            parse_quote!(union Bits { #[unit(length)] x: f64 }),
            parse_quote!(
                enum Load {
                    Force {
                        #[unit(newton)]
                        force: f64,
                    },
                }
            ),
        ];
        for input in inputs {
            assert!(scaled(&input).is_err(), "{}", input.to_token_stream());
        }
    }

    #[test]
    fn partial_types_do_not_implement_the_trait() {
        let model: DeriveInput = parse_quote! {
            #[unit(partial)]
            struct Model { #[unit(length)] size: f64, #[unit(depends)] couplings: Vec<Coupling> }
        };
        let code = scaled(&model).unwrap().to_string();
        assert!(code.contains("impl Model { # [doc = r\" Converts"), "{code}");
        assert!(code.contains("couplings : field_1"), "{code}");
    }

    #[test]
    fn structs_and_enums_are_expanded() {
        let spring: DeriveInput = parse_quote! {
            struct Spring { #[unit(force / length)] stiffness: f64, place: Place, #[unit(none)] axis: [f64; 3] }
        };
        let code = scaled(&spring).unwrap().to_string();
        assert!(code.contains("Dimension :: new (- 1i32 , 0i32 , 1i32)"), "{code}");
        assert!(
            code.contains("< Place as :: ancf :: units :: Scaled > :: scaled (field_1 , scales)"),
            "{code}"
        );
        assert!(code.contains("axis : field_2"), "{code}");
        let at: DeriveInput = parse_quote!(
            enum At {
                Named(Named),
                Length(#[unit(length)] f64),
                Start,
            }
        );
        let code = scaled(&at).unwrap().to_string();
        assert!(code.contains("(\"length\" , :: ancf :: units :: UnitTree :: Unit (\"length\"))"), "{code}");
        assert!(code.contains("Self :: Start => Self :: Start"), "{code}");
    }
}
