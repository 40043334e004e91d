#!/usr/bin/env bash
# jobs.sh QUARRY: small whole jobs of the command, as a user runs them: exit codes, messages, the same bytes on any
# number of threads, and no file touched by a job that failed.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
readonly QUARRY=$1 SECTION=tests/data/demo_section.geojson
OUT=$(mktemp -d)
readonly OUT
trap 'rm -rf "$OUT"' EXIT
passed=0 failed=0

# expect NAME CODE COMMAND...: the command ends with that exit code within five minutes.
expect() {
  local name=$1 code=$2 got=0
  shift 2
  timeout 300 "$@" > "$OUT/stdout" 2> "$OUT/stderr" < /dev/null || got=$?
  if ((got == code)); then
    passed=$((passed + 1))
  else
    failed=$((failed + 1))
    printf 'FAILED %s: exit code %s, not %s\n' "$name" "$got" "$code"
    tail -n 5 "$OUT/stdout" "$OUT/stderr"
  fi
}

# refuses NAME CODE ARGUMENTS...: `quarry mesh` says why in one line and leaves the output that was there as it was.
refuses() {
  local name=$1 code=$2
  shift 2
  printf 'kept' > "$OUT/kept.vtu"
  expect "$name" "$code" "$QUARRY" mesh "$@" -o "$OUT/kept.vtu"
  expect "$name: one line" 0 test "$(wc -l < "$OUT/stderr")" -eq 1
  expect "$name: output untouched" 0 test "$(cat "$OUT/kept.vtu")" = kept
}

expect "version" 0 "$QUARRY" --version
expect "help" 0 "$QUARRY" mesh --help

for threads in 1 2 4 7; do
  expect "mesh on $threads threads" 0 "$QUARRY" mesh "$SECTION" -o "$OUT/$threads.vtu" --size 12 --threads "$threads" \
    --report "$OUT/$threads.json" --quiet
  expect "the same bytes on $threads threads" 0 cmp "$OUT/1.vtu" "$OUT/$threads.vtu"
done
expect "the report is JSON" 0 python3 -m json.tool "$OUT/1.json"
expect "triangles" 0 "$QUARRY" mesh "$SECTION" -o "$OUT/triangles.vtu" --size 12 --elements tri --quiet
expect "Gmsh's format" 0 "$QUARRY" mesh "$SECTION" -o "$OUT/section.msh" --size 12 --quiet
for name in section.avs section.mesh section.vtkhdf; do
  expect "$name" 0 "$QUARRY" mesh "$SECTION" -o "$OUT/$name" --size 20 --quiet
done
expect "AVS and MFEM are read" 0 "$QUARRY" convert "$OUT/section.avs" "$OUT/again.mesh"
expect "elements of second order, split" 0 "$QUARRY" mesh "$SECTION" -o "$OUT/second.vtu" --size 20 --order 2 --split-fractures --quiet
expect "for MOOSE" 0 "$QUARRY" convert "$OUT/1.vtu" "$OUT/moose.msh" --for moose
expect "for OpenGeoSys" 0 "$QUARRY" convert "$OUT/1.vtu" "$OUT/ogs.vtu" --for ogs
expect "clean" 0 "$QUARRY" clean "$SECTION" -o "$OUT/clean.geojson" --snap 0.5
expect "the cleaned lines are JSON" 0 python3 -m json.tool "$OUT/clean.geojson"
expect "quality" 0 "$QUARRY" quality "$OUT/1.vtu" --json
cp "$OUT/stdout" "$OUT/quality.json"
expect "quality prints JSON" 0 python3 -m json.tool "$OUT/quality.json"
expect "a drawn network" 0 "$QUARRY" generate fractures --count 150 --curved --outline -o "$OUT/network.geojson"
expect "a drawn network is meshed" 0 "$QUARRY" mesh "$OUT/network.geojson" -o "$OUT/network.vtu" --size 30 --quiet
expect "a batch" 0 "$QUARRY" batch "$SECTION" "$OUT/network.geojson" -o "$OUT/batch" --size 30 --quiet
expect "a batch makes the same bytes" 0 cmp "$OUT/network.vtu" "$OUT/batch/network.vtu"
expect "a batch with a broken job" 8 "$QUARRY" batch "$SECTION" "$OUT/none.geojson" -o "$OUT/batch" --size 30 --quiet
expect "drawn layers" 0 "$QUARRY" generate layers --threads 2 -o "$OUT/layers.geojson"
expect "drawn layers are meshed" 0 "$QUARRY" mesh "$OUT/layers.geojson" -o "$OUT/layers.vtu" --size 20 --quiet
expect "picture" 0 "$QUARRY" picture "$OUT/1.vtu" -o "$OUT/section.svg"

cat > "$OUT/cube.obj" << 'END'
v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
v 0 0 1
v 1 0 1
v 0 1 1
v 1 1 1
f 1 3 4 2
f 5 6 8 7
f 1 2 6 5
f 3 7 8 4
f 1 5 7 3
f 2 4 8 6
END
for threads in 1 2 4 7; do
  expect "a surface on $threads threads" 0 "$QUARRY" mesh "$OUT/cube.obj" -o "$OUT/cube_$threads.vtu" --count 600 \
    --threads "$threads" --picture "$OUT/cube.png" --page "$OUT/cube.html" --report "$OUT/cube.json" --repaired "$OUT/repaired.ply" --quiet
  expect "the same bytes of a surface on $threads threads" 0 cmp "$OUT/cube_1.vtu" "$OUT/cube_$threads.vtu"
done
expect "lines on a surface" 0 "$QUARRY" mesh "$(dirname "$SECTION")/demo_horizon.obj" \
  --lines "$(dirname "$SECTION")/demo_horizon_traces.geojson" -o "$OUT/horizon.vtu" --size 40 --curvature 2 --quiet
expect "triangles on a surface" 0 "$QUARRY" mesh "$OUT/cube.obj" -o "$OUT/cube.stl" --size 0.2 --elements tri --quiet
expect "the report of a surface is JSON" 0 python3 -m json.tool "$OUT/cube.json"
refuses "an option of lines for a surface" 2 "$OUT/cube.obj" --size 0.2 --snap 0.1

printf '{"type": "FeatureCollection", "features": [' > "$OUT/broken.geojson"
printf '' > "$OUT/empty.geojson"
refuses "a file that is not there" 3 "$OUT/none.geojson" --size 12
refuses "broken JSON" 3 "$OUT/broken.geojson" --size 12
refuses "an empty file" 3 "$OUT/empty.geojson" --size 12
refuses "a size of 0" 2 "$SECTION" --size 0
refuses "a size that is no number" 2 "$SECTION" --size wide
expect "an unknown command" 2 "$QUARRY" melt "$SECTION"
expect "an output that cannot be written" 7 "$QUARRY" mesh "$SECTION" -o "$OUT/no/folder/out.vtu" --size 12 --quiet

printf '%s passed, %s failed\n' "$passed" "$failed"
((failed == 0))
