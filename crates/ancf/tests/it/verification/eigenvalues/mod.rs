//! Buckling loads and natural frequencies.

mod buckling;
mod fine_meshes;
mod timoshenko_modes;
mod vibration;
