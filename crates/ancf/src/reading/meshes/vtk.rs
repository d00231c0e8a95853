//! Mesh files of VTK: unstructured grids and polygons, as text and binary.

use std::collections::BTreeSet;

use super::file_mesh::{FileElement, FileMesh};
use super::vtk_piece::{Labels, VtkPiece, kinds};
use super::{vtk_legacy, vtk_xml};

/// Largest number of groups of an array. Arrays with more numbers are those of nodes or elements.
const MAX_GROUPS: usize = 100;

/// Returns true for the start of a file of VTK.
pub(super) fn is_vtk(bytes: &[u8]) -> bool {
    vtk_legacy::is_legacy(bytes) || vtk_xml::is_xml(bytes)
}

/// Reads a mesh file. Errors are descriptions of what was found.
///
/// Arrays of integers with one component define groups: each number k other than 0 of an array A is the group "A k" of nodes, edges
/// or elements.
pub(super) fn parse(bytes: &[u8]) -> Result<FileMesh, String> {
    let pieces = if vtk_legacy::is_legacy(bytes) { vtk_legacy::read(bytes) } else { vtk_xml::read(bytes) };
    let pieces = pieces.map_err(|found| format!("a file of VTK that cannot be read: {found}"))?;
    let mut content = Content::default();
    pieces.into_iter().try_for_each(|piece| content.add(piece))?;
    FileMesh::new(&content.nodes, &content.elements)
}

/// Nodes and elements of the pieces of a file.
#[derive(Default)]
struct Content {
    nodes: Vec<(u64, [f64; 3])>,
    elements: Vec<FileElement>,
    /// Number of cells so far.
    cells: u64,
}

impl Content {
    fn add(&mut self, piece: VtkPiece) -> Result<(), String> {
        let first = self.nodes.len() as u64;
        let places = piece.points.chunks_exact(3).map(|at| [at[0], at[1], at[2]]);
        self.nodes.extend((first..).zip(places));
        let of_cells = of_groups(piece.of_cells);
        for (k, (kind, points)) in piece.cells.into_iter().enumerate() {
            let nodes = points.into_iter().map(|point| first + point).collect();
            self.add_cell(kind, nodes, &groups(&of_cells, k))?;
        }
        // Points of no quadrilateral and no triangle are left out.
        let faces = self.elements.iter().filter(|element| element.dimension == 2);
        let used: BTreeSet<u64> = faces.flat_map(|element| element.nodes.iter().copied()).collect();
        let of_points = of_groups(piece.of_points);
        for node in used.range(first..) {
            let groups = groups(&of_points, (node - first) as usize);
            if !groups.is_empty() {
                self.elements.push(FileElement { tag: *node, dimension: 0, groups, nodes: vec![*node] });
            }
        }
        Ok(())
    }

    fn add_cell(&mut self, kind: u8, nodes: Vec<u64>, groups: &[String]) -> Result<(), String> {
        let tag = self.cells;
        self.cells += 1;
        let mut add = |dimension: u32, nodes: Vec<u64>| {
            self.elements.push(FileElement { tag, dimension, groups: groups.to_vec(), nodes });
        };
        match (kind, nodes.len()) {
            (kinds::VERTEX | kinds::VERTICES, _) => nodes.iter().for_each(|node| add(0, vec![*node])),
            (kinds::LINE | kinds::LINES, _) => {
                nodes.windows(2).for_each(|segment| add(1, segment.to_vec()));
            }
            (kinds::TRIANGLE | kinds::POLYGON, 3) | (kinds::QUADRILATERAL | kinds::POLYGON, 4) => {
                add(2, nodes)
            }
            // Rows instead of a cycle.
            (kinds::PIXEL, 4) => add(2, [0, 1, 3, 2].map(|k| nodes[k]).to_vec()),
            (kind, count) => {
                let name = match kind {
                    kinds::STRIP => "a strip of triangles",
                    10..=14 | 42 => "a solid",
                    21..=37 => "of second order",
                    _ => "of another type",
                };
                return Err(format!(
                    "cell {tag} with {count} points, which is {name}; only quadrilaterals of four and triangles of three points are \
                     supported"
                ));
            }
        }
        Ok(())
    }
}

/// Returns the arrays that have few numbers.
fn of_groups(labels: Vec<Labels>) -> Vec<Labels> {
    let has_few = |(_, values): &Labels| {
        values.iter().filter(|k| **k != 0).collect::<BTreeSet<_>>().len() <= MAX_GROUPS
    };
    labels.into_iter().filter(has_few).collect()
}

/// Returns the groups of a point or a cell.
fn groups(labels: &[Labels], k: usize) -> Vec<String> {
    let of = |(name, values): &Labels| {
        values.get(k).filter(|value| **value != 0).map(|value| format!("{name} {value}"))
    };
    labels.iter().filter_map(of).collect()
}

