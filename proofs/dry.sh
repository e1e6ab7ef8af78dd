cd /work/w/files
python3 -m venv /tmp/sc/v; 
for f in sim/jsbsim/requirements.txt tests/requirements.txt scripts/trace/requirements.txt scripts/coverage-requirements.txt scripts/laws/requirements.txt ground/campaign-requirements.txt ground/report-requirements.txt ground/requirements.txt; do
echo "$f 311"; nice /tmp/sc/v/bin/pip install -q --dry-run --disable-pip-version-check --no-deps --require-hashes --only-binary :all: -r $f 2>&1 | grep -v "^Would" | tail -3
echo "$f 313"; nice /tmp/sc/v/bin/pip install -q --dry-run --disable-pip-version-check --no-deps --require-hashes --only-binary :all: --python-version 3.13 --platform manylinux_2_28_x86_64 --platform manylinux_2_17_x86_64 --platform manylinux_2_5_x86_64 --platform manylinux_2_27_x86_64 --platform manylinux_2_34_x86_64 --platform manylinux2014_x86_64 --platform manylinux1_x86_64  --platform manylinux_2_12_x86_64 --target /tmp/sc/t -r $f 2>&1 | grep -v "^Would" | tail -3
done; echo done
