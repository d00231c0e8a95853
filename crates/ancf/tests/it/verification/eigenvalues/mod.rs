//! Buckling loads and natural frequencies.

mod buckling;
mod damped_modes;
mod fine_meshes;
mod timoshenko_modes;
mod vibration;
