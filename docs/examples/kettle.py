"""A tea kettle on the RATS bus, with nothing but paho-mqtt: a feature that MAESTRO has never seen.

python3 kettle.py HOST PORT SITE [FOLDER]     FOLDER: its own of a secured site, DIR/users/kettle-1"""
import json
import sys
import uuid

import paho.mqtt.client as mqtt
from paho.mqtt.subscribeoptions import SubscribeOptions

HOST, PORT, SITE = sys.argv[1:4] if len(sys.argv) > 3 else sys.exit(__doc__)
ME, BOOT, ROOT = "kettle-1", uuid.uuid4().hex, f"rats/1/{SITE}/"  # another start is another boot
OWN, answers, served = ROOT + f"member/{ME}/", {}, []
DESCRIPTION = {
    "@context": ["https://w3id.org/maestro/context.jsonld", {"k": "https://example.org/kitchen#"}],
    "id": "k:" + ME, "label": "the kettle", "type": "k:Kettle",
    "offers": {
        "id": "k:brew", "type": "maestro:Task", "sentence": "{self} brews {drink} for {guest}",
        "input": [{"name": "drink", "types": ["k:Drink"]}, {"name": "guest", "types": ["k:Guest"]}],
        "effect": "(served ?drink ?guest)", "occupies": ["pot"], "cost": "3", "seconds": "0.1"},
    "brings": [  # words that no home has, how they go with the home's, and what there is to drink
        {"id": "k:Kettle", "type": "owl:Class", "subClassOf": "maestro:Device"},
        {"id": "k:Drink", "type": "owl:Class", "subClassOf": "maestro:Thing"},
        {"id": "k:Guest", "type": "owl:Class", "equivalentClass": "domain:Person"},
        {"id": "k:served", "type": "maestro:Predicate", "label": "served to", "arguments": ["?drink - Drink", "?guest - Guest"]},
        {"id": "k:tea", "type": "k:Drink", "label": "tea"}]}


def publish(topic, retain, **fields):
    client.publish(topic, json.dumps({"v": "1.0", **fields}), 1, retain)


def tell_state():
    publish(OWN + "state", True, id=ME, boot=BOOT, z="standby", values=served, running=[], queue=[], disabled=[])


def announce(*_):  # after each connect, since the broker may have come back empty
    others = SubscribeOptions(1, noLocal=True, retainAsPublished=True, retainHandling=2)
    client.subscribe([(topic, others) for topic in (ROOT + "call/#", OWN + "status", OWN + "description")])
    client.publish(OWN + "description", json.dumps(DESCRIPTION), 1, True)
    tell_state()
    publish(OWN + "status", True, id=ME, status="ready", boot=BOOT)


def perform(call):
    if call.get("boot", BOOT) != BOOT:
        return refusal("RESTARTED", "The call was meant for another life of the kettle")
    if call["f"] == "brew":
        served.append("(served {} {})".format(*(call["p"][name]["ref"].split("#")[-1] for name in ("drink", "guest"))))
        tell_state()
    elif call["f"] == "$cost":
        return {"outcome": "SUCCEEDED", "values": {"costs": [{"cost": 3, "seconds": 0.1}] * len(call["p"]["sets"])}}
    elif call["f"] == "$cancel":  # what it is called for is done at once
        return {"outcome": "SUCCEEDED", "values": {"found": False}}
    elif call["f"] == "$describe":
        announce()
    elif call["f"] not in ("$ping", "$safe"):
        return refusal("UNKNOWN_FEATURE", f"{ME} has no feature {call['f']}")
    return {"outcome": "SUCCEEDED", "values": {}}


def refusal(code, message):
    return {"outcome": "REJECTED", "values": {}, "error": {
        "code": code, "level": "WARNING", "message": message, "refs": [], "retriable": False}}


def heard(_, __, message):
    call = {"p": {}, **json.loads(message.payload)}
    if message.retain or call.get("r", "") not in (ME, "") or message.topic not in (ROOT + "call", ROOT + "call/" + call["from"]):
        return
    if call.get("r") or call["f"] == "brew" or call["f"].startswith("$"):
        key, body = (call["from"], call["id"]), (call["f"], call["p"])
        if not call["v"].startswith("1."):
            answer = refusal("UNSUPPORTED_VERSION", "It understands version 1")
        elif any("\ud800" <= letter <= "\udfff" for letter in json.dumps(call, ensure_ascii=False)):
            answer = refusal("MALFORMED", "The call holds half a character")
        elif key in answers and answers[key][0] != body:
            answer = refusal("DUPLICATE_ID", "Another call of that id came before")
        else:  # the same call again gets the same answer: nothing is done twice
            answer = (answers.get(key) or answers.setdefault(key, (body, perform(call))))[1]
        publish(ROOT + f"result/{call['from']}/{ME}", False, id=call["id"], **{"from": ME, "z": "standby"}, **answer)


def said_of_me(_, __, message):  # a will that came late, or another's word, must not be the last
    own = DESCRIPTION if message.topic == OWN + "description" else {"status": "ready"}
    if {**(said := json.loads(message.payload or "{}")), **own} != said:
        announce()


client = mqtt.Client(mqtt.CallbackAPIVersion.VERSION2, ME, protocol=mqtt.MQTTv5)
client.will_set(OWN + "status", json.dumps({"v": "1.0", "id": ME, "status": "lost", "boot": BOOT}), 1, True)
if len(sys.argv) > 4:
    client.username_pw_set(ME, open(sys.argv[4] + "/password").read().strip())
    client.tls_set(ca_certs=sys.argv[4] + "/ca.pem")
client.message_callback_add(OWN + "+", said_of_me)
client.on_connect, client.on_message, client.suppress_exceptions = announce, heard, True  # rubbish must not end it
client.on_disconnect = lambda *a: a[3] == "Session taken over" and sys.exit(f"Another {ME} is there; rename one")
client.connect(HOST, int(PORT), keepalive=15)
client.loop_forever(retry_first_connection=True)
