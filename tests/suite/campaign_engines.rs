//! Campaigns by real engines give the bytes of one process: a Slurm array by real daemons on loopback, Dask distributed with a worker
//! that is killed in the middle, any executor of Python's `concurrent.futures`. Needs what `tools/test` installs.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::campaigns::{DAY, half_a_day, merged};
use crate::common::fmpy::python;
use crate::common::{examples, fmi_hazard, write};
use crate::sample;

fn tool(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tools/campaign").join(name)
}

/// Slurm's packages, unpacked.
fn slurm() -> PathBuf {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join(".venv/slurm");
    let slurm = std::env::var_os("FMI_HAZARD_SLURM").map_or(own, PathBuf::from);
    assert!(slurm.join("usr/bin/sbatch").is_file(), "no Slurm at {}: run tools/test once", slurm.display());
    slurm
}

fn told(output: &Output) -> String {
    [&output.stdout, &output.stderr].map(|said| String::from_utf8_lossy(said).into_owned()).concat()
}

/// Plans the day with a divided search beside it, in so many folders.
fn planned(dir: &Path, folders: &[&str]) {
    write(dir, "day.toml", DAY);
    // The first start at the first time, in four parts.
    let parts = DAY.replace("begins_s", "# begins_s").replace("other_starts", "# other_starts");
    let parts = parts.replace("actions = 2", "actions = 4").replace("\"day\"", "\"parts\"");
    write(dir, "parts.toml", &(parts + "\n[search]\nparts = 4\n"));
    for folder in folders {
        for campaign in ["day", "parts"] {
            let plan = ["campaign", "plan", &format!("{campaign}.toml"), "--out", &format!("{folder}-{campaign}")];
            fmi_hazard(dir).args(plan).assert().code(0);
        }
    }
}

/// A campaign of a folder, of which nothing is missing, is what one process gives.
fn same(dir: &Path, folder: &str, campaign: &str) {
    let [one, other] = ["one", folder].map(|folder| format!("{folder}-{campaign}"));
    assert_eq!(fmi_hazard(dir).args(["campaign", "status", &other, "--missing"]).output().unwrap().stdout, b"");
    fmi_hazard(dir).args(["campaign", "merge", &other]).assert().code(1);
    let [one, other] = [one, other].map(|folder| merged(&dir.join(folder)));
    assert!(one.len() > 3 && one == other, "{folder} {campaign}");
}

/// A campaign by threads of one process, as any executor of that kind.
fn by_threads(dir: &Path, campaign: &str) {
    let output = Command::new(python())
        .arg(tool("futures.py"))
        .args([format!("threads-{campaign}").as_str(), "--workers", "2", "--program", env!("CARGO_BIN_EXE_fmi-hazard")])
        .current_dir(dir)
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", told(&output));
    same(dir, "threads", campaign);
}

/// One start at four times.
#[test]
fn threads_give_what_one_process_gives() {
    if !sample::is_turn(4, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    write(dir, "day.toml", &half_a_day().replace("other_starts", "# other_starts"));
    for folder in ["one-day", "threads-day"] {
        fmi_hazard(dir).args(["campaign", "plan", "day.toml", "--out", folder]).assert().code(0);
    }
    fmi_hazard(dir).args(["campaign", "run", "one-day"]).assert().code(0);
    fmi_hazard(dir).args(["campaign", "merge", "one-day"]).assert().code(1);
    by_threads(dir, "day");
}

#[test]
#[ignore = "a minute: a queue's daemons and a cluster; `threads_give_what_one_process_gives` and `campaigns` are without them"]
fn slurm_dask_and_threads_give_what_one_process_gives() {
    let dir = examples();
    let dir = dir.path();
    planned(dir, &["one", "slurm", "dask", "threads"]);
    for campaign in ["one-day", "one-parts"] {
        fmi_hazard(dir).args(["campaign", "run", campaign]).assert().code(0);
        fmi_hazard(dir).args(["campaign", "merge", campaign]).assert().code(1);
    }
    slurm_array(dir);
    dask_with_a_worker_killed(dir);
    by_threads(dir, "parts");
}

/// Both campaigns as arrays, by real daemons.
fn slurm_array(dir: &Path) {
    let script = tool("slurm_array.sh").display().to_string();
    let submit = |campaign: &str, array: &str| {
        format!("sbatch --wait --array={array} --output=%A-%a.log {script} {}/slurm-{campaign}", dir.display())
    };
    // Numbers need not begin with 0; the second is given out twice, as Slurm does after a node has failed.
    let commands = [submit("day", "1-4"), submit("parts", "0-3"), submit("parts", "0-3")].join(" && ");
    let output = Command::new(python())
        .arg(tool("slurm_here.py"))
        .args([slurm(), dir.join("cluster")])
        .args(["bash", "-euc", &commands])
        .current_dir(dir)
        .env("FMI_HAZARD", env!("CARGO_BIN_EXE_fmi-hazard"))
        .output()
        .unwrap();
    let logs = || {
        let files = std::fs::read_dir(dir).unwrap().map(|entry| entry.unwrap().path());
        let logs = files.filter(|path| path.extension().is_some_and(|e| e == "log"));
        logs.map(|path| std::fs::read_to_string(path).unwrap()).collect::<String>()
    };
    assert!(output.status.success(), "{}{}", told(&output), logs());
    same(dir, "slurm", "day");
    same(dir, "slurm", "parts");
}

/// Both campaigns by Dask. A worker is killed as soon as three tasks are there.
fn dask_with_a_worker_killed(dir: &Path) {
    let program = r#"
import os, signal, sys, threading, time, pathlib
sys.path.insert(0, sys.argv[1])
import futures
from distributed import Client, LocalCluster

def kill_one(client, folder):
    while len([f for f in (pathlib.Path(folder) / "tasks").glob("*") if not f.name.startswith(".")]) < 3:
        time.sleep(0.02)
    before = set(client.run(os.getpid).values())
    victim = min(before)
    os.kill(victim, signal.SIGKILL)
    print("killed", victim)

if __name__ == "__main__":
    program, day, parts = sys.argv[2:5]
    cluster = LocalCluster(n_workers=2, threads_per_worker=1, host="127.0.0.1", dashboard_address=None)
    with cluster, Client(cluster) as client, client.get_executor(retries=3, pure=False) as executor:
        os.makedirs(f"{day}/tasks", exist_ok=True)
        threading.Thread(target=kill_one, args=(client, day)).start()
        for folder in [day, parts]:
            tasks = futures.names(program, folder, "--missing")
            left = futures.run(executor, tasks, [program, "campaign", "run", folder, "--workers", "1"])
            print(folder, len(tasks), left)
            assert not left
"#;
    let script = write(dir, "killed.py", program);
    let own = env!("CARGO_BIN_EXE_fmi-hazard");
    let output = Command::new(python())
        .arg(script)
        .arg(tool(""))
        .args([own, "dask-day", "dask-parts"])
        .current_dir(dir)
        .output()
        .unwrap();
    let said = told(&output);
    assert!(output.status.success() && said.contains("killed") && said.contains("dask-day 24 {}"), "{said}");
    same(dir, "dask", "day");
    same(dir, "dask", "parts");
}
