//! Container of binary glTF 2.0 files: a header, a chunk of JSON, and a chunk of data.

const MAGIC: &[u8] = b"glTF";
const VERSION: u32 = 2;
/// Bytes of the header, and of the head of a chunk.
const HEADER: usize = 12;
const HEAD: usize = 8;
const DATA: &[u8] = b"BIN\0";

/// Returns the JSON and the data of a file, which may be JSON alone.
pub(super) fn json_and_data(bytes: &[u8]) -> Result<(&[u8], Option<&[u8]>), String> {
    if !bytes.starts_with(MAGIC) {
        return Ok((bytes, None));
    }
    if word(bytes, MAGIC.len()) != Some(VERSION) {
        return Err("another version of glTF".to_owned());
    }
    let (_, json, rest) = chunk(bytes.get(HEADER..).unwrap_or_default()).ok_or("a file without JSON")?;
    let data = chunk(rest).filter(|(kind, ..)| *kind == DATA).map(|(_, data, _)| data);
    Ok((json, data))
}

/// Returns kind and content of the first chunk, and the remaining bytes.
fn chunk(bytes: &[u8]) -> Option<(&[u8], &[u8], &[u8])> {
    let content = bytes.get(HEAD..)?;
    let (content, rest) = content.split_at_checked(word(bytes, 0)? as usize)?;
    Some((&bytes[4..HEAD], content, rest))
}

fn word(bytes: &[u8], at: usize) -> Option<u32> {
    Some(u32::from_le_bytes(bytes.get(at..at + 4)?.try_into().ok()?))
}
