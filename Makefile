# Every target does its own set-up. The first call makes .venv and installs the pinned packages
# (a minute); later calls start the job at once, because the stamps below are newer than the locks.
#
#   make verify       decide every printed claim, write build/verify
#   make test         format, lint, types, import contracts, tests
#   make test-strict  the same and the slow rest; nothing may be skipped
#   make bench        time the exact methods, with error and status beside the time
#   make generate     rewrite what is generated from theory
#   make docs         the manual, as HTML in docs/_build/html
#   make clean        remove what the targets made, the environment included

PYTHON ?= $(shell command -v python3.11 || command -v python3)
BIN := .venv/bin
READY := .venv/.ready
READY_STRICT := .venv/.ready-strict
WORKERS ?= 2

export PIP_DISABLE_PIP_VERSION_CHECK := 1
export PIP_NO_INPUT := 1

.DELETE_ON_ERROR:
.NOTPARALLEL:
.PHONY: help verify test test-strict strict-programs bench generate docs clean

help:
	@sed -n 's/^#   //p' Makefile

verify: $(READY)
	$(BIN)/sensortrack verify

test: $(READY)
	$(BIN)/python -m pytest -n $(WORKERS)

test-strict: $(READY_STRICT) strict-programs
	SENSORTRACK_STRICT=1 $(BIN)/python -m pytest -n $(WORKERS)
	$(BIN)/python -m sphinx -q -W --keep-going docs docs/_build/html

bench: $(READY_STRICT)
	mkdir -p build
	$(BIN)/python -m pytest benchmarks -o python_files='bench_*.py' --benchmark-only --benchmark-json build/bench.json

generate: $(READY)
	$(BIN)/python -m theory generate

docs: $(READY_STRICT)
	$(BIN)/python -m sphinx -q -W --keep-going docs docs/_build/html

clean:
	rm -rf .venv build dist docs/_build *.egg-info
	rm -rf .pytest_cache .mypy_cache .ruff_cache .hypothesis .benchmarks .import_linter_cache
	find theory sensortrack verification tests benchmarks docs -name __pycache__ -prune -exec rm -rf {} +

$(READY): requirements.lock pyproject.toml
	@test -n "$(PYTHON)" || { echo "make: no python3 found; install Python 3.11 or later, or give PYTHON=/path/to/python" >&2; exit 1; }
	@"$(PYTHON)" -c 'import sys; sys.exit(sys.version_info < (3, 11))' || { echo "make: $(PYTHON) is no Python 3.11 or later; give PYTHON=/path/to/one" >&2; exit 1; }
	"$(PYTHON)" -m venv .venv
	$(BIN)/python -m pip install -q -r requirements.lock
	$(BIN)/python -m pip install -q --no-deps --no-build-isolation -e .
	@touch $@

$(READY_STRICT): $(READY) requirements-strict.lock
	$(BIN)/python -m pip install -q -r requirements-strict.lock
	@touch $@

# A second compiler and a browser, which the strict tests compare results with.
strict-programs:
	@missing=; \
	for program in clang chromium; do command -v $$program >/dev/null || missing="$$missing $$program"; done; \
	if [ -n "$$missing" ] && [ "$$(id -u)" = 0 ] && command -v apt-get >/dev/null; then \
	    apt-get update -qq && DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends $$missing; \
	fi; \
	for program in clang chromium; do \
	    command -v $$program >/dev/null || { echo "make: test-strict needs $$program; install it and try again" >&2; exit 1; }; \
	done
