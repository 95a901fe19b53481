#!/usr/bin/env bash
# Measurements:  tests/benchmarks/bench.sh BUILD [NAME [OPTIONS...]]
#
# NAME is a program BUILD/tests/benchmarks/NAME_bench; without one, all of them run.
set -euo pipefail
build=$1
name=${2:-}
folder=$build/tests/benchmarks
sed -n 's/^model name\t*: /processor: /p' /proc/cpuinfo | head -1
echo "cores: $(nproc)   load: $(cut -d' ' -f1-3 /proc/loadavg)   build: $(basename "$build")"
if [[ -n $name ]]; then
  [[ -x $folder/${name}_bench ]] || {
    echo "bench: there is no \"$name\"; known: $(cd "$folder" && ls -- *_bench | sed 's/_bench//' | tr '\n' ' ')" >&2
    exit 2
  }
  exec "$folder/${name}_bench" "${@:3}"
fi
for program in "$folder"/*_bench; do
  echo "== $(basename "$program")"
  "$program"
done
