//! glTF 2.0 files: all triangles of the default scene, in its global coordinates.
//!
//! The types of the crate `gltf-json` are used without its validation, which panics for some damaged files.

use std::fs;
use std::path::Path;

use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use gltf_json::accessor::{Accessor, ComponentType, Type};
use gltf_json::mesh::{Mode, Primitive, Semantic};
use gltf_json::scene::Node;
use gltf_json::validation::Checked;
use gltf_json::{Index, Root};
use nalgebra::{Matrix4, Point3, Quaternion, UnitQuaternion, Vector3};

use super::glb::json_and_data;
use crate::mesh::Triangles;

/// Reads a file whose buffers are inside the file or in the same folder.
pub(super) fn from_gltf(bytes: &[u8], folder: &Path) -> Result<Triangles, String> {
    let (json, data) = json_and_data(bytes)?;
    let root = Root::from_slice(json).map_err(|error| error.to_string())?;
    if let Some(extension) = root.extensions_required.first() {
        return Err(format!("the extension {extension}, which is not supported"));
    }
    let buffers = root.buffers.iter().map(|buffer| match &buffer.uri {
        Some(address) => data_at(address, folder),
        None => data.map(<[u8]>::to_vec).ok_or_else(|| "a buffer without data".to_owned()),
    });
    let buffers = buffers.collect::<Result<Vec<_>, _>>()?;
    Reader { root: &root, buffers, triangles: Triangles::default() }.read()
}

/// Reads a data address, or a file of the folder.
fn data_at(address: &str, folder: &Path) -> Result<Vec<u8>, String> {
    match address.strip_prefix("data:") {
        Some(data) => {
            let (_, text) = data.split_once(";base64,").ok_or("a data address that is not in Base64")?;
            BASE64_STANDARD.decode(text).map_err(|error| error.to_string())
        }
        None => fs::read(folder.join(address)).map_err(|error| format!("the buffer {address}: {error}")),
    }
}

/// Returns the item with an index.
fn item<'a, T>(all: &'a [T], index: &Index<T>, what: &str) -> Result<&'a T, String> {
    all.get(index.value()).ok_or_else(|| format!("no {what} {}", index.value()))
}

struct Reader<'a> {
    root: &'a Root,
    buffers: Vec<Vec<u8>>,
    triangles: Triangles,
}

