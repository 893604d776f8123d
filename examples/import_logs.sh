#!/bin/bash
# Logs as a laboratory has them, brought into limber. They are written from a recording of the virtual arm:
# Motive's CSV with noise and hidden plates, pressures on another clock. Yours come from your own devices.
#
#     examples/import_logs.sh [FOLDER]        (limber: $LIMBER_PROGRAM, or the one of the release build)
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
limber=${LIMBER_PROGRAM:-$here/../build/release/bin/limber}
folder=${1:-$(mktemp -d)}
mkdir -p "$folder"
cd "$folder"

echo "== a recording of the virtual arm, and the logs that devices would have written of it"
"$limber" collect --arm two_segment --schedule random --count 15 --seed 5 --out truth.h5 --force
"$limber" export truth.h5 --motive logs --rate-hz 120 --time-offset-s 41.7 \
          --noise-m 0.0005 --noise-rad 0.004 --occlusions 30 --occlusion-s 0.15 --force

echo "== what import would do"
"$limber" import motive logs/episode_000_motive.csv --pressures logs/episode_000_pressures.csv \
          --mapping logs/mapping.yaml --arm two_segment --dry-run

echo "== import, and what the recording holds"
"$limber" import motive logs/episode_000_motive.csv --pressures logs/episode_000_pressures.csv \
          --mapping logs/mapping.yaml --arm two_segment --out imported.h5 --force
"$limber" inspect imported.h5 --arm two_segment

echo "== it is used like any other"
"$limber" evaluate --arm two_segment --data imported.h5
echo "files are in $folder"
