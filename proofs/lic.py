import importlib.metadata as md, re, glob, os, xml.etree.ElementTree as ET
from pathlib import Path
os.chdir("/work/w/files")
plain=lambda n: re.sub(r"[-_.]+","-",n).lower()
L="sim/jsbsim/requirements.txt ground/report-requirements.txt ground/requirements.txt ground/campaign-requirements.txt tests/requirements.txt scripts/trace/requirements.txt scripts/coverage-requirements.txt scripts/laws/requirements.txt".split()
seen={}
for f in L:
    for l in open(f):
        if "==" in l and not l.startswith("#"):
            n,v=l.rstrip(" \\\n").split("==")
            seen.setdefault(plain(n),(n,v,[]))[2].append(f)
            assert seen[plain(n)][1]==v,(n,v)
for k,(n,v,fs) in sorted(seen.items()):
    try: m=md.metadata(n)
    except Exception as e: print(n,v,"???",fs); continue
    cl=[c.split(" :: ")[-1] for c in m.get_all("Classifier") or [] if c.startswith("License ::") and c!="License :: OSI Approved"]
    print(n,v,"|",m.get("License-Expression"),"|",(m.get("License") or "")[:40].replace("\n"," "),"|",cl)
