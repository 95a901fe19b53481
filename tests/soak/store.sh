#!/usr/bin/env bash
# The program is killed at random moments: tests/soak/store.sh BUILD [KILLS] [SEED]
#
# Kills `exercise run` and `demo` in turn with SIGKILL, starts the server once more, and looks:
# finished trials unchanged, what ran marked aborted with its trace, the file whole, and `trial
# verify` confirms. The seed of the moments is printed; the same seed kills at the same delays.
set -euo pipefail
build=${1:?usage: store.sh BUILD [KILLS] [SEED]}
exec node "$(dirname "$(readlink -f "$0")")/store.mjs" "$build/cathedra" "${2:-100}" "${3:-$RANDOM}"
