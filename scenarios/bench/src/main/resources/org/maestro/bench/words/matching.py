"""Reads templates, names, titles and sentences from standard input; tells which sentences are matched, and how long each took."""
import json
import sys
import time

try:
    from hassil import Intents, recognize
except ImportError:
    print(json.dumps({"missing": True}))
    sys.exit(0)

given = json.load(sys.stdin)
templates = given["templates"]
templates["lists"]["name"] = {"values": given["names"]}
templates["lists"]["title"] = {"values": given["titles"]}
intents = Intents.from_dict(templates)
sentences = given["sentences"]
for sentence in sentences:
    recognize(sentence, intents)
matched = []
seconds = []
for _ in range(given["times"]):
    for sentence in sentences:
        begun = time.perf_counter()
        found = recognize(sentence, intents)
        seconds.append(time.perf_counter() - begun)
        matched.append(found.intent.name if found else None)
print(json.dumps({"matched": matched[: len(sentences)], "seconds": seconds}))
