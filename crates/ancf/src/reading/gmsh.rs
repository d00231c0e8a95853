//! Mesh files of Gmsh.

use std::collections::{BTreeMap, HashMap};
use std::str::SplitWhitespace;

/// First words of a mesh file of Gmsh.
pub(super) const START: &str = "$MeshFormat";

/// Quadrilaterals and triangles of a mesh file with their nodes, and its physical groups.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct GmshMesh {
    pub(super) nodes: Vec<[f64; 3]>,
    pub(super) elements: Vec<Vec<usize>>,
    pub(super) groups: BTreeMap<String, GmshGroup>,
}

/// Physical group of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum GmshGroup {
    /// Nodes.
    Nodes(Vec<usize>),
    /// Chains of nodes.
    Edges(Vec<Vec<usize>>),
    /// Elements.
    Elements(Vec<usize>),
}

/// Element of a file: its number, type, physical groups and numbers of nodes.
struct FileElement {
    tag: u64,
    kind: u32,
    groups: Vec<i64>,
    nodes: Vec<u64>,
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
pub(super) fn parse(text: &str) -> Result<GmshMesh, String> {
    let text = text.replace("\r\n", "\n");
    let mut format = words(&text, "MeshFormat")?;
    let (version, binary): (String, u32) = (format.next()?, format.next()?);
    if binary != 0 {
        return Err("a binary mesh file; export it as text (in Gmsh: Mesh.Binary = 0)".into());
    }
    let (nodes, elements) = match version.as_str() {
        "2.2" | "2" => (nodes_2(&text)?, elements_2(&text)?),
        "4.1" => (nodes_4(&text)?, elements_4(&text)?),
        _ => return Err(format!("a mesh file of version {version}; versions 2.2 and 4.1 are supported")),
    };
    mesh(&nodes, &elements, &names(&text)?)
}

/// Names of the physical groups by dimension and number.
fn names(text: &str) -> Result<HashMap<(u32, i64), String>, String> {
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
    (0..count).map(|_| Ok((words.next()?, [words.next()?, words.next()?, words.next()?]))).collect()
}

fn elements_2(text: &str) -> Result<Vec<FileElement>, String> {
    let mut words = words(text, "Elements")?;
    let count: usize = words.next()?;
    let mut read = || {
        let (tag, kind) = (words.next()?, words.next()?);
        let tags: usize = words.next()?;
        let tags: Vec<i64> = words.list(tags)?;
        let nodes = words.list(size(tag, kind)?)?;
        // The first tag is the physical group; 0 for none.
        let groups = tags.first().copied().filter(|group| *group != 0).into_iter().collect();
        Ok(FileElement { tag, kind, groups, nodes })
    };
    (0..count).map(|_| read()).collect()
}

fn nodes_4(text: &str) -> Result<Vec<(u64, [f64; 3])>, String> {
    let mut words = words(text, "Nodes")?;
    let [blocks, _, _, _]: [u64; 4] = [words.next()?, words.next()?, words.next()?, words.next()?];
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
    Ok(nodes)
}

/// Physical groups of the entities by dimension and number.
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

fn elements_4(text: &str) -> Result<Vec<FileElement>, String> {
    let (groups, mut words) = (entities_4(text)?, words(text, "Elements")?);
    let [blocks, _, _, _]: [u64; 4] = [words.next()?, words.next()?, words.next()?, words.next()?];
    let mut elements = Vec::new();
    for _ in 0..blocks {
        let (dimension, entity, kind, count): (u32, i64, u32, usize) =
            (words.next()?, words.next()?, words.next()?, words.next()?);
        let own = groups.get(&(dimension, entity)).cloned().unwrap_or_default();
        for _ in 0..count {
            let tag = words.next()?;
            let nodes = words.list(size(tag, kind)?)?;
            elements.push(FileElement { tag, kind, groups: own.clone(), nodes });
        }
    }
    Ok(elements)
}

/// Types of elements that are supported.
const LINE: u32 = 1;
const TRIANGLE: u32 = 2;
const QUADRILATERAL: u32 = 3;
const POINT: u32 = 15;

/// Number of nodes of a supported type of element.
fn size(tag: u64, kind: u32) -> Result<usize, String> {
    let name = match kind {
        LINE => return Ok(2),
        TRIANGLE => return Ok(3),
        QUADRILATERAL => return Ok(4),
        POINT => return Ok(1),
        8 | 9 | 10 | 16 => "of second order",
        4..=7 => "a solid",
        _ => "of another type than point, line, triangle and quadrilateral",
    };
    Err(format!(
        "element {tag}, which is {name}; only quadrilaterals of four and triangles of three nodes are supported (in Gmsh: Mesh.ElementOrder = 1)"
    ))
}

/// Creates the mesh of the quadrilaterals and triangles. Nodes of none are left out, since they have no effect.
fn mesh(
    nodes: &[(u64, [f64; 3])],
    elements: &[FileElement],
    names: &HashMap<(u32, i64), String>,
) -> Result<GmshMesh, String> {
    let places: HashMap<u64, [f64; 3]> = nodes.iter().copied().collect();
    if places.len() < nodes.len() {
        return Err("a number of a node a second time".into());
    }
    let (mut mesh, mut numbers) = (GmshMesh::default(), HashMap::<u64, usize>::new());
    for element in elements.iter().filter(|element| is_face(element)) {
        let mut own = Vec::with_capacity(element.nodes.len());
        for tag in &element.nodes {
            let place = places.get(tag).ok_or_else(|| missing(element.tag, *tag))?;
            own.push(*numbers.entry(*tag).or_insert_with(|| {
                mesh.nodes.push(*place);
                mesh.nodes.len() - 1
            }));
        }
        mesh.elements.push(own);
    }
    if mesh.elements.is_empty() {
        return Err("no quadrilaterals and no triangles".into());
    }
    let mut members = BTreeMap::<(u32, i64), Vec<Vec<usize>>>::new();
    let mut face = 0;
    for element in elements {
        let (dimension, own) = match element.kind {
            TRIANGLE | QUADRILATERAL => {
                face += 1;
                (2, vec![face - 1])
            }
            kind => {
                let own = element.nodes.iter().map(|tag| numbers.get(tag).copied());
                let Some(own) = own.collect::<Option<Vec<_>>>() else {
                    if element.groups.is_empty() {
                        continue;
                    }
                    return Err(format!(
                        "element {} of a group with a node of no quadrilateral and no triangle",
                        element.tag
                    ));
                };
                (u32::from(kind == LINE), own)
            }
        };
        element
            .groups
            .iter()
            .for_each(|group| members.entry((dimension, *group)).or_default().push(own.clone()));
    }
    for (key, own) in members {
        let name = names.get(&key).cloned().unwrap_or_else(|| key.1.to_string());
        let group = match key.0 {
            0 => GmshGroup::Nodes(own.concat()),
            1 => GmshGroup::Edges(chains(&own)),
            _ => GmshGroup::Elements(own.concat()),
        };
        if mesh.groups.insert(name.clone(), group).is_some() {
            return Err(format!("two physical groups of different dimensions with the name \"{name}\""));
        }
    }
    Ok(mesh)
}

/// True for a quadrilateral or a triangle.
fn is_face(element: &FileElement) -> bool {
    [TRIANGLE, QUADRILATERAL].contains(&element.kind)
}

fn missing(element: u64, node: u64) -> String {
    format!("element {element} with the node {node}, which does not exist")
}

/// Joins segments to chains. A closed chain ends with its first node.
fn chains(segments: &[Vec<usize>]) -> Vec<Vec<usize>> {
    let mut at_node = BTreeMap::<usize, Vec<usize>>::new();
    for (k, segment) in segments.iter().enumerate() {
        segment.iter().for_each(|node| at_node.entry(*node).or_default().push(k));
    }
    // Chains start at ends and branches; closed ones are left for the second pass.
    let starts = at_node.iter().filter(|(_, of)| of.len() != 2).map(|(node, _)| *node);
    let all = starts.collect::<Vec<_>>().into_iter().chain(at_node.keys().copied().collect::<Vec<_>>());
    let (mut used, mut chains) = (vec![false; segments.len()], Vec::new());
    for start in all {
        for &first in &at_node[&start] {
            let (mut chain, mut next) = (vec![start], Some(first).filter(|k| !used[*k]));
            while let Some(k) = next {
                used[k] = true;
                let last = chain[chain.len() - 1];
                let end = if segments[k][0] == last { segments[k][1] } else { segments[k][0] };
                chain.push(end);
                let of = &at_node[&end];
                next = of.iter().copied().find(|k| of.len() == 2 && !used[*k]);
            }
            if chain.len() > 1 {
                chains.push(chain);
            }
        }
    }
    chains
}

#[cfg(test)]
mod tests {
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

