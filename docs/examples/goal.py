"""States a goal to a running platform and follows it, by the API of its console.

    python3 goal.py "(nextTo Cup Bob)" [http://127.0.0.1:7070]
"""
import json
import sys
import urllib.error
import urllib.request

API = (sys.argv[2] if len(sys.argv) > 2 else "http://127.0.0.1:7070") + "/api/v1"


def ask(path, body=None):
    data = None if body is None else json.dumps(body).encode()
    request = urllib.request.Request(API + path, data, {"Content-Type": "application/json"})
    try:
        return json.load(urllib.request.urlopen(request, timeout=30))
    except urllib.error.HTTPError as refused:
        sys.exit(json.load(refused)["problem"])


goal, kind = None, ""
for line in urllib.request.urlopen(urllib.request.Request(API + "/events", headers={"Accept": "text/event-stream"})):
    name, _, value = line.decode().rstrip("\n").partition(": ")
    if name == "event":
        kind = value
        goal = goal or ask("/goals", {"goal": sys.argv[1]})["id"]  # now that nothing of it can be missed
    elif name == "data" and kind == "story":
        news = json.loads(value)
        if news["goal"] == goal:
            print(f"{news['kind']:8} {news['text']}")
            if news["kind"] == "end":
                break
states = {row["id"]: row["state"] for row in ask("/goals")["goals"]}
sys.exit(0 if states[goal] == "achieved" else 1)
