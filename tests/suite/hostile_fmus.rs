//! FMUs whose binary is missing, foreign, damaged, incomplete or hostile: a clear message, never a crash of ours. Each is
//! made here from a working test FMU, or compiled, by one change.

use crate::common::archives::{
    BINARY, Entries, entries, entries_of, folder_with, pack, refused, run, same, with_binary, with_xml,
};
use crate::common::fmi_hazard;
use crate::sample;

/// The files of the test FMU under other names.
fn renamed(from: &str, to: &str) -> Vec<u8> {
    let all: Entries = entries().into_iter().map(|(n, c)| (n.replace(from, to), c)).collect();
    pack(&all)
}

#[test]
fn binaries_for_other_machines() {
    let none = |found: &str, more: &str| {
        format!(
            "x.fmu: this FMU has no binary for this machine: linux64 is needed, it contains {found}. Ask its maker for a \
             linux64 export, or run this program on a machine it was made for{more}"
        )
    };
    refused("inspect --self-test", &renamed("linux64", "win64"), &none("win64", ""));
    refused("inspect --self-test", &renamed("linux64", "x86_64-linux"), &none("x86_64-linux", ""));
    let sources = renamed("binaries/linux64/faulty.so", "sources/faulty.c");
    refused(
        "inspect --self-test",
        &sources,
        &none("no binaries at all", ", or compile the sources in it (`fmpy compile` does that)"),
    );
    refused("inspect --self-test", &renamed(BINARY, "binaries/linux64"), &none("no binaries at all", ""));
    refused("inspect --self-test", &renamed("linux64", "win\u{202e}46"), &none("win\\u{202e}46", ""));
}

#[test]
fn binaries_of_another_name() {
    let other = |found: &str| {
        format!(
            "x.fmu: binaries/linux64 has no faulty.so, the name that modelDescription.xml gives; it contains {found}. \
             Export the FMU again"
        )
    };
    refused("inspect --self-test", &renamed("faulty.so", "other.so"), &other("other.so"));
    refused("inspect --self-test", &renamed("faulty.so", "faulty.SO"), &other("faulty.SO"));
    refused("inspect --self-test", &renamed("faulty.so", "faulty.so/readme"), &other("faulty.so"));
}

#[test]
fn files_that_are_no_library_for_this_machine() {
    let cannot = |why: &str| format!("x.fmu: faulty.so cannot be loaded: it {why}. Export the FMU for linux64");
    refused("inspect --self-test", &with_binary(|_| b"a letter".to_vec()), &cannot("is not a shared library"));
    refused("inspect --self-test", &with_binary(|_| Vec::new()), &cannot("is not a shared library"));
    let elf32 = |b: &[u8]| [&b[..4], &[1], &b[5..]].concat();
    refused("inspect --self-test", &with_binary(elf32), &cannot("is a 32-bit library"));
    // e_machine at offset 18: 0xB7 is AArch64.
    let arm = |b: &[u8]| [&b[..18], &[0xB7, 0], &b[20..]].concat();
    refused("inspect --self-test", &with_binary(arm), &cannot("is for another processor"));
    refused("inspect --self-test", &with_binary(|_| b"MZ\x90\0".to_vec()), &cannot("is a library for Windows"));
    refused("inspect --self-test", &with_binary(|_| vec![0xCF, 0xFA, 0xED, 0xFE]), &cannot("is a library for macOS"));
    refused("inspect --self-test", &with_binary(|_| vec![0xCA, 0xFE, 0xBA, 0xBE]), &cannot("is a library for macOS"));
}

