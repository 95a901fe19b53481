#!/usr/bin/env bash
# The long checks at full size:  tests/soak.sh BUILD [NAME...]
#
# Each is a script in tests/soak; finished ones are remembered in BUILD/soak, so that a run that was
# stopped goes on with the next. Seeds are printed.
set -euo pipefail
cd "$(dirname "$(readlink -f "$0")")"
build=$1
shift
mkdir -p "$build/soak"
names=("$@")
if ((${#names[@]} == 0)); then
  for script in soak/*.sh; do names+=("$(basename "$script" .sh)"); done
fi
passed=0 failed=0
for name in "${names[@]}"; do
  [[ -x soak/$name.sh ]] || { echo "soak: there is no \"$name\"; known: $(cd soak && ls -- *.sh | sed 's/\.sh//' | tr '\n' ' ')" >&2; exit 2; }
  if [[ $# == 0 && -e $build/soak/$name.done ]]; then
    echo "== $name: done before ($build/soak/$name.done); delete that file to run it again"
    continue
  fi
  echo "== $name"
  if "soak/$name.sh" "$build"; then
    date -u >"$build/soak/$name.done"
    ((passed += 1))
  else
    ((failed += 1))
  fi
done
echo "$passed passed, $failed failed"
((failed == 0))
