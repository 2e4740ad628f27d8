#!/usr/bin/env bash
# A bake as a job array of a Slurm of one machine, made for this test: the merge of its parts has the bytes of the single
# bake, also after a task died and was sent again. Usage: slurm_test.sh FOLDER_OF_PRT. Exit: 77 where Slurm is missing or
# may not start.
set -euo pipefail
prt=$(cd "$1" && pwd)
for program in munged slurmctld slurmd sbatch; do
  command -v "$program" >/dev/null || PATH=$PATH:/usr/sbin
  command -v "$program" >/dev/null || { echo "skipped: $program is not installed"; exit 77; }
done
[ "$(id -u)" = 0 ] || { echo "skipped: the daemons of Slurm start as root only"; exit 77; }

folder=$(mktemp -d)
export SLURM_CONF=$folder/slurm.conf
end() {  # the daemons that this test started
  local daemon process
  for daemon in slurmd slurmctld munged; do
    [ -s "$folder/$daemon.pid" ] || continue
    process=$(cat "$folder/$daemon.pid")
    kill "$process" 2>/dev/null || continue
    for ((i = 0; i < 100; ++i)); do
      kill -0 "$process" 2>/dev/null || break
      sleep 0.1
    done
  done
  rm -rf "$folder"
}
trap end EXIT

head -c 1024 /dev/urandom >"$folder/key"
chmod 400 "$folder/key"
munged --force --key-file="$folder/key" --socket="$folder/munge" --pid-file="$folder/munged.pid" \
  --log-file="$folder/munged.log" --seed-file="$folder/seed"
port=$((20000 + $$ % 20000))
host=$(hostname -s)
cat >"$SLURM_CONF" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
AuthType=auth/munge
AuthInfo=socket=$folder/munge
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SlurmUser=root
StateSaveLocation=$folder
SlurmdSpoolDir=$folder
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
SlurmctldLogFile=$folder/slurmctld.log
SlurmdLogFile=$folder/slurmd.log
SelectType=select/cons_tres
ReturnToService=2
MailProg=/bin/true
NodeName=$host NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=p Nodes=$host Default=YES MaxTime=INFINITE State=UP
CONF
slurmctld
slurmd -N "$host"
for ((i = 0; i < 100; ++i)); do
  sinfo --noheader --format=%t 2>/dev/null | grep -q idle && break
  sleep 0.2
done
sinfo --noheader --format=%t | grep -q idle || { cat "$folder"/slurm*.log; echo "skipped: Slurm does not start here"; exit 77; }

cat >"$folder/scene.json" <<'SCENE'
{"meshes": [{"primitive": "stairs", "max_edge": 0.1}, {"primitive": "torus", "transform": {"translate": [0, 0, 0.9]}}],
 "bake": {"degree": 2, "directions": 512, "transfer": "interreflected"}}
SCENE
PATH=$prt:$PATH
export PATH
cd "$folder"
prt bake scene.json -o single --instruction-set sse4.2
prt shards scene.json -n 4 --for slurm -o merged --instruction-set sse4.2 >job.sh
sbatch --wait --output=task.%a job.sh
printf x | dd of=merged.3of4 bs=1 seek=2000 conv=notrunc status=none  # what a disk may do
if prt merge merged.[1-4]of4 -o merged 2>said; then echo "a damaged part was merged"; exit 1; fi
grep -q -- '--shard 3/4' said || { cat said; exit 1; }
sbatch --wait --output=task.%a --array=3 job.sh
prt merge merged.[1-4]of4 -o merged
cmp single merged
echo "four tasks of Slurm made the bytes of the single bake"
