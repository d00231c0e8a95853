//! Mesh files of Gmsh.

use std::collections::HashMap;
use std::str::SplitWhitespace;

use super::file_mesh::{FileElement, FileMesh};

/// First words of a mesh file of Gmsh.
pub(super) const START: &str = "$MeshFormat";

/// Start of the comments that may precede them.
const COMMENTS: &[u8] = b"$Comments";
/// Byte order mark of UTF-8.
const MARK: &[u8] = b"\xef\xbb\xbf";

/// Returns the place of the first words of a file of Gmsh, after a byte order mark and comments; `None` for other files.
pub(super) fn start(bytes: &[u8]) -> Option<usize> {
    let own = bytes.strip_prefix(MARK).unwrap_or(bytes);
    let start = bytes.len() - own.len();
    if !own.starts_with(COMMENTS) {
        return own.starts_with(START.as_bytes()).then_some(start);
    }
    own.windows(START.len()).position(|words| words == START.as_bytes()).map(|place| start + place)
}

/// Words of a section of a file.
struct Words<'a>(SplitWhitespace<'a>, &'static str);

impl Words<'_> {
    fn next<T: std::str::FromStr>(&mut self) -> Result<T, String> {
        let word = self.0.next().ok_or_else(|| format!("the end of the section {} too early", self.1))?;
        word.parse().map_err(|_| format!("\"{word}\" in the section {} where a number is expected", self.1))
    }

    fn list<T: std::str::FromStr>(&mut self, count: usize) -> Result<Vec<T>, String> {
        (0..count).map(|_| self.next()).collect()
    }

    /// Checks that the section ends here and has the stated number of items.
    fn end(mut self, stated: usize, found: usize) -> Result<(), String> {
        if stated != found {
            return Err(format!("{found} items in the section {}, which states {stated}", self.1));
        }
        match self.0.next() {
            None => Ok(()),
            Some(word) => {
                Err(format!("\"{word}\" after the {found} items that the section {} states", self.1))
            }
        }
    }
}

/// Returns the text of a section without its first and last line.
fn section<'a>(text: &'a str, name: &'static str) -> Option<&'a str> {
    let rest = text.split_once(&format!("${name}\n")).map(|(_, rest)| rest)?;
    rest.split_once(&format!("$End{name}")).map(|(own, _)| own)
}

fn words<'a>(text: &'a str, name: &'static str) -> Result<Words<'a>, String> {
    section(text, name)
        .map(|own| Words(own.split_whitespace(), name))
        .ok_or_else(|| format!("no section ${name}"))
}

/// Reads a mesh file of version 2.2 or 4.1 as text. Errors are descriptions of what was found.
pub(super) fn parse(text: &str) -> Result<FileMesh, String> {
    let text: String = text.lines().flat_map(|line| [line.trim_end(), "\n"]).collect();
    let mut format = words(&text, "MeshFormat")?;
    let (version, binary): (String, u32) = (format.next()?, format.next()?);
    if binary != 0 {
        return Err("a binary mesh file; export it as text (in Gmsh: Mesh.Binary = 0)".into());
    }
    let names = names(&text)?;
    let (nodes, elements) = match version.as_str() {
        "2.2" | "2" => (nodes_2(&text)?, elements_2(&text, &names)?),
        "4.1" => (nodes_4(&text)?, elements_4(&text, &names)?),
        _ => return Err(format!("a mesh file of version {version}; versions 2.2 and 4.1 are supported")),
    };
    FileMesh::new(&nodes, &elements)
}

/// Names of the physical groups by dimension and number.
type Names = HashMap<(u32, i64), String>;

/// Returns the name of a physical group: its number for a group without a name.
fn name(names: &Names, dimension: u32, group: i64) -> String {
    names.get(&(dimension, group)).cloned().unwrap_or_else(|| group.to_string())
}

fn names(text: &str) -> Result<Names, String> {
    let Some(own) = section(text, "PhysicalNames") else { return Ok(HashMap::new()) };
    let of_line = |line: &str| {
        let wrong = || format!("\"{line}\" in the section PhysicalNames");
        let (numbers, name) = line.split_once('"').ok_or_else(wrong)?;
        let mut words = Words(numbers.split_whitespace(), "PhysicalNames");
        Ok(((words.next()?, words.next()?), name.trim_end().trim_end_matches('"').to_owned()))
    };
    own.lines().skip(1).filter(|line| !line.trim().is_empty()).map(of_line).collect()
}

fn nodes_2(text: &str) -> Result<Vec<(u64, [f64; 3])>, String> {
    let mut words = words(text, "Nodes")?;
    let count: usize = words.next()?;
    let read = |_| Ok((words.next()?, [words.next()?, words.next()?, words.next()?]));
    let nodes: Vec<_> = (0..count).map(read).collect::<Result<_, String>>()?;
    words.end(count, nodes.len())?;
    Ok(nodes)
}

