//! Records one behind the other, each with its length and a checksum; the first says what the others are about. A torn
//! end, after a power failure say, is left out.

use std::io::{self, Write};

use sha2::{Digest as _, Sha256};

/// Bytes of the checksum before each record.
const CHECK: usize = 8;

/// One more record.
pub(super) fn append(to: &mut impl Write, bytes: &[u8]) -> io::Result<()> {
    let length = u32::try_from(bytes.len()).map_err(io::Error::other)?;
    let mut record = Sha256::digest(bytes)[..CHECK].to_vec();
    record.extend(length.to_le_bytes());
    record.extend(bytes);
    to.write_all(&record)
}

/// The whole records about `subject`, and where they end; at 0 where it is not told what they are about.
///
/// # Errors
/// When they are about something else.
pub(super) fn read<'a>(bytes: &'a [u8], subject: &str) -> io::Result<(Vec<&'a [u8]>, usize)> {
    let mut rest = bytes;
    let Some(found) = next(&mut rest) else { return Ok((Vec::new(), 0)) };
    if found != subject.as_bytes() {
        return Err(io::Error::other(
            "it is that of another search: the cell, the FMU, a setting or this program differs",
        ));
    }
    let records = std::iter::from_fn(|| next(&mut rest)).collect();
    Ok((records, bytes.len() - rest.len()))
}

/// The next whole and undamaged record.
fn next<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let (check, after) = rest.split_at_checked(CHECK)?;
    let (length, after) = after.split_first_chunk::<4>()?;
    let (bytes, after) = after.split_at_checked(usize::try_from(u32::from_le_bytes(*length)).ok()?)?;
    if Sha256::digest(bytes)[..CHECK] != *check {
        return None;
    }
    *rest = after;
    Some(bytes)
}
