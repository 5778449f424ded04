//! What the benches share: the built-in example cells as files.

use std::path::PathBuf;
use std::sync::LazyLock;

use tempfile::TempDir;

static FILES: LazyLock<TempDir> = LazyLock::new(|| {
    let dir = TempDir::new().expect("a temporary folder");
    fmi_hazard::examples::export(dir.path()).expect("the examples can be written");
    dir
});

/// The cell file of a scenario, for instance `safety-fence`.
pub fn cell(scenario: &str) -> PathBuf {
    FILES.path().join(scenario).join("cell.toml")
}
