//! What a result rests on, in words for a terminal: what is open with what to do about it, what is accepted, and on request what is
//! shown.

use super::view::View;
use crate::obligations::{Obligations, Standing};
use fmi_hazard_record::paragraph::wrapped_to;

/// What stands before the lines that accept what can be.
pub(super) const TO_ACCEPT: &str = "Whoever accepts what was only tried out adds to the cell file:";

/// All of it.
pub(super) fn rests_on(obligations: &Obligations, view: View) -> String {
    let mut out = String::new();
    for one in obligations.all() {
        let head = match &one.standing {
            Standing::Open { .. } => "  Not shown ",
            Standing::Assumed { .. } => "  Accepted  ",
            Standing::Shown { .. } if view.verbose => "  Shown     ",
            Standing::Shown { .. } => continue,
        };
        out += &wrapped_to(view.width, head, &one.words());
    }
    if let Some(lines) = obligations.lines_to_accept() {
        let head = "            ";
        out += &wrapped_to(view.width, head, TO_ACCEPT);
        for line in lines.lines() {
            out += format!("{head}  {line}").trim_end();
            out.push('\n');
        }
    }
    out
}
