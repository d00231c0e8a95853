//! Mesh files of VTK: unstructured grids and polygons, as text and binary.

use std::collections::{BTreeMap, BTreeSet};

use super::file_mesh::{FACE, FileElement, FileMesh};
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
/// or elements. If it occurs for several of them, the groups are "A k nodes", "A k edges" and "A k elements".
pub(super) fn parse(bytes: &[u8]) -> Result<FileMesh, String> {
    let pieces = if vtk_legacy::is_legacy(bytes) { vtk_legacy::read(bytes) } else { vtk_xml::read(bytes) };
    let pieces = pieces.and_then(|pieces| pieces.iter().try_for_each(VtkPiece::check).map(|()| pieces));
    let pieces = pieces.map_err(|found| format!("a file of VTK that cannot be read: {found}"))?;
    let mut content = Content { of_points: names(&pieces, |piece| &piece.of_points), ..Content::default() };
    content.of_cells = names(&pieces, |piece| &piece.of_cells);
    pieces.into_iter().try_for_each(|piece| content.add(piece))?;
    content.name_apart();
    FileMesh::new(&content.nodes, &content.elements)
}

/// Nodes and elements of the pieces of a file.
#[derive(Default)]
struct Content {
    nodes: Vec<(u64, [f64; 3])>,
    elements: Vec<FileElement>,
    /// Number of cells so far.
    cells: u64,
    /// Names of the arrays of points and of cells that define groups.
    of_points: BTreeSet<String>,
    of_cells: BTreeSet<String>,
}

impl Content {
    fn add(&mut self, piece: VtkPiece) -> Result<(), String> {
        let (first, own) = (self.nodes.len() as u64, self.elements.len());
        let places = piece.points.chunks_exact(3).map(|at| [at[0], at[1], at[2]]);
        self.nodes.extend((first..).zip(places));
        for (k, (kind, points)) in piece.cells.into_iter().enumerate() {
            let nodes = points.into_iter().map(|point| first + point).collect();
            self.add_cell(kind, nodes, &groups(&piece.of_cells, &self.of_cells, k))?;
        }
        // Points and lines of no quadrilateral and no triangle are in no group.
        let faces = self.elements[own..].iter().filter(|element| element.dimension == FACE);
        let used: BTreeSet<u64> = faces.flat_map(|element| element.nodes.iter().copied()).collect();
        for element in &mut self.elements[own..] {
            if !element.nodes.iter().all(|node| used.contains(node)) {
                element.groups.clear();
            }
        }
        for node in used {
            let groups = groups(&piece.of_points, &self.of_points, (node - first) as usize);
            if !groups.is_empty() {
                self.elements.push(FileElement { tag: node, dimension: 0, groups, nodes: vec![node] });
            }
        }
        Ok(())
    }

