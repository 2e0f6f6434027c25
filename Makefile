# LOFT: build, proof and set-up. `make help` lists what can be asked for.
#
# Nothing is listed by hand: sources are found, and their order comes from their `use` lines, because
# the path of a file is the name of its module. All products go to build/.

FC    := gfortran
AWK   := awk
BUILD := build
LIBS  := -llapack -lblas

# Builds of the same sources: as used, as distrusted (make DEBUG=1), as read by lint; for proofs
# apart from `make check`, watched by the sanitizers, and led by AFL++ (doc/robustness.md).
AFL  := /usr/lib/afl
MODE := $(if $(DEBUG),debug,release)
FLAGS.release := -O2 -g -ffp-contract=off
FLAGS.debug   := -O0 -g -fcheck=all,no-array-temps -ffpe-trap=invalid,zero,overflow -fbacktrace
FLAGS.sanitize := -O1 -g -fno-omit-frame-pointer -fsanitize=address,undefined \
    -fno-sanitize-recover=undefined -fbacktrace
FLAGS.afl     := -O1 -g -B$(AFL) -fcheck=all,no-array-temps -ffpe-trap=invalid,zero,overflow
FLAGS.lint    := -O0 -Wall -Wextra -pedantic -Wimplicit-interface -Wconversion-extra -Werror
# Objects go into program and library alike, so all are position independent.
FFLAGS        := -std=f2018 -fopenmp -fPIC -fno-semantic-interposition $(FLAGS.$(MODE))

ifeq ($(shell uname),Darwin)
LDFLAGS += -L$(shell brew --prefix lapack 2>/dev/null)/lib
endif

B    := $(BUILD)/$(MODE)
LOFT := $(if $(filter release,$(MODE)),$(BUILD),$(B))/loft

# The library: its interface, which is the number of the shared one, and its files.
ABI     := $(shell $(AWK) '$$2 == "LOFT_ABI_VERSION" { print $$3 }' src/api/loft.h)
VERSION := $(shell sed -n "s/.*version = '\(.*\)'/\1/p" src/base/constants.f90)
LIBLOFT := $(B)/libloft.a $(if $(filter Darwin,$(shell uname))$(filter sanitize,$(MODE)),,$(B)/libloft.so.$(ABI))
# The same program for many processes: modules of mpi/ take the place of their twins in src/.
MPIFC := mpifort
TWINS := $(sort $(shell find mpi -name '*.f90'))
HAS_MPI := $(shell command -v $(MPIFC))

