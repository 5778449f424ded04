//! For tests of what stands in books and pipelines: an `fmi-hazard` on the path that looks from the cell's starts alone where a command
//! does not say from where. All of it from anywhere would take hours.

use std::ffi::OsString;
use std::fs;
use std::os::unix::fs::PermissionsExt as _;
use std::path::Path;

/// Such a program, first on the path that is given back; its folder is made in `dir`.
pub fn path_with_program(dir: &Path) -> OsString {
    let folder = dir.join("program");
    fs::create_dir_all(&folder).expect("a folder can be made");
    let own = env!("CARGO_BIN_EXE_fmi-hazard");
    let script = format!(
        "#!/bin/sh\n\
         case \" $* \" in\n\
         *\" --from\"*|*\" --resume\"*|*\" --until\"*) ;;\n\
         *\" scan \"*|*\" explain \"*) set -- \"$@\" --from start ;;\n\
         esac\n\
         exec '{own}' \"$@\"\n"
    );
    let program = folder.join("fmi-hazard");
    fs::write(&program, script).expect("a file can be written");
    fs::set_permissions(&program, fs::Permissions::from_mode(0o755)).expect("a file can be made a program");
    let paths = std::env::var_os("PATH").unwrap_or_default();
    let all = [folder, Path::new(own).parent().expect("a program is in a folder").to_owned()];
    std::env::join_paths(all.into_iter().chain(std::env::split_paths(&paths))).expect("no folder has a colon in it")
}