    /// Adds the dimension to the names of groups that have several.
    fn name_apart(&mut self) {
        let mut dimensions = BTreeMap::<String, BTreeSet<u32>>::new();
        for element in &self.elements {
            for group in &element.groups {
                dimensions.entry(group.clone()).or_default().insert(element.dimension);
            }
        }
        for element in &mut self.elements {
            let kind = ["nodes", "edges", "elements"][element.dimension as usize];
            for group in &mut element.groups {
                if dimensions[group.as_str()].len() > 1 {
                    *group = format!("{group} {kind}");
                }
            }
        }
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
                add(FACE, nodes);
            }
            // Rows instead of a cycle.
            (kinds::PIXEL, 4) => add(FACE, [0, 1, 3, 2].map(|k| nodes[k]).to_vec()),
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

/// Returns the names of the arrays that have few numbers in all pieces.
fn names<'a>(pieces: &'a [VtkPiece], labels: impl Fn(&'a VtkPiece) -> &'a [Labels]) -> BTreeSet<String> {
    let mut numbers = BTreeMap::<&str, BTreeSet<i64>>::new();
    for (name, values) in pieces.iter().flat_map(labels) {
        numbers.entry(name).or_default().extend(values.iter().filter(|k| **k != 0));
    }
    numbers.retain(|_, distinct| distinct.len() <= MAX_GROUPS);
    numbers.into_keys().map(str::to_owned).collect()
}

/// Returns the groups of a point or a cell by the arrays of given names.
fn groups(labels: &[Labels], names: &BTreeSet<String>, k: usize) -> Vec<String> {
    let of = |(name, values): &Labels| Some(values[k]).filter(|k| *k != 0).map(|k| format!("{name} {k}"));
    labels.iter().filter(|(name, _)| names.contains(name)).filter_map(of).collect()
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

    /// Grids and polygons have the same mesh, with the nodes in the order of the file. Points of no quadrilateral are left out, also from
    /// groups.
    #[test]
    fn grids_and_polygons_have_groups() {
        let mut mesh = parse(GRID.as_bytes()).unwrap();
        assert_eq!(
            mesh.nodes,
            [[0., 0., 0.], [1., 0., 0.], [2., 0., 0.], [0., 1., 0.], [1., 1., 0.], [2., 1., 0.]]
        );
        assert_eq!(mesh.elements, [[0, 1, 4, 3], [1, 2, 5, 4]]);
        assert_eq!(mesh.groups["part 1"], MeshGroup::Elements(vec![0]));
        assert_eq!(mesh.groups["part 2"], MeshGroup::Edges(vec![vec![0, 3]]));
        assert_eq!(mesh.groups["held 1"], MeshGroup::Nodes(vec![3, 4]));
        assert_eq!(mesh.groups.remove("part 3"), Some(MeshGroup::Nodes(vec![2])));
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
            (GRID, "4 0 1 4 3\n", "4 0 1 4 9\n", "cell 0 with the point 9 of 7"),
            (GRID, "1 2 3 0\n", "1 2 3 0\nGLOBAL_IDS ids int\n1 2 3 4\n", "\"GLOBAL_IDS\""),
            (POLYGONS, "NumberOfPoints=\"6\"", "NumberOfPoints=\"7\"", "6 points instead of 7"),
            (POLYGONS, ">2 1 0<", ">2 1<", "\"part\" with 2 numbers for 3"),
            (POLYGONS, ">4 8<", ">4 7<", "offsets"),
            (POLYGONS, "0 0 0 1 0 0 2", "nan 0 0 1 0 0 2", "not finite"),
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

    /// A number of lines and faces has a group for each of them.
    #[test]
    fn groups_of_several_dimensions_have_names_of_their_own() {
        let mesh = parse(GRID.replace("1 2 3 0\n", "1 1 1 1\n").as_bytes()).unwrap();
        assert_eq!(mesh.groups["part 1 elements"], MeshGroup::Elements(vec![0, 1]));
        assert_eq!(mesh.groups["part 1 edges"], MeshGroup::Edges(vec![vec![0, 3]]));
        assert_eq!(mesh.groups["part 1 nodes"], MeshGroup::Nodes(vec![2]));
        let coded = parse(GRID.replace("SCALARS part", "SCALARS my%20part").as_bytes()).unwrap();
        assert_eq!(coded.groups["my part 1"], MeshGroup::Elements(vec![0]));
    }

    /// The grid as a binary legacy file.
    fn binary_grid() -> Vec<u8> {
        let text = GRID.replace("ASCII", "BINARY").replace(" double", " float");
        let (mut bytes, mut is_float, mut is_data) = (Vec::new(), false, false);
        for line in text.lines() {
            if !line.starts_with(|c: char| c.is_ascii_digit()) {
                is_float = line.contains("float");
                bytes.extend_from_slice(format!("{}{line}\n", if is_data { "\n" } else { "" }).as_bytes());
                is_data = false;
                continue;
            }
            is_data = true;
            for word in line.split_whitespace() {
                let number: i32 = word.parse().unwrap();
                bytes.extend(if is_float { (number as f32).to_be_bytes() } else { number.to_be_bytes() });
            }
        }
        bytes.push(b'\n');
        bytes
    }

    /// The polygons with compressed blocks in base64.
    fn binary_polygons() -> Vec<u8> {
        use base64::Engine;
        use base64::engine::general_purpose::STANDARD;
        let mut text = POLYGONS.replace("byte_order", "compressor=\"vtkZLibDataCompressor\" byte_order");
        text = text.replace("Int32", "Int64").replace("format=\"ascii\"", "format=\"binary\"");
        let mut coded = String::new();
        for (k, part) in text.split("format=\"binary\">").enumerate() {
            let Some((numbers, rest)) = part.split_once('<').filter(|_| k > 0) else {
                coded += part;
                continue;
            };
            let mut bytes = Vec::new();
            for word in numbers.split_whitespace() {
                if k == 1 {
                    bytes.extend(word.parse::<f64>().unwrap().to_le_bytes());
                } else {
                    bytes.extend(word.parse::<i64>().unwrap().to_le_bytes());
                }
            }
            let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
            std::io::Write::write_all(&mut encoder, &bytes).unwrap();
            let block = encoder.finish().unwrap();
            let header = [1, bytes.len() as u32, 0, block.len() as u32].map(u32::to_le_bytes).concat();
            coded +=
                &format!("format=\"binary\">{}{}<{rest}", STANDARD.encode(header), STANDARD.encode(block));
        }
        coded.into_bytes()
    }

    /// Files that end too early and files with a wrong byte are read or rejected.
    #[test]
    fn damaged_files_cause_no_panic() {
        let (grid, polygons) = (binary_grid(), binary_polygons());
        assert_eq!(parse(&grid).unwrap(), parse(GRID.as_bytes()).unwrap());
        assert_eq!(parse(&polygons).unwrap(), parse(POLYGONS.as_bytes()).unwrap());
        for file in [GRID.as_bytes(), POLYGONS.as_bytes(), &grid, &polygons] {
            for end in 0..file.len() {
                let _ = parse(&file[..end]);
                for wrong in [b"0 -<9"[end % 5], 0, 255] {
                    let mut bytes = file.to_vec();
                    bytes[end] = wrong;
                    let _ = parse(&bytes);
                }
            }
        }
    }
}
