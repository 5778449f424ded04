//! A command that is at work, followed by what it tells on standard error.

use std::io::{BufRead as _, BufReader, Lines};
use std::path::Path;
use std::process::{Child, ChildStderr, Command, Stdio};

/// A command at work.
pub struct Started {
    /// Its process; standard output is kept for `wait_with_output`.
    pub process: Child,
    lines: Lines<BufReader<ChildStderr>>,
    told: String,
}

impl Started {
    /// Runs `fmi-hazard` until it has said `word` on standard error.
    pub fn until(dir: &Path, arguments: &[&str], word: &str) -> Self {
        let mut process = Command::new(env!("CARGO_BIN_EXE_fmi-hazard"))
            .args(arguments)
            .current_dir(dir)
            .stderr(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let lines = BufReader::new(process.stderr.take().expect("it is piped")).lines();
        let mut started = Self { process, lines, told: String::new() };
        assert!(started.listen(|line| line.contains(word)), "`{word}` was not said: {}", started.told);
        started
    }

    /// Takes in lines up to one that is `enough`, which is told if there is one.
    fn listen(&mut self, enough: impl Fn(&str) -> bool) -> bool {
        for line in self.lines.by_ref().map_while(Result::ok) {
            self.told += &(line.clone() + "\n");
            if enough(&line) {
                return true;
            }
        }
        false
    }

    /// Sends it a signal, such as `-INT`. It may have ended by itself.
    pub fn signal(&self, signal: &str) {
        let _ = Command::new("kill").args([signal, &self.process.id().to_string()]).stderr(Stdio::null()).status();
    }

    /// Waits for its end: its exit code, if it ended by itself, and all that it printed.
    pub fn end(mut self) -> (Option<i32>, String) {
        self.listen(|_| false);
        let ended = self.process.wait_with_output().expect("it ends");
        (ended.status.code(), self.told + &String::from_utf8_lossy(&ended.stdout))
    }
}
