"""A device as strangers write them, with nothing but paho-mqtt: it answers in odd ways.

python3 odd.py HOST PORT SITE WAY [SECONDS [ID COST]]
WAY: text, nan, null, missing (what its measurements tell), slow (says nothing for so long), busy (says that it is at it)
"""
import json
import sys
import threading
import time
import uuid

import paho.mqtt.client as mqtt
from paho.mqtt.subscribeoptions import SubscribeOptions

BOOT, ROOT, WAY = uuid.uuid4().hex, f"rats/1/{sys.argv[3]}/", sys.argv[4]
ME, COST = sys.argv[6:8] if len(sys.argv) > 7 else ("odd-1", "3")
OWN = ROOT + f"member/{ME}/"
HOUSE = "https://w3id.org/maestro/home/odd#"
DESCRIPTION = {
    "@context": "https://w3id.org/maestro/context.jsonld", "id": "https://example.org/odd#" + ME,
    "label": "the odd one", "type": ["maestro:Device", "https://example.org/odd#Odd"],
    "offers": [
        {"id": "https://example.org/odd#weigh", "type": "maestro:Action", "sentence": "{self} weighs {load}",
         "input": [{"name": "load", "types": [HOUSE + "Load"]}],
         "output": [{"name": "kilograms", "types": ["http://www.w3.org/2001/XMLSchema#decimal"]}],
         "effect": "(sense (weight ?load))", "learns": "(assign (weight ?load) ?kilograms)", "cost": "1", "seconds": "0.1"},
        {"id": "https://example.org/odd#polish", "type": "maestro:Task", "sentence": "{self} polishes {load}",
         "input": [{"name": "load", "types": [HOUSE + "Load"]}],
         "effect": "(bright ?load)", "cost": COST, "seconds": "0.1"}]}
VALUES = {"text": {"kilograms": "heavy"}, "nan": {"kilograms": float("nan")}, "null": {"kilograms": None}, "missing": {}}
answers = {}


def publish(topic, retain, **fields):
    client.publish(topic, json.dumps({"v": "1.0", **fields}), 1, retain)


def announce(*_):
    client.subscribe(ROOT + "call/#", options=SubscribeOptions(1, retainAsPublished=True, retainHandling=2))
    client.publish(OWN + "description", json.dumps(DESCRIPTION), 1, True)
    publish(OWN + "state", True, id=ME, boot=BOOT, z="on", values=[], running=[], queue=[], disabled=[])
    publish(OWN + "status", True, id=ME, status="ready", boot=BOOT)


def tell(call, values):
    answers[call["id"]] = values
    publish(ROOT + f"result/{call['from']}/{ME}", False, id=call["id"], **{"from": ME, "z": "on"},
            outcome="SUCCEEDED", values=values)


def polish(call):
    print("POLISH", call["id"], flush=True)
    end = time.time() + float(sys.argv[5])
    while time.time() < end:
        time.sleep(1)
        if WAY == "busy":
            publish(ROOT + f"progress/{call['from']}/{ME}", False, id=call["id"], **{"from": ME}, kind="RUNNING",
                    fraction=0.5, values={})
    tell(call, {})


def heard(_, __, message):
    call = json.loads(message.payload)
    if call.get("r", "") not in (ME, "") or call.get("boot", BOOT) != BOOT:
        return
    if call["f"] == "$describe":
        announce()
    elif call["f"] == "polish" and call["id"] not in answers:
        answers[call["id"]] = None
        threading.Thread(target=polish, args=(call,), daemon=True).start()
        return
    elif call["f"] == "$cancel":
        print("CANCEL", call["p"]["id"], flush=True)
    elif call["f"] == "weigh":
        print("WEIGH", call["id"], flush=True)
    if call.get("r") and answers.get(call["id"], {}) is not None:
        tell(call, answers.get(call["id"], VALUES.get(WAY, {}) if call["f"] == "weigh" else {}))


client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2, ME, protocol=mqtt.MQTTv5)
client.on_connect, client.on_message = announce, heard
client.connect(sys.argv[1], int(sys.argv[2]), keepalive=15)
client.loop_forever(retry_first_connection=True)
