"""A Slurm cluster of one machine, for tests: real slurmctld and slurmd, on the loopback interface alone.

    python tools/campaign/slurm_here.py WHERE FOLDER COMMAND...

WHERE is a folder with Debian's packages of Slurm unpacked (tools/test makes one), FOLDER gets configuration, state and logs. COMMAND
runs with sbatch and the others on its PATH. When it ends, the daemons are ended too; their logs are shown if it failed.
"""

import os
import pathlib
import signal
import socket
import subprocess
import sys
import time


def free_ports(count):
    """Ports that nobody listens on just now."""
    sockets = [socket.socket() for _ in range(count)]
    try:
        for one in sockets:
            one.bind(("127.0.0.1", 0))
        return [one.getsockname()[1] for one in sockets]
    finally:
        for one in sockets:
            one.close()


def configuration(where, folder):
    controller, node = free_ports(2)
    host = socket.gethostname().split(".")[0]
    user = subprocess.run(["id", "-un"], capture_output=True, text=True, check=True).stdout.strip()
    plugins = next(where.glob("usr/lib/*/slurm-wlm"))
    cpus = os.cpu_count() or 1
    lines = {
        "ClusterName": "here",
        "SlurmctldHost": f"{host}(127.0.0.1)",
        "SlurmctldPort": controller,
        "SlurmdPort": node,
        "CommunicationParameters": "NoCtldInAddrAny,NoInAddrAny",
        "AuthType": "auth/none",
        "CredType": "cred/none",
        "SlurmUser": user,
        "SlurmdUser": user,
        "PluginDir": plugins,
        "StateSaveLocation": folder / "state",
        "SlurmdSpoolDir": folder / "spool",
        "SlurmctldPidFile": folder / "slurmctld.pid",
        "SlurmdPidFile": folder / "slurmd.pid",
        "SlurmctldLogFile": folder / "slurmctld.log",
        "SlurmdLogFile": folder / "slurmd.log",
        "ProctrackType": "proctrack/pgid",
        "TaskPlugin": "task/none",
        "MpiDefault": "none",
        "SwitchType": "switch/none",
        "JobAcctGatherType": "jobacct_gather/none",
        "AccountingStorageType": "accounting_storage/none",
        "JobCompType": "jobcomp/none",
        "SchedulerType": "sched/builtin",
        "SchedulerParameters": "sched_interval=1,sched_min_interval=100000,batch_sched_delay=0",
        "SelectType": "select/cons_tres",
        "SelectTypeParameters": "CR_CPU",
        "ReturnToService": 2,
        "KillWait": 2,
    }
    text = "".join(f"{key}={value}\n" for key, value in lines.items())
    text += f"NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} State=UNKNOWN\n"
    text += "PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP\n"
    for name in ["state", "spool"]:
        (folder / name).mkdir(parents=True, exist_ok=True)
    (folder / "slurm.conf").write_text(text)
    (folder / "cgroup.conf").write_text("CgroupPlugin=autodetect\n")


def programs(where, folder):
    """A folder with Slurm's programs under their usual names: Debian adds -wlm to some and links them when it installs."""
    own = folder / "bin"
    own.mkdir(exist_ok=True)
    for program in [*where.glob("usr/bin/*"), *where.glob("usr/sbin/*")]:
        link = own / program.name.removesuffix("-wlm")
        link.unlink(missing_ok=True)
        link.symlink_to(program)
    return own


def environment(where, folder):
    libraries = [*where.glob("usr/lib/*/slurm-wlm"), *where.glob("usr/lib/*-linux-gnu")]
    before = os.environ.get("LD_LIBRARY_PATH")
    return {
        **os.environ,
        "PATH": f"{programs(where, folder)}:{os.environ['PATH']}",
        "LD_LIBRARY_PATH": ":".join([*map(str, libraries), *([before] if before else [])]),
        "SLURM_CONF": str(folder / "slurm.conf"),
    }


def wait_for_node(env, daemons, seconds=30):
    """Until the node takes work."""
    ends = time.monotonic() + seconds
    while time.monotonic() < ends:
        if any(daemon.poll() is not None for daemon in daemons):
            return False
        told = subprocess.run(["sinfo", "--noheader", "--format=%t"], env=env, capture_output=True, text=True)
        if told.stdout.strip() == "idle":
            return True
        time.sleep(0.2)
    return False


def main():
    where, folder = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    folder.mkdir(parents=True, exist_ok=True)
    configuration(where, folder)
    env = environment(where, folder)
    daemons = []
    code = 1
    try:
        own = folder / "bin"
        for command in [[own / "slurmctld", "-D"], [own / "slurmd", "-D", "-d", own / "slurmstepd"]]:
            quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
            daemons.append(subprocess.Popen(command, env=env, **quiet))
        if wait_for_node(env, daemons):
            code = subprocess.run(sys.argv[3:], env=env).returncode
        else:
            print("Slurm does not start here", file=sys.stderr)
    finally:
        for daemon in reversed(daemons):
            daemon.send_signal(signal.SIGTERM)
        for daemon in daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()
        if code != 0:
            for name in ["slurmctld", "slurmd"]:
                log = folder / f"{name}.log"
                if log.exists():
                    print(f"{name}: ...{log.read_text()[-3000:]}", file=sys.stderr)
    return code


if __name__ == "__main__":
    sys.exit(main())
