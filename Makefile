# SPDX-License-Identifier: Apache-2.0
# The commands of the README. Everything is prepared on the way: packages, configuration, build.

.PHONY: build demo test test-long fuzz bench clean

build:
	@tools/install-packages
	@cmake --preset release >build-configure.log 2>&1 || { cat build-configure.log; exit 1; }
	@rm -f build-configure.log
	@cmake --build --preset release

demo: build
	@mkdir -p out
	build/bin/candela --output-dir out examples/desk_lamp/desk_lamp.rib

# What Python and windows need may be missing: then neither is built, nor tested.
test:
	@tools/install-packages python window || echo 'candela goes on without Python or windows'
	@$(MAKE) build
	cd build && ctest --output-on-failure -j 2 -LE 'long|bench'

test-long:
	@tools/install-packages python window test-long
	@$(MAKE) build
	cmake --preset tsan >/dev/null
	cmake --build --preset tsan --target candela
	cd build && ctest --output-on-failure -j 2 -L long

# Random inputs, with sanitizers: 10,000 mutated shaders and 10,000 streams of words for the
# compiler alone, 10,000 mutated scenes and shaders to render (tests/README.md). What fails is kept.
fuzz:
	@tools/install-packages
	cmake --preset asan >/dev/null
	cmake --build --preset asan --target fuzz_compiler render_each
	CANDELA_TIME_SCALE=5 build-asan/bin/fuzz_compiler --count 10000 \
	    --keep build-asan/fuzz-failures
	CANDELA_CACHE=$(CURDIR)/build-asan/shader-cache CANDELA_TIME_SCALE=3 \
	    tests/fuzz/fuzz.py --program build-asan/bin/render_each --count 10000 \
	    --keep build-asan/fuzz-failures

bench: build
	bench/run

clean:
	rm -rf build build-asan build-tsan out
