//! Cross-sections: geometric constants, elastic laws and stress resultants.

mod cable_frame;
mod constants;
mod directors;
mod elasticity;
mod neo_hookean;
mod resultants;
mod section_forces;
mod section_frames;
mod stresses;
mod tapered;
