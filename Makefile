# `make report` and `make test` are all that a newcomer needs; both make .venv first.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: report test test-processors check check-studio bench bench-studio studio bundle extras clean

report: .venv/installed
	$(BIN)/quintrig report examples/car_boot.toml out/car_boot

test: .venv/installed-dev
	$(BIN)/python -m pytest -n auto

# What numbers and verdicts hang on, as on processors without AVX-512, and without AVX2.
NUMERICAL := $(addprefix tests/test_,$(addsuffix .py,any_processor basis compiled construct curve envelope exact extremes far \
	integrate layers nurbs properties quantity sample studio_numbers summary surface sweep_numbers still_edges sweep_unbounded unroll))

test-processors: .venv/installed-dev
	$(BIN)/python .ci/processor.py haswell -m pytest -n auto $(NUMERICAL)
	$(BIN)/python .ci/processor.py generic -m pytest -n auto $(NUMERICAL)

check: .venv/installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright --project pyproject.toml

# The browser's half: types, lint, unit tests, and the bundle that its sources make is the one that ships.
check-studio: studio/node_modules
	cd studio && npm run --silent check && npm run --silent lint && npm test --silent
	mkdir -p out && node studio/build.mjs out/studio.js && cmp out/studio.js src/quintrig/studio/bundle/studio.js

bench: .venv/installed-dev
	$(BIN)/python -m bench

# From moving a slider to the drawn frame, in a real browser.
bench-studio: .venv/installed-dev
	$(BIN)/python bench/studio.py

# The live studio on an example. The bundle is part of the repository: this builds nothing and needs no Node.
studio: .venv/installed-studio
	$(BIN)/quintrig view $(or $(MODEL),examples/car_boot.toml)

# Build the studio's bundle anew after a change to studio/src, or to a table that it holds (needs Node and npm).
bundle: .venv/installed-dev studio/node_modules
	$(BIN)/python -m quintrig.studio.data studio/src/data.json
	cd studio && npx tsc --noEmit && node build.mjs

studio/node_modules: studio/package-lock.json
	cd studio && npm ci --no-audit --no-fund
	touch $@

# Everything optional: CAD, meshes, studio, clusters. The tests that need one of them skip without it.
extras: .venv/installed-dev
	$(BIN)/python -m pip install --quiet --editable ".[dev,all]"

.venv/bin/python:
	$(PYTHON) -m venv .venv

.venv/installed: .venv/bin/python pyproject.toml
	$(BIN)/python -m pip install --quiet --editable .
	touch $@

.venv/installed-studio: .venv/bin/python pyproject.toml
	$(BIN)/python -m pip install --quiet --editable ".[studio]"
	touch $@ .venv/installed

.venv/installed-dev: .venv/bin/python pyproject.toml
	$(BIN)/python -m pip install --quiet --editable ".[dev]"
	touch $@ .venv/installed

clean:
	rm -rf .venv out