SOURCES := $(sort $(shell find src tests -name '*.f90'))
OBJECTS := $(SOURCES:%.f90=$(B)/%.o)
PROGRAM := $(B)/src/app/main.o
TESTS   := $(filter-out tests/support/%,$(filter tests/%,$(SOURCES)))
CHECKS  := $(foreach t,$(TESTS),$(if $(filter test_%,$(notdir $t)),$(t:%.f90=$(B)/%)))
SCRIPTS := $(filter-out tests/soak/%,$(sort $(shell find tests -name '*.t')))
SOAKS   := $(patsubst %.f90,$(B)/%,$(filter tests/soak/%,$(TESTS)))
HOURS   := $(sort $(wildcard tests/soak/*.t))
BENCHES := $(patsubst %.f90,$(B)/%,$(filter tests/bench/%,$(TESTS)))
BOOK    := $(B)/tests/book/book
# The outside judges of exported files; they judge what the release build writes.
JUDGES  := $(BUILD)/judges
UNJUDGED := $(if $(filter release,$(MODE)),,tests/judges/%)
JOBS    := $(shell getconf _NPROCESSORS_ONLN)

PREFIX := /usr/local
DECK   := cards/sae700202.crd
PLOTS  := $(BUILD)/plots

MAKEFLAGS += --no-print-directory

.DELETE_ON_ERROR:
.PHONY: all debug programs library objects deps deps-test deps-doc doc demo check test sanitize soak lint golden book \
    plot pictures bench graph install uninstall clean help

all: $(LOFT)$(if $(MPI),-mpi)       ## builds build/loft (DEBUG=1: build/debug/loft; MPI=1: build/loft-mpi)
	@:

debug:                              ## builds build/debug/loft, which checks all it does
	@$(MAKE) MODE=debug all

# --- compiling and linking ----------------------------------------------------------------------

# The rules `object: objects of the modules it uses` and `program: objects it needs`.
$(shell mkdir -p $(B)/mod && $(AWK) -v objects=$(B) -v loft=$(LOFT) -v library=$(B)/libloft.o \
    -v twins='$(TWINS)' \
    -f tests/make/modules.awk -f tests/make/order.awk $(SOURCES) > $(B)/order.mk)
include $(B)/order.mk

# Reals are compared for equality in one module only, and in tests.
EXACT = $(if $(filter src/base/exact.f90 tests/%,$<),-Wno-compare-reals)

$(OBJECTS): $(B)/%.o: %.f90 Makefile
	@mkdir -p $(@D)
	@echo "$(MODE): $<"
	@$(FC) $(FFLAGS) $(EXACT) -J$(B)/mod -c $< -o $@

# Where the linker can do that, the program asks for memory through app_memory.
ifneq ($(shell uname),Darwin)
$(LOFT): LDFLAGS += -Wl,--wrap=malloc,--wrap=calloc,--wrap=realloc
$(LOFT): $(B)/src/app/memory.o
endif

$(LOFT): $(PROGRAM)
$(LOFT) $(TESTS:%.f90=$(B)/%):
	@echo "$(MODE): $@"
	@$(FC) $(FFLAGS) $(filter %.o,$^) $(LDFLAGS) $(LIBS) -o $@

# One object, in which all names but those of the faces are local; both libraries are made of it.
$(B)/libloft.o: src/api/libloft.map
	@echo "$(MODE): $@"
	@ld -r $(filter %.o,$^) -o $@
	@! command -v objcopy > /dev/null || objcopy --wildcard \
	    --keep-global-symbol='loft_*' --keep-global-symbol='__api_loft_MOD_*' $@

$(B)/libloft.a: $(B)/libloft.o
	@rm -f $@
	@ar rcs $@ $<

$(B)/libloft.so.$(ABI): $(B)/libloft.o
	@echo "$(MODE): $@"
	@$(FC) -shared -fopenmp -Wl,-soname,$(@F) -Wl,--version-script=src/api/libloft.map -Wl,-z,defs \
	    $< $(LDFLAGS) $(LIBS) -o $@

# The interface of a twin is that of the module it stands for, so that module's users need not be
# compiled again; tests/sweep/twins.t compares the two.
$(TWINS:%.f90=$(B)/%.o): $(B)/%.o: %.f90 Makefile
	@command -v $(MPIFC) > /dev/null || { echo "there is no $(MPIFC); make MPI=1 deps installs it" >&2; exit 1; }
	@mkdir -p $(@D) $(B)/mpi/mod
	@echo "$(MODE): $<"
	@$(MPIFC) $(FFLAGS) -J$(B)/mpi/mod -I$(B)/mod -c $< -o $@

$(LOFT)-mpi:
	@echo "$(MODE): $@"
	@$(MPIFC) $(FFLAGS) $(filter %.o,$^) $(LDFLAGS) $(LIBS) -o $@

objects: $(OBJECTS) $(if $(HAS_MPI),$(TWINS:%.f90=$(B)/%.o))
	@:
programs: $(LOFT) $(TESTS:%.f90=$(B)/%)
	@:
library: $(LIBLOFT)                 ## builds libloft.a and libloft.so
	@:

# --- set-up and show ----------------------------------------------------------------------------

deps:                               ## installs what is missing (DEPS=yes allows sudo; MPI=1: OpenMPI, too)
	@DEPS=$(DEPS) FC=$(FC) MPI=$(MPI) sh tests/make/deps.sh

deps-test:                          ## installs the judges of exported files (into build/judges)
	@DEPS=$(DEPS) sh tests/make/deps-test.sh $(JUDGES)

demo: deps                          ## sets up, builds, runs the deck of 1970, compares, draws
	@$(MAKE) all $(BOOK)
	@echo && echo "== $(LOFT) run --arithmetic s360 $(DECK) > $(BUILD)/demo.lst (first page)" && echo
	@$(LOFT) run --arithmetic s360 $(DECK) > $(BUILD)/demo.lst
	@sed -n 1,60p $(BUILD)/demo.lst | tr -d '\f'
	@echo && echo "== make book: the paper's figures beside ours" && echo
	@$(MAKE) book
	@echo && echo "== make plot: the pictures" && echo
	@$(MAKE) plot
	@echo && echo "The whole listing is $(BUILD)/demo.lst, the program is $(LOFT)."

book: $(BOOK)                       ## shows the printed figures of SAE 700202 and seed 002 beside ours
	@$(BOOK)

plot: $(LOFT)                       ## draws the pictures of DECK
	@$(LOFT) plot $(DECK) -o $(PLOTS) --format svg
	@$(LOFT) plot $(DECK) -o $(PLOTS) --format png

pictures: $(LOFT) deps-test         ## draws the pictures of the README (doc/*.svg, *.png)
	@$(LOFT) plot cards/sae700202.crd -o $(PLOTS)
	@$(LOFT) plot cards/fuselage.crd -o $(BUILD)/fuselage
	@for p in side sections; do cp $(PLOTS)/$$p.svg doc/nose-$$p.svg; done
	@$(LOFT) plot cards/fuselage.crd -o $(BUILD)/fuselage --format png
	@cp $(BUILD)/fuselage/lines.svg doc/fuselage-lines.svg
	@cp $(BUILD)/fuselage/view3d.png doc/fuselage-view3d.png
	@$(LOFT) export cards/fuselage.crd -o $(BUILD)/frame.svg --cut STA_248 --bevel 4 > $(BUILD)/frame.txt
	@rsvg-convert -b white -w 800 $(BUILD)/frame.svg -o doc/frame-pattern.png
	@$(LOFT) export cards/fuselage.crd -o $(BUILD)/fuselage.step > $(BUILD)/fuselage.txt
	@$(JUDGES)/bin/python tests/judges/render.py $(BUILD)/fuselage.step doc/fuselage-skin.png

# Each program of tests/bench prints a section of doc/performance.md and leaves the data of its
# pictures in build/bench; plot/bench_NAME.gp draws doc/performance-NAME.svg from them.
bench: $(LOFT) $(BENCHES) $(BUILD)/bench/plain ## measures the speed: doc/performance.md
	$(if $(BENCHES),,$(error there is no program in tests/bench))
	@mkdir -p $(BUILD)/bench
	@LOFT=$(abspath $(LOFT)) BENCH=$(abspath $(BUILD)/bench) JUDGES=$(abspath $(JUDGES)) \
	    FC='$(FC)' FFLAGS='$(FFLAGS)' sh tests/bench/report.sh $(BENCHES) \
	    > $(BUILD)/bench/performance.md
	@for p in $(patsubst plot/bench_%.gp,%,$(wildcard plot/bench_*.gp)); do \
	    (cd plot && gnuplot -e "folder = '$(abspath $(BUILD)/bench)'; format = 'svg'; \
	        output_file = '../doc/performance-$$p.svg'" bench_$$p.gp) || exit 1; done
	@cp $(BUILD)/bench/performance.md doc/performance.md
	@$(AWK) -f tests/bench/section.awk -v name=Audit doc/performance.md doc/audit.md > $(BUILD)/bench/audit.md
	@cp $(BUILD)/bench/audit.md doc/audit.md
	@echo "written: doc/performance.md, the rates in doc/audit.md"

$(BUILD)/bench/plain: tests/bench/plain.c
	@mkdir -p $(@D)
	@gcc -O2 $< -lm -o $@

# --- proof --------------------------------------------------------------------------------------

check: deps                         ## sets up, builds, lints and runs all tests, twice
	@$(MAKE) programs
	@$(MAKE) MODE=debug programs
	@$(MAKE) lint
	@$(MAKE) test
	@$(MAKE) MODE=debug test

# Whole-program tests (tests/*.t) find the program and the tree by LOFT and ROOT.
test: $(LOFT) $(if $(HAS_MPI),$(LOFT)-mpi) $(LIBLOFT) $(CHECKS) $(BOOK) ## runs all tests of one build
	$(if $(CHECKS),,$(error there are no test programs))
	@echo "== tests of the $(MODE) build"
	@LOFT=$(abspath $(LOFT)) ROOT=$(CURDIR) JUDGES=$(abspath $(JUDGES)) MODE=$(MODE) \
	    prove --jobs $(JOBS) --failures --comments --exec '' \
	    $(CHECKS) $(filter-out $(UNJUDGED),$(SCRIPTS))
	@[ -x $(JUDGES)/bin/python ] || [ $(MODE) != release ] || \
	    echo "*** JUDGES SKIPPED: no outside program has read an exported file; make deps-test ***"

# All programs and scripts again, watched by the sanitizers: any report ends a program, with status
# 99. Lost memory is looked for in every run of LOFT, not in tests (tests/support/sanitize.supp).
sanitize:                           ## runs all tests under the address and undefined-behaviour sanitizers
	@$(MAKE) MODE=sanitize programs
	@ASAN_OPTIONS=detect_leaks=1:exitcode=99 UBSAN_OPTIONS=print_stacktrace=1 \
	    LSAN_OPTIONS=suppressions=$(CURDIR)/tests/support/sanitize.supp:print_suppressions=0 \
	    $(MAKE) MODE=sanitize test

MINUTES := 60
SEED    := 1

# Long proofs: programs and scripts of tests/soak, one after the other (MINUTES=5 SEED=7).
soak: $(LOFT) $(SOAKS)              ## breaks LOFT for MINUTES, or fails to (SEED)
	@$(MAKE) MODE=debug all
	@$(MAKE) MODE=sanitize all $(BUILD)/sanitize/libloft.a
	@LOFT=$(abspath $(LOFT)) ROOT=$(CURDIR) BUILD=$(abspath $(BUILD)) MINUTES=$(MINUTES) \
	    SEED=$(SEED) prove --failures --comments --exec '' $(SOAKS) $(HOURS)

lint:                               ## reads all sources: compiler warnings, layers, style
	@$(MAKE) MODE=lint objects
	@$(AWK) -f tests/make/modules.awk -f tests/lint/lint.awk $(SOURCES)
	@$(AWK) -f tests/make/modules.awk -f tests/lint/lint.awk $(TWINS)

golden: $(LOFT)                     ## rewrites golden/ with what the program prints now
	@LOFT=$(abspath $(LOFT)) ROOT=$(CURDIR) sh tests/golden

graph:                              ## draws the modules (build/graph.svg, doc/architecture.svg)
	@command -v dot > /dev/null || { echo "make graph needs dot, of the package graphviz" >&2; exit 1; }
	@$(AWK) -f tests/make/modules.awk -f tests/make/graph.awk $(filter src/%,$(SOURCES)) \
	    > $(BUILD)/graph.dot
	@dot -Tsvg $(BUILD)/graph.dot -o $(BUILD)/graph.svg
	@dot -Tpng $(BUILD)/graph.dot -o $(BUILD)/graph.png
	@cp $(BUILD)/graph.svg doc/architecture.svg
	@echo "drawn: $(BUILD)/graph.svg $(BUILD)/graph.png doc/architecture.svg"

# FORD makes pages of the docstrings; it lives in an environment of its own.
FORD := $(BUILD)/ford

deps-doc:                           ## installs FORD, for make doc (into build/ford)
	@cmp -s doc/requirements.txt $(FORD)/requirements.txt || { python3 -m venv $(FORD) && \
	    $(FORD)/bin/pip install --quiet --requirement doc/requirements.txt && \
	    cp doc/requirements.txt $(FORD); }

doc: deps-doc                       ## makes pages of the docstrings (build/doc/index.html)
	@$(FORD)/bin/ford doc/ford.md -o $(abspath $(BUILD))/doc > $(BUILD)/doc.log 2>&1 || \
	    { cat $(BUILD)/doc.log >&2; exit 1; }
	@! grep -E "Ignoring unknown Ford|^Error" $(BUILD)/doc.log
	@grep -q 'Loads a deck from a file' $(BUILD)/doc/module/api_loft.html
	@echo "made: $(BUILD)/doc/index.html, $$(ls $(BUILD)/doc/module | wc -l) modules"

# --- installing and cleaning --------------------------------------------------------------------

SHARE    = $(DESTDIR)$(PREFIX)/share
LIB      = $(DESTDIR)$(PREFIX)/lib
INCLUDE  = $(DESTDIR)$(PREFIX)/include
# Module files are the compiler's own.
COMPILER = gfortran-$(firstword $(subst ., ,$(shell $(FC) -dumpversion)))

install: $(LOFT) $(if $(MPI),$(LOFT)-mpi) $(LIBLOFT) ## installs below PREFIX (DESTDIR is put before it)
	install -d $(DESTDIR)$(PREFIX)/bin $(SHARE)/man/man1 $(SHARE)/loft/plot $(SHARE)/loft/cards \
	    $(SHARE)/doc/loft/doc/examples $(LIB)/pkgconfig $(INCLUDE)/loft/$(COMPILER)
	install -m 755 $(LOFT) $(if $(MPI),$(LOFT)-mpi) $(DESTDIR)$(PREFIX)/bin
	install -m 644 doc/loft.1 $(SHARE)/man/man1
	install -m 644 $(filter-out plot/bench_%,$(wildcard plot/*.gp)) $(SHARE)/loft/plot
	install -m 644 $(wildcard cards/*) $(SHARE)/loft/cards
	install -m 644 $(wildcard *.md) LICENSE $(SHARE)/doc/loft
	install -m 644 $(wildcard doc/*.md doc/*.svg doc/*.png) $(SHARE)/doc/loft/doc
	install -m 644 $(wildcard doc/examples/*) $(SHARE)/doc/loft/doc/examples
	install -m 644 $(LIBLOFT) $(LIB)
	for so in $(notdir $(filter %.so.$(ABI),$(LIBLOFT))); do ln -sf $$so $(LIB)/libloft.so; done
	install -m 644 src/api/loft.h $(INCLUDE)
	install -m 644 $(B)/mod/api_loft.mod $(INCLUDE)/loft/$(COMPILER)
	sed -e 's|@PREFIX@|$(abspath $(PREFIX))|' -e 's|@COMPILER@|$(COMPILER)|' \
	    -e 's|@VERSION@|$(VERSION)|' src/api/loft.pc.in > $(LIB)/pkgconfig/loft.pc

# What `install` would install, into a folder that goes again, is what there is to remove.
uninstall: $(LOFT) $(LIBLOFT)       ## removes what `make install` put below PREFIX
	@folder=$$(mktemp -d) && $(MAKE) install DESTDIR=$$folder > $$folder/log && \
	cd $$folder$(PREFIX) && \
	find . ! -type d | (cd $(DESTDIR)$(PREFIX) && xargs rm -f) && \
	find . -depth -type d -path '*/loft*' | (cd $(DESTDIR)$(PREFIX) && xargs rmdir 2> /dev/null); \
	rm -rf $$folder

clean:                              ## removes build/
	rm -rf $(BUILD)

help:                               ## says this
	@sed -n 's/^\([a-z-]*\):[^#]*## \(.*\)/make \1 \2/p' Makefile | \
	    $(AWK) '{ target = $$2; sub(/^make [a-z-]* /, ""); printf "make %-9s %s\n", target, $$0 }'
