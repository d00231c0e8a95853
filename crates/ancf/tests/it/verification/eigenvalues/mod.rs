//! Buckling loads, natural frequencies and whirls.

mod buckling;
mod clamped_bodies;
mod damped_modes;
mod fine_meshes;
mod timoshenko_modes;
mod vibration;
mod whirls;