#[test]
fn truncated_binaries_never_reach_the_loader() {
    let whole = entries().into_iter().find(|(name, _)| name == BINARY).unwrap().1.len();
    for length in [1, 4, 16, 63, 64, 65, 500, 4096, 5000, whole / 4, whole / 2, whole * 9 / 10, whole - 1] {
        let dir = folder_with(&with_binary(|b| b[..length].to_vec()));
        let (code, stdout, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu"]);
        let whys = ["is truncated", "is damaged", "is not a shared library"];
        let said = |why: &&str| {
            stderr == format!("Error: × x.fmu: faulty.so cannot be loaded: it {why}. Export the FMU for linux64")
        };
        assert!(whys.iter().any(said), "{length} of {whole}: {stderr}");
        assert_eq!((code, stdout.as_str()), (2, ""));
    }
}

/// A library compiled from C, with more words for the compiler.
fn compiled(source: &str, arguments: &[&str]) -> Vec<u8> {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::write(dir.path().join("f.c"), source).unwrap();
    let status = std::process::Command::new("cc")
        .args(["-shared", "-fPIC", "-o", "f.so", "f.c"])
        .args(arguments)
        .current_dir(dir.path())
        .status()
        .unwrap();
    assert!(status.success());
    std::fs::read(dir.path().join("f.so")).unwrap()
}

/// The functions that an FMI 2.0 FMU of ours needs, with a body for `fmi2DoStep`.
fn source_with_step(body: &str) -> String {
    format!(
        "#include <stdlib.h>\n#include <unistd.h>\n\
         void *fmi2Instantiate(void) {{ return malloc(1); }}\n\
         void fmi2FreeInstance(void *c) {{ free(c); }}\n\
         int fmi2SetupExperiment(void) {{ return 0; }}\n\
         int fmi2EnterInitializationMode(void) {{ return 0; }}\n\
         int fmi2ExitInitializationMode(void) {{ return 0; }}\n\
         int fmi2SetReal(void) {{ return 0; }}\nint fmi2SetBoolean(void) {{ return 0; }}\n\
         int fmi2GetReal(void *c, const unsigned *v, size_t n, double *x) {{ while (n--) x[n] = 1; return 0; }}\n\
         int fmi2DoStep(void) {{ {body} }}\n"
    )
}

fn binary_with_step(body: &str) -> Vec<u8> {
    compiled(&source_with_step(body), &[])
}

#[test]
fn libraries_and_functions_that_are_missing_outside_the_fmu() {
    let cannot = |library: &[u8], why: &str, advice: &str| {
        let dir = folder_with(&with_binary(|_| library.to_vec()));
        let (code, _, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu"]);
        assert!(stderr.starts_with("Error: × x.fmu: the binary of this FMU cannot be loaded: "), "{stderr}");
        assert!(stderr.contains(why) && stderr.contains(advice), "{stderr}");
        // Where it lies may be closed to an FMU.
        assert_eq!(stderr.contains("--trust-fmu"), why.contains("cannot open shared object file"), "{stderr}");
        assert_eq!(code, 2);
    };
    let calls = |function: &str| {
        let source = source_with_step(&format!("void {function}(void); {function}(); return 0;"));
        compiled(&source, &[])
    };
    let incomplete = ". The export is incomplete: ask its maker for one that brings this function";
    cannot(&calls("vendor_function"), "undefined symbol: vendor_function", incomplete);
    let python = ". It is written in Python and needs Python's library: start this program with LD_PRELOAD set to that \
                  library, for instance LD_PRELOAD=libpython3.11.so.1 (on Debian 12 in the package libpython3.11)";
    cannot(&calls("_Py_NoneStruct"), "undefined symbol: _Py_NoneStruct", python);
    cannot(&calls("PyErr_Print"), "undefined symbol: PyErr_Print", python);
    for (name, advice) in [
        ("libvendor.so.1", ". Install the library that is named here"),
        ("libgfortran.so.3", ". On Debian the package libgfortran5 has the present version of this library"),
    ] {
        // A library that is there when linking, and not when loading.
        let dir = tempfile::TempDir::new().unwrap();
        std::fs::write(
            dir.path().join("l.so"),
            compiled("void there(void) {}", &["-Wl,-soname", &format!("-Wl,{name}")]),
        )
        .unwrap();
        let at = dir.path().join("l.so");
        let library = compiled(&source_with_step("void there(void); there(); return 0;"), &[at.to_str().unwrap()]);
        cannot(&library, &format!("{name}: cannot open shared object file: No such file or directory"), advice);
    }
    // The mathematical library, which many exports forget to name, is brought along.
    let library = compiled(
        &source_with_step("extern double sqrt(double); volatile double x = 2; return sqrt(x) < 1;"),
        &["-fno-builtin"],
    );
    let dir = folder_with(&with_binary(|_| library.clone()));
    assert_eq!(run(dir.path(), &["inspect", "--self-test", "x.fmu", "--steps", "8"]).0, 0);
}

#[test]
fn functions_that_are_missing_in_the_fmu() {
    for function in [
        "fmi2Instantiate",
        "fmi2FreeInstance",
        "fmi2SetupExperiment",
        "fmi2EnterInitializationMode",
        "fmi2ExitInitializationMode",
        "fmi2DoStep",
    ] {
        let library = compiled(&source_with_step("return 0;").replace(function, "another"), &[]);
        let message = "which every FMI 2.0 co-simulation FMU must have. Ask its maker for a complete export";
        let message = format!("x.fmu: the binary of this FMU lacks {function}, {message}");
        refused("inspect --self-test", &with_binary(|_| library.clone()), &message);
    }
    // One that is needed for some variables only is missed when it is needed.
    let library = compiled(&source_with_step("return 0;").replace("fmi2SetBoolean", "another"), &[]);
    let dir = folder_with(&with_binary(|_| library.clone()));
    let (code, _, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "Error: × the FMU failed in its first plain run: setting `stop` (value reference 3): the FMU does not have \
         fmi2SetBoolean, which is needed here";
    same(&stderr, text);
    assert_eq!(code, 3);
}

#[test]
fn state_functions_that_are_declared_and_missing_are_done_without() {
    let library = binary_with_step("return 0;");
    let dir = folder_with(&with_binary(|_| library.clone()));
    let (code, stdout, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu", "--steps", "8"]);
    for text in [
        "restored state, two held at once       FAILED: the FMU does not have fmi2GetFMUstate, which is needed here\n",
        "A scan brings states back by: fresh instance and replay (the FMU says it can save its state, but does not do it",
    ] {
        assert!(stdout.contains(text), "{stdout}");
    }
    assert_eq!((code, stderr.as_str()), (0, ""));
}

#[test]
fn a_state_of_more_bytes_than_there_is_memory_is_not_asked_for() {
    let source = source_with_step("return 0;")
        + "int fmi2GetFMUstate(void *c, void **s) { if (!*s) *s = malloc(1); return 0; }\n\
           int fmi2SetFMUstate(void *c, void *s) { return 0; }\n\
           int fmi2FreeFMUstate(void *c, void **s) { free(*s); *s = 0; return 0; }\n\
           int fmi2Reset(void *c) { return 0; }\n\
           int fmi2SerializedFMUstateSize(void *c, void *s, size_t *n) { *n = (size_t)-1; return 0; }\n\
           int fmi2SerializeFMUstate(void *c, void *s, char *b, size_t n) { return 0; }\n\
           int fmi2DeSerializeFMUstate(void *c, const char *b, size_t n, void **s) { return 3; }\n";
    let library = compiled(&source, &[]);
    let dir = folder_with(&with_binary(|_| library.clone()));
    let (code, stdout, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu", "--steps", "8"]);
    let text = "serialised state in another instance   FAILED: fmi2SerializedFMUstateSize says that a state has \
                18446744073709551615 bytes, which cannot be\n";
    assert!(stdout.contains(text), "{stdout}");
    assert_eq!((code, stderr.as_str()), (0, ""));
}

#[test]
fn fmi_3_binaries_are_told_apart_too() {
    let with = |change: fn(&mut (String, Vec<u8>))| {
        let mut all = entries_of("faulty-fmi3.fmu");
        all.iter_mut().filter(|(name, _)| name.ends_with(".so")).for_each(change);
        pack(&all)
    };
    let other = with(|(name, _)| *name = name.replace("x86_64-linux", "linux64"));
    let none = "x.fmu: this FMU has no binary for this machine: x86_64-linux is needed, it contains linux64. Ask its maker \
                for a x86_64-linux export, or run this program on a machine it was made for";
    refused("inspect --self-test", &other, none);
    let empty = with(|(_, content)| *content = compiled("int nothing;", &[]));
    let lacks = "x.fmu: the binary of this FMU lacks fmi3FreeInstance, which every FMI 3.0 co-simulation FMU must have. Ask \
                 its maker for a complete export";
    refused("inspect --self-test", &empty, lacks);
    let text = with(|(_, content)| *content = b"a letter".to_vec());
    let letter = "x.fmu: faulty.so cannot be loaded: it is not a shared library. Export the FMU for x86_64-linux";
    refused("inspect --self-test", &text, letter);
}

/// That it is refused without it shows in its first run, and counts in all other processes.
#[test]
fn an_fmu_that_needs_event_mode_has_it_in_every_process() {
    let source = "#include <stdbool.h>\n#include <stdlib.h>\n\
                  void *fmi3InstantiateCoSimulation(const char *n, const char *t, const char *r, bool v, bool l, bool events)\n\
                  { return events ? malloc(1) : 0; }\n\
                  void fmi3FreeInstance(void *c) { free(c); }\n\
                  int fmi3EnterInitializationMode(void) { return 0; }\n\
                  int fmi3ExitInitializationMode(void) { return 0; }\n\
                  int fmi3EnterEventMode(void) { return 0; }\nint fmi3EnterStepMode(void) { return 0; }\n\
                  int fmi3UpdateDiscreteStates(void) { return 0; }\nint fmi3DoStep(void) { return 0; }\n\
                  int fmi3SetFloat64(void) { return 0; }\nint fmi3SetBoolean(void) { return 0; }\n\
                  int fmi3GetFloat64(void *c, const unsigned *v, size_t n, double *x) { while (n--) x[n] = 1; return 0; }\n";
    let library = compiled(source, &[]);
    let mut all = entries_of("faulty-fmi3.fmu");
    all.iter_mut().filter(|(name, _)| name.ends_with(".so")).for_each(|(_, content)| content.clone_from(&library));
    let dir = folder_with(&pack(&all));
    let (code, stdout, stderr) =
        run(dir.path(), &["inspect", "--self-test", "x.fmu", "--steps", "8", "--format", "json"]);
    assert_eq!(code, 0, "{stdout}{stderr}");
    let told: serde_json::Value = serde_json::from_str(&stdout).unwrap();
    for runs in ["deterministic", "second_instance", "fresh_process"] {
        assert_eq!(told[runs]["result"], "exact", "{runs}: {told}");
    }
}

#[test]
fn a_binary_of_another_version_than_its_xml() {
    let source = source_with_step("return 0;") + "const char *fmi2GetVersion(void) { return \"2.1\\033[2J\"; }\n";
    let library = compiled(&source, &[]);
    let message = "x.fmu: the binary is of FMI version \"2.1\\u{1b}[2J\", its XML says \"2.0\". Export the FMU again";
    refused("inspect --self-test", &with_binary(|_| library.clone()), message);
}

#[test]
fn a_guid_that_does_not_fit_is_explained_with_the_fmus_own_words() {
    let xml = with_xml(|x| {
        let start = x.find("guid=\"").unwrap() + 6;
        let end = start + x[start..].find('"').unwrap();
        format!("{}wrong{}", &x[..start], &x[end..])
    });
    let (code, _, stderr) = run(folder_with(&xml).path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "Error: × the FMU failed in its first plain run: the FMU refused to be instantiated: binary and \
                modelDescription.xml come from different exports. Export the FMU again its last log lines: \
                [logStatusError] ";
    assert!(stderr.starts_with(text), "{stderr}");
    assert_eq!(code, 3);
}

#[test]
fn fmus_that_allow_one_instance_or_need_their_tool_say_why_they_refuse() {
    let flags = |flags: &str, library: &[u8]| {
        let library = library.to_vec();
        let mut all = entries();
        for (name, content) in &mut all {
            if name == BINARY {
                content.clone_from(&library);
            } else if name == crate::common::archives::XML {
                let text = String::from_utf8(content.clone()).unwrap();
                *content = text.replace("canBeInstantiatedOnlyOncePerProcess=\"false\"", flags).into_bytes();
            }
        }
        pack(&all)
    };
    let refusing = compiled(&source_with_step("return 0;").replace("return malloc(1);", "return 0;"), &[]);
    let (code, _, stderr) =
        run(folder_with(&flags("needsExecutionTool=\"true\"", &refusing)).path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "Error: × the FMU failed in its first plain run: the FMU refused to be instantiated: it needs the tool \
                that made it (needsExecutionTool). Install and license that tool on this machine";
    same(&stderr, text);
    assert_eq!(code, 3);
    let source = source_with_step("return 0;");
    let once = compiled(&source.replace("return malloc(1);", "static int n; return n++ ? 0 : malloc(1);"), &[]);
    let fmu = flags("canBeInstantiatedOnlyOncePerProcess=\"true\"", &once);
    let (code, stdout, _) = run(folder_with(&fmu).path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "FAILED: the FMU refused to be instantiated: it allows one instance in a process only";
    assert!(stdout.contains(text), "{stdout}");
    // Each run has a process of its own then.
    assert!(stdout.contains("brings states back by: ") && stdout.contains("runs once in a process"), "{stdout}");
    assert_eq!(code, 0);
}

#[test]
fn variables_that_the_binary_does_not_know_are_named() {
    let fmu = with_xml(|x| x.replace("name=\"qd\" valueReference=\"6\"", "name=\"qd\" valueReference=\"999\""));
    let (code, _, stderr) = run(folder_with(&fmu).path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "Error: × the FMU failed in its first plain run: reading `qd` (value reference 999): the FMU returned \
                Error from fmi2GetReal its last log lines: [logStatusError] ";
    assert!(stderr.starts_with(text) && stderr.contains("999"), "{stderr}");
    assert_eq!(code, 3);
    // The wrong type: the binary knows `stop` as a Boolean.
    let fmu = with_xml(|x| x.replace("<Boolean start=\"false\"/>", "<Real/>"));
    let (code, _, stderr) = run(folder_with(&fmu).path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "Error: × the FMU failed in its first plain run: setting `stop` (value reference 3), `push` (value \
                reference 4): the FMU returned Error from fmi2SetReal its last log lines: [logStatusError] ";
    assert!(stderr.starts_with(text), "{stderr}");
    assert_eq!(code, 3);
}

#[test]
fn what_is_no_number_before_the_first_step_is_not_put_down_to_its_size() {
    let library = compiled(&source_with_step("return 0;").replace("x[n] = 1", "x[n] = 0.0 / 0.0"), &[]);
    let (code, _, stderr) =
        run(folder_with(&with_binary(|_| library.clone())).path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "is NaN (not a number) at t = 0.000 s; before its first step: look at the start values";
    assert!(code == 3 && stderr.contains(text) && !stderr.contains("too long"), "{stderr}");
}

#[test]
fn what_an_fmu_says_does_not_steer_the_terminal() {
    let log = "struct { void (*log)(void *, const char *, int, const char *, const char *, ...); void *m[3]; void *env; } *cb";
    let source = source_with_step("return 0;").replace(
        "void *fmi2Instantiate(void) { return malloc(1); }",
        &format!(
            "void *fmi2Instantiate(const char *a, int b, const char *c, const char *d, void *e) {{ {log} = e; \
             cb->log(cb->env, a, 3, \"c\\033[1m\", \"\\033[2J\\342\\200\\256%s\", \"x\"); return 0; }}"
        ),
    );
    let library = compiled(&source, &["-Wno-incompatible-pointer-types"]);
    let (code, _, stderr) =
        run(folder_with(&with_binary(|_| library.clone())).path(), &["inspect", "--self-test", "x.fmu"]);
    let text = "Error: × the FMU failed in its first plain run: the FMU refused to be instantiated its last log lines: \
                [c\\u{1b}[1m] \\u{1b}[2J\\u{202e}x";
    same(&stderr, text);
    assert_eq!(code, 3);
}

/// What is said of an FMU that the sandbox may have made fail.
const SANDBOX: &str = "the sandbox may be why: there an FMU may read its own files and the system's libraries and write into \
                       its working folder, but not open other files, make temporary ones elsewhere, use the network or \
                       start programs. If you trust it: --trust-fmu";

#[test]
fn a_crash_carries_what_the_fmu_printed_and_logged_shortly_before() {
    let log =
        "struct { void (*log)(void *, const char *, int, const char *, const char *, ...); void *m[3]; void *env; }";
    // Six lines on both ways and to the logger, the first of them too old to be told; standard output is not flushed.
    let source = format!(
        "#include <stdio.h>\nstatic {log} *cb;\n{}",
        source_with_step(
            "static int n; if (++n < 12) return 0; printf(\"oldest\\nopening table\\n\"); fprintf(stderr, \"no table\\n\"); \
             cb->log(cb->env, \"a\", 0, \"all\", \"row %d\", 7); printf(\"\\033[2Jpivot 0\\nlast words\\n\"); abort();"
        )
    )
    .replace(
        "void *fmi2Instantiate(void) { return malloc(1); }",
        "void *fmi2Instantiate(const char *a, int b, const char *c, const char *d, void *e) { cb = e; return malloc(1); }",
    );
    let library = compiled(&source, &["-Wno-incompatible-pointer-types"]);
    let dir = folder_with(&with_binary(|_| library.clone()));
    let (code, _, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu"]);
    // Not in its beginning: the sandbox is not named.
    let text = "Error: × the FMU failed in its first plain run: the FMU ended its process (signal 6, SIGABRT, abort) in a \
                step, number 12 of its run the last lines that it printed: opening table no table [all] row 7 \
                \\u{1b}[2Jpivot 0 last words";
    same(&stderr, text);
    assert_eq!(code, 3);
}

#[test]
fn what_only_the_sandbox_denies_names_the_way_out() {
    // A temporary file elsewhere, which is then written to, used or complained about.
    let source =
        |step: &str| format!("#include <stdio.h>\n#include <errno.h>\n#include <string.h>\n{}", source_with_step(step));
    let open = "static int n; FILE *f = n++ < FIRST ? (FILE *)1 : tmpfile();";
    for (first, rest, words) in [
        ("0", "fputs(\"x\", f); return 0;", "If it fails here only, the sandbox may be why"),
        ("9", "if (f) return 0; perror(\"table\"); abort();", "It was denied something, maybe by the sandbox"),
        ("9", "if (f) return 0; perror(\"table\"); return 3;", "It was denied something, maybe by the sandbox"),
        ("9", "if (f) return 0; abort();", ""),
    ] {
        let library = compiled(&source(&format!("{open} {rest}").replace("FIRST", first)), &[]);
        let dir = folder_with(&with_binary(|_| library.clone()));
        let (code, _, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu"]);
        assert_eq!(code, 3, "{rest}: {stderr}");
        assert!(stderr.contains(words) && stderr.contains("--trust-fmu") != words.is_empty(), "{rest}: {stderr}");
    }
    // One that refuses to begin, and does not say why.
    let library = compiled(&source_with_step("return 0;").replace("return malloc(1);", "return 0;"), &[]);
    let (_, _, stderr) =
        run(folder_with(&with_binary(|_| library.clone())).path(), &["inspect", "--self-test", "x.fmu"]);
    same(
        &stderr,
        &format!(
            "Error: × the FMU failed in its first plain run: the FMU refused to be instantiated. If it fails here only, {SANDBOX}"
        ),
    );
}

#[test]
fn an_fmu_that_kills_its_process_is_a_finding_and_not_a_crash_of_ours() {
    for (body, words) in [
        ("*(volatile int *)0 = 1; return 0;", "signal 11, SIGSEGV, invalid memory access"),
        ("abort();", "signal 6, SIGABRT, abort"),
        ("exit(0);", "exit code 0"),
    ] {
        let library = binary_with_step(body);
        let dir = folder_with(&with_binary(|_| library.clone()));
        let (code, _, stderr) = run(dir.path(), &["inspect", "--self-test", "x.fmu"]);
        let message = "Error: × the FMU failed in its first plain run: the FMU ended its process";
        same(&stderr, &format!("{message} ({words}) in a step, number 1 of its run. If it fails here only, {SANDBOX}"));
        assert_eq!(code, 3);
    }
}

#[test]
fn an_fmu_that_fails_on_the_way_leaves_valid_results_and_unevaluated_sequences() {
    let dir = tempfile::TempDir::new().unwrap();
    let library = binary_with_step("static int n; return ++n > 1500 ? 3 : 0;");
    std::fs::write(dir.path().join("x.fmu"), with_binary(|_| library.clone())).unwrap();
    let cell =
        crate::common::faulty_cell("x.fmu", 0, 0).replace("[parameters]\n\"fault.kind\" = 0\n\"fault.step\" = 0\n", "");
    crate::common::write(dir.path(), "cell.toml", &cell.replace("iterations = 12", "iterations = 400"));
    let output = fmi_hazard(dir.path())
        .args(["scan", "--no-advice", "cell.toml", "--strategy", "mcts-dpw", "--out", "o"])
        .output()
        .unwrap();
    let scan = crate::common::scan_json(&dir.path().join("o"));
    assert!(scan["coverage"]["episodes_not_evaluated"].as_u64().unwrap() > 0, "{}", scan["coverage"]);
    assert!(scan["faults"][0]["message"].as_str().unwrap().contains("fmi2DoStep"), "{}", scan["faults"]);
    assert!(!scan["faults"][0]["actions"].as_array().unwrap().is_empty());
    let expected = if scan["hazards"].as_array().unwrap().is_empty() { 3 } else { 1 };
    assert_eq!(output.status.code(), Some(expected), "{}", String::from_utf8_lossy(&output.stderr));
}

#[test]
fn an_fmu_that_ends_a_scan_leaves_what_was_found_until_then() {
    if !sample::is_turn(2, 4) {
        return;
    }
    let dir = tempfile::tempdir().unwrap();
    let dir = dir.path();
    let [count, most] = ["count", "most"].map(|name| dir.join(name));
    // A turning robot, and a licence for so many instances.
    let source = source_with_step("t += 0.02; return 0;")
        .replace("x[n] = 1", "x[n] = n ? 1 : t")
        .replace(
            "void *fmi2Instantiate(void) { return malloc(1); }",
            &format!(
                "static double t; void *fmi2Instantiate(void) {{ long most = 0; t = 0; FILE *f = fopen(\"{}\", \"a\"); fputc('x', \
                 f); long k = ftell(f); fclose(f); f = fopen(\"{}\", \"r\"); fscanf(f, \"%ld\", &most); fclose(f); return k > \
                 most ? 0 : malloc(1); }}",
                count.display(),
                most.display()
            ),
        );
    let library = compiled(&format!("#include <stdio.h>\n{source}"), &[]);
    std::fs::write(dir.join("x.fmu"), with_binary(|_| library.clone())).unwrap();
    let cell =
        crate::common::faulty_cell("x.fmu", 0, 0).replace("[parameters]\n\"fault.kind\" = 0\n\"fault.step\" = 0\n", "");
    let cell = crate::common::nearer(&cell).replace("iterations = 30", "iterations = 10\nactions = 1");
    crate::common::write(dir, "cell.toml", &cell);
    for strategy in sample::some(["mcts-dpw", "exhaustive", "auto"], 3) {
        let scan = |licence: u64| {
            let _ = std::fs::remove_file(&count);
            let _ = std::fs::remove_dir_all(dir.join("o"));
            std::fs::write(&most, licence.to_string()).unwrap();
            let how = ["--from", "start", "--no-advice", "--trust-fmu", "--strategy", strategy, "--out", "o"];
            let (code, stdout, stderr) = run(dir, &[&["scan", "cell.toml"], &how[..]].concat());
            (code, stdout, stderr, std::fs::metadata(&count).unwrap().len())
        };
        let (code, _, stderr, needed) = scan(u64::MAX / 2);
        assert_eq!(code, 1, "{stderr}");
        let whole = crate::common::scan_json(&dir.join("o"))["hazards"].as_array().unwrap().len();
        let mut ended = 0;
        for licence in [1, 3, 8, 14].map(|fewer| needed.saturating_sub(fewer)) {
            let (code, stdout, stderr, _) = scan(licence);
            let found = std::fs::read_to_string(dir.join("o/hazards.jsonl")).unwrap_or_default();
            if code == 3 {
                assert!(found.is_empty(), "{strategy} {licence} of {needed}: {stderr}");
                continue;
            }
            ended += 1;
            assert!(code == 1 && stdout.contains("possible hazard"), "{strategy} {licence}: {stdout} {stderr}");
            let scan = crate::common::scan_json(&dir.join("o"));
            let hazards = scan["hazards"].as_array().unwrap();
            assert!(!hazards.is_empty() && hazards.len() <= whole, "{strategy} {licence} of {needed}");
            let unconfirmed = hazards.iter().any(|hazard| hazard["confirmed"].is_null());
            assert!(!unconfirmed || scan["certificate"]["complete"] != true, "{strategy} {licence}");
            assert!(
                hazards.iter().all(|hazard| hazard["confirmed"] != false),
                "{strategy} {licence}: none was refuted"
            );
        }
        assert!(ended > 0, "{strategy}");
    }
}
