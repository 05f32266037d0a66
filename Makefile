# Needs Python 3.11 or later, git and make; everything else goes into .venv (for the benchmarks into .venv-bench, for
# JupyterLab into .venv-lab).
#   make PYTHON=python3.12 test    uses that interpreter instead of the first suitable one on the path

MAKEFLAGS += --no-builtin-rules --no-print-directory
.DEFAULT_GOAL := help

PYTHON ?=
VENV := .venv
BENCH_VENV := .venv-bench
LAB_VENV := .venv-lab
BIN := $(VENV)/bin
DEMO := build/demo
SITE := build/site
# Quiet twice: errors only.
PIP_QUIET := --disable-pip-version-check --quiet --quiet

# The stamp is older than pyproject.toml when the dependencies may have changed. An interpreter that was asked for
# by name has a stamp of its own, so that asking for another one takes effect.
ready = $(1)/.ready$(if $(PYTHON),-$(subst /,_,$(PYTHON)))
READY := $(call ready,$(VENV))
BENCH_READY := $(call ready,$(BENCH_VENV))
LAB_READY := $(call ready,$(LAB_VENV))

# An environment whose interpreter is gone is made anew.
runs = $(shell $(1)/bin/python -c 'print("yes")' 2>/dev/null)
ifneq ($(call runs,$(VENV)),yes)
.PHONY: $(READY)
endif
ifneq ($(call runs,$(BENCH_VENV)),yes)
.PHONY: $(BENCH_READY)
endif
ifneq ($(call runs,$(LAB_VENV)),yes)
.PHONY: $(LAB_READY)
endif

.PHONY: help
help: ## list the targets
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  make \1\t\2/p' Makefile | expand -t 22

.PHONY: demo
demo: $(READY) ## analyse the octahedral platform, every stage, and write its report
	$(BIN)/gcrules analyze "ab af cb cd ed ef"
	@mkdir -p $(DEMO)
	$(BIN)/gcrules report examples/octahedral.yaml -o $(DEMO)/octahedral.html
	@echo
	@echo "The report is in $(CURDIR)/$(DEMO)/octahedral.html"

.PHONY: test
test: $(READY) ## run the tests and doctests; ends with what was left out
	$(BIN)/python -m pytest -n auto --dist worksteal --spread

.PHONY: test-all
test-all: $(READY) ## the same with all cases of the tests that cost much (tests/choice.py)
	$(BIN)/python -m pytest -n auto --dist worksteal

.PHONY: test-fast
test-fast: $(READY) ## of all tests those that find most in a second; a minute and a half on two cores (tests/choice.py)
	$(BIN)/python -m pytest -n auto --dist worksteal --fast tests

.PHONY: costs
costs: $(READY) ## measure again what the tests cost, of which `make test` makes its choice
	$(BIN)/python -m pytest -n auto --dist worksteal --costs tests/data/costs.txt

# A plugin that does not end is stopped by a signal, which may come while coverage holds its lock.
ENDLESS := tests/rules/test_foreign.py::test_a_plugin_that_does_not_end_is_stopped
.PHONY: coverage
coverage: $(READY) ## the same with branch coverage, which takes twice as long
	$(BIN)/python -m pytest -n auto --dist worksteal --deselect $(ENDLESS) --cov --cov-branch --cov-report=term

# Seeds are dates, so that each day tries other inputs; WORKERS=1 SEED=12 make fuzz says otherwise.
WORKERS ?= $(shell nproc 2> /dev/null || echo 2)
SEED ?= $(shell date +%Y%m%d)

.PHONY: fuzz
fuzz: $(READY) ## try odd inputs of every kind for 10 minutes; what is wrong is shown with a small input
	$(BIN)/python -m tests.fuzz --seconds 600 --workers $(WORKERS) --seed $(SEED)

.PHONY: fuzz-nightly
fuzz-nightly: $(READY) ## the same with 100,000 inputs of each kind, which takes hours, and a record of it
	$(BIN)/python -m tests.fuzz --nightly --workers $(WORKERS) --seed $(SEED) --record