impl Reader<'_> {
    /// Reads the meshes of the nodes of the scene and of their descendants.
    fn read(mut self) -> Result<Triangles, String> {
        let root = self.root;
        let scene = match &root.scene {
            Some(index) => Some(item(&root.scenes, index, "scene")?),
            None => root.scenes.first(),
        };
        let mut seen = vec![false; root.nodes.len()];
        let nodes = scene.map_or(&[][..], |scene| &scene.nodes);
        let mut rest: Vec<_> = nodes.iter().map(|node| (node, Matrix4::identity())).collect();
        while let Some((index, above)) = rest.pop() {
            let node = item(&root.nodes, index, "node")?;
            if std::mem::replace(&mut seen[index.value()], true) {
                return Err(format!("the node {} with two parents", index.value()));
            }
            let placed = above * transform(node);
            if let Some(mesh) = &node.mesh {
                for primitive in &item(&root.meshes, mesh, "mesh")?.primitives {
                    self.add(primitive, &placed)?;
                }
            }
            rest.extend(node.children.iter().flatten().map(|child| (child, placed)));
        }
        Ok(self.triangles)
    }

    /// Adds the triangles of a primitive. Points and lines are omitted.
    fn add(&mut self, primitive: &Primitive, placed: &Matrix4<f64>) -> Result<(), String> {
        let Checked::Valid(mode @ (Mode::Triangles | Mode::TriangleStrip | Mode::TriangleFan)) =
            primitive.mode
        else {
            return Ok(());
        };
        let positions = primitive.attributes.get(&Checked::Valid(Semantic::Positions));
        let positions = positions.ok_or("a mesh without positions")?;
        let number =
            |bytes: &[u8], k: usize| f64::from(f32::from_le_bytes(std::array::from_fn(|i| bytes[4 * k + i])));
        let points: Vec<[f64; 3]> = self
            .items(positions, &[ComponentType::F32], Type::Vec3)?
            .map(|bytes| Point3::new(number(bytes, 0), number(bytes, 1), number(bytes, 2)))
            .map(|point| placed.transform_point(&point).into())
            .collect();
        let whole = [ComponentType::U8, ComponentType::U16, ComponentType::U32];
        let indices: Vec<u32> = match &primitive.indices {
            Some(accessor) => self.items(accessor, &whole, Type::Scalar)?.map(number_of).collect(),
            None => (0..points.len() as u32).collect(),
        };
        if indices.iter().any(|&index| index as usize >= points.len()) {
            return Err("an index of a point that does not exist".to_owned());
        }
        let mut corners = corners(&indices, mode);
        // A reflection reverses the order of the corners.
        if placed.determinant() < 0.0 {
            corners.iter_mut().for_each(|corners| corners.swap(1, 2));
        }
        self.triangles.extend(&Triangles { points, corners });
        Ok(())
    }

    /// Bytes of each item of an accessor with components of one of some types.
    fn items(
        &self,
        accessor: &Index<Accessor>,
        allowed: &[ComponentType],
        kind: Type,
    ) -> Result<impl Iterator<Item = &[u8]>, String> {
        let accessor = item(&self.root.accessors, accessor, "accessor")?;
        let component = match accessor.component_type {
            Checked::Valid(component) if allowed.contains(&component.0) => component.0,
            _ => return Err("numbers of another type than positions and indices have".to_owned()),
        };
        if accessor.type_ != Checked::Valid(kind) {
            return Err("vectors of another length than positions and indices have".to_owned());
        }
        let view = accessor.buffer_view.as_ref().filter(|_| accessor.sparse.is_none());
        let view =
            item(&self.root.buffer_views, view.ok_or("sparse data, which are not supported")?, "view")?;
        let buffer = self.buffers.get(view.buffer.value()).ok_or("a view without buffer")?;
        let size = component.size() * if kind == Type::Vec3 { 3 } else { 1 };
        let stride = view.byte_stride.map_or(size, |stride| stride.0).max(1);
        let bytes = |number: u64| usize::try_from(number).unwrap_or(usize::MAX);
        let viewed = part(buffer, bytes(view.byte_offset.map_or(0, |at| at.0)), bytes(view.byte_length.0))
            .ok_or("a view beyond its buffer")?;
        let (first, count) = (bytes(accessor.byte_offset.map_or(0, |at| at.0)), bytes(accessor.count.0));
        let length = count.saturating_sub(1).saturating_mul(stride).saturating_add(size.min(count * size));
        let items = part(viewed, first, length).ok_or("an accessor beyond its view")?;
        Ok((0..count).map(move |k| &items[k * stride..][..size]))
    }
}

/// Part of some bytes.
fn part(bytes: &[u8], first: usize, length: usize) -> Option<&[u8]> {
    bytes.get(first..first.checked_add(length)?)
}

/// Transformation of a node: its matrix, or translation, rotation and scale.
fn transform(node: &Node) -> Matrix4<f64> {
    if let Some(matrix) = node.matrix {
        return Matrix4::from_column_slice(&matrix).cast();
    }
    let [x, y, z, w] = node.rotation.map_or([0.0, 0.0, 0.0, 1.0], |rotation| rotation.0.map(f64::from));
    let rotation = UnitQuaternion::try_new(Quaternion::new(w, x, y, z), 0.0).unwrap_or_default();
    let scale = Vector3::from(node.scale.unwrap_or([1.0; 3]).map(f64::from));
    let translation = Vector3::from(node.translation.unwrap_or_default().map(f64::from));
    Matrix4::new_translation(&translation)
        * rotation.to_homogeneous()
        * Matrix4::new_nonuniform_scaling(&scale)
}

/// Unsigned number of one, two or four bytes.
fn number_of(bytes: &[u8]) -> u32 {
    bytes.iter().rev().fold(0, |sum, byte| sum << 8 | u32::from(*byte))
}

/// Corners of the triangles of a list, a strip or a fan.
fn corners(indices: &[u32], mode: Mode) -> Vec<[u32; 3]> {
    match mode {
        Mode::TriangleStrip => {
            let turned = |(k, w): (usize, &[u32])| {
                if k % 2 == 0 { [w[0], w[1], w[2]] } else { [w[1], w[0], w[2]] }
            };
            indices.windows(3).enumerate().map(turned).collect()
        }
        Mode::TriangleFan => match indices {
            [hub, rim @ ..] => rim.windows(2).map(|w| [*hub, w[0], w[1]]).collect(),
            [] => Vec::new(),
        },
        _ => indices.chunks_exact(3).map(|w| [w[0], w[1], w[2]]).collect(),
    }
}
