# The set-up commands. On a machine with Python >= 3.11, make and the package registry:
#   make plan              plan the house; PART=name or file, ARGS="--action ... --json"
#   make test              everything: tests, doctests, documents, notebooks

PYTHON ?= python3
PART ?= house
ARGS ?=
WORKERS ?= auto

VENV := .venv
BIN := $(VENV)/bin
PIP := $(BIN)/python -m pip --disable-pip-version-check install --quiet
PYTEST := $(BIN)/python -m pytest -n $(WORKERS) --dist worksteal --nbmake

.PHONY: plan test test-slow lint docs bench clean

plan: $(VENV)/.installed
	@$(BIN)/stochgeom plan "$(PART)" $(ARGS)

test: $(VENV)/.installed-dev
	$(PYTEST)

# The empty expression lifts the default "not slow".
test-slow: $(VENV)/.installed-dev
	$(PYTEST) -m ""

lint: $(VENV)/.installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy

# The manual, to be read from build/manual/index.html; what a reference cannot find is an error, and so
# is a notebook that fails. ARGS="-D thesis_long_experiments=1" runs the long experiments as well.
docs: $(VENV)/.installed-dev
	$(BIN)/python -m sphinx --fresh-env --fail-on-warning --keep-going --quiet -b html $(ARGS) docs build/manual

bench: $(VENV)/.installed-dev
	$(BIN)/python -m benchmarks $(ARGS)

clean:
	rm -rf $(VENV) .hypothesis .mypy_cache .pytest_cache .ruff_cache build dist docs/notebooks
	find stochgeom tests benchmarks -name __pycache__ -prune -exec rm -rf {} +

# The stamps make a second call install nothing. `venv` is safe to repeat, so that a set-up that
# was cut short is taken up again. The notes go to stderr: stdout belongs to the plan.
$(VENV)/.installed: pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
	  { echo 'stochgeom needs Python 3.11 or newer; name one: make PYTHON=python3.12 ...' >&2; exit 1; }
	@echo 'Setting up $(VENV), once (about half a minute)...' >&2
	@$(PYTHON) -m venv $(VENV)
	@$(PIP) --upgrade pip
	@$(PIP) --editable .
	@touch $@

$(VENV)/.installed-dev: $(VENV)/.installed
	@echo 'Adding the development tools...' >&2
	@$(PIP) --editable . --group dev
	@$(PIP) --only-binary stormpy --group oracles || echo 'No stormpy here: its tests are skipped' >&2
	@touch $@
