"""A vending machine as strangers write them, with nothing but paho-mqtt: what it sells is counted by its effect.

python3 vending.py HOST PORT SITE WAY     WAY: before, after (its result it tells how much is left), never
"""
import json
import sys
import uuid

import paho.mqtt.client as mqtt
from paho.mqtt.subscribeoptions import SubscribeOptions

WAY, BOOT, ROOT = sys.argv[4], uuid.uuid4().hex, f"rats/1/{sys.argv[3]}/"
ME = "vending-" + WAY
OWN = ROOT + f"member/{ME}/"
HALL = "https://w3id.org/maestro/home/vending#"
DESCRIPTION = {
    "@context": "https://w3id.org/maestro/context.jsonld", "id": "https://example.org/vending#" + ME,
    "label": ME, "type": ["maestro:Device", "https://example.org/vending#Machine"],
    "offers": {"id": "https://example.org/vending#sell", "type": "maestro:Task", "sentence": "{self} sells {guest} a can",
               "input": [{"name": "guest", "types": [HALL + "Guest"]}],
               "precondition": "(and (>= (stock ?self) 1) (not (sold ?self ?guest)))",
               "effect": "(and (sold ?self ?guest) (decrease (stock ?self) 1))",
               "occupies": ["flap"], "cost": "1", "seconds": "0.1"}}
answers, stock = {}, 2


def publish(topic, retain, **fields):
    client.publish(topic, json.dumps({"v": "1.0", **fields}), 1, retain)


def tell_state():
    publish(OWN + "state", True, id=ME, boot=BOOT, z="on", values=[f"(= (stock {ME}) {stock})"],
            running=[], queue=[], disabled=[])


def announce(*_):
    client.subscribe(ROOT + "call/#", options=SubscribeOptions(1, retainAsPublished=True, retainHandling=2))
    client.publish(OWN + "description", json.dumps(DESCRIPTION), 1, True)
    tell_state()
    publish(OWN + "status", True, id=ME, status="ready", boot=BOOT)


def answer(call):
    publish(ROOT + f"result/{call['from']}/{ME}", False, id=call["id"], **{"from": ME, "z": "on"},
            **answers[call["from"], call["id"]])


def sell(call):
    global stock
    if stock == 0:
        print("EMPTY", call["id"], flush=True)
        return {"outcome": "REJECTED", "values": {}, "error": {
            "code": "PRECONDITION_NOT_MET", "level": "WARNING", "message": "It is empty", "refs": [], "retriable": False}}
    stock -= 1
    print("SOLD", call["id"], flush=True)
    return {"outcome": "SUCCEEDED", "values": {}}


def heard(_, __, message):
    call = json.loads(message.payload)
    key = call["from"], call["id"]
    if call.get("r", "") not in (ME, "") or call.get("boot", BOOT) != BOOT:
        return
    if call["f"] == "$describe" and WAY != "never":
        announce()
    if not call.get("r"):
        return
    if key in answers:
        answer(call)
    elif call["f"] == "sell":
        answers[key] = sell(call)
        if WAY == "before":
            tell_state()
        answer(call)
        if WAY == "after":
            tell_state()
    else:
        answers[key] = {"outcome": "SUCCEEDED", "values": {}}
        answer(call)


client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2, ME, protocol=mqtt.MQTTv5)
client.on_connect, client.on_message = announce, heard
client.connect(sys.argv[1], int(sys.argv[2]), keepalive=15)
client.loop_forever(retry_first_connection=True)
