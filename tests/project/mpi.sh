#!/usr/bin/env bash
# mpi.sh QUARRY: `quarry batch` of a build with QUARRY_MPI under mpirun, with 2 and 3 ranks on this machine: each job is
# done once, every rank does some, and the meshes are those that one process makes; jobs are shared as ranks become free; a
# job that crashes and one that hangs harm no other; what a lost rank leaves is done by the next run. Ends with 1 where that
# is not so.
set -euo pipefail
QUARRY=$(realpath "$1")
readonly QUARRY JOBS=24
OUT=$(mktemp -d)
readonly OUT
trap 'rm -rf "$OUT"' EXIT

# Messages of the runs are kept for who must look into a failure.
ranks() { timeout 300 mpirun --allow-run-as-root --oversubscribe -n "$1" "$QUARRY" batch "${@:2}" 2> "$OUT/stderr"; }

fail() {
  printf 'FAILED %s\n' "$*"
  tail -n 10 "$OUT/stderr"
  exit 1
}

mkdir "$OUT/in"
for ((seed = 0; seed < JOBS; ++seed)); do
  "$QUARRY" generate fractures --count 40 --outline --seed "$seed" -q -o "$OUT/in/section_$seed.geojson"
done
"$QUARRY" batch "$OUT/in" -o "$OUT/alone" --size 25 -q > /dev/null

for count in 2 3; do
  ranks "$count" "$OUT/in" -o "$OUT/$count" --size 25 -v --json > "$OUT/table.json" || fail "$count ranks: exit code $?"
  python3 - "$OUT/table.json" "$count" "$JOBS" << 'END' || fail "$count ranks: the table"
import json, sys
jobs = json.load(open(sys.argv[1]))["jobs"]
count, wanted = map(int, sys.argv[2:])
assert len(jobs) == wanted and all(job["outcome"] == "done" for job in jobs), jobs
assert {job["rank"] for job in jobs} == set(range(count)), [job["rank"] for job in jobs]
END
  # Rank 0 tells each job as it hears of it.
  (($(grep -c ': done in ' "$OUT/stderr") == JOBS)) || fail "$count ranks: a job was told twice, or not at all"
  for mesh in "$OUT"/alone/*.vtu; do
    cmp "$mesh" "$OUT/$count/$(basename "$mesh")" || fail "$count ranks: other bytes"
  done
  printf '%s ranks: %s jobs, each once, the same bytes\n' "$count" "$JOBS"
done

ranks 2 "$OUT/in" -o "$OUT/2" --size 25 > "$OUT/table.txt" || fail "again: exit code $?"
(($(grep -c ' skipped ' "$OUT/table.txt") == JOBS)) || fail "again: not all were passed over"
: > "$OUT/in/broken.geojson"
code=0
ranks 2 "$OUT/in" -o "$OUT/2" --size 25 > "$OUT/table.txt" || code=$?
((code == 8)) || fail "a broken job: exit code $code, not 8"
code=0
ranks 2 "$OUT/in" -o "$OUT/in" --size 25 > "$OUT/table.txt" || code=$?
((code == 2)) || fail "the folder of the models: exit code $code, not 2"
printf 'run again, all passed over; exit codes as without MPI\n'
rm "$OUT/in/broken.geojson"

# list FILE SIZE: all sections, the first with this element size.
list() {
  printf '[defaults]\nsize = 25\n[[job]]\ninput = "%s"\nsize = %s\n' "$OUT/in/section_0.geojson" "$2"
  for ((seed = 1; seed < JOBS; ++seed)); do printf '[[job]]\ninput = "%s"\n' "$OUT/in/section_$seed.geojson"; done
} > "$1"

list "$OUT/uneven.toml" 4
ranks 2 "$OUT/uneven.toml" -o "$OUT/uneven" --threads 1 --json > "$OUT/table.json" || fail "an uneven list: exit code $?"
python3 - "$OUT/table.json" << 'END' || fail "the rank that has the large job did half of the others"
import json, sys
jobs = json.load(open(sys.argv[1]))["jobs"]
large = max(jobs, key=lambda job: job["seconds"])
assert sum(job["rank"] == large["rank"] for job in jobs) < len(jobs) / 2, jobs
END

list "$OUT/bad.toml" 25
for name in crash hang; do
  mkfifo "$OUT/$name.geojson" # nobody writes to it
  printf '[[job]]\ninput = "%s"\n' "$OUT/$name.geojson" >> "$OUT/bad.toml"
done
until pkill -SEGV -f "mesh.*$OUT/crash.geojson"; do sleep 0.1; done &
killer=$!
code=0
ranks 2 "$OUT/bad.toml" -o "$OUT/bad" --job-time 5s --json > "$OUT/table.json" || code=$?
kill "$killer" 2> /dev/null || true
((code == 8)) || fail "a crash and a hang: exit code $code, not 8"
python3 - "$OUT/table.json" "$JOBS" << 'END' || fail "a crash and a hang: the table"
import json, sys
outcomes = {job["name"]: job["outcome"] for job in json.load(open(sys.argv[1]))["jobs"]}
assert (outcomes.pop("crash"), outcomes.pop("hang")) == ("crashed", "out of time"), outcomes
assert list(outcomes.values()) == ["done"] * int(sys.argv[2]), outcomes
END

# rank_of PID: its number among the ranks; nothing for other processes.
rank_of() { tr '\0' '\n' 2> /dev/null < "/proc/$1/environ" | sed -n 's/^OMPI_COMM_WORLD_RANK=//p'; }
list "$OUT/lost.toml" 2
ranks 2 "$OUT/lost.toml" -o "$OUT/lost" --threads 1 > "$OUT/table.txt" &
lost=$!
until compgen -G "$OUT/lost/batch/records/*.json" > /dev/null; do sleep 0.1; done # some are done
for process in $(pgrep -f "^$QUARRY batch $OUT/lost.toml"); do
  [[ $(rank_of "$process") != 1 ]] || kill -KILL "$process"
done
code=0
wait "$lost" || code=$?
((code != 0)) || fail "a lost rank: exit code 0"
ranks 2 "$OUT/lost.toml" -o "$OUT/lost" --threads 1 > "$OUT/table.txt" || fail "after a lost rank: exit code $?"
(($(grep -cE ' (done|skipped) ' "$OUT/table.txt") == JOBS)) || fail "after a lost rank: not all are done"
grep -q ' skipped ' "$OUT/table.txt" || fail "after a lost rank: all were done again"
printf 'jobs go to who is free; a crash, a hang and a lost rank are got over\n'
