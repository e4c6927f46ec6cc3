#!/bin/bash -eu
# Builds the fuzz targets by OSS-Fuzz's contract: compiler, flags and engine come from the
# environment, what is found in $OUT is run. tests/fuzz/oss_fuzz_test.py runs this file as it is.

cmake -S "$SRC/rasterproof" -B "$WORK/rasterproof" -G Ninja \
  -DRASTERPROOF_FUZZING_ENGINE="$LIB_FUZZING_ENGINE" -DRASTERPROOF_LUMPS=ON
cmake --build "$WORK/rasterproof" --target fuzzers

for target in "$WORK"/rasterproof/fuzz/*_fuzzer; do
  name=$(basename "$target")
  cp "$target" "$OUT/$name"
  cp "$SRC/rasterproof/fuzz/oss-fuzz/all.options" "$OUT/$name.options"
  zip -q -j -r "$OUT/${name}_seed_corpus.zip" "$WORK/rasterproof/fuzz/seeds/${name%_fuzzer}/"
done
