#!/usr/bin/env bash
# mpi.sh QUARRY: `quarry batch` of a build with QUARRY_MPI under mpirun, with 2 and 3 ranks on this machine: each job is
# done once, every rank does some, and the meshes are those that one process makes. Ends with 1 where that is not so.
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
