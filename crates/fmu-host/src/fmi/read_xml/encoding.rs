//! From the bytes of modelDescription.xml to its text. FMI asks for UTF-8; UTF-16 is understood too.

use std::borrow::Cow;

use super::DescriptionError;

/// The text, and whether it was UTF-16.
///
/// # Errors
/// Where the bytes are neither.
pub(super) fn decode(bytes: &[u8]) -> Result<(Cow<'_, str>, bool), DescriptionError> {
    let (little, rest) = match bytes {
        [0xFF, 0xFE, rest @ ..] => (true, rest),
        [0xFE, 0xFF, rest @ ..] => (false, rest),
        [b'<', 0, ..] => (true, bytes),
        [0, b'<', ..] => (false, bytes),
        _ => return utf8(bytes).map(|text| (Cow::Borrowed(text), false)),
    };
    let to_unit = |pair: &[u8; 2]| if little { u16::from_le_bytes(*pair) } else { u16::from_be_bytes(*pair) };
    let (pairs, odd) = rest.as_chunks::<2>();
    let mut text = String::with_capacity(rest.len() / 2);
    for unit in char::decode_utf16(pairs.iter().map(to_unit)) {
        text.push(unit.map_err(|_| broken(&text, "this is not UTF-16, although the file begins like it"))?);
    }
    if !odd.is_empty() {
        return Err(broken(&text, "the file ends within a character of UTF-16"));
    }
    Ok((Cow::Owned(text), true))
}

fn utf8(bytes: &[u8]) -> Result<&str, DescriptionError> {
    let text = std::str::from_utf8(bytes).map_err(|e| {
        let good = String::from_utf8_lossy(&bytes[..e.valid_up_to()]);
        broken(&good, "this is not UTF-8, which FMI asks for")
    })?;
    Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
}

/// An error at the end of what could be read.
fn broken(good: &str, what: &str) -> DescriptionError {
    DescriptionError::new(good, good.len(), &format!("{what}. Save the file as UTF-8"))
}
