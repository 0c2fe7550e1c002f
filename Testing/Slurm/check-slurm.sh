#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Runs a study under a real Slurm of one node, this machine: started here for the time of the check,
# with its state in a temporary folder, away from any other.
#
#   check-slurm.sh BUILD-FOLDER      # as root; Debian: slurm-wlm munge openmpi-bin
#
# Not one of ctest's tests, since it needs root and daemons. What is checked: a job of two tasks leaves
# what a plain run leaves; a job that is told that its time is over saves, is queued again and goes on.
set -eu

program=$(realpath "$1")/bin/pemesh
work=$(mktemp -d)
node=$(hostname -s)
say() { printf '==> %s\n' "$*"; }
fail() { printf 'check-slurm.sh: %s\n' "$*" >&2; exit 1; }
for tool in munged slurmctld slurmd sbatch mpiexec; do
  PATH=$PATH:/usr/sbin command -v $tool >/dev/null || fail "$tool is missing: apt-get install slurm-wlm munge openmpi-bin"
done
daemons=()
clean_up() {
  for daemon in "${daemons[@]}"; do kill "$daemon" 2>/dev/null || true; done
  wait 2>/dev/null || true
  rm -rf "$work"
}
trap clean_up EXIT

say "Starting Slurm on $node."
chmod 755 "$work"
mkdir "$work/state" "$work/spool" "$work/munge"
chmod 711 "$work/munge"
dd if=/dev/urandom of="$work/munge/key" bs=1k count=1 status=none
chmod 600 "$work/munge/key"
/usr/sbin/munged --foreground --force --key-file="$work/munge/key" --socket="$work/munge/socket" \
  --pid-file="$work/munge/pid" --seed-file="$work/munge/seed" --log-file="$work/munge/log" &
daemons+=($!)
cat >"$work/slurm.conf" <<END
ClusterName=check
SlurmctldHost=$node
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$work/munge/socket
CredType=cred/munge
StateSaveLocation=$work/state
SlurmdSpoolDir=$work/spool
SlurmctldPidFile=$work/slurmctld.pid
SlurmdPidFile=$work/slurmd.pid
SlurmctldPort=16817
SlurmdPort=16818
ProctrackType=proctrack/pgid
TaskPlugin=task/none
MpiDefault=none
ReturnToService=2
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
NodeName=$node CPUs=$(nproc) State=UNKNOWN
PartitionName=check Nodes=$node Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF="$work/slurm.conf" OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
for i in $(seq 50); do [ -S "$work/munge/socket" ] && break; sleep 0.1; done
/usr/sbin/slurmctld -D -L "$work/slurmctld.log" &
daemons+=($!)
/usr/sbin/slurmd -D -L "$work/slurmd.log" -N "$node" &
daemons+=($!)
for i in $(seq 60); do sinfo -h -o %T 2>/dev/null | grep -q idle && break; sleep 1; done
sinfo -h -o %T | grep -q idle || { tail -n 20 "$work"/*.log >&2; fail "Slurm does not come up."; }

cat >"$work/s.json" <<'END'
{"pemesh": 1, "name": "s", "polygons": [{"family": "maze"}],
 "sweep": [{"parameter": "t", "from": 0, "to": 0.9, "count": 60}],
 "mesh": {"target": {"quantity": "elements", "value": 20000}}}
END
cd "$work"
say "The same study without Slurm."
"$program" run s.json -o plain

# state_of JOB: its state, as long as Slurm knows it
state_of() { scontrol show job "$1" 2>/dev/null | sed -n 's/.*JobState=\([A-Z_]*\).*/\1/p'; }
wait_for() { # JOB SECONDS
  for i in $(seq "$2"); do
    # A job that was queued again may not start for two minutes, by default.
    case $(state_of "$1") in
      COMPLETED) return ;;
      PENDING) scontrol update jobid="$1" starttime=now 2>/dev/null || true ;;
      FAILED | CANCELLED | TIMEOUT | NODE_FAIL | OUT_OF_MEMORY) break ;;
    esac
    sleep 1
  done
  cat ./*.log >&2
  fail "job $1 is $(state_of "$1")."
}
same() {
  cmp plain/results.csv "$1/results.csv" || fail "$1 is not what a plain run leaves."
  cmp plain/correlation.csv "$1/correlation.csv" || fail "$1 is not what a plain run leaves."
}

say "A job of two tasks."
"$program" slurm s.json -o two --script two.slurm --ntasks 2 --time 30:00
job=$(sbatch --parsable two.slurm)
wait_for "$job" 300
same two

say "A job whose time is over."
"$program" slurm s.json -o again --script again.slurm --ntasks 2 --time 30:00
job=$(sbatch --parsable again.slurm)
for i in $(seq 300); do
  [ "$(cat again/journal.tsv 2>/dev/null | wc -l)" -gt 5 ] && break
  sleep 0.2
done
scancel --batch --signal=USR1 "$job" # what Slurm does by itself 90 seconds before
wait_for "$job" 300
same again
grep -q "queued again" ./s-"$job".log || { cat ./*.log >&2; fail "the job was not queued again."; }
grep -q "as they were" ./s-"$job".log || fail "the job did not go on from what was done."
say "All is well."
