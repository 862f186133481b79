"""A device that puts what terminals, logs and pages obey into everything that it says; nothing but paho-mqtt.

python3 hostile.py HOST PORT SITE EVIL
EVIL: the text, as JSON; what is asked of it is printed
"""
import json
import sys
import uuid

import paho.mqtt.client as mqtt
from paho.mqtt.subscribeoptions import SubscribeOptions

BOOT, ROOT, EVIL = uuid.uuid4().hex, f"rats/1/{sys.argv[3]}/", json.loads(sys.argv[4])
ME = "hostile-1"
OWN = ROOT + f"member/{ME}/"
HOUSE = "https://w3id.org/maestro/home/odd#"
LONG = "y" * 100_000
BIDI = "\u202egnp\u2066"


def description(name, label):
    return {
        "@context": "https://w3id.org/maestro/context.jsonld", "id": "https://example.org/odd#" + name,
        "label": label, "type": ["maestro:Device", "https://example.org/odd#Odd"],
        "offers": [
            {"id": "https://example.org/odd#weigh", "type": "maestro:Action", "sentence": "{self} weighs {load} " + EVIL,
             "input": [{"name": "load", "types": [HOUSE + "Load"]}],
             "output": [{"name": "kilograms", "types": ["http://www.w3.org/2001/XMLSchema#decimal"]}],
             "effect": "(sense (weight ?load))", "learns": "(assign (weight ?load) ?kilograms)", "cost": "1",
             "seconds": "0.1"},
            {"id": "https://example.org/odd#polish", "type": "maestro:Task", "sentence": "{self} polishes {load} " + EVIL,
             "input": [{"name": "load", "types": [HOUSE + "Load"]}],
             "effect": "(bright ?load)", "cost": "3", "seconds": "0.1"}]}


def publish(topic, retain, **fields):
    client.publish(topic, json.dumps({"v": "1.0", **fields}), 1, retain)


def announce(*_):
    client.subscribe(ROOT + "call/#", options=SubscribeOptions(1, retainAsPublished=True, retainHandling=2))
    client.publish(OWN + "description", json.dumps(description(ME, "the hostile one " + EVIL)), 1, True)
    publish(OWN + "state", True, id=ME, boot=BOOT, z="on" + EVIL, running=["r" + BIDI], queue=[], disabled=["f" + BIDI],
            values=["(bad %s)" % EVIL, '(= (weight Box) "%s")' % EVIL.replace("\\", "").replace('"', ""), EVIL])
    publish(OWN + "status", True, id=ME, status="ready", boot=BOOT)
    publish(ROOT + "member/evil" + BIDI + "<script>/status", True, id=EVIL, status="ready", boot=EVIL)
    publish(ROOT + "member/long/status", True, id="long", status="ready", boot="long")
    client.publish(ROOT + "member/long/description", json.dumps({**description("long", LONG + EVIL), "offers": []}), 1, True)
    client.publish(ROOT + "member/broken/description", json.dumps({"id": EVIL, "label": EVIL, EVIL: EVIL}), 1, True)
    publish(ROOT + "member/broken/status", True, id="broken", status="ready", boot="broken")


def refusal(message):
    return {"outcome": "REJECTED", "values": {}, "error": {
        "code": "PRECONDITION_NOT_MET", "level": "WARNING", "message": message,
        "refs": [{"fact": "(bad %s)" % EVIL, "need": EVIL, "have": EVIL}], "retriable": False}}


def answer(call):
    if call["f"] == "weigh":
        return {"outcome": "SUCCEEDED", "values": {"kilograms": EVIL, EVIL: EVIL}}
    if call["f"] == "polish":
        return refusal("No " + (LONG + EVIL if "Chest" in json.dumps(call["p"]) else EVIL))
    return {"outcome": "SUCCEEDED", "values": {}}


def heard(_, __, message):
    call = json.loads(message.payload)
    if call.get("r", "") not in (ME, "") or call.get("boot", BOOT) != BOOT:
        return
    if call["f"] == "$describe":
        announce()
    if call.get("r") == ME:
        print(call["f"], json.dumps(call["p"]), flush=True)
        client.publish(OWN + "observation/$alert", json.dumps(
            {"v": "1.0", "id": "alert-" + uuid.uuid4().hex, "from": ME, "f": "$alert", "values": {"message": EVIL}}), 1)
        publish(ROOT + f"result/{call['from']}/{ME}", False, id=call["id"], **{"from": ME, "z": EVIL}, **answer(call))


client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2, ME, protocol=mqtt.MQTTv5)
client.on_connect, client.on_message = announce, heard
client.connect(sys.argv[1], int(sys.argv[2]), keepalive=15)
client.loop_forever(retry_first_connection=True)
