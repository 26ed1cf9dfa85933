# `make report` and `make test` are all that a newcomer needs; both make .venv first.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: report test check bench extras clean

report: .venv/installed
	$(BIN)/quintrig report examples/car_boot.toml out/car_boot

test: .venv/installed-dev
	$(BIN)/python -m pytest -n auto

check: .venv/installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright

bench: .venv/installed-dev
	$(BIN)/python -m bench

# Everything optional: CAD, meshes, studio, clusters. The tests that need one of them skip without it.
extras: .venv/installed-dev
	$(BIN)/python -m pip install --quiet --editable ".[dev,all]"

.venv/bin/python:
	$(PYTHON) -m venv .venv

.venv/installed: .venv/bin/python pyproject.toml
	$(BIN)/python -m pip install --quiet --editable .
	touch $@

.venv/installed-dev: .venv/bin/python pyproject.toml
	$(BIN)/python -m pip install --quiet --editable ".[dev]"
	touch $@ .venv/installed

clean:
	rm -rf .venv out
