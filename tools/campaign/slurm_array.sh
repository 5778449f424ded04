#!/usr/bin/env bash
# A campaign as a Slurm array: each task of the array does its share of the campaign, with as many threads as it has processors.
#
#     fmi-hazard campaign plan day.toml --out out/day
#     sbatch --array=0-99 tools/campaign/slurm_array.sh out/day
#     fmi-hazard campaign merge out/day        # when all have ended; before that, it says what is missing
#
# A task that was ended (its time was up, its node failed) is given out again by Slurm, or by the same line: what is done is left out.
# The folder is on a disk that all nodes see. FMI_HAZARD names the program, if it is not on the PATH.
#SBATCH --requeue
#SBATCH --open-mode=append
set -euo pipefail
campaign="$1"
first="${SLURM_ARRAY_TASK_MIN:-0}"
share="$((SLURM_ARRAY_TASK_ID - first + 1))/$SLURM_ARRAY_TASK_COUNT"
# Slurm ends a job with SIGTERM; the program then stops within a second.
exec "${FMI_HAZARD:-fmi-hazard}" --quiet campaign run "$campaign" --shard "$share" --workers "${SLURM_CPUS_PER_TASK:-1}"