.PHONY: proofs
proofs: $(READY) ## write the proofs of all classes, robots and theorems, and have them checked, by Coq too where it is installed
	$(BIN)/python tools/all_proofs.py build/proofs

.PHONY: check
check: lint types contracts docs-check ## lint, formatting, types, the order of the rooms, documentation

.PHONY: lint
lint: $(READY)
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .

.PHONY: types
types: $(READY)
	$(BIN)/mypy
	$(BIN)/mypy benchmarks/conftest.py

.PHONY: contracts
contracts: $(READY)
	$(BIN)/lint-imports --no-cache
	$(BIN)/python tools/studio_protocol.py --check

.PHONY: docs-check
docs-check: $(READY)
	$(BIN)/python tools/check_docs.py
	@$(build-site)

.PHONY: docs
docs: $(READY) ## write the generated pages of docs/, check every link and picture, build the guide
	$(BIN)/python tools/check_docs.py --write
	$(BIN)/python tools/answer_pictures.py --check
	@$(build-site)
	@echo "The guide is in $(CURDIR)/$(SITE)/index.html"

# The engine that runs in the guide's pages: Pyodide from npm, and what gcrules is made of.
ENGINE := build/engine
.PHONY: site
site: $(READY) tools/engine/node_modules/.package-lock.json ## build the guide with run buttons: the engine in its pages (needs Node)
	$(BIN)/python tools/site_engine.py $(ENGINE)
	@export GCRULES_SITE_ENGINE=$(ENGINE); $(build-site)
	@echo "Serve it: $(BIN)/python -m http.server --directory $(SITE)"

.PHONY: site-check
site-check: site ## run every example that has a button, under Node and in Chromium
	cd tools/engine && npm run --silent test
	GCRULES_SITE=$(SITE) $(BIN)/python -m pytest -q tests/project/test_site_engine.py

tools/engine/node_modules/.package-lock.json: tools/engine/package-lock.json
	@command -v npm > /dev/null || { echo "make: the engine of the guide's pages needs Node 20 or later with npm." >&2; exit 1; }
	cd tools/engine && npm ci --ignore-scripts --no-fund --no-audit --loglevel=error

.PHONY: studio
studio: $(READY) studio-ui/node_modules/.package-lock.json ## build the viewer and the studio's page from studio-ui/ (needs Node)
	$(BIN)/python tools/studio_protocol.py
	cd studio-ui && npm run --silent build

.PHONY: studio-check
studio-check: studio-ui/node_modules/.package-lock.json ## check its types, run its tests, compare the committed page with its sources
	cd studio-ui && npm run --silent check && npm run --silent test

studio-ui/node_modules/.package-lock.json: studio-ui/package-lock.json
	@command -v npm > /dev/null || { echo "make: building the page needs Node 20 or later with npm." >&2; exit 1; }
	cd studio-ui && npm ci --ignore-scripts --no-fund --no-audit --loglevel=error

.PHONY: lab lab-ready
lab-ready: $(LAB_READY)
lab: $(READY) lab-ready ## try the widget in a JupyterLab, which gets an environment of its own (needs Chromium)
	GCRULES_JUPYTERLAB=$(CURDIR)/$(LAB_VENV)/bin/jupyter-lab $(BIN)/python -m pytest -q tests/apps/test_jupyterlab.py

.PHONY: release-check
release-check: $(READY) ## build sdist and wheel, and try them on every Python here with the oldest and newest packages
	$(BIN)/python tools/release_check.py --all build/release

.PHONY: bench
bench: $(BENCH_READY) ## run the benchmarks beside naive forms and peers, in an environment of their own
	$(BENCH_VENV)/bin/python -m pytest benchmarks

.PHONY: bench-curve
bench-curve: $(BENCH_READY) ## measure normal forms and factoring again, and redraw docs/speed.md (25 minutes)
	$(BENCH_VENV)/bin/python benchmarks/scale.py --measure

