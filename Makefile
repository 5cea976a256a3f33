# Variance shadow maps, step by step. `make help` lists the commands.

ROOT := .
include step1_shadowmap/base/words.mk
STEP_GIVEN := $(filter-out undefined,$(origin STEP))
STEP ?= 5
DEPS ?= yes
PROGRAMS := step1_shadowmap step2_pcf step3_moments step4_blur step5_chebyshev

# STEP and DIR are checked before anything is built. The brackets make a space
# an error.
$(if $(filter-out [1] [2] [3] [4] [5],[$(value STEP)]),\
    $(error STEP is 1, 2, 3, 4 or 5, as in make test STEP=3))
$(if $(and $(filter diff,$(MAKECMDGOALS)),$(filter 1,$(STEP))),\
    $(error No step is before 1. STEP is 2, 3, 4 or 5 here: make diff STEP=2))
$(foreach goal,$(filter standalone lesson exercise grade,$(MAKECMDGOALS)),\
    $(if $(value DIR),,$(error say where: make $(goal) STEP=$(STEP) DIR=mine)))
program := $(word $(STEP),$(PROGRAMS))
before := $(word $(STEP),none $(PROGRAMS))
PICTURES := $(patsubst %,out/step%.png,1 2 3 4 5)

all: out/steps.png out/table.txt ## read: set up, build, and draw all five pictures into out/
	@echo 'look at out/steps.png, and at out/step1.png to out/step5.png;' \
	    'what they cost: out/table.txt'

include $(PROGRAMS:%=%/Makefile)
include step1_shadowmap/base/base.mk
include tests/tests.mk

.PHONY: all programs set-up set-up-tests test identical stability fuzz mutants saved \
    sanitize report table bench exercise grade standalone lesson shader window diff \
    figures lint format clean help

# All pictures are made again when a program or a shader has changed, or when
# one of them is missing or is newer than the strip: somebody else wrote it.
MADE_FROM := $(PROGRAMS:%=$(BUILD)/%) $(wildcard step*/shaders/* step*/techniques/*/* \
    step1_shadowmap/base/*/shaders/*)
$(PICTURES): ;
out/steps.png: $(MADE_FROM) $(PICTURES) $(BUILD)/strip
	@mkdir -p out
	@for p in $(PROGRAMS); do \
	    draw="$(BUILD)/$$p --output out/$${p%%_*}.png"; \
	    echo "$$draw"; $$draw || exit 1; done
	@$(BUILD)/strip $@ $(PICTURES)

$(BUILD)/strip: PACKAGES := libpng
$(BUILD)/strip: $(BUILD)/obj/tests/report/strip.c.o
	@echo link $@
	@$(CC) $(LDFLAGS) -o $@ $< $(LIBRARIES)

# After the pictures: only one of the two at a time.
out/table.txt: $(MADE_FROM) tests/report/table.sh | out/steps.png
	@sh tests/report/table.sh $(BUILD) >$@
	@cat $@

standalone: ## read: copy exactly step STEP's files to DIR, which then builds alone
	@sh step1_shadowmap/base/standalone.sh "$$DIR" $(program) $($(program)) $(base)

# A step's files but for its techniques.
lesson = $(foreach file,$($1),$(if $(findstring /techniques/,$(file)),,$(file)))
lesson: ## read: copy step STEP's lesson alone to DIR: it draws the default picture's bytes
	@sh step1_shadowmap/base/standalone.sh "$$DIR" $(program) \
	    $(call lesson,$(program)) $(base_rest) $(call rooms,$(lesson_rooms))

shader: $(BUILD)/$(program) ## read: print the shader program of step STEP's picture
	@$< --print-shader

window: $(BUILD)/$(program) ## read: open step STEP in a window
	@$< --window

diff: ## read: what the lesson of step STEP changes against the one before it
	@diff -u --label '$(before)/main.c' --label '$(program)/main.c' \
	    $(before)/main.c $(program)/main.c || test $$? = 1
	@for f in $(filter-out $(program)/main.c $(call lesson,$(before)),$(call lesson,$(program))); do \
	    echo; echo "new: $$f"; cat $$f; done
	@for f in $(filter-out $(call lesson,$(program)) $(before)/main.c,$(call lesson,$(before))); do \
	    echo "gone: $$f"; done

clean: ## maintain: remove build/ and out/
	rm -rf build out

# A goal's group is the first word after the two number signs.
help: ## read: print this
	@for group in read measure teach maintain; do \
	    echo "to $$group:"; \
	    sed -n "s/^\([a-z-]*\):[^#]*## $$group: /  \1\t/p" $(MAKEFILE_LIST) | \
	        sort -u | expand -t 14; done
	@echo 'STEP is 1 to 5 (5 if it is not said), DEPS is yes or no (yes: install' \
	    'what is missing), DIR a folder.'