fn elements_2(text: &str, names: &Names) -> Result<Vec<FileElement>, String> {
    let mut words = words(text, "Elements")?;
    let count: usize = words.next()?;
    let mut read = || {
        let (tag, kind) = (words.next()?, words.next()?);
        let tags: usize = words.next()?;
        let tags: Vec<i64> = words.list(tags)?;
        let (dimension, size) = shape(tag, kind)?;
        let nodes = words.list(size)?;
        // The first tag is the physical group; 0 for none.
        let group = tags.first().map(|group| group.abs()).filter(|group| *group != 0);
        let groups = group.map(|group| name(names, dimension, group)).into_iter().collect();
        Ok(FileElement { tag, dimension, groups, nodes })
    };
    let elements: Vec<_> = (0..count).map(|_| read()).collect::<Result<_, String>>()?;
    words.end(count, elements.len())?;
    Ok(elements)
}

fn nodes_4(text: &str) -> Result<Vec<(u64, [f64; 3])>, String> {
    let mut words = words(text, "Nodes")?;
    let [blocks, stated, _, _]: [usize; 4] = [words.next()?, words.next()?, words.next()?, words.next()?];
    let mut nodes = Vec::new();
    for _ in 0..blocks {
        let (dimension, _, parametric, count): (usize, i64, usize, usize) =
            (words.next()?, words.next()?, words.next()?, words.next()?);
        let tags: Vec<u64> = words.list(count)?;
        for tag in tags {
            nodes.push((tag, [words.next()?, words.next()?, words.next()?]));
            // Parameters on the curve or the surface.
            words.list::<f64>(if parametric == 0 { 0 } else { dimension })?;
        }
    }
    words.end(stated, nodes.len())?;
    Ok(nodes)
}

/// Physical groups of the entities by dimension and number. A negative number is that of a group with the opposite orientation of the
/// entity (`Geometry.OrientedPhysicals` of Gmsh).
fn entities_4(text: &str) -> Result<HashMap<(u32, i64), Vec<i64>>, String> {
    if section(text, "Entities").is_none() {
        return Ok(HashMap::new());
    }
    let mut words = words(text, "Entities")?;
    let counts: Vec<usize> = words.list(4)?;
    let mut groups = HashMap::new();
    for (dimension, count) in (0..).zip(counts) {
        for _ in 0..count {
            let tag: i64 = words.next()?;
            words.list::<f64>(if dimension == 0 { 3 } else { 6 })?;
            let own: usize = words.next()?;
            groups.insert((dimension, tag), words.list(own)?);
            if dimension > 0 {
                let bounds: usize = words.next()?;
                words.list::<i64>(bounds)?;
            }
        }
    }
    Ok(groups)
}

fn elements_4(text: &str, names: &Names) -> Result<Vec<FileElement>, String> {
    let (groups, mut words) = (entities_4(text)?, words(text, "Elements")?);
    let [blocks, stated, _, _]: [usize; 4] = [words.next()?, words.next()?, words.next()?, words.next()?];
    let mut elements = Vec::new();
    for _ in 0..blocks {
        let (dimension, entity, kind, count): (u32, i64, u32, usize) =
            (words.next()?, words.next()?, words.next()?, words.next()?);
        let own = groups.get(&(dimension, entity)).map_or(&[][..], Vec::as_slice);
        for _ in 0..count {
            let tag = words.next()?;
            let (dimension, size) = shape(tag, kind)?;
            let mut nodes: Vec<u64> = words.list(size)?;
            // Files of version 2.2 have reversed elements in this case.
            if dimension == 2 && own.first().is_some_and(|group| *group < 0) {
                nodes.reverse();
            }
            let groups = own.iter().map(|group| name(names, dimension, group.abs())).collect();
            elements.push(FileElement { tag, dimension, groups, nodes });
        }
    }
    words.end(stated, elements.len())?;
    Ok(elements)
}

/// Returns the dimension and the number of nodes of a supported type of element.
fn shape(tag: u64, kind: u32) -> Result<(u32, usize), String> {
    let name = match kind {
        15 => return Ok((0, 1)),
        1 => return Ok((1, 2)),
        2 => return Ok((2, 3)),
        3 => return Ok((2, 4)),
        8 | 9 | 10 | 16 => "of second order",
        4..=7 => "a solid",
        _ => "of another type than point, line, triangle and quadrilateral",
    };
    Err(format!(
        "element {tag}, which is {name}; only quadrilaterals of four and triangles of three nodes are supported (in Gmsh: Mesh.ElementOrder = 1)"
    ))
}

#[cfg(test)]
mod tests {
    use super::super::file_mesh::MeshGroup;
    use super::*;

    const HEAD: &str =
        "$PhysicalNames\n3\n0 1 \"tip\"\n1 2 \"left side\"\n2 3 \"plate\"\n$EndPhysicalNames\n";

    fn version_2() -> String {
        format!(
            "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n{HEAD}$Nodes\n7\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n9 5 5 5\n\
             $EndNodes\n$Elements\n4\n1 15 2 1 1 3\n2 1 2 2 1 4 1\n3 3 2 3 1 1 2 5 4\n4 3 2 3 1 2 3 6 5\n$EndElements\n"
        )
    }