    /// Both versions have the same mesh. A node of no element is left out.
    #[test]
    fn versions_agree() {
        let mesh = parse(&version_2()).unwrap();
        assert_eq!(
            mesh.nodes,
            [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.], [2., 0., 0.], [2., 1., 0.]]
        );
        assert_eq!(mesh.elements, [[0, 1, 2, 3], [1, 4, 5, 2]]);
        assert_eq!(mesh.groups["tip"], GmshGroup::Nodes(vec![4]));
        assert_eq!(mesh.groups["left side"], GmshGroup::Edges(vec![vec![0, 3]]));
        assert_eq!(mesh.groups["plate"], GmshGroup::Elements(vec![0, 1]));
        assert_eq!(parse(&version_4()).unwrap(), mesh);
        assert_eq!(parse(&version_4().replace('\n', "\r\n")).unwrap(), mesh);
    }

    /// A quadrilateral may be divided into two triangles; groups of elements count both.
    #[test]
    fn triangles_are_elements() {
        let divided = version_2()
            .replace("$Elements\n4\n", "$Elements\n5\n")
            .replace("4 3 2 3 1 2 3 6 5", "4 2 2 3 1 2 3 6\n5 2 2 3 1 2 6 5");
        let mesh = parse(&divided).unwrap();
        assert_eq!(mesh.elements, [vec![0, 1, 2, 3], vec![1, 4, 5], vec![1, 5, 2]]);
        assert_eq!(mesh.groups["plate"], GmshGroup::Elements(vec![0, 1, 2]));
    }

    #[test]
    fn segments_join_to_chains() {
        let pairs = |all: &[[usize; 2]]| all.iter().map(|pair| pair.to_vec()).collect::<Vec<_>>();
        assert_eq!(chains(&pairs(&[[2, 3], [1, 2], [4, 3]])), [vec![1, 2, 3, 4]]);
        assert_eq!(chains(&pairs(&[[1, 2], [3, 1], [2, 3]])), [vec![1, 2, 3, 1]]);
        assert_eq!(chains(&pairs(&[[5, 6], [1, 2]])), [vec![1, 2], vec![5, 6]]);
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
            ("4 3 2 3 1 2 3 6 5", "4 3 2 3 1 2 3 6 x", "\"x\""),
        ] {
            let error = parse(&version_2().replace(from, to)).unwrap_err();
            assert!(error.contains(found), "{to}: {error}");
        }
    }
}
