//! Cross-sections: constants, elastic laws and stress resultants.

mod constants;
mod elasticity;
mod neo_hookean;
mod resultants;
