# What a release offers: packaging/dist.py builds it, tests/dist/run.sh proves it.

.PHONY: dist dist-test release

dist:
	python3 packaging/dist.py $(TARGETS)

dist-test:
	tests/dist/run.sh

release:
	python3 packaging/release.py "$(VERSION)"
