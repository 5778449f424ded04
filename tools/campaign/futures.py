"""A campaign by any executor of the `concurrent.futures` kind: one call a task, what fails is given out again.

    python tools/campaign/futures.py CAMPAIGN_FOLDER                          processes of this machine
    python tools/campaign/futures.py CAMPAIGN_FOLDER --dask tcp://host:8786   a cluster of Dask distributed that is there
    python tools/campaign/futures.py CAMPAIGN_FOLDER --dask-here 4            one of this machine alone, on loopback

All machines see the folder under the same path, and have the same fmi-hazard. A task that a lost worker was at is done again by
another one; a task that is done twice gives the same. With other executors: `run(executor, tasks, command)`.
"""

import argparse
import concurrent.futures
import subprocess
import sys


def names(program, folder, option):
    """Names of tasks, as `fmi-hazard campaign status` tells them. Exit code 4 says that some are missing."""
    told = subprocess.run([program, "campaign", "status", folder, option], capture_output=True, text=True)
    if told.returncode not in (0, 4):
        raise SystemExit(told.stderr)
    return told.stdout.split()


def do(command):
    """One task, on whatever machine: its exit code, and what it said."""
    done = subprocess.run(command, capture_output=True, text=True)
    return done.returncode, done.stderr


def run(executor, tasks, command, rounds=5):
    """Does all tasks; a worker that is lost costs a try, not the campaign. Gives those that could not be done, with why."""
    left = dict.fromkeys(tasks, "not tried")
    for _ in range(rounds):
        if not left:
            break
        given = {executor.submit(do, [*command, "--task", task]): task for task in left}
        for future in concurrent.futures.as_completed(given):
            task = given[future]
            try:
                code, said = future.result()
            except Exception as lost:  # The executor's own: a worker is gone, a call was cancelled.
                left[task] = f"{type(lost).__name__}: {lost}"
                continue
            if code == 0:
                del left[task]
            else:
                left[task] = f"exit code {code}: {said.strip()[-500:]}"
    return left


def dask_executor(address, workers):
    from distributed import Client, LocalCluster

    if address:
        client = Client(address)
    else:
        client = Client(LocalCluster(n_workers=workers, threads_per_worker=1, host="127.0.0.1", dashboard_address=None))
    return client, client.get_executor(retries=3, pure=False)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--program", default="fmi-hazard", help="the program, on every machine")
    parser.add_argument("--threads", type=int, default=1, help="threads of a task")
    parser.add_argument("--workers", type=int, help="tasks at a time on this machine")
    parser.add_argument("--dask", help="address of a scheduler")
    parser.add_argument("--dask-here", type=int, metavar="N", help="N workers on this machine")
    own = parser.parse_args()
    command = [own.program, "--quiet", "campaign", "run", own.folder, "--workers", str(own.threads)]
    tasks = names(own.program, own.folder, "--missing")
    if own.dask or own.dask_here:
        client, executor = dask_executor(own.dask, own.dask_here)
        with client:
            left = run(executor, tasks, command)
    else:
        # Threads here wait for processes that do the work.
        with concurrent.futures.ThreadPoolExecutor(own.workers) as executor:
            left = run(executor, tasks, command)
    for task, why in left.items():
        print(f"{task}: {why}", file=sys.stderr)
    print(f"{len(tasks) - len(left)} of {len(tasks)} tasks done")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
