# The tests, and what only they need. `make test STEP=3` runs one step's.

TEST_RECOGNISED := libglm-dev:module:glm perl:command:prove \
    libopenimageio-dev:module:OpenImageIO openimageio-tools:command:oiiotool \
    libembree-dev:header:/usr/include/embree*/rtcore.h \
    nlohmann-json3-dev:header:/usr/include/nlohmann/json.hpp \
    gnuplot-nox:command:gnuplot xvfb:command:Xvfb \
    xdotool:command:xdotool imagemagick:command:import \
    locales:header:/usr/share/i18n/locales/de_DE
LINT_RECOGNISED := clang:command:clang clang-format:command:clang-format \
    shellcheck:command:shellcheck

set-up-tests: set-up
	@sh step1_shadowmap/base/set-up.sh $(DEPS) 'the tests' $(TEST_RECOGNISED)

# No five lines on stderr by each Perl where the locale is not installed.
export PERL_BADLANG := 0

# The formulas on their own, in C: roundings are counted here too.
STABILITY_SOURCES := $(wildcard tests/stability/*.c)
STABILITY_OBJECTS := $(STABILITY_SOURCES:%=$(BUILD)/obj/%.o)
$(STABILITY_OBJECTS): $(BUILD)/obj/%.c.o: %.c | set-up
	@mkdir -p $(@D)
	@echo compile $<
	@$(CC) -std=c11 -MMD -MP $(WARNINGS) -I. $(CFLAGS) -ffp-contract=off \
	    -c -o $@ $<
# And step 5's own numbers, to be held against them.
STABILITY_SHARED := $(BUILD)/obj/step5_chebyshev/chebyshev.c.o \
    $(BUILD)/obj/step5_chebyshev/techniques/guard/guard.c.o \
    $(BUILD)/obj/step1_shadowmap/base/system/die.c.o
$(BUILD)/fuzz: $(STABILITY_OBJECTS) $(STABILITY_SHARED)
	@echo link $@
	@$(CC) $(LDFLAGS) -o $@ $^ -lm
-include $(STABILITY_OBJECTS:.o=.d)

# The oracle shares the scene table and the meshes with the programs, and
# nothing else; with the fuzzing the bounds on rounding. No fused multiply-add: its error bounds count roundings.
ORACLE_SOURCES := $(wildcard tests/oracle/*.cpp tests/oracle/*/*.cpp)
ORACLE_OBJECTS := $(ORACLE_SOURCES:%=$(BUILD)/obj/%.o)
ORACLE_SHARED := $(patsubst %,$(BUILD)/obj/step1_shadowmap/base/%.c.o,\
    $(addprefix scene/,scene scene_build mesh) \
    $(addprefix scenes/,table create daylight closed lamps extreme meshes lights change) \
    system/die)
ORACLE_BOUNDS := $(patsubst %,$(BUILD)/obj/tests/stability/%.c.o,\
    bound formulas search windows)
EMBREE = $(patsubst /usr/include/%/rtcore.h,-l%,\
    $(firstword $(wildcard /usr/include/embree*/rtcore.h)))

$(ORACLE_OBJECTS): PACKAGES := glm OpenImageIO
$(ORACLE_OBJECTS): CXXFLAGS += -ffp-contract=off
$(ORACLE_OBJECTS): WARNINGS := -Wall -Wextra -Wpedantic -Wshadow
$(ORACLE_OBJECTS): | set-up-tests
$(BUILD)/oracle: PACKAGES := OpenImageIO
$(BUILD)/oracle: $(ORACLE_OBJECTS) $(ORACLE_SHARED) $(ORACLE_BOUNDS)
	@echo link $@
	@$(CXX) $(LDFLAGS) -o $@ $^ $(LIBRARIES) $(EMBREE)
-include $(ORACLE_OBJECTS:.o=.d)

# The programs once more, as ones that stay; made after the programs, for what is
# older than they are is not used.
define warm_rule
$(BUILD)/warm/$1: $(BUILD)/obj/tests/warm.c.o $(call objects,$1) \
    $(BUILD)/glad/gl.o | $(BUILD)/$1
	@mkdir -p $$(@D)
	@echo link $$@
	@$$(CC) $$(LDFLAGS) -Wl,--wrap=main -o $$@ $$^ $$(LIBRARIES)
endef
$(foreach p,$(PROGRAMS),$(eval $(call warm_rule,$p)))
-include $(BUILD)/obj/tests/warm.c.d

.PHONY: warm
warm: programs $(PROGRAMS:%=$(BUILD)/warm/%)

TESTS := $(if $(STEP_GIVEN),$(sort $(wildcard tests/images/step$(STEP)*.t \
    tests/images/all_*.t)),-r tests/images tests/robustness tests/stability)