.PHONY: clean
clean: ## remove the environments and everything generated
	rm -rf $(VENV) $(BENCH_VENV) $(LAB_VENV) studio-ui/node_modules tools/engine/node_modules build dist .coverage .coverage.* .benchmarks .hypothesis .mypy_cache .pytest_cache .ruff_cache
	find . -name __pycache__ -type d -prune -exec rm -rf {} +

$(READY): pyproject.toml
	@$(call make-venv,$(VENV))
	@echo "make: installing into $(VENV); this takes a minute or so"
	@$(BIN)/python -m pip $(PIP_QUIET) install --editable ".[dev]"
	@$(BIN)/python -m compileall -q gcrules
	@touch $@

$(BENCH_READY): pyproject.toml benchmarks/peers.txt
	@$(call make-venv,$(BENCH_VENV))
	@echo "make: installing into $(BENCH_VENV); this takes a minute or so"
	@$(BENCH_VENV)/bin/python -m pip $(PIP_QUIET) install --editable ".[bench]"
	@$(BENCH_VENV)/bin/python -m compileall -q gcrules
	@grep -v '^ *\(#\|$$\)' benchmarks/peers.txt | while read -r peer; do \
	  $(BENCH_VENV)/bin/python -m pip $(PIP_QUIET) install "$$peer" < /dev/null \
	    || echo "make: the peer $$peer does not install here; its benchmarks go without it" >&2; \
	done
	@touch $@

$(LAB_READY): pyproject.toml
	@$(call make-venv,$(LAB_VENV))
	@echo "make: installing JupyterLab into $(LAB_VENV); this takes a minute or so"
	@$(LAB_VENV)/bin/python -m pip $(PIP_QUIET) install --editable ".[widget]" "jupyterlab>=4.2,<5"
	@touch $@

# A warning, a broken link or a load from the network is an error.
define build-site
$(BIN)/python tools/build_site.py $(SITE) && \
  $(BIN)/python tools/check_site.py $(SITE)
endef

# Make the environment $(1) unless it is there, with the interpreter asked for, or else with the first on the path
# that is new enough. Some distributions ship Python without the wheel of pip that venv copies; their own pip serves then.
define make-venv
new_enough='import sys; sys.exit(sys.version_info < (3, 11))'; \
version='import sys; print("%d.%d" % sys.version_info[:2])'; \
found=; \
for python in $(or $(PYTHON),python3 python3.14 python3.13 python3.12 python3.11 python); do \
  if "$$python" -c "$$new_enough" > /dev/null 2>&1; then found=$$python; break; fi; \
done; \
if [ -z "$$found" ]; then \
  echo "make: gcrules needs Python 3.11 or later, but $(or $(PYTHON),python3) is" \
    "$$($(or $(PYTHON),python3) -c "$$version" 2>/dev/null || echo missing)." >&2; \
  echo "make: name an interpreter that is new enough: make PYTHON=/path/to/python3.11 ..." >&2; \
  exit 1; \
fi; \
have=$$($(1)/bin/python -c "$$version" 2> /dev/null || echo none); \
if ! $(1)/bin/python -c "$$new_enough" > /dev/null 2>&1 || ! $(1)/bin/python -m pip --version > /dev/null 2>&1 \
    || { [ -n "$(PYTHON)" ] && [ "$$have" != "$$("$$found" -c "$$version")" ]; }; then \
  echo "make: $(1) with $$("$$found" --version)"; \
  "$$found" -m venv --clear $(1) 2> /dev/null || { \
    "$$found" -m venv --clear --without-pip $(1) && "$$found" -m pip --python $(1)/bin/python $(PIP_QUIET) install pip; \
  } || { \
    rm -rf $(1); \
    echo "make: $$found cannot make a virtual environment (Debian and Ubuntu: install python3-venv)." >&2; \
    exit 1; \
  }; \
fi; \
rm -f $(1)/.ready*
endef
