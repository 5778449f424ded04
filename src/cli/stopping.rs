//! Ctrl-C and SIGTERM: the first ends what is under way and keeps what is there, the second ends the program.

use std::sync::atomic::{AtomicBool, Ordering};

use super::{exit, output};
use crate::stop::Stop;

/// From now on Ctrl-C and SIGTERM ask.
#[expect(clippy::exit, reason = "who asks twice does not want to wait for anything")]
pub(super) fn by_signals(stop: &Stop) {
    let (handler, again) = (stop.clone(), AtomicBool::new(false));
    // A second handler in one process cannot be set; the default (end at once) then stays.
    let _ = ctrlc::set_handler(move || {
        if again.swap(true, Ordering::Relaxed) {
            // The workers see that this process is gone, and go.
            std::process::exit(i32::from(exit::INTERRUPTED));
        }
        handler.ask();
        output::interlude(" Stopping: what was found is kept. Once more to end at once");
    });
}
