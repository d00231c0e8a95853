//! Derive macro for the units of the model types of crate `ancf`.

mod attribute;
mod expand;
mod unit;

use proc_macro::TokenStream;
use syn::{DeriveInput, parse_macro_input};

/// Implements `ancf::units::Scaled`: conversion of all fields to other units, and the unit of each key as data.
///
/// Each field of type `f64`, or of an array, `Option` or `Vec` of it, states its unit:
///
/// | attribute | meaning |
/// |---|---|
/// | `#[unit(force / length^2)]` | product of powers of base quantities |
/// | `#[unit([force / length; 3], [force * length; 3])]` | one unit for each component of an array |
/// | `#[unit(number)]` | pure number, not converted |
/// | `#[unit(none)]` | no quantity, such as a direction or a function, not converted |
/// | `#[unit(depends)]` | unit that depends on other keys, converted by a hand-written function |
///
/// Base quantities are `length`, `time`, `force`, `mass` (force time²/length), and `radian` and `cycle`, which are numbers.
/// A type with `depends` fields states `#[unit(partial)]`. It does not implement the trait: the macro then makes functions
/// `scaled_keys` and `unit_tree` of the crate, to be used by the hand-written conversion of the whole.
///
/// Fields without the attribute are converted by their own implementation of `Scaled`. Numbers have none, so that a number
/// without a unit does not compile:
///
/// ```
/// # extern crate self as ancf;
/// # mod units {
/// #     pub struct Scales;
/// #     #[derive(Debug, PartialEq)]
/// #     pub struct Dimension(pub [i32; 3]);
/// #     impl Dimension {
/// #         pub const fn new(length: i32, time: i32, force: i32) -> Self { Self([length, time, force]) }
/// #     }
/// #     pub enum UnitTree {
/// #         None,
/// #         Unit(&'static str),
/// #         Components(&'static [&'static str]),
/// #         Keys(Vec<(&'static str, UnitTree)>),
/// #         Forms(Vec<(&'static str, UnitTree)>),
/// #     }
/// #     pub trait Scaled { fn scaled(self, scales: &Scales) -> Self; fn unit_tree() -> UnitTree; }
/// #     pub trait Convert { fn converted(self, unit: Dimension, scales: &Scales) -> Self; }
/// #     impl Convert for f64 {
/// #         fn converted(self, unit: Dimension, _: &Scales) -> Self {
/// #             self / 2_f64.powi(unit.0[0]) / 3_f64.powi(unit.0[1]) / 5_f64.powi(unit.0[2])
/// #         }
/// #     }
/// # }
/// use ancf_derive::Scaled;
/// # use units::{Scaled, Scales};
///
/// #[derive(Scaled)]
/// struct Spring {
///     #[unit(force / length)]
///     stiffness: f64,
///     #[unit([length; 2], [number])]
///     data: [f64; 3],
/// }
/// # fn main() {
/// let spring = Spring { stiffness: 5.0, data: [2.0, 4.0, 6.0] }.scaled(&Scales);
/// assert_eq!(spring.stiffness, 2.0);
/// assert_eq!(spring.data, [1.0, 2.0, 6.0]);
/// # }
/// ```
///
/// ```compile_fail,E0277
/// # extern crate self as ancf;
/// # mod units {
/// #     pub struct Scales;
/// #     pub enum UnitTree { Keys(Vec<(&'static str, UnitTree)>) }
/// #     pub trait Scaled { fn scaled(self, scales: &Scales) -> Self; fn unit_tree() -> UnitTree; }
/// # }
/// #[derive(ancf_derive::Scaled)]
/// struct Spring {
///     stiffness: f64, // No unit.
/// }
/// # fn main() {}
/// ```
#[proc_macro_derive(Scaled, attributes(unit))]
pub fn scaled(input: TokenStream) -> TokenStream {
    let input = parse_macro_input!(input as DeriveInput);
    expand::scaled(&input).unwrap_or_else(|error| error.to_compile_error()).into()
}
