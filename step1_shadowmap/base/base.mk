# The ground floor that every program stands on, and how a program is built
# from its list. Before this: ROOT (the tree's top), PROGRAMS (their names) and
# for each program the list of that name.

# Its rooms, the lowest first: base/README.md says what is where. A program can
# do without the last ones, as the lesson alone does.
lesson_rooms := system files gl scene light picture run
base_rooms := $(lesson_rooms) seams legend scenes leave_out measure safety
rooms = $(patsubst $(ROOT)/%,%,$(wildcard $(foreach room,$1,\
    $(ROOT)/step1_shadowmap/base/$(room)/*.[ch]* \
    $(ROOT)/step1_shadowmap/base/$(room)/shaders/*)))
base_rest := $(patsubst %,step1_shadowmap/base/%,\
    base.mk words.mk set-up.sh README.md)
base := $(call rooms,$(base_rooms)) $(base_rest)

# A single folder or a copy of it names what is missing and installs nothing.
DEPS ?= no
$(if $(filter-out [yes] [no],[$(value DEPS)]),\
    $(error DEPS is yes or no, as in make DEPS=no))

# On all processors, unless make is told otherwise; several goals (make clean
# all) one after the other.
ifeq ($(MAKELEVEL)$(word 2,$(MAKECMDGOALS)),0)
MAKEFLAGS += -j$(shell nproc)
endif

CFLAGS ?= -O2 -g
CXXFLAGS ?= -O2 -g
WARNINGS := -Wall -Wextra -Wpedantic -Wshadow -Wconversion
PACKAGES := osmesa glfw3 cglm libpng OpenEXR
# In the tree: the programs look for their shaders from there upwards.
BUILD := $(ROOT)/build
# BUILD stands in targets and in recipes without quotes.
special := $(foreach character,' " ` \ $$ \# % & | ; : < > ( ) [ ] * ? ~,\
    $(findstring $(character),$(BUILD)))
$(if $(strip $(special) $(filter-out 2,$(words $(BUILD) [$(BUILD)]))),\
    $(error BUILD names a folder, without spaces and special characters))
# Recursive on purpose: the set-up may install the packages first.
INCLUDES = -I$(ROOT) -I$(BUILD)/glad/include \
    $(patsubst -I%,-isystem %,$(shell pkg-config --cflags-only-I $(PACKAGES)))
LIBRARIES = $(shell pkg-config --libs $(PACKAGES)) -lstdc++ -lm

objects = $(addprefix $(BUILD)/obj/,$(addsuffix .o,$(filter %.c %.cpp,$($1) $(base))))
all_objects := $(sort $(foreach p,$(PROGRAMS),$(call objects,$p)))

.DELETE_ON_ERROR:
programs: $(PROGRAMS:%=$(BUILD)/%)

# Which Debian packages a program needs, and what each is recognised by.
RECOGNISED := g++:command:g++ pkg-config:command:pkg-config \
    python3-glad:command:glad libosmesa6-dev:module:osmesa \
    libglfw3-dev:module:glfw3 libcglm-dev:module:cglm \
    libpng-dev:module:libpng libopenexr-dev:module:OpenEXR

.PHONY: set-up
set-up: ## read: install the packages that are missing (DEPS=no: only name them)
	@sh $(ROOT)/step1_shadowmap/base/set-up.sh '$(DEPS)' 'the programs' \
	    $(RECOGNISED)

define link_rule
$(BUILD)/$1: $(call objects,$1) $(BUILD)/glad/gl.o
	@echo link $$@
	@$$(CC) $$(LDFLAGS) -o $$@ $$^ $$(LIBRARIES)
endef
$(foreach p,$(PROGRAMS),$(eval $(call link_rule,$p)))

# make at the top and in a step's folder make the same objects, by other names:
# so what an object needs is written from ROOT and BUILD.
rooted = sed -i -E 's!(^| )([.]{1,2}/)?(step[1-5]_|tests/)!\1$$(ROOT)/\3!g;\
    s!(^| )([.]{1,2}/)?build/!\1$$(BUILD)/!g' $(@:.o=.d)
$(BUILD)/obj/%.c.o: $(ROOT)/%.c $(BUILD)/glad/include/glad/gl.h
	@mkdir -p $(@D)
	@echo compile $*.c
	@$(CC) -std=c11 $(CFLAGS) $(WARNINGS) $(INCLUDES) \
	    -MMD -MP -MT '$$(BUILD)/obj/$*.c.o' -c -o $@ $<
	@$(rooted)

$(BUILD)/obj/%.cpp.o: $(ROOT)/%.cpp | set-up
	@mkdir -p $(@D)
	@echo compile $*.cpp
	@$(CXX) -std=c++17 $(CXXFLAGS) $(WARNINGS) $(INCLUDES) \
	    -MMD -MP -MT '$$(BUILD)/obj/$*.cpp.o' -c -o $@ $<
	@$(rooted)

# The GL loader, written by glad from the specification it carries (2>&1: it
# reports every step on stderr; a failure still prints and fails).
$(BUILD)/glad/include/glad/gl.h: | set-up
	@mkdir -p $(BUILD)
	@echo glad: $(BUILD)/glad
	@glad --quiet --reproducible --api gl:core=4.3 --out-path $(BUILD)/glad c \
	    >$(BUILD)/glad.log 2>&1 || { cat $(BUILD)/glad.log; exit 1; }

$(BUILD)/glad/gl.o: $(BUILD)/glad/include/glad/gl.h
	@$(CC) $(CFLAGS) -I$(BUILD)/glad/include -c -o $@ $(BUILD)/glad/src/gl.c

-include $(all_objects:.o=.d)
