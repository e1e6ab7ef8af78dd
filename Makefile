# SPDX-License-Identifier: Apache-2.0

# Flies, tests and proves URV. `make` lists the targets; docs/development.md
# explains them. Measurements have a Makefile of their own, in evidence.

.PHONY: help fly ground monte_carlo test check prove real_time cortex_m mc68000 \
        cost trace clean

GPRBUILD := gprbuild -q -p -j0

help:
	@echo "  make fly        fly the standard flight, leave it in flight/"
	@echo "  make ground     fly in real time: page, Yamcs, all programs; Ctrl-C"
	@echo "                  ends it, or GROUND_SECONDS=60; the control laws are"
	@echo "                  on, OPTIONS=\"--laws off\" flies without"
	@echo "  make monte_carlo  fly in random conditions, FLIGHTS=2000"
	@echo "  make real_time  build the partitions bin/urv_mcs and bin/urv_gsc"
	@echo "  make cortex_m   build both nodes for a bare Cortex-M4, fly them in"
	@echo "                  QEMU, compare them with the simulation"
	@echo "  make mc68000    the same on the report's processor, in Musashi"
	@echo "  make cost       cycles and stack on the bare machines, beside the"
	@echo "                  baseline; RENEW=--renew writes it"
	@echo "  make check      the quick tests: after each change"
	@echo "  make test       run every test"
	@echo "  make prove      prove src and proofs, renew the proof record"
	@echo "  make trace      requirements with their links, in trace/"
	@echo "  make clean      remove the built files and all results, flight/ too"
	@echo "  make -C evidence  list the measurements"

fly:
	@scripts/setup.sh fly
	@echo "fly: building bin/urv_sim"
	@scripts/patiently.sh "fly: building" \
	   $(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@mkdir -p flight
	@echo "fly: flying 180 s"
	@bin/urv_sim fly --plant jsbsim --pilot standard \
	   --record flight/record.csv --summary flight/summary.json \
	   --events flight/events.jsonl
	@bin/urv report flight/record.csv --summary flight/summary.json \
	   --events flight/events.jsonl -o flight/report.html
	@echo "fly: results are in flight/: report.html to look at;" \
	   "record.csv, summary.json, events.jsonl"

# Ends with Ctrl-C or after GROUND_SECONDS. OPTIONS: more of bin/urv ground's.
GROUND_SECONDS :=
OPTIONS        :=
ground:
	@scripts/setup.sh $(if $(findstring --no-yamcs,$(OPTIONS)),page,ground)
	@echo "ground: building bin/urv_gsc and bin/urv_mcs"
	@scripts/patiently.sh "ground: building" \
	   $(GPRBUILD) -P real_time/urv_real_time.gpr -XURV_Mode=flight
	@exec bin/urv ground $(if $(GROUND_SECONDS),--seconds $(GROUND_SECONDS)) \
	   $(OPTIONS)

FLIGHTS := 2000
monte_carlo:
	@scripts/setup.sh monte_carlo
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@bin/urv monte-carlo --flights $(FLIGHTS)

test:
	@scripts/setup.sh test
	@.venv/bin/python scripts/run_tests.py

check:
	@scripts/setup.sh check
	@.venv/bin/python scripts/run_tests.py --quick

prove:
	@scripts/setup.sh prove
	@python3 scripts/proof_record.py prove
	@gnatprove -P examples/thermostat/thermostat.gpr --no-subprojects -j0 \
	   --checks-as-errors --report=fail
	@gnatprove -P targets/drivers.gpr --no-subprojects -j0 \
	   --checks-as-errors --warnings=error

real_time:
	@scripts/setup.sh real_time
	@$(GPRBUILD) -P real_time/urv_real_time.gpr -XURV_Mode=flight

cortex_m:
	@scripts/setup.sh cortex_m
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@targets/build.sh cortex_m gsc
	@targets/build.sh cortex_m mcs
	@python3 -B targets/figures.py cortex_m

mc68000:
	@scripts/setup.sh mc68000
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@targets/mc68000/musashi/build_board.sh
	@targets/build.sh mc68000 telemetry_board
	@targets/build.sh mc68000 gsc
	@targets/build.sh mc68000 mcs
	@python3 -B targets/figures.py mc68000

# RENEW=--renew writes the figures as the new baseline.
cost:
	@scripts/setup.sh cortex_m
	@scripts/setup.sh mc68000
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@targets/mc68000/musashi/build_board.sh
	@targets/build.sh mc68000 telemetry_board
	@for machine in cortex_m mc68000; do \
	   for node in gsc mcs; do \
	      targets/build.sh $$machine $$node || exit 1; \
	   done; \
	done
	@python3 -B targets/cost.py $(RENEW)

trace:
	@scripts/setup.sh trace
	@.venv/bin/python scripts/trace/run.py export

clean:
	@rm -rf obj bin flight campaign trace coverage

# Targets of evidence can be called from here, too.
.DEFAULT:
	@$(MAKE) --no-print-directory -C evidence $@
