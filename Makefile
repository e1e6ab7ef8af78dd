# SPDX-License-Identifier: Apache-2.0

# What a person does with URV. `make` lists it; docs/development.md explains.

.PHONY: help fly ground monte_carlo test check prove explore fuzz campaign \
        theory bench size trace mutate planted real_time timing trials coverage \
        independence margins surfaces clean attack

GPRBUILD := gprbuild -q -p -j0

help:
	@echo "Product: fly it and work on it."
	@echo "  make fly        fly the standard flight, leave it in flight/"
	@echo "  make ground     fly in real time: page, Yamcs, all programs; Ctrl-C"
	@echo "                  ends it, or GROUND_SECONDS=60; the control laws are"
	@echo "                  on, OPTIONS=\"--laws off\" flies without"
	@echo "  make real_time  build the partitions bin/urv_mcs and bin/urv_gsc"
	@echo "  make check      the quick tests: after each change"
	@echo "  make test       run every test"
	@echo "  make prove      prove src and proofs, renew the proof record"
	@echo "  make clean      remove what was built"
	@echo "Evidence: measure it. RENEW=--renew writes the result into docs."
	@echo "  make explore    explore both telemetry boards exhaustively"
	@echo "  make campaign   spoil the link in every way, see it recover;"
	@echo "                  CAMPAIGN=tiny|short|full FORMAT=1|2 JOBS=N"
	@echo "  make monte_carlo  fly in conditions by chance, FLIGHTS=2000"
	@echo "  make fuzz       fuzz a telemetry board, or FUZZ=files or readers,"
	@echo "                  SECONDS=60"
	@echo "  make mutate     change the code, report what nothing notices, JOBS=N"
	@echo "  make planted    plant the defects that the safety monitor finds"
	@echo "  make attack     2,000 sealed flights with someone in the middle"
	@echo "  make coverage   what the tests reach, in coverage/ [RENEW]"
	@echo "  make independence  other switches, compilers [RENEW]"
	@echo "  make theory     the link under bit errors beside theory [RENEW]"
	@echo "  make trials     ten minutes of station, garbage, a full disk [RENEW]"
	@echo "  make timing     the partitions beside cyclictest, SECONDS=60 [RENEW]"
	@echo "  make margins    poles and margins of the control laws [RENEW]"
	@echo "  make surfaces   flights with a failed surface, SAMPLE=N [RENEW]"
	@echo "  make bench      calls and simulation beside what one would take"
	@echo "                  instead, BEFORE=COMMIT beside then's [RENEW]"
	@echo "  make size       static data of each node's flight software"
	@echo "  make trace      requirements with their links, in trace/"

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

# Ends with Ctrl-C, or after so long. OPTIONS: more of bin/urv ground's.
GROUND_SECONDS :=
OPTIONS        :=
ground:
	@scripts/setup.sh ground
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

explore:
	@scripts/setup.sh explore
	@$(GPRBUILD) -P explore/urv_explore.gpr -XURV_Mode=host
	@bin/urv_explore

# Goes on where it stopped. One worker, unless JOBS says more.
MUTATE_JOBS = $(if $(filter command%,$(origin JOBS)),$(JOBS),1)
mutate:
	@scripts/setup.sh mutate
	@.venv/bin/python scripts/mutation/run.py --jobs $(MUTATE_JOBS)
	@.venv/bin/python scripts/mutation/report.py table

# Someone in the middle of a sealed line (docs/security.md).
attack:
	@scripts/setup.sh fly
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@.venv/bin/python scripts/attack.py $(if $(FLIGHTS),--flights $(FLIGHTS))

planted:
	@scripts/setup.sh test
	@.venv/bin/python scripts/planted.py

SECONDS := 60

# FUZZ=files: key, fault, conditions, orders, sticks and sensors files.
# FUZZ=readers: all that bin/urv reads.
FUZZ := board
fuzz:
	@scripts/setup.sh $(if $(filter readers,$(FUZZ)),test,fuzz)
	@FUZZ=$(FUZZ) scripts/fuzz.sh $(SECONDS)

real_time:
	@scripts/setup.sh real_time
	@$(GPRBUILD) -P real_time/urv_real_time.gpr -XURV_Mode=flight

# RENEW=--renew writes the result into the page in docs that shows it.
RENEW :=
timing: real_time
	@scripts/setup.sh timing
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@python3 scripts/timing.py --seconds $(SECONDS) $(RENEW)

margins:
	@scripts/setup.sh margins
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@.venv/bin/python scripts/laws/margins.py $(RENEW)

# SAMPLE: so many cases of the grid, drawn by lot.
SAMPLE :=
surfaces:
	@scripts/setup.sh fly
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@.venv/bin/python scripts/laws/surfaces.py $(RENEW) \
	   $(if $(SAMPLE),--sample $(SAMPLE))

bench:
	@scripts/setup.sh bench
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@.venv/bin/python scripts/bench.py $(if $(BEFORE),--before $(BEFORE)) $(RENEW)

size:
	@scripts/setup.sh size
	@python3 scripts/node_size.py

# SCHEDULER: of Dask, whose workers fly instead of processes here, with the
# CERTIFICATES of a folder.
# FORMAT: of the messages; 2 is sealed. ONLY=single,soak: of the cases.
CAMPAIGN := short
FORMAT   := 1
ONLY     :=
JOBS     :=
SCHEDULER :=
CERTIFICATES :=
campaign:
	@scripts/setup.sh campaign
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@.venv/bin/python -I -B scripts/campaign/run.py $(CAMPAIGN) \
	   --format $(FORMAT) $(if $(ONLY),--only $(ONLY)) \
	   $(if $(JOBS),--jobs $(JOBS)) \
	   $(if $(SCHEDULER),--scheduler $(SCHEDULER)) \
	   $(if $(CERTIFICATES),--certificates $(CERTIFICATES))

trials:
	@scripts/setup.sh ground
	@scripts/setup.sh test
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@$(GPRBUILD) -P real_time/urv_real_time.gpr -XURV_Mode=flight
	@$(if $(RENEW),URV_RENEW=1) .venv/bin/python -B -m pytest -v -s \
	   -p no:cacheprovider tests/trials

theory:
	@scripts/setup.sh campaign
	@$(GPRBUILD) -P sim/urv_sim.gpr -XURV_Mode=host
	@python3 scripts/campaign/theory.py $(RENEW)

trace:
	@scripts/setup.sh trace
	@.venv/bin/python scripts/trace/run.py export

coverage:
	@scripts/setup.sh coverage
	@.venv/bin/python scripts/coverage.py run $(RENEW)

# CHROOT: a folder for fresh Debians, to fly and test there, too. Needs root.
CHROOT  :=
independence:
	@scripts/setup.sh independence
	@.venv/bin/python scripts/independence.py $(RENEW) switches
	@$(if $(CHROOT),.venv/bin/python scripts/independence.py $(RENEW) \
	   chroot $(CHROOT))

clean:
	@rm -rf obj bin flight bench/results.json campaign trace coverage
