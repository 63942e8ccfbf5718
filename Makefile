# SPDX-License-Identifier: Apache-2.0
# The commands of the README. Everything is prepared on the way: packages, configuration, build.

.PHONY: build demo test bench clean

build:
	@tools/install-packages
	@cmake --preset release >build-configure.log 2>&1 || { cat build-configure.log; exit 1; }
	@rm -f build-configure.log
	@cmake --build --preset release

demo: build
	@mkdir -p out
	build/bin/candela --output-dir out examples/desk_lamp/desk_lamp.rib

test: build
	cd build && ctest --output-on-failure -j 2 -LE 'long|bench'

test-long: build
	cd build && ctest --output-on-failure -j 2 -L long

bench: build
	bench/run

clean:
	rm -rf build out