# A program that draws for a fifth of a second waits longest for its memory:
# in large pages, where there are some, it is there sooner. (Not where time is
# measured: this is not how a reader runs it.)
LARGE_PAGES := \
    GLIBC_TUNABLES=glibc.malloc.hugetlb=1:glibc.malloc.top_pad=16777216

test: set-up-tests warm $(BUILD)/oracle $(BUILD)/fuzz ## maintain: set up, build, test (STEP=n: one step only)
	@$(LARGE_PAGES) VSM_BUILD=$(BUILD) $(if $(STEP_GIVEN),VSM_STEP=$(STEP)) \
	    perl tests/run.pl $(TESTS)

# Everything once more, with the programs watching their own memory. The two
# leaks that are OSMesa's own are not counted (tests/lsan.supp). Libraries that
# are loaded late have thread-local memory that the search for leaks, which
# watches where it is, would look for at a wrong place.
SANITIZE := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined \
    -fno-sanitize-recover=undefined
sanitize: ## maintain: run every test on programs built with ASan and UBSan
	@LSAN_OPTIONS="suppressions=\"$$PWD/tests/lsan.supp\":print_suppressions=0" \
	    ASAN_OPTIONS=intercept_tls_get_addr=0 \
	    VSM_SLOW=1 $(MAKE) BUILD=build/sanitize CFLAGS='$(SANITIZE)' \
	    CXXFLAGS='$(SANITIZE)' LDFLAGS='$(SANITIZE)' test

REPORT_RECOGNISED := libjxl-devtools:command:butteraugli_main
report: set-up-tests programs $(BUILD)/oracle ## measure: error against run time, out/report/ (REPORT=quick: in 2 minutes)
	@sh step1_shadowmap/base/set-up.sh $(DEPS) 'the report' $(REPORT_RECOGNISED)
	@VSM_BUILD=$(BUILD) perl tests/report/report.pl

table: set-up-tests programs $(BUILD)/oracle ## measure: what a frame of each step costs, and how wrong it is
	@sh tests/report/table.sh $(BUILD)

bench: set-up-tests programs ## measure: how the time grows with width, map, triangles, picture, layers: out/bench/
	@VSM_BUILD=$(BUILD) perl tests/report/bench.pl

saved: set-up-tests programs ## measure: time of each scene and step with and without what is left out: out/bench/saved.csv
	@VSM_BUILD=$(BUILD) perl tests/report/saved.pl

mutants: set-up-tests warm $(BUILD)/oracle ## maintain: plant mistakes one at a time: each must be caught
	@$(LARGE_PAGES) VSM_BUILD=$(BUILD) perl tests/mutants.pl

exercise: set-up-tests ## teach: copy step STEP to DIR with its functions emptied, for a student to write
	@perl tests/exercise/exercise.pl $(STEP) "$$DIR"

grade: set-up-tests warm $(BUILD)/oracle ## teach: marks for what was written in DIR, with reasons and pictures
	@VSM_BUILD=$(BUILD) perl tests/exercise/grade.pl $(STEP) "$$DIR"

stability: set-up-tests programs $(BUILD)/oracle $(BUILD)/fuzz ## maintain: the extreme cases, as a table and out/stability/results.csv
	@VSM_BUILD=$(BUILD) perl tests/stability/stability.pl

identical: set-up-tests programs $(BUILD)/oracle ## maintain: every scene in every step, with and without --keep-all: the same pixels
	@VSM_BUILD=$(BUILD) VSM_ALL=1 perl tests/run.pl tests/images/all_plan.t

fuzz: $(BUILD)/fuzz ## maintain: bits of the variance lost, against the bound: out/stability/fuzz.svg
	@mkdir -p out/stability
	@$(BUILD)/fuzz --count 40000 --csv >out/stability/fuzz.csv
	@for kind in svg png; do gnuplot -e "kind='$$kind'" \
	    -e "input='out/stability/fuzz.csv'" \
	    -e "output='out/stability/fuzz.$$kind'" \
	    tests/stability/fuzz.gp || exit 1; done

figures: set-up-tests programs $(BUILD)/oracle $(BUILD)/fuzz ## measure: make every committed picture again, and print the READMEs' numbers
	@for p in $(PROGRAMS); do \
	    sh tests/report/figures.sh $(BUILD) $$p || exit 1; done
	@sh tests/report/headline.sh $(BUILD)
	@VSM_BUILD=$(BUILD) perl tests/report/saved.pl \
	    room:turn=-100 grazing empty unlit offstage

CODE = $(shell git ls-files '*.c' '*.h' '*.cpp')
lint: programs $(BUILD)/oracle ## maintain: compile with gcc and clang without a warning, check the format
	@sh step1_shadowmap/base/set-up.sh $(DEPS) 'lint' $(LINT_RECOGNISED)
	@clang-format --dry-run --Werror $(CODE)
	@sh tests/lint.sh

format: ## maintain: lay out the C and C++ files
	@clang-format -i $(CODE)
