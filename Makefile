# The two commands of the README are `make demo` and `make test`; each installs what it needs on a
# bare Debian 12.
JOBS ?= 2
# One more than there are cores: many tests wait, for a browser, a clock, a disk.
CTEST_PARALLEL ?= $(shell echo $$(($$(nproc) + 1)))

.PHONY: all demo test quick outputs sbom package bench soak tsan coverage fuzz tidy tidy-changed \
  format check-format packages test-packages venv clean

all: packages
	cmake --preset release
	cmake --build --preset release -j$(JOBS) --target slackwater

demo: all
	build/release/api/slackwater demo --out build/demo

test: test-packages check-format venv tidy-changed
	cmake --preset dev
	cmake --build --preset dev -j$(JOBS)
	ctest --preset dev -j$(CTEST_PARALLEL)

# Unit tests of the rooms that were changed, in the tree of `make test`.
quick: test-packages
	cmake --preset dev
	cmake/quick build/dev $(JOBS)

# What the program answers to every kind of question, in build/outputs: keep a copy before a
# rearrangement, compare with `diff -r` after it.
outputs: all test-packages
	tests/outputs/capture build/release/api/slackwater build/outputs

# What the program is made of: build/sbom.cdx.json, and for people build/licences_of_parts.txt.
sbom: all
	cmake/sbom build/release
	cp build/release/sbom.cdx.json build/release/licences_of_parts.txt build

# build/package/slackwater_VERSION_ARCHITECTURE.deb
package: sbom
	cpack --config build/release/CPackConfig.cmake -B build/package

bench: test-packages
	cmake --preset release
	cmake --build --preset release -j$(JOBS) --target slackwater slackwater_bench_all
	tests/bench/run build/release

# Long runs: 200 kills instead of 7, 210 days of bands, 500 twins, a vehicle behind a lossy link,
# 10 000 readers that come and go, ten minutes of serving, attacks on the server and on the ports of
# DDS, damaged files, two hours of fuzzing.
soak: test-packages venv
	cmake --preset release
	cmake --build --preset release -j$(JOBS)
	ctest --preset release -L '^soak$$' -E TurnACameraByHand  # below, with more of them
	ctest --preset release -L bench-answers
	SLACKWATER_REQUESTS=300000 ctest --preset release -V -R 'ReadDoubtfulRequests'
	# Memory and crashes, that sanitizers hide.
	ctest --preset release -R 'KeptAnswersOfTheDesk|RunApart|Confined|HostileFiles|HostileLog'
	SLACKWATER_KILLS=200 ctest --preset release -R '[Kk]ill|[Cc]rash'
	SLACKWATER_CUT_EVERY=1 SLACKWATER_FAIL_EVERY=1 ctest --preset release -R 'PowerCut|FailingDisk'
	SLACKWATER_SCENARIOS=1000 SLACKWATER_SMALL_DAYS=200 ctest --preset release \
	  -R 'WriteScenario|MakePlan'
	SLACKWATER_DAYS=210 SLACKWATER_TWINS=500 SLACKWATER_WINDS=50 ctest --preset release -V \
	  -R 'Probabilities|MemberSpread|TwinTargets|BlendTwin|FitProfile|RealPairs'
	ctest --preset release -V -R 'Encounters|TenTasks'
	SLACKWATER_TASK_DAYS=4000 SLACKWATER_TWIN_DAYS=300 ctest --preset release -V \
	  -R 'WindowProbabilities|TwinProbabilities|PlanChances'
	SLACKWATER_OCEANS=6 SLACKWATER_MORNINGS=45 ctest --preset release -V -R 'MorningChances'
	SLACKWATER_LIVE_SECONDS=600 build/release/tests/bench/slackwater_live_bench
	SLACKWATER_PLANNED_MISSIONS=200 ctest --preset release -V -R 'FixedAndAdapted'
	SLACKWATER_MUTATIONS=1000000 ctest --preset release -V -R 'MutatedMessages|UnrulyStations'
	SLACKWATER_HISTORIES=15 ctest --preset release -V -R 'FitTheExtremes'
	SLACKWATER_LOSSY_LINK=1 ctest --preset release -V -R 'LossyLink|LossySession'
	SLACKWATER_JOINS=10000 build/release/tests/slackwater_api_dds_tests --gtest_filter='*Joins.*'
	SLACKWATER_JOINS=10000 build/release/tests/slackwater_api_tests --gtest_filter='Session.Many*'
	SLACKWATER_FLOOD_SECONDS=30 ctest --preset release -V -R 'FloodedLiveRun'
	SLACKWATER_SESSION_MINUTES=120 ctest --preset release -V -R 'LongSession'
	SLACKWATER_SCENE_MINUTES=30 ctest --preset release -V -R 'DrawTheSceneOfARun'
	SLACKWATER_MORE_HANDS=1 ctest --preset release -V -R 'TurnACameraByHand'
	build/release/api/slackwater demo --out build/soak-demo
	tests/soak/serve build/release/api/slackwater build/soak-demo/store
	tests/soak/attack build/release/api/slackwater build/soak-demo/store || [ $$? -eq 77 ]
	tests/soak/mutated-files build/release/api/slackwater build/soak-demo/store 500
	tests/soak/morning build/release/api/slackwater build/soak-demo/store
	tests/soak/desk build/release/api/slackwater build/soak-demo/store build/node
	tests/soak/lit_scenes build/release/tests/slackwater_made_up_lit_scenes build/venv-mitsuba \
	  || [ $$? -eq 77 ]
	tests/soak/learn build/release/api/slackwater || [ $$? -eq 77 ]
	tests/soak/learn_looks build/release/api/slackwater || [ $$? -eq 77 ]
	tests/soak/five-products build/release/api/slackwater build/soak-demo/store \
	  build/release/tests/slackwater_made_up_products build/node
	$(MAKE) fuzz

fuzz: test-packages
	cmake --preset fuzz
	cmake --build --preset fuzz -j$(JOBS)
	tests/fuzz/run build/fuzz

tsan: test-packages
	cmake --preset tsan
	cmake --build --preset tsan -j$(JOBS)
	ctest --preset tsan -LE 'fuzz|bench-answers'

coverage: test-packages
	cmake --preset coverage
	cmake --build --preset coverage -j$(JOBS)
	ctest --preset coverage

format: test-packages
	git ls-files '*.h' '*.cc' | xargs clang-format-14 -i
check-format: test-packages
	@cmake/check-format
# The first time it looks at every source; afterwards at what has changed.
tidy: test-packages
	cmake --preset tidy
	cmake/tidy build/tidy $(JOBS)
# What the last commit changes, for two minutes.
tidy-changed: test-packages
	cmake --preset tidy
	cmake/tidy build/tidy $(JOBS) 100

packages:
	@cmake/install-packages cmake/debian-packages.txt
test-packages:
	@cmake/install-packages cmake/debian-packages.txt cmake/debian-packages-test.txt
# Validators that only tests use; absent (with a message) where PyPI cannot be reached.
venv:
	@tests/strangers/make-venv build/venv

clean:
	rm -rf build
