"""A lamp with valid credentials that tries what it must not: python3 insider.py PORT CA PASSWORD.

Prints one JSON object for each attempt; waits for a line on its input before the last one.
"""
import json
import ssl
import sys
import threading

import paho.mqtt.client as mqtt
from paho.mqtt.enums import CallbackAPIVersion
from paho.mqtt.packettypes import PacketTypes
from paho.mqtt.properties import Properties

port, ca, password = int(sys.argv[1]), sys.argv[2], sys.argv[3]
ROOT = "rats/1/home/"


def tell(**what):
    print(json.dumps(what), flush=True)


class Client:
    def __init__(self, client_id="lamp", user="lamp", secret=password, will=None):
        self.event = threading.Event()
        self.codes = []
        self.heard = []
        self.connected = None
        self.c = mqtt.Client(CallbackAPIVersion.VERSION2, client_id=client_id, protocol=mqtt.MQTTv5)
        if user:
            self.c.username_pw_set(user, secret)
        if will:
            self.c.will_set(will, json.dumps({"v": "1.0", "id": "door", "status": "lost", "boot": "x"}), 1, True)
        self.c.tls_set(ca_certs=ca, cert_reqs=ssl.CERT_REQUIRED)
        self.c.on_connect = self.on_connect
        self.c.on_disconnect = lambda *a: self.event.set()
        self.c.on_publish = lambda c, u, mid, code, p: self.got([code.value])
        self.c.on_subscribe = lambda c, u, mid, codes, p: self.got([code.value for code in codes])
        self.c.on_message = self.on_message
        self.c.reconnect_delay_set(60, 60)
        self.ended = threading.Event()
        try:
            self.c.connect("127.0.0.1", port, 30)
            self.c.loop_start()
            self.event.wait(10)
        except OSError as refused:
            self.connected = str(refused)

    def got(self, codes):
        self.codes += codes
        self.event.set()

    def on_connect(self, c, userdata, flags, code, properties):
        self.connected = code.value
        self.event.set()

    def on_message(self, c, userdata, message):
        text = message.payload.decode()
        if message.topic == ROOT + "call/cca" and '"f":"end"' in text:
            self.ended.set()
        elif "/call/" not in message.topic:
            self.heard.append(message.topic)

    def code(self, action):
        self.codes, _ = [], self.event.clear()
        action()
        self.event.wait(10)
        return self.codes or ["cut off"]

    def vanish(self):
        """Without goodbye, so that its will is published."""
        self.c.on_disconnect = None
        if self.c.socket():
            self.c.socket().close()

    def close(self):
        self.c.disconnect()
        self.c.loop_stop()


def call(sender, member, feature, call_id, **parameters):
    return json.dumps({"v": "1.0", "id": call_id, "r": member, "f": feature, "p": parameters, "t": 20000, "from": sender})


def publish(topic, payload, retain=False):
    lamp = Client()
    codes = lamp.code(lambda: lamp.c.publish(ROOT + topic, payload, 1, retain))
    lamp.close()
    tell(attempt="publish " + topic, codes=codes)


publish("call/cca", call("cca", "door", "echo", "i1"))
publish("call/lamp", call("cca", "door", "echo", "i2"))
publish("call/lamp", call("lamp", "door", "echo", "i3"))
publish("call/lamp", json.dumps({"v": "1.0", "id": "i4", "r": "", "f": "echo", "p": {}, "t": 20000, "from": "lamp"}))
publish("call", call("lamp", "door", "echo", "i5"))
publish("result/cca/cam-1.a", json.dumps({"v": "1.0", "id": "x", "from": "cam-1.a", "outcome": "SUCCEEDED", "z": "standby", "values": {}}))
publish("result", json.dumps({"v": "1.0", "id": "x", "from": "cam-1.a", "outcome": "SUCCEEDED", "z": "standby", "values": {}}))
publish("member/door/status", json.dumps({"v": "1.0", "id": "door", "status": "lost", "boot": "x"}), True)
publish("member/door/state", "", True)
publish("member/lamp/state", "", True)
publish("controller/cca/status", json.dumps({"v": "1.0", "id": "cca", "status": "lost", "boot": "x"}), True)

for name, arguments in {
    "another's client id": dict(client_id="door"),
    "another's name": dict(user="door"),
    "another's will": dict(will=ROOT + "member/door/status"),
    "no name": dict(user=None),
    "wrong password": dict(secret="guessed"),
}.items():
    client = Client(**arguments)
    tell(attempt="connect with " + name, codes=[client.connected])
    client.vanish()

FILTERS = ["result/cca/#", "result/#", "result/+/cam-1.a", "result/cca/cam-1.a", "progress/#", "member/#",
           "member/+/state", "member/cam-1.a/state", "member/+/observation/+", "member/cam-1.a/observation/watch",
           "member/cam-1.a/#"]
WHOLE = ["#", "+/#", "rats/#", "+/1/home/result/cca/cam-1.a", "$share/g/" + ROOT + "result/cca/#",
         "$share/g/" + ROOT + "member/+/state", "$share/g/#"]
spies = []
for each in [ROOT + f for f in FILTERS] + WHOLE:
    spy = Client()
    tell(attempt="read " + each, codes=spy.code(lambda: spy.c.subscribe(each, 1)))
    spy.close()
# What a broker grants it may still keep to itself: look at what arrives.
spy = Client()
spy.code(lambda: spy.c.subscribe([(ROOT + "call/#", 1)]))
for each in [ROOT + f for f in FILTERS] + WHOLE:
    codes = spy.code(lambda: spy.c.subscribe(each, 1))
    if codes == ["cut off"]:
        spy.close()
        spy = Client()
        spy.code(lambda: spy.c.subscribe([(ROOT + "call/#", 1)]))
tell(attempt="listening", codes=[])
sys.stdin.readline()
spy.ended.wait(20)
tell(attempt="heard", codes=sorted(set(spy.heard)))
spy.close()
