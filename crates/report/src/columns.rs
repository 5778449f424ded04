//! Tables as text.

/// Rows under a header in aligned columns, for a terminal or as Markdown.
#[must_use]
pub fn columns(header: &[&str], rows: &[Vec<String>], markdown: bool) -> String {
    let width = |c: usize| rows.iter().map(|r| r[c].len()).max().unwrap_or(0).max(header[c].len());
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    let line = |cells: Vec<&str>| {
        let padded: Vec<String> = cells.iter().zip(&widths).map(|(c, w)| format!("{c:<w$}")).collect();
        match markdown {
            true => format!("| {} |\n", padded.join(" | ")),
            false => format!(" {}\n", padded.join("  ").trim_end()),
        }
    };
    let mut out = line(header.to_vec());
    if markdown {
        let dashes: Vec<String> = widths.iter().map(|w| "-".repeat(*w)).collect();
        out += &line(dashes.iter().map(String::as_str).collect());
    }
    rows.iter().for_each(|r| out += &line(r.iter().map(String::as_str).collect()));
    out
}
