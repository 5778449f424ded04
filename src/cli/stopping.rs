//! Ctrl-C and SIGTERM: the first ends what is under way and keeps what is there, a later one ends the program.

use std::sync::OnceLock;
use std::time::{Duration, Instant};

use super::{exit, output};
use crate::stop::Stop;

/// A signal that comes sooner after the first is the same one: `timeout` sends it to the program and to the program's
/// group, service managers send SIGTERM and SIGHUP together. Nobody presses two keys twice as fast.
const SAME: Duration = Duration::from_millis(200);

/// From now on Ctrl-C and SIGTERM ask.
#[expect(clippy::exit, reason = "who asks twice does not want to wait for anything")]
pub(super) fn by_signals(stop: &Stop) {
    let (handler, first) = (stop.clone(), OnceLock::new());
    // A second handler in one process cannot be set; the default (end at once) then stays.
    let _ = ctrlc::set_handler(move || {
        if let Some(first) = first.get() {
            if Instant::now().duration_since(*first) > SAME {
                // The workers see that this process is gone, and go.
                std::process::exit(i32::from(exit::INTERRUPTED));
            }
            return;
        }
        let _ = first.set(Instant::now());
        handler.ask();
        output::interlude(" Stopping: what was found is kept. Once more to end at once");
    });
}
