# `make report` and `make test` are all that a newcomer needs; both make .venv first.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: report test test-fast test-slow test-lowest test-processors check check-studio bench bench-studio studio bundle docs paper dist extras clean

report: .venv/installed
	$(BIN)/quintrig report examples/car_boot.toml out/car_boot

# Tests run in as many processes as there are cores: threads of the linear algebra would wait for each other.
test-fast test-slow test-lowest test-processors: export OPENBLAS_NUM_THREADS := 1

# All tests, in two parts: what to run while working, and what takes long (tests/conftest.py says which). CI prints
# what share of the lines the fast ones reach in their own process.
test: test-fast test-slow

test-fast: .venv/installed-dev
	$(BIN)/python -m pytest -n auto -m "not slow" $(if $(CI),--cov --cov-report=term)

# More processes than cores: pages and commands mostly wait.
test-slow: .venv/installed-dev
	$(BIN)/python -m pytest -n 4 -m slow

# Numbers with the lowest versions of dependencies that pyproject.toml lets in, in an environment of their own.
LOWEST := $(addprefix tests/test_,$(addsuffix .py,basis construct curve envelope integrate model nurbs quantity schema \
	summary surface table))

test-lowest: .venv-lowest/installed
	.venv-lowest/bin/python -m pytest -n auto $(LOWEST)

.venv-lowest/installed: .ci/lowest.py pyproject.toml
	$(PYTHON) -m venv .venv-lowest
	$(PYTHON) .ci/lowest.py > .venv-lowest/lowest.txt
	.venv-lowest/bin/python -m pip install --quiet --constraint .venv-lowest/lowest.txt --editable . \
		pytest pytest-xdist packaging hypothesis mpmath jsonschema
	touch $@

# What numbers and verdicts hang on, as on processors without AVX-512, and, where rounding decided once, without AVX2.
NUMERICAL := $(addprefix tests/test_,$(addsuffix .py,any_processor basis construct curve envelope exact extremes far integrate \
	layers nurbs properties sample studio_numbers summary surface still_edges unroll))
DECIDED := $(addprefix tests/test_,$(addsuffix .py,any_processor envelope exact far still_edges unroll))

test-processors: .venv/installed-dev
	$(BIN)/python .ci/processor.py haswell -m pytest -n auto $(NUMERICAL)
	$(BIN)/python .ci/processor.py generic -m pytest -n auto $(DECIDED)

check: .venv/installed-dev
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/pyright --project pyproject.toml

# The browser's half: types, lint, unit tests, and the bundle that its sources make is the one that ships.
check-studio: studio/node_modules
	cd studio && npm run --silent check && npm run --silent lint && npm test --silent
	mkdir -p out && node studio/build.mjs out/studio.js && cmp out/studio.js src/quintrig/studio/bundle/studio.js

# With OUT=bench/results/VERSION.json the tables are kept there too, as for each release.
bench: .venv/installed-dev
	$(BIN)/python -m bench $(if $(OUT),--keep $(OUT))

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

# The documentation site, out/site/index.html: guides, gallery, notebooks (run anew), reference. Needs no network.
docs: .venv/installed-docs
	$(BIN)/python -m mkdocs build --strict --quiet

.venv/installed-docs: .venv/bin/python pyproject.toml
	$(BIN)/python -m pip install --quiet --editable ".[docs,all]"
	touch $@ .venv/installed

# Everything optional: CAD, meshes, studio, clusters. The tests that need one of them skip without it.
extras: .venv/installed-dev
	$(BIN)/python -m pip install --quiet --editable ".[dev,all,docs]"

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

# The draft of the paper, out/paper.pdf, through Pandoc and pdfLaTeX.
paper: .venv/installed-dev
	mkdir -p out && cd paper && ../$(BIN)/python -c "import pypandoc; pypandoc.convert_file('paper.md', 'pdf', \
		outputfile='../out/paper.pdf', extra_args=['--citeproc', '--bibliography=paper.bib', '-V', 'geometry:margin=25mm', '-V', 'fontfamily=times', '-V', 'colorlinks'])"

# The wheel and the source distribution, dist/, as they are uploaded.
dist: .venv/installed-dev
	rm -rf dist && $(BIN)/python -m build --no-isolation && $(BIN)/python -m twine check --strict dist/*

clean:
	rm -rf .venv .venv-lowest out
