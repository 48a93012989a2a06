# make validate: everything behind docs/validation.md, with the boundary elements computed anew: in two hours or
# so. The short form, tests/validation/run.sh, is part of `make test-all`.

.PHONY: validate
validate:
	tests/setup.sh core validation
	nice -n 10 tests/validation/run.sh long