    fn version_4() -> String {
        format!(
            "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n{HEAD}$Entities\n1 1 1 0\n3 2 0 0 1 1\n1 0 0 0 0 1 0 1 2 2 1 -2\n\
             1 0 0 0 2 1 0 1 3 1 1\n$EndEntities\n$Nodes\n2 6 1 6\n1 1 1 1\n1\n0 0 0 0.5\n2 1 0 5\n2\n3\n4\n5\n6\n1 0 0\n2 0 0\n0 1 0\n\
             1 1 0\n2 1 0\n$EndNodes\n$Elements\n3 4 1 4\n0 3 15 1\n1 3\n1 1 1 1\n2 4 1\n2 1 3 2\n3 1 2 5 4\n4 2 3 6 5\n$EndElements\n"
        )
    }

    /// Both versions have the same mesh, with the nodes in the order of the file. A node of no element is left out.
    #[test]
    fn versions_agree() {
        let mesh = parse(&version_2()).unwrap();
        assert_eq!(
            mesh.nodes,
            [[0., 0., 0.], [1., 0., 0.], [2., 0., 0.], [0., 1., 0.], [1., 1., 0.], [2., 1., 0.]]
        );
        assert_eq!(mesh.elements, [[0, 1, 4, 3], [1, 2, 5, 4]]);
        assert_eq!(mesh.groups["tip"], MeshGroup::Nodes(vec![2]));
        assert_eq!(mesh.groups["left side"], MeshGroup::Edges(vec![vec![0, 3]]));
        assert_eq!(mesh.groups["plate"], MeshGroup::Elements(vec![0, 1]));
        assert_eq!(parse(&version_4()).unwrap(), mesh);
        assert_eq!(parse(&version_4().replace('\n', "\r\n")).unwrap(), mesh);
        assert_eq!(parse(&version_4().replace("$Nodes\n", "$Nodes  \n")).unwrap(), mesh);
    }

    /// Entities with the opposite orientation belong to their groups. Surfaces are reversed.
    #[test]
    fn entities_may_be_reversed_in_groups() {
        let curve = version_4().replace("1 0 0 0 0 1 0 1 2 2 1 -2", "1 0 0 0 0 1 0 1 -2 2 1 -2");
        assert_eq!(parse(&curve).unwrap(), parse(&version_4()).unwrap());
        let surface = version_4().replace("1 0 0 0 2 1 0 1 3 1 1", "1 0 0 0 2 1 0 1 -3 1 1");
        let (mesh, own) = (parse(&surface).unwrap(), parse(&version_4()).unwrap());
        assert_eq!(mesh.groups["plate"], own.groups["plate"]);
        for (reversed, element) in mesh.elements.iter().zip(&own.elements) {
            let places =
                |nodes: &[usize], mesh: &FileMesh| nodes.iter().map(|k| mesh.nodes[*k]).collect::<Vec<_>>();
            let mut expected = places(element, &own);
            expected.reverse();
            assert_eq!(places(reversed, &mesh), expected);
        }
    }

    /// A quadrilateral may be divided into two triangles; groups of elements count both.
    #[test]
    fn triangles_are_elements() {
        let divided = version_2()
            .replace("$Elements\n4\n", "$Elements\n5\n")
            .replace("4 3 2 3 1 2 3 6 5", "4 2 2 3 1 2 3 6\n5 2 2 3 1 2 6 5");
        let mesh = parse(&divided).unwrap();
        assert_eq!(mesh.elements, [vec![0, 1, 4, 3], vec![1, 2, 5], vec![1, 5, 4]]);
        assert_eq!(mesh.groups["plate"], MeshGroup::Elements(vec![0, 1, 2]));
    }

    #[test]
    fn unsupported_files_are_rejected() {
        for (from, to, found) in [
            ("2.2 0 8", "2.2 1 8", "binary"),
            ("2.2 0 8", "3 0 8", "version 3"),
            ("3 3 2 3 1 1 2 5 4", "3 9 2 3 1 1 2 5 4 6 9", "element 3, which is of second order"),
            ("3 3 2 3 1 1 2 5 4", "3 3 2 3 1 1 2 5 8", "node 8"),
            ("$EndElements", "", "no section $Elements"),
            ("4 3 2 3 1 2 3 6 5", "4 3 2 3 1 2 3 6", "too early"),
            ("$Elements\n4", "$Elements\n3", "\"4\" after the 3 items"),
            ("$Nodes\n7", "$Nodes\n6", "\"9\" after the 6 items"),
            ("4 3 2 3 1 2 3 6 5", "4 3 2 3 1 2 3 6 x", "\"x\""),
        ] {
            let error = parse(&version_2().replace(from, to)).unwrap_err();
            assert!(error.contains(found), "{to}: {error}");
        }
        for (from, to, found) in [
            (
                "2 4 1\n2 1 3 2\n3 1 2 5 4\n4 2 3 6 5",
                "2 4 1\n2 1 3 1\n3 1 2 5 4\n4 2 3 6 5",
                "3 items in the section Elements, which states 4",
            ),
            ("$Nodes\n2 6", "$Nodes\n2 7", "6 items in the section Nodes, which states 7"),
        ] {
            let error = parse(&version_4().replace(from, to)).unwrap_err();
            assert!(error.contains(found), "{to}: {error}");
        }
    }
}