#[cfg(test)]
mod tests {
    use super::super::file_mesh::MeshGroup;
    use super::*;

    /// Two squares, a line along the left side and a point, as an unstructured grid.
    const GRID: &str = "# vtk DataFile Version 3.0\nstrip\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 7 double\n\
                        0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0 5 5 5\nCELLS 4 15\n4 0 1 4 3\n2 3 0\n1 2\n4 1 2 5 4\nCELL_TYPES 4\n9\n3\n1\n9\n\
                        CELL_DATA 4\nSCALARS part int 1\nLOOKUP_TABLE default\n1 2 3 0\nPOINT_DATA 7\nFIELD FieldData 2\n\
                        held 1 7 int\n0 0 0 1 1 0 1\nheight 1 7 double\n1 1 1 1 1 1 1\n";

    /// The squares as polygons.
    const POLYGONS: &str = "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\"><PolyData>\
                            <Piece NumberOfPoints=\"6\" NumberOfVerts=\"0\" NumberOfLines=\"1\" NumberOfStrips=\"0\" NumberOfPolys=\"2\">\
                            <Points><DataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\" format=\"ascii\">\
                            0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0</DataArray></Points>\
                            <Lines><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">3 0</DataArray>\
                            <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">2</DataArray></Lines>\
                            <Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">0 1 4 3 1 2 5 4</DataArray>\
                            <DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">4 8</DataArray></Polys>\
                            <CellData><DataArray type=\"Int32\" Name=\"part\" format=\"ascii\">2 1 0</DataArray></CellData>\
                            <PointData><DataArray type=\"Int32\" Name=\"held\" format=\"ascii\">0 0 0 1 1 0</DataArray></PointData>\
                            </Piece></PolyData></VTKFile>\n";

    /// Grids and polygons have the same mesh. Points of no quadrilateral are left out, also from groups.
    #[test]
    fn grids_and_polygons_have_groups() {
        let mut mesh = parse(GRID.as_bytes()).unwrap();
        assert_eq!(
            mesh.nodes,
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [2., 0., 0.], [2., 1., 0.]]
        );
        assert_eq!(mesh.elements, [[0, 1, 2, 3], [1, 4, 5, 2]]);
        assert_eq!(mesh.groups["part 1"], MeshGroup::Elements(vec![0]));
        assert_eq!(mesh.groups["part 2"], MeshGroup::Edges(vec![vec![0, 3]]));
        assert_eq!(mesh.groups["held 1"], MeshGroup::Nodes(vec![3, 2]));
        assert_eq!(mesh.groups.remove("part 3"), Some(MeshGroup::Nodes(vec![4])));
        assert_eq!(mesh.groups.len(), 3);
        assert_eq!(parse(POLYGONS.as_bytes()).unwrap(), mesh);
    }

    #[test]
    fn unsupported_files_are_rejected() {
        for (text, from, to, found) in [
            (GRID, "UNSTRUCTURED_GRID", "RECTILINEAR_GRID", "cannot be read"),
            (POLYGONS, "\"PolyData\"", "\"ImageData\"", "ImageData"),
            (POLYGONS, "<Polys>", "<Strips>", "XML"),
            (POLYGONS, "format=\"ascii\">3 0<", "format=\"ascii\">3 x<", "\"x\""),
            (POLYGONS, "format=\"ascii\">3 0<", "format=\"binary\">????????<", "base64"),
            (POLYGONS, "format=\"ascii\">3 0<", "format=\"appended\" offset=\"7\"><", "appended"),
            (GRID, "4 0 1 4 3\n", "4 0 1 4 9\n", "element 0 with the node 9"),
            (GRID, "POINTS 7", "POINTS 700000000000", "cannot be read"),
            (GRID, "CELLS 4 15", "CELLS 4 4000000000", "cannot be read"),
            (GRID, "\n9\n3\n1\n9\n", "\n10\n3\n1\n9\n", "a solid"),
            (GRID, "\n9\n3\n1\n9\n", "\n3\n3\n1\n3\n", "no quadrilaterals"),
            (POLYGONS, ">4 8<", ">4 9<", "offsets"),
            (POLYGONS, "Points>", "Other>", "no Points"),
            (POLYGONS, ">4 8<", ">3 8<", "cell 2"),
        ] {
            assert!(text.contains(from), "{from}");
            let error = parse(text.replace(from, to).as_bytes()).expect_err(to);
            assert!(error.contains(found), "{to}: {error}");
        }
    }

    /// Files that end too early and files with a wrong byte are read or rejected.
    #[test]
    fn damaged_files_cause_no_panic() {
        for text in [GRID, POLYGONS] {
            for end in 0..text.len() {
                let _ = parse(&text.as_bytes()[..end]);
                let mut bytes = text.as_bytes().to_vec();
                bytes[end] = b"0 -<9"[end % 5];
                let _ = parse(&bytes);
            }
        }
    }
}
