#!/usr/bin/env bash
# Twenty seeds of an expert and a novice at each built-in task: tests/soak/operators.sh BUILD [SEEDS]
#
# For every seed there must be contact to measure, and the novice must be slower, rougher and lean on
# the wall for longer. Prints every seed with its results; ends with 1 when a seed does not.
set -euo pipefail
build=${1:?usage: operators.sh BUILD [SEEDS]}
seeds=${2:-20}
exec node "$(dirname "$(readlink -f "$0")")/operators.mjs" "$build/cathedra" "$seeds"
