# A word on make's command line is data. Otherwise make would evaluate the name of
# a folder, for example $(shell ...), when it hands the name to a recipe. Recipes
# read such words from their environment. The compilers and their flags stay
# text for make and the shell. Other words would take the place of what the
# Makefiles call so.
$(foreach word,$(.VARIABLES),\
    $(if $(filter command,$(firstword $(origin $(word)))),\
        $(if $(filter STEP DIR DEPS BUILD REPORT CC CXX %FLAGS,$(word)),,\
            $(error make takes STEP, DIR, DEPS, BUILD, REPORT, the compilers and\
                their flags, and no $(word)))\
        $(if $(filter CC CXX %FLAGS,$(word)),,\
            $(eval override $(word) := $$(value $(word)))\
            $(eval export $(word)))))

# Where the tree is, and whose programs are built: said by a Makefile, or those
# of the folder that make runs in.
ifeq ($(filter file,$(origin ROOT)),)
ROOT := ..
endif
ifneq ($(origin PROGRAMS),file)
override undefine PROGRAMS
endif

# What a program is made of: the lessons of earlier steps, without their main.c;
# and the techniques of steps, its own first, whose table lists them all.
lesson_of = $(filter-out %/main.c,$(foreach step,$1,$($(step)_lesson)))
techniques_of = $(patsubst $(ROOT)/%,%,\
    $(wildcard $(ROOT)/$(firstword $1)/techniques/table.c \
        $(foreach step,$1,$(ROOT)/$(step)/techniques/*/*)))
