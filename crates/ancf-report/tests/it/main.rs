//! Tests of scenes, pages, the server and ParaView files.
#![cfg(test)]

mod common;
mod every_model;
mod model_shapes;
mod outlines;
mod page;
mod paraview;
mod paraview_rates;
mod paraview_selection;
mod scene;
mod server;
mod shapes;
mod shells;
mod stresses;
mod surfaces;
mod whirls;
