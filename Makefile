# What one does here, in five words. On Windows, the commands below them.
PYTHON ?= python3
BIN := .venv/bin

.PHONY: help setup test check bench docs
help:  ## say what there is
	@sed -n 's/^\([a-z]*\): .*## /\1\t/p' Makefile

setup: $(BIN)/kinlint  ## make .venv with all that is needed, and have git run the hooks
	$(BIN)/pre-commit install

$(BIN)/kinlint: pyproject.toml
	$(PYTHON) -m venv .venv
	$(BIN)/python -m pip install -q -e '.[test,lint]'
	@touch $@

test: $(BIN)/kinlint  ## run the tests that take seconds each; `.ci/run` runs all
	$(BIN)/pytest -q -n auto

check: $(BIN)/kinlint  ## hold code, types, layers, workflows and rule files to their checks
	.ci/check $(BIN)

bench: $(BIN)/kinlint  ## measure how fast it is
	$(BIN)/python tests/benchmarks

docs: $(BIN)/kinlint  ## make the generated pages anew; those on real robots where their files are
	$(BIN)/kinlint config --schema > linter/kinlint.schema.json.new
	mv linter/kinlint.schema.json.new linter/kinlint.schema.json
	if [ -d "$${KINLINT_DATA:-../shared/data}" ]; then \
	    $(BIN)/python tests/real_models.py > tests/real_models.md.new && \
	    mv tests/real_models.md.new tests/real_models.md && \
	    $(BIN)/python tests/real_robots.py > rules/real-robots.md.new && \
	    mv rules/real-robots.md.new rules/real-robots.md; fi
	$(BIN)/kinlint rule --all --output-directory rules
