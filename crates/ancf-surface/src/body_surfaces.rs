//! Surfaces of the rigid bodies of a model.

use std::io;
use std::path::Path;
use std::sync::Arc;

use ancf::Model;
use ancf::model::{Body, BodySurface, DisplayShape, ModelError, ModelErrors, Rigid};
use nalgebra::{Rotation3, Vector3};

use crate::files::{read_mesh, to_stl};
use crate::mesh::Triangles;
use crate::shapes::{cuboid, cylinder, sphere};

/// Surfaces of the rigid bodies of a model that have display shapes or a contact surface.
///
/// Points are relative to the centre of mass, in the axes of the body, which are the global axes in the initial state. The unit
/// of length is that of the model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BodySurfaces {
    bodies: Vec<Option<Surface>>,
}

#[derive(Clone, Debug, PartialEq)]
struct Surface {
    triangles: Arc<Triangles>,
    /// True if a part is from a file.
    has_mesh: bool,
}

/// Folder with the surfaces inside a results folder.
const FOLDER: &str = "display";

impl BodySurfaces {
    /// Computes the surfaces of a model. Mesh files are relative to `folder`.
    ///
    /// # Errors
    /// One error for each file that cannot be read.
    pub fn read(model: &Model, folder: &Path) -> Result<Self, ModelErrors> {
        let mut errors = Vec::new();
        let mut surface = |(number, body): (usize, &Body)| {
            let mut read = |k: usize, file: &str| {
                read_mesh(&folder.join(file)).map_err(|fault| {
                    let path = format!("bodies[{number}].display[{k}].file");
                    errors.push(ModelError::new(path, fault.found, fault.expected));
                })
            };
            Surface::of(body, &mut read)
        };
        let bodies = model.bodies.iter().enumerate().map(&mut surface).collect();
        if errors.is_empty() { Ok(Self { bodies }) } else { Err(ModelErrors(errors)) }
    }

    /// Reads the surfaces of a run from its results folder, and returns messages about files that cannot be read.
    pub fn of_run(model: &Model, results: &Path) -> (Self, Vec<String>) {
        let mut messages = Vec::new();
        let mut surface = |(number, body): (usize, &Body)| {
            let has_mesh = matches!(body, Body::Rigid(rigid) if rigid.has_mesh());
            if !has_mesh {
                return Surface::of(body, &mut |_, _| Err(()));
            }
            match read_mesh(&results.join(FOLDER).join(file_name(number))) {
                Ok(triangles) => Some(Surface { triangles: Arc::new(triangles), has_mesh }),
                Err(fault) => {
                    let name = body.name();
                    messages.push(format!("`{name}` is drawn without its display geometry: {}", fault.found));
                    None
                }
            }
        };
        let bodies = model.bodies.iter().enumerate().map(&mut surface).collect();
        (Self { bodies }, messages)
    }

    /// Returns names and contents of the files for a results folder: the surfaces that contain meshes of files, as binary STL.
    ///
    /// # Errors
    /// If a surface has too many triangles for the format.
    pub fn files(&self) -> io::Result<Vec<(String, Vec<u8>)>> {
        let surfaces = self.bodies.iter().enumerate();
        let stored = surfaces.filter_map(|(number, surface)| Some((number, surface.as_ref()?)));
        let stored = stored.filter(|(_, surface)| surface.has_mesh);
        stored.map(|(k, one)| Ok((format!("{FOLDER}/{}", file_name(k)), to_stl(&one.triangles)?))).collect()
    }

    /// Surface of a body by its number; `None` if it is drawn by its inertia.
    pub fn get(&self, body: usize) -> Option<&Arc<Triangles>> {
        self.bodies.get(body)?.as_ref().map(|surface| &surface.triangles)
    }
}

fn file_name(body: usize) -> String {
    format!("{body}.stl")
}

impl Surface {
    /// Surface of a body; `None` without shapes, or if a mesh cannot be read.
    fn of(body: &Body, read: &mut dyn FnMut(usize, &str) -> Result<Triangles, ()>) -> Option<Self> {
        let Body::Rigid(rigid) = body else { return None };
        let centre = Vector3::from(rigid.center);
        let mut triangles = match &rigid.surface {
            Some(surface) if rigid.display.is_empty() => of_contact(surface, rigid.center),
            _ => Triangles::default(),
        };
        let mut is_complete = true;
        for (k, shape) in rigid.display.iter().enumerate() {
            match of_shape(shape, rigid, &mut |file| read(k, file)) {
                Ok(shape) => triangles.extend(&shape),
                Err(()) => is_complete = false,
            }
        }
        triangles.transform(|point| (Vector3::from(point) - centre).into());
        let is_drawn = is_complete && !triangles.corners.is_empty();
        is_drawn.then(|| Self { triangles: Arc::new(triangles), has_mesh: rigid.has_mesh() })
    }
}

/// Triangles of a display shape in global coordinates.
fn of_shape(
    shape: &DisplayShape,
    body: &Rigid,
    read: &mut dyn FnMut(&str) -> Result<Triangles, ()>,
) -> Result<Triangles, ()> {
    let placed = |mut triangles: Triangles, scale: f64, rotation: &[f64; 3], to: [f64; 3]| {
        let (turn, to) = (Rotation3::new(Vector3::from(*rotation)), Vector3::from(to));
        triangles.transform(|point| (turn * Vector3::from(point) * scale + to).into());
        triangles
    };
    Ok(match shape {
        DisplayShape::Box { edges, center, rotation } => {
            placed(cuboid(*edges), 1.0, rotation, center.unwrap_or(body.center))
        }
        DisplayShape::Cylinder { from, to, radius } => cylinder(*from, *to, *radius),
        DisplayShape::Sphere { radius, center } => sphere(center.unwrap_or(body.center), *radius),
        DisplayShape::Mesh { file, scale, origin, rotation } => {
            placed(read(file)?, *scale, rotation, *origin)
        }
    })
}

/// Triangles of a contact surface in global coordinates; none for points.
fn of_contact(surface: &BodySurface, centre: [f64; 3]) -> Triangles {
    let mut triangles = Triangles::default();
    if let Some(edges) = surface.edges {
        let mut own = cuboid(edges);
        own.transform(|point| [0, 1, 2].map(|k| point[k] + centre[k]));
        triangles.extend(&own);
    } else if surface.radius > 0.0 {
        let centres = if surface.points.is_empty() { &[centre][..] } else { &surface.points };
        centres.iter().for_each(|&centre| triangles.extend(&sphere(centre, surface.radius)));
    }
    triangles
}
