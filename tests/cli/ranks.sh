# SPDX-License-Identifier: LGPL-2.1-or-later
# The same bits on 1, 2 and 3 ranks: the whole chain of the Whipple shield on coarse cells, its debris with bonds that
# break, and a Lagrangian blast of cells that share nodes. What only says how much energy changed its form is summed rank by rank: equal to 1e-12.
program=$1
source=$2

# Tables "name<tab>value" of everything a run says: summary.json with a line number for a name where names repeat,
# statistics.csv by row and column.
values() {
  awk -F'": ' '/"phases"/ { skip = 1 } skip { skip = !/}/; next }
    /wall_s|cpu_s|peak_rss|per_rank|"ranks"/ { next }
    { gsub(/[ ",]/, "", $1); sub(/,$/, "", $2); print FNR " " $1 "\t" $2 }' "$1/summary.json"
  awk -F, 'NR == 1 { for (i = 1; i <= NF; ++i) name[i] = $i; next }
    { for (i = 1; i <= NF; ++i) print "row " NR " " name[i] "\t" $i }' "$1/statistics.csv"
}

# same_values A B SCALE: energies and closures may differ by 1e-12 of SCALE, all else not at all.
same_values() {
  values "$1" >a.txt
  values "$2" >b.txt
  [ "$(wc -l <a.txt)" -gt 100 ] || { echo "$1 says too little"; cat a.txt; exit 1; }
  paste a.txt b.txt | awk -F'\t' -v scale="$3" '
    $1 == $3 && $2 == $4 { next }
    { difference = $2 - $4 }
    $1 == $3 && $1 ~ /work|loss|left.domain|closure/ && difference * difference <= 1e-24 * scale * scale { next }
    { print "differs: " $0; failed = 1 }
    END { exit failed }' || { echo "$1 and $2 are not the same"; exit 1; }
}

# compare NAME SCALE SCENE OPTIONS...
compare() {
  name=$1
  scale=$2
  scene=$3
  shift 3
  for ranks in 1 2 3; do
    rm -rf "$name.$ranks"
    "$program" run "$source/$scene" -n $ranks --output "$name.$ranks" "$@" >"$name.$ranks.txt"
  done
  same_values "$name.1" "$name.2" "$scale"
  same_values "$name.1" "$name.3" "$scale"
  for table in "$name.1"/gauges/*.csv; do
    [ -e "$table" ] || continue
    cmp "$table" "$name.2/gauges/${table##*/}" && cmp "$table" "$name.3/gauges/${table##*/}" || exit 1
  done
}

# coarse cells and a short look at the wall; scale: kinetic energy of the sphere, Mbar cm^3
compare whipple 0.01 prm/whipple_shield.prm --set 'Mesh/Finest cell = 0.016 cm' \
  --set 'Stages/wall/End = for 0.2 us' --set 'Output/Fields interval = 100 us' \
  --set 'Gauges/List = way, rider, wall' --set 'Gauges/way/Point = 0 cm, 2 cm' --set 'Gauges/rider/Kind = material' \
  --set 'Gauges/rider/Point = 0.032 cm, -0.16 cm' --set 'Gauges/rider/Interval = 0.05 us' \
  --set 'Gauges/wall/Kind = surface velocity' --set 'Gauges/wall/Body = wall' --set 'Gauges/wall/Side = front'
for gauge in way rider wall; do # each has seen material
  grep -vq nan "whipple.1/gauges/$gauge.csv" && [ "$(grep -vc nan "whipple.1/gauges/$gauge.csv")" -gt 2 ]
done
grep -q '"leading_edge_velocity_cm_per_us": 0.5' whipple.3/summary.json

# bonds that break at hand-over and in flight
compare graded 0.01 prm/whipple_shield.prm --set 'Mesh/Finest cell = 0.016 cm' --set 'Stages/List = perforation, debris' \
  --set 'Stages/debris/Cohesion = graded' --set 'Stages/debris/Break void = 80 %' \
  --set 'Output/Fields interval = 100 us'
grep -q '"breaks": [1-9]' graded.3/summary.json

compare sedov 0.25 prm/verification/sedov.prm --set 'Stages/blast/End = 0.3 us'

# turned bodies, an outline, and states in expressions
compare oblique 0.006 prm/oblique_impact.prm --set 'Mesh/Finest cell = 0.04 cm' --set 'Stages/impact/End = 0.3 us'
compare cone 0.002 tests/verification/scenes/turned_cone.prm --set 'Stages/flight/End = 0.1 us'
