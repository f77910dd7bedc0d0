# The five tasks of a contributor. On Windows, run the commands below each.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: help setup test check bench docs
help:  ## list the tasks
	@sed -n 's/^\([a-z]*\): .*## /\1\t/p' Makefile

setup: $(BIN)/kinlint  ## create .venv with all dependencies, and install the git hooks
	$(BIN)/pre-commit install

$(BIN)/kinlint: pyproject.toml
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install -q -e '.[test,lint]'
	@touch $@

test: $(BIN)/kinlint  ## run the tests that take seconds each; `.ci/run` runs all
	$(BIN)/pytest -q -n auto

check: $(BIN)/kinlint  ## run linters, type checks, import contracts and the rule formatter
	.ci/check $(BIN)

bench: $(BIN)/kinlint  ## run the benchmarks
	$(BIN)/python tests/benchmarks

docs: $(BIN)/kinlint  ## regenerate the generated pages
	$(BIN)/python tests/documents/pictures.py
	$(BIN)/kinlint config --schema > linter/kinlint.schema.json.new
	mv linter/kinlint.schema.json.new linter/kinlint.schema.json
	if [ -d "$${KINLINT_DATA:-../shared/data}" ]; then \
	    $(BIN)/python tests/real_models.py > tests/real_models.md.new && \
	    mv tests/real_models.md.new tests/real_models.md && \
	    $(BIN)/python tests/real_robots.py > rules/real-robots.md.new && \
	    mv rules/real-robots.md.new rules/real-robots.md; fi
	$(BIN)/kinlint rule --all --output-directory rules
