# Variance shadow maps, step by step. `make help` lists the commands.

ROOT := .
STEP ?= 5
DEPS ?= yes
PROGRAMS := step1_shadowmap step2_pcf step3_moments step4_blur step5_chebyshev
program = $(filter step$(STEP)_%,$(PROGRAMS))
PICTURES := $(patsubst %,out/step%.png,1 2 3 4 5)
SETUP := set-up

all: out/steps.png ## set up, build, and draw all five pictures into out/

include $(PROGRAMS:%=%/Makefile)
include step1_shadowmap/base/base.mk
include tests/tests.mk

.PHONY: all programs set-up set-up-tests test identical stability fuzz mutants saved \
    sanitize report table bench exercise grade standalone window diff figures lint \
    format clean help

# What each Debian package is recognised by.
RECOGNISED := g++:command:g++ pkg-config:command:pkg-config \
    python3-glad:command:glad libosmesa6-dev:module:osmesa \
    libglfw3-dev:module:glfw3 libcglm-dev:module:cglm \
    libpng-dev:module:libpng libopenexr-dev:module:OpenEXR \
    openimageio-tools:command:oiiotool

set-up: ## install the packages that are missing (DEPS=no: only name them)
	@sh step1_shadowmap/base/set-up.sh '$(DEPS)' 'the programs' $(RECOGNISED)

# A picture is made again when its program or any shader has changed.
SHADERS := $(wildcard step*/shaders/*)
.SECONDEXPANSION:
out/step%.png: $(BUILD)/$$(wildcard step$$*_*) $(SHADERS)
	@mkdir -p out
	$< --output $@

out/steps.png: $(PICTURES)
	@oiiotool $^ --mosaic:pad=8 5x1 --resize 3200x0 -d uint8 -o $@
	@sh tests/report/table.sh $(BUILD)
	@echo 'look at out/steps.png, and at out/step1.png to out/step5.png'

standalone: ## copy exactly step STEP's files to DIR, which then builds alone
	@test -n '$(DIR)' || { echo 'say where: make standalone STEP=4 DIR=mine'; exit 2; }
	@test -n '$(program)' || { echo 'STEP is 1 to 5'; exit 2; }
	@mkdir -p '$(DIR)'
	@cp --parents $($(program)) $(base) $(program)/Makefile '$(DIR)'
	@printf 'ROOT := .\ninclude $(program)/Makefile\n' >'$(DIR)/Makefile'
	@echo 'make -C $(DIR) builds $(DIR)/build/$(program)'

window: $(program:%=build/%) ## open step STEP in a window
	@test -n '$(program)' || { echo 'STEP is 1 to 5'; exit 2; }
	@$< --window

before = $(filter step$(shell expr $(STEP) - 1)_%,$(PROGRAMS))
diff: ## what step STEP changes against the step before it
	@test -n '$(before)' || { echo 'STEP is 2 to 5'; exit 2; }
	@diff -u --label '$(before)/main.c' --label '$(program)/main.c' \
	    $(before)/main.c $(program)/main.c || test $$? = 1
	@for f in $(filter-out $(program)/main.c,$(filter-out $($(before)),$($(program)))); do \
	    echo; echo "new: $$f"; cat $$f; done
	@for f in $(filter-out $($(program)) $(before)/main.c,$($(before))); do \
	    echo "gone: $$f"; done

clean: ## remove build/ and out/
	rm -rf build out

help: ## print this
	@sed -n 's/^\([a-z-]*\):[^#]*## /\1\t/p' $(MAKEFILE_LIST) | sort -u | expand -t 14
